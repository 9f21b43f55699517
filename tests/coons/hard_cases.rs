//! Inputs that break the textbook formulas of this chapter, what survives them, and both shown.

use crate::common::exact::fraction;
use crate::common::oracle::{big, big_point, largest_error};
use crate::inputs::{bezier, hermite_boundary, incompatible_example, surface_point};
use crate::variants::{direct_point, fused_point, short_lerp_point};
use facette::algebra::{Vector3, VectorSpace, unit_vector};
use facette::coons::{
    BicubicPatch, Boundary, CoonsPatch, bicubic_partials, bicubic_point, bilinear_point,
};
use facette::curve::{BezierCurve, Curve};
use facette::surface::Surface;
use glam::{DVec3, Vec3};

/// The straight line between two points.
pub fn line(start: [f64; 3], end: [f64; 3]) -> BezierCurve<[f64; 3]> {
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
/// $S_2+(1-v)\bigl(P_1-(1-u)A-uB\bigr)+v\bigl(P_2-(1-u)D-uC\bigr)$, which saves operations, rounds its differences: both miss the edge curve at some parameter, and a
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

/// **A curve that stands still.** Where an edge has a cusp, or a double control point, its derivative vanishes too, but the side is no point: the normals
/// from the left and from the right differ, and there is none at the place itself.
#[test]
fn normal_at_a_cusp_is_not_made_up() {
    let [c, d] = [[1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    for (edge, u) in [
        (vec![[0., 0., 0.], [0., 0., 0.], [1., 0., 1.]], 0.0),
        (
            vec![[0., 0., 0.], [1., 0., 1.], [0., 0., 1.], [1., 0., 0.]],
            0.5,
        ),
    ] {
        let [a, b] = [edge[0], edge[edge.len() - 1]];
        let boundary = Boundary::new(bezier(&edge), line(d, c), line(a, d), line(b, c));
        let patch = CoonsPatch::new(boundary.expect("the ends are shared"));
        assert_eq!(patch.boundary().p1().derivative(u), Some([0.0; 3]));
        assert_eq!(patch.normal_vector(u, 0.0), None, "{edge:?}");
        assert!(patch.normal_vector(u, 0.25).is_some());
    }
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
    let patch = BicubicPatch::new(data.clone());
    assert_eq!(patch.point(t, t), bicubic_point(&data, t, t));
    assert_eq!(patch.partials(t, t), bicubic_partials(&data, t, t));
}

/// **Gregory's corner.** At the corner the blended twist is $0/0$, but its weight is zero: the patch has its corner point and its two tangents there, no NaN, and next
/// to the corner the values close up on them.
#[test]
fn gregory_patch_is_continuous_at_its_corners() {
    let data = incompatible_example();
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

/// **Tiny distances from Gregory's corner.** The change of the blended twist grows as the reciprocal of the distance from the corner. Its weight tames it, if the two meet
/// before the reciprocal overflows: the derivatives are finite down to denormal parameters, and for data as large as $10^{300}$.
#[test]
fn gregory_derivatives_do_not_overflow() {
    let data = incompatible_example();
    let tangents = bicubic_partials(&data, 0.0, 0.0).expect("Bézier curves have derivatives");
    for distance in [1e-300, 1e-310, f64::from_bits(1)] {
        let near = bicubic_partials(&data, distance, distance).expect("as at the corner");
        for (near, tangent) in near.into_iter().zip(tangents) {
            let change = near.minus(tangent).largest_coordinate();
            assert!(change <= 2.0 * distance, "{change} at {distance}");
        }
    }
}

/// **Noise in a twist.** Twists are differences of slopes, and carry the rounding of slopes. Twists that vanish, up to that, agree with zero.
#[test]
fn twists_agree_up_to_the_rounding_of_slopes() {
    use facette::coons::{Corners, CrossDerivatives, HermiteBoundary};
    let [a, b, c, d] = [[0., 0., 0.], [0.3, 0., 0.], [0.3, 0.3, 0.], [0., 0.3, 0.]];
    let boundary = Boundary::new(line(a, b), line(d, c), line(a, d), line(b, c));
    let [in_u, in_v, noisy] = [[0.3, 0., 0.], [0., 0.3, 0.], [0.3_f64.next_up(), 0., 0.]];
    let cross = CrossDerivatives {
        p1_v: line(in_v, in_v),
        p2_v: line(in_v, in_v),
        q1_u: line(in_u, noisy),
        q2_u: line(in_u, in_u),
    };
    let none = Corners {
        a: [0.0; 3],
        b: [0.0; 3],
        c: [0.0; 3],
        d: [0.0; 3],
    };
    let data = HermiteBoundary::new(boundary.expect("a square"), cross, none);
    assert!(data.is_ok(), "{:?}", data.err());
}

/// **Nearly parallel tangents.** Their product is known up to 8 unit roundoffs of their sizes: what is not larger is no normal, what is larger is one.
#[test]
fn parallel_tangents_have_no_normal_up_to_rounding() {
    struct Tangents([[f64; 3]; 2]);
    impl Surface for Tangents {
        type Scalar = f64;
        type Point = [f64; 3];

        fn domain(&self) -> [[f64; 2]; 2] {
            [[0.0, 1.0]; 2]
        }

        fn point(&self, _: f64, _: f64) -> [f64; 3] {
            [0.0; 3]
        }

        fn partials(&self, _: f64, _: f64) -> Option<[[f64; 3]; 2]> {
            Some(self.0)
        }
    }
    let roundoff = f64::EPSILON / 2.0;
    let normal = |slope: f64| Tangents([[1., 0., 0.], [1., slope, 0.]]).normal_vector(0.5, 0.5);
    assert_eq!(normal(8.0 * roundoff), None);
    assert_eq!(normal(10.0 * roundoff), Some([0.0, 0.0, 10.0 * roundoff]));
}
