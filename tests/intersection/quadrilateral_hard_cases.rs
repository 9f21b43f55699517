//! Rays and quadrilateral facets where the equations degenerate.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::quadrilateral::Quadrilateral;
use facette::intersection::{Hit, Intersect, IntersectionError, Side};
use facette::ray::Ray;
use num_traits::ToPrimitive;

use crate::quadrilateral_inputs::exact_point;

/// **Both roots are hits.** A ray through a saddle from side to side meets it twice: first from the front, then, if it starts behind that, from the back.
#[test]
fn saddle_is_met_twice() {
    let saddle = [[0., 0., 0.], [2., 0., 2.], [2., 2., 0.], [0., 2., 2.]];
    let saddle = Quadrilateral::new(saddle).expect("finite corners");
    let ray = Ray::new([-0.5, -0.5, 0.75], [1.0, 1.0, 0.0]);
    let first = saddle.intersect(&ray).expect("the near side");
    let second = saddle.intersect(&ray.after(first.t)).expect("the far side");
    assert_eq!((first.t, second.t), (1.0, 2.0));
    assert_eq!((first.side, second.side), (Side::Front, Side::Back));
    assert_eq!(saddle.intersect(&ray.after(second.t)), None);
    let exact = |u: f64| exact_point(saddle.corners(), [u, u])[2].to_f64();
    assert_eq!([exact(0.25), exact(0.75)], [Some(0.75); 2]);
}

/// **A ruling is no hit.** A ray along a straight line of the patch, or in the plane of a flat one, misses; so does one that only touches. Next to it, all is well.
#[test]
fn ray_along_a_ruling_misses() {
    let corners = [[0., 0., 0.], [2., 0., 2.], [2., 2., 0.], [0., 2., 2.]];
    let saddle = Quadrilateral::new(corners).expect("finite corners");
    let along = Ray::new([0.0, 0.0, 0.0], [1.0, 0.0, 1.0]);
    let inner = Ray::new([1.0, -1.0, 1.0], [0.0, 1.0, 0.0]);
    assert_eq!([along, inner].map(|ray| saddle.intersect(&ray)), [None; 2]);
    let flat = Quadrilateral::new(corners.map(|[x, y, _]| [x, y, 1.0])).expect("finite corners");
    assert_eq!(
        flat.intersect(&Ray::new([-1.0, 1.0, 1.0], [1.0, 0.0, 0.0])),
        None
    );
    assert!(
        flat.intersect(&Ray::new([-1.0, 1.0, 1.0 + 1e-9], [1.0, 0.0, -5e-10]))
            .is_some()
    );
}

/// **Two corners in one make a triangle.** Where $\mathbf d=\mathbf a$, or $\mathbf c=\mathbf b$, the patch is a triangle, and is met as one.
#[test]
fn collapsed_quadrilateral_is_a_triangle() {
    let [a, b, c] = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]];
    let ray = Ray::new([1.0, 1.5, 3.0], [0.0, 0.0, -1.0]);
    for corners in [[a, b, c, a], [a, a, b, c], [a, b, b, c], [a, b, c, c]] {
        let patch = Quadrilateral::new(corners).expect("finite corners");
        let hit = patch.intersect(&ray).expect("inside");
        assert_eq!(
            (hit.t, hit.point, hit.normal),
            (3.0, [1.0, 1.5, 0.0], [0.0, 0.0, 1.0]),
            "{corners:?}"
        );
        assert_eq!(
            patch.intersect(&Ray::new([3.0, 3.0, 3.0], ray.direction)),
            None
        );
    }
}

/// A saddle of the given size, and a ray whose direction has the given length: met at t = 3.1957 size / speed.
fn saddle_of_size<S: Real>(size: S, speed: S) -> Option<Hit<[S; 3]>> {
    let scaled = |point: [f64; 3], unit: S| point.map(|x| S::from_f64(x) * unit);
    let corners = [
        [-1., -1., 1.],
        [2., -1., 1.5],
        [2., 2., 1.],
        [-1., 2., 1.25],
    ];
    let saddle = Quadrilateral::new(corners.map(|corner| scaled(corner, size)));
    saddle.expect("finite corners").intersect(&Ray::new(
        scaled([0.25, 0.125, -2.0], size),
        scaled([0.0625, 0.03125, 1.0], speed),
    ))
}

/// Whether the hit is the one of size 1, to the last bit.
fn expect_same_digits<S: Real>(exponents: [i32; 2]) {
    let [size, speed] = exponents.map(|exponent| S::from_f64(2.0_f64.powi(exponent)));
    let unit = saddle_of_size(S::one(), S::one()).expect("inside");
    let hit = saddle_of_size(size, speed);
    let expected = Hit {
        t: unit.t * size / speed,
        t_error: unit.t_error * size / speed,
        point: unit.point.times(size),
        point_error: unit.point_error * size,
        ..unit
    };
    assert_eq!(hit, Some(expected), "size and speed 2^{exponents:?}");
}

/// **A quadrilateral may have any size.** The discriminant has products of four lengths and two coordinates of $\mathbf d$: of $10^{10}$ they overflow in `f32`, of $10^{-12}$ they underflow. In powers of two near the sizes of the facet and of $\mathbf d$ the hit has the same digits at all sizes and all speeds.
#[test]
fn quadrilateral_may_have_any_size() {
    let t = saddle_of_size::<f64>(1.0, 1.0).expect("inside").t;
    // The root is 3.195717 to six decimals: within half a unit of the last.
    assert!((t - 3.195_717).abs() <= 0.5e-6, "{t}");
    for exponent in (-90..=120).step_by(10) {
        for speed in [exponent, exponent - 30, exponent / 2, 0] {
            expect_same_digits::<f32>([exponent, speed]);
        }
    }
    for exponent in (-950..=1000).step_by(50) {
        for speed in [exponent, exponent / 2, 0] {
            expect_same_digits::<f64>([exponent, speed]);
        }
    }
}

/// **Far and slow.** A facet of $10^8$ at $10^{11}$, in `f32`: nothing about it is extreme but the products in the discriminant. The ray through its side meets it at $t=1$.
#[test]
fn quadrilateral_far_away_is_met_in_single_precision() {
    let corners: [[f32; 3]; 4] = [
        [99_979_665_408.0, 99_991_502_848.0, 99_997_057_024.0],
        [100_098_605_056.0, 100_024_311_808.0, 100_025_540_608.0],
        [100_082_499_584.0, 100_103_569_408.0, 100_015_611_904.0],
        [99_997_597_696.0, 100_126_498_816.0, 100_011_278_336.0],
    ];
    let ray = Ray::new(
        [100_097_430_000.0, 100_061_800_000.0, 100_046_620_000.0],
        [-58_271_520.0, -50_742_470.0, -35_256_724.0],
    );
    let hit = Quadrilateral::new(corners)
        .expect("finite corners")
        .intersect(&ray);
    let hit = hit.expect("inside");
    // The exact root is 1.00000004.
    assert!((hit.t - 1.000_000_04).abs() <= hit.t_error, "{hit:?}");
    assert!(
        hit.t_error < 1.0 / 1024.0,
        "a bound that says something: {hit:?}"
    );
}

/// **What is not finite is met nowhere.** So with NaN, infinity or no direction in the ray; corners that are not finite are refused by name.
#[test]
fn rays_that_are_not_finite_miss_every_quadrilateral() {
    let corners = [[0., 0., 0.], [2., 0., 2.], [2., 2., 0.], [0., 2., 2.]];
    let saddle = Quadrilateral::new(corners).expect("finite corners");
    let good = ([1., 1., 5.], [0., 0., -1.]);
    let mut rays = vec![Ray::new(good.0, [0.0; 3])];
    for axis in 0..3 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (mut origin, mut direction) = good;
            origin[axis] = bad;
            direction[axis] = bad;
            rays.extend([Ray::new(origin, good.1), Ray::new(good.0, direction)]);
        }
    }
    for ray in rays {
        assert_eq!(saddle.intersect(&ray), None, "{ray:?}");
    }
    let refusal = Quadrilateral::new([
        corners[0],
        corners[1],
        corners[2],
        [0.0, 0.0, f64::INFINITY],
    ]);
    assert!(
        matches!(
            refusal,
            Err(IntersectionError::NotFinite {
                what: "corner d",
                ..
            })
        ),
        "{refusal:?}"
    );
}
