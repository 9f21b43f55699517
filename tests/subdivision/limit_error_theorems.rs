//! Rounding errors of limits: single precision against double, double against exact numbers.

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::Corners;
use facette::subdivision::limit::{
    catmull_clark_limit_positions, catmull_clark_limits, loop_limit_positions, loop_limits,
    sqrt3_limit_positions, sqrt3_limits, turn_point,
};

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::limit_inputs::{VALENCES, joined, limits_with, rational_circle};
use crate::meshes::{Topology, double_fan, quad_fan};
use crate::steps::Scheme;

const SCHEMES: [Scheme; 3] = [Scheme::CatmullClark, Scheme::Loop, Scheme::Sqrt3];

fn fan_for(scheme: Scheme, n: u32) -> Topology {
    if scheme == Scheme::CatmullClark {
        quad_fan(n)
    } else {
        double_fan(n)
    }
}

/// The largest coordinate difference between vertex 0 and another vertex of its faces.
fn extent(mesh: &Mesh<[f64; 3]>) -> f64 {
    let faces = mesh.faces().filter(|face| face.contains(&0));
    let centre = mesh.positions[0];
    let lengths = faces.flatten().map(|&v| {
        mesh.positions[v as usize]
            .minus(centre)
            .largest_coordinate()
    });
    lengths.fold(0.0, f64::max)
}

/// The documented bounds on the offset from the vertex, in units of roundoff and of the ring's extent.
fn position_bound(scheme: Scheme, n: u32) -> f64 {
    let n = f64::from(n);
    match scheme {
        Scheme::CatmullClark => 6.0 * (n + 9.0) / (n + 5.0),
        _ => 0.63 * (n + 15.0),
    }
}

/// A mesh in single precision, with points at random about a far one, or about the origin.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the rounded points are the test's points"
)]
fn single_mesh(topology: &Topology, offset: f64, dice: &mut Dice) -> Mesh<[f32; 3]> {
    let points = (0..topology.vertex_count).map(|_| dice.vector().map(|c| (offset + c) as f32));
    topology.with_points(points.collect())
}

/// The limit at vertex 0 in single precision, as double precision numbers: position and tangents.
fn single(scheme: Scheme, mesh: &Mesh<[f32; 3]>) -> [[f64; 3]; 3] {
    let (joined, points) = (&joined(mesh), &mesh.positions);
    let (limits, positions) = match scheme {
        Scheme::CatmullClark => (
            catmull_clark_limits(joined, points, Corners::Sharp),
            catmull_clark_limit_positions(joined, points, Corners::Sharp),
        ),
        Scheme::Loop => (
            loop_limits(joined, points, Corners::Sharp),
            loop_limit_positions(joined, points, Corners::Sharp),
        ),
        _ => (
            sqrt3_limits(joined, points, Corners::Sharp),
            sqrt3_limit_positions(joined, points, Corners::Sharp),
        ),
    };
    let limit = limits.expect("a point for each vertex")[0];
    assert_eq!(
        limit.position,
        positions.expect("a point for each vertex")[0]
    );
    let [along, across] = limit.tangents.expect("faces around");
    [limit.position, along, across].map(|v| v.map(f64::from))
}

/// **Limit positions and tangents are as accurate as they say.** With $L$ the largest coordinate difference between the vertex and the corners of its faces (of at most $m$ corners), $n$ the valence and $p$ the largest coordinate of the result, the
/// error of a position is at most $\frac{6(n+m+5)}{n+5}\mathbf uL+\mathbf up$ for Catmull-Clark, and $0.63\,(n+15)\mathbf uL+\mathbf up$ for Loop and $\sqrt3$; that of a tangent at most $2(n+m+40)\mathbf uL$, without a term in $p$: a mesh may lie as far away as it likes.
///
/// The terms of the sums are differences, with one rounding each. The centroids add $m+1$, sums of $n$ terms $n-1$, the factors four; for Loop and $\sqrt3$ the weight itself is within $13\mathbf u$, since its cosine is within $3\mathbf u$. The weights'
/// absolute values sum to $\frac6{n+5}$, or to $\frac58$ at most. Tangents: the eigenvalue is within $12\mathbf u$ and enters by $16\lambda-4$, which is within $33\mathbf u$; the weights sum to 2 at most. Measured in single precision against double, near the origin and at $2^{20}$.
/// The bound of the tangents adds up the worst of every rounding, of which random ones reach a thirtieth.
///
/// Course: D24, slide 77, limits at extraordinary points in floating point.
#[test]
fn limits_are_as_accurate_as_they_say() {
    let unit = f64::from(f32::EPSILON) / 2.0;
    let mut worst = [0.0_f64; 2];
    for scheme in SCHEMES {
        for n in VALENCES {
            for seed in 0..20 {
                let mut dice = Dice::new(seed);
                let offset = if seed % 4 == 0 { 1_048_576.0 } else { 0.0 };
                let topology = fan_for(scheme, n);
                let mesh = single_mesh(&topology, offset, &mut dice);
                let wide = mesh.positions.iter().map(|p| p.map(f64::from)).collect();
                let wide: Mesh<[f64; 3]> = topology.with_points(wide);
                let exact = limits_with(scheme, &wide, Corners::Sharp, turn_point, f64::sqrt)[0];
                let [along, across] = exact.tangents.expect("faces around");
                let got = single(scheme, &mesh);
                let error = |k: usize, exact: [f64; 3]| got[k].minus(exact).largest_coordinate();
                let length = extent(&wide);
                let position =
                    position_bound(scheme, n) * length + exact.position.largest_coordinate();
                let tangent = 2.0 * f64::from(n + 44) * length;
                worst[0] = worst[0].max(error(0, exact.position) / (position * unit));
                for (k, exact) in [(1, along), (2, across)] {
                    worst[1] = worst[1].max(error(k, exact) / (tangent * unit));
                }
            }
        }
    }
    println!("largest parts of the bounds: {worst:.3?}");
    assert!(worst[0] <= 1.0 && worst[0] >= 0.05, "{worst:?}");
    assert!(worst[1] <= 1.0 && worst[1] >= 0.01, "{worst:?}");
}

/// **At $2^{27}$ a position loses one rounding.** The same in double precision against exact numbers: a mesh with coordinates $2^{27}+\frac k{1024}$ is exact, its limits are off by the bound of the theorem before.
///
/// Course: D24, slide 77, limits of a mesh far from the origin.
#[test]
fn far_limits_lose_one_rounding() {
    let unit = f64::EPSILON / 2.0;
    let far = 134_217_728.0;
    let mut worst = 0.0_f64;
    let cases = [
        (Scheme::CatmullClark, 3),
        (Scheme::CatmullClark, 5),
        (Scheme::CatmullClark, 50),
    ];
    let triangles = [Scheme::Loop, Scheme::Sqrt3].map(|scheme| [3, 4, 6].map(|n| (scheme, n)));
    for (scheme, n) in cases.into_iter().chain(triangles.concat()) {
        let topology = fan_for(scheme, n);
        let mut dice = Dice::new(u64::from(n));
        #[allow(clippy::cast_possible_truncation, reason = "numerators below 1024")]
        let numerators: Vec<[i32; 3]> = (0..topology.vertex_count)
            .map(|_| dice.vector().map(|c| (c * 1023.0) as i32))
            .collect();
        let float = numerators
            .iter()
            .map(|p| p.map(|k| far + f64::from(k) / 1024.0));
        let mesh = topology.with_points(float.collect());
        let exact = numerators
            .iter()
            .map(|p| p.map(|k| fraction(1 << 27, 1) + fraction(k, 1024)));
        let exact: Mesh<[Exact; 3]> = topology.with_points(exact.collect());
        let circle = |k, n| rational_circle(k, n).unwrap_or([fraction(1, 1); 2]);
        let exact = limits_with(scheme, &exact, Corners::Sharp, circle, |x| x)[0].position;
        let got = limits_with(scheme, &mesh, Corners::Sharp, turn_point, f64::sqrt)[0].position;
        for axis in 0..3 {
            // Both numbers less 2²⁷, which is exact, in units of 1/1024 · 2⁻³⁰.
            let error = exact[axis] - rational(got[axis]);
            let bound = (position_bound(scheme, n) * extent(&mesh) + far + 1.0) * unit;
            worst = worst.max(approximate(error).abs() / bound);
        }
    }
    println!("largest part of the bound: {worst:.3}");
    assert!((0.05..=1.0).contains(&worst), "{worst}");
}

/// A number near 2²⁷ with at most 26 fractional bits, exactly.
#[allow(
    clippy::cast_possible_truncation,
    reason = "the parts are whole and small"
)]
fn rational(value: f64) -> Exact {
    let (whole, part) = (value.trunc(), value.fract() * 67_108_864.0);
    assert_eq!(part, part.trunc(), "26 fractional bits");
    fraction(whole as i32, 1) + fraction(part as i32, 1 << 26)
}

/// A small exact number as a float, by bisection of its size.
fn approximate(value: Exact) -> f64 {
    let mut rest = value;
    let (mut sum, mut bit) = (0.0, 1.0_f64);
    let sign = if rest < fraction(0, 1) { -1.0 } else { 1.0 };
    if sign < 0.0 {
        rest = -rest;
    }
    let mut exact_bit = fraction(1, 1);
    for _ in 0..90 {
        if rest >= exact_bit {
            rest = rest - exact_bit;
            sum += bit;
        }
        bit /= 2.0;
        exact_bit = exact_bit / fraction(2, 1);
    }
    sign * sum
}
