//! The theorems of a step of √3. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::mesh::Mesh;
use facette::subdivision::Corners;
use facette::subdivision::mask::sqrt3_neighbours_weight;
use num_traits::Zero;

use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::meshes::{
    hard_triangle_meshes, hard_triangle_topologies, octahedron, triangle_meshes,
    triangle_topologies,
};
use crate::plain_rules::Plain;
use crate::steps::{Scheme, boundary_polygons, expect_same_cycles, flat, rational_cosine};
use crate::suspects;

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::library)
}

fn alpha(n: usize) -> Exact {
    sqrt3_neighbours_weight(rational_cosine(1, n))
}

fn first_step<const N: usize>(mesh: &Mesh<[Exact; N]>) -> Mesh<[Exact; N]> {
    Scheme::Sqrt3.step(mesh, 0, Corners::Sharp)
}

/// **√3 moves the old vertices.** Each triangle gets its centroid as a new point, and an old vertex $V$ with $n$ neighbours of mean $Q$ goes to $(1-\alpha_n)V+\alpha_nQ$ with $\alpha_n=\frac19\bigl(4-2\cos\frac{2\pi}n\bigr)$. As $\frac29\le\alpha_n\le\frac23$, it always moves if it is not $Q$
/// already: the scheme approximates. An apex of the octahedron with vertices $\pm e_i$ goes from 1 to $\frac59$.
///
/// Course: D03, slide 50, history of the schemes.
/// Erratum: the slide calls √3 an interpolating scheme. Kobbelt's is approximating; the interpolating one is another, Labsik and Greiner's of 2000.
#[test]
fn sqrt3_moves_the_old_vertices() {
    law("subdivision::sqrt3_moves_the_old_vertices").holds(
        triangle_meshes(),
        hard_triangle_meshes(),
        |cage| {
            let plain = Plain::new(&cage.mesh);
            let refined = first_step(&cage.mesh).positions;
            let (old, new) = refined.split_at(cage.mesh.positions.len());
            let moved = (0..).take(old.len()).map(|v| plain.sqrt3_vertex(v, alpha));
            expect_equal(&moved.collect(), &old.to_vec())?;
            let centroids = cage.mesh.faces().map(|face| plain.face_point(face));
            expect_equal(&centroids.collect(), &new.to_vec())
        },
    );
    let apex = first_step(&octahedron()).positions[0];
    assert_eq!(apex, [fraction(5, 9), Exact::zero(), Exact::zero()]);
}

/// **Every old edge is flipped.** Of an edge $AB$ with the centroids $L$ on its left and $R$ on its right remain the triangles $ARL$ and $BLR$: the edge itself is gone, and $LR$ is in its place. A boundary edge stays, in the triangle $ABL$. So there are three triangles for one.
///
/// Course: D28, slide 79, √3: fewer triangles than Loop.
#[test]
fn sqrt3_flips_every_inner_edge() {
    law("subdivision::sqrt3_flips_every_inner_edge").holds(
        triangle_topologies(),
        hard_triangle_topologies(),
        |topology| {
            let joined = topology.connectivity();
            let refined = first_step(&flat(topology));
            let number = |count: usize| u32::try_from(count).expect("a small mesh");
            let centroid = |h| number(joined.vertex_count()) + joined.face_of(h);
            let half_edges = 0..number(joined.half_edge_count());
            let flipped = half_edges.map(|h| match joined.twin(h) {
                Some(twin) => [joined.origin(h), centroid(twin), centroid(h)],
                None => [joined.origin(h), joined.target(h), centroid(h)],
            });
            let expected: Vec<_> = flipped.collect();
            let got: Vec<_> = refined.faces().collect();
            expect_equal(&expected.iter().map(|face| &face[..]).collect(), &got)
        },
    );
}

/// **Two steps divide each edge by three.** One step turns the directions of the edges by a sixth of half a turn and divides their length by $\sqrt3$; two steps turn them back. A triangle that is cut regularly, with the vertices $(i,j)$, becomes the one with the vertices $\bigl(\frac i3,\frac j3\bigr)$: nine triangles for one. At the boundary, which has
/// no triangles to flip into, the first step leaves the edges alone and the second divides them by three; the points next to it have five neighbours instead of six when the second step moves them, and end up a little off the lattice.
///
/// Course: D28, slide 79, √3: fewer triangles than Loop.
#[test]
fn two_steps_of_sqrt3_divide_each_edge_by_three() {
    for size in 4..=6 {
        let lattice = triangular_lattice(size);
        let mut refined = lattice.clone();
        for step in 0..2 {
            refined = Scheme::Sqrt3.step(&refined, step, Corners::Sharp);
        }
        let (third, whole) = (fraction(1, 3), fraction(size, 1));
        let finer = triangular_lattice(3 * size);
        assert_eq!(refined.face_count(), 9 * lattice.face_count());
        assert_eq!(refined.positions.len(), finer.positions.len());
        let depth = |[x, y]: &[Exact; 2]| [*x, *y, whole - *x - *y];
        let is_inside = |place: &[Exact; 2]| depth(place).iter().all(|&d| d >= fraction(1, 1));
        let is_outside = |place: &[Exact; 2]| depth(place).iter().any(Zero::is_zero);
        let chosen = |places: Vec<[Exact; 2]>| {
            let of_interest = |place: &[Exact; 2]| is_inside(place) || is_outside(place);
            sorted(places.into_iter().filter(of_interest).collect())
        };
        let expected = finer
            .positions
            .iter()
            .map(|place| place.times(third))
            .collect();
        assert_eq!(chosen(expected), chosen(refined.positions.clone()));
        let directions = [[1, 0], [0, 1], [1, -1]].map(|d| d.map(|c| fraction(c, 3)));
        for face in refined.faces() {
            let corners = [0, 1, 2].map(|i| refined.positions[face[i] as usize]);
            if corners.iter().all(is_inside) {
                let [a, b, c] = corners;
                let is_along = |[a, b]: [[Exact; 2]; 2]| {
                    directions.contains(&b.minus(a)) || directions.contains(&a.minus(b))
                };
                assert!(
                    [[a, b], [b, c], [c, a]].into_iter().all(is_along),
                    "{corners:?}"
                );
            }
        }
    }
}

/// The places (i, j) with i + j ≤ size, and the triangles between them.
fn triangular_lattice(size: i32) -> Mesh<[Exact; 2]> {
    let rows = || (0..=size).flat_map(move |j| (0..=size - j).map(move |i| [i, j]));
    let places: Vec<[i32; 2]> = rows().collect();
    let number = |place: [i32; 2]| {
        let found = places.iter().position(|&other| other == place);
        found.map(|number| u32::try_from(number).expect("a small mesh"))
    };
    let triangles = places.iter().flat_map(|&[i, j]| {
        [
            [[i, j], [i + 1, j], [i, j + 1]],
            [[i + 1, j], [i + 1, j + 1], [i, j + 1]],
        ]
    });
    let faces = triangles.filter_map(|[a, b, c]| Some([number(a)?, number(b)?, number(c)?]));
    let faces: Vec<_> = faces.collect();
    let points = places.iter().map(|place| place.map(|c| fraction(c, 1)));
    Mesh::new(points.collect(), faces).expect("the faces name places that are there")
}

/// The points in order of rows.
fn sorted(mut points: Vec<[Exact; 2]>) -> Vec<[Exact; 2]> {
    points.sort_by(|a, b| {
        [a[1], a[0]]
            .partial_cmp(&[b[1], b[0]])
            .expect("exact numbers are ordered")
    });
    points
}

/// **The boundary of √3.** The step that divides boundary edges by three makes of the boundary the ternary refinement of a uniform cubic B-spline: the mask is
/// $$\tfrac1{27}(1,4,10,16,19,16,10,4,1),\qquad\text{from } \tfrac1{27}(1+z+z^2)^4.$$
/// An old vertex has $\frac1{27}(4,19,4)$, a new point $\frac1{27}(1,16,10)$.
///
/// Course: D27, slide 78, Loop: boundaries.
#[test]
fn sqrt3_refines_the_boundary_as_a_cubic_b_spline() {
    let mut mask = vec![1];
    for _ in 0..4 {
        let at = |mask: &[i32], index: usize, back: usize| {
            index
                .checked_sub(back)
                .and_then(|i| mask.get(i).copied())
                .unwrap_or(0)
        };
        mask = (0..mask.len() + 2)
            .map(|i| at(&mask, i, 0) + at(&mask, i, 1) + at(&mask, i, 2))
            .collect();
    }
    assert_eq!(mask, [1, 4, 10, 16, 19, 16, 10, 4, 1]);
    let law = law("subdivision::sqrt3_refines_the_boundary_as_a_cubic_b_spline");
    law.holds(triangle_meshes(), hard_triangle_meshes(), |cage| {
        let first = Scheme::Sqrt3.step(&cage.mesh, 0, Corners::Smooth);
        let second = Scheme::Sqrt3.step(&first, 1, Corners::Smooth);
        let [before, kept, after] = [&cage.mesh, &first, &second].map(boundary_polygons);
        expect_same_cycles(&before, &kept)?;
        let ternary = |polygon: &Vec<[Exact; 3]>| {
            let n = i32::try_from(polygon.len()).expect("a small mesh");
            // The new point m has from the old point i the weight of z^(m − 3i + 4).
            let at = |m: i32| {
                let near = (m / 3 - 1)..=(m / 3 + 2);
                near.fold([Exact::zero(); 3], |sum, i| {
                    let exponent = usize::try_from(m - 3 * i + 4).ok();
                    let weight = exponent.and_then(|exponent| mask.get(exponent));
                    let weight = weight.map_or(Exact::zero(), |&w| fraction(w, 27));
                    let point = polygon[usize::try_from(i.rem_euclid(n)).expect("not negative")];
                    sum.plus(point.times(weight))
                })
            };
            (0..3 * n).map(at).collect::<Vec<_>>()
        };
        expect_same_cycles(&before.iter().map(ternary).collect::<Vec<_>>(), &after)
    });
}
