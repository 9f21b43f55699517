//! What a patch cannot see: the rings around the extraordinary vertices or faces, refined on their own.

use super::rows::Grid;
use crate::algebra::VectorSpace;

/// What stands for "no star" and "no vertex".
pub(super) const NONE: u32 = u32::MAX;

/// A place in a grid: row and column, ring included.
pub(super) type Place = (usize, usize);

/// For each corner of a patch that no regular mask refines: its star, and which of the star's faces the patch is (in a star that is a face:
/// which of its corners). `NONE` for the other corners.
pub(super) type StarCorners<const CORNERS: usize> = [(u32, u32); CORNERS];

/// Puts the points of stars into the corners of the patches' grids: `places(corner, side)` says where, `points(star, place)` which.
pub(super) fn mend<'a, P: VectorSpace, const LANES: usize, const CORNERS: usize>(
    patches: impl Iterator<Item = &'a StarCorners<CORNERS>>,
    places: impl Fn(usize, usize) -> [Place; 3],
    points: impl Fn(u32, usize) -> [Option<P>; 3],
    grid: &mut Grid<P, LANES>,
) {
    for (lane, corners) in patches.enumerate() {
        for (corner, &(star, place)) in corners.iter().enumerate() {
            if star == NONE {
                continue;
            }
            let places = places(corner, grid.side());
            for ((row, column), point) in places.into_iter().zip(points(star, place as usize)) {
                if let Some(point) = point {
                    grid.at_mut(row, column)[lane] = point;
                }
            }
        }
    }
}

/// Where the points of the stars are: those of one level after the other, star by star.
///
/// A star is closed under refinement: its points on the next level are masks of its points on this one. So the few stars are refined first,
/// through all levels, and the patches look up there what no regular mask gives.
#[derive(Clone, Debug, Default)]
pub(super) struct Stars {
    /// The points of level 0.
    indices: Vec<u32>,
    /// Where each star ends.
    ends: Vec<usize>,
}

impl Stars {
    /// Adds a star of these vertices; its number.
    pub(super) fn push(&mut self, vertices: impl Iterator<Item = u32>) -> u32 {
        let number = super::index_of(self.ends.len());
        self.indices.extend(vertices);
        self.ends.push(self.indices.len());
        number
    }

    pub(super) fn count(&self) -> usize {
        self.ends.len()
    }

    /// How many points each star has.
    pub(super) fn sizes(&self) -> impl Iterator<Item = usize> {
        (0..self.count()).map(|star| self.places(star).len())
    }

    pub(super) fn bytes(&self) -> usize {
        size_of::<u32>() * self.indices.capacity() + size_of::<usize>() * self.ends.capacity()
    }

    /// The places of a star among the points of a level.
    fn places(&self, star: usize) -> std::ops::Range<usize> {
        let start = star.checked_sub(1).map_or(0, |before| self.ends[before]);
        start..self.ends[star]
    }

    /// The points of a star on a level.
    pub(super) fn points<'a, P>(&self, stored: &'a [P], level: u32, star: u32) -> &'a [P] {
        let on_level = &stored[level as usize * self.indices.len()..];
        &on_level[self.places(star as usize)]
    }

    /// Fills `stored` with the points of all stars on the levels 0 to `levels`; `refine(star, old, new)` makes one level of one star.
    pub(super) fn refine<P: VectorSpace>(
        &self,
        levels: u32,
        points: &[P],
        stored: &mut Vec<P>,
        refine: impl Fn(usize, &[P], &mut [P]),
    ) {
        stored.clear();
        stored.extend(self.indices.iter().map(|&vertex| points[vertex as usize]));
        let size = self.indices.len();
        stored.resize(size * (levels as usize + 1), P::origin());
        for level in 0..levels as usize {
            let (old, new) = stored[level * size..].split_at_mut(size);
            for star in 0..self.count() {
                let places = self.places(star);
                refine(star, &old[places.clone()], &mut new[places]);
            }
        }
    }
}
