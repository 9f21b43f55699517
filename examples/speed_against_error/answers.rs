//! Answers instead of points: what a ray meets, and where.

use std::hint::black_box;
use std::rc::Rc;

use facette::algebra::{Real, Scalar};

use crate::common::oracle::{Big, big, ulp};
use crate::harness::{Batch, Errors, Shared, nearest};

/// What a variant says that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The ray's parameter.
    pub t: f64,
    /// Which of several surfaces; 0 where there is only one.
    pub surface: u32,
}

impl Answer {
    /// The answer that this surface is met at `t`; `None` where it is not.
    pub fn of<S: Real>(t: Option<S>, surface: u32) -> Option<Self> {
        t.map(|t| Self {
            t: t.to_f64(),
            surface,
        })
    }

    /// Whether it names a surface that is met, at a place.
    fn agrees_with(&self, truth: &Truth) -> bool {
        self.t.is_finite() && truth.surfaces.contains(&self.surface)
    }
}

/// What a ray meets in truth.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The ray's parameter, exactly or to far more digits than a variant has.
    pub t: Big,
    /// Which of several surfaces: all that are met at this very parameter.
    pub surfaces: Vec<u32>,
}

/// The truths that variants share; `None` for a ray that meets nothing.
pub type Truths<'a> = Shared<'a, Option<Truth>>;

/// A variant that answers questions.
pub struct AnswerBatch<'a, F> {
    answers: Vec<Option<Answer>>,
    fill: F,
    truths: Truths<'a>,
    unit_roundoff: f64,
}

impl<'a, F: FnMut(&mut [Option<Answer>])> AnswerBatch<'a, F> {
    /// The variant over this scalar that fills so many answers.
    pub fn new(scalar: &str, count: usize, truths: &Truths<'a>, fill: F) -> Self {
        let unit_roundoff = if scalar == "f32" {
            f32::unit_roundoff().into()
        } else {
            f64::unit_roundoff()
        };
        Self {
            answers: vec![None; count],
            fill,
            truths: Rc::clone(truths),
            unit_roundoff,
        }
    }
}

impl<F: FnMut(&mut [Option<Answer>])> Batch for AnswerBatch<'_, F> {
    fn run(&mut self) {
        (self.fill)(&mut self.answers);
        black_box(&mut self.answers);
    }

    /// The errors of t over the rays that meet something, in truth and by the answer.
    fn errors(&self) -> Option<Errors> {
        assert_eq!(self.answers.len(), self.truths.len(), "one truth an answer");
        let (mut ulps, mut largest, mut squares) = (0.0_f64, 0.0_f64, 0.0);
        let (mut met, mut wrong) = (0.0_f64, 0.0);
        for (answer, truth) in self.answers.iter().zip(self.truths.iter()) {
            match (answer, truth) {
                (None, None) => {}
                (Some(answer), Some(truth)) if answer.agrees_with(truth) => {
                    let error = nearest(&(big(answer.t) - &truth.t)).abs();
                    ulps = ulps.max(error / ulp(nearest(&truth.t), self.unit_roundoff));
                    largest = largest.max(error);
                    squares += error * error;
                    met += 1.0;
                }
                _ => wrong += 1.0,
            }
        }
        Some(Errors {
            ulps,
            largest,
            rms: (squares / met.max(1.0)).sqrt(),
            wrong: Some(wrong / self.answers.len() as f64),
        })
    }
}
