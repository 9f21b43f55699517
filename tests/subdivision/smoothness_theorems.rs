//! How smooth the limit surfaces are at extraordinary points: what the eigenvalues promise, seen in meshes.

use facette::algebra::{Real, Vector3, VectorSpace, unit_vector};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Eigenvalues, catmull_clark_eigenvalues, catmull_clark_ring_eigenvalues, doo_sabin_eigenvalues,
    doo_sabin_limits, loop_eigenvalues, loop_ring_eigenvalue, loop_vertex_eigenvalue,
    sqrt3_eigenvalues,
};
use facette::subdivision::mask::{loop_vertex_weight, turn_cosine};
use facette::subdivision::{Corners, DooSabinWeights, loop_subdivision_with};

use crate::common::dice::Dice;
use crate::common::exact::fraction;
use crate::limit_inputs::{
    centred, degrees, face_normal, half_fan, hilly, joined, levels, neighbourhood, refined,
};
use crate::meshes::pyramid;
use crate::steps::Scheme;

type Point = [f64; 3];

/// The largest angle between the normals of two of the faces that are at most two away from vertex 0, in degrees.
fn spread(mesh: &Mesh<Point>) -> f64 {
    let near = neighbourhood(mesh, 0, 2);
    spread_of(
        &near
            .faces()
            .map(|face| face_normal(&near, face))
            .collect::<Vec<_>>(),
    )
}

fn spread_of(normals: &[Point]) -> f64 {
    let pairs = normals.iter().enumerate();
    let pairs = pairs.flat_map(|(k, &a)| normals[k + 1..].iter().map(move |&b| degrees(a, b)));
    pairs.fold(0.0, f64::max)
}

/// **Tangent planes exist.** Around an interior vertex of any valence the facets' normals of Catmull-Clark, Loop and $\sqrt3$ come together, whatever the heights of the control points: the angle between any two of them shrinks like $(\mu/\lambda)^k$. So the surfaces are tangent-plane continuous at extraordinary points. Seen here over
/// twelve levels at $n=3,\dots,20$: in the last four the angle shrinks by the fourth power of that ratio, within 30 %, or faster.
///
/// Course: D24, slide 77, Loop is C1 at extraordinary points.
#[test]
fn normals_come_together_at_every_valence() {
    for n in [3, 4, 5, 6, 7, 8, 12, 20] {
        let schemes = [
            (
                Scheme::CatmullClark,
                catmull_clark_eigenvalues::<f64>(n as usize),
            ),
            (Scheme::Loop, loop_eigenvalues(n as usize)),
            (Scheme::Sqrt3, sqrt3_eigenvalues(n as usize)),
        ];
        for (scheme, Eigenvalues { tangent, next }) in schemes {
            let spreads: Vec<f64> = levels(scheme, &hilly(scheme, n, 5), 12)
                .iter()
                .map(spread)
                .collect();
            let expected = (next / tangent).powi(4);
            let got = spreads[12] / spreads[8];
            assert!(
                got <= 1.3 * expected,
                "{scheme:?} {n}: {got} instead of {expected}"
            );
            assert!(
                got >= 0.2 * expected,
                "{scheme:?} {n}: {got} instead of {expected}"
            );
        }
    }
}

/// The face of a mesh with the given number and the faces at its corners, of which it is the first.
fn around_face(mesh: &Mesh<Point>, face: usize) -> Mesh<Point> {
    let faces: Vec<&[u32]> = mesh.faces().collect();
    let mut order = faces.clone();
    order.swap(0, face);
    let reordered = Mesh::new(mesh.positions.clone(), order).expect("the same faces");
    let near = |other: &&[u32]| other.iter().any(|v| faces[face].contains(v));
    let kept: Vec<Vec<u32>> = reordered
        .faces()
        .filter(near)
        .map(<[u32]>::to_vec)
        .collect();
    let mut numbers = std::collections::HashMap::new();
    let mut points = Vec::new();
    let mut number = |v: u32| {
        *numbers.entry(v).or_insert_with(|| {
            points.push(mesh.positions[v as usize]);
            u32::try_from(points.len() - 1).expect("a small mesh")
        })
    };
    let renumbered: Vec<Vec<u32>> = kept
        .iter()
        .map(|face| face.iter().map(|&v| number(v)).collect())
        .collect();
    Mesh::new(points, renumbered).expect("a part of a mesh")
}

/// The largest angle between normals of faces around the n-gon that Doo-Sabin makes of a pyramid's tip, after 1, 2, ... rounds.
fn angles_around_the_tip(n: u32, weights: DooSabinWeights, rounds: u32) -> Vec<f64> {
    let base = (0..n).map(|k| {
        let angle = 2.0 * f64::pi() * f64::from(k) / f64::from(n);
        let lift = if k == 0 { 0.5 } else { 0.0 };
        [angle.cos(), angle.sin(), lift]
    });
    let points = base.chain([[0.0, 0.0, 1.0]]).collect();
    let cage = pyramid(n).with_points(points);
    let scheme = Scheme::DooSabin(weights);
    let first = refined(scheme, &cage, 0..1, Corners::Sharp);
    // The tip is the last vertex, and its face the last one.
    let mut mesh = around_face(&first, first.face_count() - 1);
    let mut angles = Vec::new();
    for round in 0..rounds {
        let normals: Vec<Point> = mesh.faces().map(|face| face_normal(&mesh, face)).collect();
        angles.push(spread_of(&normals));
        let next = refined(scheme, &mesh, round..round + 1, Corners::Sharp);
        let near = around_face(&next, 0);
        let tip =
            doo_sabin_limits(&joined(&near), &near.positions).expect("a point for each vertex")[0];
        mesh = centred(&near, tip.position);
    }
    angles
}

/// **Doo-Sabin is C1 everywhere.** At the tip of a pyramid, an extraordinary vertex of valence $n$, Doo-Sabin makes an $n$-gon that shrinks to a point. The angles between the normals of the faces around it go to zero, with either kind of weights, and each round multiplies them by $\mu/\lambda$: by $\frac12$ with Doo's and Sabin's weights at every $n$; with averaging by
/// $\frac23$ at $n=3$, $0.516$ at 5, $0.739$ at 8 and $0.952$ at 20. There is one tangent plane in the limit. With Doo's and Sabin's weights the angles in degrees after 1, 2, ... 7 rounds are 96.0, 63.0, 41.4, 23.5, 12.5, 6.4, 3.3 at $n=5$ for the pyramid of this test.
///
/// Course: D18, slide 71, Doo-Sabin at extraordinary points.
/// Erratum: the slide says that the surface is $C^1$ except at the extraordinary points, where it is $C^0$. It is tangent-plane continuous there too. And the extraordinary points do not belong to vertices of valence $\ne4$ alone: every face that is no quadrilateral has one as well. After one step all vertices have valence 4, and the only irregularities are $n$-gons.
#[test]
fn doo_sabin_is_tangent_continuous_at_extraordinary_points() {
    for n in [3, 5, 8, 20] {
        for weights in [DooSabinWeights::Own, DooSabinWeights::Averaging] {
            let Eigenvalues { tangent, next } = doo_sabin_eigenvalues::<f64>(n as usize, weights);
            let angles = angles_around_the_tip(n, weights, 60);
            println!("{n} {weights:?}: {:.1?}", &angles[..7]);
            let rate = (angles[39] / angles[29]).powf(0.1);
            assert!(
                // Where ¼ has fewer eigenvectors than its multiplicity, the rate is approached like 1 + 1/k.
                (rate / (next / tangent) - 1.0).abs() < 0.035,
                "{n} {weights:?}: {rate}"
            );
        }
    }
    // The rest of the erratum: after a step all vertices have valence 4, and an n-gon stays an n-gon.
    let cage = pyramid(5).with_points(vec![[0.0; 3]; 6]);
    let fine = refined(
        Scheme::DooSabin(DooSabinWeights::Own),
        &cage,
        0..1,
        Corners::Sharp,
    );
    let joined_fine = joined(&fine);
    assert!(
        (0..fine.positions.len())
            .all(|v| joined_fine.valence(u32::try_from(v).expect("small")) == 4)
    );
    let pentagons = fine.faces().filter(|face| face.len() == 5).count();
    assert_eq!(pentagons, 2);
    assert_eq!(
        doo_sabin_limits(&joined_fine, &fine.positions)
            .expect("points")
            .len(),
        fine.face_count()
    );
}

/// **The weight of valence 6 does not serve for 3.** With $\alpha=\frac58$ at a vertex of valence 3 the eigenvalue of the vertex is $\alpha-\frac38=\frac14$, and so is $\lambda$: heights shrink no faster than lengths, and what was a tip remains a tip. Fifteen levels on, the facets around it still make the angle of a cone, where Loop's own weight makes them flat.
///
/// Course: D25, slide 78, Loop at irregular vertices: the unmodified rule is not smooth.
#[test]
fn weight_of_valence_six_leaves_a_tip_at_valence_three() {
    let unmodified = fraction(5, 8);
    let c = fraction(-1, 2);
    assert_eq!(loop_vertex_eigenvalue(unmodified), fraction(1, 4));
    assert_eq!(loop_ring_eigenvalue(c), fraction(1, 4));
    assert_eq!(
        loop_vertex_eigenvalue(loop_vertex_weight(c)),
        fraction(1, 16)
    );
    let tip = |weight: &dyn Fn(usize) -> f64| {
        let mut mesh = hilly(Scheme::Loop, 3, 5);
        mesh.positions[0] = [0.0, 0.0, 4.0];
        for _ in 0..20 {
            let fine =
                loop_subdivision_with(&joined(&mesh), &mesh.positions, Corners::Sharp, weight);
            mesh = neighbourhood(&fine.expect("a small mesh"), 0, 3);
        }
        spread(&mesh)
    };
    let sharp = tip(&|n| {
        if n == 3 {
            0.625
        } else {
            loop_vertex_weight(turn_cosine(1, n))
        }
    });
    let smooth = tip(&|n| loop_vertex_weight(turn_cosine(1, n)));
    println!("{sharp:.1} degrees against {smooth:.5}");
    assert!(sharp > 30.0 && smooth < 0.1);
}

/// **Too many faces on a boundary.** The boundary's own tangent has the eigenvalue $\frac12$, whatever is inside. With $k$ faces at the vertex, waves of half a turn have the eigenvalue $\lambda$ of valence $2k$, whole turns that of valence $k$. The second must be less than $\frac12$, or there is no tangent plane: it is for $k\le3$ quadrilaterals and
/// $k\le5$ triangles, and not for more. Seen here: the normals at such a vertex come together for 2 and 3 quadrilaterals and for 2 and 4 triangles; for 5 quadrilaterals and for 7 triangles they do not in forty levels.
///
/// Course: D27, slide 78, boundaries by the cubic rule: their smoothness.
/// Erratum: the slide takes the cubic rule for the border, and no more. It is right for the border itself, but a border vertex with four quadrilaterals or six triangles and more is not smooth with it, and a single sharp corner is rounded off unless it is kept. Biermann, Levin and Zorin change the rules of the inside near the border for that reason.
#[test]
fn boundary_with_many_faces_has_no_tangent_plane() {
    let whole_turn = |is_quad: bool, k: usize| {
        let c = turn_cosine::<f64>(1, k);
        if is_quad {
            catmull_clark_ring_eigenvalues(c)[0]
        } else {
            loop_ring_eigenvalue(c)
        }
    };
    for k in 3..30 {
        assert_eq!(whole_turn(true, k) < 0.5, k <= 3);
        assert_eq!(whole_turn(false, k) < 0.5, k <= 5);
    }
    let settled = |scheme, k: u32| {
        let is_quad = scheme == Scheme::CatmullClark;
        let topology = half_fan(k, is_quad);
        let mut dice = Dice::new(9);
        let points = (0..topology.vertex_count).map(|vertex| {
            let height = dice.roll();
            let Some(place) = vertex.checked_sub(1) else {
                return [0.0, 0.0, height];
            };
            let opposite = place > k as usize;
            let spoke = if opposite {
                place as f64 - f64::from(k) - 0.5
            } else {
                place as f64
            };
            let angle = f64::pi() * spoke / f64::from(k);
            let radius = if opposite { 1.4 } else { 1.0 };
            [
                radius * angle.cos(),
                radius * angle.sin(),
                height + 2.0 * (2.0 * angle).sin(),
            ]
        });
        let all = levels(scheme, &topology.with_points(points.collect()), 40);
        // The triangles of the vertex and two neighbours: the faces of a scheme on quadrilaterals are not flat.
        let last = &all[40];
        let joined = joined(last);
        let at = |v: u32| last.positions[v as usize].minus(last.positions[0]);
        let mut spokes: Vec<Point> = joined.around(0).map(|h| at(joined.target(h))).collect();
        let end = joined.boundary_neighbours(0).expect("on the boundary")[0];
        spokes.push(at(end));
        let normals = spokes
            .windows(2)
            .map(|pair| unit_vector(pair[0].cross(pair[1])));
        spread_of(
            &normals
                .map(|normal| normal.expect("an area"))
                .collect::<Vec<_>>(),
        )
    };
    for (scheme, smooth, rough) in [(Scheme::CatmullClark, [2, 3], 5), (Scheme::Loop, [2, 4], 7)] {
        for k in smooth {
            let spread = settled(scheme, k);
            println!("{scheme:?} {k}: {spread:.4}");
            assert!(spread < 0.5, "{scheme:?} {k}: {spread}");
        }
        let spread = settled(scheme, rough);
        println!("{scheme:?} {rough}: {spread:.4}");
        assert!(spread > 5.0, "{scheme:?} {rough}: {spread}");
    }
}
