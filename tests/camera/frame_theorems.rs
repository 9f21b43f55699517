//! The theorems of the frame and of the field of view. They need square roots and angles, so they are tried in floating point, on
//! data whose exact answer is known. The book shows their doc comments.

use std::fmt;

use facette::algebra::{Scalar, Vector3, VectorSpace};
use facette::camera::{CameraError, CameraFrame, ImageRectangle, half_extent, look_at_axes};
use proptest::prelude::*;

use crate::common::exact::Exact;
use crate::common::law::{Broken, Law, Verdict, expect_at_most, expect_equal};
use crate::inputs::rotation;
use crate::suspects;

/// The unit roundoff of `f64`.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// So far may an axis be from its exact value, in roundoffs, for the views of this file.
///
/// The angle between up and the view has a sine of at least `1/√10`, and a term of the product of unit vectors is at most 1: by the bound of
/// [`look_at_axes`], u turns by `8√3 √10 + 12 = 56` roundoffs at most. v, a product of u and w, turns with u and rounds by 3 more.
const ROUNDOFFS: f64 = 64.0;

/// An eye, a target and a direction up in whole numbers, whose frame is known.
#[derive(Clone)]
pub struct KnownView {
    quaternion: [i32; 4],
    eye: [i32; 3],
    steps: i32,
    lean: [i32; 2],
    /// Target and up are scaled by this power of two.
    exponent: i32,
}

impl KnownView {
    /// The exact axes.
    fn axes(&self) -> [[Exact; 3]; 3] {
        rotation(self.quaternion)
    }

    /// The axes in whole numbers, all of the same length.
    fn whole_axes(&self) -> [[f64; 3]; 3] {
        let norm = self.quaternion.iter().map(|part| part * part).sum::<i32>();
        self.axes().map(|axis| {
            axis.map(|coordinate| {
                let whole = coordinate * Exact::from_i32(norm);
                let found = (-10_000..=10_000).find(|&n| Exact::from_i32(n) == whole);
                f64::from(found.expect("a whole number of this size"))
            })
        })
    }

    /// The eye, the target and up.
    fn data(&self) -> [[f64; 3]; 3] {
        let [_, v, w] = self.whole_axes();
        let scale = 2_f64.powi(self.exponent);
        let eye = self.eye.map(f64::from);
        let [p, q] = self.lean.map(f64::from);
        let up = v.times(p * scale).plus(w.times(q * scale));
        [eye, eye.minus(w.times(f64::from(self.steps) * scale)), up]
    }

    /// The axes of the function under test.
    fn computed(&self) -> Result<[[f64; 3]; 3], Broken> {
        let [eye, target, up] = self.data();
        look_at_axes(eye, target, up).ok_or(Broken {
            expected: "a frame".to_owned(),
            got: "None".to_owned(),
        })
    }
}

impl fmt::Debug for KnownView {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [eye, target, up] = self.data();
        write!(formatter, "eye = {eye:?}, target = {target:?}, up = {up:?}")
    }
}

fn known_views_of(
    quaternion: impl Strategy<Value = [i32; 4]>,
    eye_and_exponent: impl Strategy<Value = ([i32; 3], i32)>,
) -> impl Strategy<Value = KnownView> {
    let rest = (1..=5, [1..=3, -3..=3]);
    (quaternion, eye_and_exponent, rest).prop_map(|(quaternion, (eye, exponent), (steps, lean))| {
        KnownView {
            quaternion,
            eye,
            steps,
            lean,
            exponent,
        }
    })
}

fn known_views() -> impl Strategy<Value = KnownView> {
    let quaternion = (1..=4, [-4..=4, -4..=4, -4..=4]).prop_map(|(a, [b, c, d])| [a, b, c, d]);
    let eye = [-20..=20, -20..=20, -20..=20].prop_map(|eye| (eye, 0));
    known_views_of(quaternion, eye)
}

/// Along the axes, far from the origin, tiny and huge.
fn hard_known_views() -> impl Strategy<Value = KnownView> {
    let along_an_axis = prop::sample::select(vec![
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [1, 1, 0, 0],
        [1, 0, 1, 0],
        [1, 1, 1, 1],
        [40, 1, 0, 0],
    ]);
    let far = prop::sample::select(vec![
        ([1_000_000_007, -1_000_000_007, 999_999_937], 0),
        ([0; 3], -300),
        ([0; 3], 300),
        ([0; 3], 0),
    ]);
    known_views_of(along_an_axis, far)
}

/// Passes where axis number `index` is within [`ROUNDOFFS`] of the exact one.
fn expect_axis(view: &KnownView, index: usize) -> Verdict {
    let norm = view.quaternion.iter().map(|part| part * part).sum::<i32>();
    // This division rounds once.
    let exact = view.whole_axes()[index].map(|coordinate| coordinate / f64::from(norm));
    let computed = view.computed()?[index];
    let error = computed.minus(exact).largest_coordinate();
    let bound = (ROUNDOFFS + 1.0) * ROUNDOFF;
    let name = ["u", "v", "w"][index];
    if error <= bound {
        return Ok(());
    }
    Err(Broken {
        expected: format!("{name} within {bound:e} of {exact:?}"),
        got: format!("{computed:?}"),
    })
}

/// **The frame looks at the target.** The axis $\mathbf w$ is the unit vector from the target to the eye, $\mathbf w=\frac{\mathbf e-\mathbf c}{\lVert\mathbf e-\mathbf c\rVert}$: it points
/// *backwards*, so that $(\mathbf u,\mathbf v,\mathbf w)$ is right-handed with $\mathbf u$ to the right and $\mathbf v$ up.
///
/// Course: R01, slide 88, The frame of the camera: (e, u, v, w).
/// Exercise: frame.
#[test]
fn frame_looks_at_the_target() {
    let law = Law::new("camera::frame_looks_at_the_target", suspects::frame);
    law.holds(known_views(), hard_known_views(), |view| {
        expect_axis(view, 2)
    });
}

/// **The frame is orthonormal.** $\mathbf u\cdot\mathbf u=\mathbf v\cdot\mathbf v=\mathbf w\cdot\mathbf w=1$, $\mathbf u\cdot\mathbf v=\mathbf v\cdot\mathbf w=\mathbf w\cdot\mathbf u=0$, and
/// $\mathbf u\times\mathbf v=\mathbf w$. That holds whatever the length of up and of the view, and whatever the angle between them.
///
/// Course: R01, slide 88, The frame of the camera: (e, u, v, w).
/// Exercise: frame.
#[test]
fn frame_is_orthonormal_and_right_handed() {
    let name = "camera::frame_is_orthonormal_and_right_handed";
    Law::new(name, suspects::frame).holds(known_views(), hard_known_views(), |view| {
        let axes = view.computed()?;
        for (i, a) in axes.into_iter().enumerate() {
            for (j, b) in axes.into_iter().enumerate() {
                let expected = if i == j { 1.0 } else { 0.0 };
                let names = ["u", "v", "w"];
                let what = format!("|{} · {} − {expected}|", names[i], names[j]);
                let error = (a.dot(b) - expected).abs();
                // Axes within 64u of their exact values: twice that, and 3 for the product itself.
                expect_at_most(&what, (2.0 * ROUNDOFFS + 3.0) * ROUNDOFF, error)?;
            }
        }
        let [u, v, w] = axes;
        let beside = u.cross(v).minus(w).largest_coordinate();
        expect_at_most("|u × v − w|", (3.0 * ROUNDOFFS + 3.0) * ROUNDOFF, beside)
    });
}

/// **What points up appears upright.** The axis $\mathbf u$ is perpendicular to up, and $\mathbf v$ lies in the plane of up and the view, on the side of up. So an object that stands along up
/// stands upright in the image, leaning neither to the left nor to the right.
///
/// Course: R01, slide 88, The frame of the camera: (e, u, v, w).
/// Exercise: frame.
#[test]
fn up_appears_upright() {
    let law = Law::new("camera::up_appears_upright", suspects::frame);
    law.holds(known_views(), hard_known_views(), |view| {
        expect_axis(view, 0)?;
        expect_axis(view, 1)
    });
}

/// **The frame passes its own test.** [`CameraFrame::from_axes`] takes every frame that [`CameraFrame::looking_at`] makes, since it allows 32 roundoffs where 23 can occur; and the frame made without
/// an opinion on up looks at the target too.
#[test]
fn frames_are_accepted_as_axes() {
    let name = "camera::frames_are_accepted_as_axes";
    Law::new(name, suspects::library).holds(known_views(), hard_known_views(), |view| {
        let [eye, target, up] = view.data();
        let broken = |error: CameraError<f64>| Broken {
            expected: "a frame".to_owned(),
            got: error.to_string(),
        };
        let chosen = CameraFrame::looking_at(eye, target, up).map_err(broken)?;
        let any = CameraFrame::looking_at_with_any_up(eye, target).map_err(broken)?;
        for frame in [chosen, any] {
            CameraFrame::from_axes(eye, frame.axes()).map_err(broken)?;
            let [_, _, w] = frame.axes();
            expect_equal(&chosen.axes()[2], &w)?;
        }
        Ok(())
    });
}

/// **The field of view spans the height.** Under the vertical angle $\theta$, an image plane at the distance $D$ is seen from $-h$ to $h$ with $h=D\tan\tfrac\theta2$: the rays through the middle of
/// the upper and of the lower border enclose the angle $\theta$. The width is the height times the aspect ratio, so the horizontal angle is $2\arctan(a\tan\tfrac\theta2)$, and not $a\,\theta$.
///
/// Course: R02, slide 90, Perspective rays: the distance of the image plane and the rectangle.
/// Exercise: field_of_view.
#[test]
fn field_of_view_spans_the_height() {
    let name = "camera::field_of_view_spans_the_height";
    let ordinary = (0.1..10.0_f64, 0.1..10.0_f64, 0.2..5.0_f64);
    let hard = (
        prop::sample::select(vec![1e-30, 1e-9, 1.0, 1e6]),
        prop::sample::select(vec![1e-30, 1.0, 1e30]),
        prop::sample::select(vec![1e-3, 1.0, 1e3]),
    );
    Law::new(name, suspects::field_of_view).holds(
        ordinary,
        hard,
        |&(tangent, distance, aspect)| {
            let angle = 2.0 * tangent.atan();
            // The arc tangent is within an ulp, 2u; the tangent of half an angle θ turns a relative error of it into θ/sin θ as much.
            let through_the_angle = 2.0 * angle * (1.0 + tangent * tangent) / (2.0 * tangent);
            let near = |what: &str, computed: f64, exact: f64| {
                let error = (computed - exact).abs() / exact;
                // Beside it: 6u of the function itself, 1u for the width, 2u for the products here.
                expect_at_most(what, (through_the_angle + 9.0) * ROUNDOFF, error)
            };
            let exact = distance * tangent;
            near("a relative error", half_extent(angle, distance), exact)?;
            let rectangle = ImageRectangle::from_field_of_view(angle, aspect, distance);
            let rectangle = rectangle.expect("an angle below π");
            near("an error of the top", rectangle.top(), exact)?;
            near("an error of the bottom", -rectangle.bottom(), exact)?;
            near("an error of the right", rectangle.right(), aspect * exact)?;
            near("an error of the left", -rectangle.left(), aspect * exact)
        },
    );
}
