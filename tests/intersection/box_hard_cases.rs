//! Boxes and rays for which the usual slabs compute 0 · ∞, take near for far, or lose a ray by rounding; and what keeps them.

use facette::algebra::VectorSpace;
use facette::intersection::{BoundingBox, Intersect, SlabRay, box_interval};
use facette::ray::Ray;

use num_traits::Signed;

use crate::common::oracle::big;
use crate::float_boxes::big_interval;
use crate::variants_spheres::{ignoring_slabs, propagating_slabs, slabs_by_sign, unwidened_slabs};

type Point = [f64; 3];
type Case = (&'static str, BoundingBox<Point>, Ray<Point>);
/// Whether a ray meets a box, by some way of asking.
type Test = fn(&BoundingBox<Point>, &Ray<Point>) -> bool;

/// The smallest number above zero: its reciprocal is infinite.
const SMALLEST: f64 = f64::from_bits(1);

fn dice() -> BoundingBox<Point> {
    cuboid([-1.0; 3], [1.0; 3])
}

fn cuboid(min: Point, max: Point) -> BoundingBox<Point> {
    BoundingBox::new(min, max).expect("corners in order")
}

/// The case in the three positions that the axes allow.
fn turned(
    name: &'static str,
    bounds: BoundingBox<Point>,
    origin: Point,
    direction: Point,
) -> impl Iterator<Item = Case> {
    (0..3).map(move |turns| {
        let turn = |mut vector: Point| {
            vector.rotate_right(turns);
            vector
        };
        let bounds = cuboid(turn(bounds.min()), turn(bounds.max()));
        (name, bounds, Ray::new(turn(origin), turn(direction)))
    })
}

/// All 75 cases: 25, in three positions each.
#[rustfmt::skip]
fn cases() -> Vec<Case> {
    let plate = cuboid([-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]);
    let needle = cuboid([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]);
    let point = cuboid([0.5; 3], [0.5; 3]);
    let of = |name, bounds, origin, direction| turned(name, bounds, origin, direction);
    [
        of("through", dice(), [-3.0, 0.25, 0.5], [1.0, 0.125, -0.25]),
        of("backwards_through", dice(), [3.0, 0.25, 0.5], [-1.0, 0.125, -0.25]),
        of("from_inside", dice(), [0.25, 0.5, 0.0], [1.0, -2.0, 0.5]),
        of("past", dice(), [-3.0, 2.0, 0.5], [1.0, 0.125, 0.25]),
        of("behind", dice(), [3.0, 0.25, 0.5], [1.0, 0.125, -0.25]),
        of("parallel_inside_+0", dice(), [-3.0, 0.25, 0.5], [1.0, 0.0, 0.0]),
        of("parallel_inside_-0", dice(), [-3.0, 0.25, 0.5], [1.0, -0.0, -0.0]),
        of("parallel_outside_+0", dice(), [-3.0, 2.0, 0.5], [1.0, 0.0, 0.0]),
        of("parallel_outside_-0", dice(), [-3.0, 2.0, 0.5], [1.0, -0.0, -0.0]),
        of("face_plane_+0", dice(), [-3.0, 0.25, 1.0], [1.0, 0.0, 0.0]),
        of("face_plane_-0", dice(), [-3.0, 0.25, 1.0], [1.0, -0.0, -0.0]),
        of("face_plane_min_+0", dice(), [-3.0, 0.25, -1.0], [1.0, 0.0, 0.0]),
        of("face_plane_min_-0", dice(), [-3.0, 0.25, -1.0], [1.0, -0.0, -0.0]),
        of("origin_on_face_along_+0", dice(), [0.5, 0.25, 1.0], [1.0, 0.0, 0.0]),
        of("origin_on_face_along_-0", dice(), [0.5, 0.25, 1.0], [1.0, -0.0, -0.0]),
        of("origin_at_corner_axis", dice(), [-1.0; 3], [1.0, 0.0, 0.0]),
        of("edge_touch", dice(), [-3.0, 1.0, 1.0], [1.0, 0.0, 0.0]),
        of("edge_line_diag", dice(), [-2.0, 0.0, 1.0], [1.0, 1.0, 0.0]),
        of("corner_touch", dice(), [-2.0, 0.0, 3.0], [1.0, 1.0, -2.0]),
        of("flat_box_in_plane", plate, [-3.0, 0.25, 0.0], [1.0, 0.0, 0.0]),
        of("flat_box_across", plate, [0.25, 0.5, -2.0], [0.125, 0.0, 1.0]),
        of("needle_box_along", needle, [0.0, 0.0, -3.0], [0.0, -0.0, 1.0]),
        of("point_box", point, [-0.5, 0.0, 1.5], [1.0, 0.5, -1.0]),
        of("subnormal_in_plane", dice(), [-3.0, 0.25, 1.0], [1.0, SMALLEST, -SMALLEST]),
        of("subnormal_inside", dice(), [-3.0, 0.25, 0.5], [1.0, -SMALLEST, SMALLEST]),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Whether the half-line truly meets the box.
fn is_met(bounds: &BoundingBox<Point>, ray: &Ray<Point>) -> bool {
    let interval = big_interval(bounds, ray);
    interval.is_some_and(|[_, exit]| exit >= num_traits::Zero::zero())
}

fn library(bounds: &BoundingBox<Point>, ray: &Ray<Point>) -> bool {
    bounds.may_be_hit_by(&SlabRay::new(ray))
}

/// The names of the cases that a test gets wrong, each once, and how many cases that are.
fn wrong(test: Test) -> (Vec<&'static str>, usize) {
    let cases = cases();
    let wrong = cases
        .iter()
        .filter(|(_, bounds, ray)| test(bounds, ray) != is_met(bounds, ray));
    let all: Vec<_> = wrong.map(|(name, ..)| *name).collect();
    let count = all.len();
    let mut names = all;
    names.dedup();
    (names, count)
}

/// **Zero times infinity.** A ray in the plane of a face has $d_k=0$ and $\min_k-o_k=0$, and the slab's parameter $(\min_k-o_k)\cdot\tfrac1{d_k}$ is $0\cdot\infty$: not a number. Minimum and maximum that give NaN for NaN lose all such rays, 36 of the 75 cases; those that take the other argument
/// instead, as `f64::min` does, put the slab's second plane, infinitely far away, in the place of the first, and lose 30. With comparisons that are false for NaN the interval stays as it is, which is right: the ray is in that slab everywhere. All 75 cases are then as the exact box says.
#[test]
fn zero_times_infinity_loses_rays_in_a_face() {
    assert_eq!(cases().len(), 75);
    let in_a_face = [
        "face_plane_+0",
        "face_plane_-0",
        "face_plane_min_+0",
        "face_plane_min_-0",
        "origin_on_face_along_+0",
        "origin_on_face_along_-0",
        "origin_at_corner_axis",
        "edge_touch",
        "edge_line_diag",
        "subnormal_in_plane",
    ];
    let (names, count) = wrong(ignoring_slabs);
    assert_eq!((names, count), (in_a_face.to_vec(), 30));
    let (names, count) = wrong(propagating_slabs);
    let in_a_flat_box = ["flat_box_in_plane", "needle_box_along"];
    let is_in_a_face = |name: &&str| in_a_face.contains(name) || in_a_flat_box.contains(name);
    assert!(count == 36 && names.iter().all(is_in_a_face), "{names:?}");
    assert_eq!(wrong(library), (vec![], 0));
    assert_eq!(
        wrong(|bounds, ray| box_interval(bounds, ray).is_some_and(|[_, exit]| exit >= 0.0)),
        (vec![], 0)
    );
}

/// **Minus zero.** A direction of $-0$ is not below 0, but its reciprocal is $-\infty$: who asks `d < 0` takes the near plane for the far one. Every ray inside the slab is lost, in the plane of a face or not. The sign of the reciprocal is right for both zeros; and who never divides by a zero need not know.
#[test]
fn minus_zero_exchanges_near_and_far() {
    let lost = [
        "parallel_inside_-0",
        "face_plane_-0",
        "face_plane_min_-0",
        "origin_on_face_along_-0",
    ];
    assert_eq!(wrong(slabs_by_sign), (lost.to_vec(), 12));
    assert_eq!(wrong(library).1, 0);
}

/// **A reciprocal that overflows.** The reciprocal of a denormal number, such as $5\cdot10^{-324}$, is infinite. A ray with such a coordinate that starts in a plane of the slab makes $0\cdot\infty$ as well, although nothing is divided by zero; anywhere farther away in the slab $\pm\infty$ is as good as the truth.
#[test]
fn denormal_direction_has_no_reciprocal() {
    let ray = Ray::new([-3.0, 0.25, 1.0], [1.0, 0.0, SMALLEST]);
    assert!(((1.0 - ray.origin[2]) * (1.0 / SMALLEST)).is_nan());
    assert!(!propagating_slabs(&dice(), &ray));
    assert!(library(&dice(), &ray));
    // It leaves the face's plane at once, outwards; and touches the face only where it starts, before the box.
    assert_eq!(box_interval(&dice(), &ray), None);
    let inwards = Ray::new([-3.0, 0.25, 1.0], [1.0, 0.0, -SMALLEST]);
    assert_eq!(box_interval(&dice(), &inwards), Some([2.0, 4.0]));
    assert!(library(&dice(), &inwards));
}

/// **Flat boxes.** The box around a triangle in a plane has no thickness, the box around a point no size at all. Entry and exit are then one number, and `entry < exit` would lose everything in it. Both are hit where the ray goes through them, across and along.
#[test]
fn flat_boxes_can_be_hit() {
    let plate = cuboid([-1.0, -1.0, 0.5], [1.0, 1.0, 0.5]);
    let across = plate.intersect(&Ray::new([0.25, 0.5, -2.0], [0.0, 0.0, 1.0]));
    assert_eq!(
        across.map(|hit| (hit.t, hit.normal)),
        Some((2.5, [0.0, 0.0, -1.0]))
    );
    let along = plate.intersect(&Ray::new([-3.0, 0.5, 0.5], [1.0, 0.0, 0.0]));
    assert_eq!(
        along.map(|hit| (hit.t, hit.normal)),
        Some((2.0, [-1.0, 0.0, 0.0]))
    );
    let point = cuboid([0.5; 3], [0.5; 3]);
    let aimed = Ray::new([-0.5, 0.0, 1.5], [1.0, 0.5, -1.0]);
    assert_eq!(point.intersect(&aimed).map(|hit| hit.t), Some(1.0));
    assert!(
        library(&point, &aimed) && library(&plate, &Ray::new([-3.0, 0.5, 0.5], [1.0, 0.0, 0.0]))
    );
}

/// **Rays through an edge.** A ray that is aimed at a point of an edge enters one slab where it leaves another: entry and exit are equal, and rounding may put the entry behind the exit. Of twenty thousand rays to points of an edge, in single precision, the plain comparison loses nearly a thousand;
/// with the exit widened by $8\mathbf u$ none is lost.
#[test]
fn rounding_loses_rays_through_an_edge() {
    let [mut met, mut lost] = [0, 0];
    for index in 0..20_000_u16 {
        // A point on the edge x = y = 1 and an origin, in full single precision, by multiples of irrational numbers.
        let part = |factor: f32| (f32::from(index) * factor).fract();
        let origin = [
            2.0 + part(0.618_034),
            -3.0 - part(0.414_213_57),
            part(0.732_050_8),
        ];
        let target = [1.0, 1.0, 2.0 * part(0.236_068) - 1.0];
        let bounds = BoundingBox::new([-1.0_f32; 3], [1.0; 3]).expect("corners in order");
        let ray = Ray::new(origin, target.minus(origin));
        if big_interval(&bounds, &ray).is_none() {
            continue;
        }
        met += 1;
        lost += i32::from(!unwidened_slabs(&bounds, &ray));
        assert!(bounds.may_be_hit_by(&SlabRay::new(&ray)), "{ray:?}");
    }
    println!("{lost} of {met} rays are lost by the plain comparison");
    assert!(met > 5000 && lost > 100, "{lost} of {met}");
}

/// **A subnormal direction, and a plane as near.** Divided by a subnormal $d_k$, a coordinate as small gives an ordinary parameter: along $\mathbf d=(10^{-310},1,0)$ the plane $x=10^{-310}$ is crossed at $t=1$. But $1/d_k$ overflows, and $10^{-310}\cdot\infty$ puts the entry at infinity,
/// after every exit: the box is lost. The prepared ray lets such a slab decide nothing, which loses no box, and is right here; the span divides, and is right everywhere.
#[test]
fn subnormal_direction_meets_a_plane_as_near() {
    let bounds = cuboid([1e-310, -5.0, -5.0], [1.0, 5.0, 5.0]);
    for (_, bounds, ray) in turned("as_near", bounds, [0.0; 3], [1e-310, 1.0, 0.0]) {
        let lost = unwidened_slabs(&bounds, &ray);
        assert!(!lost && library(&bounds, &ray), "{ray:?}");
        assert_eq!(box_interval(&bounds, &ray), Some([1.0, 5.0]));
    }
    let single = BoundingBox::new([1e-40_f32, -5.0, -5.0], [1.0, 5.0, 5.0]);
    let single = single.expect("corners in order");
    let ray = Ray::new([0.0; 3], [1e-40_f32, 1.0, 0.0]);
    assert!(single.may_be_hit_by(&SlabRay::new(&ray)));
    // Another slab still decides.
    let beside = Ray::new([0.0, 0.0, 6.0], ray.direction);
    assert!(!single.may_be_hit_by(&SlabRay::new(&beside)));
}

/// **A ray that ends on the box.** A hierarchy asks its boxes up to the best hit so far, which may lie on the very face: a box that is touched exactly at the ray's end is met, in spite of the rounding of both numbers.
#[test]
fn box_at_the_end_of_the_ray_is_met() {
    for thirds in 1..200_i32 {
        let distance = f64::from(thirds) / 3.0;
        let bounds = cuboid([distance, -1.0, -1.0], [distance + 1.0, 1.0, 1.0]);
        let ray = Ray::new([0.1, 0.0, 0.0], [0.7, 0.01, 0.0]);
        let hit = bounds.intersect(&ray).expect("it lies ahead");
        assert!(library(&bounds, &ray.until(hit.t)), "at {distance}");
        assert!(bounds.may_be_hit_by(&SlabRay::new(&ray).until(hit.t)));
        assert!(!library(&bounds, &ray.until(0.9 * hit.t)), "at {distance}");
        assert!(
            !library(&bounds, &ray.after(hit.t + 3.0)),
            "behind {distance}"
        );
    }
}

/// **Along a diagonal.** Where a ray enters through an edge or a corner, several slabs begin at the same $t$: the face that is named is that of the first of them, x before y before z, and so is the face where it leaves.
#[test]
fn first_of_several_faces_is_named() {
    let unit = cuboid([0.0; 3], [1.0; 3]);
    for (origin, direction) in [([-1.0; 3], [1.0; 3]), ([2.0; 3], [-1.0; 3])] {
        let span = unit
            .span(&Ray::new(origin, direction))
            .expect("the diagonal");
        assert_eq!((span.entry_axis, span.exit_axis), (0, 0), "{origin:?}");
    }
    let along_yz = Ray::new([0.5, -1.0, -1.0], [0.0, 1.0, 1.0]);
    let span = unit.span(&along_yz).expect("a diagonal of a face");
    assert_eq!((span.entry_axis, span.exit_axis), (1, 1));
}

/// **Two roundings add up.** The distance to a plane is rounded, and then the quotient: for this ray the error of $t$ is 1.95 roundoffs, more than either alone. The bound of three has room for it.
#[test]
fn difference_and_quotient_both_round() {
    let bounds = cuboid([4.711_351_586_691_732, -1.0, -1.0], [9.0, 1.0, 1.0]);
    let ray = Ray::new(
        [0.655_537_309_770_931_8, 0.0, 0.0],
        [1.975_950_870_022_111_6, 0.0, 0.0],
    );
    let hit = bounds.intersect(&ray).expect("straight ahead");
    let [entry, _] = big_interval(&bounds, &ray).expect("straight ahead");
    let error = (big(hit.t) - entry).abs();
    assert!(error <= big(hit.t_error));
    assert!(
        error > big(1.9 * f64::EPSILON / 2.0 * hit.t),
        "an error that needs the second rounding"
    );
}
