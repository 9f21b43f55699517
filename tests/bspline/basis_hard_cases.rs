//! Knots and parameters that break the textbook formulas of the basis functions, what survives them, and both shown.

use facette::bspline::{
    BsplineCurve, KnotVector, basis_derivatives, basis_functions, cox_de_boor, find_span,
};
use num_traits::ToPrimitive;

use crate::common::oracle::{Big, big, big_bspline_basis};

const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// The knot vector of these knots.
fn vector(degree: usize, knots: &[f64]) -> KnotVector<f64> {
    KnotVector::new(degree, knots.to_vec()).expect("the hard cases' knots are valid")
}

/// The span of `u` and the values there.
fn values_at(knots: &KnotVector<f64>, u: f64) -> (usize, Vec<f64>) {
    let span = find_span(knots, u);
    let mut values = vec![f64::NAN; knots.degree() + 1];
    basis_functions(knots, span, u, &mut values);
    (span, values)
}

/// The exact values of the functions of the span.
fn exact_values(knots: &KnotVector<f64>, u: f64) -> Vec<Big> {
    let (span, degree) = (find_span(knots, u), knots.degree());
    let all = big_bspline_basis(degree, knots.knots(), &big(u), knots.domain()[1]);
    all[span - degree..=span].to_vec()
}

/// The largest relative error of the values at `u`, in unit roundoffs. What is exactly 0 must come out as 0, and what is smaller than
/// every normal number as something not larger.
fn relative_error(knots: &KnotVector<f64>, u: f64) -> f64 {
    let exact = exact_values(knots, u);
    let (_, values) = values_at(knots, u);
    let errors = values.iter().zip(&exact).map(|(&value, exact)| {
        if *exact < big(f64::MIN_POSITIVE) {
            let is_exact_zero = *exact == big(0.0) && value == 0.0;
            let is_tiny = *exact > big(0.0) && (0.0..=f64::MIN_POSITIVE).contains(&value);
            return if is_exact_zero || is_tiny {
                0.0
            } else {
                f64::INFINITY
            };
        }
        let error = (big(value) - exact) / exact / big(UNIT_ROUNDOFF);
        error.to_f64().expect("a ratio of finite numbers").abs()
    });
    errors.fold(0.0, f64::max)
}

/// Passes where the relative error is within its bound: each of the p levels multiplies a value with a ratio of two differences (three
/// roundings) and adds (one more after the product), all terms being positive, `5p` roundings in all, and a thousandth for terms in u².
fn assert_relatively_exact(name: &str, knots: &KnotVector<f64>, parameters: &[f64]) {
    let bound = 5.0 * knots.degree().to_f64().expect("a small degree") * 1.001;
    for &u in parameters {
        let error = relative_error(knots, u);
        assert!(
            error <= bound,
            "{name}: {error} unit roundoffs at {u:e}, more than {bound}"
        );
    }
}

/// The triangle as textbooks print it (algorithm A2.2 of The NURBS Book): the lower value is divided by the sum of two distances
/// first, and multiplied afterwards.
fn textbook_triangle(knots: &KnotVector<f64>, u: f64) -> Vec<f64> {
    let (span, p, knots) = (find_span(knots, u), knots.degree(), knots.knots());
    let mut values = vec![1.0];
    for j in 1..=p {
        let mut saved = 0.0;
        for r in 0..j {
            let right = knots[span + r + 1] - u;
            let left = u - knots[span + 1 + r - j];
            let quotient = values[r] / (right + left);
            values[r] = saved + right * quotient;
            saved = left * quotient;
        }
        values.push(saved);
    }
    values
}

/// **Knots next to zero.** $U=\{0,0,0,0,\varepsilon,2\varepsilon,3\varepsilon,1,1,1,1\}$ with $\varepsilon=2^{-1074}$, the smallest number there is: at $u=\varepsilon$ the four cubics are
/// $\tfrac14,\tfrac7{12},\tfrac16,0$. The textbook's triangle divides by a distance first: $1/\varepsilon$ is infinite, and infinity times zero is not a number. Taken as ratios $(u-u_i)/(u_{i+d}-u_i)$, all weights are
/// between 0 and 1, and the values come out to the last bit but one.
#[test]
fn denormal_knots_give_ordinary_values() {
    let tiny = f64::from_bits(1);
    let knots = vector(
        3,
        &[0., 0., 0., 0., tiny, 2. * tiny, 3. * tiny, 1., 1., 1., 1.],
    );
    let expected = [1. / 4., 7. / 12., 1. / 6., 0.0];
    let (span, values) = values_at(&knots, tiny);
    assert_eq!(span, 4);
    for (value, expected) in values.iter().zip(expected) {
        assert!(
            (value - expected).abs() <= 2.0 * f64::EPSILON * expected,
            "{value} for {expected}"
        );
    }
    assert!(
        textbook_triangle(&knots, tiny)
            .iter()
            .any(|value| value.is_nan())
    );
    assert_relatively_exact("denormal", &knots, &[tiny, 2. * tiny]);
}

/// **Knots as far apart as numbers go.** $U=\{-M,-M,-M,0,M,M,M\}$ with $M=1.7\cdot10^{308}$, $p=2$: at $u=0$ the functions are $\tfrac12,\tfrac12,0$. The width $2M$ of a support overflows to infinity, and the textbook's
/// values do not even sum to one. Here both distances of such a ratio are halved first: no error at all.
#[test]
fn width_that_overflows_is_halved() {
    let m = 1.7e308;
    let knots = vector(2, &[-m, -m, -m, 0.0, m, m, m]);
    assert_eq!(values_at(&knots, 0.0), (3, vec![0.5, 0.5, 0.0]));
    let naive: f64 = textbook_triangle(&knots, 0.0).iter().sum();
    assert_ne!(naive, 1.0);
    assert_relatively_exact(
        "overflow",
        &knots,
        &[-m, -m / 3.0, -1.0, 1e-300, m / 2.0, m],
    );
    let curve = BsplineCurve::new(knots, vec![1.0, 2.0, 3.0, 4.0]).expect("four control points");
    assert!(curve.derivative_at(1, 0.0).is_finite());
}

/// **Knots that coincide by rounding.** Next to $10^8$ numbers are $2^{-26}\approx1.5\cdot10^{-8}$ apart. Knots meant to be $10^8+k\cdot10^{-8}$ are rounded, and some of them become double: $k=1,2$ and $k=4,5$. The answer is that of the knots that are
/// *stored*; it is as exact as any, since differences of neighbouring numbers are exact. Whoever counts on simple knots divides by zero.
#[test]
fn knots_that_coincide_by_rounding_are_double_knots() {
    let stored: Vec<f64> = (0..=15).map(|k| 1e8 + f64::from(k) * 1e-8).collect();
    let knots = vector(3, &stored);
    let multiplicity = |k: usize| knots.multiplicity(stored[k]);
    assert_eq!([1, 2, 4, 5].map(multiplicity), [2; 4]);
    assert_eq!([0, 3, 6].map(multiplicity), [1; 3]);
    let inner: Vec<f64> = stored[3..=12].to_vec();
    assert_relatively_exact("offset 1e8, step 1e-8", &knots, &inner);
}

/// **Far from zero.** For knots $10^8+k\cdot2^{-20}$ the first cubic of a span is $\frac{(u-a)^3}{6h^3}$ with $h=2^{-20}$, between 0 and $\tfrac16$. Written as a polynomial in $u$, it is a difference of numbers near $10^{41}$, and comes out as anything but that.
/// The recursion subtracts $u-a$ first, without any error.
#[test]
fn monomials_lose_everything_far_from_zero() {
    let h = 2.0_f64.powi(-20);
    let stored: Vec<f64> = (0..=10).map(|k| 1e8 + f64::from(k) * h).collect();
    let knots = vector(3, &stored);
    let a = stored[3];
    let cubic = 2.0_f64.powi(60) / 6.0;
    let monomials = [
        -a * a * a * cubic,
        3.0 * a * a * cubic,
        -3.0 * a * cubic,
        cubic,
    ];
    let mut worst: f64 = 0.0;
    for eighth in 1..8 {
        let part = f64::from(eighth) / 8.0;
        let u = a + part * h;
        let horner = monomials
            .iter()
            .rev()
            .fold(0.0, |sum, &coefficient| sum * u + coefficient);
        worst = worst.max((horner - part * part * part / 6.0).abs());
        let (_, values) = values_at(&knots, u);
        assert!((values[3] - part * part * part / 6.0).abs() <= 8.0 * UNIT_ROUNDOFF / 6.0);
    }
    assert!(worst > 1e6, "the monomials are wrong by {worst}");
    let parameters: Vec<f64> = (24..=56)
        .map(|eighth| 1e8 + f64::from(eighth) * h / 8.0)
        .collect();
    assert_relatively_exact("offset 1e8, step 2^-20", &knots, &parameters);
}

/// **Four neighbours.** $U=\{0,0,0,0,1,1^+,1^{++},1^{+++},2,2,2,2\}$, where $x^+$ is the number after $x$. At $u=1$ the cubics are about $4.9\cdot10^{-32}$, $6.7\cdot10^{-16}$, $1-6.7\cdot10^{-16}$ and 0. Each has a small *relative* error, the tiny ones too: nothing is ever
/// subtracted from anything but a knot from a parameter.
#[test]
fn cluster_of_neighbouring_knots_keeps_tiny_values() {
    let [a, b, c] = [
        1.0_f64.next_up(),
        1.0_f64.next_up().next_up(),
        1.0 + 3.0 * f64::EPSILON,
    ];
    let knots = vector(3, &[0., 0., 0., 0., 1., a, b, c, 2., 2., 2., 2.]);
    let (span, values) = values_at(&knots, 1.0);
    assert_eq!(span, 4);
    assert!((4.9e-32..5.0e-32).contains(&values[0]) && (6.6e-16..6.7e-16).contains(&values[1]));
    assert!(values[2] < 1.0 && values[3] == 0.0);
    assert_relatively_exact(
        "cluster",
        &knots,
        &[0.5, 1.0_f64.next_down(), 1.0, a, b, c, 1.5],
    );
}

/// **A knot that stands $p+1$ times inside.** Over $U=\{0,0,0,\tfrac12,\tfrac12,\tfrac12,1,1,1\}$, $p=2$, the two halves have nothing in common. At $\tfrac12$ the functions of the right half are $(1,0,0)$; one number below it those of the left half end. The recursion meets $0/0$ there, which
/// must count as 0: computed as it stands, it is not a number.
#[test]
fn full_inner_multiplicity_parts_the_sides() {
    let knots = vector(2, &[0., 0., 0., 0.5, 0.5, 0.5, 1., 1., 1.]);
    assert_eq!(values_at(&knots, 0.5), (5, vec![1.0, 0.0, 0.0]));
    let below = 0.5_f64.next_down();
    let (span, values) = values_at(&knots, below);
    assert_eq!(span, 2);
    assert!(values[2] > 1.0 - 4.0 * f64::EPSILON && values[2] < 1.0);
    assert_relatively_exact(
        "full multiplicity",
        &knots,
        &[0.0, 0.25, below, 0.5, 0.75, 1.0],
    );
    let all = (0..6)
        .map(|i| cox_de_boor(&knots, 2, i, 0.5))
        .collect::<Vec<_>>();
    assert_eq!(all, [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    assert!(unguarded_recursion(knots.knots(), 2, 3, 0.5).is_nan());
}

/// The recursion without a rule for 0/0.
fn unguarded_recursion(knots: &[f64], degree: usize, i: usize, u: f64) -> f64 {
    if degree == 0 {
        return f64::from(u8::from(knots[i] <= u && u < knots[i + 1]));
    }
    let rising = (u - knots[i]) / (knots[i + degree] - knots[i]);
    let falling = (knots[i + degree + 1] - u) / (knots[i + degree + 1] - knots[i + 1]);
    rising * unguarded_recursion(knots, degree - 1, i, u)
        + falling * unguarded_recursion(knots, degree - 1, i + 1, u)
}

/// **The last point belongs.** At the end of the domain no half-open span holds $u$: a search that goes on until it finds one runs out of the knots, or finds an empty one. The last span that is not empty is the right one, and the last function is 1
/// there. The same for unclamped knots, where spans follow that do not belong to the domain, and one number before and after the end.
#[test]
fn end_of_the_domain_belongs_to_the_last_span() {
    let knots = vector(3, &[0., 0., 0., 0., 0.25, 0.5, 0.75, 1., 1., 1., 1.]);
    assert!(
        !knots
            .knots()
            .windows(2)
            .any(|span| span[0] <= 1.0 && 1.0 < span[1])
    );
    assert_eq!(values_at(&knots, 1.0), (6, vec![0.0, 0.0, 0.0, 1.0]));
    assert_eq!(find_span(&knots, 1.0_f64.next_down()), 6);
    assert_eq!(find_span(&knots, 1.0_f64.next_up()), 6);
    let floating = KnotVector::<f64>::uniform(3, 7).expect("more control points than the degree");
    let [start, end] = floating.domain();
    assert_eq!([start, end], [0.0, 4.0]);
    assert_eq!(
        [start, end.next_down(), end, end.next_up()].map(|u| find_span(&floating, u)),
        [3, 6, 6, 6]
    );
    let sum: f64 = values_at(&floating, end).1.iter().sum();
    assert!((sum - 1.0).abs() <= 4.0 * f64::EPSILON);
    let parted = vector(1, &[0., 0., 1., 1., 2.]);
    assert_eq!(parted.domain(), [0.0, 1.0]);
    assert_eq!(values_at(&parted, 1.0), (1, vec![0.0, 1.0]));
}

/// **High degrees.** Bernstein's polynomials of degree 20, 30 and 60, and uniform B-splines of degree 40: the relative error grows with the degree, as $5p\,\mathbf u$, and no faster, since all operations are sums and products of positive numbers. As a sum of monomials, the middle
/// polynomial of degree 60 is lost altogether: at $t=0.9$ it is $5\cdot10^{-15}$, and the sum is wrong by millions.
#[test]
fn high_degrees_keep_their_relative_error() {
    let parameters = [
        0.0,
        1e-3,
        0.1,
        1.0 / 3.0,
        0.5,
        0.9,
        0.999,
        1.0_f64.next_down(),
        1.0,
    ];
    for degree in [20, 30, 60] {
        assert_relatively_exact("Bernstein", &KnotVector::bezier(degree), &parameters);
    }
    let uniform = KnotVector::<f64>::uniform(40, 44).expect("more control points than the degree");
    let inside = parameters.map(|t| 4.0 * t);
    assert_relatively_exact("uniform", &uniform, &inside);
    let bernstein = KnotVector::bezier(60);
    let exact = exact_values(&bernstein, 0.9)[30]
        .to_f64()
        .expect("an ordinary number");
    let binomial = |n: u32, k: u32| {
        (0..k).fold(1.0, |product, j| {
            product * f64::from(n - j) / f64::from(j + 1)
        })
    };
    let power = |k: i32| 0.9_f64.powi(30 + k) * if k % 2 == 0 { 1.0 } else { -1.0 };
    let terms = (0..=30_u32).map(|k| binomial(30, k) * power(k.cast_signed()));
    let monomials = binomial(60, 30) * terms.sum::<f64>();
    assert!(
        (exact - 5e-15).abs() < 1e-15 && (monomials - exact).abs() > 1e6,
        "{monomials} for {exact}"
    );
}

/// **Outside the domain.** There the first or the last polynomial goes on: the values still sum to 1, but they alternate in sign and grow with the power $p$ of the distance. NaN gives NaN; an infinite parameter gives no
/// finite value; nothing hangs, and nothing panics.
#[test]
fn values_outside_the_domain_extrapolate() {
    let knots =
        KnotVector::<f64>::clamped_uniform(3, 7).expect("more control points than the degree");
    for (u, largest) in [(-1.0, 100.0), (2.0, 100.0), (10.0, 1e4)] {
        let (_, values) = values_at(&knots, u);
        let sum: f64 = values.iter().sum();
        let size: f64 = values.iter().map(|value| value.abs()).sum();
        assert!(
            size > largest,
            "at {u} the values have the size {size} only"
        );
        // Every operation is wrong by a part u of the size; there are fewer than 40 on the way to a value.
        assert!(
            (sum - 1.0).abs() <= 40.0 * UNIT_ROUNDOFF * size,
            "{sum} at {u}"
        );
        assert!(values.iter().any(|&value| value < 0.0));
    }
    for u in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (span, values) = values_at(&knots, u);
        assert!((3..7).contains(&span));
        assert!(
            !values.iter().any(|value| value.is_finite()),
            "{values:?} at {u}"
        );
    }
}

/// **Huge knots, and knots that shrink.** Knots $k\cdot10^{300}$, and knots $2^{-k}$ down to $2^{-1000}$: sizes do not matter, since every weight is a ratio of two distances.
#[test]
fn size_of_the_knots_does_not_matter() {
    let huge: Vec<f64> = (-5..=5).map(|k| f64::from(k) * 1e300).collect();
    let knots = vector(3, &huge);
    assert_relatively_exact("huge", &knots, &[-2e300, -1.5e300, 0.0, 1.0, 1e300, 2e300]);
    let shrinking: Vec<f64> = (0..=20).rev().map(|k| 2.0_f64.powi(-50 * k)).collect();
    let knots = vector(3, &shrinking);
    let parameters: Vec<f64> = (4..=16).map(|k| 2.0_f64.powi(-50 * k) * 1.5).collect();
    assert_relatively_exact("geometric", &knots, &parameters);
}

/// **Values below the smallest number.** Over the knots of the first case, at $u=10^{-300}$, two of the four cubics are smaller than any number: about $3\cdot10^{-600}$ and $10^{-900}$. They come out as 0, which is right to $10^{-300}$; the others keep their relative error, and the sum is 1.
#[test]
fn values_that_underflow_become_zero() {
    let tiny = f64::from_bits(1);
    let knots = vector(
        3,
        &[0., 0., 0., 0., tiny, 2. * tiny, 3. * tiny, 1., 1., 1., 1.],
    );
    let exact = exact_values(&knots, 1e-300);
    let (_, values) = values_at(&knots, 1e-300);
    for (&value, exact) in values.iter().zip(&exact) {
        let error = (big(value) - exact).to_f64().expect("a small number").abs();
        assert!(
            error <= 1e-300 + 15.0 * UNIT_ROUNDOFF * value,
            "{value:e} is wrong by {error:e}"
        );
    }
    assert_eq!(values[2..], [0.0, 0.0]);
    assert_eq!(values.iter().sum::<f64>(), 1.0);
}

/// **Derivatives at a repeated knot.** Where a knot stands $p$ times or more, the derivative jumps: the one given is that of the span behind it, and at the end of the domain that of the last span. The formula's $0/0$ does not occur, since each span has its own
/// polynomials.
#[test]
fn derivatives_at_a_repeated_knot_are_those_of_the_span_behind_it() {
    for times in [3, 4] {
        let inner = vec![1.0; times];
        let knots = [&[0.0; 4][..], &inner, &[2.0; 4]].concat();
        let knots = vector(3, &knots);
        let points: Vec<f64> = (0..knots.control_point_count())
            .map(|i| [0., 1., 3., 2., 7., 5., 6., 1.][i])
            .collect();
        let curve =
            BsplineCurve::new(knots.clone(), points.clone()).expect("one point for each function");
        let last = points.len() - 1;
        let (behind, end) = (
            3.0 * (points[last - 2] - points[last - 3]),
            3.0 * (points[last] - points[last - 1]),
        );
        assert_eq!(
            curve.derivative_at(1, 1.0),
            behind,
            "behind a knot that stands {times} times"
        );
        assert_eq!(curve.derivative_at(1, 2.0), end);
        assert_eq!(
            curve.derivative_at(1, 1.0_f64.next_down()).signum(),
            (points[3] - points[2]).signum()
        );
        let mut rows = [f64::NAN; 20];
        basis_derivatives(&knots, find_span(&knots, 1.0), 1.0, &mut rows);
        assert!(rows.iter().all(|value| value.is_finite()));
        assert_eq!(rows[4..8], [-3.0, 3.0, 0.0, 0.0]);
        assert_eq!(rows[16..], [0.0; 4], "the fourth derivatives of cubics");
    }
}
