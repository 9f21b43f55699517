//! The typical mistakes of this chapter: wrong implementations that students really write. Each must be rejected by the
//! theorem that names it, and a reader's answer that behaves like one of them gets its hint.
//!
//! They use none of the functions that a reader replaces, so that a mistake in one exercise does not spoil those of another.

#[path = "mistakes/boxes.rs"]
mod boxes;
#[path = "mistakes/groups.rs"]
mod groups;
#[path = "../common/mistake.rs"]
mod mistake;
#[path = "mistakes/spheres.rs"]
mod spheres;
#[path = "mistakes/triangles.rs"]
mod triangles;

pub use boxes::box_interval;
pub use groups::nearest;
pub use mistake::Mistake;
use mistake::{Function, mistake};
pub use spheres::{first_root, roots_by_projection, roots_by_quadratic};
pub use triangles::{half_planes, moller_trumbore};

const CHORD: Function = ["sphere", "quadratic_gives_both_ends_of_a_chord"];
const COUNT: Function = ["sphere", "discriminant_counts_the_points"];
const HALF_LINE: Function = ["sphere", "ray_and_its_opposite_share_the_line"];
const FIRST: Function = ["sphere", "nearest_root_in_front_is_the_answer"];
const FAR: Function = ["stable", "projection_loses_no_digits_from_afar"];
const NEAR: Function = ["stable", "near_root_keeps_its_digits_next_to_the_surface"];
const SAME: Function = ["stable", "projection_gives_the_same_roots"];
const SLABS: Function = [
    "slabs",
    "line_is_in_the_box_between_the_last_entry_and_the_first_exit",
];
const LEAST: Function = ["group", "group_answers_with_the_least_of_its_members"];
const MAXIMUM: Function = ["group", "group_keeps_the_given_maximum"];
const EQUALS: Function = ["group", "first_of_equally_near_members_is_the_answer"];
const ONCE: Function = ["group", "group_asks_every_member_once"];

const HALF_PLANES: Function = ["half_planes", "three_half_planes_are_the_inside"];
const ALL_HITS: Function = ["moller_trumbore", "hit_solves_the_equations"];
const INTERVAL: Function = ["moller_trumbore", "triangle_hits_keep_to_the_interval"];

/// All typical mistakes of the chapter.
#[rustfmt::skip]
pub const MISTAKES: &[Mistake] = &[
    mistake(CHORD, "sign_of_the_linear_term", "the linear term has the wrong sign: t = (-d.p +- root) / d.d"),
    mistake(CHORD, "four_times_the_constant",
        "the discriminant mixes two formulas: b*b - 4ac belongs to b = 2 d.p; with d.p itself it is (d.p)(d.p) - (d.d)(p.p - r*r)"),
    mistake(CHORD, "divided_by_twice_dd", "the divisor is d.d: the 2 of 2a has gone into d.p, which is half the linear coefficient"),
    mistake(CHORD, "radius_of_one", "p.p - 1 is for the slides' unit sphere: for the radius r it is p.p - r*r"),
    mistake(CHORD, "radius_not_squared", "the implicit equation is p.p = r*r: the radius is squared"),
    mistake(CHORD, "larger_root_first", "the roots are in the wrong order: with d.d > 0 the minus sign gives the smaller one, which comes first"),
    mistake(CHORD, "root_of_nothing", "the root is missing: (d.p)(d.p) - ... is the discriminant, its square root is what is added"),
    mistake(CHORD, "unit_direction_assumed",
        "d.d is left out: the second formula of the slide is for a direction of length 1, and nothing says that this one is"),
    mistake(CHORD, "tangent_forgotten", "a discriminant of 0 is a line that touches the sphere: it has one point, and a double root"),
    mistake(COUNT, "negative_discriminant_allowed", "the root of a negative number is NaN: a negative discriminant means None"),
    mistake(HALF_LINE, "behind_the_origin", "the smaller root may lie behind the origin: take the first that the ray reaches"),
    mistake(HALF_LINE, "near_root_only", "from inside the near root lies behind the origin, and the far one is the answer"),
    mistake(HALF_LINE, "far_root_first", "the nearest is wanted: try the smaller root first"),
    mistake(FIRST, "end_ignored", "the ray may end before the sphere: ray.reaches(t) knows both ends of the interval"),
    mistake(HALF_LINE, "start_at_zero", "the ray need not start at t = 0: ray.reaches(t) knows where its interval begins"),
    mistake(HALF_LINE, "start_included", "the start itself does not belong to the ray: t > start, or a surface hits itself"),
    mistake(FAR, "slides_quadratic", "this is the quadratic: at 1e8 radii (d.p)(d.p) and (d.d)(p.p) agree in all digits, and the radius is lost"),
    mistake(SAME, "speed_forgotten", "the half chord is a length; divided by |d| it becomes a difference of parameters"),
    mistake(SAME, "distance_not_squared", "by Pythagoras half the chord is the root of (r - h)(r + h), h the line's distance from the centre"),
    mistake(NEAR, "difference_of_near_numbers",
        "one of -b - root and -b + root cancels: compute q, where both terms have the same sign, and get the other root as c / q"),
    mistake(NEAR, "squares_subtracted", "p.p - r*r cancels next to the surface: write it as (|p| - r)(|p| + r)"),
    mistake(SLABS, "first_entry", "the line is in the box once it has entered the last slab: the entry is the largest of the three"),
    mistake(SLABS, "last_exit", "the line leaves the box when it leaves the first slab: the exit is the smallest of the three"),
    mistake(SLABS, "near_and_far_not_sorted", "for a negative direction the plane of max is met first: exchange the two parameters"),
    mistake(SLABS, "never_misses", "where the largest entry is later than the smallest exit, the line misses the box: None"),
    mistake(SLABS, "touching_forgotten", "entry = exit is a hit: an edge, a corner, a flat box"),
    mistake(SLABS, "ray_instead_of_line", "the whole line is asked for: the entry may be negative, where the ray starts inside"),
    mistake(SLABS, "parallel_ignored", "with d = 0 in an axis the line may still be outside that slab: then it misses the box"),
    mistake(SLABS, "parallel_misses", "with d = 0 in an axis the line may be inside that slab everywhere: then the other slabs decide"),
    mistake(SLABS, "open_slab", "a line in the plane of a face is in the slab: min <= o <= max"),
    mistake(MAXIMUM, "maximum_forgotten",
        "the best distance starts at the ray's own end, not at infinity, as on the slide: or what lies beyond the end is found"),
    mistake(LEAST, "last_hit", "this is the last member that is hit: keep a hit only if it is nearer than the best so far"),
    mistake(LEAST, "first_hit", "this is the first member that is hit, in the order of the list: ask all of them, and keep the nearest"),
    mistake(LEAST, "farthest", "this is the farthest hit: compare the other way round"),
    mistake(EQUALS, "last_of_equals", "at the same t the member with the smaller number is the answer: replace the best only by a nearer one, t < best"),
    mistake(HALF_PLANES, "reversed_t", "the sign of t: the way to the plane is a - o, not o - a"),
    mistake(HALF_PLANES, "reversed_normal", "the normal must turn with the corners: n = (b - a) x (c - a), or all three signs change"),
    mistake(HALF_PLANES, "one_start_for_all", "each half-plane begins at its own edge: (c - b) x (x - b), not (c - b) x (x - a)"),
    mistake(HALF_PLANES, "last_edge_reversed", "go round: the third edge runs from c to a, as the first runs from a to b"),
    mistake(HALF_PLANES, "last_edge_forgotten", "three half-planes are needed: two bound a wedge"),
    mistake(HALF_PLANES, "open_half_planes", "edges and corners belong to the triangle: >= 0, or a mesh has cracks"),
    mistake(HALF_PLANES, "line_for_ray", "the plane may lie behind the origin: ask ray.reaches(t)"),
    mistake(HALF_PLANES, "exchanged_weights", "the weight of b is the half-plane of the edge from c to a, the weight of c that of the edge from a to b"),
    mistake(HALF_PLANES, "first_two_weights", "the parameters are the weights of b and of c; the weight of a is what is left"),
    mistake(HALF_PLANES, "weights_not_divided", "the half-planes give n.n times the weights: divide"),
    mistake(HALF_PLANES, "reversed_side", "against the normal, d.n < 0, the ray hits the front"),
    mistake(ALL_HITS, "fixed_threshold", "the determinant scales with the triangle and the direction: only zero is zero"),
    mistake(ALL_HITS, "front_only", "a triangle has two sides: the determinant may be negative"),
    mistake(ALL_HITS, "square_for_triangle", "v <= 1 and w <= 1 bound a parallelogram: the triangle needs v + w <= 1"),
    mistake(ALL_HITS, "open_border", "edges and corners belong to the triangle: >= and <="),
    mistake(ALL_HITS, "line_for_the_ray", "the hit may lie behind the origin: ask ray.reaches(t)"),
    mistake(ALL_HITS, "start_is_included", "the start itself does not belong to the ray: ray.reaches(t) knows it"),
    mistake(INTERVAL, "end_is_ignored", "the ray may end before the triangle: ray.reaches(t) knows it"),
    mistake(ALL_HITS, "undivided_t", "t is a quotient, too: divide by the determinant"),
    mistake(ALL_HITS, "weights_exchanged", "v belongs to b and comes with p, w belongs to c and comes with q"),
    mistake(ALL_HITS, "weights_of_a_and_b", "the parameters are the weights of b and of c"),
    mistake(ALL_HITS, "side_reversed", "the determinant is -d.n: where it is positive, the ray hits the front"),
    mistake(ONCE, "asked_twice", "each member is asked twice: keep its hit in a variable"),
];

/// Whether this is a mistake of one of these functions.
fn is_of(functions: &[Function], name: &str) -> bool {
    let of = |mistake: &Mistake| functions.contains(&[mistake.exercise, mistake.rejected_by]);
    MISTAKES
        .iter()
        .any(|mistake| mistake.name == name && of(mistake))
}

/// Prints the mistakes for the grader: name, exercise and rejecting theorem, with tabs between.
#[test]
#[ignore = "a list for the grader, not a check"]
fn list_mistakes() {
    mistake::print_all(MISTAKES);
}
