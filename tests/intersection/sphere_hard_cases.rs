//! Spheres that the slides' quadratic loses or misplaces, and what keeps them.

use facette::algebra::{Real, VectorSpace};
use facette::intersection::{
    Intersect, IntersectionError, Side, Sphere, roots_by_projection, roots_by_quadratic,
};
use facette::ray::Ray;

type Point = [f64; 3];

fn unit_sphere() -> Sphere<Point> {
    sphere([0.0; 3], 1.0)
}

fn sphere(centre: Point, radius: f64) -> Sphere<Point> {
    Sphere::new(centre, radius).expect("a positive radius")
}

fn relative_error(value: f64, truth: f64) -> f64 {
    ((value - truth) / truth).abs()
}

/// **A sphere far away.** The unit sphere, seen from $10^8$ along a line at the distance $\tfrac12$ from its centre: $\mathbf p\cdot\mathbf p=10^{16}+\tfrac14$, and floating point keeps $10^{16}$. The discriminant becomes 0 instead of
/// $0.75$, and the quadratic finds a tangent in the middle of the sphere: wrong by $0.866$ radii. The form by projection never squares the distance, and is right to the last bit.
#[test]
fn far_sphere() {
    let (p, d) = ([0.3, 0.4, -1e8], [0.0, 0.0, 1.0]);
    let truth: f64 = 99_999_999.133_974_6;
    let naive = roots_by_quadratic(p, d, 1.0).expect("it is found, at least");
    assert!((naive[0] - truth).abs() > 0.86, "{naive:?}");
    let [near, _] = roots_by_projection(p, d, 1.0).expect("half a radius from the centre");
    assert!(relative_error(near, truth) <= 1.5e-16, "{near}");
    let hit = unit_sphere().intersect(&Ray::new(p, d)).expect("the same");
    assert_eq!(hit.t, near);
}

/// **A ray that misses by an ulp.** A line that passes the unit sphere at the distance $1+2^{-52}$ has no point in common with it. From every distance between 5 and $10^{15}$ the quadratic says that it has; the distance of the line from the
/// centre, compared with the radius, says no.
#[test]
fn ray_that_misses_by_an_ulp() {
    let height = 1.0 + f64::EPSILON;
    let distances = [5.0]
        .into_iter()
        .chain((3..=15).map(|exponent| 10.0_f64.powi(exponent)));
    for distance in distances {
        let (p, d) = ([0.0, height, -distance], [0.0, 0.0, 1.0]);
        assert!(
            roots_by_quadratic(p, d, 1.0).is_some(),
            "a false hit from {distance}"
        );
        assert_eq!(roots_by_projection(p, d, 1.0), None);
        assert!(unit_sphere().intersect(&Ray::new(p, d)).is_none());
        let touching = Ray::new([0.0, 1.0, -distance], d);
        assert!(
            unit_sphere().intersect(&touching).is_some(),
            "the tangent from {distance}"
        );
    }
}

/// **A ray that grazes within an ulp.** At the distance $1-2^{-53}$ from the centre the chord is $2\cdot1.49\cdot10^{-8}$ long. The quadratic finds its ends with a relative error of $3\cdot10^{-9}$, a fifth of the chord's half; by projection the error is in the last bit.
#[test]
fn grazing_ray() {
    let (p, d) = ([1.0 - f64::EPSILON / 2.0, 0.0, -5.0], [0.0, 0.0, 2.0]);
    let truth = 2.499_999_992_549_419_4;
    let naive = roots_by_quadratic(p, d, 1.0).map_or(f64::INFINITY, |[near, _]| near);
    assert!(relative_error(naive, truth) > 2e-9, "{naive}");
    let [near, _] = roots_by_projection(p, d, 1.0).expect("it grazes");
    assert!(relative_error(near, truth) <= 1.8e-16, "{near}");
}

/// **A huge sphere underfoot.** A planet of radius $10^{10}$, an eye 1.5 above it, looking down and forward. The answer is near 1.9, the two numbers that the quadratic subtracts for it are $10^{10}$: it loses half of the digits.
#[test]
fn huge_sphere_underfoot() {
    let planet = sphere([0.0, 0.0, -1e10], 1e10);
    let ray = Ray::new([0.0, 0.0, 1.5], [0.6, 0.0, -0.8]);
    let truth = 1.875_000_000_079_101_5;
    let p = ray.origin.minus(planet.centre());
    let naive = roots_by_quadratic(p, ray.direction, planet.radius()).expect("straight below");
    assert!(relative_error(naive[0], truth) > 1e-7, "{naive:?}");
    let hit = planet.intersect(&ray).expect("straight below");
    assert!(
        relative_error(hit.t, truth) <= 2.0 * f64::EPSILON,
        "{}",
        hit.t
    );
}

/// **Directions of any length.** Nothing in the geometry says how long $\mathbf d$ is. But $\mathbf d\cdot\mathbf d$ underflows for a length of $10^{-160}$ and overflows for $10^{154}$: the quadratic loses four digits, then
/// the sphere. Measured in powers of two, all lengths give the same bits, down to denormal numbers; in single precision likewise, where the limits are $10^{-20}$ and $10^{19}$.
#[test]
fn directions_of_any_length() {
    let (p, d) = ([0.3, -0.2, -5.0], [0.02, 0.03, 1.0]);
    let [truth, _] = unit_sphere()
        .chord(&Ray::new(p, d))
        .expect("near the centre");
    for (scale, naive_limit) in [
        (1e-160, 1e-6),
        (1e154, f64::INFINITY),
        (1e160, f64::INFINITY),
    ] {
        let scaled = d.times(scale);
        let naive =
            roots_by_quadratic(p, scaled, 1.0).map_or(f64::INFINITY, |[near, _]| near * scale);
        let is_wrong = naive.is_nan() || relative_error(naive, truth) >= naive_limit;
        assert!(is_wrong, "{scale}: {naive}");
        let hit = unit_sphere()
            .intersect(&Ray::new(p, scaled))
            .expect("the same line");
        assert!(
            relative_error(hit.t * scale, truth) <= 1e-15,
            "{scale}: {}",
            hit.t
        );
    }
    for scale in [1e-37_f32, 1e-30, 1e20, 1e30] {
        let single = Sphere::new([0.0_f32; 3], 1.0).expect("a positive radius");
        let ray = Ray::new([0.0, 0.25, -5.0], [0.0, 0.0, scale]);
        let hit = single.intersect(&ray).expect("near the centre");
        let truth = (5.0 - 0.9375_f64.sqrt()) / f64::from(scale);
        assert!(
            relative_error(f64::from(hit.t), truth) < 2e-7,
            "{scale}: {}",
            hit.t
        );
    }
    let smallest = f64::from_bits(1);
    let tiny = sphere([0.0; 3], 1e-20);
    let hit = tiny.intersect(&Ray::new([0.0, 0.0, -5e-20], [0.0, 0.0, smallest]));
    let t = hit.expect("straight at its centre").t;
    assert!(
        relative_error(t * 2.0_f64.powi(-1000), 4e-20 * 2.0_f64.powi(74)) < 1e-15,
        "{t}"
    );
    // A t that no number of the type can hold is no hit.
    let beyond = unit_sphere().intersect(&Ray::new([0.0, 0.0, -5.0], [0.0, 0.0, smallest]));
    assert!(beyond.is_none());
}

/// **Spheres of any size.** The same goes for the coordinates: everything $10^{\pm200}$ times as large is the same problem with the same $t$, but $\mathbf p\cdot\mathbf p$ is 0 or infinite.
#[test]
fn spheres_of_any_size() {
    let (p, d) = ([0.5, -0.5, -5.0], [0.0, 0.125, 1.0]);
    let truth = unit_sphere()
        .intersect(&Ray::new(p, d))
        .expect("near the centre")
        .t;
    for exponent in [-900, -600, 600, 900] {
        let size = 2.0_f64.powi(exponent);
        let (p, d) = (p.times(size), d.times(size));
        let naive = roots_by_quadratic(p, d, size).map(|[near, _]| near);
        assert_ne!(naive, Some(truth), "2^{exponent}");
        let hit = sphere([0.0; 3], size).intersect(&Ray::new(p, d));
        assert_eq!(hit.map(|hit| hit.t), Some(truth), "2^{exponent}");
    }
}

/// **An origin on the surface.** A ray that starts on a sphere has one root at 0, which is not an answer. Whether the sphere lies before the ray or around it is decided by the sign of $(\lvert\mathbf p\rvert-r)(\lvert\mathbf p\rvert+r)$:
/// on the surface, entering, it sees the far side; leaving, or touching, nothing. One ulp outside, leaving, it sees nothing; one ulp inside, the surface in front of it.
#[test]
fn origin_on_the_surface() {
    let [on, above, below] = [1.0, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON / 2.0];
    let [entering, leaving, tangent] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let t = |height: f64, direction: Point| {
        let hit = unit_sphere().intersect(&Ray::new([height, 0.0, 0.0], direction));
        hit.map(|hit| (hit.t, hit.side))
    };
    assert_eq!(t(on, entering), Some((2.0, Side::Back)));
    assert_eq!(t(on, leaving), None);
    assert_eq!(t(on, tangent), None);
    assert_eq!(t(above, entering), Some((f64::EPSILON, Side::Front)));
    assert_eq!(t(above, leaving), None);
    assert_eq!(t(above, tangent), None);
    assert_eq!(
        t(below, entering),
        Some((2.0 - f64::EPSILON / 2.0, Side::Back))
    );
    assert_eq!(t(below, leaving), Some((f64::EPSILON / 2.0, Side::Back)));
    // Half the chord is √(1 − (1 − ε/2)²) = √ε (1 − ε/8 − …), which rounds to √ε.
    assert_eq!(t(below, tangent), Some((f64::EPSILON.sqrt(), Side::Back)));
    // Obliquely from one ulp outside: −b − √Δ is a multiple of 2⁻⁵³, and the truth, 2.2e-16 / 0.6, is not.
    let (p, oblique) = ([above, 0.0, 0.0], [-0.6, 0.8, 0.0]);
    let truth = f64::EPSILON / 0.6;
    let naive = roots_by_quadratic(p, oblique, 1.0).map_or(f64::INFINITY, |[near, _]| near);
    assert!(relative_error(naive, truth) > 0.05, "{naive}");
    let (near, side) = t(above, oblique).expect("it enters");
    assert!(
        relative_error(near, truth) < 1e-15 && side == Side::Front,
        "{near}"
    );
}

/// **A tiny sphere far away.** Radius $10^{-8}$ at the distance $10^8$: the sphere is smaller than the spacing of the numbers there, $1.5\cdot10^{-8}$. A ray to its centre still hits, and both ends of the chord are right to the last bit.
#[test]
fn tiny_sphere_far_away() {
    let tiny = sphere([0.0, 0.0, 1e8], 1e-8);
    let chord = tiny
        .chord(&Ray::new([0.0; 3], [0.0, 0.0, 1.0]))
        .expect("straight at its centre");
    for (t, truth) in chord
        .into_iter()
        .zip([99_999_999.999_999_99, 100_000_000.000_000_01])
    {
        assert!((t - truth).abs() <= 1.5e-8, "{t}");
    }
    let past = Ray::new([0.0, 2e-8, 0.0], [0.0, 0.0, 1.0]);
    assert!(tiny.intersect(&past).is_none());
}

/// **What is no ray meets nothing.** NaN or infinity in an origin or a direction, and the direction zero, give no hit, of spheres, planes and boxes alike; and none of them stops the program.
#[test]
fn what_is_no_ray_meets_nothing() {
    use facette::intersection::{BoundingBox, Plane};
    let plane = Plane::new([0.0; 3], [0.0, 0.0, 1.0]).expect("a normal");
    let bounds = BoundingBox::new([-1.0; 3], [1.0; 3]).expect("corners in order");
    let surfaces: [&dyn Intersect<Point = Point>; 3] = [&unit_sphere(), &plane, &bounds];
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let (mut origin, mut direction) = ([0.25, 0.25, -3.0], [0.0, 0.0, 1.0]);
            (origin[axis], direction[axis]) = (wrong, wrong);
            for surface in surfaces {
                assert!(
                    surface
                        .intersect(&Ray::new(origin, [0.0, 0.0, 1.0]))
                        .is_none()
                );
                assert!(
                    surface
                        .intersect(&Ray::new([0.25, 0.25, -3.0], direction))
                        .is_none()
                );
            }
        }
    }
    for surface in surfaces {
        assert!(
            surface
                .intersect(&Ray::new([0.25, 0.25, -3.0], [0.0; 3]))
                .is_none()
        );
        assert!(surface.intersect(&Ray::new([0.25; 3], [-0.0; 3])).is_none());
    }
}

/// **What is no surface is refused.** A radius that is zero, negative, infinite or NaN, a normal without direction, a box that ends before it begins, and NaN or infinity anywhere: each is refused with a message that says what is wrong and what was expected.
#[test]
fn what_is_no_surface_is_refused() {
    use facette::intersection::{BoundingBox, Plane};
    for radius in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let refusal = Sphere::new([0.0; 3], radius).expect_err("no length");
        let message = refusal.to_string();
        assert_eq!(
            message,
            format!("the radius is {radius:?}: it must be a positive, finite length")
        );
    }
    let message = |refusal: IntersectionError<f64>| refusal.to_string();
    let nan = Sphere::new([0.0, f64::NAN, 0.0], 1.0).expect_err("no centre");
    assert_eq!(
        message(nan),
        "the centre is [0.0, NaN, 0.0]: its coordinates must be finite"
    );
    let flat = Plane::new([0.0; 3], [0.0; 3]).expect_err("no normal");
    assert_eq!(flat, IntersectionError::NormalIsZero);
    let reversed = BoundingBox::new([0.0, 2.0, 0.0], [1.0; 3]).expect_err("reversed in y");
    assert_eq!(
        message(reversed),
        "along axis 1 the box runs from 2.0 to 1.0: it must not end before it begins"
    );
    let none = BoundingBox::<Point>::around([]).expect_err("no points");
    assert_eq!(none, IntersectionError::NoPoints);
}

/// **A length beyond the last power of two.** From $2.9\cdot10^{38}$ on one side of the centre to $3\cdot10^{38}$ on the other is a way of $5.9\cdot10^{38}$, which single precision does not have. Along $\mathbf d=(0,0,10^{38})$ it is $t=5.9$: units of length and of speed are multiplied first where
/// one is large and the other small.
#[test]
fn way_through_a_huge_sphere_is_longer_than_any_number() {
    let huge = Sphere::new([0.0_f32; 3], 3e38).expect("a positive radius");
    let ray = Ray::new([0.0, 0.0, -2.9e38], [0.0, 0.0, 1e38]);
    assert!((3e38_f32 + 2.9e38).is_infinite());
    let hit = huge.intersect(&ray).expect("there is no way out");
    assert!((hit.t - 5.9).abs() <= hit.t_error, "{hit:?}");
    // The bound is that of the same scene in handy numbers; the size costs at most a factor of two, by units that are powers of two.
    let handy = Sphere::new([0.0_f32; 3], 3.0).expect("a positive radius");
    let alike = handy.intersect(&Ray::new([0.0, 0.0, -2.9], [0.0, 0.0, 1.0]));
    let largest = 2.0 * alike.expect("from inside").t_error;
    assert!(hit.t_error <= largest && hit.side == Side::Back, "{hit:?}");
    let tiny = Sphere::new([0.0_f32; 3], 3e-38).expect("a positive radius");
    let slow = Ray::new([0.0, 0.0, -2.9e-38], [0.0, 0.0, 1e-38]);
    let hit = tiny.intersect(&slow).expect("there is no way out");
    assert!((hit.t - 5.9).abs() <= hit.t_error, "{hit:?}");
}

/// **Units that round nothing.** The power of two that a length is measured in is at most the length and more than half of it; its reciprocal is finite even for denormal numbers, and multiplying by either is exact.
#[test]
fn power_of_two_is_a_unit_that_rounds_nothing() {
    for value in [1.0, 0.75, 3.0, -1e300, f64::MAX, f64::MIN_POSITIVE, 1e-300] {
        let unit = Real::power_of_two(value);
        assert!(
            unit <= value.abs() && value.abs() < 2.0 * unit,
            "{value}: {unit}"
        );
        assert_eq!(value / unit * unit, value);
        assert_eq!(value * (1.0 / unit), value / unit);
    }
    for value in [0.0, -0.0, f64::from_bits(1)] {
        assert_eq!(Real::power_of_two(value), f64::MIN_POSITIVE);
    }
    assert_eq!(Real::power_of_two(f64::NAN), f64::INFINITY);
    assert_eq!(
        [Real::power_of_two(5.0_f32), Real::power_of_two(1e-45_f32)],
        [4.0, f32::MIN_POSITIVE]
    );
}
