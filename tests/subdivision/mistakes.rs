//! The typical mistakes of this chapter: wrong implementations that students really write. Each must be rejected by the
//! theorem that names it, and a reader's answer that behaves like one of them gets its hint.
//!
//! They use none of the functions that a reader replaces, so that a mistake in one exercise does not spoil those of another.

#[path = "mistakes/curve.rs"]
mod curve;
#[path = "../common/mistake.rs"]
mod mistake;
#[path = "mistakes/surface.rs"]
mod surface;

pub use curve::{chaikin_step, cubic_step, double_and_average};
pub use mistake::Mistake;
use mistake::{Function, mistake};
pub use surface::{catmull_clark, loop_subdivision, loop_subdivision_with};

const CHAIKIN: Function = ["chaikin", "chaikin_puts_two_points_on_every_edge"];
const CUBIC: Function = ["cubic", "cubic_step_takes_vertices_and_edges_in_turn"];
const LANE_RIESENFELD: Function = ["lane_riesenfeld", "doubling_and_averaging_halves_the_spans"];
const CC_NEW: Function = [
    "catmull_clark",
    "catmull_clark_places_face_points_and_edge_points",
];
const CC_OLD: Function = ["catmull_clark", "catmull_clark_moves_the_old_vertices"];
const LOOP_NEW: Function = ["loop", "loop_puts_a_point_on_every_edge"];
const LOOP_OLD: Function = ["loop", "loop_moves_the_old_vertices"];

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
    mistake(CC_NEW, "face_point_of_three_corners",
        "the face point is the mean of three corners: take all of the face"),
    mistake(CC_NEW, "quarter_of_every_corner",
        "the sum over a face is divided by 4: divide by its number of corners"),
    mistake(CC_NEW, "edge_midpoints",
        "the edge points are midpoints inside the mesh too: there they are the mean of the midpoint Q and the mean R of the two face points"),
    mistake(CC_NEW, "edges_of_face_points_only",
        "the edge point is the mean of the two face points: the two ends of the edge belong to it too, (Q + R)/2"),
    mistake(CC_NEW, "boundary_edges_pulled_inside",
        "an edge point on the boundary is pulled towards its face: it is the midpoint of the edge"),
    mistake(CC_OLD, "r_of_edge_points",
        "R is the mean of the new edge points, or Q counts twice instead of R, which is the same: R is the mean of the old midpoints, and counts twice"),
    mistake(CC_OLD, "vertices_stay",
        "the old vertices stay where they are: they move to (Q + 2R + (n-3)S)/n"),
    mistake(CC_OLD, "valence_four_everywhere",
        "(Q + 2R + S)/4 is the rule for four edges: with n edges it is (Q + 2R + (n-3)S)/n"),
    mistake(CC_OLD, "n_minus_two",
        "the weights sum to n+1 over n: S has n-3, not n-2"),
    mistake(CC_OLD, "boundary_as_inside",
        "a vertex on the boundary moves as one inside: there it follows the boundary, (A + 6S + B)/8"),
    mistake(CC_OLD, "corners_rounded",
        "with sharp corners a boundary vertex with a single face stays"),
    mistake(CC_OLD, "limit_mask_on_the_boundary",
        "(1, 4, 1)/6 is where a boundary vertex goes in the limit: one step takes it to (1, 6, 1)/8"),
    mistake(["catmull_clark", "catmull_clark_makes_quadrilaterals_and_keeps_valences"], "faces_turned_over",
        "the new faces run clockwise: corner, edge point after it, face point, edge point before it"),
    mistake(LOOP_NEW, "edge_midpoints",
        "the edge points are midpoints inside the mesh too: there they are 3/8 (A + B) + 1/8 (C + D)"),
    mistake(LOOP_NEW, "edge_weights_exchanged",
        "the weights of an edge point are exchanged: its ends have 3/8, the vertices opposite 1/8"),
    mistake(LOOP_NEW, "edge_weights_all_alike",
        "an edge point is not the mean of the four corners of its triangles: the ends have 3/8, the others 1/8"),
    mistake(LOOP_OLD, "vertices_stay",
        "the old vertices stay where they are: they move to alpha V + (1 - alpha) Q"),
    mistake(LOOP_OLD, "valence_six_everywhere",
        "5/8 is the weight at valence 6: with n neighbours use alpha of n"),
    mistake(LOOP_OLD, "alpha_and_rest_exchanged",
        "alpha and 1 - alpha are exchanged: alpha is the share of the vertex itself"),
    mistake(LOOP_OLD, "sum_of_neighbours",
        "1 - alpha multiplies the sum of the neighbours: Q is their mean"),
    mistake(LOOP_OLD, "boundary_as_inside",
        "a vertex on the boundary moves as one inside: there it follows the boundary, (A + 6V + B)/8"),
    mistake(LOOP_OLD, "corners_rounded",
        "with sharp corners a boundary vertex with a single triangle stays"),
    mistake(LOOP_OLD, "limit_mask_on_the_boundary",
        "(1, 4, 1)/6 is where a boundary vertex goes in the limit: one step takes it to (1, 6, 1)/8"),
    mistake(["loop", "loop_makes_four_triangles_of_one_and_keeps_valences"], "middle_turned_over",
        "the middle triangle runs clockwise: it is the edge points after the first, second and third corner"),
    mistake(["loop", "loop_weight_has_the_cosine_of_a_full_turn"], "printed_cosine",
        "the slide's cos(3 pi/n) is a misprint: the angle is a full turn over n, 2 pi/n"),
];

/// Prints the mistakes for the grader: name, exercise and rejecting theorem, with tabs between.
#[test]
#[ignore = "a list for the grader, not a check"]
fn list_mistakes() {
    mistake::print_all(MISTAKES);
}
