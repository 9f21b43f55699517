//! What is refused, and how it is said. The book shows their doc comments.

use facette::bspline::{
    BsplineSurface, Closing, Direction, KnotVector, RationalCurve, RationalSurface, TrimmedSurface,
};
use facette::tessellation::{
    Bounded, Break, Continuity, TessellationError, tessellate, tessellate_trimmed,
    tessellate_within,
};

use crate::inputs::{Graph, Point, wave};

fn refusal(
    surface: &impl facette::tessellation::BoundedSurface<Scalar = f64, Point = Point>,
    tolerance: f64,
) -> String {
    let refused = tessellate(surface, tolerance).err();
    refused.map(|error| error.to_string()).unwrap_or_default()
}

fn plane(u: f64, v: f64) -> Point {
    [u, v, 0.0]
}

/// **No tolerance.** Zero, a negative number, NaN and infinity are no distances.
#[test]
fn tolerance_that_is_no_distance_is_refused() {
    for tolerance in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let expected =
            format!("the tolerance is {tolerance:?}: it must be a positive, finite distance");
        assert_eq!(refusal(&wave(), tolerance), expected);
    }
}

/// **Too many vertices.** What would take more vertices than allowed is refused at once, before any is made: the smallest tolerances too.
#[test]
fn too_many_vertices_are_refused_at_once() {
    for tolerance in [1e-12, 1e-100, f64::MIN_POSITIVE, f64::from_bits(1)] {
        let expected = format!(
            "a chord error of {tolerance:?} needs more than 16777216 vertices here: take a larger tolerance, or allow more vertices"
        );
        assert_eq!(refusal(&wave(), tolerance), expected);
    }
    let needed = tessellate(&wave(), 0.01)
        .expect("a usable tolerance")
        .mesh
        .positions
        .len();
    let limit = |vertices: usize| u32::try_from(vertices).expect("a small mesh");
    assert!(tessellate_within(&wave(), 0.01, limit(needed)).is_ok());
    let refused = tessellate_within(&wave(), 0.01, limit(needed - 1)).err();
    assert!(
        matches!(refused, Some(TessellationError::TooManyVertices { .. })),
        "{refused:?}"
    );
}

/// **Creases count.** A place on a crease has a vertex for each of its normals, and these count towards the limit: four flat pieces have nine places, but sixteen vertices where they meet in creases.
#[test]
fn vertices_of_creases_count_towards_the_limit() {
    let knots = KnotVector::clamped(1, &[0., 1., 2.]).expect("three breaks");
    let points = (0..9_i32).map(|index| {
        let [x, y] = [index % 3 - 1, index / 3 - 1];
        [x, y, -x.abs() - y.abs()].map(f64::from)
    });
    let roof = BsplineSurface::new([knots.clone(), knots], points.collect()).expect("nine points");
    let mesh = |limit| tessellate_within(&roof, 0.5, limit).map(|cut| cut.mesh.positions.len());
    assert_eq!(mesh(16), Ok(16));
    for limit in [9, 15] {
        let tolerance = 0.5;
        let refused = TessellationError::TooManyVertices { tolerance, limit };
        assert_eq!(mesh(limit), Err(refused));
    }
}

/// **Bounds that are none.** A bound that is negative, infinite or NaN is refused with its rectangle.
#[test]
fn unusable_bounds_are_refused() {
    for bad in [-1.0, f64::INFINITY, f64::NAN] {
        let domain = [[0.0, 1.0], [0.0, 2.0]];
        let surface = Bounded::new(
            Graph {
                domain,
                point: plane,
            },
            move |_| [0.0, bad, 0.0],
        );
        assert_eq!(
            refusal(&surface, 0.1),
            format!(
                "on [0.0, 1.0] x [0.0, 0.0] the bounds of |S_uu|, |S_uv|, |S_vv| are [0.0, {bad:?}, 0.0]: they must be finite and not negative"
            )
        );
    }
}

/// **A bound that overflows.** The first quarter of this curve is longer than the largest number, and $0\cdot\infty$ in the quotient rule is NaN there, and only there. A maximum that forgets NaN
/// would take the bound of the other quarters for all.
#[test]
fn bound_that_overflows_in_one_part_is_refused() {
    let [near, far] = [[0.0; 3], [1.7e308; 3]];
    let points = [[near, far, far, far, far]; 2].concat();
    let knots = [KnotVector::bezier(4), KnotVector::bezier(1)]
        .map(|knots| knots.reparametrised([0.0, 1e10]).expect("a domain"));
    let surface = RationalSurface::new(knots, &points, &[1.0; 10]).expect("finite points");
    let message = tessellate(&surface, 1e307)
        .err()
        .map(|error| error.to_string());
    let message = message.unwrap_or_default();
    assert!(
        message.contains("the bounds of |S_uu|, |S_uv|, |S_vv| are [NaN, "),
        "{message}"
    );
}

/// **Breaks that do not fit.** Breaks must increase from one end of the domain to the other.
#[test]
fn breaks_that_do_not_cut_the_domain_are_refused() {
    for breaks in [
        vec![0.0],
        vec![],
        vec![0.0, 0.5],
        vec![0.0, 0.5, 0.5, 1.0],
        vec![0.0, f64::NAN, 1.0],
    ] {
        let lines = breaks.iter().copied().map(Break::smooth).collect();
        let domain = [[0.0, 1.0], [0.0, 1.0]];
        let surface = Bounded::new(
            Graph {
                domain,
                point: plane,
            },
            |_| [0.0; 3],
        )
        .with_breaks([[0.0, 1.0].map(Break::smooth).to_vec(), lines])
        .expect("no break is torn");
        assert_eq!(
            refusal(&surface, 0.1),
            format!(
                "the breaks in v are {breaks:?}: they must increase from 0.0 to 1.0, the ends of the domain"
            )
        );
    }
}

/// **Torn breaks of a closure.** A closure has one point at each place and cannot jump there: a break that is said to be torn is refused, since a triangle would reach across the jump.
#[test]
fn torn_break_of_a_wrapped_surface_is_refused() {
    let domain = [[0.0, 1.0], [0.0, 2.0]];
    let step = |u: f64, v: f64| [u, v, f64::from(u8::from(v >= 1.0))];
    let surface = Bounded::new(
        Graph {
            domain,
            point: step,
        },
        |_| [0.0; 3],
    );
    let torn = Break {
        at: 1.0,
        continuity: Continuity::Torn,
    };
    let smooth = Break::smooth;
    let breaks = [
        vec![smooth(0.0), smooth(1.0)],
        vec![smooth(0.0), torn, smooth(2.0)],
    ];
    let direction = Direction::V;
    assert_eq!(
        surface.with_breaks(breaks).err(),
        Some(TessellationError::TornBreak { direction, at: 1.0 })
    );
}

/// **A loop that rounding hides.** Four corners of this loop are so near to each other that the products of their distances underflow: on which sides of each other they lie cannot be told, and no triangle can
/// be cut off. A mesh with a hole there would be worse than none.
#[test]
fn loop_that_cannot_be_cut_is_refused() {
    let square = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.]];
    let knots = [KnotVector::bezier(1), KnotVector::bezier(1)];
    let sheet = BsplineSurface::new(knots, square.to_vec()).expect("four points");
    let zigzag = [[0., 5.], [3., 4.], [1., 1.], [4., 0.]].map(|point| point.map(|x| x * 1e-200));
    let mut corners = vec![[0.0, 1.0]];
    corners.extend(zigzag);
    corners.push(corners[0]);
    let knots = KnotVector::clamped_uniform(1, corners.len()).expect("six points");
    let outline = RationalCurve::new(knots, &corners, &[1.0; 6]).expect("a polygon");
    let trimmed = TrimmedSurface::new(sheet, outline, 1e-6).expect("its sides keep apart");
    assert_eq!(trimmed.polygon(), &corners[..5]);
    let refused = tessellate_trimmed(&trimmed, 0.1).err();
    assert_eq!(
        refused.map(|error| error.to_string()),
        Some(
            "the loop's polygon of 5 corners could be cut into 0 triangles only, not 3: rounding hides on which side of each other its other \
             corners lie"
                .to_owned()
        )
    );
}

/// **A seam that does not close.** A surface that is said to close, but does not, is refused with the gap: a hidden crack would be worse.
#[test]
fn open_seam_is_refused() {
    let domain = [[0.0, 1.0], [0.0, 1.0]];
    let surface = Bounded::new(
        Graph {
            domain,
            point: plane,
        },
        |_| [0.0; 3],
    )
    .closed([Closing::Closed, Closing::Open]);
    let message = refusal(&surface, 0.1);
    assert!(
        message.starts_with("the surface is said to close in u, but at ")
            && message.contains("its two sides are 1.0 apart"),
        "{message}"
    );
}

/// **A flip that does not fit.** A Möbius band joins the first piece across to the last: their lengths must be the same.
#[test]
fn flip_of_unsymmetric_pieces_is_refused() {
    let domain = [[0.0, 1.0], [0.0, 1.0]];
    let breaks = [vec![0.0, 1.0], vec![0.0, 0.25, 1.0]]
        .map(|list| list.into_iter().map(Break::smooth).collect());
    let surface = Bounded::new(
        Graph {
            domain,
            point: plane,
        },
        |_| [0.0; 3],
    )
    .with_breaks(breaks)
    .expect("no break is torn")
    .closed([Closing::Flipped, Closing::Open]);
    assert_eq!(
        refusal(&surface, 0.1),
        "the surface is said to close in u with a flip, but its breaks across are not symmetric: 0.25 after the start, 0.75 before the end"
    );
}

/// **Parameters that run out.** Between $10^{16}$ and $10^{16}+8$ there are five numbers in `f64`: not enough for ten cells.
#[test]
fn parameters_that_run_out_are_reported() {
    let domain = [[1e16, 1e16 + 8.0], [0.0, 1.0]];
    let point = |u: f64, v: f64| [u - 1e16, v, (u - 1e16) * (u - 1e16)];
    let surface = Bounded::new(Graph { domain, point }, |_| [2.0, 0.0, 0.0]);
    let message = refusal(&surface, 0.1);
    assert!(
        message.contains("the parameters of neighbouring vertices are one number"),
        "{message}"
    );
}

/// **Points that are none.** A surface with a point that is not finite is refused with the vertex.
#[test]
fn point_that_is_not_finite_is_refused() {
    let domain = [[0.0, 1.0], [0.0, 1.0]];
    let point = |u: f64, v: f64| [1.0 / u, v, 0.0];
    let surface = Bounded::new(Graph { domain, point }, |_| [0.0; 3]);
    assert_eq!(
        refusal(&surface, 0.1),
        "position 0 is [inf, 0.0, 0.0]: every coordinate must be finite"
    );
}
