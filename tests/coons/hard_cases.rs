//! Inputs that break the textbook formulas of this chapter, what survives them, and both shown.

use facette::algebra::{Scalar, Vector3, VectorSpace, unit_vector};
use facette::coons::{
    Boundary, CoonsError, CoonsPatch, Corner, FergusonPatch, bicubic_partials, bicubic_point,
    bilinear_point,
};
use facette::curve::{BezierCurve, BoxedCurve, Curve, FunctionCurve};
use facette::surface::Surface;
use glam::{DVec3, Vec3};
use num_traits::Zero;

use crate::common::exact::{Exact, fraction};
use crate::common::oracle::{big, big_point, largest_error};
use crate::inputs::{bezier, hermite_boundary, surface_point};
use crate::variants::{direct_point, fused_point, short_lerp_point};

fn line(start: [f64; 3], end: [f64; 3]) -> BezierCurve<[f64; 3]> {
    bezier(&[start, end])
}

fn arch(start: [f64; 3], end: [f64; 3], height: f64) -> BezierCurve<[f64; 3]> {
    let [x, y, z] = start.lerp(end, 0.5);
    bezier(&[start, [x, y, z + height], end])
}

/// Two arches and two lines over a square with a corner at `origin`.
fn vault(origin: [f64; 3], side: f64) -> Boundary<BezierCurve<[f64; 3]>> {
    let at = |x: f64, y: f64| origin.plus([x * side, y * side, 0.0]);
    let [a, b, c, d] = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
    let boundary = Boundary::new(
        arch(a, b, side),
        arch(d, c, side / 2.0),
        line(a, d),
        line(b, c),
    );
    boundary.expect("the curves share their ends")
}

/// **Ends that meet up to an ulp.** Curves that are evaluated on their own seldom agree in the last bit: $\cos$ and $\sin$ of the same
/// angle, computed as $\cos\frac\pi2$ and as $0$, leave a gap of $6\cdot10^{-17}$. A boundary accepts gaps of 64 unit roundoffs of the largest
/// corner coordinate. The corners come from $P_1$ and $P_2$ alone, so that $Q_1$ and $Q_2$ are met exactly and $P_1$, $P_2$ up to the gap.
#[test]
fn ends_that_meet_up_to_an_ulp_are_accepted() {
    use std::f64::consts::FRAC_PI_2;
    let arc: BoxedCurve<[f64; 3]> = Box::new(FunctionCurve::new(|t: f64| {
        [(FRAC_PI_2 * t).cos(), (FRAC_PI_2 * t).sin(), 0.0]
    }));
    let straight = |start, end| -> BoxedCurve<[f64; 3]> { Box::new(line(start, end)) };
    let [b, c, d] = [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]];
    let gap = arc.point(1.0)[0];
    assert!(gap > 0.0, "the cosine of a rounded right angle is not 0");
    let boundary = Boundary::new(
        arc,
        straight(d, c),
        straight([1.0, 0.0, 0.0], d),
        straight(b, c),
    )
    .expect("a gap of less than an ulp of 1 is rounding");
    assert_eq!(boundary.corners().b[0], gap);
    for t in [0.0, 0.25, 0.7, 1.0] {
        assert_eq!(bilinear_point(&boundary, 1.0, t), boundary.q2().point(t));
        let miss = bilinear_point(&boundary, t, 0.0).minus(boundary.p1().point(t));
        assert!(
            miss.largest_coordinate() <= gap,
            "at u = {t} the edge is missed by {miss:?}"
        );
    }
}

/// **Ends that meet at a far offset.** At $10^8$ one ulp is $1.5\cdot10^{-8}$: a tolerance that is fixed in metres refuses what rounding alone
/// has parted. Ours grows with the coordinates: a gap of one ulp is accepted at $10^8$, and the same gap refused at 1.
#[test]
fn tolerance_grows_with_the_offset() {
    let boundary_at = |offset: f64, gap: f64| {
        let at = |x: f64, y: f64| [offset + x, y, 0.0];
        let parted = [offset + gap, 0.0, 0.0];
        let [b, c, d] = [at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        Boundary::new(
            line(at(0.0, 0.0), b),
            line(d, c),
            line(parted, d),
            line(b, c),
        )
    };
    let ulp_at_1e8 = 2.0_f64.powi(-26);
    assert_ne!(1e8 + ulp_at_1e8, 1e8);
    assert!(boundary_at(1e8, ulp_at_1e8).is_ok());
    let refused = boundary_at(0.0, ulp_at_1e8).expect_err("a gap of 1.5e-8 between unit lengths");
    assert_eq!(
        refused.to_string(),
        "at corner A, P1(0) = [0.0, 0.0, 0.0] and Q1(0) = [1.4901161193847656e-8, 0.0, 0.0] must agree, but are \
         1.4901161193847656e-8 apart, where the tolerance is 7.105427357601002e-15"
    );
}

/// **The tolerance is what it says.** A gap of exactly the tolerance is accepted, the next larger one refused; a tolerance of zero accepts
/// equal ends only; a negative one and NaN accept nothing.
#[test]
fn given_tolerance_is_kept_to_the_bit() {
    let curves = |gap: f64| {
        let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        [line(a, b), line(d, c), line(a, d), line([1.0, gap, 0.0], c)]
    };
    let accepts = |gap, tolerance| Boundary::with_tolerance(curves(gap), tolerance).is_ok();
    assert!(accepts(1e-3, 1e-3));
    assert!(!accepts(1e-3_f64.next_up(), 1e-3));
    assert!(accepts(0.0, 0.0));
    assert!(!accepts(f64::from_bits(1), 0.0));
    assert!(!accepts(0.0, -1e-300));
    assert!(!accepts(0.0, f64::NAN));
}

/// A line that takes seven units of the parameter.
#[derive(Clone)]
struct Longer(BezierCurve<[f64; 3]>);
impl Curve for Longer {
    type Scalar = f64;
    type Point = [f64; 3];

    fn domain(&self) -> [f64; 2] {
        [0.0, 7.0]
    }

    fn point(&self, t: f64) -> [f64; 3] {
        self.0.point(t / 7.0)
    }

    fn derivative(&self, _: f64) -> Option<[f64; 3]> {
        None
    }
}

/// **What is not finite is refused, and what is not over $[0,1]$.** A curve that ends at infinity or nowhere bounds nothing; the message names the
/// end.
#[test]
fn boundaries_of_unusable_curves_are_refused() {
    let bad: BoxedCurve<[f64; 3]> =
        Box::new(FunctionCurve::new(|t: f64| [1.0 / (1.0 - t), 0., 0.]));
    let straight = |start, end| -> BoxedCurve<[f64; 3]> { Box::new(line(start, end)) };
    let [a, b, c, d] = [[1., 0., 0.], [2., 0., 0.], [2., 1., 0.], [1., 1., 0.]];
    let refused = Boundary::new(bad, straight(d, c), straight(a, d), straight(b, c));
    let message = refused
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default();
    assert_eq!(
        message,
        "P1(1) is [inf, 0.0, 0.0]: every coordinate must be finite"
    );

    let longer = [(a, b), (d, c), (a, d), (b, c)].map(|(start, end)| Longer(line(start, end)));
    let [p1, p2, q1, q2] = longer;
    let refused = Boundary::new(p1, p2, q1, q2)
        .err()
        .map(|error| error.to_string());
    let expected = "the curve P1 runs over [0.0, 7.0], where a patch needs [0, 1]";
    assert_eq!(refused.as_deref(), Some(expected));
}

/// **A lerp that misses its end.** $a+t(b-a)$ is one multiplication shorter than $(1-t)a+tb$, and at $t=1$ it gives $a+(b-a)$, which is not $b$
/// when the difference is rounded. Between an arch that is $2^{59}$ high and one of height $\tfrac12$ the short form loses the low arch altogether; with the longer
/// form the patch carries both.
#[test]
fn short_lerp_loses_the_lower_arch() {
    let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let [high, low] = [arch(a, b, 2.0_f64.powi(60)), arch(d, c, 1.0)];
    let boundary = Boundary::new(high, low, line(a, d), line(b, c)).expect("the ends are shared");
    assert_eq!(boundary.p2().point(0.5), [0.5, 1.0, 0.5]);
    assert_eq!(short_lerp_point(&boundary, 0.5, 1.0), [0.5, 1.0, 0.0]);
    assert_eq!(bilinear_point(&boundary, 0.5, 1.0), [0.5, 1.0, 0.5]);
}

/// **Sums that miss the edge.** Added from the left, $S_1+S_2-S_3$ rounds twice, and the fused form
/// $S_2+(1-v)\bigl(P_1-\overline{AB}\bigr)+v\bigl(P_2-\overline{DC}\bigr)$ rounds its differences: both miss the edge curve at some parameter, and a
/// neighbour on the same curve shows a crack. The compensated sum meets all four edges at every parameter tried.
#[test]
fn plain_sums_miss_the_edge() {
    let boundary = vault([0.1, 0.2, -0.3], 0.7);
    let parameters = (0..=64)
        .map(|index| f64::from(index) / 64.0)
        .collect::<Vec<_>>();
    let misses = |sum: &dyn Fn(f64, f64) -> [f64; 3]| {
        let edges = |&t: &f64| {
            let [p1, p2] = [boundary.p1().point(t), boundary.p2().point(t)];
            let [q1, q2] = [boundary.q1().point(t), boundary.q2().point(t)];
            let sums = [sum(t, 0.0), sum(t, 1.0), sum(0.0, t), sum(1.0, t)];
            [p1, p2, q1, q2]
                .into_iter()
                .zip(sums)
                .filter(|(curve, sum)| curve != sum)
                .count()
        };
        parameters.iter().map(edges).sum::<usize>()
    };
    assert!(misses(&|u, v| direct_point(&boundary, u, v)) > 0);
    assert!(misses(&|u, v| fused_point(&boundary, u, v)) > 0);
    assert_eq!(misses(&|u, v| bilinear_point(&boundary, u, v)), 0);
}

/// **A side collapsed to a point.** A triangle is a patch with $A=B$ and a constant $P_1$. There $S_u=0$, and $S_u\times S_v$ has no direction; but just inside
/// $S_u\approx v\,S_{uv}$, so the normal tends to the direction of $S_{uv}\times S_v$ (l'Hôpital's rule). The test compares that limit with the normals
/// on the way to it: the difference shrinks with the distance, until rounding takes over.
#[test]
fn normal_at_a_collapsed_side_is_the_limit() {
    for [v, sign] in [[0.0, 1.0], [1.0, -1.0]] {
        let apex = [0.5, 0.0, 0.3];
        let rim = arch([0.0, 1.0, 0.0], [1.0, 1.0, 0.2], 0.6);
        let point: BezierCurve<_> = bezier(&[apex; 3]);
        let sides = [rim.point(0.0), rim.point(1.0)].map(|end| arch(apex, end, 0.2));
        let [q1, q2] = sides.map(|side| if v == 0.0 { side } else { reversed(&side) });
        let [p1, p2] = if v == 0.0 { [point, rim] } else { [rim, point] };
        let patch = CoonsPatch::new(Boundary::new(p1, p2, q1, q2).expect("the sides meet"));
        let u = 0.3;
        let [s_u, s_v] = patch
            .partials(u, v)
            .expect("Bézier curves have derivatives");
        assert_eq!(s_u, [0.0; 3], "the side is a point");
        let normal = |v: f64| patch.normal_vector(u, v).and_then(unit_vector);
        let limit = normal(v).expect("the normal has a limit");
        // Unit normal: 5u; its coordinates times those of S_v, at most 3, and two sums.
        let bound = 3.0 * 3.0 * 8.0 * f64::EPSILON / 2.0;
        assert!(limit.dot(s_v).abs() <= bound, "the limit is normal to S_v");
        for halvings in 1..=26 {
            let distance = 0.5_f64.powi(halvings);
            let near = normal(v + sign * distance).expect("inside it is regular");
            let away = near.minus(limit).largest_coordinate();
            // The normal turns with the distance; S_u is as small as that, with roundoffs of coordinates near 1.
            let bound = 2.0 * distance + 32.0 * f64::EPSILON / distance;
            assert!(away <= bound, "{away} away at a distance of {distance}");
        }
    }
}

fn reversed(curve: &BezierCurve<[f64; 3]>) -> BezierCurve<[f64; 3]> {
    bezier(
        &curve
            .control_points()
            .iter()
            .rev()
            .copied()
            .collect::<Vec<_>>(),
    )
}

/// **A collapsed side in v.** The same for $A=D$ and a constant $Q_1$, and for $B=C$: the normal is that of $S_u\times S_{uv}$, seen from inside.
#[test]
fn normal_at_a_side_collapsed_in_v_points_the_same_way() {
    let apex = [0.0, 0.5, 0.0];
    let [b, c] = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    let boundary = Boundary::new(line(apex, b), line(apex, c), line(apex, apex), line(b, c));
    let patch = CoonsPatch::new(boundary.expect("the sides meet"));
    let mirrored = Boundary::new(line(c, apex), line(b, apex), line(c, b), line(apex, apex));
    let mirror = CoonsPatch::new(mirrored.expect("the sides meet"));
    for (patch, u) in [(&patch, 0.0), (&mirror, 1.0)] {
        for v in [0.0, 0.4, 1.0] {
            let normal = patch.normal_vector(u, v).and_then(unit_vector);
            let inside = patch.normal_vector(0.5, v).and_then(unit_vector);
            assert_eq!(normal, inside, "at u = {u}, v = {v}");
            assert_eq!(normal, Some([0.0, 0.0, 1.0]));
        }
    }
}

/// **Coincident curves.** If $P_1=P_2$ and the other two curves are points, the patch is a curve: it has points but no normal anywhere, and says so
/// instead of making one up from rounding errors. The same holds where the two tangents are parallel.
#[test]
fn patch_without_area_has_no_normal() {
    let spine = || arch([0.1, 0.2, 0.3], [0.7, 0.4, 0.9], 0.5);
    let ends = [spine().point(0.0), spine().point(1.0)].map(|end| line(end, end));
    let [q1, q2] = ends;
    let boundary = Boundary::new(spine(), spine(), q1, q2).expect("the ends are shared");
    let patch = CoonsPatch::new(boundary);
    for [u, v] in [[0.3, 0.6], [0.0, 0.5], [0.5, 0.0], [1.0, 1.0]] {
        assert_eq!(patch.normal_vector(u, v), None, "at ({u}, {v})");
        let off = patch
            .point(u, v)
            .minus(spine().point(u))
            .largest_coordinate();
        assert!(
            off <= f64::EPSILON,
            "{off} away from the spine at ({u}, {v})"
        );
    }
    let flat = |x: f64| line([0.0, 0.0, 0.0], [x, 2.0 * x, 0.1 * x]);
    let edge = || line([1.0, 2.0, 0.1], [1.0, 2.0, 0.1]);
    let collinear = Boundary::new(flat(1.0), edge(), flat(1.0), edge()).expect("all in one line");
    assert_eq!(CoonsPatch::new(collinear).normal_vector(0.3, 0.4), None);
}

/// **Parameters outside.** A patch goes on beyond $[0,1]^2$ by the same formula, without a jump: one ulp outside an edge it is within the rounding of the
/// edge point. Whoever wants another convention clamps the parameters.
#[test]
fn parameters_just_outside_extrapolate() {
    let boundary = vault([0.0; 3], 1.0);
    let edge = bilinear_point(&boundary, 0.5, 0.0);
    for outside in [-f64::EPSILON, -f64::from_bits(1)] {
        let near = bilinear_point(&boundary, 0.5, outside)
            .minus(edge)
            .largest_coordinate();
        assert!(near <= 4.0 * f64::EPSILON, "{near} away for v = {outside}");
    }
    assert_eq!(bilinear_point(&boundary, 0.5, 2.0), [0.5, 2.0, 0.0]);
    assert_eq!(bilinear_point(&boundary, 0.5, -1.0), [0.5, -1.0, 0.75]);
}

/// **Not a number.** NaN in gives NaN out, in every coordinate that depends on it, for points, derivatives and grids; nothing hangs, nothing panics, and no normal
/// is claimed.
#[test]
fn not_a_number_in_not_a_number_out() {
    let patch = CoonsPatch::new(vault([0.0; 3], 1.0));
    for [u, v] in [[f64::NAN, 0.5], [0.5, f64::NAN], [f64::NAN; 2]] {
        assert!(
            patch
                .point(u, v)
                .iter()
                .all(|coordinate| coordinate.is_nan()),
            "({u}, {v})"
        );
        assert_eq!(patch.normal_vector(u, v), None, "({u}, {v})");
        let mut row = [[0.0; 3]];
        patch.points_on_grid(&[u], &[v], &mut row);
        assert!(
            row[0].iter().all(|coordinate| coordinate.is_nan()),
            "({u}, {v})"
        );
    }
}

/// **From $10^{-300}$ to $10^{300}$.** Scaling the boundary by a power of two scales the patch by it to the last bit, and leaves the unit normal as it is: products of
/// tangents neither overflow nor vanish, since each is scaled first.
#[test]
fn patch_scales_with_its_boundary() {
    let patch = CoonsPatch::new(vault([0.1, 0.2, 0.3], 1.5));
    for exponent in [-990, -100, 100, 990] {
        let scale = 2.0_f64.powi(exponent);
        let boundary = patch.boundary();
        let scaled = |curve: &BezierCurve<[f64; 3]>| {
            bezier(
                &curve
                    .control_points()
                    .iter()
                    .map(|p| p.times(scale))
                    .collect::<Vec<_>>(),
            )
        };
        let [p1, p2] = [scaled(boundary.p1()), scaled(boundary.p2())];
        let [q1, q2] = [scaled(boundary.q1()), scaled(boundary.q2())];
        let large = CoonsPatch::new(Boundary::new(p1, p2, q1, q2).expect("the ends are shared"));
        for [u, v] in [[0.3, 0.8], [0.0, 0.5], [1.0, 0.1]] {
            assert_eq!(large.point(u, v), patch.point(u, v).times(scale));
            let normals = [&large, &patch].map(|s| s.normal_vector(u, v).and_then(unit_vector));
            assert_eq!(normals[0], normals[1], "at 2^{exponent}");
            assert!(normals[0].is_some());
        }
    }
}

/// **Far from the origin.** At an offset of $10^8$ a metre-sized patch keeps a fixed absolute error, a few units in the last place of $10^8$: `f64` still tells $10^{-7}$
/// apart, while `f32` has steps of 8 there and nothing of the shape is left. Translate first.
#[test]
fn far_patch_loses_its_shape_in_single_precision() {
    let offset = 1e8;
    let near = vault([0.0; 3], 1.0);
    let far = vault([offset, 0.0, 0.0], 1.0);
    let shape = bilinear_point(&near, 0.3, 0.4)[0];
    let shifted = [big(offset) + big(shape)];
    let unit = f64::EPSILON / 2.0 * offset;
    let far_x = bilinear_point(&far, 0.3, 0.4)[0];
    assert!(largest_error([far_x], &shifted, unit) <= 16.0, "{far_x}");

    let single = |boundary: &Boundary<BezierCurve<[f64; 3]>>, u: f32, v: f32| {
        let [p1, p2, q1, q2] =
            [boundary.p1(), boundary.p2(), boundary.q1(), boundary.q2()].map(|c| {
                let points = c.control_points().iter().map(|&p| DVec3::from(p).as_vec3());
                bezier::<Vec3>(&points.collect::<Vec<_>>())
            });
        let boundary = Boundary::new(p1, p2, q1, q2).expect("rounded alike");
        bilinear_point(&boundary, u, v)
    };
    assert_eq!(
        single(&far, 0.3, 0.4).x % 8.0,
        0.0,
        "the numbers there are multiples of 8"
    );
    assert!((single(&near, 0.3, 0.4).x - 0.3).abs() <= 16.0 * f32::EPSILON);
}

/// **Single against double precision.** The same patch in `f32` and `f64` differs by the rounding of `f32` alone: 16 unit roundoffs of the largest coordinate, plus the rounding
/// of the control points.
#[test]
fn single_precision_stays_within_its_rounding_of_double() {
    let boundary = vault([0.1, -0.3, 0.2], 1.0);
    let to_single = |curve: &BezierCurve<[f64; 3]>| {
        let round = |x: f64| DVec3::splat(x).as_vec3().x;
        bezier(
            &curve
                .control_points()
                .iter()
                .map(|p| p.map(round))
                .collect::<Vec<_>>(),
        )
    };
    let [p1, p2] = [to_single(boundary.p1()), to_single(boundary.p2())];
    let [q1, q2] = [to_single(boundary.q1()), to_single(boundary.q2())];
    let single = Boundary::new(p1, p2, q1, q2).expect("rounded alike");
    let half_ulp = f64::from(f32::EPSILON) / 2.0;
    // Largest coordinate 1.4; curve points carry 2 · 3 roundoffs, control points one, and up to three of them add.
    let bound = (16.0 + 3.0 * 7.0) * half_ulp * 1.4;
    for index in 0..=16_u8 {
        let [u, v] = [f32::from(index) / 16.0, f32::from(16 - index) / 32.0];
        let exact = big_point(bilinear_point(&boundary, u.into(), v.into()));
        let error = largest_error(bilinear_point(&single, u, v).map(f64::from), &exact, bound);
        assert!(error <= 1.0, "{error} bounds away at ({u}, {v})");
    }
}

/// **Quintic edges and slopes.** The bicubically blended patch of a biquintic surface is not that surface, but carries its edges and its derivatives across
/// them, of degree 5, exactly.
#[test]
fn quintic_edges_and_slopes_are_kept() {
    let height =
        |i: i32, j: i32| fraction(i.pow(4) * (j - 1).pow(4) + (i * i - 3 * j) * (j - 2), 90);
    let row = |i: i32| {
        (0..6)
            .map(|j| [fraction(i, 5), fraction(j, 5), height(i, j)])
            .collect()
    };
    let net: Vec<Vec<_>> = (0..6).map(row).collect();
    let data = hermite_boundary(&net);
    let [zero, one, t] = [fraction(0, 1), fraction(1, 1), fraction(2, 7)];
    for (end, edges) in [
        (zero, [data.boundary().p1(), data.p1_v()]),
        (one, [data.boundary().p2(), data.p2_v()]),
    ] {
        assert_eq!(bicubic_point(&data, t, end), edges[0].point(t));
        let partials = bicubic_partials(&data, t, end);
        assert_eq!(
            partials,
            edges[0].derivative(t).map(|s_u| [s_u, edges[1].point(t)])
        );
    }
    assert_ne!(bicubic_point(&data, t, t), surface_point(&net, t, t));
}

/// **Cross derivatives without a derivative.** Twists are read off the cross derivatives; a closure that does not know its own derivative cannot give them, and the error
/// names it.
#[test]
fn unknown_derivative_is_named() {
    use facette::coons::{CrossDerivatives, HermiteBoundary};
    let unknown = |value: [f64; 3]| -> BoxedCurve<[f64; 3]> {
        Box::new(FunctionCurve::new(move |_: f64| value))
    };
    let straight = |start, end| -> BoxedCurve<[f64; 3]> { Box::new(line(start, end)) };
    let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let boundary = Boundary::new(
        straight(a, b),
        straight(d, c),
        straight(a, d),
        straight(b, c),
    );
    let [along_u, along_v] = [[1., 0., 0.], [0., 1., 0.]];
    let cross = CrossDerivatives {
        p1_v: straight(along_v, along_v),
        p2_v: unknown(along_v),
        q1_u: straight(along_u, along_u),
        q2_u: straight(along_u, along_u),
    };
    let refused = HermiteBoundary::gregory(boundary.expect("a square"), cross);
    let message = refused
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default();
    let expected = "the derivative of p2_v is not known at 0.0, but smooth blending needs it";
    assert_eq!(message, expected);
}

/// **Gregory's corner.** At the corner the blended twist is $0/0$, but its weight is zero: the patch has its corner point and its two tangents there, no NaN, and next
/// to the corner the values close up on them.
#[test]
fn gregory_patch_is_continuous_at_its_corners() {
    let data = crate::bicubic_theorems::incompatible_example();
    let corner = bicubic_point(&data, 0.0, 0.0);
    assert_eq!(corner, data.boundary().corners().a);
    let tangents = bicubic_partials(&data, 0.0, 0.0).expect("Bézier curves have derivatives");
    assert_eq!(tangents, [data.q1_u().point(0.0), data.p1_v().point(0.0)]);
    for exponent in [-30, -60, -1000] {
        let tiny = 2.0_f64.powi(exponent);
        for [u, v] in [[tiny, tiny], [tiny, 0.0], [0.0, tiny], [tiny, tiny / 8.0]] {
            let near = bicubic_partials(&data, u, v).expect("Bézier curves have derivatives");
            for (near, tangent) in near.into_iter().zip(tangents) {
                let distance = near.minus(tangent).largest_coordinate();
                assert!(
                    distance <= 64.0 * tiny.max(f64::EPSILON),
                    "{distance} at ({u}, {v})"
                );
            }
        }
    }
}

/// **Numbers that are none.** The Ferguson patch refuses vectors that are not finite.
#[test]
fn ferguson_patch_refuses_what_is_not_finite() {
    let mut vectors = [[[0.0; 3]; 4]; 4];
    vectors[2][1][0] = f64::NAN;
    let refused = FergusonPatch::new(vectors);
    assert!(matches!(
        refused,
        Err(CoonsError::NotFinite {
            what: "a corner vector",
            ..
        })
    ));
}

/// **Exact corners.** Over a field the default tolerance is zero: the smallest gap is refused, with its corner.
#[test]
fn exact_boundaries_have_no_tolerance() {
    let [zero, one] = [Exact::zero(), Exact::from_i32(1)];
    let at = |x, y| [x, y, zero];
    let edge = |start, end| bezier::<[Exact; 3]>(&[start, end]);
    let [a, b, c, d] = [at(zero, zero), at(one, zero), at(one, one), at(zero, one)];
    let nearly = at(fraction(1, i32::MAX), one);
    let refused = Boundary::new(edge(a, b), edge(d, c), edge(a, nearly), edge(b, c));
    assert!(matches!(
        refused,
        Err(CoonsError::DoNotMeet {
            corner: Corner::D,
            ..
        })
    ));
}
