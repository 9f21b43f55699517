//! Which typical mistake does the code under test behave like? Each suspect function tries it on a few fixed inputs that tell
//! all of them apart.

use std::panic::{AssertUnwindSafe, catch_unwind};

use facette::bspline::{
    BsplineSurface, KnotVector, basis_functions, cox_de_boor, de_boor_point, find_span,
    insert_knot, surface_point,
};

use crate::common::exact::{Exact, fraction};
use crate::common::law::LikelyMistake;
use crate::inputs::Point;
use crate::mistakes::{self, MISTAKES};

/// A knot vector with knots that are repeated inside and outside the domain, and none of whose spans are alike.
fn knots(degree: usize, knots: &[i32]) -> KnotVector<Exact> {
    let knots = knots.iter().map(|&knot| fraction(knot, 1)).collect();
    KnotVector::new(degree, knots).expect("these knots are valid")
}

/// Clamped, with a double knot; with simple knots throughout; with empty spans at both ends of the domain.
fn knot_vectors() -> [KnotVector<Exact>; 3] {
    [
        knots(3, &[0, 0, 0, 0, 1, 3, 3, 4, 9, 9, 9, 9]),
        knots(2, &[-2, -1, 0, 2, 3, 7, 8, 10]),
        knots(2, &[-1, 0, 1, 1, 3, 5, 5, 7, 8]),
    ]
}

/// Parameters inside spans, at knots, at both ends of the domain and outside it.
fn parameters() -> Vec<Exact> {
    let places = [
        [0, 1],
        [1, 2],
        [2, 1],
        [3, 1],
        [7, 2],
        [5, 1],
        [7, 1],
        [9, 1],
        [-1, 2],
        [19, 2],
    ];
    places.map(|[a, b]| fraction(a, b)).to_vec()
}

/// Control points without symmetries.
fn points(count: usize) -> Vec<Point> {
    let point = |k: i32| {
        [
            fraction(k * k, 1),
            fraction(3 * k - k * k * k, 2),
            fraction(7, k + 2),
        ]
    };
    (0..).take(count).map(point).collect()
}

/// What a piece of code does: a value, or a panic.
fn outcome<T>(code: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(code)).ok()
}

/// The mistake among those of `exercise` that agrees with the code under test; otherwise `general`. `agrees` says nothing of a
/// mistake that is one of another function.
fn found(
    exercise: &str,
    general: &'static str,
    agrees: impl Fn(&str) -> Option<bool>,
) -> LikelyMistake {
    let mut candidates = MISTAKES
        .iter()
        .filter(|mistake| mistake.exercise == exercise);
    match candidates.find(|mistake| agrees(mistake.name) == Some(true)) {
        Some(mistake) => LikelyMistake {
            name: mistake.name,
            hint: mistake.hint,
        },
        None => LikelyMistake {
            name: "",
            hint: general,
        },
    }
}

/// Whether wrong and present code do the same on all inputs; `None` where the wrong code is none of the mistakes of this function.
fn alike<I, T: PartialEq>(
    inputs: &[I],
    wrong: impl Fn(&I) -> Option<T>,
    present: impl Fn(&I) -> T,
) -> Option<bool> {
    let mut is_alike = true;
    for input in inputs {
        let imitated = match outcome(|| wrong(input)) {
            Some(None) => return None,
            Some(Some(value)) => Some(value),
            None => None,
        };
        is_alike = is_alike && imitated == outcome(|| present(input));
    }
    Some(is_alike)
}

/// A knot vector and a parameter.
type Place = (KnotVector<Exact>, Exact);

fn places() -> Vec<Place> {
    let vectors = knot_vectors().into_iter();
    vectors
        .flat_map(|vector| parameters().into_iter().map(move |u| (vector.clone(), u)))
        .collect()
}

/// Those whose parameter lies in the domain.
fn inner_places() -> Vec<Place> {
    let is_inside = |(vector, u): &Place| {
        let [start, end] = vector.domain();
        start <= *u && *u <= end
    };
    places().into_iter().filter(is_inside).collect()
}

/// Suspects for `find_span`, `cox_de_boor` and `basis_functions`.
pub fn basis() -> LikelyMistake {
    let general = "check find_span at a repeated knot and at the end of the domain, then each term of the recursion by hand for p = 1";
    let (all, inner) = (places(), inner_places());
    found("basis", general, |name| {
        let of_span = || {
            alike(
                &all,
                |(knots, u)| mistakes::find_span(name, knots, *u),
                |(knots, u)| find_span(knots, *u),
            )
        };
        let of_recursion = || {
            alike(
                &inner,
                |place| wrong_recursion(name, place),
                present_recursion,
            )
        };
        let of_triangle = || {
            let wrong =
                |(knots, u): &Place| mistakes::basis_functions(name, knots, span_of(knots, *u), *u);
            alike(&inner, wrong, present_values)
        };
        of_span().or_else(of_recursion).or_else(of_triangle)
    })
}

/// The span of a parameter of the domain.
fn span_of(knots: &KnotVector<Exact>, u: Exact) -> usize {
    let starts_before = |span: &usize| knots.knots()[*span] <= u;
    knots
        .spans()
        .filter(starts_before)
        .last()
        .expect("the domain starts with a span")
}

fn wrong_recursion(name: &str, (knots, u): &Place) -> Option<Vec<Exact>> {
    let value = |i| mistakes::cox_de_boor(name, knots, knots.degree(), i, *u);
    (0..knots.control_point_count()).map(value).collect()
}

fn present_recursion((knots, u): &Place) -> Vec<Exact> {
    let value = |i| cox_de_boor(knots, knots.degree(), i, *u);
    (0..knots.control_point_count()).map(value).collect()
}

fn present_values((knots, u): &Place) -> Vec<Exact> {
    let mut values = vec![fraction(0, 1); knots.degree() + 1];
    basis_functions(knots, span_of(knots, *u), *u, &mut values);
    values
}

/// Suspects for `de_boor_point`.
pub fn curve() -> LikelyMistake {
    let general = "write down the points of all levels for p = 2 by hand, and compare them with those of your loop";
    let inputs = inner_places();
    found("curve", general, |name| {
        let wrong = |(knots, u): &Place| {
            mistakes::de_boor_point(name, knots, &points(knots.control_point_count()), *u)
        };
        alike(&inputs, wrong, |(knots, u)| {
            de_boor_point(knots, &points(knots.control_point_count()), *u)
        })
    })
}

/// Suspects for `insert_knot`.
pub fn insertion() -> LikelyMistake {
    let general =
        "count the three parts: k-p+1 points before, p mixed ones, and all from P_k on behind";
    let inputs = inner_places();
    found("insertion", general, |name| {
        let wrong = |(knots, u): &Place| {
            mistakes::insert_knot(name, knots, &points(knots.control_point_count()), *u)
        };
        alike(&inputs, wrong, |(knots, u)| {
            insert_knot(knots, &points(knots.control_point_count()), *u)
        })
    })
}

/// A surface and a parameter pair.
type Probe<'a> = (&'a BsplineSurface<Point>, [Exact; 2]);

/// Suspects for `surface_point`.
pub fn surface() -> LikelyMistake {
    let general = "check each of the five steps: which knots, which parameter, which degree, which index of the net";
    let [in_u, in_v, _] = knot_vectors();
    let net = |knots: [KnotVector<Exact>; 2]| {
        let counts = knots.each_ref().map(KnotVector::control_point_count);
        BsplineSurface::new(knots, points(counts[0] * counts[1]))
            .expect("as many points as asked for")
    };
    let surfaces = [net([in_u.clone(), in_v.clone()]), net([in_v, in_u])];
    let pairs = [
        [[1, 2], [5, 2]],
        [[2, 1], [3, 1]],
        [[5, 1], [6, 1]],
        [[3, 1], [1, 1]],
    ];
    let pairs = pairs.map(|pair| pair.map(|[a, b]| fraction(a, b)));
    let inputs: Vec<_> = surfaces
        .iter()
        .flat_map(|surface| pairs.map(|pair| (surface, pair)))
        .collect();
    found("surface", general, |name| {
        let wrong = |(surface, [u, v]): &Probe| mistakes::surface_point(name, surface, *u, *v);
        alike(&inputs, wrong, |(surface, [u, v])| {
            surface_point(surface, *u, *v)
        })
    })
}

/// Suspects for what no exercise asks the reader to write.
pub fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "a defect of the library: no exercise replaces this code",
    }
}
