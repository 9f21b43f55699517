//! The rows of a speed report.

use std::fmt::Write as _;

use super::SpeedError;
use crate::svg::literal;

/// The columns of the file, in their order.
const COLUMNS: [&str; 13] = [
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

/// Which set of inputs was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Inputs {
    Typical,
    Hard,
}

impl Inputs {
    pub fn name(self) -> &'static str {
        match self {
            Self::Typical => "typical",
            Self::Hard => "hard",
        }
    }
}

/// What the plot uses of a line of the report.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub quantity: String,
    pub algorithm: String,
    pub scalar: String,
    pub threads: String,
    pub inputs: Inputs,
    pub n: String,
    pub nanoseconds: f64,
    /// The largest absolute error; none for a yardstick.
    pub error: Option<f64>,
}

impl Row {
    /// Whether the two rows differ in nothing but their inputs.
    pub fn is_same_variant(&self, other: &Self) -> bool {
        let key =
            |row: &Self| [&row.algorithm, &row.scalar, &row.threads, &row.n].map(String::clone);
        key(self) == key(other)
    }

    /// The name of the point, in the markup of drawings.
    pub fn label(&self, names_n: bool) -> String {
        let mut label = literal(&self.algorithm);
        if self.threads != "1" && !self.threads.is_empty() {
            let _ = write!(label, ", {} threads", self.threads);
        }
        if names_n {
            let _ = write!(label, ", n = {}", self.n);
        }
        label
    }
}

/// The rows of the file, without its comments and its heading.
pub(super) fn read(csv: &str) -> Result<Vec<Row>, SpeedError> {
    let mut rows = Vec::new();
    let mut has_heading = false;
    for (index, text) in csv.lines().enumerate() {
        let text = text.trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let fail = |message| SpeedError::Line {
            line: index + 1,
            message,
        };
        let fields: Vec<&str> = text.split(',').map(str::trim).collect();
        if has_heading {
            rows.push(row(&fields).map_err(fail)?);
        } else if fields == COLUMNS {
            has_heading = true;
        } else {
            return Err(fail(format!("expected the heading {}", COLUMNS.join(","))));
        }
    }
    if rows.is_empty() {
        Err(SpeedError::Empty)
    } else {
        Ok(rows)
    }
}

fn row(fields: &[&str]) -> Result<Row, String> {
    if fields.len() != COLUMNS.len() {
        let (found, expected) = (fields.len(), COLUMNS.len());
        return Err(format!("has {found} fields, expected {expected}"));
    }
    let column = |name: &str| {
        let at = COLUMNS.iter().position(|column| *column == name);
        at.map_or("", |at| fields[at])
    };
    let text = |name: &str| column(name).to_string();
    Ok(Row {
        quantity: text("quantity"),
        algorithm: text("algorithm"),
        scalar: text("scalar"),
        threads: text("threads"),
        inputs: inputs(column("inputs"))?,
        n: text("n"),
        nanoseconds: time(column("ns_per_eval"))?,
        error: largest_error(column("max_abs"))?,
    })
}

fn inputs(text: &str) -> Result<Inputs, String> {
    [Inputs::Typical, Inputs::Hard]
        .into_iter()
        .find(|inputs| inputs.name() == text)
        .ok_or_else(|| format!("the inputs are \"{text}\", expected typical or hard"))
}

fn time(text: &str) -> Result<f64, String> {
    let time = number("ns_per_eval", text)?;
    if time > 0.0 && time.is_finite() {
        return Ok(time);
    }
    Err(format!(
        "the time is {text}, expected a positive number of nanoseconds"
    ))
}

fn largest_error(text: &str) -> Result<Option<f64>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    let error = number("max_abs", text)?;
    if error < 0.0 {
        return Err("the largest absolute error is negative".to_string());
    }
    Ok(Some(error))
}

fn number(column: &str, text: &str) -> Result<f64, String> {
    text.parse()
        .map_err(|_| format!("the column {column} holds \"{text}\", expected a number"))
}

/// Processor and date of the report, from its comment lines.
pub(super) fn circumstances(csv: &str) -> String {
    let value = |key: &str| {
        csv.lines()
            .filter_map(|line| line.strip_prefix('#')?.split_once(':'))
            .find(|(name, _)| name.trim() == key)
            .map(|(_, value)| value.trim())
    };
    let found: Vec<&str> = ["processor", "date"]
        .into_iter()
        .filter_map(value)
        .collect();
    if found.is_empty() {
        String::new()
    } else {
        format!("measured on {}", found.join(", "))
    }
}
