//! The limit surface of Loop's scheme.

use num_traits::Zero;

use super::adaptive::{Anchored, Cut, Patch};
use super::corner_table::{CornerTable, Located, limit_jet, move_from_origin};
use super::eigenbasis::Eigenbasis;
use super::jet::{Jacobian, unchanged};
use super::triangle_corner::TriangleCorner;
use super::triangle_gather::{refined_patch, regular_patch};
use super::{Derivatives, EvaluationError, box_spline, check_points, clamped, triangle_modes};
use crate::algebra::{Real, Scalar, Vector3, VectorSpace};
use crate::mesh::Mesh;
use crate::subdivision::connectivity::index_of;
use crate::subdivision::limit::loop_limits;
use crate::subdivision::mask::{loop_vertex_weight, turn_cosine};
use crate::subdivision::{Connectivity, Corners, loop_subdivision_with};

/// The limit surface of a mesh of triangles under Loop subdivision, ready to be evaluated.
///
/// # Shape
///
/// A regular face is kept as the 15 points of a quartic Bézier triangle. Any other is cut by one step into a patch for each corner, `n + 6` points
/// where the vertex has valence n other than 6, and a regular one in the middle. That takes care of faces with several extraordinary
/// vertices, on the boundary too.
///
/// # Accuracy
///
/// As [`CatmullClarkSurface`](super::CatmullClarkSurface). Over exact numbers it is exact with weights that are: [`LoopSurface::with_weights`].
///
/// # Cost
///
/// Making it takes the time of one step for meshes with irregular faces. A regular point is 15 multiples of points.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::evaluate::LoopSurface;
/// use facette::subdivision::{Connectivity, Corners};
///
/// let corners = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
/// let tetrahedron = Mesh::new(corners, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
/// let connectivity = Connectivity::new(&tetrahedron)?;
/// let surface = LoopSurface::new(&connectivity, &tetrahedron.positions, Corners::Sharp)?;
/// let vertex = surface.point(0, [1.0, 0.0, 0.0])?;
/// assert!(vertex.iter().all(|x| (x - 0.8_f64).abs() < 1e-14));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LoopSurface<P: VectorSpace> {
    faces: Vec<Face<P>>,
    table: CornerTable<P, TriangleCorner<P>, 15, 5>,
}

#[derive(Clone, Debug, PartialEq)]
enum Face<P> {
    Regular(Patch<P, 15>),
    /// Three corners and the middle.
    Cut([Patch<P, 15>; 4]),
}

impl<P: VectorSpace> LoopSurface<P> {
    /// The surface of this mesh and these control points.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::Mesh`] where a face is no triangle, there is not one point for each vertex, or the refined mesh is too large;
    /// [`EvaluationError::PointNotFinite`].
    pub fn new(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
    ) -> Result<Self, EvaluationError>
    where
        P::Scalar: Real,
    {
        let vertex_weight = |n| loop_vertex_weight(turn_cosine(1, n));
        Self::with_weights(connectivity, points, corners, vertex_weight)
    }

    /// The surface with the weight of a vertex of each valence in its own new position handed in: over a field without cosines, exact where the
    /// weights are.
    ///
    /// # Errors
    ///
    /// As [`LoopSurface::new`].
    pub fn with_weights(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
        vertex_weight: impl Fn(usize) -> P::Scalar,
    ) -> Result<Self, EvaluationError> {
        connectivity.must_be_triangles()?;
        check_points(connectivity, points)?;
        let (mut refined, mut found) = (None, Vec::new());
        let mut faces = Vec::with_capacity(connectivity.face_count());
        for face in 0..index_of(connectivity.face_count()) {
            if let Some(patch) = regular_patch(connectivity, points, face, 0, corners) {
                faces.push(Face::Regular(Patch::Regular(Box::new(patch))));
                continue;
            }
            let refined = match &mut refined {
                Some(refined) => refined,
                none => none.insert(Refined::new(connectivity, points, corners, &vertex_weight)?),
            };
            faces.push(Face::Cut(refined.cut(
                face,
                corners,
                &vertex_weight,
                &mut found,
            )));
        }
        Ok(Self {
            faces,
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
    /// As [`CatmullClarkSurface::with_eigenbasis`](super::CatmullClarkSurface::with_eigenbasis).
    #[must_use]
    pub fn with_eigenbasis(mut self) -> Self
    where
        P::Scalar: Real,
    {
        self.table.eigenbasis = Some(Eigenbasis::new(
            &self.table.corners,
            triangle_modes::spectrum,
            triangle_modes::coordinates,
        ));
        self
    }

    /// The point of a face at the barycentric parameters of its vertices. They are divided by their sum; negative ones count as 0.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NoSuchFace`].
    ///
    /// # Edge cases
    ///
    /// Next to a vertex only the parameters of the two others count, so that any distance from it can be told. NaN where none is positive.
    pub fn point(&self, face: u32, barycentric: [P::Scalar; 3]) -> Result<P, EvaluationError> {
        self.jet(self.locate(face, barycentric)?)
            .map(|[point]| point)
    }

    /// The point, and the partial derivatives in the parameters `(u, v)` of the second and third vertex, the first one's being 1 − u − v.
    ///
    /// # Errors
    ///
    /// As [`LoopSurface::point`], and [`EvaluationError::NoDerivatives`].
    pub fn derivatives(
        &self,
        face: u32,
        barycentric: [P::Scalar; 3],
    ) -> Result<Derivatives<P>, EvaluationError> {
        self.jet(self.locate(face, barycentric)?)
            .map(Derivatives::of_jet)
    }

    /// The unit normal, at an extraordinary vertex too.
    ///
    /// # Errors
    ///
    /// As [`LoopSurface::point`], and [`EvaluationError::NoNormal`].
    pub fn normal(&self, face: u32, barycentric: [P::Scalar; 3]) -> Result<P, EvaluationError>
    where
        P: Vector3,
        P::Scalar: Real,
    {
        let at = self.locate(face, barycentric)?;
        self.table.normal::<Parts>(at, |corner| {
            limit_jet(corner.fan(), |connectivity, points| {
                loop_limits(connectivity, points, Corners::Smooth)
            })
        })
    }

    fn jet<const K: usize>(&self, at: Located<'_, P, 15>) -> Result<[P; K], EvaluationError> {
        self.table.jet::<Parts, K>(at)
    }

    fn locate(
        &self,
        face: u32,
        barycentric: [P::Scalar; 3],
    ) -> Result<Located<'_, P, 15>, EvaluationError> {
        let Some(found) = self.faces.get(face as usize) else {
            return Err(EvaluationError::NoSuchFace {
                face,
                count: self.faces.len(),
            });
        };
        let zero = P::Scalar::zero();
        let positive = barycentric.map(|b| if b < zero { zero } else { b });
        let sum = positive[0] + positive[1] + positive[2];
        let barycentric = positive.map(|b| b / sum);
        Ok(match found {
            Face::Regular(patch) => {
                let [_, s, t] = barycentric;
                (patch, [s, t].map(clamped), unchanged())
            }
            Face::Cut(children) => {
                let (child, inner, jacobian) = into_child(barycentric);
                (&children[child], inner.map(clamped), jacobian)
            }
        })
    }
}

/// The corner, or the middle, in which barycentric parameters lie; the parameters there, and their derivatives.
fn into_child<S: Scalar>([a, b, c]: [S; 3]) -> (usize, [S; 2], Jacobian<S>) {
    let (zero, one, half, two) = (S::zero(), S::one(), S::ratio(1, 2), S::from_i32(2));
    if a >= half {
        (0, [b * two, c * two], [[two, zero], [zero, two]])
    } else if b >= half {
        (1, [c * two, a * two], [[zero, -two], [two, -two]])
    } else if c >= half {
        (2, [a * two, b * two], [[-two, two], [-two, zero]])
    } else {
        let middle = [one - b * two, one - c * two];
        (3, middle, [[-two, zero], [zero, -two]])
    }
}

/// A corner's regular patches: at the far vertices, and in the middle, turned around.
#[derive(Clone, Copy, Debug)]
struct Parts;

impl Cut<15> for Parts {
    fn weights<S: Scalar, const K: usize>(parameters: [S; 2]) -> [[S; 15]; K] {
        box_spline::weights(parameters)
    }

    fn part<S: Scalar>([s, t]: [S; 2]) -> Option<(usize, [S; 2], Jacobian<S>)> {
        let (zero, one, half, two) = (S::zero(), S::one(), S::ratio(1, 2), S::from_i32(2));
        let straight = [[two, zero], [zero, two]];
        if s + t < half {
            None
        } else if s >= half {
            Some((0, [s * two - one, t * two], straight))
        } else if t >= half {
            Some((2, [s * two, t * two - one], straight))
        } else {
            let turned = [[-two, zero], [zero, -two]];
            Some((1, [one - s * two, one - t * two], turned))
        }
    }
}

/// The mesh after one step, relative to the first control point.
struct Refined<P: VectorSpace> {
    origin: P,
    mesh: Mesh<P>,
    connectivity: Connectivity,
}

impl<P: VectorSpace> Refined<P> {
    fn new(
        connectivity: &Connectivity,
        points: &[P],
        corners: Corners,
        vertex_weight: &impl Fn(usize) -> P::Scalar,
    ) -> Result<Self, EvaluationError> {
        let origin = points.first().copied().unwrap_or_else(P::origin);
        let relative: Vec<P> = points.iter().map(|point| point.minus(origin)).collect();
        let mesh = loop_subdivision_with(connectivity, &relative, corners, vertex_weight)?;
        let connectivity = Connectivity::new(&mesh)?;
        Ok(Self {
            origin,
            mesh,
            connectivity,
        })
    }

    /// The four patches of a face: a step makes faces 4f to 4f + 2 at its corners, and 4f + 3 between its edge points.
    fn cut(
        &self,
        face: u32,
        corners: Corners,
        vertex_weight: &impl Fn(usize) -> P::Scalar,
        found: &mut Vec<Anchored<P, TriangleCorner<P>>>,
    ) -> [Patch<P, 15>; 4] {
        let (joined, points) = (&self.connectivity, &self.mesh.positions);
        let place = found.len();
        let mut patches = [0, 1, 2, 3].map(|k| {
            let face = 4 * face + k;
            if k == 3 {
                Patch::Regular(Box::new(
                    regular_patch(joined, points, face, 1, corners)
                        .expect("edge points are regular"),
                ))
            } else {
                refined_patch(joined, points, face, corners, vertex_weight, found)
            }
        });
        move_from_origin(self.origin, &mut patches, &mut found[place..]);
        patches
    }
}
