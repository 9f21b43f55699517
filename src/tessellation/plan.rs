//! Points on the sides of the pieces and in them, and the triangles between.

use std::collections::HashSet;

use super::bounds::{BoundedSurface, Bounds, Break};
use super::cells::segments_for;
use super::parameters::{Classes, ParameterMesh, Triangle};
use super::refine::{Bending, Whole, edge, refined};
use super::stitch::{Fill, Inner, division, usable, vertex_number, zipped};
use super::{Goal, TessellationError, intervals};
use crate::algebra::Real;
use crate::bspline::{Closing, Direction};

/// A side of a piece: how many segments it has, and the number of its first inner vertex.
#[derive(Clone, Copy, Debug)]
struct Side {
    segments: u32,
    first: u32,
}

impl Side {
    /// The vertices from one end to the other.
    fn chain(self, from: u32, to: u32) -> Vec<u32> {
        let inner = self.first..self.first + self.segments - 1;
        std::iter::once(from).chain(inner).chain([to]).collect()
    }
}

/// The net of sides of a surface, and the cells inside each piece.
struct Plan<'a, S> {
    goal: Goal<S>,
    lines: [Vec<Break<S>>; 2],
    bounds: Bounds<'a, S>,
    /// `along[0][line * pieces + piece]` are the sides in u on the lines of constant v; `along[1]` the other way round.
    along: [Vec<Side>; 2],
    mesh: ParameterMesh<S>,
}

/// The triangles of all pieces in the parameter plane, with the seams' and collapsed sides' vertices joined.
pub(super) fn parameter_mesh<T>(
    surface: &T,
    goal: Goal<T::Scalar>,
) -> Result<ParameterMesh<T::Scalar>, TessellationError<T::Scalar>>
where
    T: BoundedSurface,
    T::Scalar: Real,
{
    let mut plan = Plan {
        goal,
        lines: intervals(surface)?,
        bounds: surface.second_derivative_bounds(),
        along: [Vec::new(), Vec::new()],
        mesh: ParameterMesh {
            vertices: Vec::new(),
            triangles: Vec::new(),
            same: Classes::default(),
        },
    };
    let closing = surface.closing();
    plan.count_sides(closing)?;
    let cells = plan.count_cells()?;
    plan.place_sides()?;
    plan.join_seams(closing);
    plan.join_collapsed(surface)?;
    for (index, inner) in cells.into_iter().enumerate() {
        let columns = plan.pieces(0);
        plan.triangulate([index % columns, index / columns], inner)?;
    }
    Ok(plan.mesh)
}

impl<S: Real> Plan<'_, S> {
    fn pieces(&self, direction: usize) -> usize {
        self.lines[direction].len() - 1
    }

    fn interval(&self, direction: usize, piece: usize) -> [S; 2] {
        [piece, piece + 1].map(|line| self.lines[direction][line].at)
    }

    /// The bounds on a rectangle, refused where they are none.
    fn bounds_on(&self, rectangle: [[S; 2]; 2]) -> Result<[S; 3], TessellationError<S>> {
        usable((self.bounds)(rectangle), rectangle)
    }

    /// The rectangle of the side of a piece on a line across `direction`.
    fn side_rectangle(&self, direction: usize, line: usize, piece: usize) -> [[S; 2]; 2] {
        let across = [self.lines[1 - direction][line].at; 2];
        let mut rectangle = [across; 2];
        rectangle[direction] = self.interval(direction, piece);
        rectangle
    }

    /// Counts the segments of each side, from its own curve's bound alone; a seam's second side has those of its first.
    fn count_sides(&mut self, closing: [Closing; 2]) -> Result<(), TessellationError<S>> {
        for direction in [0, 1] {
            let [pieces, lines] = [self.pieces(direction), self.lines[1 - direction].len()];
            for line in 0..lines {
                let is_seam = line + 1 == lines && closing[1 - direction] != Closing::Open;
                for piece in 0..pieces {
                    let segments = if is_seam {
                        let first = self.mirrored(direction, piece, closing[1 - direction])?;
                        self.along[direction][first].segments
                    } else {
                        let rectangle = self.side_rectangle(direction, line, piece);
                        let [start, end] = rectangle[direction];
                        let bound = self.bounds_on(rectangle)?[2 * direction];
                        segments_for(bound, end - start, self.goal.tolerance)
                            .ok_or_else(|| self.goal.too_many())?
                    };
                    self.along[direction].push(Side { segments, first: 0 });
                }
            }
        }
        Ok(())
    }

    /// The piece of the first side of a seam that is joined to `piece` of its last; refused where their lengths differ.
    fn mirrored(
        &self,
        direction: usize,
        piece: usize,
        closing: Closing,
    ) -> Result<usize, TessellationError<S>> {
        if closing != Closing::Flipped {
            return Ok(piece);
        }
        let other = self.pieces(direction) - 1 - piece;
        let [first, last] = [piece, other].map(|piece| {
            let [start, end] = self.interval(direction, piece);
            end - start
        });
        let largest =
            [0, self.pieces(direction)].map(|line| self.lines[direction][line].at.magnitude());
        let rounding = (largest[0] + largest[1]) * S::from_i32(4) * S::unit_roundoff();
        if (first - last).magnitude() > rounding {
            let direction = [Direction::V, Direction::U][direction];
            return Err(TessellationError::SeamNotSymmetric {
                direction,
                first,
                last,
            });
        }
        Ok(other)
    }

    /// The cells inside each piece; refuses what has too many vertices, before any is made.
    fn count_cells(&self) -> Result<Vec<Inner<S>>, TessellationError<S>> {
        let lines = self.lines.each_ref().map(|lines| lines.len() as u64);
        let sides = self.along.iter().flatten();
        let on_sides: u64 = sides.map(|side| u64::from(side.segments) - 1).sum();
        let mut vertices = lines[0] * lines[1] + on_sides;
        let mut cells = Vec::new();
        for row in 0..self.pieces(1) {
            for column in 0..self.pieces(0) {
                let box_ = [self.interval(0, column), self.interval(1, row)];
                let bounds = self.bounds_on(box_)?;
                let (whole, needed) = Whole::new(bounds, box_, self.goal.tolerance)
                    .ok_or_else(|| self.goal.too_many())?;
                let sides = self.sides_of([column, row]).map(|side| side.segments);
                let inner = Inner::new(needed, sides, whole);
                vertices = vertices.saturating_add(inner.vertices());
                cells.push(inner);
            }
        }
        if vertices > u64::from(self.goal.vertex_limit) {
            return Err(self.goal.too_many());
        }
        Ok(cells)
    }

    /// The sides of a piece: bottom, right, top, left.
    fn sides_of(&self, [column, row]: [usize; 2]) -> [Side; 4] {
        let [columns, rows] = [self.pieces(0), self.pieces(1)];
        let in_u = |line: usize| self.along[0][line * columns + column];
        let in_v = |line: usize| self.along[1][line * rows + row];
        [in_u(row), in_v(column + 1), in_u(row + 1), in_v(column)]
    }

    /// Makes the corners of all pieces and the vertices on their sides.
    fn place_sides(&mut self) -> Result<(), TessellationError<S>> {
        let [us, vs] = &self.lines;
        let corners = vs.iter().flat_map(|v| us.iter().map(|u| [u.at, v.at]));
        self.mesh.vertices.extend(corners);
        for direction in [0, 1] {
            let pieces = self.pieces(direction);
            for index in 0..self.along[direction].len() {
                let [line, piece] = [index / pieces, index % pieces];
                let rectangle = self.side_rectangle(direction, line, piece);
                let segments = self.along[direction][index].segments;
                self.along[direction][index].first = vertex_number(self.mesh.vertices.len());
                for parameter in division(rectangle, direction, segments)? {
                    let mut vertex = rectangle.map(|[start, _]| start);
                    vertex[direction] = parameter;
                    self.mesh.vertices.push(vertex);
                }
            }
        }
        Ok(())
    }

    fn corner(&self, column: usize, row: usize) -> u32 {
        vertex_number(row * self.lines[0].len() + column)
    }

    /// The corner at which `line` and `across` meet, `line` being one of constant parameter across `direction`.
    fn corner_on(&self, direction: usize, line: usize, across: usize) -> u32 {
        if direction == 0 {
            self.corner(across, line)
        } else {
            self.corner(line, across)
        }
    }

    /// Joins the vertices of the last line with those of the first, where the surface closes.
    fn join_seams(&mut self, closing: [Closing; 2]) {
        for direction in [0, 1] {
            let how = closing[1 - direction];
            if how == Closing::Open {
                continue;
            }
            let [pieces, last] = [self.pieces(direction), self.pieces(1 - direction)];
            let is_flipped = how == Closing::Flipped;
            for across in 0..=pieces {
                let other = if is_flipped { pieces - across } else { across };
                let [a, b] =
                    [(0, other), (last, across)].map(|(l, x)| self.corner_on(direction, l, x));
                self.mesh.same.join(a, b);
            }
            for piece in 0..pieces {
                let other = if is_flipped {
                    pieces - 1 - piece
                } else {
                    piece
                };
                let there = self.along[direction][last * pieces + piece];
                let here = self.along[direction][other];
                for step in 0..there.segments - 1 {
                    let back = if is_flipped {
                        there.segments - 2 - step
                    } else {
                        step
                    };
                    self.mesh.same.join(here.first + back, there.first + step);
                }
            }
        }
    }

    /// Joins the ends of sides that are one point: without bending, and with equal ends.
    fn join_collapsed<T>(&mut self, surface: &T) -> Result<(), TessellationError<S>>
    where
        T: BoundedSurface<Scalar = S>,
    {
        for direction in [0, 1] {
            let pieces = self.pieces(direction);
            for index in 0..self.along[direction].len() {
                let [line, piece] = [index / pieces, index % pieces];
                if self.along[direction][index].segments > 1 {
                    continue;
                }
                let rectangle = self.side_rectangle(direction, line, piece);
                let is_straight = self.bounds_on(rectangle)?[2 * direction].is_zero();
                if is_straight && surface.is_collapsed(rectangle) {
                    let ends = [piece, piece + 1].map(|x| self.corner_on(direction, line, x));
                    self.mesh.same.join(ends[0], ends[1]);
                }
            }
        }
        Ok(())
    }

    /// The vertices on the sides of a piece (bottom, right, top, left), in the direction of their parameters.
    fn chains_of(&self, piece: [usize; 2]) -> [Vec<u32>; 4] {
        let [column, row] = piece;
        let [bottom, right, top, left] = self.sides_of(piece);
        let [a, b] = [column, column + 1].map(|column| self.corner(column, row));
        let [d, c] = [column, column + 1].map(|column| self.corner(column, row + 1));
        [
            bottom.chain(a, b),
            right.chain(b, c),
            top.chain(d, c),
            left.chain(a, d),
        ]
    }

    /// Makes the triangles of one piece.
    fn triangulate(
        &mut self,
        piece: [usize; 2],
        inner: Inner<S>,
    ) -> Result<(), TessellationError<S>> {
        let chains = self.chains_of(piece);
        let corners = match inner.fill {
            Fill::AlongU => zipped(&chains[0], &chains[2], |vertex| {
                self.mesh.vertices[vertex as usize][0]
            }),
            Fill::AlongV => zipped(&chains[1], &chains[3], |vertex| {
                self.mesh.vertices[vertex as usize][1]
            }),
            Fill::Grid(cells) => self.grid(piece, cells, chains.clone())?,
        };
        let piece = piece.map(vertex_number);
        let triangles = corners
            .into_iter()
            .map(|corners| Triangle { corners, piece });
        let sides = chains.iter().flat_map(|chain| chain.windows(2));
        let frozen: HashSet<_> = sides.map(|ends| edge(ends[0], ends[1])).collect();
        let bending = Bending {
            bounds: &self.bounds,
            of_pieces: &|_| inner.whole,
        };
        let vertices = &mut self.mesh.vertices;
        let refined = refined(vertices, triangles.collect(), &frozen, &bending, self.goal)?;
        self.mesh.triangles.extend(refined);
        Ok(())
    }

    /// The triangles of a grid whose outermost vertices are replaced by those of the sides.
    fn grid(
        &mut self,
        [column, row]: [usize; 2],
        [columns, rows]: [u32; 2],
        [bottom, right, mut top, mut left]: [Vec<u32>; 4],
    ) -> Result<Vec<[u32; 3]>, TessellationError<S>> {
        let rectangle = [self.interval(0, column), self.interval(1, row)];
        let first = vertex_number(self.mesh.vertices.len());
        let us = division(rectangle, 0, columns)?;
        for v in division(rectangle, 1, rows)? {
            self.mesh.vertices.extend(us.iter().map(|&u| [u, v]));
        }
        let width = columns - 1;
        let at = |i: u32, j: u32| first + j * width + i;
        let [last_i, last_j] = [columns - 2, rows - 2];
        let mut triangles = Vec::new();
        for j in 0..last_j {
            for i in 0..last_i {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        top.reverse();
        left.reverse();
        let position = |direction: usize, sign: S| {
            let vertices = &self.mesh.vertices;
            move |vertex: u32| vertices[vertex as usize][direction] * sign
        };
        let [forth, back] = [S::one(), -S::one()];
        let rising_u: Vec<_> = (0..=last_i).map(|i| at(i, 0)).collect();
        let rising_v: Vec<_> = (0..=last_j).map(|j| at(last_i, j)).collect();
        let falling_u: Vec<_> = (0..=last_i).rev().map(|i| at(i, last_j)).collect();
        let falling_v: Vec<_> = (0..=last_j).rev().map(|j| at(0, j)).collect();
        triangles.extend(zipped(&bottom, &rising_u, position(0, forth)));
        triangles.extend(zipped(&right, &rising_v, position(1, forth)));
        triangles.extend(zipped(&top, &falling_u, position(0, back)));
        triangles.extend(zipped(&left, &falling_v, position(1, back)));
        Ok(triangles)
    }
}
