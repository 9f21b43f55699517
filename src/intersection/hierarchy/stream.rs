//! Many rays at once: while one waits for memory, the others go on.
//!
//! A ray's way down the tree is a chain: which node is next is known only when the last one has been tested. The processor can do several times as
//! much in that time. So a number of rays walk side by side, each taking one step in turn; those at a node first, then those at a
//! leaf, so that no branch has to guess which it is.

use glam::Vec3;

use super::confirm::Line;
use super::node::Child;
use super::prepared::Prepared;
use super::stack::Stack;
use super::traverse::Walk;
use super::{Found, Hierarchy, found};
use crate::ray::Ray;

/// How many rays walk side by side.
pub(super) const AT_ONCE: usize = 16;

/// The rays that walk side by side, with their stacks.
#[derive(Clone, Debug)]
pub(super) struct Walkers {
    walks: Vec<Walker>,
}

/// One of them.
#[derive(Clone, Debug)]
struct Walker {
    /// Which ray of the stream.
    index: usize,
    line: Line,
    walk: Walk,
    stack: Box<Stack>,
}

/// Some of the walkers, by number.
struct List {
    walkers: [u8; 2 * AT_ONCE],
    count: usize,
}

impl List {
    const EMPTY: Self = Self {
        walkers: [0; 2 * AT_ONCE],
        count: 0,
    };

    /// Adds a walker if it belongs here; it is written in either case, so that there is no branch.
    #[inline(always)]
    fn push_if(&mut self, walker: usize, belongs: bool) {
        self.walkers[self.count % (2 * AT_ONCE)] = walker as u8;
        self.count += usize::from(belongs);
    }

    #[inline(always)]
    fn get(&self, place: usize) -> usize {
        self.walkers[place % (2 * AT_ONCE)] as usize % AT_ONCE
    }
}

/// What is asked of each ray of a stream.
pub(super) trait Question {
    /// Whether any hit will do.
    const ANY: bool;

    fn answer(&mut self, index: usize, found: Option<Found>);

    fn answer_any(&mut self, index: usize, hit: bool);
}

pub(super) struct Nearest<'a>(pub(super) &'a mut [Option<Found>]);

impl Question for Nearest<'_> {
    const ANY: bool = false;

    #[inline(always)]
    fn answer(&mut self, index: usize, found: Option<Found>) {
        self.0[index] = found;
    }

    fn answer_any(&mut self, _: usize, _: bool) {}
}

pub(super) struct Any<'a>(pub(super) &'a mut [bool]);

impl Question for Any<'_> {
    const ANY: bool = true;

    fn answer(&mut self, index: usize, found: Option<Found>) {
        self.0[index] = found.is_some();
    }

    #[inline(always)]
    fn answer_any(&mut self, index: usize, hit: bool) {
        self.0[index] = hit;
    }
}

impl Walkers {
    pub(super) fn new() -> Self {
        Self { walks: Vec::new() }
    }

    /// Asks the question of all rays, of which there are as many as answers.
    pub(super) fn walk<Q: Question>(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        question: &mut Q,
    ) {
        let mut next = 0;
        let mut at_nodes = List::EMPTY;
        self.walks.clear();
        while self.walks.len() < AT_ONCE
            && let Some((index, line, ray)) = started(hierarchy, rays, &mut next, question)
        {
            at_nodes.push_if(self.walks.len(), true);
            self.walks.push(Walker {
                index,
                line,
                walk: Walk::new(ray),
                stack: Stack::new(),
            });
        }
        let nodes = &hierarchy.tree.nodes[..];
        while at_nodes.count > 0 {
            let (mut still_at_nodes, mut at_leaves, mut at_ends) =
                (List::EMPTY, List::EMPTY, List::EMPTY);
            for place in 0..at_nodes.count {
                let number = at_nodes.get(place);
                let Walker { walk, stack, .. } = &mut self.walks[number];
                let node = &nodes[walk.current.index()];
                if Q::ANY {
                    walk.visit_for_any(node, stack);
                } else {
                    walk.visit(node, stack);
                }
                let (is_leaf, is_end) = (walk.current.is_leaf(), walk.current == Child::END);
                still_at_nodes.push_if(number, !is_leaf);
                at_leaves.push_if(number, is_leaf && !is_end);
                at_ends.push_if(number, is_end);
            }
            while at_leaves.count > 0 {
                let mut still_at_leaves = List::EMPTY;
                for place in 0..at_leaves.count {
                    let number = at_leaves.get(place);
                    let Walker {
                        walk,
                        stack,
                        line,
                        index,
                    } = &mut self.walks[number];
                    if Q::ANY {
                        if hierarchy.visit_leaf_for_any(line, walk, stack) {
                            question.answer_any(*index, true);
                            *index = usize::MAX;
                            walk.current = Child::END;
                        }
                    } else {
                        hierarchy.visit_leaf(line, walk, stack);
                    }
                    let (is_leaf, is_end) = (walk.current.is_leaf(), walk.current == Child::END);
                    still_at_nodes.push_if(number, !is_leaf);
                    still_at_leaves.push_if(number, is_leaf && !is_end);
                    at_ends.push_if(number, is_end);
                }
                at_leaves = still_at_leaves;
            }
            for place in 0..at_ends.count {
                let number = at_ends.get(place);
                let walker = &mut self.walks[number];
                if Q::ANY {
                    if walker.index != usize::MAX {
                        question.answer_any(walker.index, false);
                    }
                } else {
                    let hit = hierarchy.outcome(&walker.line, &walker.walk);
                    question.answer(walker.index, hit.as_ref().map(found));
                }
                if let Some((index, line, ray)) = started(hierarchy, rays, &mut next, question) {
                    (walker.index, walker.line, walker.walk) = (index, line, Walk::new(ray));
                    still_at_nodes.push_if(number, true);
                }
            }
            at_nodes = still_at_nodes;
        }
    }
}

/// The next ray that has a way to go; those without are answered.
#[inline(always)]
fn started<Q: Question>(
    hierarchy: &Hierarchy,
    rays: &[Ray<Vec3>],
    next: &mut usize,
    question: &mut Q,
) -> Option<(usize, Line, Prepared)> {
    while let Some(ray) = rays.get(*next) {
        let index = *next;
        *next += 1;
        let Some(line) = Line::new(ray) else {
            question.answer(index, None);
            continue;
        };
        let reach = Prepared::reach(&line, hierarchy.scale, hierarchy.largest);
        if Prepared::is_ordinary(&line, reach) {
            return Some((index, line, Prepared::new(&line, hierarchy.scale, reach)));
        }
        let hit = hierarchy.walk_carefully(&line, Q::ANY);
        question.answer(index, hit.as_ref().map(found));
    }
    None
}
