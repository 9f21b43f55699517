//! Evaluation where it is easily got wrong.

use facette::algebra::Real;
use facette::subdivision::evaluate::{CatmullClarkSurface, EvaluationError, LoopSurface};
use facette::subdivision::{Connectivity, Corners, SubdivisionError};

use crate::common::dice::Dice;
use crate::limit_inputs::joined;
use crate::meshes::{cube, prism, quad_fan, tetrahedron};

/// **At the vertex there is a point and a normal, but no derivative.** At the corner of the cube $\pm1$, of valence 3, the surface has the point $-\tfrac12(1,1,1)$ and the normal along it. Derivatives vanish there for one who comes nearer, and are unbounded for valence 5 and more; both are refused.
#[test]
fn vertex_has_a_normal_but_no_derivatives() {
    let cube = cube::<f64>();
    let surface = CatmullClarkSurface::new(&joined(&cube), &cube.positions, Corners::Sharp);
    let adaptive = surface.expect("finite points");
    for surface in [adaptive.clone(), adaptive.with_eigenbasis()] {
        let point = surface.point(0, 0.0, 0.0).expect("a face");
        assert!(point.iter().all(|x| (x + 0.5).abs() <= 4.0 * f64::EPSILON));
        let normal = surface.normal(0, 0.0, 0.0).expect("a tangent plane");
        let along = -1.0 / 3.0_f64.sqrt();
        assert!(
            normal
                .iter()
                .all(|x| (x - along).abs() <= 8.0 * f64::EPSILON)
        );
        let refused = surface.derivatives(0, 0.0, 0.0);
        assert_eq!(refused, Err(EvaluationError::NoDerivatives));
    }
}

/// **Parameters as small as numbers get.** One subnormal step from a vertex of valence 3, 5 and 200 the points are finite, and so are the tangents, in single precision too; nothing overflows on the way to the power of two that brings them there.
#[test]
fn smallest_parameters_do_not_overflow() {
    for n in [3, 5, 200] {
        let topology = quad_fan(n);
        let mut dice = Dice::new(u64::from(n));
        let points: Vec<[f32; 3]> = (0..topology.vertex_count)
            .map(|_| dice.vector().map(f32::from_f64))
            .collect();
        let mesh = topology.with_points(points);
        let surface = CatmullClarkSurface::new(&joined(&mesh), &mesh.positions, Corners::Sharp);
        let adaptive = surface.expect("finite points");
        let smallest = f32::from_bits(1);
        for surface in [adaptive.clone(), adaptive.with_eigenbasis()] {
            let derivatives = surface.corner_derivatives(0, smallest, 0.0);
            let derivatives = derivatives.expect("not the vertex itself");
            let coordinates = derivatives
                .first
                .into_iter()
                .flatten()
                .chain(derivatives.point);
            assert!(coordinates.into_iter().all(f32::is_finite));
            assert!(surface.corner_normal(0, smallest, smallest).is_ok());
        }
    }
}

/// **A far mesh keeps its derivatives.** Moved by $2^{27}$, with coordinates that stay exact, the surface of a prism has the very same derivatives, bit for bit.
#[test]
fn derivatives_do_not_depend_on_the_place() {
    let topology = prism(5);
    let mut dice = Dice::new(5);
    let sixteenths = |x: f64| (x * 16.0).round() / 16.0;
    let near: Vec<_> = (0..topology.vertex_count)
        .map(|_| dice.vector().map(sixteenths))
        .collect();
    let far: Vec<_> = near.iter().map(|p| p.map(|x| x + 134_217_728.0)).collect();
    let [near, far] = [near, far].map(|points| {
        CatmullClarkSurface::new(&topology.connectivity(), &points, Corners::Sharp)
            .expect("finite points")
            .with_eigenbasis()
    });
    for half_edge in 0..10 {
        for (s, t) in [(0.3, 0.8), (0.01, 0.2), (1e-9, 1e-12)] {
            let [a, b] = [&near, &far]
                .map(|surface| surface.corner_derivatives(half_edge, s, t).expect("inside"));
            assert_eq!((a.first, a.second), (b.first, b.second));
        }
    }
}

/// **Parameters outside, and NaN.** Parameters are moved to the nearest in $[0,1]$; barycentric ones are divided by their sum, negative ones being 0. NaN gives NaN.
#[test]
fn parameters_outside_are_moved_inside() {
    let cube = cube::<f64>();
    let surface = CatmullClarkSurface::new(&joined(&cube), &cube.positions, Corners::Sharp);
    let surface = surface.expect("finite points");
    assert_eq!(surface.point(0, -3.0, 0.25), surface.point(0, 0.0, 0.25));
    assert_eq!(surface.point(3, 0.25, 1.5), surface.point(3, 0.25, 1.0));
    assert_eq!(
        surface.corner_point(5, 0.5, 7.0),
        surface.corner_point(5, 0.5, 1.0)
    );
    let is_nan = |point: [f64; 3]| point.iter().all(|x| x.is_nan());
    assert!(surface.point(0, f64::NAN, 0.5).is_ok_and(is_nan));
    assert!(
        surface
            .clone()
            .with_eigenbasis()
            .point(0, 0.1, f64::NAN)
            .is_ok_and(is_nan)
    );
    let tetrahedron = tetrahedron::<f64>();
    let surface = LoopSurface::new(
        &joined(&tetrahedron),
        &tetrahedron.positions,
        Corners::Sharp,
    )
    .expect("triangles");
    let moved = surface.point(1, [2.0, -1.0, 2.0]);
    assert_eq!(moved, surface.point(1, [0.5, 0.0, 0.5]));
    assert!(surface.point(0, [f64::NAN, 0.5, 0.5]).is_ok_and(is_nan));
    assert!(surface.point(0, [0.0, -1.0, 0.0]).is_ok_and(is_nan));
}

/// **What cannot be evaluated is refused, and named.** A face or half-edge that does not exist; two parameters for a pentagon; a point that is not finite; a number of points that is not that of the vertices; other faces than triangles for Loop.
#[test]
fn what_cannot_be_evaluated_is_refused() {
    let prism = prism(5).with_points(vec![[0.0; 3]; 10]);
    let connectivity = Connectivity::new(&prism).expect("a prism");
    let made =
        |points: &[[f64; 3]]| CatmullClarkSurface::new(&connectivity, points, Corners::Sharp);
    let surface = made(&prism.positions).expect("finite points");
    assert_eq!(
        surface.point(7, 0.5, 0.5),
        Err(EvaluationError::NoSuchFace { face: 7, count: 7 })
    );
    assert_eq!(
        surface.point(0, 0.5, 0.5),
        Err(EvaluationError::NotAQuadrilateral { face: 0, found: 5 })
    );
    for half_edge in [30, u32::MAX] {
        assert_eq!(
            surface.corner_point(half_edge, 0.5, 0.5),
            Err(EvaluationError::NoSuchHalfEdge {
                half_edge,
                count: 30
            })
        );
    }
    assert_eq!(surface.normal(2, 0.5, 0.5), Err(EvaluationError::NoNormal));
    assert_eq!(
        made(&prism.positions[1..]).err(),
        Some(EvaluationError::Mesh(SubdivisionError::PointCount {
            found: 9,
            expected: 10
        }))
    );
    let mut points = prism.positions.clone();
    points[3][1] = f64::INFINITY;
    assert!(matches!(
        made(&points),
        Err(EvaluationError::PointNotFinite { vertex: 3, .. })
    ));
    assert_eq!(
        LoopSurface::new(&connectivity, &prism.positions, Corners::Sharp).err(),
        Some(EvaluationError::Mesh(SubdivisionError::NotATriangle {
            face: 0,
            found: 5
        }))
    );
}
