//! The fragments of Rust that the page "Just enough Rust" shows. Each is compiled, and each `#[test]` runs.

use facette::algebra::{Scalar, VectorSpace};
use facette::curve::{BezierCurve, Curve, FunctionCurve};

// ANCHOR: function
/// The number halfway between two numbers.
fn middle(a: f64, b: f64) -> f64 {
    let sum = a + b;
    sum / 2.0
}
// ANCHOR_END: function

// ANCHOR: call
#[test]
fn middle_of_one_and_four() {
    let halfway = middle(1.0, 4.0);
    assert_eq!(halfway, 2.5);
}
// ANCHOR_END: call

// ANCHOR: semicolon
/// The cost of two things, and of the bag to carry them in.
fn cost(apple: f64, pear: f64) -> f64 {
    let fruit = apple + pear;
    let bag = 0.1;
    fruit + bag
}
// ANCHOR_END: semicolon

#[test]
fn cost_is_the_sum_of_three() {
    assert_eq!(cost(0.25, 0.5), 0.85);
}

// ANCHOR: struct
/// A rectangle with its sides along the axes.
struct Rectangle {
    width: f64,
    height: f64,
}

impl Rectangle {
    /// The length of the way around it.
    fn perimeter(&self) -> f64 {
        2.0 * (self.width + self.height)
    }
}
// ANCHOR_END: struct

// ANCHOR: destructuring
#[test]
fn rectangle_is_taken_apart() {
    let sheet = Rectangle {
        width: 3.0,
        height: 2.0,
    };
    assert_eq!(sheet.perimeter(), 10.0);

    let Rectangle { width, height } = sheet;
    assert_eq!(width * height, 6.0);
}
// ANCHOR_END: destructuring

// ANCHOR: arrays
#[test]
fn arrays_hold_several_values_of_one_type() {
    let point = [1.0, 2.0, 5.0];
    assert_eq!(point[0], 1.0);

    let [x, y, z] = point;
    assert_eq!(x + y + z, 8.0);

    let doubled = point.map(|coordinate| 2.0 * coordinate);
    assert_eq!(doubled, [2.0, 4.0, 10.0]);
}
// ANCHOR_END: arrays

// ANCHOR: five_operations
#[test]
fn five_operations_on_points() {
    let [p, q, r] = [[1.0, 2.0], [3.0, 6.0], [9.0, 0.0]];

    assert_eq!(p.plus(q), [4.0, 8.0]);
    assert_eq!(q.minus(p), [2.0, 4.0]);
    assert_eq!(p.times(3.0), [3.0, 6.0]);

    // A quarter of the way from p to q.
    assert_eq!(p.lerp(q, 0.25), [1.5, 3.0]);

    // Half of p, a quarter of q, a quarter of r.
    let mixture = VectorSpace::combination([0.5, 0.25, 0.25], [p, q, r]);
    assert_eq!(mixture, [3.5, 2.5]);
}
// ANCHOR_END: five_operations

// ANCHOR: chain
#[test]
fn calls_stand_in_a_row() {
    let [p, q, r] = [[1.0, 2.0], [3.0, 6.0], [2.0, 3.0]];
    let fourth_corner = p.plus(q).minus(r);
    assert_eq!(fourth_corner, [2.0, 5.0]);
}
// ANCHOR_END: chain

// ANCHOR: generic
/// The point halfway between the two ends of a curve, whatever curve it is and whatever its points are made of.
fn middle_of_ends<C: Curve>(curve: &C) -> C::Point {
    let [first, last] = curve.domain();
    let half = C::Scalar::ratio(1, 2);
    curve.point(first).lerp(curve.point(last), half)
}
// ANCHOR_END: generic

// ANCHOR: generic_call
#[test]
fn generic_function_takes_every_curve() {
    let parabola = FunctionCurve::new(|t: f64| [t, t * t]);
    assert_eq!(middle_of_ends(&parabola), [0.5, 0.5]);

    let line = FunctionCurve::new(|t: f32| [t, 0.0, 4.0 * t]);
    assert_eq!(middle_of_ends(&line), [0.5, 0.0, 2.0]);
}
// ANCHOR_END: generic_call

// ANCHOR: option
/// How much the direction of a curve changes from its first point to its last; `None` where it has no derivative.
fn turn<C: Curve>(curve: &C) -> Option<C::Point> {
    let [first, last] = curve.domain();
    let at_first = curve.derivative(first)?;
    let at_last = curve.derivative(last)?;
    Some(at_last.minus(at_first))
}
// ANCHOR_END: option

// ANCHOR: option_call
#[test]
fn question_mark_hands_none_on() {
    let unknown = FunctionCurve::new(|t: f64| [t, t * t]);
    assert_eq!(turn(&unknown), None);

    let known = unknown.with_derivative(|t| [1.0, 2.0 * t]);
    assert_eq!(turn(&known), Some([0.0, 2.0]));
}
// ANCHOR_END: option_call

// ANCHOR: todo
/// The area of a rectangle.
fn area(_rectangle: &Rectangle) -> f64 {
    todo!("area: width times height")
}
// ANCHOR_END: todo

#[test]
#[should_panic(expected = "not yet implemented: area: width times height")]
fn todo_stops_the_program() {
    let (width, height) = (1.0, 2.0);
    area(&Rectangle { width, height });
}

// ANCHOR: bezier
#[test]
fn arch_stands_on_its_ends() {
    let control_points = vec![[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];
    let arch = BezierCurve::new(control_points).expect("three points are enough");

    assert_eq!(arch.point(0.0), [0.0, 0.0]);
    assert_eq!(arch.point(0.5), [1.0, 1.0]);
    assert_eq!(arch.derivative(0.0), Some([2.0, 4.0]));
}
// ANCHOR_END: bezier

#[allow(
    clippy::needless_range_loop,
    clippy::assign_op_pattern,
    reason = "the page shows plain loops first"
)]
// ANCHOR: list
/// The mean of some numbers, at least one.
fn mean(numbers: &[f64]) -> f64 {
    let mut sum = 0.0;
    for index in 0..numbers.len() {
        sum = sum + numbers[index];
    }
    sum / numbers.len() as f64
}
// ANCHOR_END: list

// ANCHOR: list_call
#[test]
fn mean_of_a_growing_list() {
    let mut heights = vec![1.0, 2.0];
    heights.push(6.0);
    assert_eq!(mean(&heights), 3.0);
    assert_eq!(mean(&heights[1..=2]), 4.0);
}
// ANCHOR_END: list_call

// ANCHOR: if_else
/// The number itself, or 0 if it is negative.
fn at_least_zero(number: f64) -> f64 {
    if number < 0.0 { 0.0 } else { number }
}
// ANCHOR_END: if_else

#[test]
fn negative_numbers_become_zero() {
    assert_eq!([-2.0, 0.0, 3.0].map(at_least_zero), [0.0, 0.0, 3.0]);
}

#[allow(
    clippy::assign_op_pattern,
    reason = "the page has introduced no other operator"
)]
// ANCHOR: while
/// The place of the first number that is 0, or how many numbers there are if none is.
fn first_zero(numbers: &[f64]) -> usize {
    let mut place = 0;
    while place < numbers.len() && numbers[place] != 0.0 {
        place = place + 1;
    }
    place
}
// ANCHOR_END: while

#[allow(
    clippy::needless_range_loop,
    reason = "the page shows plain loops first"
)]
// ANCHOR: return
/// The same, with another loop.
fn first_zero_again(numbers: &[f64]) -> usize {
    for place in 0..numbers.len() {
        if numbers[place] == 0.0 {
            return place;
        }
    }
    numbers.len()
}
// ANCHOR_END: return

#[test]
fn both_loops_find_the_same_place() {
    for numbers in [&[3.0, 0.0, 0.0][..], &[0.0], &[1.0, 2.0], &[]] {
        assert_eq!(first_zero(numbers), first_zero_again(numbers));
    }
    assert_eq!(first_zero(&[3.0, 0.0, 0.0]), 1);
    assert_eq!(first_zero(&[1.0, 2.0]), 2);
}

#[allow(
    clippy::assign_op_pattern,
    reason = "the page has introduced no other operator"
)]
// ANCHOR: change
/// Replaces every number by its double.
fn double(numbers: &mut [f64]) {
    for number in numbers {
        *number = 2.0 * *number;
    }
}
// ANCHOR_END: change

#[test]
fn double_changes_what_it_is_given() {
    let mut pair = [1.0, 4.0];
    double(&mut pair);
    assert_eq!(pair, [2.0, 8.0]);
}
