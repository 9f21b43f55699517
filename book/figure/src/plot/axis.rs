//! One axis of a plot: its range, its ticks and their names, linear or logarithmic.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// The range of an axis and how values lie along it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Axis {
    least: f64,
    greatest: f64,
    is_logarithmic: bool,
    /// The part of the axis, left of the least value, that is kept for the value 0 of a logarithmic axis.
    reserved: f64,
    ticks: Vec<f64>,
}

/// About how many ticks an axis has.
const TICKS: i32 = 6;
/// The least factor between a value and the end of a logarithmic axis, so that no point sits on the frame.
const MARGIN: f64 = 1.25;
/// The part of a logarithmic axis that is kept for 0, where 0 is among the values.
const RESERVED: f64 = 0.09;

impl Axis {
    /// The linear axis that takes in all `values`, widened to the next ticks.
    pub fn linear(values: impl Iterator<Item = f64>) -> Self {
        let (least, greatest) = extent(values);
        let padding = if least < greatest {
            0.0
        } else {
            least.abs().max(1.0) / 2.0
        };
        let (least, greatest) = (least - padding, greatest + padding);
        let rough = (greatest / f64::from(TICKS)) - (least / f64::from(TICKS));
        let step = ceil_1_2_5(rough);
        let (first, last) = ((least / step).floor(), (greatest / step).ceil());
        let mut ticks = vec![];
        let mut index = first;
        while index <= last {
            ticks.push(index * step);
            index += 1.0;
        }
        let (least, greatest) = (first * step, last * step);
        Self {
            least,
            greatest,
            is_logarithmic: false,
            reserved: 0.0,
            ticks,
        }
    }

    /// The logarithmic axis that takes in all positive `values`, widened to 1, 2 or 5 times a power of ten and to
    /// almost a decade. If one of
    /// them is 0, it has a place of its own before the others.
    pub fn logarithmic(values: impl Iterator<Item = f64> + Clone) -> Self {
        let has_zero = values.clone().any(|value| value <= 0.0);
        let (least, greatest) = extent(values.filter(|&value| value > 0.0));
        let (mut least, mut greatest) =
            (floor_1_2_5(least / MARGIN), ceil_1_2_5(greatest * MARGIN));
        while greatest < 8.0 * least {
            (least, greatest) = (floor_1_2_5(least / 2.0), ceil_1_2_5(greatest * 2.0));
        }
        let ticks = logarithmic_ticks(least, greatest);
        let reserved = if has_zero { RESERVED } else { 0.0 };
        Self {
            least,
            greatest,
            is_logarithmic: true,
            reserved,
            ticks,
        }
    }

    /// Where a value lies: 0 at the beginning of the axis, 1 at its end.
    pub fn fraction(&self, value: f64) -> f64 {
        if !self.is_logarithmic {
            return (value - self.least) / (self.greatest - self.least);
        }
        if value <= 0.0 {
            return self.reserved / 2.0;
        }
        // Differences of logarithms, because the quotient of the two ends may overflow.
        let [value, least, greatest] = [value, self.least, self.greatest].map(f64::log10);
        let along = (value - least) / (greatest - least);
        // The smallest numbers of all lie below every power of ten that can be written.
        self.reserved + (1.0 - self.reserved) * along.clamp(0.0, 1.0)
    }

    /// The part of the axis kept for the value 0, if any.
    pub fn reserved(&self) -> Option<f64> {
        (self.reserved > 0.0).then_some(self.reserved)
    }

    fn tick_name(&self, value: f64) -> String {
        if self.is_logarithmic {
            return scientific(value);
        }
        let step = self
            .ticks
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .fold(f64::INFINITY, f64::min);
        if value.abs().max(step) >= 1e6 || step < 1e-4 {
            return format!("{value:.1e}");
        }
        let decimals = (0..4).find(|&decimals| step * f64::from(10_i32.pow(decimals)) > 0.99);
        // Adding 0 turns -0 into 0.
        format!("{:.*}", decimals.unwrap_or(4) as usize, value + 0.0)
    }
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    let (least, greatest) = values.fold(start, |(least, greatest), value| {
        (least.min(value), greatest.max(value))
    });
    if least <= greatest {
        (least, greatest)
    } else {
        (1.0, 1.0)
    }
}

/// `mantissa · 10^exponent`, correctly rounded, and within the range of normal numbers.
fn decimal(mantissa: u32, exponent: i32) -> f64 {
    let value: f64 = format!("{mantissa}e{exponent}").parse().unwrap_or(f64::NAN);
    value.clamp(f64::MIN_POSITIVE, f64::MAX)
}

/// The numbers 1, 2 and 5 times a power of ten, from below `value` to above it.
fn steps_around(value: f64) -> impl DoubleEndedIterator<Item = f64> + Clone {
    let exponent = exponent(value);
    (exponent - 1..=exponent + 1)
        .flat_map(|exponent| [1, 2, 5].map(|mantissa| decimal(mantissa, exponent)))
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "the exponent of a number lies within ±324"
)]
fn exponent(value: f64) -> i32 {
    value.clamp(f64::MIN_POSITIVE, f64::MAX).log10().floor() as i32
}

fn floor_1_2_5(value: f64) -> f64 {
    steps_around(value)
        .rev()
        .find(|&step| step <= value)
        .unwrap_or(f64::MIN_POSITIVE)
}

fn ceil_1_2_5(value: f64) -> f64 {
    steps_around(value)
        .find(|&step| step >= value)
        .unwrap_or(f64::MAX)
}

/// Powers of ten, every second or third of them over a long range; 1, 2 and 5 times powers over a short one.
fn logarithmic_ticks(least: f64, greatest: f64) -> Vec<f64> {
    let (first, last) = (exponent(least) - 1, exponent(greatest) + 1);
    let mantissas: &[u32] = if greatest / least <= 2000.0 {
        &[1, 2, 5]
    } else {
        &[1]
    };
    let stride = ((last - first - 2) / 9 + 1).max(1);
    let exponents = (first..=last).filter(|exponent| exponent.rem_euclid(stride) == 0);
    let all = exponents.flat_map(|exponent| mantissas.iter().map(move |&m| decimal(m, exponent)));
    all.filter(|tick| (least..=greatest).contains(tick))
        .collect()
}

/// A number of one digit: plain where that is short, otherwise with a power of ten.
fn scientific(value: f64) -> String {
    if (1e-2..=1e4).contains(&value) {
        return format!("{value}");
    }
    let text = format!("{value:.0e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let superscript: String = exponent.chars().map(superscript).collect();
    if mantissa == "1" {
        format!("10{superscript}")
    } else {
        format!("{mantissa}·10{superscript}")
    }
}

fn superscript(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    #[allow(
        clippy::cast_possible_truncation,
        reason = "pixels of a drawing of some thousand"
    )]
    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let (start, end) = (f64::from(limit.0), f64::from(limit.1));
        (start + self.fraction(*value) * (end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.least..self.greatest
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        self.tick_name(*value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(axis: &Axis) -> Vec<String> {
        axis.ticks
            .iter()
            .map(|&tick| axis.tick_name(tick))
            .collect()
    }

    #[test]
    fn linear_ticks_are_round_numbers() {
        let axis = Axis::linear([0.0, 1.0].into_iter());
        assert_eq!(names(&axis), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        let axis = Axis::linear([-3.0, 110.0].into_iter());
        assert_eq!(
            names(&axis),
            ["-20", "0", "20", "40", "60", "80", "100", "120"]
        );
    }

    #[test]
    fn logarithmic_ticks_are_powers_of_ten_and_the_numbers_between_them_where_they_are_few() {
        let axis = Axis::logarithmic([3.0, 70.0].into_iter());
        assert_eq!(names(&axis), ["2", "5", "10", "20", "50", "100"]);
        let axis = Axis::logarithmic([2e-17, 3e-5].into_iter());
        assert_eq!(
            names(&axis),
            ["10⁻¹⁶", "10⁻¹⁴", "10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶"]
        );
    }

    #[test]
    fn every_value_lies_on_its_axis_and_order_is_kept() {
        let values = [
            0.0,
            f64::MIN_POSITIVE,
            1e-300,
            2.5e-16,
            1.0,
            3e5,
            1e300,
            f64::MAX,
        ];
        for count in 1..=values.len() {
            for axis in [
                Axis::logarithmic(values[..count].iter().copied()),
                Axis::linear(values[..count].iter().copied()),
            ] {
                let fractions: Vec<f64> = values[..count]
                    .iter()
                    .map(|&value| axis.fraction(value))
                    .collect();
                assert!(
                    fractions.iter().all(|f| (0.0..=1.0).contains(f)),
                    "{axis:?} {fractions:?}"
                );
                assert!(
                    fractions.windows(2).all(|pair| pair[0] <= pair[1]),
                    "{axis:?}"
                );
            }
        }
    }

    #[test]
    fn a_single_value_has_room_on_both_sides() {
        for axis in [
            Axis::linear([7.0].into_iter()),
            Axis::logarithmic([7.0].into_iter()),
        ] {
            let fraction = axis.fraction(7.0);
            assert!((0.1..=0.9).contains(&fraction), "{axis:?} {fraction}");
            assert!(axis.ticks.len() >= 2);
        }
    }

    #[test]
    fn zero_has_a_place_of_its_own_on_a_logarithmic_axis() {
        let axis = Axis::logarithmic([0.0, 1e-16].into_iter());
        assert!(axis.fraction(0.0) < RESERVED && axis.fraction(1e-16) > RESERVED);
        assert_eq!(axis.reserved(), Some(RESERVED));
        assert_eq!(Axis::logarithmic([1e-16].into_iter()).reserved(), None);
    }
}
