//! The typical mistakes of this chapter: wrong implementations that students really write. Each must be rejected by the
//! theorem that names it, and a reader's answer that behaves like one of them gets its hint.
//!
//! They use none of the functions that a reader replaces, so that a mistake in one exercise does not spoil those of another.

#[path = "mistakes/curve.rs"]
mod curve;
#[path = "../common/mistake.rs"]
mod mistake;

pub use curve::{chaikin_step, cubic_step, double_and_average};
pub use mistake::Mistake;
use mistake::{Function, mistake};

const CHAIKIN: Function = ["chaikin", "chaikin_puts_two_points_on_every_edge"];
const CUBIC: Function = ["cubic", "cubic_step_takes_vertices_and_edges_in_turn"];
const LANE_RIESENFELD: Function = ["lane_riesenfeld", "doubling_and_averaging_halves_the_spans"];

/// All typical mistakes of the chapter.
#[rustfmt::skip]
pub const MISTAKES: &[Mistake] = &[
    mistake(CHAIKIN, "swapped_points",
        "Q and R are swapped: Q, with 3/4 of P, is nearer to P and comes first"),
    mistake(CHAIKIN, "thirds",
        "the edges are cut at a third: Chaikin cuts at a quarter and three quarters"),
    mistake(CHAIKIN, "one_point_on_an_edge",
        "there is one point on each edge: two are needed, one near each of its ends"),
    mistake(CHAIKIN, "cut_from_the_new_point",
        "R is computed from Q in place of P: both come from the two old points"),
    mistake(CHAIKIN, "vertices_left_in",
        "the old vertices stand among the new points: their corners are to be cut off"),
    mistake(CHAIKIN, "closing_edge_forgotten",
        "the edge from the last point to the first is missing: a closed polygon has as many edges as points"),
    mistake(CHAIKIN, "open_polygon_closed",
        "an open polygon gets an edge from its last point to its first: it has one edge less than points"),
    mistake(CHAIKIN, "ends_lost",
        "kept ends are lost: the first point stands before all others, the last behind"),
    mistake(CHAIKIN, "one_end_kept",
        "of two ends that are to be kept only the first is"),
    mistake(CUBIC, "limit_mask",
        "(1, 4, 1)/6 is where a vertex goes in the limit: one round takes it to (1, 6, 1)/8"),
    mistake(CUBIC, "tent_mask",
        "(1, 2, 1)/4 pulls the vertex too far: its weights are (1, 6, 1)/8"),
    mistake(CUBIC, "vertices_stay",
        "the vertices stay where they are: they move to (P- + 6P + P+)/8"),
    mistake(CUBIC, "midpoints_of_moved_vertices",
        "the edge points are midpoints of the moved vertices: take those of the old ones"),
    mistake(CUBIC, "edges_first",
        "a closed polygon begins with the first vertex: V0, E0, V1, E1, ..."),
    mistake(CUBIC, "first_and_last_vertex_forgotten",
        "a closed polygon goes on from its last point to its first: the first and the last vertex have two neighbours, and there are n edges"),
    mistake(CUBIC, "vertices_at_kept_ends_lost",
        "kept ends are lost: they stand before the first edge point and behind the last"),
    mistake(CUBIC, "ends_stay_when_open",
        "with open ends a vertex without two neighbours has no point: the first and the last are edge points"),
    mistake(CUBIC, "ends_move",
        "kept ends move: (7P + P+)/8 is not the end point itself"),
    mistake(LANE_RIESENFELD, "one_average_more",
        "there is one round of means too many: a curve of degree d takes d"),
    mistake(LANE_RIESENFELD, "one_average_less",
        "there is one round of means too few: a curve of degree d takes d, after the doubling"),
    mistake(LANE_RIESENFELD, "not_doubled",
        "the points are not doubled before the means are taken"),
    mistake(LANE_RIESENFELD, "list_twice",
        "the whole list stands twice, one behind the other: each point is to be doubled in its place, P0, P0, P1, P1, ..."),
    mistake(LANE_RIESENFELD, "averaged_with_the_new_neighbour",
        "a mean is taken with a point that has been replaced already: take both points from the list before"),
    mistake(LANE_RIESENFELD, "last_point_left",
        "the last point of a round stays: n points have n - 1 midpoints"),
    mistake(LANE_RIESENFELD, "closed_by_a_mean",
        "the last point is averaged with the first: this polygon is open"),
    mistake(LANE_RIESENFELD, "doubled_every_round",
        "the points are doubled in every round of means: once is enough"),
];

/// Prints the mistakes for the grader: name, exercise and rejecting theorem, with tabs between.
#[test]
#[ignore = "a list for the grader, not a check"]
fn list_mistakes() {
    mistake::print_all(MISTAKES);
}
