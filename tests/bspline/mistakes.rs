//! The typical mistakes of this chapter: wrong implementations that students really write. Each must be rejected by the
//! theorem that names it, and a reader's answer that behaves like one of them gets its hint.
//!
//! They use none of the functions that a reader replaces, so that a mistake in one exercise does not spoil those of another.

#[path = "mistakes/basis.rs"]
mod basis;
#[path = "../common/mistake.rs"]
mod mistake;
#[path = "mistakes/points.rs"]
mod points;

pub use basis::{basis_functions, cox_de_boor, find_span};
pub use mistake::Mistake;
use mistake::{Function, mistake};
pub use points::{de_boor_point, insert_knot, surface_point};

const SPAN: Function = ["basis", "every_parameter_has_one_span"];
const RECURSION: Function = [
    "basis",
    "recursion_is_the_divided_difference_of_a_truncated_power",
];
const TRIANGLE: Function = ["basis", "triangle_gives_the_functions_that_are_not_zero"];
const CURVE: Function = ["curve", "de_boors_points_give_the_sum_of_the_basis"];
const INSERTION: Function = ["insertion", "inserting_a_knot_keeps_the_curve"];
const SURFACE: Function = ["surface", "five_steps_give_the_double_sum"];

/// All typical mistakes of the chapter.
#[rustfmt::skip]
pub const MISTAKES: &[Mistake] = &[
    mistake(SPAN, "closed_span",
        "a knot belongs to the span that begins there, not to the one that ends there: u_i <= u < u_(i+1)"),
    mistake(SPAN, "span_behind_the_end",
        "at the end of the domain no span has u_i <= u < u_(i+1), and the search runs past it: there, take the last span that is not empty"),
    mistake(SPAN, "empty_span",
        "at a repeated knot the span found is empty, u_i = u_(i+1): take the one behind the last copy of the knot"),
    mistake(SPAN, "empty_span_at_an_end",
        "where knots coincide at an end of the domain, the span found there is empty: leave the spans with u_i = u_(i+1) out of the search"),
    mistake(SPAN, "span_outside_the_domain",
        "a u outside the domain gets a span outside it, where p + 1 functions are missing: take the first or the last span of [u_p, u_(n+1)]"),
    mistake(SPAN, "span_counted_from_the_domain",
        "the spans are counted from the start of the domain: the number of a span is that of its left knot, and the first is p"),
    mistake(RECURSION, "zero_at_the_end",
        "at the end of the domain every half-open span misses u, so all functions are 0: the last span that is not empty counts as closed there"),
    mistake(RECURSION, "two_spans_at_a_knot",
        "with closed spans two functions of degree 0 are 1 at a knot, and more where it is repeated: u_i <= u < u_(i+1)"),
    mistake(RECURSION, "zero_over_zero",
        "where knots coincide, a fraction of the recursion is 0/0: it counts as 0, so leave its term out"),
    mistake(RECURSION, "swapped_denominators",
        "the two denominators are swapped: u - u_i is divided by u_(i+d) - u_i, and u_(i+d+1) - u by u_(i+d+1) - u_(i+1)"),
    mistake(RECURSION, "one_knot_short",
        "the second fraction takes u_(i+d) where u_(i+d+1) belongs: the function number i reaches to the knot i+d+1"),
    mistake(RECURSION, "one_term",
        "the second term of the recursion is missing: N_(i+1) falls while N_i rises"),
    mistake(RECURSION, "same_function_twice",
        "both terms take the function number i of degree d-1: the second belongs to number i+1"),
    mistake(RECURSION, "rising_twice",
        "both weights rise: the second is (u_(i+d+1) - u) / (u_(i+d+1) - u_(i+1)), which falls to 0 at the far end"),
    mistake(TRIANGLE, "reversed_values",
        "the values stand in reverse order: the first is that of N_(i-p), the last that of N_i"),
    mistake(TRIANGLE, "exchanged_parts",
        "the two parts of a value are exchanged: with t = (u - u_k) / (u_(k+d) - u_k), the part 1-t goes left and t goes right"),
    mistake(TRIANGLE, "lost_part",
        "a part is overwritten: every value but the first and the last is the sum of what comes from the left and from the right"),
    mistake(TRIANGLE, "triangle_one_level_short",
        "the last level is missing: the values are those of degree p-1"),
    mistake(TRIANGLE, "functions_after_the_span",
        "these are functions from N_i on: those that are not zero on the span i end there, N_(i-p) to N_i"),
    mistake(CURVE, "exchanged_weights_of_the_points",
        "the weights of the two neighbours are exchanged: d_i = (1-a) d_(i-1) + a d_i"),
    mistake(CURVE, "curve_one_level_short",
        "the last level is missing: after p levels one point is left"),
    mistake(CURVE, "overwritten_points",
        "a level uses points of its own: if the list is overwritten, go from its end to its start"),
    mistake(CURVE, "same_denominator_on_every_level",
        "the denominator must change with the level: u_(i+p+1-r) - u_i, one span less at every level"),
    mistake(CURVE, "weight_of_de_casteljau",
        "one weight for all is de Casteljau's algorithm, right for Bézier curves only: here a = (u - u_i) / (u_(i+p+1-r) - u_i)"),
    mistake(CURVE, "points_after_the_span",
        "these are control points from P_k on: those that count on the span k end there, P_(k-p) to P_k"),
    mistake(INSERTION, "exchanged_weights_of_the_insertion",
        "the weights are exchanged: Q_i = (1-a) P_(i-1) + a P_i"),
    mistake(INSERTION, "forgotten_tail",
        "the control points behind the new knot are missing: P_k, ..., P_n follow, and n+2 points are needed"),
    mistake(INSERTION, "replaced_points",
        "there are still n+1 points: the mixed points take no one's place, P_k stands behind them"),
    mistake(INSERTION, "insertion_range_too_early",
        "the points are mixed one place too early: Q_(k-p+1) to Q_k are mixed, Q_(k-p) is still P_(k-p)"),
    mistake(INSERTION, "same_weight_for_all",
        "all points are mixed with the weight of the last: a = (u - u_i) / (u_(i+p) - u_i) depends on i"),
    mistake(INSERTION, "denominator_of_p_plus_one_spans",
        "the denominator reaches one knot too far: u_(i+p) - u_i, p spans"),
    mistake(INSERTION, "mixed_with_new_points",
        "a mixed point takes the new Q_(i-1) as its neighbour: both neighbours are old points, P_(i-1) and P_i"),
    mistake(INSERTION, "curve_point_put_in",
        "the point of the curve is put in and the others stay: that pulls the curve there, while insertion moves p-1 of the others"),
    mistake(SURFACE, "exchanged_parameters",
        "u and v are exchanged: u belongs to the knots of direction U and to the index i"),
    mistake(SURFACE, "transposed_net",
        "the indices of the net are exchanged: in P_kl, and in control_point(k, l), k belongs to u and l to v"),
    mistake(SURFACE, "row_length_n",
        "a row of the net has n+1 points, not n: P_ij is control_points()[j * (n+1) + i]"),
    mistake(SURFACE, "span_of_u_for_v",
        "the span of u is used in v too: v has knots of its own, and so a span of its own"),
    mistake(SURFACE, "functions_of_u_for_v",
        "the functions of u weigh the rows too: in v they are N_(j-q)(v), ..., N_j(v)"),
    mistake(SURFACE, "forgotten_weights_of_v",
        "the weights of v are missing: each control point is multiplied by N_i(u) and by N_j(v)"),
    mistake(SURFACE, "exchanged_degrees",
        "the degrees are exchanged: columns i-p to i, rows j-q to j"),
    mistake(SURFACE, "points_of_the_first_rectangle",
        "the control points are always those of the first rectangle: on the spans i and j the columns i-p to i and the rows j-q to j count"),
];

/// Whether a mistake is one of this function.
fn is_of([_, rejected_by]: Function, mistake: &str) -> bool {
    let mut entries = MISTAKES.iter();
    entries.any(|entry| entry.name == mistake && entry.rejected_by == rejected_by)
}

/// Prints the mistakes for the grader: name, exercise and rejecting theorem, with tabs between.
#[test]
#[ignore = "a list for the grader, not a check"]
fn list_mistakes() {
    mistake::print_all(MISTAKES);
}
