//! The steps before a mesh is a patchwork: whole steps of the scheme, one or two.

use super::super::doo_sabin::doo_sabin_points;
use super::super::{Counts, DooSabinWeights, SubdivisionError, catmull_clark, doo_sabin_with};
use super::doo_sabin::{corner_weight, is_regular};
use super::{Connectivity, Corners};
use crate::algebra::VectorSpace;
use crate::mesh::Mesh;

/// A scheme with its choices.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    CatmullClark(Corners),
    DooSabin(DooSabinWeights, Corners),
    /// A mesh of triangles is a patchwork at once.
    Loop,
}

/// The first steps.
#[derive(Clone, Debug)]
pub(super) struct Prelude {
    rule: Rule,
    /// The connectivity before each step.
    steps: Vec<Connectivity>,
    source_count: usize,
}

impl Prelude {
    /// As many steps as the mesh needs to become a patchwork, or as are asked for; and the connectivity after them.
    pub(super) fn new(
        rule: Rule,
        connectivity: &Connectivity,
        levels: u32,
    ) -> Result<(Self, Connectivity), SubdivisionError> {
        rule.check_counts(connectivity, levels)?;
        let mut connectivity = connectivity.clone();
        let mut prelude = Self {
            rule,
            steps: Vec::new(),
            source_count: connectivity.vertex_count(),
        };
        while prelude.levels() < levels && !rule.is_patchwork(&connectivity) {
            let refined = rule.step(
                &connectivity,
                &vec![0.0; connectivity.vertex_count()],
                |_, _| 0.0,
            )?;
            let next = Connectivity::new(&refined)?;
            prelude
                .steps
                .push(std::mem::replace(&mut connectivity, next));
        }
        Ok((prelude, connectivity))
    }

    pub(super) fn levels(&self) -> u32 {
        super::index_of(self.steps.len())
    }

    pub(super) fn bytes(&self) -> usize {
        self.steps.iter().map(super::bytes_of).sum()
    }

    pub(super) fn source_count(&self) -> usize {
        self.source_count
    }

    pub(super) fn must_have_points(&self, found: usize) -> Result<(), SubdivisionError> {
        let expected = self.source_count;
        if found == expected {
            Ok(())
        } else {
            Err(SubdivisionError::PointCount { found, expected })
        }
    }

    /// The points after the steps.
    pub(super) fn refine<'a, P: VectorSpace>(
        &self,
        points: &'a [P],
        refined: &'a mut Vec<P>,
        cosine: &impl Fn(usize, usize) -> P::Scalar,
    ) -> Result<&'a [P], SubdivisionError> {
        let [first, rest @ ..] = &self.steps[..] else {
            return Ok(points);
        };
        *refined = self.rule.step_points(first, points, cosine)?;
        for connectivity in rest {
            *refined = self.rule.step_points(connectivity, refined, cosine)?;
        }
        Ok(refined)
    }
}

impl Rule {
    /// Refuses more levels than 32-bit numbers can name the points of.
    fn check_counts(
        self,
        connectivity: &Connectivity,
        levels: u32,
    ) -> Result<(), SubdivisionError> {
        let mut counts = Counts::of(connectivity);
        // Without faces no level is larger than the one before.
        let growing = if counts.faces == 0 { 0..0 } else { 0..levels };
        for _ in growing {
            let next = match self {
                Self::CatmullClark(_) => counts.after_catmull_clark(),
                Self::DooSabin(_, corners) => counts.after_doo_sabin(corners),
                Self::Loop => counts.after_loop(),
            };
            counts = next.map_err(|error| match error {
                SubdivisionError::TooLarge { what, .. } => {
                    SubdivisionError::TooLarge { levels, what }
                }
                other => other,
            })?;
        }
        Ok(())
    }

    fn is_patchwork(self, connectivity: &Connectivity) -> bool {
        match self {
            Self::CatmullClark(_) => is_quads(connectivity),
            Self::DooSabin(_, corners) => is_regular(connectivity, corners),
            Self::Loop => true,
        }
    }

    /// The points after a step whose faces are known.
    fn step_points<P: VectorSpace>(
        self,
        connectivity: &Connectivity,
        points: &[P],
        cosine: &impl Fn(usize, usize) -> P::Scalar,
    ) -> Result<Vec<P>, SubdivisionError> {
        if let Self::DooSabin(weights, corners) = self {
            let weight = |n, steps| corner_weight(weights, n, steps, cosine);
            return Ok(doo_sabin_points(connectivity, points, corners, weight));
        }
        Ok(self.step(connectivity, points, cosine)?.positions)
    }

    fn step<P: VectorSpace>(
        self,
        connectivity: &Connectivity,
        points: &[P],
        cosine: impl Fn(usize, usize) -> P::Scalar,
    ) -> Result<Mesh<P>, SubdivisionError> {
        match self {
            Self::CatmullClark(corners) => catmull_clark(connectivity, points, corners),
            Self::DooSabin(weights, corners) => {
                doo_sabin_with(connectivity, points, corners, |n, steps| {
                    corner_weight(weights, n, steps, &cosine)
                })
            }
            Self::Loop => unreachable!("a patchwork needs no steps"),
        }
    }
}

/// Whether all faces are quadrilaterals.
pub(super) fn is_quads(connectivity: &Connectivity) -> bool {
    let faces = 0..super::index_of(connectivity.face_count());
    faces
        .into_iter()
        .all(|face| connectivity.half_edges_of(face).len() == 4)
}
