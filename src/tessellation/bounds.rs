//! What a surface must know of itself to be tessellated within a tolerance.

use super::TessellationError;
use crate::algebra::{Real, Vector3};
use crate::bspline::{Closing, Direction};
use crate::surface::Surface;

/// How a surface goes on across a parameter line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Continuity {
    /// The normal goes on continuously.
    Smooth,
    /// Points go on continuously, normals may jump: a crease.
    Crease,
    /// Points may jump: the two sides are not joined.
    Torn,
}

/// A parameter line at which the surface may be less than twice differentiable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Break<S> {
    /// The parameter of the line.
    pub at: S,
    /// How the surface goes on across it.
    pub continuity: Continuity,
}

impl<S> Break<S> {
    /// A break without crease, as at a simple knot and at the ends of the domain.
    pub fn smooth(at: S) -> Self {
        Self {
            at,
            continuity: Continuity::Smooth,
        }
    }
}

/// Upper bounds of the Euclidean lengths of `[S_uu, S_uv, S_vv]` on a parameter rectangle `[[u0, u1], [v0, v1]]`.
pub type Bounds<'a, S> = Box<dyn Fn([[S; 2]; 2]) -> [S; 3] + 'a>;

/// A surface with bounds on its second derivatives, twice continuously differentiable but for its breaks.
pub trait BoundedSurface: Surface {
    /// The lines where smoothness may end, in u and in v: increasing, from the start of the domain to its end.
    fn break_lines(&self) -> [Vec<Break<Self::Scalar>>; 2];

    /// Whether a straight side of a piece, one of whose intervals is a single parameter, is one point.
    fn is_collapsed(&self, side: [[Self::Scalar; 2]; 2]) -> bool {
        let [[u0, u1], [v0, v1]] = side;
        self.point(u0, v0) == self.point(u1, v1)
    }

    /// The function that bounds the second derivatives on rectangles, each of which lies in one piece.
    ///
    /// A rectangle without extent in one direction is a segment of a parameter line; the bound along it, from both sides where it
    /// lies on a break, decides how many points stand on it. The tessellation ends where the bounds on thinner and
    /// thinner rectangles along a segment tend to the segment's, as those of a constant and of a control net do.
    fn second_derivative_bounds(&self) -> Bounds<'_, Self::Scalar>;

    /// How the surface closes in u and in v.
    fn closing(&self) -> [Closing; 2] {
        [Closing::Open; 2]
    }

    /// The point `S(u, v)` as the piece `[[u0, u1], [v0, v1]]` has it, `(u, v)` being in that piece: on the side of a tear that the piece is on.
    ///
    /// A surface with [`Continuity::Torn`] breaks must implement this: without it, both sides of a tear get the same point.
    fn point_in(
        &self,
        _piece: [[Self::Scalar; 2]; 2],
        u: Self::Scalar,
        v: Self::Scalar,
    ) -> Self::Point {
        self.point(u, v)
    }

    /// A normal as the piece has it: on the side of a crease that the piece is on.
    fn normal_in(
        &self,
        _piece: [[Self::Scalar; 2]; 2],
        u: Self::Scalar,
        v: Self::Scalar,
    ) -> Option<Self::Point>
    where
        Self::Point: Vector3,
    {
        self.normal_vector(u, v)
    }
}

/// Any surface together with bounds that the caller knows.
///
/// # Examples
///
/// A torus of radii 3 and 1 has `|S_uu| = 3 + cos v <= 4`, `|S_uv| = |sin v| <= 1`, `|S_vv| = 1`:
///
/// ```
/// use facette::bspline::Closing;
/// use facette::surface::Surface;
/// use facette::tessellation::{Bounded, tessellate};
///
/// struct Torus;
/// impl Surface for Torus {
///     type Scalar = f64;
///     type Point = [f64; 3];
///     fn domain(&self) -> [[f64; 2]; 2] {
///         [[0.0, std::f64::consts::TAU]; 2]
///     }
///     fn point(&self, u: f64, v: f64) -> [f64; 3] {
///         let r = 3.0 + v.cos();
///         [r * u.cos(), r * u.sin(), v.sin()]
///     }
///     fn partials(&self, u: f64, v: f64) -> Option<[[f64; 3]; 2]> {
///         let r = 3.0 + v.cos();
///         Some([[-r * u.sin(), r * u.cos(), 0.0], [-v.sin() * u.cos(), -v.sin() * u.sin(), v.cos()]])
///     }
/// }
///
/// let torus = Bounded::new(Torus, |_| [4.0, 1.0, 1.0]).closed([Closing::Closed; 2]);
/// let welded = tessellate(&torus, 0.01)?.welded();
/// // V − E + F = 0, and 3F = 2E, so F = 2V.
/// assert_eq!(welded.face_count(), 2 * welded.positions.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bounded<T: Surface, F> {
    surface: T,
    bounds: F,
    breaks: [Vec<Break<T::Scalar>>; 2],
    closing: [Closing; 2],
}

impl<T, F> Bounded<T, F>
where
    T: Surface,
    F: Fn([[T::Scalar; 2]; 2]) -> [T::Scalar; 3],
{
    /// The surface, twice continuously differentiable and open, with these bounds of `[|S_uu|, |S_uv|, |S_vv|]` on a rectangle.
    pub fn new(surface: T, bounds: F) -> Self {
        let breaks = surface
            .domain()
            .map(|ends| ends.map(Break::smooth).to_vec());
        Self {
            surface,
            bounds,
            breaks,
            closing: [Closing::Open; 2],
        }
    }

    /// The same with these breaks, which include the ends of the domain.
    ///
    /// # Errors
    ///
    /// [`TessellationError::TornBreak`] where a break is [`Continuity::Torn`]: a surface by itself has but one point at each place of it.
    pub fn with_breaks(
        self,
        breaks: [Vec<Break<T::Scalar>>; 2],
    ) -> Result<Self, TessellationError<T::Scalar>> {
        for (direction, list) in [Direction::U, Direction::V].into_iter().zip(&breaks) {
            let torn = |line: &&Break<_>| line.continuity == Continuity::Torn;
            if let Some(&Break { at, .. }) = list.iter().find(torn) {
                return Err(TessellationError::TornBreak { direction, at });
            }
        }
        Ok(Self { breaks, ..self })
    }

    /// The same, closed as said; [`tessellate`](super::tessellate) checks that the sides meet.
    #[must_use]
    pub fn closed(self, closing: [Closing; 2]) -> Self {
        Self { closing, ..self }
    }
}

impl<T: Surface, F> Surface for Bounded<T, F> {
    type Scalar = T::Scalar;
    type Point = T::Point;

    fn domain(&self) -> [[T::Scalar; 2]; 2] {
        self.surface.domain()
    }

    fn point(&self, u: T::Scalar, v: T::Scalar) -> T::Point {
        self.surface.point(u, v)
    }

    fn partials(&self, u: T::Scalar, v: T::Scalar) -> Option<[T::Point; 2]> {
        self.surface.partials(u, v)
    }

    fn normal_vector(&self, u: T::Scalar, v: T::Scalar) -> Option<T::Point>
    where
        T::Point: Vector3,
    {
        self.surface.normal_vector(u, v)
    }

    fn points_on_grid(&self, us: &[T::Scalar], vs: &[T::Scalar], points: &mut [T::Point]) {
        self.surface.points_on_grid(us, vs, points);
    }
}

impl<T, F> BoundedSurface for Bounded<T, F>
where
    T: Surface,
    T::Scalar: Real,
    F: Fn([[T::Scalar; 2]; 2]) -> [T::Scalar; 3],
{
    fn break_lines(&self) -> [Vec<Break<T::Scalar>>; 2] {
        self.breaks.clone()
    }

    fn second_derivative_bounds(&self) -> Bounds<'_, T::Scalar> {
        Box::new(&self.bounds)
    }

    fn closing(&self) -> [Closing; 2] {
        self.closing
    }
}
