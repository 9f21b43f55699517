//! The limit surface of Catmull-Clark.

use super::adaptive::{Anchored, Patch};
use super::corner_table::{CornerTable, Located, limit_jet, move_from_origin};
use super::eigenbasis::Eigenbasis;
use super::jet::unchanged;
use super::quad_corner::QuadCorner;
use super::quad_gather::{refined_patch, regular_patch};
use super::quadrants::{Quadrants, into_quadrant, out_of_quadrant};
use super::{Derivatives, EvaluationError, check_points, clamped, quad_modes};
use crate::algebra::{Real, Vector3, VectorSpace};
use crate::mesh::Mesh;
use crate::subdivision::limit::catmull_clark_limits;
use crate::subdivision::{Connectivity, Corners, catmull_clark};

/// The limit surface of a mesh under Catmull-Clark subdivision, ready to be evaluated.
///
/// # Shape
///
/// A regular face is kept as 16 points. Any other is cut by one step into a patch for each corner (by two steps where it is no
/// quadrilateral): 16 points each, or `2n + 8` where an extraordinary vertex of valence n is left. That takes care of faces with several such
/// vertices, on the boundary too.
///
/// # Accuracy
///
/// A point is wrong by few u · M, M the largest coordinate of a control point; a derivative by few u · D, D the extent of the mesh, times its own growth
/// of 2λ a step and order. Over exact numbers everything is exact: all masks are rational.
///
/// # Cost
///
/// Making it takes the time of one step for meshes with irregular faces, of two for meshes with other faces than quadrilaterals. A regular point
/// is 16 multiples of points; one near an extraordinary vertex see [`CatmullClarkSurface::with_eigenbasis`].
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::evaluate::CatmullClarkSurface;
/// use facette::subdivision::{Connectivity, Corners};
///
/// let corners = (0..8).map(|k| [f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)]);
/// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
/// let cube = Mesh::new(corners.collect(), faces)?;
/// let connectivity = Connectivity::new(&cube)?;
/// let surface = CatmullClarkSurface::new(&connectivity, &cube.positions, Corners::Sharp)?;
/// let corner = surface.point(0, 0.0, 0.0)?;
/// assert!(corner.iter().all(|x| (x - 0.25).abs() < 1e-15));
/// let [x, y, z] = surface.normal(0, 0.5, 0.5)?;
/// assert!(x.abs() + y.abs() < 1e-15 && z == -1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CatmullClarkSurface<P: VectorSpace> {
    faces: Vec<Face<P>>,
    /// Where the half-edges of each face begin, and where the last ones end.
    starts: Vec<u32>,
    table: CornerTable<P, QuadCorner<P>, 16, 7>,
}

#[derive(Clone, Debug, PartialEq)]
enum Face<P> {
    Regular(Patch<P, 16>),
    /// A quadrilateral, cut at its corners.
    Cut([Patch<P, 16>; 4]),
    /// A polygon, cut at its corners, and these again.
    Polygon(Vec<[Patch<P, 16>; 4]>),
}

impl<P: VectorSpace> CatmullClarkSurface<P> {
    /// The surface of this mesh and these control points.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::Mesh`] where there is not one point for each vertex, or the refined mesh is too large;
    /// [`EvaluationError::PointNotFinite`].
    pub fn new(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
    ) -> Result<Self, EvaluationError> {
        check_points(connectivity, points)?;
        let mut found = Vec::new();
        let faces = (0..connectivity.face_count()).zip(0..);
        let regular: Vec<_> = faces
            .map(|(_, face)| regular_patch(connectivity, points, face, corners))
            .collect();
        let steps_for = |(regular, face): (&Option<_>, u32)| {
            let is_quadrilateral = connectivity.half_edges_of(face).len() == 4;
            match (regular, is_quadrilateral) {
                (Some(_), _) => 0,
                (None, true) => 1,
                (None, false) => 2,
            }
        };
        let steps = regular.iter().zip(0..).map(steps_for).max().unwrap_or(0);
        let levels = Levels::new(connectivity, points, corners, steps)?;
        let patches = regular.into_iter().zip(0..).map(|(regular, face)| {
            if let Some(patch) = regular {
                return Face::Regular(Patch::Regular(Box::new(patch)));
            }
            let half_edges = connectivity.half_edges_of(face);
            if half_edges.len() == 4 {
                let first = half_edges.start;
                return Face::Cut(levels.split(0, first, corners, &mut found));
            }
            // A step makes a face of each half-edge, with its half-edges in order: number 4h is the first of face h.
            let split = |h| levels.split(1, 4 * h, corners, &mut found);
            Face::Polygon(half_edges.map(split).collect())
        });
        let faces = patches.collect();
        let ends = (0..connectivity.face_count()).zip(0..);
        let ends = ends.map(|(_, face)| connectivity.half_edges_of(face).end);
        Ok(Self {
            faces,
            starts: std::iter::once(0).chain(ends).collect(),
            table: CornerTable {
                corners: found,
                eigenbasis: None,
            },
        })
    }

    /// The same surface, evaluated by Stam's eigenbasis at extraordinary vertices that are not on the boundary.
    ///
    /// # Cost
    ///
    /// Here O(n²) for each face at a vertex of valence n; a point then costs O(n log k) where the feature-adaptive way costs O(n k), for parameters of about 2⁻ᵏ.
    #[must_use]
    pub fn with_eigenbasis(mut self) -> Self
    where
        P::Scalar: Real,
    {
        self.table.eigenbasis = Some(Eigenbasis::new(
            &self.table.corners,
            |corner| quad_modes::spectrum(corner.faces.len()),
            quad_modes::coordinates,
        ));
        self
    }

    /// The point at the parameters of a quadrilateral.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NoSuchFace`], [`EvaluationError::NotAQuadrilateral`].
    pub fn point(&self, face: u32, u: P::Scalar, v: P::Scalar) -> Result<P, EvaluationError> {
        self.jet(self.in_face(face, [u, v])?).map(|[point]| point)
    }

    /// The point and the partial derivatives at the parameters of a quadrilateral.
    ///
    /// # Errors
    ///
    /// As [`CatmullClarkSurface::point`], and [`EvaluationError::NoDerivatives`].
    pub fn derivatives(
        &self,
        face: u32,
        u: P::Scalar,
        v: P::Scalar,
    ) -> Result<Derivatives<P>, EvaluationError> {
        self.jet(self.in_face(face, [u, v])?)
            .map(Derivatives::of_jet)
    }

    /// The unit normal at the parameters of a quadrilateral, at an extraordinary vertex too.
    ///
    /// # Errors
    ///
    /// As [`CatmullClarkSurface::point`], and [`EvaluationError::NoNormal`].
    pub fn normal(&self, face: u32, u: P::Scalar, v: P::Scalar) -> Result<P, EvaluationError>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        self.normal_at(self.in_face(face, [u, v])?)
    }

    /// The point at the parameters of one corner of a face: the vertex at (0, 0), the middle of the half-edge at (1, 0), the middle of the face
    /// at (1, 1).
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NoSuchHalfEdge`].
    pub fn corner_point(
        &self,
        half_edge: u32,
        u: P::Scalar,
        v: P::Scalar,
    ) -> Result<P, EvaluationError> {
        self.jet(self.in_corner(half_edge, [u, v])?)
            .map(|[point]| point)
    }

    /// The point and the partial derivatives at the parameters of one corner of a face.
    ///
    /// # Errors
    ///
    /// As [`CatmullClarkSurface::corner_point`], and [`EvaluationError::NoDerivatives`].
    pub fn corner_derivatives(
        &self,
        half_edge: u32,
        u: P::Scalar,
        v: P::Scalar,
    ) -> Result<Derivatives<P>, EvaluationError> {
        self.jet(self.in_corner(half_edge, [u, v])?)
            .map(Derivatives::of_jet)
    }

    /// The unit normal at the parameters of one corner of a face.
    ///
    /// # Errors
    ///
    /// As [`CatmullClarkSurface::corner_point`], and [`EvaluationError::NoNormal`].
    pub fn corner_normal(
        &self,
        half_edge: u32,
        u: P::Scalar,
        v: P::Scalar,
    ) -> Result<P, EvaluationError>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        self.normal_at(self.in_corner(half_edge, [u, v])?)
    }

    fn jet<const K: usize>(&self, at: Located<'_, P, 16>) -> Result<[P; K], EvaluationError> {
        self.table.jet::<Quadrants, K>(at)
    }

    fn normal_at(&self, at: Located<'_, P, 16>) -> Result<P, EvaluationError>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        self.table.normal::<Quadrants>(at, |corner| {
            limit_jet(corner.fan(), |connectivity, points| {
                catmull_clark_limits(connectivity, points, Corners::Smooth)
            })
        })
    }

    fn in_face(
        &self,
        face: u32,
        parameters: [P::Scalar; 2],
    ) -> Result<Located<'_, P, 16>, EvaluationError> {
        match self.faces.get(face as usize) {
            None => Err(EvaluationError::NoSuchFace {
                face,
                count: self.faces.len(),
            }),
            Some(Face::Polygon(corners)) => Err(EvaluationError::NotAQuadrilateral {
                face,
                found: corners.len(),
            }),
            Some(Face::Regular(patch)) => Ok((patch, parameters.map(clamped), unchanged())),
            Some(Face::Cut(children)) => Ok(in_quadrant(children, parameters.map(clamped))),
        }
    }

    fn in_corner(
        &self,
        half_edge: u32,
        parameters: [P::Scalar; 2],
    ) -> Result<Located<'_, P, 16>, EvaluationError> {
        let face = self.starts.partition_point(|&start| start <= half_edge);
        let Some(patches) = self.faces.get(face.wrapping_sub(1)) else {
            return Err(EvaluationError::NoSuchHalfEdge {
                half_edge,
                count: self.starts.last().map_or(0, |&end| end as usize),
            });
        };
        let corner = (half_edge - self.starts[face - 1]) as usize;
        let parameters = parameters.map(clamped);
        Ok(match patches {
            Face::Polygon(patches) => in_quadrant(&patches[corner], parameters),
            Face::Cut(children) => (&children[corner], parameters, unchanged()),
            Face::Regular(patch) => {
                let (parameters, jacobian) = out_of_quadrant(corner, parameters);
                (patch, parameters, jacobian)
            }
        })
    }
}

fn in_quadrant<P: VectorSpace>(
    children: &[Patch<P, 16>; 4],
    parameters: [P::Scalar; 2],
) -> Located<'_, P, 16> {
    let (child, inner, jacobian) = into_quadrant(parameters);
    (&children[child], inner, jacobian)
}

/// The meshes after one and two steps, relative to the first control point.
struct Levels<P: VectorSpace> {
    origin: P,
    meshes: Vec<(Mesh<P>, Connectivity)>,
}

impl<P: VectorSpace> Levels<P> {
    fn new(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
        count: usize,
    ) -> Result<Self, EvaluationError> {
        let origin = points.first().copied().unwrap_or_else(P::origin);
        let relative: Vec<P> = points.iter().map(|point| point.minus(origin)).collect();
        let mut meshes: Vec<(Mesh<P>, Connectivity)> = Vec::new();
        for _ in 0..count {
            let (joined, points) = match meshes.last() {
                Some((mesh, joined)) => (joined, &mesh.positions),
                None => (connectivity, &relative),
            };
            let mesh = catmull_clark(joined, points, corners)?;
            let joined = Connectivity::new(&mesh)?;
            meshes.push((mesh, joined));
        }
        Ok(Self { origin, meshes })
    }

    /// The four faces of the mesh `level` that begin at number `first`: those that a step made of one quadrilateral.
    fn split(
        &self,
        level: usize,
        first: u32,
        corners: Corners,
        found: &mut Vec<Anchored<P, QuadCorner<P>>>,
    ) -> [Patch<P, 16>; 4] {
        let (mesh, connectivity) = &self.meshes[level];
        let place = found.len();
        let mut patches = [0, 1, 2, 3]
            .map(|k| refined_patch(connectivity, &mesh.positions, first + k, corners, found));
        move_from_origin(self.origin, &mut patches, &mut found[place..]);
        patches
    }
}
