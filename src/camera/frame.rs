//! The frame of a camera: where it stands, and what it calls right, up and backwards.

use num_traits::{One, Zero};

use super::CameraError;
use crate::algebra::{Real, Scalar, Vector3, larger, unit_vector};

/// So many unit roundoffs of its terms must the largest coordinate of `up × w` have, for the axis u to follow from the data.
///
/// A coordinate `a_j b_k − a_k b_j` of the product of the two unit vectors carries 7u of `|a_j b_k| + |a_k b_j|`, 8u with all terms in u²: 2u for each
/// coordinate of up, 3u for one of w (a difference more), 1u for the product and 1u for the sum. The whole product is therefore off by at most `8√3 u` of
/// the largest such term. With 32u of it in hand, u is turned by at most arcsin(√3/4) = 26° from where exact arithmetic puts it: still known. Below, it is not.
const ROUNDOFFS_OF_A_KNOWN_PRODUCT: i32 = 32;

/// So many unit roundoffs may a scalar product of two axes be away from 0 or 1.
///
/// [`look_at_axes`] needs 20, and the product itself rounds by 3: 23, rounded up to a power of two so that the product with a roundoff is exact.
const ROUNDOFFS_OF_A_FRAME: i32 = 32;

/// The axes `[u, v, w]` of a camera at `eye` that looks at `target`, with v as near to `up` as may be: w points backwards, u to the right.
///
/// `None` where a coordinate is infinite or NaN, where the eye is the target, where up is zero, or parallel to the view as far as the rounded numbers can tell.
///
/// # Accuracy
///
/// However near to the view up may be, the six scalar products are within 20u of 0 and 1 (tested as `frame_is_orthonormal_within_its_bound`).
/// w is within 6u of its exact value, coordinate by coordinate relatively; the sine of the angle between u and its exact value is at most
/// `(8√3 m / |up × w| + 12) u`, where `m` is the largest of the terms `|a_j b_k| + |a_k b_j|` of the product (tested as
/// `right_axis_turns_no_more_than_its_bound`). That bound supposes that the coordinates of `up`, and those of its unit vector, are zero or normal numbers: subnormal ones
/// have fewer digits, and turn the frame by as much.
///
/// # Source
///
/// Marschner and Shirley 2016, section 7.1.3; the second orthogonalisation: Giraud, Langou and Rozložník 2005.
// ANCHOR: look_at_axes
pub fn look_at_axes<P>(eye: P, target: P, up: P) -> Option<[P; 3]>
where
    P: Vector3,
    P::Scalar: Real,
{
    let w = unit_vector(difference(eye, target))?;
    let leaning = unit_vector(known_product(unit_vector(up)?, w)?)?;
    // With up near the view the product has lost digits and leans towards w.
    let u = unit_vector(leaning.minus(w.times(leaning.dot(w))))?;
    let v = w.cross(u);
    Some([u, v, w])
}
// ANCHOR_END: look_at_axes

/// A multiple of `a − b`: half of it where the difference itself would overflow.
fn difference<P: Vector3>(a: P, b: P) -> P {
    let whole = a.minus(b);
    if whole.has_finite_coordinates() {
        return whole;
    }
    let half = P::Scalar::ratio(1, 2);
    a.times(half).minus(b.times(half))
}

/// The product `a × b` of unit vectors; `None` where it may be nothing but rounding.
// ANCHOR: known_product
fn known_product<P: Vector3>(a: P, b: P) -> Option<P> {
    let product = a.cross(b);
    let mut largest_term = P::Scalar::zero();
    for (j, k) in [(1, 2), (2, 0), (0, 1)] {
        let term = (a.coordinate(j) * b.coordinate(k)).magnitude()
            + (a.coordinate(k) * b.coordinate(j)).magnitude();
        largest_term = larger(largest_term, term);
    }
    let roundoffs = P::Scalar::from_i32(ROUNDOFFS_OF_A_KNOWN_PRODUCT) * P::Scalar::unit_roundoff();
    (product.largest_coordinate() > roundoffs * largest_term).then_some(product)
}
// ANCHOR_END: known_product

/// The frame of a camera (*repère lié à la caméra*): the eye e, and an orthonormal, right-handed basis u (right), v (up), w (backwards).
///
/// # Examples
///
/// ```
/// use facette::camera::CameraFrame;
///
/// let frame = CameraFrame::looking_at([0., 0., 5.], [0., 0., 0.], [0., 1., 0.])?;
/// assert_eq!(frame.axes(), [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]);
/// assert_eq!(frame.coordinates([1., 2., 0.]), [1., 2., -5.]);
/// # Ok::<(), facette::camera::CameraError<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraFrame<P: Vector3> {
    eye: P,
    axes: [P; 3],
}

impl<P: Vector3> CameraFrame<P> {
    /// The frame with these axes, which must be orthonormal and right-handed: exactly over exact numbers, within 32 unit roundoffs in floating point.
    ///
    /// # Errors
    ///
    /// [`CameraError::PointNotFinite`], [`CameraError::NotOrthonormal`] with the two axes that are not, [`CameraError::LeftHanded`].
    pub fn from_axes(eye: P, axes: [P; 3]) -> Result<Self, CameraError<P::Scalar>> {
        let [u, v, w] = axes;
        let named = [("u", u), ("v", v), ("w", w)];
        for (what, value) in [("the eye", eye)].into_iter().chain(named) {
            CameraError::check_finite(what, value)?;
        }
        for (index, (first, a)) in named.into_iter().enumerate() {
            for (second, b) in named.into_iter().skip(index) {
                check_product([first, second], a.dot(b))?;
            }
        }
        let determinant = u.cross(v).dot(w);
        if determinant > P::Scalar::zero() {
            Ok(Self { eye, axes })
        } else {
            Err(CameraError::LeftHanded { determinant })
        }
    }

    /// The frame of a camera at `eye` that looks at `target`, with v as near to `up` as may be.
    ///
    /// # Accuracy
    ///
    /// As [`look_at_axes`]: coordinates of any size that does not overflow, those of `up` zero or normal numbers. Eye and target far from the origin do no harm of
    /// their own, since their difference loses nothing that the given numbers had; but what was rounded when they were written down is lost: at 10⁷ a
    /// number of single precision is known to within one half.
    ///
    /// # Errors
    ///
    /// [`CameraError::PointNotFinite`], [`CameraError::EyeAtTarget`], [`CameraError::UpIsZero`]; [`CameraError::UpAlongView`] where up is parallel to the view
    /// as far as the rounded numbers can tell. [`CameraFrame::looking_at_with_any_up`] is the way out.
    pub fn looking_at(eye: P, target: P, up: P) -> Result<Self, CameraError<P::Scalar>>
    where
        P::Scalar: Real,
    {
        for (what, value) in [("the eye", eye), ("the target", target), ("up", up)] {
            CameraError::check_finite(what, value)?;
        }
        let back = unit_vector(difference(eye, target)).ok_or(CameraError::EyeAtTarget {
            eye: eye.coordinates(),
        })?;
        if up.largest_coordinate().is_zero() {
            let up = up.coordinates();
            return Err(CameraError::UpIsZero { up });
        }
        let axes = look_at_axes(eye, target, up).ok_or(CameraError::UpAlongView {
            up: up.coordinates(),
            view: P::origin().minus(back).coordinates(),
        })?;
        Ok(Self { eye, axes })
    }

    /// The frame of a camera at `eye` that looks at `target`, for callers that have no opinion on up: it takes the coordinate axis that is most nearly
    /// perpendicular to the view (of two equal ones the first), which is at least 54° away from it.
    ///
    /// The frame jumps where the choice goes over from one axis to another: no choice is continuous in all directions of view (hairy ball theorem).
    ///
    /// # Errors
    ///
    /// [`CameraError::PointNotFinite`], [`CameraError::EyeAtTarget`].
    pub fn looking_at_with_any_up(eye: P, target: P) -> Result<Self, CameraError<P::Scalar>>
    where
        P::Scalar: Real,
    {
        let along = difference(eye, target);
        let mut most_perpendicular = 0;
        for axis in [1, 2] {
            if along.coordinate(axis).magnitude() < along.coordinate(most_perpendicular).magnitude()
            {
                most_perpendicular = axis;
            }
        }
        let mut up = [P::Scalar::zero(); 3];
        up[most_perpendicular] = P::Scalar::one();
        Self::looking_at(eye, target, P::from_coordinates(up))
    }

    /// The eye e.
    #[inline]
    pub fn eye(&self) -> P {
        self.eye
    }

    /// The axes `[u, v, w]`: right, up, backwards.
    #[inline]
    pub fn axes(&self) -> [P; 3] {
        self.axes
    }

    /// The coordinates of a point in this frame: to the right of the eye, above it, and behind it.
    ///
    /// # Accuracy
    ///
    /// Each within `4u · Σ |a_k| |p_k − e_k|` for the axis a of that coordinate as it is stored.
    // ANCHOR: coordinates
    #[inline]
    pub fn coordinates(&self, point: P) -> [P::Scalar; 3] {
        let from_eye = point.minus(self.eye);
        self.axes.map(|axis| from_eye.dot(axis))
    }
    // ANCHOR_END: coordinates

    /// The point with these coordinates in this frame, `e + u u + v v + w w`.
    #[inline]
    pub fn point(&self, [right, above, behind]: [P::Scalar; 3]) -> P {
        let [u, v, w] = self.axes;
        let offset = u.times(right).plus(v.times(above)).plus(w.times(behind));
        self.eye.plus(offset)
    }
}

fn check_product<S: Scalar>(
    [first, second]: [&'static str; 2],
    product: S,
) -> Result<(), CameraError<S>> {
    let expected = if first == second { S::one() } else { S::zero() };
    let tolerance = S::from_i32(ROUNDOFFS_OF_A_FRAME) * S::unit_roundoff();
    if (product - expected).magnitude() <= tolerance {
        return Ok(());
    }
    Err(CameraError::NotOrthonormal {
        first,
        second,
        product,
        expected,
        tolerance,
    })
}
