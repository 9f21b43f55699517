//! How smooth the limit surfaces are at extraordinary points: what the eigenvalues promise, seen in meshes.

use facette::algebra::{Real, Vector3, VectorSpace, length, unit_vector};
use facette::mesh::Mesh;
use facette::subdivision::limit::{
    Eigenvalues, catmull_clark_eigenvalues, catmull_clark_ring_eigenvalues, doo_sabin_eigenvalues,
    doo_sabin_limits, loop_eigenvalues, loop_ring_eigenvalue, loop_vertex_eigenvalue,
    sqrt3_eigenvalues,
};
use facette::subdivision::mask::{loop_vertex_weight, turn_cosine};
use facette::subdivision::{Corners, DooSabinWeights, loop_subdivision_with};
use proptest::prelude::*;

use crate::common::dice::Dice;
use crate::common::exact::{Exact, fraction};
use crate::common::law::{Law, expect_equal};
use crate::limit_inputs::{half_fan, joined, limits, neighbourhood, refined};
use crate::meshes::{double_fan, pyramid, quad_fan, triangle_grid};
use crate::steps::Scheme;
use crate::suspects;

type Point = [f64; 3];

fn degrees(a: Point, b: Point) -> f64 {
    length(a.cross(b)).atan2(a.dot(b)).to_degrees()
}

fn face_normal(mesh: &Mesh<Point>, face: &[u32]) -> Point {
    let at = |k: usize| mesh.positions[face[k] as usize].minus(mesh.positions[face[0] as usize]);
    let sum = (1..face.len() - 1).fold([0.0; 3], |sum, k| sum.plus(at(k).cross(at(k + 1))));
    unit_vector(sum).expect("a face with an area")
}

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

/// The neighbourhood of vertex 0 after 0, 1, ... steps, each moved so that the limit of the vertex is the origin, and scaled to its first
/// size: neither changes an angle, and hundreds of levels lose no digits.
fn levels(scheme: Scheme, mesh: &Mesh<Point>, steps: u32) -> Vec<Mesh<Point>> {
    let mut all = vec![mesh.clone()];
    for step in 0..steps {
        let last = &all[all.len() - 1];
        let step = if scheme == Scheme::Sqrt3 { 0 } else { step };
        let fine = neighbourhood(&refined(scheme, last, step..step + 1, Corners::Sharp), 0, 3);
        let limit = limits(scheme, &fine, Corners::Sharp)[0].position;
        all.push(centred(&fine, limit));
    }
    all
}

/// The mesh with `centre` moved to the origin, and scaled by a power of two so that its largest coordinate is between 1 and 2.
fn centred(mesh: &Mesh<Point>, centre: Point) -> Mesh<Point> {
    let offsets: Vec<Point> = mesh.positions.iter().map(|p| p.minus(centre)).collect();
    let largest = offsets
        .iter()
        .map(|p| p.largest_coordinate())
        .fold(0.0, f64::max);
    let scale = 1.0 / largest.power_of_two();
    let points = offsets.iter().map(|p| p.times(scale)).collect();
    Mesh::new(points, mesh.faces()).expect("the same faces")
}

/// Vertex 0 in the middle of circles of neighbours, with heights at random.
fn hilly(scheme: Scheme, n: u32, seed: u64) -> Mesh<Point> {
    let topology = if scheme == Scheme::CatmullClark {
        quad_fan(n)
    } else {
        double_fan(n)
    };
    let mut dice = Dice::new(seed);
    let place = |vertex: usize| {
        let height = dice.roll();
        let Some(k) = vertex.checked_sub(1) else {
            return [0.0, 0.0, height];
        };
        let (ring, k) = (k / n as usize, k % n as usize);
        let angle = f64::pi() * (2 * k + ring) as f64 / f64::from(n);
        let radius = 1.0 + ring as f64;
        [radius * angle.cos(), radius * angle.sin(), height]
    };
    topology.with_points((0..topology.vertex_count).map(place).collect())
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
    for n in [3, 4, 5, 6, 8, 12, 20] {
        let expected = expected(catmull_clark_eigenvalues(n as usize));
        let got = growth(Scheme::CatmullClark, n, frequency(n, 4));
        println!("Catmull-Clark {n}: {got:.4}, {expected:.4}");
        assert!(
            (got / expected - 1.0).abs() < 1e-6,
            "Catmull-Clark {n}: {got}, not {expected}"
        );
    }
    for n in [4, 5, 6, 7, 8, 12, 20] {
        let expected = expected(loop_eigenvalues(n as usize));
        let got = growth(Scheme::Loop, n, frequency(n, 6));
        println!("Loop {n}: {got:.4}, {expected:.4}");
        assert!(
            (got / expected - 1.0).abs() < 1e-6,
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

/// **Too many faces on a boundary.** The boundary's own tangent has the eigenvalue $\frac12$, whatever is inside. With $k$ faces at the vertex, waves of half a turn have the eigenvalue $\lambda$ of valence $2k$, whole turns that of valence $k$. The second must be less than $\frac12$, or there is no tangent plane: it is for $k\le3$ quadrilaterals and
/// $k\le5$ triangles, and not for more. Seen here: the normals at such a vertex come together for $k\le3$ and $k\le5$; for 5 quadrilaterals and for 7 triangles they do not in forty levels.
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
