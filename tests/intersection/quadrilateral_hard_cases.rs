//! Rays and quadrilateral facets where the equations degenerate.

use facette::intersection::quadrilateral::Quadrilateral;
use facette::intersection::{Intersect, IntersectionError, Side};
use facette::ray::Ray;
use num_traits::ToPrimitive;

use crate::quadrilateral_inputs::exact_point;

/// **Both roots are hits.** A ray through a saddle from side to side meets it twice: first from the front, then, if it starts behind that, from the back.
#[test]
fn saddle_is_met_twice() {
    let saddle = [[0., 0., 0.], [2., 0., 2.], [2., 2., 0.], [0., 2., 2.]];
    let saddle = Quadrilateral::new(saddle).expect("finite corners");
    let ray = Ray::new([-0.5, -0.5, 0.75], [1.0, 1.0, 0.0]);
    let first = saddle.intersect(&ray).expect("the near side");
    let second = saddle.intersect(&ray.after(first.t)).expect("the far side");
    assert_eq!((first.t, second.t), (1.0, 2.0));
    assert_eq!((first.side, second.side), (Side::Front, Side::Back));
    assert_eq!(saddle.intersect(&ray.after(second.t)), None);
    let exact = |u: f64| exact_point(saddle.corners(), [u, u])[2].to_f64();
    assert_eq!([exact(0.25), exact(0.75)], [Some(0.75); 2]);
}

/// **A ruling is no hit.** A ray along a straight line of the patch, or in the plane of a flat one, misses; so does one that only touches. Next to it, all is well.
#[test]
fn ray_along_a_ruling_misses() {
    let corners = [[0., 0., 0.], [2., 0., 2.], [2., 2., 0.], [0., 2., 2.]];
    let saddle = Quadrilateral::new(corners).expect("finite corners");
    let along = Ray::new([0.0, 0.0, 0.0], [1.0, 0.0, 1.0]);
    let inner = Ray::new([1.0, -1.0, 1.0], [0.0, 1.0, 0.0]);
    assert_eq!([along, inner].map(|ray| saddle.intersect(&ray)), [None; 2]);
    let flat = Quadrilateral::new(corners.map(|[x, y, _]| [x, y, 1.0])).expect("finite corners");
    assert_eq!(
        flat.intersect(&Ray::new([-1.0, 1.0, 1.0], [1.0, 0.0, 0.0])),
        None
    );
    assert!(
        flat.intersect(&Ray::new([-1.0, 1.0, 1.0 + 1e-9], [1.0, 0.0, -5e-10]))
            .is_some()
    );
}

/// **Two corners in one make a triangle.** Where $\mathbf d=\mathbf a$, or $\mathbf c=\mathbf b$, the patch is a triangle, and is met as one.
#[test]
fn collapsed_quadrilateral_is_a_triangle() {
    let [a, b, c] = [[0., 0., 0.], [4., 0., 0.], [0., 4., 0.]];
    let ray = Ray::new([1.0, 1.5, 3.0], [0.0, 0.0, -1.0]);
    for corners in [[a, b, c, a], [a, a, b, c], [a, b, b, c], [a, b, c, c]] {
        let patch = Quadrilateral::new(corners).expect("finite corners");
        let hit = patch.intersect(&ray).expect("inside");
        assert_eq!(
            (hit.t, hit.point, hit.normal),
            (3.0, [1.0, 1.5, 0.0], [0.0, 0.0, 1.0]),
            "{corners:?}"
        );
        assert_eq!(
            patch.intersect(&Ray::new([3.0, 3.0, 3.0], ray.direction)),
            None
        );
    }
}

/// **What is not finite is met nowhere.** So with NaN, infinity or no direction in the ray; corners that are not finite are refused by name.
#[test]
fn rays_that_are_not_finite_miss_every_quadrilateral() {
    let corners = [[0., 0., 0.], [2., 0., 2.], [2., 2., 0.], [0., 2., 2.]];
    let saddle = Quadrilateral::new(corners).expect("finite corners");
    let good = ([1., 1., 5.], [0., 0., -1.]);
    let mut rays = vec![Ray::new(good.0, [0.0; 3])];
    for axis in 0..3 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (mut origin, mut direction) = good;
            origin[axis] = bad;
            direction[axis] = bad;
            rays.extend([Ray::new(origin, good.1), Ray::new(good.0, direction)]);
        }
    }
    for ray in rays {
        assert_eq!(saddle.intersect(&ray), None, "{ray:?}");
    }
    let refusal = Quadrilateral::new([
        corners[0],
        corners[1],
        corners[2],
        [0.0, 0.0, f64::INFINITY],
    ]);
    assert!(
        matches!(
            refusal,
            Err(IntersectionError::NotFinite {
                what: "corner d",
                ..
            })
        ),
        "{refusal:?}"
    );
}
