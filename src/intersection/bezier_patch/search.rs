//! The search: parts of the patch, the nearest first, halved until each is decided.

use super::ROUNDOFF;
use super::certificate::{Examined, Finding, Part};
use super::net::{ROUNDOFFS_OF_A_PROJECTION, RayFrame, Seen, halve};
use crate::ray::Ray;

/// So many parts of a patch are looked at for one ray. A bicubic patch has at most 18 roots, and even a tangent ray needs some hundreds of parts; only a patch that collapses onto
/// a curve, every point of which has a curve of parameters, would need more.
pub const CELL_LIMIT: usize = 1 << 14;

/// A root in the ray's coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    /// Where in the unit square.
    pub(super) parameters: [f64; 2],
    /// How far along the ray.
    pub(super) depth: f64,
    /// A bound on the error of the depth.
    pub(super) depth_error: f64,
    /// Whether it is a part of the patch as small as the rounding, and not a certified root.
    pub(super) is_point: bool,
}

/// The parts that are left to look at, the next one last: each with its control net at the end of `nets`.
pub(super) struct Search<'a> {
    degrees: [usize; 2],
    /// The ray's interval of depths, widened by its rounding; ends at the nearest root so far.
    depths: (f64, Option<f64>),
    t_per_depth: f64,
    /// Whether the ray's interval holds a t, which is rounded to the ray's own type first.
    reaches: &'a dyn Fn(f64) -> bool,
    parts: Vec<Part>,
    nets: Vec<Seen>,
    buffer: Vec<Seen>,
}

impl<'a> Search<'a> {
    /// The search that begins with the whole patch; `None` where its hull already lies beside the ray.
    pub(super) fn new(
        frame: &RayFrame,
        ray: &Ray<[f64; 3]>,
        control_points: &[[f64; 3]],
        degrees: [usize; 2],
        reaches: &'a dyn Fn(f64) -> bool,
    ) -> Option<Self> {
        let rounding = ROUNDOFFS_OF_A_PROJECTION * ROUNDOFF;
        let mut beside = [true; 4];
        for &point in control_points {
            let [a, b, _] = frame.seen(point);
            beside[0] &= a > rounding;
            beside[1] &= a < -rounding;
            beside[2] &= b > rounding;
            beside[3] &= b < -rounding;
        }
        if beside.contains(&true) {
            return None;
        }
        let whole = Part {
            corner: [0.0; 2],
            sides: [1.0; 2],
            rounding,
        };
        Some(Self {
            degrees,
            depths: (
                frame.depth_beyond(ray.start, -1.0),
                ray.end.map(|end| frame.depth_beyond(end, 1.0)),
            ),
            t_per_depth: frame.t_per_depth,
            reaches,
            parts: vec![whole],
            nets: control_points
                .iter()
                .map(|&point| frame.seen(point))
                .collect(),
            buffer: Vec::new(),
        })
    }

    /// The root with the least depth in the ray's interval; with `any`, the first that is found.
    // ANCHOR: search
    pub(super) fn nearest(&mut self, any: bool) -> Option<Root> {
        let mut nearest = None;
        for _ in 0..CELL_LIMIT {
            let Some(part) = self.parts.pop() else {
                break;
            };
            let net = self.nets.len() - self.net_length();
            let examined = Examined {
                part,
                net: &self.nets[net..],
                degrees: self.degrees,
                depths: self.depths,
            };
            match examined.finding(&mut self.buffer) {
                Finding::Halve(direction) => {
                    self.halve(part, direction);
                    continue;
                }
                Finding::Root(root) if self.counts(root) => {
                    self.depths.1 = Some(root.depth);
                    nearest = Some(root);
                    if any {
                        break;
                    }
                }
                Finding::Root(_) | Finding::Nothing => {}
            }
            self.nets.truncate(net);
        }
        nearest
    }
    // ANCHOR_END: search

    fn net_length(&self) -> usize {
        (self.degrees[0] + 1) * (self.degrees[1] + 1)
    }

    /// Whether a root lies in the ray's interval, and after its start for certain.
    fn counts(&self, root: Root) -> bool {
        let (start, nearest) = self.depths;
        root.depth - root.depth_error > start
            && nearest.is_none_or(|nearest| root.depth <= nearest)
            && (self.reaches)(root.depth * self.t_per_depth)
    }

    /// Replaces the part, whose net is the last one, by its halves, the nearer one last.
    fn halve(&mut self, part: Part, direction: usize) {
        let lower = halve(&mut self.nets, self.degrees, direction);
        // Each level of de Casteljau rounds sums of two numbers up to 2, and halves them: two roundoffs.
        let roundoffs = (2 * self.degrees[direction]) as f64 * ROUNDOFF;
        let mut halves = [part; 2];
        for half in &mut halves {
            half.sides[direction] = part.sides[direction] * 0.5;
            half.rounding = part.rounding + roundoffs;
        }
        let [below, above] = &mut halves;
        above.corner[direction] = part.corner[direction] + below.sides[direction];
        let length = self.net_length();
        let (rest, last) = self.nets.split_at_mut(lower);
        let upper = &mut rest[lower - length..];
        let nearest = |net: &[Seen]| net.iter().map(|f| f[2]).fold(f64::INFINITY, f64::min);
        if nearest(upper) < nearest(last) {
            upper.swap_with_slice(last);
            self.parts.extend([halves[0], halves[1]]);
        } else {
            self.parts.extend([halves[1], halves[0]]);
        }
    }
}
