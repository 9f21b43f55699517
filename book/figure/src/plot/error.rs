//! What a plot refuses.

use std::fmt;

/// Why a plot cannot be drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum PlotError {
    /// There is no point in any series.
    Empty {
        /// The title of the plot.
        title: String,
    },
    /// A point is NaN or infinite, or not positive on a logarithmic axis.
    Misplaced {
        /// The name of the series.
        series: String,
        /// The number of the point in its series, from 0.
        index: usize,
        /// The point.
        point: [f64; 2],
    },
    /// The axes could not be drawn.
    Axes {
        /// What the plotting library says.
        message: String,
    },
}

impl PlotError {
    pub(super) fn axes(error: impl fmt::Display) -> Self {
        Self::Axes {
            message: error.to_string(),
        }
    }
}

impl fmt::Display for PlotError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { title } => write!(formatter, "the plot \"{title}\" has no points"),
            Self::Misplaced {
                series,
                index,
                point: [x, y],
            } => write!(
                formatter,
                "point {index} of \"{series}\" is ({x}, {y}): expected finite numbers, positive on a logarithmic axis"
            ),
            Self::Axes { message } => write!(formatter, "the axes cannot be drawn: {message}"),
        }
    }
}

impl std::error::Error for PlotError {}
