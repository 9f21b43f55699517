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
