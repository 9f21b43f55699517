//! Triangles that bend too much are cut, without touching the sides that neighbours share.

use std::collections::{HashMap, HashSet};

use super::bounds::Bounds;
use super::cells::{cells_for, chord_error_bound, number};
use super::parameters::Triangle;
use super::stitch::{usable, vertex_number};
use super::{Goal, TessellationError};
use crate::algebra::{Real, Scalar};

/// An edge, whichever way it is run through.
pub(super) type Edge = [u32; 2];

/// The edge between two vertices.
pub(super) fn edge(a: u32, b: u32) -> Edge {
    [a.min(b), a.max(b)]
}

/// No triangle on this side of an edge.
const NONE: u32 = u32::MAX;

/// What bounds the second derivatives.
pub(super) struct Bending<'a, S> {
    /// On any rectangle in a piece.
    pub bounds: &'a Bounds<'a, S>,
    /// On whole pieces: cheap, and often enough.
    pub of_pieces: &'a dyn Fn([u32; 2]) -> Whole<S>,
}

/// What is known of a whole piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Whole<S> {
    /// The bounds of the second derivatives.
    pub bounds: [S; 3],
    /// The sides of a cell that keeps the tolerance everywhere in it: how long is long, in u and in v.
    pub cell: [S; 2],
}

impl<S: Real> Whole<S> {
    /// What these bounds on a rectangle ask for; `None` where that is too many cells.
    pub fn new(bounds: [S; 3], rectangle: [[S; 2]; 2], tolerance: S) -> Option<(Self, [u32; 2])> {
        let sides = rectangle.map(|[start, end]| end - start);
        let cells = cells_for(bounds, sides, tolerance)?;
        let cell = [0, 1].map(|direction| sides[direction] / number(cells[direction]));
        Some((Self { bounds, cell }, cells))
    }
}

impl<S: Scalar> Bending<'_, S> {
    /// Whether the chord error over the box of these vertices is at most the tolerance.
    pub fn fits(
        &self,
        piece: [u32; 2],
        vertices: &[[S; 2]],
        tolerance: S,
    ) -> Result<bool, TessellationError<S>> {
        let rectangle = box_of(vertices);
        let sides = rectangle.map(|[low, high]| high - low);
        if chord_error_bound(sides, (self.of_pieces)(piece).bounds) <= tolerance {
            return Ok(true);
        }
        let bounds = usable((self.bounds)(rectangle), rectangle)?;
        Ok(chord_error_bound(sides, bounds) <= tolerance)
    }
}

/// The smallest rectangle around the vertices.
fn box_of<S: Scalar>(vertices: &[[S; 2]]) -> [[S; 2]; 2] {
    [0, 1].map(|direction| {
        let mut coordinates = vertices.iter().map(|vertex| vertex[direction]);
        let first = coordinates.next().unwrap_or_else(S::zero);
        coordinates.fold([first; 2], |[low, high], x| {
            [
                if x < low { x } else { low },
                if x > high { x } else { high },
            ]
        })
    })
}

/// Triangles that know their neighbours, to be cut without leaving a vertex in the middle of an edge.
pub(super) struct Conforming<'a, S> {
    pub vertices: &'a mut Vec<[S; 2]>,
    pub triangles: Vec<Triangle>,
    /// The one or two triangles at each edge.
    pub neighbours: HashMap<Edge, [u32; 2]>,
    goal: Goal<S>,
}

impl<'a, S: Scalar> Conforming<'a, S> {
    pub fn new(vertices: &'a mut Vec<[S; 2]>, triangles: Vec<Triangle>, goal: Goal<S>) -> Self {
        let mut mesh = Self {
            vertices,
            triangles,
            neighbours: HashMap::new(),
            goal,
        };
        for index in 0..mesh.triangles.len() {
            for side in sides(mesh.triangles[index].corners) {
                mesh.add(side, vertex_number(index));
            }
        }
        mesh
    }

    fn add(&mut self, side: Edge, triangle: u32) {
        let both = self.neighbours.entry(side).or_insert([NONE; 2]);
        let free = usize::from(both[0] != NONE);
        both[free] = triangle;
    }

    fn replace(&mut self, side: Edge, old: u32, new: u32) {
        if let Some(both) = self.neighbours.get_mut(&side) {
            for triangle in both.iter_mut().filter(|triangle| **triangle == old) {
                *triangle = new;
            }
        }
    }

    fn push_vertex(&mut self, vertex: [S; 2]) -> Result<u32, TessellationError<S>> {
        let number = vertex_number(self.vertices.len());
        if number >= self.goal.vertex_limit {
            return Err(self.goal.too_many());
        }
        self.vertices.push(vertex);
        Ok(number)
    }

    fn push_triangle(&mut self, triangle: Triangle) -> u32 {
        self.triangles.push(triangle);
        vertex_number(self.triangles.len() - 1)
    }

    /// Cuts an edge at a point of it, and with it the triangles on both sides; these and the new ones are returned.
    // ANCHOR: split_edge
    pub fn split_edge(&mut self, cut: Edge, at: [S; 2]) -> Result<Vec<u32>, TessellationError<S>> {
        let middle = self.push_vertex(at)?;
        let mut changed = Vec::new();
        for old in self.neighbours.remove(&cut).into_iter().flatten() {
            if old == NONE {
                continue;
            }
            let Triangle { corners, piece } = self.triangles[old as usize];
            let [from, to, apex] = turned_to(corners, cut);
            self.triangles[old as usize].corners = [from, middle, apex];
            let new = self.push_triangle(Triangle {
                corners: [middle, to, apex],
                piece,
            });
            self.replace(edge(to, apex), old, new);
            self.add(edge(middle, apex), old);
            self.add(edge(middle, apex), new);
            self.add(edge(from, middle), old);
            self.add(edge(middle, to), new);
            changed.extend([old, new]);
        }
        Ok(changed)
    }
    // ANCHOR_END: split_edge

    /// Cuts an edge in the middle.
    pub fn bisect(&mut self, cut: Edge) -> Result<Vec<u32>, TessellationError<S>> {
        let ends = cut.map(|vertex| self.vertices[vertex as usize]);
        let half = S::ratio(1, 2);
        let at = [0, 1].map(|d| ends[0][d] * half + ends[1][d] * half);
        if ends.contains(&at) {
            return Err(TessellationError::ParametersTooClose { at });
        }
        self.split_edge(cut, at)
    }

    /// Joins the corners of a triangle with its centre.
    fn split_inside(&mut self, old: u32) -> Result<Vec<u32>, TessellationError<S>> {
        let Triangle { corners, piece } = self.triangles[old as usize];
        let [a, b, c] = corners;
        let points = corners.map(|vertex| self.vertices[vertex as usize]);
        let third = S::ratio(1, 3);
        let at = [0, 1].map(|d| {
            points
                .iter()
                .fold(S::zero(), |sum, point| sum + point[d] * third)
        });
        if points.contains(&at) {
            return Err(TessellationError::ParametersTooClose { at });
        }
        let centre = self.push_vertex(at)?;
        self.triangles[old as usize].corners = [a, b, centre];
        let [second, last] = [[b, c, centre], [c, a, centre]]
            .map(|corners| self.push_triangle(Triangle { corners, piece }));
        self.replace(edge(b, c), old, second);
        self.replace(edge(c, a), old, last);
        for (corner, triangles) in [(a, [old, last]), (b, [old, second]), (c, [second, last])] {
            for triangle in triangles {
                self.add(edge(corner, centre), triangle);
            }
        }
        Ok(vec![old, second, last])
    }

    /// The points of a triangle's corners.
    pub fn points(&self, triangle: u32) -> [[S; 2]; 3] {
        let corners = self.triangles[triangle as usize].corners;
        corners.map(|vertex| self.vertices[vertex as usize])
    }

    /// Cuts the triangles of the list, and what comes of them, until each is within the tolerance. An edge that is frozen stays whole.
    ///
    /// # Source
    ///
    /// Rivara 1997: along the path of longer and longer edges, the last one is cut first, so that no triangle is ever cut
    /// across its shorter edges and shapes do not degenerate from cut to cut.
    // ANCHOR: refine
    pub fn refine(
        &mut self,
        mut unfit: Vec<u32>,
        frozen: &HashSet<Edge>,
        bending: &Bending<'_, S>,
    ) -> Result<(), TessellationError<S>> {
        while let Some(triangle) = unfit.pop() {
            let piece = self.triangles[triangle as usize].piece;
            if bending.fits(piece, &self.points(triangle), self.goal.tolerance)? {
                continue;
            }
            let cell = (bending.of_pieces)(piece).cell;
            let changed = match self.end_of_path(triangle, frozen, cell) {
                Some(side) => self.bisect(side)?,
                None => self.split_inside(triangle)?,
            };
            unfit.push(triangle);
            unfit.extend(changed);
        }
        Ok(())
    }

    /// The last edge of the path that starts at the triangle's longest free edge and crosses it to the next triangle as long as that has
    /// a longer one. It ends before triangles with a frozen edge: these have long edges for good. `None` where all edges are frozen.
    fn end_of_path(&self, triangle: u32, frozen: &HashSet<Edge>, cell: [S; 2]) -> Option<Edge> {
        let square_length = |side: Edge| self.square_length(side, cell);
        let longest = |triangle: u32| {
            let all = sides(self.triangles[triangle as usize].corners).into_iter();
            let free = all.filter(|side| !frozen.contains(side));
            free.reduce(|a, b| {
                if square_length(b) > square_length(a) {
                    b
                } else {
                    a
                }
            })
        };
        let mut at = triangle;
        let mut side = longest(triangle)?;
        loop {
            let beyond = self
                .neighbours
                .get(&side)?
                .iter()
                .find(|&&other| other != at);
            let is_inner = |&other: &u32| {
                let next = sides(self.triangles[other as usize].corners);
                !next.iter().any(|side| frozen.contains(side))
            };
            let Some(next) = beyond
                .copied()
                .filter(|&other| other != NONE)
                .filter(is_inner)
            else {
                return Some(side);
            };
            let its_longest = longest(next)?;
            if square_length(its_longest) <= square_length(side) {
                return Some(side);
            }
            (at, side) = (next, its_longest);
        }
    }
    // ANCHOR_END: refine

    /// The square of an edge's length, with the cell's sides as units: the longest edge is cut, so that shapes stay alike.
    fn square_length(&self, side: Edge, cell: [S; 2]) -> S {
        let [a, b] = side.map(|vertex| self.vertices[vertex as usize]);
        let [x, y] = [0, 1].map(|direction| (b[direction] - a[direction]) / cell[direction]);
        x * x + y * y
    }
}

/// The triangles, cut until each is within the tolerance; frozen edges stay whole.
pub(super) fn refined<S: Scalar>(
    vertices: &mut Vec<[S; 2]>,
    triangles: Vec<Triangle>,
    frozen: &HashSet<Edge>,
    bending: &Bending<'_, S>,
    goal: Goal<S>,
) -> Result<Vec<Triangle>, TessellationError<S>> {
    let mut unfit = Vec::new();
    for (index, triangle) in triangles.iter().enumerate() {
        let points = triangle.corners.map(|vertex| vertices[vertex as usize]);
        if !bending.fits(triangle.piece, &points, goal.tolerance)? {
            unfit.push(vertex_number(index));
        }
    }
    if unfit.is_empty() {
        return Ok(triangles);
    }
    let mut mesh = Conforming::new(vertices, triangles, goal);
    mesh.refine(unfit, frozen, bending)?;
    Ok(mesh.triangles)
}

/// The edges of a triangle.
pub(super) fn sides([a, b, c]: [u32; 3]) -> [Edge; 3] {
    [edge(a, b), edge(b, c), edge(c, a)]
}

/// The corners in the same order, from the edge on.
fn turned_to([a, b, c]: [u32; 3], cut: Edge) -> [u32; 3] {
    if edge(a, b) == cut {
        [a, b, c]
    } else if edge(b, c) == cut {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
