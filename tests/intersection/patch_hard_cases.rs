//! Patches and rays that break the plain methods. The book shows their doc comments.

use std::time::{Duration, Instant};

use facette::algebra::VectorSpace;
use facette::bspline::{self, BsplineError};
use facette::intersection::bezier_patch::{PatchError, PatchIntersector};
use facette::intersection::{Hit, Intersect, Side};
use facette::ray::Ray;

use crate::patch_inputs::{patch, wild};
use crate::variants_surfaces::newton_from_the_middle;

type Point = [f64; 3];

/// All hits of a ray, one after the other.
fn all_hits(patch: &PatchIntersector<Point>, ray: Ray<Point>) -> Vec<Hit<Point>> {
    let mut hits: Vec<Hit<Point>> = Vec::new();
    let mut rest = ray;
    while let Some(hit) = patch.intersect(&rest) {
        rest = rest.after(hit.t);
        hits.push(hit);
        assert!(hits.len() <= 18, "more hits than a bicubic patch has");
    }
    hits
}

/// The graph z = −(x² + y²) over the square from −1 to 1.
fn dome() -> PatchIntersector<Point> {
    let half = [-1.0, 1.0, -1.0]; // −x² in Bézier form, over −1 <= x <= 1
    let points = (0..9).map(|k| {
        let [i, j] = [k % 3, k / 3];
        [i as f64 - 1.0, j as f64 - 1.0, half[i] + half[j]]
    });
    patch([2, 2], points.collect())
}

/// **Newton without a guard.** Newton's method from the middle of the patch, without subdivision and without a certificate, needs luck: on wild patches with a ray that is known to hit, it runs away or
/// finds a farther root in more than a tenth of all cases. Subdivision until a root is certain loses none.
#[test]
fn newton_from_the_middle_of_a_patch_needs_luck() {
    use proptest::strategy::{Strategy, ValueTree};
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let [mut lost, mut tried] = [0, 0];
    for _ in 0..400 {
        let input = wild().new_tree(&mut runner).expect("an input").current();
        let patch = input.patch::<f64>();
        let Some(hit) = patch.intersect(&input.ray()) else {
            continue;
        };
        tried += 1;
        let t = newton_from_the_middle(patch.surface(), &input.ray());
        lost += u32::from(t.is_none_or(|t| (t - hit.t).abs() > 1e-9 * hit.t));
    }
    println!("{lost} of {tried} lost");
    assert!(tried >= 390 && 10 * lost >= tried, "{lost} of {tried} lost");
}

/// **Silhouettes.** A ray that passes at a height $\delta$ below the top of the dome $z=-(x^2+y^2)$ meets it twice, at $x=\pm\sqrt\delta$; above the top never. Both roots are found down to
/// $\delta=10^{-10}$, where they are a hundred-thousandth of the dome apart. The tangent ray itself may be hit or not: it is decided, and not a question of time.
#[test]
fn both_roots_next_to_a_silhouette_are_found() {
    let dome = dome();
    let at = |height: f64| Ray::new([-3.0, 0.0, height], [1.0, 0.0, 0.0]);
    for exponent in 1..=10 {
        let delta = 10.0_f64.powi(-exponent);
        let hits = all_hits(&dome, at(-delta));
        let found: Vec<f64> = hits.iter().map(|hit| hit.t).collect();
        let exact = [3.0 - delta.sqrt(), 3.0 + delta.sqrt()];
        assert_eq!(found.len(), 2, "at {delta}: {found:?}");
        for (hit, exact) in hits.iter().zip(exact) {
            assert!(
                (hit.t - exact).abs() <= hit.t_error,
                "{} for {exact}",
                hit.t
            );
        }
        assert_eq!([hits[0].side, hits[1].side], [Side::Front, Side::Back]);
        assert_eq!(all_hits(&dome, at(delta)).len(), 0);
    }
    let started = Instant::now();
    for ulps in -40..=40 {
        let hits = all_hits(&dome, at(f64::from(ulps) * f64::EPSILON));
        assert!(hits.len() <= 2 && hits.iter().all(|hit| (hit.t - 3.0).abs() <= 1e-6));
    }
    assert!(
        started.elapsed() < Duration::from_secs(5),
        "a tangent ray takes too long"
    );
}

/// **Poles.** Where a side of the patch is one point, $S_u$ vanishes: the two equations have a whole line of roots, and Newton's method divides by 0. Rays through the pole from all directions above meet it, at its $t$; so do those that pass
/// it by less and less.
#[test]
fn pole_of_a_patch_is_hit() {
    // A quarter of a cap: the side v = 1 is the pole (0, 0, 1).
    let row = |r: f64, z: f64| [[r, 0.0, z], [r, r, z], [0.0, r, z]];
    let cap = patch(
        [2, 2],
        [row(1.0, 0.0), row(1.0, 1.0), row(0.0, 1.0)].concat(),
    );
    for k in 0..200 {
        let [x, y] = [
            f64::from(k % 20) / 10.0 - 0.95,
            f64::from(k / 20) / 5.0 - 0.9,
        ];
        let direction = [x, y, -1.0];
        let from = |target: Point| Ray::new(target.minus(direction.times(4.0)), direction);
        let hit = cap
            .intersect(&from([0.0, 0.0, 1.0]))
            .expect("the pole is met");
        assert!(
            (hit.t - 4.0).abs() <= hit.t_error.max(1e-14) && hit.t_error < 1e-12,
            "{hit:?}"
        );
        assert!(
            hit.normal[2] > 0.999,
            "the limit of the normal: {:?}",
            hit.normal
        );
        for exponent in [-4, -20, -40, -50] {
            let near = 2.0_f64.powi(exponent);
            let hit = cap.intersect(&from([near, near, 1.0 - near * near]));
            assert!(
                hit.is_some_and(|hit| (hit.t - 4.0).abs() <= 4.0 * near),
                "{near} from the pole"
            );
        }
    }
}

/// **Edge-on.** A flat patch is not met by a ray in its plane, as a triangle is not; however its control points are spread in the plane. A ray one part in $10^{9}$ out of the plane meets it where the plane says.
#[test]
fn flat_patch_is_not_met_edge_on() {
    let spread = [
        [0., 0.],
        [1., 0.5],
        [2., -0.5],
        [3., 0.],
        [0.5, 1.],
        [1., 1.],
        [2.5, 1.2],
        [3., 1.],
        [0., 2.],
        [1., 3.],
        [2., 2.],
        [3., 2.],
    ];
    let flat = |z: &dyn Fn(f64, f64) -> f64| {
        let points = spread.map(|[x, y]| [x, y, z(x, y)]).to_vec();
        patch([3, 2], points)
    };
    let level = flat(&|_, _| 0.0);
    for [x, y] in [[1.0, 0.0], [1.0, 0.3], [0.2, -1.0], [0.0, 1.0]] {
        assert!(
            level
                .intersect(&Ray::new([1.5 - 9.0 * x, 1.0 - 9.0 * y, 0.0], [x, y, 0.0]))
                .is_none()
        );
        let slope = 1e-9;
        let ray = Ray::new([1.5 - 9.0 * x, 1.0 - 9.0 * y, 9.0 * slope], [x, y, -slope]);
        let hit = level.intersect(&ray).expect("it comes down in the middle");
        assert!(
            (hit.t - 9.0).abs() <= hit.t_error && hit.t_error <= 1e-3,
            "{hit:?}"
        );
    }
    let oblique = flat(&|x, y| 0.5 * x - 0.25 * y);
    let hit = oblique
        .intersect(&Ray::new([1.5, 1.0, 5.0], [0.0, 0.0, -1.0]))
        .expect("from above");
    assert!(
        (hit.t - 4.5).abs() <= hit.t_error && hit.t_error <= 1e-13,
        "{hit:?}"
    );
}

/// **Along a ruling.** A ray that runs in the surface, along a straight line of a cylinder, is edge-on, too; next to it the cylinder is met or missed as it should, and a ray across meets it twice.
#[test]
fn ray_along_a_ruling_is_decided() {
    let arch = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];
    let points = [0.0, 1.0].map(|y| arch.map(|[x, z]| [x, y, z])).concat();
    let cylinder: PatchIntersector<Point> = patch([2, 1], points);
    assert!(
        cylinder
            .intersect(&Ray::new([1.0, -3.0, 1.0], [0.0, 1.0, 0.0]))
            .is_none()
    );
    assert!(
        cylinder
            .intersect(&Ray::new([1.0, -3.0, 1.0 + 1e-9], [0.0, 1.0, 0.0]))
            .is_none()
    );
    let steep = Ray::new([1.0, -3.0, 1.0 - 1e-9], [0.0, 1.0, 1e-9 / 3.5]);
    let hit = cylinder.intersect(&steep).expect("steep enough");
    // The height and the slope as they are stored are off by a roundoff of 1, which this slope makes 3.5e9 times as much along the ray.
    let inherited = 3.5e9 * f64::EPSILON;
    assert!((hit.t - 3.5).abs() <= hit.t_error + inherited, "{hit:?}");
    assert_eq!(
        all_hits(&cylinder, Ray::new([-1.0, 0.5, 0.5], [1.0, 0.0, 0.0])).len(),
        2
    );
}

/// **A patch that crosses itself.** A sheet bent back through itself is met three times by a ray, in order; on the line where it crosses itself two of the roots coincide in space, and differ in $(u,v)$.
#[test]
fn sheets_of_a_patch_that_crosses_itself_are_all_found() {
    let loop_of = [[0.0, 0.0], [6.0, 4.0], [-4.0, 4.0], [2.0, 0.0]]; // x(u), z(u): a cubic with a loop
    let points = [0.0, 1.0].map(|y| loop_of.map(|[x, z]| [x, y, z])).concat();
    let sheet = patch([3, 1], points);
    let down = |x: f64| Ray::new([x, 0.5, 9.0], [0.0, 0.0, -1.0]);
    let hits = all_hits(&sheet, down(1.25));
    assert_eq!(hits.len(), 3);
    assert!(hits.windows(2).all(|pair| pair[0].t < pair[1].t));
    // By symmetry about x = 1 the curve crosses itself there, once above with u and 1 − u: x = 1 has the roots 1/2 and (1 ± 1/√5)/2 … in the loop.
    let at_the_crossing = all_hits(&sheet, down(1.0));
    assert!(
        (2..=3).contains(&at_the_crossing.len()),
        "{at_the_crossing:?}"
    );
    // Sideways through the crossing both sheets are met at the same t, and passed.
    let crossing = at_the_crossing.last().expect("found above").point;
    let through = Ray::new([crossing[0] - 5.0, 0.5, crossing[2]], [1.0, 0.0, 0.0]);
    let hit = sheet.intersect(&through).expect("the crossing is met");
    assert!((hit.t - 5.0).abs() <= 1e-12);
}

/// **Collapsed onto a curve.** If every point $S(u,v)$ depends on $u+v$ alone the patch has no area; a ray through it has a curve of roots in the parameters. The search is bounded, and the answer no panic.
#[test]
fn patch_without_area_ends_the_search() {
    // c(s) with s = u + v, of degree 2 in s, in biquadratic form: blossoms of (u1 + v1)(u2 + v2).
    let c = |s: f64, s2: f64| [s, s2, 0.25 * s];
    let points = (0..9).map(|k| {
        let [i, j] = [f64::from(k % 3) / 2.0, f64::from(k / 3) / 2.0];
        let square = |k: f64| if k > 0.75 { 1.0 } else { 0.0 };
        c(i + j, square(i) + 2.0 * i * j + square(j))
    });
    let collapsed = patch([2, 2], points.collect());
    let target = collapsed.surface();
    let target = facette::surface::Surface::point(target, 0.3, 0.4);
    let started = Instant::now();
    let _ = collapsed.intersect(&Ray::new(target.plus([0.0, 0.0, 3.0]), [0.0, 0.0, -1.0]));
    assert!(started.elapsed() < Duration::from_secs(5));
}

/// **From $2^{-100}$ to $2^{100}$.** Scaling patch and ray by a power of two leaves $t$ as it is, bit for bit; scaling the direction divides it.
#[test]
fn patch_and_ray_scale_together() {
    let points: Vec<Point> = dome().surface().control_points().to_vec();
    let ray = Ray::new([0.1, 0.2, 3.0], [0.1, -0.05, -1.0]);
    let hit = patch([2, 2], points.clone())
        .intersect(&ray)
        .expect("from above");
    for exponent in [-100, -10, 10, 100] {
        let scale = 2.0_f64.powi(exponent);
        let scaled = points.iter().map(|p| p.times(scale)).collect();
        let scaled = patch([2, 2], scaled);
        let large = Ray::new(ray.origin.times(scale), ray.direction.times(scale));
        let other = scaled.intersect(&large).expect("the same ray");
        assert_eq!(
            (other.t, other.t_error, other.parameters),
            (hit.t, hit.t_error, hit.parameters)
        );
        let faster = Ray::new(ray.origin, ray.direction.times(scale));
        let faster = patch([2, 2], points.clone())
            .intersect(&faster)
            .expect("the same ray");
        assert_eq!(faster.t * scale, hit.t);
    }
}

/// **From afar.** A metre-sized patch at $10^7$, seen from $10^7$ away: $t$ carries the rounding of the distance, a few units in the last place, and the point lies on the patch as well as its own coordinates can say.
#[test]
fn far_patch_keeps_its_point() {
    let far = [1e7, -1e7, 1e7];
    let points: Vec<Point> = dome()
        .surface()
        .control_points()
        .iter()
        .map(|p| p.plus(far))
        .collect();
    let patch = patch([2, 2], points);
    let target = far.plus([0.25, -0.5, -0.3125]);
    let direction = [0.3, 0.2, -1.0];
    let hit = patch
        .intersect(&Ray::new(target.minus(direction.times(1e7)), direction))
        .expect("it is aimed at the patch");
    let off = hit.point.minus(target).largest_coordinate();
    assert!((hit.t - 1e7).abs() <= 1e-7 && off <= 1e-7, "{hit:?}");
    let height = hit.point.minus(far);
    let above = height[2] + height[0] * height[0] + height[1] * height[1];
    assert!(
        above.abs() <= 4.0 * hit.point_error && hit.point_error <= 4e-8,
        "{above}"
    );
}

/// **Not a number.** Rays with NaN, infinity or no direction meet nothing; patches with them, with a degree of 0 or too few points are refused.
#[test]
fn unusable_rays_and_patches_are_refused() {
    let dome = dome();
    let good = Ray::new([0.0, 0.0, 3.0], [0.0, 0.0, -1.0]);
    assert!(dome.is_hit_by(&good) && !dome.is_hit_by(&good.until(1.0)));
    for bad in [f64::NAN, f64::INFINITY] {
        for axis in 0..3 {
            let mut ray = good;
            ray.origin[axis] = bad;
            assert!(!dome.is_hit_by(&ray));
            let mut ray = good;
            ray.direction[axis] = bad;
            assert!(!dome.is_hit_by(&ray));
        }
    }
    assert!(!dome.is_hit_by(&Ray::new(good.origin, [0.0; 3])));
    assert!(!dome.is_hit_by(&good.after(f64::NAN)) && !dome.is_hit_by(&good.until(f64::NAN)));
    let made = |degrees, control_points| {
        PatchIntersector::<Point>::new(bspline::BezierPatch {
            domain: [[0.0, 1.0]; 2],
            degrees,
            control_points,
        })
    };
    let line = vec![[0.0; 3], [1.0, 0.0, 0.0]];
    assert_eq!(
        made([1, 0], line.clone()).err(),
        Some(PatchError::NoArea { degrees: [1, 0] })
    );
    assert!(matches!(
        made([1, 1], line),
        Err(PatchError::Patch(BsplineError::WrongNetSize { .. }))
    ));
    let nan = vec![[f64::NAN; 3]; 4];
    assert!(matches!(
        made([1, 1], nan),
        Err(PatchError::Patch(BsplineError::PointNotFinite { .. }))
    ));
}
