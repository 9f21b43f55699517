//! What is refused, and how it is said. The book shows their doc comments.

use facette::bspline::Closing;
use facette::tessellation::{Bounded, Break, TessellationError, tessellate, tessellate_within};

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
        .with_breaks([[0.0, 1.0].map(Break::smooth).to_vec(), lines]);
        assert_eq!(
            refusal(&surface, 0.1),
            format!(
                "the breaks in v are {breaks:?}: they must increase from 0.0 to 1.0, the ends of the domain"
            )
        );
    }
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
