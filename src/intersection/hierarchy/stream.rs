//! Many rays at once: while one waits for memory, the others go on.
//!
//! A ray's way down the tree is a chain: which node is next is known only when the last one has been tested. The processor can do several times as
//! much in that time. So a number of rays walk side by side, each taking one step in turn; those at a node first, then those at a
//! leaf, so that no branch has to guess which it is.

use glam::Vec3;

use super::confirm::Line;
use super::finish::Arrived;
use super::node::{Child, Node};
use super::packet::Packet;
use super::prepared::{GROUP, Group, Prepared};
use super::stack::Stack;
use super::walk::{Place, Walk};
use super::{Found, Hierarchy, found};
use crate::ray::Ray;

/// How many rays walk side by side.
pub(super) const AT_ONCE: usize = 16;

/// The rays that walk side by side, with their stacks.
#[derive(Clone, Debug)]
pub(super) struct Walkers {
    walks: Vec<Walker>,
    group: Group,
    /// The stack of packets.
    stack: Box<Stack>,
}

/// One of them.
#[derive(Clone, Debug)]
struct Walker {
    /// Which ray of the stream.
    index: usize,
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
    #[allow(
        clippy::cast_possible_truncation,
        reason = "there are fewer walkers than 256"
    )]
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

    /// The ray with this number meets nothing.
    fn miss(&mut self, index: usize);

    /// It meets the triangle in a place first, or any triangle.
    fn hit(&mut self, hierarchy: &Hierarchy, rays: &[Ray<Vec3>], index: usize, place: Place);

    /// It has been answered already.
    fn found(&mut self, index: usize, found: Option<Found>);

    /// All rays have arrived.
    fn finish(&mut self, hierarchy: &Hierarchy, rays: &[Ray<Vec3>]);
}

/// Which triangle is met first?
pub(super) struct Nearest<'a> {
    pub(super) answers: &'a mut [Option<Found>],
    pub(super) arrived: Arrived,
}

impl Question for Nearest<'_> {
    const ANY: bool = false;

    #[inline(always)]
    fn miss(&mut self, index: usize) {
        self.answers[index] = None;
    }

    #[inline(always)]
    fn hit(&mut self, hierarchy: &Hierarchy, rays: &[Ray<Vec3>], index: usize, place: Place) {
        self.arrived
            .add(hierarchy, rays, index, place, self.answers);
    }

    fn found(&mut self, index: usize, found: Option<Found>) {
        self.answers[index] = found;
    }

    fn finish(&mut self, hierarchy: &Hierarchy, rays: &[Ray<Vec3>]) {
        self.arrived.answer(hierarchy, rays, self.answers);
    }
}

/// Is any met?
pub(super) struct Any<'a> {
    pub(super) answers: &'a mut [bool],
}

impl Question for Any<'_> {
    const ANY: bool = true;

    #[inline(always)]
    fn miss(&mut self, index: usize) {
        self.answers[index] = false;
    }

    #[inline(always)]
    fn hit(&mut self, _: &Hierarchy, _: &[Ray<Vec3>], index: usize, _: Place) {
        self.answers[index] = true;
    }

    fn found(&mut self, index: usize, found: Option<Found>) {
        self.answers[index] = found.is_some();
    }

    fn finish(&mut self, _: &Hierarchy, _: &[Ray<Vec3>]) {}
}

impl Walkers {
    pub(super) fn new() -> Self {
        Self {
            walks: Vec::new(),
            group: Group::new(),
            stack: Stack::new(),
        }
    }

    /// Asks the question of all rays, of which there are as many as answers.
    pub(super) fn walk<Q: Question>(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        question: &mut Q,
    ) {
        let Self {
            walks,
            group,
            stack,
        } = self;
        let mut queue = Queue {
            hierarchy,
            rays,
            group,
            stack,
            next: 0,
        };
        let mut at_nodes = start(walks, &mut queue, question);
        while at_nodes.count > 0 {
            let mut round = Round::EMPTY;
            round.visit_nodes(&hierarchy.tree.nodes, walks, &at_nodes);
            while round.leaves.count > 0 {
                round.visit_leaves::<Q>(hierarchy, rays, walks);
            }
            round.start_others(walks, &mut queue, question);
            at_nodes = round.nodes;
        }
        question.finish(hierarchy, rays);
    }
}

/// The first walkers, as many as there are rays for, all at the root.
fn start<Q: Question>(walks: &mut Vec<Walker>, queue: &mut Queue<'_>, question: &mut Q) -> List {
    let mut at_nodes = List::EMPTY;
    for number in 0..AT_ONCE {
        let Some((index, ray)) = queue.next(question) else {
            break;
        };
        let walk = Walk::new(ray);
        match walks.get_mut(number) {
            Some(walker) => (walker.index, walker.walk) = (index, walk),
            None => walks.push(Walker {
                index,
                walk,
                stack: Stack::new(),
            }),
        }
        at_nodes.push_if(number, true);
    }
    at_nodes
}

/// Where the walkers are after a step.
struct Round {
    nodes: List,
    leaves: List,
    ends: List,
}

impl Round {
    const EMPTY: Self = Self {
        nodes: List::EMPTY,
        leaves: List::EMPTY,
        ends: List::EMPTY,
    };

    #[inline(always)]
    fn sort(&mut self, walker: usize, at: Child) {
        let (is_leaf, is_end) = (at.is_leaf(), at == Child::END);
        self.nodes.push_if(walker, !is_leaf);
        self.leaves.push_if(walker, is_leaf && !is_end);
        self.ends.push_if(walker, is_end);
    }

    /// A step of those that are at a node.
    #[inline(always)]
    fn visit_nodes(&mut self, nodes: &[Node], walks: &mut [Walker], at_nodes: &List) {
        for place in 0..at_nodes.count {
            let number = at_nodes.get(place);
            let Walker { walk, stack, .. } = &mut walks[number];
            walk.visit(&nodes[walk.current.index()], stack);
            self.sort(number, walk.current);
        }
    }

    /// A step of those that are at a leaf.
    #[inline(always)]
    fn visit_leaves<Q: Question>(
        &mut self,
        hierarchy: &Hierarchy,
        rays: &[Ray<Vec3>],
        walks: &mut [Walker],
    ) {
        let at_leaves = std::mem::replace(&mut self.leaves, List::EMPTY);
        for place in 0..at_leaves.count {
            let number = at_leaves.get(place);
            let Walker { walk, stack, index } = &mut walks[number];
            if !Q::ANY {
                hierarchy.visit_leaf(&rays[*index], walk, stack);
            } else if hierarchy.visit_leaf_for_any(&rays[*index], walk, stack) {
                walk.current = Child::END;
                walk.place.leaf = 0;
            }
            self.sort(number, walk.current);
        }
    }

    /// Answers the rays that have arrived, and starts others in their place.
    #[inline(always)]
    fn start_others<Q: Question>(
        &mut self,
        walks: &mut [Walker],
        queue: &mut Queue<'_>,
        question: &mut Q,
    ) {
        for place in 0..self.ends.count {
            let number = self.ends.get(place);
            let Walker { walk, index, .. } = &mut walks[number];
            if walk.place == Place::NONE {
                question.miss(*index);
            } else {
                question.hit(queue.hierarchy, queue.rays, *index, walk.place);
            }
            if let Some((next, ray)) = queue.next(question) {
                *index = next;
                *walk = Walk::new(ray);
                self.nodes.push_if(number, true);
            }
        }
    }
}

/// The rays that have not started yet.
struct Queue<'a> {
    hierarchy: &'a Hierarchy,
    rays: &'a [Ray<Vec3>],
    group: &'a mut Group,
    stack: &'a mut Stack,
    next: usize,
}

impl Queue<'_> {
    /// The next ray that has a way to go; those without are answered.
    #[inline(always)]
    fn next<Q: Question>(&mut self, question: &mut Q) -> Option<(usize, Prepared)> {
        while self.next < self.rays.len() {
            let (index, lane) = (self.next, self.next % GROUP);
            if lane == 0 {
                self.group.fill(&self.rays[index..], self.hierarchy.scene);
                if self.walk_together(question) {
                    self.next += GROUP;
                    continue;
                }
            }
            self.next += 1;
            if self.group.ordinary >> lane & 1 == 1 {
                return Some((index, self.group.ray(lane)));
            }
            question.found(index, self.carefully(index, Q::ANY));
        }
        None
    }

    /// Answers the eight rays of the group as a packet, if they go the same way.
    #[inline(always)]
    fn walk_together<Q: Question>(&mut self, question: &mut Q) -> bool {
        let Some(mut packet) = Packet::new(self.group, self.hierarchy.scene) else {
            return false;
        };
        let rays = &self.rays[self.next..];
        if Q::ANY {
            packet.walk::<true>(self.hierarchy, rays, self.stack);
        } else {
            packet.walk::<false>(self.hierarchy, rays, self.stack);
        }
        for lane in 0..GROUP {
            match packet.place(lane) {
                Place::NONE => question.miss(self.next + lane),
                place => question.hit(self.hierarchy, self.rays, self.next + lane, place),
            }
        }
        true
    }

    #[cold]
    fn carefully(&self, index: usize, any: bool) -> Option<Found> {
        let line = Line::new(&self.rays[index])?;
        self.hierarchy
            .walk_carefully(&line, any)
            .as_ref()
            .map(found)
    }
}
