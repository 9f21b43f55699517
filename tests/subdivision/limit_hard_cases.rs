//! Meshes at which a limit is easily got wrong, with the right answers.

use facette::algebra::{Real, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    catmull_clark_distance_bound, catmull_clark_eigenvalues, catmull_clark_limits,
    doo_sabin_eigenvalues, doo_sabin_limits, loop_distance_bound, loop_limits, sqrt3_limits,
};
use facette::subdivision::{Connectivity, Corners, DooSabinWeights, SubdivisionError};

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::limit_inputs::{
    VALENCES, degrees, face_normal, half_fan, joined, limits, limits_with, neighbourhood,
    rational_circle, refined,
};
use crate::meshes::{
    cube, double_fan, octahedron, polygon, quad_fan, tetrahedron, with_isolated_vertex,
};
use crate::steps::Scheme;

/// **Limits of the regular solids.** The corner $0$ of the cube $[0,1]^3$ has the Catmull-Clark limit $\left(\tfrac14,\tfrac14,\tfrac14\right)$. The vertex 0 of the tetrahedron $0,4e_1,4e_2,4e_3$ goes to $\tfrac79(1,1,1)$ with Catmull-Clark, $\tfrac45(1,1,1)$ with Loop, $\tfrac56(1,1,1)$ with $\sqrt3$; the
/// vertex $e_1$ of the octahedron to $\tfrac{24}{55}e_1$ with Loop and $\tfrac37e_1$ with $\sqrt3$.
#[test]
fn limits_of_the_regular_solids() {
    let circle = |k, n| rational_circle(k, n).expect("valence 3 or 4");
    let limit = |scheme, mesh: &Mesh<[Exact; 3]>| {
        limits_with(scheme, mesh, Corners::Sharp, circle, |x| x)[0].position
    };
    let all = |numerator, denominator| [fraction(numerator, denominator); 3];
    // The cube has its corner at −1 and a side of 2.
    assert_eq!(limit(Scheme::CatmullClark, &cube()), all(-1, 2));
    assert_eq!(limit(Scheme::CatmullClark, &tetrahedron()), all(7, 9));
    assert_eq!(limit(Scheme::Loop, &tetrahedron()), all(4, 5));
    assert_eq!(limit(Scheme::Sqrt3, &tetrahedron()), all(5, 6));
    let on_axis = |numerator, denominator| {
        [
            fraction(numerator, denominator),
            fraction(0, 1),
            fraction(0, 1),
        ]
    };
    assert_eq!(limit(Scheme::Loop, &octahedron()), on_axis(24, 55));
    assert_eq!(limit(Scheme::Sqrt3, &octahedron()), on_axis(3, 7));
}

/// A cone with its tip at vertex 0, whose neighbours lie on a tilted circle with one of them lifted.
fn lopsided(scheme: Scheme, n: u32) -> Mesh<[f64; 3]> {
    let topology = if scheme == Scheme::CatmullClark {
        quad_fan(n)
    } else {
        double_fan(n)
    };
    let place = |vertex: usize| {
        let Some(k) = vertex.checked_sub(1) else {
            return [0.0, 0.0, 0.5];
        };
        let [ring, k] = [k / n as usize, k % n as usize];
        let angle = 2.0 * f64::pi() * (k as f64 + 0.5 * ring as f64) / f64::from(n);
        let radius = 1.0 + ring as f64;
        let lift = if k == 0 {
            0.4
        } else {
            0.1 * (2.0 * angle).cos()
        };
        [radius * angle.cos(), radius * angle.sin(), lift]
    };
    topology.with_points((0..topology.vertex_count).map(place).collect())
}

/// **Many steps are not the limit.** At valence 100 twelve steps of Catmull-Clark leave $\mu_+^{12}=0.45\,\%$ of the way to the limit point, and the facets around the vertex are still 22 degrees off the normal, since $\mu/\lambda=0.9987$: they come nearer by a seventh of a percent in each step. The masks
/// give both at once. And a mesh that has been refined twelve times has the limit of the first one to within 12 ulps: the steps themselves do not drift.
#[test]
fn many_steps_are_not_the_limit() {
    let scheme = Scheme::CatmullClark;
    let mesh = lopsided(scheme, 100);
    let limit = limits(scheme, &mesh, Corners::Sharp)[0];
    let normal = limit.normal().expect("a cone has a normal at its tip");
    let mut fine = mesh.clone();
    for step in 0..12 {
        fine = neighbourhood(
            &refined(scheme, &fine, step..step + 1, Corners::Sharp),
            0,
            2,
        );
    }
    let start = mesh.positions[0].minus(limit.position).largest_coordinate();
    let left = fine.positions[0].minus(limit.position).largest_coordinate() / start;
    assert!((0.0044..0.0046).contains(&left), "{left}");
    let around = fine.faces().filter(|face| face.contains(&0));
    let angles = around.map(|face| degrees(face_normal(&fine, face), normal));
    let worst = angles.fold(0.0, f64::max);
    println!("{worst:.2} degrees off after 12 steps");
    assert!((20.0..25.0).contains(&worst));
    let again = limits(scheme, &fine, Corners::Sharp)[0];
    let drift = again.position.minus(limit.position).largest_coordinate();
    assert!(drift <= 12.0 * f64::EPSILON / 2.0, "{drift:e}");
    assert!(degrees(again.normal().expect("as before"), normal) < 1e-10);
}

/// **Twelve levels, no drift.** Refine the neighbourhood of a vertex twelve times, at every valence from 3 to 200 and in every scheme: the limit of what is left is the limit of the control mesh, within $12\cdot2\mathbf u$ of the coordinates' size.
#[test]
fn twelve_levels_do_not_drift() {
    for n in VALENCES {
        for scheme in [Scheme::CatmullClark, Scheme::Loop, Scheme::Sqrt3] {
            let mesh = lopsided(scheme, n);
            let limit = limits(scheme, &mesh, Corners::Sharp)[0].position;
            let mut fine = mesh.clone();
            for step in 0..12 {
                // The part that is cut out has a boundary, which must not come near: its rule is the first step's every time.
                let step = if scheme == Scheme::Sqrt3 { 0 } else { step };
                fine = neighbourhood(
                    &refined(scheme, &fine, step..step + 1, Corners::Sharp),
                    0,
                    2,
                );
            }
            let again = limits(scheme, &fine, Corners::Sharp)[0].position;
            let drift = again.minus(limit).largest_coordinate();
            assert!(
                drift <= 24.0 * f64::EPSILON / 2.0,
                "{scheme:?} {n}: {drift:e}"
            );
        }
    }
}

/// **Far away and very small.** The normals of a mesh with coordinates that are multiples of $2^{-20}$ are the same bits when it is moved by $2^{27}$ along every axis; and the same bits when it is scaled by $2^{-900}$ or $2^{900}$, where squares of lengths would underflow or overflow.
#[test]
fn normals_do_not_depend_on_place_and_size() {
    for n in VALENCES {
        for scheme in [Scheme::CatmullClark, Scheme::Loop, Scheme::Sqrt3] {
            let rounded = |p: [f64; 3]| p.map(|c| (c * 1_048_576.0).round() / 1_048_576.0);
            let mesh = lopsided(scheme, n);
            let mapped = |map: &dyn Fn(f64) -> f64| {
                let points = mesh.positions.iter().map(|&p| rounded(p).map(map));
                let mesh = Mesh::new(points.collect(), mesh.faces()).expect("finite points");
                limits(scheme, &mesh, Corners::Sharp)[0].normal()
            };
            let normal = mapped(&|c| c);
            assert!(normal.is_some());
            assert_eq!(
                mapped(&|c| c + 134_217_728.0),
                normal,
                "{scheme:?} {n}: moved"
            );
            for size in [2.0_f64.powi(-900), 2.0_f64.powi(900)] {
                assert_eq!(
                    mapped(&|c| c * size),
                    normal,
                    "{scheme:?} {n}: scaled by {size:e}"
                );
            }
        }
    }
}

/// **No face, no extent, no area.** A vertex that no face visits is its own limit and has no tangents. Where all points are one, the limit is that point, the tangents are zero and there is no normal; nor where all points are on a line. A vertex between two quadrilaterals that share both its edges has a limit and no tangents.
#[test]
fn normal_is_none_where_there_is_none() {
    let topology = with_isolated_vertex(double_fan(5));
    let last = topology.vertex_count - 1;
    let one_point = topology.with_points(vec![[0.1, 0.2, 0.3]; last + 1]);
    let on_a_line = (0..=last).map(|k| [k as f64, 2.0 * k as f64, -(k as f64)]);
    let on_a_line = topology.with_points(on_a_line.collect());
    for scheme in [Scheme::CatmullClark, Scheme::Loop, Scheme::Sqrt3] {
        let at = limits(scheme, &one_point, Corners::Sharp);
        assert!(at.iter().all(|limit| limit.position == [0.1, 0.2, 0.3]));
        assert_eq!(at[0].tangents, Some([[0.0; 3]; 2]));
        assert_eq!((at[last].tangents, at[0].normal()), (None, None));
        assert_eq!(limits(scheme, &on_a_line, Corners::Sharp)[0].normal(), None);
    }
    let folded = quad_fan(2).with_points(vec![
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 1.0, 1.0],
    ]);
    let limit = limits(Scheme::CatmullClark, &folded, Corners::Sharp)[0];
    assert_eq!(limit.tangents, None);
    let face = polygon(4).with_points(vec![[0.5; 3]; 4]);
    let limits = doo_sabin_limits(&joined(&face), &face.positions).expect("four points");
    assert_eq!(limits[0].normal(), None);
}

/// **What is no mesh of triangles, or has other points, is refused.** The message names the face, or the two counts.
#[test]
fn limits_of_the_wrong_mesh_are_refused() {
    let square = polygon(4).with_points(vec![[0.0_f64; 3]; 4]);
    let joined = Connectivity::new(&square).expect("a face");
    let not_a_triangle = Err(SubdivisionError::NotATriangle { face: 0, found: 4 });
    assert_eq!(
        loop_limits(&joined, &square.positions, Corners::Sharp),
        not_a_triangle
    );
    assert_eq!(
        sqrt3_limits(&joined, &square.positions, Corners::Sharp),
        not_a_triangle
    );
    let three = &square.positions[..3];
    let miscounted = Err(SubdivisionError::PointCount {
        found: 3,
        expected: 4,
    });
    assert_eq!(
        catmull_clark_limits(&joined, three, Corners::Sharp),
        miscounted
    );
    assert_eq!(doo_sabin_limits(&joined, three), miscounted);
}

/// **A corner that points inwards.** A single face with a re-entrant sharp corner, a dart: the limit stays in the corner, and its tangents are the two sides. Near it the surface fills the angle *between the sides* that is less than half a turn, not the face's: it is folded over, and its normal is the opposite of the face's. A scheme
/// with a rule for concave corners would be needed to avoid that.
#[test]
fn reentrant_sharp_corner_is_folded_over() {
    let dart = vec![
        [0.0, 0.0, 0.0],
        [-1.0, -1.0, 0.0],
        [2.0, 0.0, 0.0],
        [-1.0, 1.0, 0.0],
    ];
    let mesh = polygon(4).with_points(dart);
    assert_eq!(
        face_normal(
            &polygon(3).with_points(vec![
                mesh.positions[1],
                mesh.positions[2],
                mesh.positions[3]
            ]),
            &[0, 1, 2]
        ),
        [0.0, 0.0, 1.0]
    );
    let limit = limits(Scheme::CatmullClark, &mesh, Corners::Sharp)[0];
    assert_eq!(limit.position, [0.0; 3]);
    assert_eq!(limit.tangents, Some([[-1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]]));
    assert_eq!(limit.normal(), Some([0.0, 0.0, -1.0]));
    let mut fine = mesh;
    for step in 0..6 {
        fine = neighbourhood(
            &refined(Scheme::CatmullClark, &fine, step..step + 1, Corners::Sharp),
            0,
            3,
        );
    }
    let at_corner = fine.faces().find(|face| face.contains(&0)).expect("a face");
    assert_eq!(face_normal(&fine, at_corner), [0.0, 0.0, -1.0]);
}

/// **A rounded corner of one face.** With smooth corners the boundary is a smooth curve, and a vertex with a single face lies on it. There Catmull-Clark's matrix has the eigenvalue $\frac14$ twice with one eigenvector only, and the surface's tangent plane is the *osculating plane* of the boundary curve, spanned by its tangent and its second difference. The
/// facets come to it as slowly as $1/k$: the product of $k$ and their angle to it settles at a constant. Loop's corner has nothing but the two sides, and the plane is that of the triangle.
#[test]
fn rounded_corner_lies_in_the_osculating_plane() {
    // The tangent is along x, the second difference along y: each coordinate keeps its digits however small it becomes.
    let points = vec![
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 2.0, 1.5],
        [-1.0, 1.0, 0.0],
    ];
    let mesh = polygon(4).with_points(points);
    let limit = limits(Scheme::CatmullClark, &mesh, Corners::Smooth)[0];
    assert_eq!(limit.normal(), Some([0.0, 0.0, 1.0]));
    let mut fine = mesh;
    let mut products = Vec::new();
    for step in 0..400_u32 {
        fine = neighbourhood(
            &refined(Scheme::CatmullClark, &fine, 0..1, Corners::Smooth),
            0,
            3,
        );
        let limit = limits(Scheme::CatmullClark, &fine, Corners::Smooth)[0].position;
        let at_corner = fine.faces().find(|face| face.contains(&0)).expect("a face");
        let angle = degrees(face_normal(&fine, at_corner), [0.0, 0.0, 1.0]);
        products.push(f64::from(step + 1) * angle);
        // Moved to the origin and doubled, it keeps its angles, and its digits.
        let points = fine.positions.iter().map(|p| p.minus(limit).times(2.0));
        fine = Mesh::new(points.collect(), fine.faces()).expect("the same faces");
    }
    println!(
        "{:.2} {:.2} {:.2}",
        products[49], products[199], products[399]
    );
    let [before, last] = [products[199], products[399]];
    assert!(
        (last / before - 1.0).abs() < 0.02 && last > 50.0,
        "{before} {last}"
    );
    let triangle = polygon(3).with_points(vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
    let limit = limits(Scheme::Loop, &triangle, Corners::Smooth)[0];
    assert_eq!(limit.normal(), Some([0.0, 0.0, 1.0]));
    assert_eq!(limit.position, [1.0 / 3.0, 1.0 / 3.0, 0.0]);
}

/// **Inner corners of an open mesh are rounded.** A boundary vertex with several faces is no corner, whatever the angle: in an L of three squares the re-entrant vertex moves to $\frac16(e_-+4v+e_+)$ and the boundary is smooth there. The tangent across points into the mesh.
#[test]
fn concave_boundary_vertex_is_rounded() {
    let fan = half_fan(3, true);
    // The L around the origin: from (0, −1) anticlockwise over (1, 0) and (0, 1) to (−1, 0).
    let spokes = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
    let opposite = [[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let points = std::iter::once([0.0, 0.0]).chain(spokes).chain(opposite);
    let mesh = fan.with_points(points.map(|[x, y]| [x, y, 0.0]).collect());
    let limit = limits(Scheme::CatmullClark, &mesh, Corners::Sharp)[0];
    let [along, across] = limit.tangents.expect("three faces");
    assert_eq!(limit.position, [-1.0 / 6.0, -1.0 / 6.0, 0.0]);
    assert_eq!(along, [0.5, -0.5, 0.0]);
    assert!(across[0] > 0.0 && (across[0] - across[1]).abs() < 4.0 * f64::EPSILON);
    assert_eq!(limit.normal(), Some([0.0, 0.0, 1.0]));
}

/// **Doo-Sabin at $n=3$ and $n=20$.** With averaging $\lambda=\frac38$ at $n=3$, and the rest shrinks by $\frac23$ of that; at $n=20$ $\lambda=0.7378$ and the third eigenvalue is 0.7023: the face becomes flat by a factor of only 0.952 in a round. With Doo's and Sabin's own weights it is $\frac12$ at both.
#[test]
fn doo_sabin_becomes_flat_at_its_rate() {
    let rate = |n, weights| {
        let eigenvalues = doo_sabin_eigenvalues::<f64>(n, weights);
        eigenvalues.next / eigenvalues.tangent
    };
    assert!((rate(3, DooSabinWeights::Averaging) - 2.0 / 3.0).abs() < 1e-15);
    assert!((rate(20, DooSabinWeights::Averaging) - 0.952).abs() < 5e-4);
    for n in [3, 5, 8, 20] {
        assert_eq!(rate(n, DooSabinWeights::Own), 0.5);
    }
    // A polygon of 20 corners at random heights: its distance from a plane, over its size, round after round.
    let mut dice = Dice::new(7);
    let points = (0..20).map(|k| {
        let angle = 2.0 * f64::pi() * f64::from(k) / 20.0;
        [angle.cos(), angle.sin(), dice.roll()]
    });
    let mut mesh = polygon(20).with_points(points.collect());
    let mut parts = Vec::new();
    for step in 0..60 {
        let limit = doo_sabin_limits(&joined(&mesh), &mesh.positions).expect("points")[0];
        let normal = limit.normal().expect("a flat limit");
        let height = |p: &[f64; 3]| {
            use facette::algebra::Vector3;
            p.minus(limit.position).dot(normal).abs()
        };
        let highest = mesh.positions.iter().map(height).fold(0.0, f64::max);
        let widest = mesh
            .positions
            .iter()
            .map(|p| p.minus(limit.position).largest_coordinate());
        parts.push(highest / widest.fold(0.0, f64::max));
        let scheme = Scheme::DooSabin(DooSabinWeights::Averaging);
        let next = refined(scheme, &mesh, step..step + 1, Corners::Sharp);
        mesh = polygon(20).with_points(next.positions[..20].to_vec());
    }
    let measured = (parts[59] / parts[49]).powf(0.1);
    assert!((measured - 0.9519).abs() < 1e-3, "{measured}");
}

/// **Eigenvalues of extreme valences.** At $n=3$ the smaller eigenvalue of the vertex in Catmull-Clark is exactly 0: the formula would subtract a root from its equal. It is computed as $\frac{n-3}{16n}$ over the larger one. At a million neighbours both are next to $\frac18(3\pm\sqrt5)$, and $\lambda$ is still the larger of $\lambda$ and $\mu$.
#[test]
fn eigenvalues_of_extreme_valences() {
    use facette::subdivision::limit::catmull_clark_vertex_eigenvalues;
    assert_eq!(catmull_clark_vertex_eigenvalues::<f64>(3), [1.0 / 6.0, 0.0]);
    let [larger, smaller] = catmull_clark_vertex_eigenvalues::<f64>(1_000_000);
    assert!((larger - (3.0 + 5.0_f64.sqrt()) / 8.0).abs() < 1e-5);
    assert!((smaller - (3.0 - 5.0_f64.sqrt()) / 8.0).abs() < 1e-5);
    let eigenvalues = catmull_clark_eigenvalues::<f64>(1_000_000);
    assert!(eigenvalues.next < eigenvalues.tangent && eigenvalues.tangent < 0.654_51);
}

/// **What has no bound is refused.** With Catmull-Clark the bound is for quadrilaterals, which a first step makes of any faces; with Loop it is for triangles. The first face that is neither is named.
#[test]
fn bound_is_for_quadrilaterals_or_triangles() {
    let triangle = polygon(3).with_points(vec![[0.0_f64; 3]; 3]);
    let square = polygon(4).with_points(vec![[0.0_f64; 3]; 4]);
    let refused =
        catmull_clark_distance_bound(&joined(&triangle), &triangle.positions, Corners::Sharp);
    assert_eq!(
        refused,
        Err(SubdivisionError::NotAQuadrilateral { face: 0, found: 3 })
    );
    let refused = loop_distance_bound(&joined(&square), &square.positions, Corners::Sharp);
    assert_eq!(
        refused,
        Err(SubdivisionError::NotATriangle { face: 0, found: 4 })
    );
}
