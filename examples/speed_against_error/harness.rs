//! The harness: runs the variants of a quantity in turn, and holds their time against their error.
//!
//! A chapter hands over one [`Comparison`] after the other. A variant of points ([`Comparison::variant`]) fills a list of points, whose
//! exact values are known. A variant of answers ([`Comparison::answers`]) says for each question, such as a ray, what is met and where; its
//! error is that of t where both it and the truth meet something, and the share of its answers that are wrong has a column of its own.

use std::cell::LazyCell;
use std::hint::black_box;
use std::rc::Rc;
use std::time::Instant;

use facette::algebra::Scalar;
use num_traits::ToPrimitive;

use crate::answers::{Answer, AnswerBatch, Truths};
use crate::common::oracle::{Big, big, ulp};
use crate::float_inputs::{FloatPoint, coordinates};

/// A point without rounding.
pub type ExactPoint = [Big; 3];

/// Values that variants share, computed when first asked for.
pub type Shared<'a, T> = Rc<LazyCell<Vec<T>, Box<dyn FnOnce() -> Vec<T> + 'a>>>;

/// The exact points that variants share.
pub type Exact<'a> = Shared<'a, ExactPoint>;

/// The values that `compute` gives.
pub fn lazily<'a, T>(compute: impl FnOnce() -> Vec<T> + 'a) -> Shared<'a, T> {
    Rc::new(LazyCell::new(Box::new(compute)))
}

/// How long to measure.
#[derive(Clone, Copy)]
pub struct Effort {
    /// How often each variant gets its turn.
    pub rounds: usize,
    /// How long a turn lasts, in nanoseconds.
    pub turn: f64,
    /// How many points of a patch are evaluated, the square of an even number.
    pub points: usize,
    /// How long all turns of a comparison may last, in nanoseconds: where single runs take long, there are fewer rounds.
    pub budget: f64,
}

/// How far a variant is from the exact values.
#[derive(Clone, Copy)]
pub struct Errors {
    /// The largest error in ulps.
    pub ulps: f64,
    /// The largest absolute error.
    pub largest: f64,
    /// The root mean square of the absolute error.
    pub rms: f64,
    /// The share of wrong answers, where there are answers.
    pub wrong: Option<f64>,
}

/// What a variant computes, and how far it is from the exact values.
pub trait Batch {
    /// Evaluates everything once.
    fn run(&mut self);
    /// The errors; `None` for a yardstick, which has no exact values.
    fn errors(&self) -> Option<Errors>;
}

struct PointBatch<'a, P, F> {
    points: Vec<P>,
    fill: F,
    exact: Option<Exact<'a>>,
}

impl<P: FloatPoint, F: FnMut(&mut [P])> Batch for PointBatch<'_, P, F> {
    fn run(&mut self) {
        (self.fill)(&mut self.points);
        black_box(&mut self.points);
    }

    fn errors(&self) -> Option<Errors> {
        let exact = self.exact.as_ref()?;
        assert_eq!(self.points.len(), exact.len(), "one exact value a point");
        let roundoff = P::Scalar::unit_roundoff().into();
        let mut worst = [0.0_f64; 2];
        let mut squares = 0.0;
        for (&point, exact) in self.points.iter().zip(exact.iter()) {
            let errors = differences(coordinates(point), exact);
            let largest = errors.into_iter().fold(0.0, f64::max);
            let size = exact.iter().map(|value| nearest(value).abs());
            let spacing = ulp(size.fold(0.0, f64::max), roundoff);
            worst = [worst[0].max(largest / spacing), worst[1].max(largest)];
            squares += errors.into_iter().map(|error| error * error).sum::<f64>();
        }
        let count = 3.0 * self.points.len() as f64;
        Some(Errors {
            ulps: worst[0],
            largest: worst[1],
            rms: (squares / count).sqrt(),
            wrong: None,
        })
    }
}

fn differences(computed: [f64; 3], exact: &ExactPoint) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let is_finite = computed[axis].is_finite();
        if is_finite {
            nearest(&(big(computed[axis]) - &exact[axis])).abs()
        } else {
            f64::INFINITY
        }
    })
}

/// The floating-point number nearest to a value.
pub fn nearest(value: &Big) -> f64 {
    value.to_f64().unwrap_or(f64::INFINITY)
}

/// One way to compute a quantity with one type of numbers.
pub struct Variant<'a> {
    algorithm: &'static str,
    scalar: &'static str,
    threads: usize,
    batch: Box<dyn Batch + 'a>,
}

/// All ways to compute one quantity on one set of inputs. The first is the baseline of the ratios.
pub struct Comparison<'a> {
    quantity: &'static str,
    inputs: &'static str,
    evaluations: usize,
    size: usize,
    points_each: usize,
    budget: f64,
    variants: Vec<Variant<'a>>,
}

impl<'a> Comparison<'a> {
    /// A comparison without variants; every run of a variant is so many `evaluations`.
    pub fn new(quantity: &'static str, inputs: &'static str, evaluations: usize) -> Self {
        Self {
            quantity,
            inputs,
            evaluations,
            size: evaluations,
            points_each: 1,
            budget: f64::INFINITY,
            variants: Vec::new(),
        }
    }

    /// The same comparison of evaluations that make so many points each.
    pub fn with_points_each(self, points_each: usize) -> Self {
        Self {
            points_each,
            ..self
        }
    }

    /// The same comparison on a problem of this size, for the column `n`, where that is not the number of evaluations.
    pub fn of_size(self, size: usize) -> Self {
        Self { size, ..self }
    }

    /// The same comparison, all turns of which last no longer than so many nanoseconds where three rounds suffice for that.
    pub fn within(self, budget: f64) -> Self {
        Self { budget, ..self }
    }

    /// Adds a variant that fills a list of points, one for each of the `exact` values.
    pub fn variant<P: FloatPoint>(
        self,
        [algorithm, scalar]: [&'static str; 2],
        exact: &Exact<'a>,
        fill: impl FnMut(&mut [P]) + 'a,
    ) -> Self {
        let points = vec![P::origin(); self.evaluations * self.points_each];
        let exact = Some(Rc::clone(exact));
        self.push(
            [algorithm, scalar],
            PointBatch {
                points,
                fill,
                exact,
            },
        )
    }

    /// Adds a variant that answers as many questions as there are evaluations, with a truth for each. `scalar` is `f32` or `f64`.
    pub fn answers(
        self,
        names: [&'static str; 2],
        truths: &Truths<'a>,
        fill: impl FnMut(&mut [Option<Answer>]) + 'a,
    ) -> Self {
        let batch = AnswerBatch::new(names[1], self.evaluations, truths, fill);
        self.push(names, batch)
    }

    fn push(mut self, [algorithm, scalar]: [&'static str; 2], batch: impl Batch + 'a) -> Self {
        assert!(
            !algorithm.contains(','),
            "a comma in \"{algorithm}\" would end its cell"
        );
        self.variants.push(Variant {
            algorithm,
            scalar,
            threads: 1,
            batch: Box::new(batch),
        });
        self
    }

    /// Says that the variant added last runs on so many threads.
    pub fn on_threads(mut self, threads: usize) -> Self {
        if let Some(variant) = self.variants.last_mut() {
            variant.threads = threads;
        }
        self
    }

    /// Adds a yardstick: work that has a time but no error.
    pub fn yardstick<P: FloatPoint>(
        self,
        [algorithm, scalar]: [&'static str; 2],
        fill: impl FnMut(&mut [P]) + 'a,
    ) -> Self {
        let points = vec![P::origin(); self.evaluations];
        let exact = None;
        self.push(
            [algorithm, scalar],
            PointBatch {
                points,
                fill,
                exact,
            },
        )
    }

    /// Runs the variant of this name so many times; false where there is none.
    pub fn repeat(&mut self, name: &str, times: usize) -> bool {
        let [quantity, inputs] = [self.quantity, self.inputs];
        let found = self.variants.iter_mut().find(|variant| {
            let Variant {
                algorithm, scalar, ..
            } = variant;
            name == format!("{quantity}/{algorithm}/{scalar}/{inputs}")
        });
        let Some(variant) = found else { return false };
        (0..times).for_each(|_| variant.batch.run());
        true
    }

    /// Measures all variants, in turn.
    pub fn measure(mut self, effort: Effort) -> Vec<Row> {
        let (mut of_variants, mut round) = (Vec::new(), 0.0);
        for variant in &mut self.variants {
            let once = time(variant, 3).max(1.0);
            of_variants.push(repetitions(effort.turn / once));
            round += once.max(effort.turn);
        }
        let mut times = vec![Vec::new(); self.variants.len()];
        for _ in 0..repetitions(effort.budget.min(self.budget) / round).clamp(3, effort.rounds) {
            for (index, variant) in self.variants.iter_mut().enumerate() {
                let turn = time(variant, of_variants[index]);
                times[index].push(turn / self.evaluations as f64);
            }
        }
        let baseline = times[0].clone();
        let rows = self.variants.iter().zip(times);
        rows.map(|(variant, times)| self.row(variant, times, &baseline))
            .collect()
    }

    fn row(&self, variant: &Variant<'_>, times: Vec<f64>, baseline: &[f64]) -> Row {
        let ratios = times.iter().zip(baseline).map(|(time, base)| time / base);
        let [_, ratio, _] = quartiles(ratios.collect());
        let [low, median, high] = quartiles(times);
        Row {
            quantity: self.quantity,
            algorithm: variant.algorithm,
            scalar: variant.scalar,
            threads: variant.threads,
            inputs: self.inputs,
            size: self.size,
            nanoseconds: median,
            spread: (high - low) / median,
            ratio,
            errors: variant.batch.errors(),
        }
    }
}

/// How often to run a variant that fits so many times into a turn.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a positive number of moderate size"
)]
fn repetitions(fitting: f64) -> usize {
    fitting.clamp(1.0, 1e9).ceil() as usize
}

/// The nanoseconds of one run, as the mean of so many.
fn time(variant: &mut Variant<'_>, repetitions: usize) -> f64 {
    let start = Instant::now();
    for _ in 0..repetitions {
        variant.batch.run();
    }
    start.elapsed().as_nanos() as f64 / repetitions as f64
}

/// The lower quartile, the median and the upper quartile.
fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let last = values.len() - 1;
    [last / 4, last / 2, last - last / 4].map(|index| values[index])
}

/// A line of the report.
pub struct Row {
    quantity: &'static str,
    algorithm: &'static str,
    scalar: &'static str,
    threads: usize,
    inputs: &'static str,
    size: usize,
    nanoseconds: f64,
    spread: f64,
    ratio: f64,
    errors: Option<Errors>,
}

impl Row {
    /// The names of the cells.
    pub const COLUMNS: [&str; 13] = [
        "quantity",
        "algorithm",
        "scalar",
        "threads",
        "inputs",
        "n",
        "ns_per_eval",
        "spread",
        "ratio",
        "max_ulp",
        "max_abs",
        "rms",
        "wrong",
    ];

    /// The cells as text; those of the errors are empty for a yardstick.
    pub fn cells(&self) -> [String; 13] {
        let errors = self.errors;
        let wrong = errors.and_then(|errors| errors.wrong);
        let scientific = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:.2e}"));
        [
            self.quantity.to_owned(),
            self.algorithm.to_owned(),
            self.scalar.to_owned(),
            self.threads.to_string(),
            self.inputs.to_owned(),
            self.size.to_string(),
            format!("{:.2}", self.nanoseconds),
            format!("{:.3}", self.spread),
            format!("{:.3}", self.ratio),
            errors.map_or(String::new(), |errors| short(errors.ulps)),
            scientific(errors.map(|errors| errors.largest)),
            scientific(errors.map(|errors| errors.rms)),
            wrong.map_or(String::new(), share),
        ]
    }
}

/// A share of all answers: 0 says that none is wrong.
fn share(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.1e}")
    }
}

/// A number of ulps: with a fraction where it is small, in powers of ten where it is large.
fn short(value: f64) -> String {
    if value < 1e4 {
        format!("{value:.2}")
    } else {
        format!("{value:.2e}")
    }
}
