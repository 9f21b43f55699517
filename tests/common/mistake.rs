//! A typical mistake of a chapter. Not part of [`super`], since the mistakes are compiled without the tests as well.

/// A wrong implementation that students really write.
#[derive(Clone, Copy, Debug)]
pub struct Mistake {
    /// Its name.
    pub name: &'static str,
    /// The exercise in which it is made.
    pub exercise: &'static str,
    /// The theorem that rejects it.
    pub rejected_by: &'static str,
    /// What its maker should look at.
    pub hint: &'static str,
}

/// The exercise of a function, and the theorem that rejects its mistakes.
pub type Function = [&'static str; 2];

/// The mistake of this name in a function, with the hint for its maker.
pub const fn mistake(
    [exercise, rejected_by]: Function,
    name: &'static str,
    hint: &'static str,
) -> Mistake {
    Mistake {
        name,
        exercise,
        rejected_by,
        hint,
    }
}

/// Prints mistakes for the grader: name, exercise, rejecting theorem and hint, with tabs between.
#[allow(dead_code, reason = "only the tests make the list")]
pub fn print_all(mistakes: &[Mistake]) {
    for Mistake {
        name,
        exercise,
        rejected_by,
        hint,
    } in mistakes
    {
        println!("{name}\t{exercise}\t{rejected_by}\t{hint}");
    }
}
