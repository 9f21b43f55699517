//! From the parameter plane to space: points, normals, and which vertices are one place.

use std::collections::HashMap;

use super::bounds::{BoundedSurface, Break, Continuity};
use super::parameters::{ParameterMesh, Triangle};
use super::stitch::vertex_number;
use super::{Goal, TessellationError, intervals};
use crate::algebra::{Real, Scalar, Vector3, VectorSpace, larger, unit_vector};
use crate::bspline::Direction;
use crate::mesh::Mesh;

/// So many unit roundoffs of the largest coordinate may part the two sides of a seam: what two evaluations of one point with
/// degrees up to 8 or so differ by.
const ROUNDOFFS_OF_A_SEAM: i32 = 64;

/// A surface as triangles.
///
/// A vertex of the mesh is a place together with a normal and parameters. Where a place has several of those, on a crease, on a seam and at a
/// pole, there are several vertices, with the same bits for their position.
#[derive(Clone, Debug)]
pub struct Tessellation<P: VectorSpace> {
    /// The triangles, with a unit normal and the parameters at each vertex.
    pub mesh: Mesh<P>,
    /// For each vertex of the mesh, the number of its place.
    places: Vec<u32>,
    place_count: usize,
}

impl<P: VectorSpace> Tessellation<P> {
    /// For each vertex of the mesh, the number of its place: vertices of one place are one point of the surface.
    pub fn places(&self) -> &[u32] {
        &self.places
    }

    /// The mesh with one vertex for each place, without normals and parameters: watertight across seams and creases.
    ///
    /// # Edge cases
    ///
    /// A Möbius band has no consistent orientation: across its seam, neighbouring triangles run the same way along their edge.
    ///
    /// # Panics
    ///
    /// When the public list of the mesh's positions was changed to points that are not finite.
    pub fn welded(&self) -> Mesh<P> {
        let mut positions = vec![P::origin(); self.place_count];
        for (&place, &position) in self.places.iter().zip(&self.mesh.positions) {
            positions[place as usize] = position;
        }
        let faces = self.mesh.triangles();
        let faces = faces.map(|corners| corners.map(|vertex| self.places[vertex as usize]));
        Mesh::new(positions, faces)
            .expect("places are as finite as the vertices, and numbered in order")
    }
}

/// A vertex in the making: which of the parameter mesh, and on which sides of creases or tears.
type Key = (u32, [bool; 2]);

/// Numbers for keys, in the order of their first use; a vertex away from all lines costs no search.
struct Numbering {
    plain: Vec<u32>,
    others: HashMap<Key, u32>,
    count: u32,
}

impl Numbering {
    fn new(vertices: usize) -> Self {
        Self {
            plain: vec![u32::MAX; vertices],
            others: HashMap::new(),
            count: 0,
        }
    }

    /// The number of a key, and whether it is new.
    fn number(&mut self, key: Key) -> (u32, bool) {
        let entry = if key.1 == [false; 2] {
            &mut self.plain[key.0 as usize]
        } else {
            self.others.entry(key).or_insert(u32::MAX)
        };
        let is_new = *entry == u32::MAX;
        if is_new {
            *entry = self.count;
            self.count += 1;
        }
        (*entry, is_new)
    }
}

/// A mesh in the making.
struct Lifting<'a, T: BoundedSurface> {
    surface: &'a T,
    goal: Goal<T::Scalar>,
    parameters: &'a ParameterMesh<T::Scalar>,
    lines: [Vec<Break<T::Scalar>>; 2],
    vertex_numbers: Numbering,
    place_numbers: Numbering,
    place_positions: Vec<T::Point>,
    positions: Vec<T::Point>,
    normals: Vec<Option<T::Point>>,
    vertex_parameters: Vec<[T::Scalar; 2]>,
    places: Vec<u32>,
}

/// The surface's points and normals on the vertices of the parameter mesh; refused where creases and tears make too many of them.
pub(super) fn lifted<T>(
    surface: &T,
    parameters: &ParameterMesh<T::Scalar>,
    goal: Goal<T::Scalar>,
) -> Result<Tessellation<T::Point>, TessellationError<T::Scalar>>
where
    T: BoundedSurface,
    T::Point: Vector3,
    T::Scalar: Real,
{
    let count = parameters.vertices.len();
    let mut lifting = Lifting {
        surface,
        goal,
        parameters,
        lines: intervals(surface)?,
        vertex_numbers: Numbering::new(count),
        place_numbers: Numbering::new(count),
        place_positions: Vec::with_capacity(count),
        positions: Vec::with_capacity(count),
        normals: Vec::with_capacity(count),
        vertex_parameters: Vec::with_capacity(count),
        places: Vec::with_capacity(count),
    };
    let mut faces = Vec::with_capacity(parameters.triangles.len());
    for triangle in &parameters.triangles {
        faces.extend(lifting.face(*triangle)?);
    }
    lifting.finish(&faces)
}

impl<T> Lifting<'_, T>
where
    T: BoundedSurface,
    T::Point: Vector3,
    T::Scalar: Real,
{
    /// The triangle as one of the mesh; `None` where two of its corners are one place.
    fn face(
        &mut self,
        Triangle { corners, piece }: Triangle,
    ) -> Result<Option<[u32; 3]>, TessellationError<T::Scalar>> {
        let [a, b, c] = corners.map(|vertex| self.parameters.same.first(vertex));
        if a == b || b == c || c == a {
            for vertex in corners {
                self.check_joined(vertex, piece)?;
            }
            return Ok(None);
        }
        let mut face = [0; 3];
        for (corner, vertex) in face.iter_mut().zip(corners) {
            *corner = self.vertex(vertex, piece)?;
        }
        Ok(Some(face))
    }

    /// The number of the mesh's vertex for a vertex of the parameter mesh, as a piece sees it.
    fn vertex(
        &mut self,
        vertex: u32,
        piece: [u32; 2],
    ) -> Result<u32, TessellationError<T::Scalar>> {
        let [u, v] = self.parameters.vertices[vertex as usize];
        let creased = self.is_after([u, v], piece, |c| c != Continuity::Smooth);
        let (number, is_new) = self.vertex_numbers.number((vertex, creased));
        if is_new {
            self.goal.check_count(self.vertex_numbers.count)?;
            let place = self.place(vertex, piece)?;
            self.positions.push(self.place_positions[place as usize]);
            self.places.push(place);
            self.vertex_parameters.push([u, v]);
            let normal = if self.is_on_line([u, v], piece, |c| c != Continuity::Smooth) {
                self.surface.normal_in(self.rectangle(piece), u, v)
            } else {
                self.surface.normal_vector(u, v)
            };
            self.normals.push(normal.and_then(unit_vector));
        }
        Ok(number)
    }

    /// The place of a vertex; its point is computed once.
    fn place(&mut self, vertex: u32, piece: [u32; 2]) -> Result<u32, TessellationError<T::Scalar>> {
        let parameters = self.parameters.vertices[vertex as usize];
        let torn = self.is_after(parameters, piece, |c| c == Continuity::Torn);
        let first = self.parameters.same.first(vertex);
        let (place, is_new) = self.place_numbers.number((first, torn));
        if is_new {
            let [u, v] = self.parameters.vertices[first as usize];
            let point = if first == vertex {
                self.own_point(vertex, piece)
            } else {
                self.surface.point(u, v)
            };
            self.place_positions.push(point);
        }
        self.check_joined(vertex, piece)?;
        Ok(place)
    }

    /// The point at a vertex's own parameters, on the side of a tear that the piece is on.
    fn own_point(&self, vertex: u32, piece: [u32; 2]) -> T::Point {
        let [u, v] = self.parameters.vertices[vertex as usize];
        if self.is_on_line([u, v], piece, |c| c == Continuity::Torn) {
            self.surface.point_in(self.rectangle(piece), u, v)
        } else {
            self.surface.point(u, v)
        }
    }

    /// Refuses a seam whose sides do not meet at a vertex.
    fn check_joined(
        &self,
        vertex: u32,
        piece: [u32; 2],
    ) -> Result<(), TessellationError<T::Scalar>> {
        let first = self.parameters.same.first(vertex);
        if first == vertex {
            return Ok(());
        }
        let [u, v] = self.parameters.vertices[first as usize];
        let there = self.surface.point(u, v);
        let here = self.own_point(vertex, piece);
        let [u, v] = self.parameters.vertices[vertex as usize];
        let largest = larger(here.largest_coordinate(), there.largest_coordinate());
        let allowed =
            T::Scalar::from_i32(ROUNDOFFS_OF_A_SEAM) * T::Scalar::unit_roundoff() * largest;
        let gap = here.minus(there).largest_coordinate();
        if gap <= allowed || !Scalar::is_finite(gap) {
            return Ok(());
        }
        let is_in_u = self.lines[0].last().is_some_and(|line| line.at == u);
        let (direction, at) = if is_in_u {
            (Direction::U, v)
        } else {
            (Direction::V, u)
        };
        Err(TessellationError::SeamOpen {
            direction,
            at,
            gap,
            allowed,
        })
    }

    /// The two lines of a direction between which a piece lies.
    fn ends(&self, direction: usize, piece: [u32; 2]) -> [Break<T::Scalar>; 2] {
        let first = piece[direction] as usize;
        [first, first + 1].map(|line| self.lines[direction][line])
    }

    fn rectangle(&self, piece: [u32; 2]) -> [[T::Scalar; 2]; 2] {
        [0, 1].map(|direction| self.ends(direction, piece).map(|line| line.at))
    }

    /// For each direction, whether the vertex lies on such a line and the piece after it.
    fn is_after(
        &self,
        parameters: [T::Scalar; 2],
        piece: [u32; 2],
        counts: impl Fn(Continuity) -> bool,
    ) -> [bool; 2] {
        [0, 1].map(|direction| {
            let [start, _] = self.ends(direction, piece);
            piece[direction] > 0 && start.at == parameters[direction] && counts(start.continuity)
        })
    }

    /// Whether the vertex lies on such a line at a side of the piece.
    fn is_on_line(
        &self,
        parameters: [T::Scalar; 2],
        piece: [u32; 2],
        counts: impl Fn(Continuity) -> bool,
    ) -> bool {
        [0, 1].into_iter().any(|direction| {
            let ends = self.ends(direction, piece);
            ends.iter()
                .any(|line| line.at == parameters[direction] && counts(line.continuity))
        })
    }

    /// The mesh; where the surface has no normal, the vertex takes that of the triangles around its place.
    fn finish(
        self,
        faces: &[[u32; 3]],
    ) -> Result<Tessellation<T::Point>, TessellationError<T::Scalar>> {
        let mut mesh = Mesh::new(self.positions, faces)?;
        mesh.parameters = self.vertex_parameters;
        let place_count = self.place_numbers.count as usize;
        let mut tessellation = Tessellation {
            mesh,
            places: self.places,
            place_count,
        };
        let complete: Option<Vec<_>> = self.normals.iter().copied().collect();
        tessellation.mesh.normals = if let Some(normals) = complete {
            normals
        } else {
            let around = tessellation.welded().vertex_normals();
            let places = tessellation
                .places
                .iter()
                .map(|&place| around[place as usize]);
            let known = self.normals.into_iter();
            known
                .zip(places)
                .map(|(normal, other)| normal.unwrap_or(other))
                .collect()
        };
        debug_assert_eq!(
            vertex_number(tessellation.mesh.positions.len()),
            self.vertex_numbers.count,
            "every vertex has a position"
        );
        Ok(tessellation)
    }
}
