//! The theorems of limit positions: the masks are left eigenvectors of the schemes as they run.

use facette::algebra::{Scalar, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::limit::{catmull_clark_limit_positions, doo_sabin_limits_with};
use facette::subdivision::mask::{loop_vertex_weight, sqrt3_neighbours_weight};
use facette::subdivision::{Corners, DooSabinWeights};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::limit_inputs::{joined, limits_with, neighbourhood, rounds, whole};
use crate::meshes::{
    double_fan, hard_meshes, hard_triangle_meshes, meshes, quad_fan, triangle_meshes,
};
use crate::steps::{Scheme, corner_rules, rational_cosine};
use crate::suspects;

type Point = [Exact; 3];

/// The limit positions with rational cosines in the place of the others, and no tangents that anyone looks at.
fn positions(scheme: Scheme, mesh: &Mesh<Point>, corners: Corners) -> Vec<Point> {
    if scheme == Scheme::CatmullClark {
        return catmull_clark_limit_positions(&joined(mesh), &mesh.positions, corners)
            .expect("a point for each vertex");
    }
    let circle = |k, n| [rational_cosine(k, n), Exact::one()];
    let limits = limits_with(scheme, mesh, corners, circle, |_| Exact::zero());
    limits.iter().map(|limit| limit.position).collect()
}

/// **A step leaves the limit of Catmull-Clark where it is.** The position mask of the refined ring gives what the mask of the ring gives. With $n$ neighbours $e$ of the vertex $v$ and the centroids $c$ of the $n$ faces it is
///
/// $$p^\infty=\frac{n(n-1)\,v+2\sum e+4\sum c}{n(n+5)},$$
///
/// on a boundary $\frac16(e_-+4v+e_+)$, and a sharp corner stays. The weights are rational, so it is exact, for every valence and faces of any number of corners.
///
/// Course: D24, slides 76-77, Catmull-Clark and Loop: the limit at a vertex.
#[test]
fn catmull_clark_limit_is_not_moved_by_a_step() {
    let law = Law::new(
        "subdivision::catmull_clark_limit_is_not_moved_by_a_step",
        suspects::library,
    );
    law.holds(
        (meshes(), corner_rules()),
        (hard_meshes(), corner_rules()),
        |(cage, corners)| {
            let before = positions(Scheme::CatmullClark, &cage.mesh, *corners);
            let refined = Scheme::CatmullClark.step(&cage.mesh, 0, *corners);
            let after = positions(Scheme::CatmullClark, &refined, *corners);
            expect_equal(&before, &after[..before.len()].to_vec())
        },
    );
}

/// **Nor the limits of Loop and of √3.** With $m$ the mean of the neighbours of an interior vertex $v$, the limits are
///
/// $$\text{Loop: }\ v+\frac{8(1-\alpha)}{11-8\alpha}(m-v),\qquad\sqrt3:\ \frac{v+3\alpha m}{1+3\alpha},$$
///
/// whatever weight $\alpha$ the scheme gives the vertex (Loop) or the mean ($\sqrt3$). The theorem is tried with fractions near the true weights, where it is exact for every valence. On a boundary both have the limit $\frac16(e_-+4v+e_+)$ of
/// the cubic B-spline; for $\sqrt3$, whose boundary is refined in every second step, after two steps.
///
/// Course: D03, slide 50, √3 is approximating: its limit at a vertex.
#[test]
fn limits_of_loop_and_sqrt3_are_not_moved_by_steps() {
    let law = Law::new(
        "subdivision::limits_of_loop_and_sqrt3_are_not_moved_by_steps",
        suspects::library,
    );
    law.holds(
        (triangle_meshes(), corner_rules()),
        (hard_triangle_meshes(), corner_rules()),
        |(cage, corners)| {
            for scheme in [Scheme::Loop, Scheme::Sqrt3] {
                let before = positions(scheme, &cage.mesh, *corners);
                let refined = (0..rounds(scheme)).fold(cage.mesh.clone(), |mesh, step| {
                    scheme.step(&mesh, step, *corners)
                });
                let after = positions(scheme, &refined, *corners);
                expect_equal(
                    &(scheme, &before),
                    &(scheme, &after[..before.len()].to_vec()),
                )?;
            }
            Ok(())
        },
    );
}

/// **A face of Doo-Sabin shrinks to its centroid.** It does so with either kind of weights, on the boundary as inside, and whether it is flat or not. So the limit points of a vertex and of an edge are the centroids of the faces that the first step makes of them.
///
/// Course: D16, slide 68, Doo-Sabin: the centroid of an n-gon stays.
#[test]
fn doo_sabin_limit_of_a_face_is_its_centroid() {
    let law = Law::new(
        "subdivision::doo_sabin_limit_of_a_face_is_its_centroid",
        suspects::library,
    );
    law.holds(
        (meshes(), corner_rules()),
        (hard_meshes(), corner_rules()),
        |(cage, corners)| {
            let centres = |mesh: &Mesh<Point>| -> Vec<Point> {
                let unused = |_, _| [Exact::zero(); 2];
                let limits = doo_sabin_limits_with(&joined(mesh), &mesh.positions, unused);
                let limits = limits.expect("a point for each vertex");
                limits.iter().map(|limit| limit.position).collect()
            };
            let before = centres(&cage.mesh);
            let centroids = cage.mesh.faces().map(|face| {
                let corners = face.iter().map(|&v| cage.mesh.positions[v as usize]);
                let sum = corners.fold(Point::origin(), Point::plus);
                sum.times(Exact::one() / whole(face.len()))
            });
            expect_equal(&centroids.collect::<Vec<_>>(), &before)?;
            // Any weights that depend on the number of steps alone, the same both ways round, keep the centroid.
            for weights in [DooSabinWeights::Own, DooSabinWeights::Averaging] {
                let refined = Scheme::DooSabin(weights).step(&cage.mesh, 0, *corners);
                let after = centres(&refined)[..before.len()].to_vec();
                expect_equal(&(weights, &before), &(weights, &after))?;
            }
            Ok(())
        },
    );
}

/// **On quadrilaterals the mask is the textbook's.** With edge neighbours $e$ and diagonal neighbours $f$ the limit of Catmull-Clark is $\dfrac{n^2v+4\sum e+\sum f}{n(n+5)}$, and the mask with centroids on any faces is this one after the first step.
///
/// Course: D23, slide 76, Catmull-Clark at extraordinary points.
#[test]
fn limit_on_quadrilaterals_has_the_weights_of_the_textbook() {
    let law = Law::new(
        "subdivision::limit_on_quadrilaterals_has_the_weights_of_the_textbook",
        suspects::library,
    );
    let rings = |valences: std::ops::Range<u32>| {
        valences.prop_flat_map(|n| {
            let coordinates = [-9..9_i32, -9..9, -9..9];
            let points = proptest::collection::vec(coordinates, 2 * n as usize + 1);
            (Just(n), points)
        })
    };
    law.holds(rings(3..9), rings(40..41), |(n, points)| {
        let points: Vec<Point> = points.iter().map(|p| p.map(|c| fraction(c, 1))).collect();
        let n = *n as usize;
        let sum = |part: &[Point]| part.iter().fold(Point::origin(), |sum, &p| sum.plus(p));
        let [e, f] = [sum(&points[1..=n]), sum(&points[n + 1..])];
        let count = whole::<Exact>(n);
        let four = fraction(4, 1);
        let expected = points[0].times(count * count).plus(e.times(four)).plus(f);
        let expected = expected.times(Exact::one() / (count * (count + fraction(5, 1))));
        let mesh = quad_fan(u32::try_from(n).expect("small")).with_points(points);
        expect_equal(
            &expected,
            &positions(Scheme::CatmullClark, &mesh, Corners::Sharp)[0],
        )
    });
}

/// The positions of vertex 0 after 0, 1, ... steps, less its limit: only the neighbourhood is refined.
fn way_to_the_limit(scheme: Scheme, mesh: &Mesh<Point>, steps: u32) -> Vec<Point> {
    let limit = positions(scheme, mesh, Corners::Sharp)[0];
    let mut mesh = mesh.clone();
    let mut way = vec![mesh.positions[0].minus(limit)];
    for step in 0..steps {
        mesh = neighbourhood(&scheme.step(&mesh, step, Corners::Sharp), 0, 2);
        way.push(mesh.positions[0].minus(limit));
    }
    way
}

/// **The error of a vertex is a power of one eigenvalue.** After $k$ steps an interior vertex $v_k$ of Loop's scheme or of $\sqrt3$ is away from its limit by exactly
///
/// $$v_k-p^\infty=\mu^k\,(v_0-p^\infty),\qquad\mu_{\text{Loop}}=\alpha-\tfrac38,\quad\mu_{\sqrt3}=\tfrac23-\alpha,$$
///
/// and with the schemes' own weights $\mu=\lambda^2$. Twelve levels of a neighbourhood are refined, and it holds with $=$. Nothing that happens further away matters.
///
/// Course: D24, slide 77, Loop at extraordinary points.
#[test]
fn error_of_a_vertex_of_triangles_is_a_power() {
    let law = Law::new(
        "subdivision::error_of_a_vertex_of_triangles_is_a_power",
        suspects::library,
    );
    let cages = |valences: Vec<u32>| {
        prop::sample::select(valences).prop_flat_map(|n| {
            let topology = double_fan(n);
            let points =
                proptest::collection::vec([-9..9_i32, -9..9, -9..9], topology.vertex_count);
            (Just(n), points)
        })
    };
    let law = law.on_cases(8);
    law.holds(cages(vec![3, 4, 6]), cages(vec![3, 7]), |(n, points)| {
        let points = points.iter().map(|p| p.map(|c| fraction(c, 1))).collect();
        let mesh = double_fan(*n).with_points(points);
        let cosine = rational_cosine(1, *n as usize);
        let mus = [
            loop_vertex_weight(cosine) - fraction(3, 8),
            fraction(2, 3) - sqrt3_neighbours_weight(cosine),
        ];
        for (scheme, mu) in [Scheme::Loop, Scheme::Sqrt3].into_iter().zip(mus) {
            let way = way_to_the_limit(scheme, &mesh, 12);
            for pair in way.windows(2) {
                expect_equal(&(scheme, pair[0].times(mu)), &(scheme, pair[1]))?;
            }
        }
        Ok(())
    });
}

/// **For Catmull-Clark it is a sum of powers of two.** The errors $d_k=v_k-p^\infty$ of an interior vertex of quadrilaterals obey
///
/// $$d_{k+2}=\frac{3n-7}{4n}\,d_{k+1}-\frac{n-3}{16n}\,d_k,$$
///
/// whose solutions are $d_k=a\mu_+^k+b\mu_-^k$ with $\mu_\pm=\dfrac{3n-7\pm\sqrt{5n^2-30n+49}}{8n}$: sum and product of the two are the coefficients. It is exact for every valence.
///
/// Course: D23, slide 76, Catmull-Clark at extraordinary points.
#[test]
fn error_of_a_vertex_of_quadrilaterals_is_a_sum_of_two_powers() {
    let law = Law::new(
        "subdivision::error_of_a_vertex_of_quadrilaterals_is_a_sum_of_two_powers",
        suspects::library,
    );
    let cages = |valences: std::ops::Range<u32>| {
        valences.prop_flat_map(|n| {
            let points = proptest::collection::vec([-9..9_i32, -9..9, -9..9], 2 * n as usize + 1);
            (Just(n), points)
        })
    };
    law.on_cases(8)
        .holds(cages(3..9), cages(12..13), |(n, points)| {
            let points = points.iter().map(|p| p.map(|c| fraction(c, 1))).collect();
            let mesh = quad_fan(*n).with_points(points);
            let way = way_to_the_limit(Scheme::CatmullClark, &mesh, 12);
            let n = Exact::from_i32(i32::try_from(*n).expect("small"));
            let [three, four, seven, sixteen] = [3, 4, 7, 16].map(Exact::from_i32);
            let sum = (three * n - seven) / (four * n);
            let product = (n - three) / (sixteen * n);
            for triple in way.windows(3) {
                let expected = triple[1].times(sum).minus(triple[0].times(product));
                expect_equal(&expected, &triple[2])?;
            }
            Ok(())
        });
}
