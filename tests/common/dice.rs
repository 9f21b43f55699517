//! Pseudo-random numbers that are the same in every run, where a generator of inputs would be too slow or too small.

/// Pseudo-random numbers between −1 and 1 (Knuth's 64-bit linear congruence, upper bits).
pub struct Dice(u64);

impl Dice {
    /// Dice that roll the same numbers for the same seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number.
    pub fn roll(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A vector of the next three numbers.
    pub fn vector(&mut self) -> [f64; 3] {
        [self.roll(), self.roll(), self.roll()]
    }

    /// A number below `count`.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a share of a count is one of its numbers"
    )]
    pub fn index(&mut self, count: usize) -> usize {
        let share = self.roll().midpoint(1.0);
        ((share * count as f64) as usize).min(count - 1)
    }
}
