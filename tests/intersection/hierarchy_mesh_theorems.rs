//! The theorems of the page *A hierarchy of boxes* on whole meshes: nothing leaks, threads change nothing, and few boxes are visited.

use facette::algebra::VectorSpace;
use facette::intersection::hierarchy::{Found, Hierarchy, Visits};
use facette::intersection::triangle::moller_trumbore;
use facette::intersection::{BoundingBox, box_interval};
use facette::ray::Ray;
use glam::Vec3;

use crate::hierarchy_meshes::{Draws, bumpy_ball, cuts_for, ray_at_the_border};

fn built(triangles: &[[Vec3; 3]]) -> Hierarchy {
    Hierarchy::new(triangles).expect("finite corners")
}

/// How many of so many rays at edges and corners of a ball of 968 triangles meet nothing.
fn lost_by_the_hierarchy(count: usize) -> usize {
    let triangles = bumpy_ball(11);
    let hierarchy = built(&triangles);
    let mut query = hierarchy.query();
    let mut draws = Draws::new(1);
    (0..count)
        .filter(|_| {
            let ray = ray_at_the_border(&triangles, &mut draws);
            query.nearest(&ray).is_none() || !query.is_hit(&ray)
        })
        .count()
}

/// How many Möller and Trumbore's test loses, in the same precision and on the same rays.
fn lost_by_moller_trumbore(count: usize) -> usize {
    let triangles = bumpy_ball(11);
    let corners: Vec<_> = triangles
        .iter()
        .map(|corners| corners.map(|p| p.to_array()))
        .collect();
    let mut draws = Draws::new(1);
    (0..count)
        .filter(|_| {
            let ray = ray_at_the_border(&triangles, &mut draws);
            let ray = Ray::new(ray.origin.to_array(), ray.direction.to_array());
            !corners
                .iter()
                .any(|corners| moller_trumbore(corners, &ray).is_some())
        })
        .count()
}

/// **No ray slips through.** Of 100 000 rays from the inside of a closed mesh, aimed at its edges and corners, the hierarchy loses none. No bound is needed to prove it: a closed mesh has an inside and an outside, the exact ray leaves from one to the other, and the answer is that of the exact
/// ray. Möller and Trumbore's test, in the same precision, loses some of the first 5000.
#[test]
fn no_ray_slips_through_the_hierarchy() {
    assert_eq!(lost_by_the_hierarchy(100_000), 0);
    let lost = lost_by_moller_trumbore(5000);
    println!("Möller and Trumbore's test loses {lost} of 5000 rays");
    assert!(lost > 0);
}

/// **A hundred million rays.** The same, a thousand times as many: `cargo test --release --test intersection hundred_million -- --ignored --nocapture`. The variable `FACETTE_RAYS` sets another number.
#[test]
#[ignore = "minutes"]
fn hundred_million_rays_at_edges_and_corners() {
    let rays = std::env::var("FACETTE_RAYS")
        .ok()
        .and_then(|rays| rays.parse().ok());
    let rays: usize = rays.unwrap_or(100_000_000);
    let lost = lost_by_the_hierarchy(rays);
    println!("of {rays} rays at edges and corners {lost} are lost");
    assert_eq!(lost, 0);
}

/// **A closed mesh has no way out of the hierarchy.** Every ray that starts inside a closed mesh meets it, and from within: it arrives on the back of its triangle.
#[test]
fn every_ray_from_inside_hits_the_hierarchy() {
    use facette::intersection::Side;
    let triangles = bumpy_ball(20);
    let hierarchy = built(&triangles);
    let mut query = hierarchy.query();
    let mut draws = Draws::new(2);
    for _ in 0..20_000 {
        // Inside: the ball's radius is 0.9 at least, its faces cut off little of it.
        let ray = Ray::new(0.8 * draws.share() * draws.direction(), draws.direction());
        let side = query.nearest(&ray).map(|found| found.hit.side);
        assert_eq!(side, Some(Side::Back), "{ray:?}");
    }
}

/// The boxes of a tree, level by level.
type Boxes = Vec<Vec<[Vec3; 2]>>;

/// What a ray finds and visits.
type Answer = (Option<Found>, Option<Visits>);

/// The boxes, and what rays find and visit, in a tree built by so many threads.
fn built_by(threads: usize) -> (Boxes, Vec<Answer>) {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("threads");
    // More than a thread builds alone, so that the work is indeed divided.
    let triangles = bumpy_ball(cuts_for(20_000));
    let hierarchy = pool.install(|| built(&triangles));
    let mut query = hierarchy.query();
    let mut draws = Draws::new(3);
    let answers = (0..500).map(|_| {
        let ray = ray_at_the_border(&triangles, &mut draws);
        (query.nearest(&ray), query.visits(&ray))
    });
    (hierarchy.boxes(), answers.collect())
}

/// **Threads change nothing.** The tree is the same, box by box, whether one thread builds it or several: which half of the triangles goes where is decided before the halves are handed out.
#[test]
fn number_of_threads_does_not_matter() {
    let one = built_by(1);
    assert!(one == built_by(2) && one == built_by(5));
}

/// The mean number of nodes and of triangles that rays at a ball of so many triangles visit.
fn mean_visits(triangles: &[[Vec3; 3]]) -> [f64; 2] {
    const RAYS: u32 = 1000;
    let hierarchy = built(triangles);
    let mut query = hierarchy.query();
    let mut draws = Draws::new(4);
    let mut sums = [0.0; 2];
    for _ in 0..RAYS {
        let origin = 3.0 * draws.direction();
        let ray = Ray::new(origin, draws.direction() - origin);
        let visits = query.visits(&ray).expect("an ordinary ray");
        sums[0] += f64::from(visits.nodes);
        sums[1] += f64::from(visits.triangles);
    }
    sums.map(|sum| sum / f64::from(RAYS))
}

/// **The cost grows like a logarithm.** A tree whose nodes have eight children is about $\log_8n=\frac13\log_2n$ levels deep. If a ray follows three ways down on average, it visits $\log_2n$ nodes. The test measures it, on bumpy balls of $10^2$ to $10^5$ triangles and rays from all sides: a ray visits fewer
/// than $\log_2n$ nodes and tests fewer than $4\log_2n$ triangles, on average. The loop tests all $n$.
///
/// Course: R12, slide 104, Many surfaces: the loop over all primitives.
#[test]
fn visits_grow_like_a_logarithm() {
    for wanted in [100, 1000, 10_000, 100_000] {
        let triangles = bumpy_ball(cuts_for(wanted));
        let count = triangles.len() as f64;
        let [nodes, tested] = mean_visits(&triangles);
        println!(
            "{count} triangles: {nodes:.2} nodes, {tested:.2} triangles; log2 {:.2}",
            count.log2()
        );
        assert!(nodes < count.log2() && tested < 4.0 * count.log2());
        // And no less than the way down: the bound is not idle.
        assert!(nodes > count.log2() / 20.0 && tested > 4.0 * count.log2() / 20.0);
    }
}

/// **How likely a box is.** Of all lines that meet a convex body, the share that meets a convex body inside it is the quotient of their surface areas (Crofton). This is what the surface area heuristic weighs boxes with.
///
/// The test draws 200 000 random lines through a box and counts those that meet a box inside; a share $p$ of $N$ lines has the standard deviation $\sqrt{p(1-p)/N}$, and five of them are allowed.
#[test]
fn box_is_met_as_often_as_its_area_says() {
    let outer = BoundingBox::new([-1.0, -2.0, -0.5], [1.0, 2.0, 0.5]).expect("corners in order");
    let inners = [
        [[-0.5, -1.0, -0.25], [0.5, 1.0, 0.25]],
        [[0.0, -2.0, 0.1], [0.9, 2.0, 0.11]],
        [[-1.0, 1.9, -0.5], [-0.9, 2.0, -0.4]],
    ];
    let area = |[low, high]: [[f64; 3]; 2]| {
        let [x, y, z] = high.minus(low);
        2.0 * (x * y + y * z + z * x)
    };
    let radius = 5.25_f64.sqrt();
    let mut draws = Draws::new(5);
    let (mut met, mut of_them) = (0.0_f64, [0.0_f64; 3]);
    while met < 200_000.0 {
        // A random direction, and a random point of the disc across it that hides the outer box.
        let d = draws.direction().as_dvec3();
        let (u, v) = d.any_orthonormal_pair();
        let [x, y] = [0; 2].map(|_| radius * (2.0 * f64::from(draws.share()) - 1.0));
        if x * x + y * y > radius * radius {
            continue;
        }
        let line = Ray::new((x * u + y * v).to_array(), d.to_array());
        if box_interval(&outer, &line).is_none() {
            continue;
        }
        met += 1.0;
        for (count, [low, high]) in of_them.iter_mut().zip(inners) {
            let inner = BoundingBox::new(low, high).expect("corners in order");
            *count += f64::from(u8::from(box_interval(&inner, &line).is_some()));
        }
    }
    for (count, inner) in of_them.into_iter().zip(inners) {
        let expected = area(inner) / area([outer.min(), outer.max()]);
        let deviation = (expected * (1.0 - expected) / met).sqrt();
        println!("expected {expected:.5}, counted {:.5}", count / met);
        assert!((count / met - expected).abs() <= 5.0 * deviation);
    }
}
