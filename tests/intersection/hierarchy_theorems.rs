//! The theorems of the page *A hierarchy of boxes*.

use facette::intersection::hierarchy::{Hierarchy, nearest_by_loop};
use facette::ray::Ray;
use glam::Vec3;

use super::hierarchy_oracle::nearest_exactly;

#[test]
fn the_first_hit_is_the_exact_one() {
    let mut state = 1_u32;
    let mut next = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        state >> 8
    };
    let mut hits = 0;
    for round in 0..60 {
        let scale = if round % 3 == 0 {
            1.0
        } else if round % 3 == 1 {
            1e-43
        } else {
            1.1e37
        };
        let mut vector = |n: u32| {
            let mut x = || (next() % (2 * n + 1)) as f32 - n as f32;
            Vec3::new(x(), x(), x())
        };
        let triangles: Vec<_> = (0..20)
            .map(|_| [vector(3), vector(3), vector(3)].map(|p| p * scale))
            .collect();
        let hierarchy = Hierarchy::new(&triangles).expect("finite corners");
        let mut query = hierarchy.query();
        for _ in 0..30 {
            let mut ray = Ray::new(vector(4) * scale, vector(3));
            if round % 2 == 0 {
                ray.direction *= scale;
            }
            let exact = nearest_exactly(&triangles, &ray);
            let found = query.nearest(&ray);
            assert_eq!(found, nearest_by_loop(&triangles, &ray));
            assert_eq!(
                found.map(|found| found.triangle),
                exact.as_ref().map(|hit| hit.triangle),
                "{ray:?}"
            );
            assert_eq!(
                found.map(|found| found.hit.side),
                exact.as_ref().map(|hit| hit.side)
            );
            assert_eq!(query.is_hit(&ray), exact.is_some());
            hits += u32::from(exact.is_some());
        }
    }
    assert!(hits > 400, "{hits}");
}
