//! Seams and poles that are hard to close.

use facette::algebra::{Vector3, VectorSpace};
use facette::bspline::{Closing, KnotVector, RationalSurface, closed_surface};

use crate::inputs::{cut, euler_number};

/// **A pole that is a point up to rounding.** The textbook's sphere has weights $\sqrt{\tfrac12}$ and 1, which are rounded, and so are the products with them and the quotients by them: the
/// control points of a pole differ by an ulp unless the centre happens to be 0. They are one place all the same, and the sphere has no hole, wherever it lies.
#[test]
fn sphere_with_rounded_weights_is_closed_wherever_it_lies() {
    let half = 0.5_f64.sqrt();
    let circle: [([f64; 2], f64); 9] = [
        ([1., 0.], 1.),
        ([1., 1.], half),
        ([0., 1.], 1.),
        ([-1., 1.], half),
        ([-1., 0.], 1.),
        ([-1., -1.], half),
        ([0., -1.], 1.),
        ([1., -1.], half),
        ([1., 0.], 1.),
    ];
    let knots = [
        KnotVector::clamped(2, &[0., 1., 1., 2., 2., 3., 3., 4.]).expect("valid knots"),
        KnotVector::clamped(2, &[0., 1., 1., 2.]).expect("valid knots"),
    ];
    for centre in [0.0, 0.1, 1.0, 3.0, 10.0, 1e3, 1e6] {
        let meridian = [6, 7, 0, 1, 2].map(|k: usize| circle[k]);
        let rows = meridian.iter().flat_map(|&([r, z], w)| {
            circle
                .iter()
                .map(move |&([x, y], v)| ([r * x, r * y, z], v * w))
        });
        let (points, weights): (Vec<[f64; 3]>, Vec<f64>) = rows
            .map(|(point, weight)| (point.map(|c| c + centre), weight))
            .unzip();
        let sphere =
            RationalSurface::new(knots.clone(), &points, &weights).expect("positive weights");
        let welded = cut(&sphere, 0.05).welded();
        assert_eq!(euler_number(&welded), 2, "centre {centre}");
    }
}

/// **A crease along the seam.** A square tube of degree 1 closes over a simple knot, which is a crease like the other three: the normals on both of its sides are those of the faces
/// that they belong to.
#[test]
fn creased_seam_has_a_normal_for_each_side() {
    let knots = [
        KnotVector::uniform(1, 5).expect("four sides"),
        KnotVector::bezier(1),
    ];
    let corners = [[1., 0.], [0., 1.], [-1., 0.], [0., -1.]];
    let row = |z: f64| corners.map(|[x, y]| [x, y, z]);
    let points = [row(0.0), row(1.0)].concat();
    let tube = closed_surface(knots, &points, [Closing::Closed, Closing::Open]);
    let mesh = cut(&tube.expect("a tube closes"), 0.1).mesh;
    for [a, b, c] in mesh.triangles() {
        let [p, q, r] = [a, b, c].map(|vertex| mesh.positions[vertex as usize]);
        let face = q.minus(p).cross(r.minus(p));
        let size = face.dot(face).sqrt();
        for vertex in [a, b, c] {
            let along = mesh.normals[vertex as usize].dot(face) / size;
            assert!(along > 0.999, "a normal {along} off its face");
        }
    }
}
