//! Subdivision of polygons: corner cutting (Chaikin), the cubic scheme, and uniform B-splines of any degree (Lane and Riesenfeld).
//!
//! A polygon is replaced by one with twice as many points, each a mean of neighbours, again and again. The limit is the uniform B-spline of
//! degree d with the first polygon for control points:
//!
//! ```text
//! d = 2    Q = 3/4 P + 1/4 P₊    R = 1/4 P + 3/4 P₊             Chaikin: two points on each edge
//! d = 3    V = (P₋ + 6 P + P₊)/8    E = (P + P₊)/2               the cubic scheme: a point for each vertex and each edge
//! any d    every point twice, then d times the means of neighbours     Lane and Riesenfeld
//! ```
//!
//! # Conventions
//!
//! Points are in the order of the polygon; [`Ends`] says whether the last is joined to the first, and what becomes of ends. The limit is
//! parametrised with one unit for each span of the polygon in hand: a round halves the unit. Lists shorter than a scheme needs are no error in
//! a step, which gives what the formulas give, down to nothing; a limit curve needs enough points.
//!
//! # Numerics
//!
//! Every new point is a mean, so that errors do not grow: k rounds of Chaikin in floating point are off by at most `2ku` times the largest
//! coordinate. The limit is not reached by many rounds but by the masks of [`limit_points`], and how far a polygon is from it is known
//! beforehand ([`distance_bound`]).
//!
//! # Sources
//!
//! G. M. Chaikin, *An algorithm for high-speed curve generation*, 1974; R. F. Riesenfeld, *On Chaikin's algorithm*, 1975; J. M. Lane, R. F.
//! Riesenfeld, *A theoretical development for the computer generation and display of piecewise polynomial surfaces*, 1980.
//!
//! *In the course*: slides 51 to 63 (*algorithme de Chaikin*).
//!
//! *In the book*: [Curves](../../../../subdivision/curves.html).

mod ends;
mod error;
mod limit;
mod rounds;
mod step;

pub use ends::{Ends, LARGEST_DEGREE};
pub use error::PolygonError;
pub use limit::{
    distance_bound, limit_curve, limit_points, limit_tangents, limit_weights, rounds_within,
};
pub use rounds::{LARGEST_POINT_COUNT, LARGEST_ROUNDS, point_count, subdivided};
pub use step::{
    chaikin_step, cubic_step, double_and_average, edges, lane_riesenfeld_step, neighbours,
};
