//! Steps in floating point against the same steps without rounding.

use facette::algebra::Scalar;
use facette::mesh::Mesh;
use facette::subdivision::Corners;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, Verdict, expect_at_most};
use crate::meshes::{
    Topology, hard_topologies, hard_triangle_topologies, topologies, triangle_topologies,
};
use crate::steps::{OF_POLYGONS, OF_TRIANGLES, Scheme, corner_rules, rational_cosine};
use crate::suspects;

/// A mesh with whole coordinates, and how to refine it.
type Input = (Topology, Vec<[i32; 3]>, Corners);

fn inputs(topologies: impl Strategy<Value = Topology>) -> impl Strategy<Value = Input> {
    let with_points = topologies.prop_flat_map(|topology| {
        let coordinate = || -64..=64_i32;
        let points = vec(
            [coordinate(), coordinate(), coordinate()],
            topology.vertex_count,
        );
        (Just(topology), points)
    });
    (with_points, corner_rules())
        .prop_map(|((topology, points), corners)| (topology, points, corners))
}

/// The largest error of a step far from the origin, in units in the last place of the distance. The cosines are the same fractions with denominator 4096 in both
/// arithmetics, so that the steps differ by rounding alone.
fn error_far_away<S: Scalar + Into<f64>>(
    scheme: Scheme,
    (topology, points, corners): &Input,
    distance: i32,
    ulp: f64,
) -> f64 {
    let exact: Vec<[Exact; 3]> = points.iter().map(|p| p.map(Exact::from_i32)).collect();
    let near = scheme.step(&topology.with_points(exact), 0, *corners);
    let far: Vec<[S; 3]> = points
        .iter()
        .map(|p| p.map(|c| S::from_i32(c + distance)))
        .collect();
    let cosine = |k, n| {
        let numerator = (rational_cosine(k, n) * fraction(4096, 1)).to_f64();
        #[allow(clippy::cast_possible_truncation, reason = "a whole number up to 4096")]
        S::ratio(numerator as i32, 4096)
    };
    let far: Mesh<[S; 3]> = scheme
        .step_with(&topology.with_points(far), 0, *corners, cosine)
        .expect("a manifold");
    let mut worst = 0.0_f64;
    for (near, far) in near.positions.iter().zip(&far.positions) {
        for axis in 0..3 {
            // Both numbers are next to the distance: their difference is not rounded.
            let offset: f64 = far[axis].into() - f64::from(distance);
            worst = worst.max((offset - near[axis].to_f64()).abs() / ulp);
        }
    }
    worst
}

/// **Far away.** A mesh of size 128 whose vertices are $2^{27}$ away from the origin loses at most $\frac{13}{10}$ of a unit in the last place of $2^{27}$ in a step of any scheme, in `f64`, and at most $\frac32$ of one in `f32` at $2^{20}$.
///
/// Every rule is a point $p$ and a sum of weighted differences. Differences of neighbouring vertices are exact; that of rounded face points are wrong by half a unit each. So the worst case is an edge point of Catmull-Clark: the midpoint of two face points, each half a unit wrong, adds half a unit,
/// the midpoint of the edge half a unit, and their mean halves both and adds half: $\frac12(\frac12+\frac12+\frac12)+\frac12=\frac54$. The small differences themselves are rounded at their own size; at this distance that is less than a hundredth of a unit in `f64`, and a quarter in `f32`.
///
/// Course: D20, slide 73, Catmull-Clark: points on edges.
#[test]
fn far_away_steps_lose_few_ulps() {
    let worst = std::cell::Cell::new([0.0_f64; 2]);
    let check = |schemes: &[Scheme], input: &Input| -> Verdict {
        for &scheme in schemes {
            let wide = error_far_away::<f64>(scheme, input, 1 << 27, 2.0_f64.powi(27 - 52));
            let narrow = error_far_away::<f32>(scheme, input, 1 << 20, 2.0_f64.powi(20 - 23));
            let [a, b] = worst.get();
            worst.set([a.max(wide), b.max(narrow)]);
            expect_at_most("an error, in units in the last place,", 1.3, wide)?;
            expect_at_most("an error in f32, in units in the last place,", 1.5, narrow)?;
        }
        Ok(())
    };
    let law = || {
        Law::new(
            "subdivision::far_away_steps_lose_few_ulps",
            suspects::library,
        )
    };
    law().holds(inputs(topologies()), inputs(hard_topologies()), |input| {
        check(&OF_POLYGONS, input)
    });
    let triangles = inputs(triangle_topologies());
    law().holds(triangles, inputs(hard_triangle_topologies()), |input| {
        check(&OF_TRIANGLES, input)
    });
    println!("largest errors seen: {:?}", worst.get());
    assert!(worst.get().iter().all(|&worst| worst > 0.5));
}
