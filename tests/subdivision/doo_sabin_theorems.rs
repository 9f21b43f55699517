//! The theorems of a step of Doo-Sabin. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::subdivision::mask::{averaging_weight, doo_sabin_weight};
use facette::subdivision::{Connectivity, Corners, Counts, doo_sabin_with};
use num_traits::{One, Zero};
use proptest::prelude::*;

use crate::common::exact::{Exact, fraction};
use crate::common::generators::point;
use crate::common::law::{Law, Verdict, expect_equal};
use crate::meshes::{Cage, hard_meshes, hard_topologies, meshes, topologies};
use crate::nets::{Placed, grid_of, in_rows, quadratic_row, refined_rows};
use crate::plain_rules::Plain;
use crate::steps::{flat, rational_cosine};
use crate::suspects;

type Point = [Exact; 3];

fn law(theorem: &'static str) -> Law {
    Law::new(theorem, suspects::library)
}

/// The corner points of all faces, with the slides' weights.
fn corner_points(cage: &Cage<Point>) -> Vec<Point> {
    let joined = cage.connectivity();
    let points = &cage.mesh.positions;
    let refined = doo_sabin_with(&joined, points, Corners::Sharp, averaging_weight);
    refined.expect("a manifold").positions[..joined.half_edge_count()].to_vec()
}

/// **The slides' mean.** In a face of any number of corners, the new point of a corner $P$ is the mean of four points: $P$, the midpoints $E_1,E_2$ of its two sides, and the centroid $F$ of the face,
/// $P'=\frac14(P+E_1+E_2+F)$.
///
/// Course: D15, slide 68, Doo-Sabin: a mean of points of three kinds.
/// Erratum: the slide speaks of the simple mean of points of three *categories*. The mean of the three categories' means, $\frac13\bigl(P+\frac12(E_1+E_2)+F\bigr)$, would give $P$ the weight $\frac7{12}$ in a quadrilateral. The tensor product needs $\frac9{16}$: the mean of four *points*.
#[test]
fn doo_sabin_corner_is_the_mean_of_four_points() {
    let law = law("subdivision::doo_sabin_corner_is_the_mean_of_four_points");
    law.holds(meshes(), hard_meshes(), |cage| {
        let plain = Plain::new(&cage.mesh);
        let of_face = |face: &[u32]| {
            let places = 0..face.len();
            places
                .map(|place| plain.doo_sabin_corner(face, place))
                .collect::<Vec<_>>()
        };
        let expected: Vec<Point> = cage.mesh.faces().flat_map(of_face).collect();
        expect_equal(&expected, &corner_points(cage))
    });
    let [quarter, third] = [fraction(1, 4), fraction(1, 3)];
    let [half, of_centroid] = [fraction(1, 2), fraction(1, 4)];
    let four_points = quarter * (Exact::one() + half + half + of_centroid);
    let three_kinds = third * (Exact::one() + half + of_centroid);
    assert_eq!(
        [four_points, three_kinds],
        [fraction(9, 16), fraction(7, 12)]
    );
}

/// **Nine, three, three, one.** In a quadrilateral a corner's new point has the weights $\frac1{16}(9,3,1,3)$, counted round the face from that corner: the products of Chaikin's $\frac34$ and $\frac14$. The slides' mean and Doo's and Sabin's own weights agree there, and only there: in a triangle
/// the corner's own weight is $\frac7{12}$ by the mean and $\frac23$ by theirs, and in general $\frac12+\frac1{4n}$ and $\frac14+\frac5{4n}$.
///
/// Course: D13, slide 64, Doo-Sabin extends Chaikin's scheme.
/// Course: D16, slide 68, Doo-Sabin: faces with any number of corners.
/// Erratum: the slides extend the mean to faces of any number of corners and call the result Doo and Sabin's scheme. It is Catmull and Clark's variant; Doo's and Sabin's own weights are $\frac{n+5}{4n}$ and $\frac{3+2\cos(2\pi k/n)}{4n}$, equal to it for $n=4$ alone.
#[test]
fn both_doo_sabin_weights_agree_on_quadrilaterals_only() {
    let tensor = [9, 3, 1, 3].map(|sixteenths| fraction(sixteenths, 16));
    for (steps, weight) in tensor.into_iter().enumerate() {
        assert_eq!(averaging_weight::<Exact>(4, steps), weight);
        assert_eq!(
            doo_sabin_weight(4, steps, rational_cosine(steps, 4)),
            weight
        );
    }
    for n in (3..=200).filter(|&n| n != 4) {
        let size = i32::try_from(n).expect("a small face");
        let averaging = fraction(1, 2) + fraction(1, 4 * size);
        let own = fraction(1, 4) + fraction(5, 4 * size);
        assert_eq!(averaging_weight::<Exact>(n, 0), averaging);
        assert_eq!(doo_sabin_weight::<Exact>(n, 0, Exact::one()), own);
        assert_ne!(averaging, own);
    }
}

/// The nine points of the slides' matrix, sixteen times as large: rows are the first index.
#[rustfmt::skip]
fn sixteenfold(p: &[[Exact; 3]; 3], wrong_entry: bool) -> [[Exact; 3]; 3] {
    let [[p00, p01, p02], [p10, p11, p12], [p20, p21, p22]] = *p;
    let three = |x: Exact| x * fraction(3, 1);
    let printed = three(three(p01) + p11) + p02 + three(p12);
    let right = three(p01 + three(p11)) + p02 + three(p12);
    [
        [
            three(three(p00) + p10) + three(p01) + p11,
            three(p00) + p10 + three(three(p01) + p11),
            three(three(p01) + p11) + three(p02) + p12,
        ],
        [
            three(p00 + three(p10)) + p01 + three(p11),
            p00 + three(p10) + three(p01 + three(p11)),
            if wrong_entry { printed } else { right },
        ],
        [
            three(three(p10) + p20) + three(p11) + p21,
            three(p10) + p20 + three(three(p11) + p21),
            three(three(p11) + p21) + three(p12) + p22,
        ],
    ]
}

fn transposed(p: &[[Exact; 3]; 3]) -> [[Exact; 3]; 3] {
    [0, 1, 2].map(|i| p.map(|row| row[i]))
}

/// **The slides' matrix.** The nine control points of one quarter of a uniform biquadratic patch are $P'=QPQ^T$ with
/// $$Q=\tfrac14\begin{pmatrix}3&1&0\\1&3&0\\0&3&1\end{pmatrix},$$
/// and they are nine of the points of a step of Doo-Sabin on the $3\times3$ net. The construction does not prefer rows to columns, so transposing $P$ transposes $P'$.
///
/// Course: D14, slide 67, Doo-Sabin: the matrix of the new control points.
/// Erratum: the entry in row 2, column 3 must be $3(P_{01}+3P_{11})+P_{02}+3P_{12}$; printed is $3(3P_{01}+P_{11})+P_{02}+3P_{12}$. Its coefficients still sum to 16, so a test of the partition of unity does not see it; the symmetry does.
#[test]
fn doo_sabin_matrix_of_the_slides_is_symmetric_but_for_one_entry() {
    let law = law("subdivision::doo_sabin_matrix_of_the_slides_is_symmetric_but_for_one_entry");
    law.holds(grid_of(2, 2), grid_of(2, 2), |cage| {
        // The first coordinate stands for all.
        let net: [[Exact; 3]; 3] =
            std::array::from_fn(|i| [0, 1, 2].map(|j| cage.mesh.positions[3 * j + i][0]));
        let right = sixteenfold(&net, false);
        expect_equal(&transposed(&right), &sixteenfold(&transposed(&net), false))?;
        let refined = doo_sabin_with(
            &cage.connectivity(),
            &cage.mesh.positions,
            Corners::Sharp,
            averaging_weight,
        );
        let placed = refined.expect("a manifold").positions;
        // A step halves the spacing: the inner points of the refined grid stand at 1/4, 3/4, 5/4 and 7/4.
        let at = |i: i32, j: i32| {
            let place = [1 + 2 * i, 1 + 2 * j].map(|quarters| fraction(quarters, 4));
            let found = placed.iter().find(|point: &&Placed| point[3..] == place);
            found.expect("a point of each place")[0] * fraction(16, 1)
        };
        expect_equal(&right, &[0, 1, 2].map(|i| [0, 1, 2].map(|j| at(i, j))))
    });
    let mut net = [[Exact::zero(); 3]; 3];
    net[1][1] = Exact::one();
    let [printed, other] = [net, transposed(&net)].map(|net| sixteenfold(&net, true));
    assert_ne!(transposed(&printed), other);
    assert_eq!(
        (printed[1][2], printed[2][1]),
        (fraction(3, 1), fraction(9, 1))
    );
}

/// **A biquadratic B-spline on a grid.** On a grid of quadrilaterals a step of Doo-Sabin is Chaikin's step along the rows, then along the columns, with the mask $\frac14(1,3,3,1)$: the midpoint insertion of a uniform
/// biquadratic B-spline. At the boundary, with sharp corners, it is that of a net whose outer rows and columns stand twice. So the limit there is the uniform quadratic B-spline of the boundary, and it passes through the corners.
///
/// Course: D13, slide 64, Doo-Sabin extends Chaikin's scheme.
#[test]
fn doo_sabin_on_a_grid_is_the_biquadratic_b_spline() {
    let law = law("subdivision::doo_sabin_on_a_grid_is_the_biquadratic_b_spline");
    let grids = (1..5_u32, 1..5_u32).prop_flat_map(|(columns, rows)| grid_of(columns, rows));
    let thin = (1..6_u32).prop_flat_map(|columns| grid_of(columns, 1));
    law.holds(grids, thin, |cage| {
        let points = &cage.mesh.positions;
        let refined = doo_sabin_with(
            &cage.connectivity(),
            points,
            Corners::Sharp,
            averaging_weight,
        );
        let expected = refined_rows(&in_rows(points), quadratic_row);
        expect_equal(&expected, &in_rows(&refined.expect("a manifold").positions))
    });
}

/// **Faces, edges, vertices.** A step of Doo-Sabin makes a face of each face, each edge and each vertex: a face keeps its number of corners, an edge gives a quadrilateral, a vertex of valence $n$ an $n$-gon. On a closed mesh
/// $$V'=2E,\qquad E'=4E,\qquad F'=F+E+V,$$
/// and all new vertices have valence 4. So after one step the irregular places are faces: one for each face that is no quadrilateral, and one for each vertex of another valence than 4.
///
/// Course: D17, slides 69-70, Doo-Sabin: how the new points are joined.
/// Erratum: the slides join the points for each face and for each old vertex. The quadrilaterals between them, one for each edge, are faces too; without them the mesh has holes.
#[test]
fn doo_sabin_makes_a_face_of_each_face_edge_and_vertex() {
    let law = law("subdivision::doo_sabin_makes_a_face_of_each_face_edge_and_vertex");
    law.holds(topologies(), hard_topologies(), |topology| {
        let (mesh, joined) = (flat(topology), topology.connectivity());
        let refined = doo_sabin_with(&joined, &mesh.positions, Corners::Smooth, averaging_weight);
        let refined = refined.expect("a manifold");
        let finer = Connectivity::new(&refined).expect("a step leaves a manifold");
        let vertices = (0..).take(joined.vertex_count());
        let inner = vertices.filter(|&v| !joined.is_boundary_vertex(v));
        let of_vertices: Vec<usize> = (0..)
            .take(joined.vertex_count())
            .map(|v| joined.around(v).count() + 2 * usize::from(joined.is_boundary_vertex(v)))
            .filter(|&corners| corners > 2)
            .collect();
        let of_faces = mesh.faces().map(<[u32]>::len);
        let of_edges = std::iter::repeat_n(4, joined.edge_count());
        let expected: Vec<usize> = of_faces.chain(of_edges).chain(of_vertices).collect();
        expect_equal(&expected, &refined.faces().map(<[u32]>::len).collect())?;
        let counts = Counts::of(&joined);
        let has_spur = inner.into_iter().any(|v| joined.valence(v) == 2);
        if counts.boundary_edges > 0 || counts.isolated > 0 || has_spur {
            return Ok(());
        }
        expect_closed(counts, &finer)
    });
}

fn expect_closed(before: Counts, finer: &Connectivity) -> Verdict {
    let after = Counts::of(finer);
    let expected = [
        2 * before.edges,
        4 * before.edges,
        before.faces + before.edges + before.vertices,
    ];
    expect_equal(&expected, &[after.vertices, after.edges, after.faces])?;
    for vertex in (0..).take(finer.vertex_count()) {
        expect_equal(&4, &finer.valence(vertex))?;
    }
    Ok(())
}

/// **Faces do not drift.** With either weights the centroid of a shrunken face is the centroid of the face. So at every step the extraordinary face has the same centre.
///
/// Course: D16, slide 68, Doo-Sabin: faces with any number of corners.
#[test]
fn doo_sabin_keeps_the_centroid_of_every_face() {
    let law = law("subdivision::doo_sabin_keeps_the_centroid_of_every_face");
    // Valences with rational cosines, for Doo's and Sabin's own weights.
    let faces = || prop_oneof![Just(3_usize), Just(4), Just(6)];
    let polygons = || faces().prop_flat_map(|n| proptest::collection::vec(point(), n));
    let flat_polygons = (faces(), point()).prop_map(|(n, p)| vec![p; n]);
    law.holds(polygons(), flat_polygons, |points| {
        let n = points.len();
        let topology = crate::meshes::polygon(u32::try_from(n).expect("a small face"));
        let joined = topology.connectivity();
        let own = |n, steps| doo_sabin_weight(n, steps, rational_cosine(steps, n));
        let weights: [&dyn Fn(usize, usize) -> Exact; 2] = [&averaging_weight, &own];
        let sum = |points: &[Point]| {
            points
                .iter()
                .copied()
                .fold([Exact::zero(); 3], VectorSpace::plus)
        };
        for weight in weights {
            let refined = doo_sabin_with(&joined, points, Corners::Smooth, weight);
            let refined = refined.expect("a manifold").positions;
            expect_equal(&sum(points), &sum(&refined[..n]))?;
        }
        Ok(())
    });
}
