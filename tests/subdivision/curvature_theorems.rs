//! Curvature at extraordinary points, and what the printed weight of Loop's scheme does to it.

use facette::algebra::{Vector3, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Eigenvalues, catmull_clark_eigenvalues, catmull_clark_ring_eigenvalues,
    catmull_clark_vertex_eigenvalues, loop_eigenvalues,
};
use facette::subdivision::mask::{loop_vertex_weight, turn_cosine};
use facette::subdivision::{Corners, loop_subdivision_with};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::limit_inputs::{hilly, joined, levels, limits, refined};
use crate::meshes::triangle_grid;
use crate::steps::Scheme;
use crate::suspects;

type Point = [f64; 3];

/// **The printed cosine makes regular vertices too flat.** In Loop's step the difference $m-v$ of the mean of the neighbours and the vertex is multiplied by $\alpha-\frac38$. At a regular vertex that must be $\frac14=\lambda^2$, as it is for $\alpha_6=\frac58$: then $4^k(m-v)$, a discrete curvature, stays what it is. With the cosine printed on the slide, $\alpha_6=\left(\frac38+0\right)^2+\frac38=\frac{33}{64}$, and it is multiplied by
/// $\frac9{16}$ in each step: the mean curvature goes to zero in every vertex, and the surface is no box spline.
///
/// Course: D26, slide 78, Loop's weight: its eigenvalues.
#[test]
fn printed_cosine_flattens_regular_vertices() {
    let law = Law::new(
        "subdivision::printed_cosine_flattens_regular_vertices",
        suspects::library,
    );
    let points = || proptest::collection::vec([-9..9_i32, -9..9, -9..9], 9);
    let right = loop_vertex_weight(fraction(1, 2));
    // cos(3π/6) = 0.
    let printed = loop_vertex_weight(fraction(0, 1));
    assert_eq!([right, printed], [fraction(5, 8), fraction(33, 64)]);
    let flat = Just(vec![[0, 1, 2]; 9]);
    law.holds(points(), flat, |points: &Vec<[i32; 3]>| {
        let points = points.iter().map(|p| p.map(|c| fraction(c, 1))).collect();
        let mesh = triangle_grid(2, 2).with_points(points);
        for (alpha, factor) in [(right, fraction(1, 1)), (printed, fraction(9, 16))] {
            let bump = |mesh: &Mesh<[Exact; 3]>| {
                let joined = joined(mesh);
                let at = |v: u32| mesh.positions[v as usize];
                let ring = joined.around(4).map(|h| at(joined.target(h)).minus(at(4)));
                ring.fold([fraction(0, 1); 3], VectorSpace::plus)
            };
            let fine =
                loop_subdivision_with(&joined(&mesh), &mesh.positions, Corners::Sharp, |_| alpha);
            let fine = fine.expect("exact points");
            expect_equal(
                &bump(&mesh).times(factor),
                &bump(&fine).times(fraction(4, 1)),
            )?;
        }
        Ok(())
    });
}

/// The largest height of a corner of the faces around vertex 0 over the tangent plane, over the square of its distance within it: half a discrete
/// normal curvature. The neighbours alone would not do: at valence 3 of Catmull-Clark their heights vanish in the eigenvector.
fn curvature(scheme: Scheme, mesh: &Mesh<Point>) -> f64 {
    let limit = limits(scheme, mesh, Corners::Sharp)[0];
    let normal = limit.normal().expect("a tangent plane");
    let around = mesh.faces().filter(|face| face.contains(&0)).flatten();
    let bends = around.filter(|&&v| v != 0).map(|&v| {
        let offset = mesh.positions[v as usize].minus(limit.position);
        let height = offset.dot(normal);
        height.abs() / (offset.dot(offset) - height * height)
    });
    bends.fold(0.0, f64::max)
}

/// How much faster than the first the second eigenvector of Catmull-Clark shrinks: for the tangents, or for a frequency if that is slower.
fn second_to_first(n: usize, frequency: usize) -> f64 {
    let of = |frequency: usize| {
        let [first, second] = match frequency {
            0 => catmull_clark_vertex_eigenvalues::<f64>(n),
            _ => catmull_clark_ring_eigenvalues(turn_cosine(frequency, n)),
        };
        second / first
    };
    of(1).max(of(frequency))
}

/// **Curvature that grows without end.** Heights over the tangent plane shrink by $\mu$, squares of distances by $\lambda^2$: a discrete curvature at the vertex is multiplied by $\mu/\lambda^2$ in every step. For Catmull-Clark at $n=5$ that is $1.124$, at $n=8$ it is $1.339$; for Loop at $n=7$ $1.13$. At regular vertices it is 1, and the
/// curvature converges. At $n=3$ Catmull-Clark has $0.991$, and the surface becomes flat in the point. The surfaces are $C^2$ elsewhere and $C^1$ there.
///
/// Course: D23, slide 76, Catmull-Clark: C2 but at extraordinary points.
#[test]
fn curvature_is_multiplied_by_mu_over_lambda_squared() {
    // Heights of one frequency, that of the largest eigenvalue: saddles, or a cup where that is larger.
    let growth = |scheme, n: u32, frequency: u32| {
        let last = levels(scheme, &wavy(scheme, n, frequency), 20);
        let fine = refined(scheme, &last[20], 0..1, Corners::Sharp);
        curvature(scheme, &fine) / curvature(scheme, &last[20])
    };
    let expected = |e: Eigenvalues<f64>| e.next / (e.tangent * e.tangent);
    let frequency = |n, cups_up_to| if n <= cups_up_to { 0 } else { 2 };
    // The quotient of two curvatures, each a quotient: few roundings, none of them magnified.
    let rounding = 8.0 * f64::EPSILON;
    for n in [3, 4, 5, 6, 8, 12, 20] {
        let expected = expected(catmull_clark_eigenvalues(n as usize));
        let got = growth(Scheme::CatmullClark, n, frequency(n, 4));
        println!("Catmull-Clark {n}: {got:.4}, {expected:.4}");
        // Of the faces' ring there is a second eigenvector, in the heights and in the plane. Relative to the first it shrinks by this ratio in
        // each step, and what it changes from one step to the next is its share less what is left of that. It begins no larger than the first.
        let ratio = second_to_first(n as usize, frequency(n, 4) as usize);
        let left = 2.0 * ratio.powi(20) * (1.0 - ratio);
        assert!(
            (got / expected - 1.0).abs() <= left + rounding,
            "Catmull-Clark {n}: {got}, not {expected}"
        );
    }
    // Loop's neighbours in a wave are an eigenvector alone.
    for n in [4, 5, 6, 7, 8, 12, 20] {
        let expected = expected(loop_eigenvalues(n as usize));
        let got = growth(Scheme::Loop, n, frequency(n, 6));
        println!("Loop {n}: {got:.4}, {expected:.4}");
        assert!(
            (got / expected - 1.0).abs() <= rounding,
            "Loop {n}: {got}, not {expected}"
        );
    }
}

/// Vertex 0 in the middle of circles of neighbours, whose heights are a wave of the given frequency; for frequency 0 the middle alone is lifted.
fn wavy(scheme: Scheme, n: u32, frequency: u32) -> Mesh<Point> {
    let flat = hilly(scheme, n, 0);
    let points = flat.positions.iter().map(|&[x, y, _]| {
        let wave = (f64::from(frequency) * y.atan2(x)).cos();
        // A cup is a lifted centre.
        let is_centre = x == 0.0 && y == 0.0;
        let height = if frequency == 0 {
            f64::from(u8::from(is_centre))
        } else {
            x.hypot(y) * wave
        };
        [x, y, height]
    });
    Mesh::new(points.collect(), flat.faces()).expect("the same faces")
}
