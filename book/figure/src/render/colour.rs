//! The sRGB transfer curve, computed with plain arithmetic alone so that pictures are the same on every machine.

use std::sync::LazyLock;

/// The linear value, 0 to 1, of an sRGB byte.
pub(crate) fn decode(byte: u8) -> f64 {
    DECODED[usize::from(byte)]
}

/// The sRGB byte nearest to a linear value; values outside 0 to 1 are clamped, and NaN is black.
pub(crate) fn encode(value: f64) -> u8 {
    let above = THRESHOLDS.partition_point(|&threshold| threshold <= value);
    u8::try_from(above).unwrap_or(u8::MAX)
}

/// The linear value of each byte: every ray that meets something asks for three.
static DECODED: LazyLock<[f64; 256]> =
    LazyLock::new(|| std::array::from_fn(|byte| linear(byte as f64 / 255.0)));

/// The linear values half-way, on the encoded scale, between one byte and the next.
static THRESHOLDS: LazyLock<[f64; 255]> =
    LazyLock::new(|| std::array::from_fn(|byte| linear((byte as f64 + 0.5) / 255.0)));

/// The curve of IEC 61966-2-1: a line near black, then a power of 2.4.
fn linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        return encoded / 12.92;
    }
    let base = (encoded + 0.055) / 1.055;
    // x^2.4 = x² · (x²)^(1/5)
    base * base * fifth_root(base * base)
}

/// The fifth root of a number in (0, 1], by Newton's method from above, where it converges without overshooting.
fn fifth_root(value: f64) -> f64 {
    let mut root = 1.0;
    loop {
        let fourth = root * root * root * root;
        let next = root - (root - value / fourth) / 5.0;
        if next >= root {
            return root;
        }
        root = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_survives_decoding_and_encoding() {
        for byte in 0..=u8::MAX {
            assert_eq!(encode(decode(byte)), byte);
        }
    }

    #[test]
    fn the_curve_is_the_power_of_the_standard() {
        for byte in 11..=u8::MAX {
            let expected = ((f64::from(byte) / 255.0 + 0.055) / 1.055).powf(2.4);
            // A dozen roundings at 2⁻⁵³ each, and one unit of powf.
            assert!(
                (decode(byte) / expected - 1.0).abs() <= 16.0 * f64::EPSILON,
                "{byte}"
            );
        }
    }

    #[test]
    fn values_out_of_range_are_clamped_and_nan_is_black() {
        assert_eq!(
            [-1.0, 2.0, f64::INFINITY, f64::NAN].map(encode),
            [0, 255, 255, 0]
        );
    }
}
