//! Mistakes in a step on a mesh.

use facette::algebra::{Real, Scalar, VectorSpace};
use facette::mesh::Mesh;
use facette::subdivision::mask::{loop_vertex_weight, turn_cosine};
use facette::subdivision::{Connectivity, Corners, SubdivisionError};

use super::MISTAKES;

/// What a step gives.
type Refined<P> = Result<Mesh<P>, SubdivisionError>;

fn is_made_in(exercise: &str, name: &str) -> bool {
    MISTAKES
        .iter()
        .any(|mistake| mistake.exercise == exercise && mistake.name == name)
}

fn mean<P: VectorSpace>(points: impl IntoIterator<Item = P>) -> P {
    let (mut sum, mut count) = (P::origin(), 0);
    for point in points {
        sum = sum.plus(point);
        count += 1;
    }
    sum.times(P::Scalar::ratio(1, count))
}

/// A mesh in the middle of a step, with a mistake.
struct Step<'a, P> {
    name: &'a str,
    joined: &'a Connectivity,
    points: &'a [P],
    corners: Corners,
}

impl<P: VectorSpace> Step<'_, P> {
    fn at(&self, vertex: u32) -> P {
        self.points[vertex as usize]
    }

    fn mean_of(&self, vertices: impl IntoIterator<Item = u32>) -> P {
        mean(vertices.into_iter().map(|vertex| self.at(vertex)))
    }

    fn ends(&self, h: u32) -> [u32; 2] {
        [self.joined.origin(h), self.joined.target(h)]
    }

    fn counts(&self) -> [u32; 4] {
        let joined = self.joined;
        [
            joined.vertex_count(),
            joined.edge_count(),
            joined.face_count(),
            joined.half_edge_count(),
        ]
        .map(|count| u32::try_from(count).expect("a small mesh"))
    }

    /// The place of a vertex that is on the boundary or has no face; `None` for a vertex that moves as one inside.
    fn outer_vertex(&self, vertex: u32) -> Option<P> {
        let p = self.at(vertex);
        let Some(neighbours) = self.joined.boundary_neighbours(vertex) else {
            return self.joined.outgoing(vertex).is_none().then_some(p);
        };
        if self.name == "boundary_as_inside" {
            return None;
        }
        let is_corner = self.joined.around(vertex).count() == 1;
        let is_kept = self.corners == Corners::Sharp && self.name != "corners_rounded";
        if is_corner && is_kept || self.name == "vertices_stay" {
            return Some(p);
        }
        let [a, b] = neighbours.map(|vertex| self.at(vertex));
        let (centre, sum) = if self.name == "limit_mask_on_the_boundary" {
            (4, 6)
        } else {
            (6, 8)
        };
        let weights = [1, centre, 1].map(|weight| P::Scalar::ratio(weight, sum));
        Some(P::combination(weights, [a, p, b]))
    }

    /// The vertices with an edge to this one.
    fn ring(&self, vertex: u32) -> Vec<u32> {
        let around = self.joined.around(vertex).map(|h| self.joined.target(h));
        let before = self
            .joined
            .boundary_neighbours(vertex)
            .map(|[before, _]| before);
        around.chain(before).collect()
    }

    fn face_point(&self, face: u32) -> P {
        let vertices = self.joined.vertices_of(face);
        match self.name {
            "face_point_of_three_corners" => self.mean_of(vertices[..3].iter().copied()),
            "quarter_of_every_corner" => {
                let sum = vertices.iter().map(|&v| self.at(v)).reduce(P::plus);
                sum.unwrap_or_else(P::origin).times(P::Scalar::ratio(1, 4))
            }
            _ => self.mean_of(vertices.iter().copied()),
        }
    }

    fn catmull_clark_edge(&self, edge: u32) -> P {
        let h = self.joined.half_edge_of(edge);
        let q = self.mean_of(self.ends(h));
        let left = self.face_point(self.joined.face_of(h));
        let Some(twin) = self.joined.twin(h) else {
            let with_face = mean([q, q, left]);
            return if self.name == "boundary_edges_pulled_inside" {
                with_face
            } else {
                q
            };
        };
        let r = mean([left, self.face_point(self.joined.face_of(twin))]);
        match self.name {
            "edge_midpoints" => q,
            "edges_of_face_points_only" => r,
            _ => mean([q, r]),
        }
    }

    fn catmull_clark_vertex(&self, vertex: u32) -> P {
        let s = self.at(vertex);
        if let Some(point) = self.outer_vertex(vertex) {
            return point;
        }
        let around = || self.joined.around(vertex);
        let q = mean(around().map(|h| self.face_point(self.joined.face_of(h))));
        let r = match self.name {
            "r_of_edge_points" => {
                mean(around().map(|h| self.catmull_clark_edge(self.joined.edge_of(h))))
            }
            _ => mean(
                self.ring(vertex)
                    .into_iter()
                    .map(|other| self.mean_of([vertex, other])),
            ),
        };
        let n = i32::try_from(self.ring(vertex).len()).expect("a small mesh");
        let (weights, sum) = match self.name {
            "vertices_stay" => ([0, 0, 1], 1),
            "valence_four_everywhere" => ([1, 2, 1], 4),
            "n_minus_two" => ([1, 2, n - 2], n),
            _ => ([1, 2, n - 3], n),
        };
        P::combination(
            weights.map(|weight| P::Scalar::ratio(weight, sum)),
            [q, r, s],
        )
    }

    fn loop_edge(&self, edge: u32) -> P {
        let h = self.joined.half_edge_of(edge);
        let opposite = |h| self.joined.origin(self.joined.previous(h));
        let ends = self.mean_of(self.ends(h));
        let Some(twin) = self.joined.twin(h) else {
            return ends;
        };
        let beside = self.mean_of([opposite(h), opposite(twin)]);
        let quarters = match self.name {
            "edge_midpoints" => 0,
            "edge_weights_exchanged" => 3,
            "edge_weights_all_alike" => 2,
            _ => 1,
        };
        ends.lerp(beside, P::Scalar::ratio(quarters, 4))
    }

    fn loop_vertex(&self, vertex: u32, alpha: &dyn Fn(usize) -> P::Scalar) -> P {
        let v = self.at(vertex);
        if let Some(point) = self.outer_vertex(vertex) {
            return point;
        }
        let ring = self.ring(vertex);
        let rest = P::Scalar::from_i32(1) - alpha(ring.len());
        let q = self.mean_of(ring.iter().copied());
        match self.name {
            "vertices_stay" => v,
            "valence_six_everywhere" => v.lerp(q, P::Scalar::ratio(3, 8)),
            "alpha_and_rest_exchanged" => q.lerp(v, rest),
            "sum_of_neighbours" => {
                let sum = ring.iter().map(|&v| self.at(v)).reduce(P::plus);
                let alpha = P::Scalar::from_i32(1) - rest;
                v.times(alpha)
                    .plus(sum.unwrap_or_else(P::origin).times(rest))
            }
            _ => v.lerp(q, rest),
        }
    }
}

/// A step of Catmull-Clark with a mistake; `None` where it has none of this name.
pub fn catmull_clark<P: VectorSpace>(
    name: &str,
    joined: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Option<Refined<P>> {
    if !is_made_in("catmull_clark", name) {
        return None;
    }
    let step = Step {
        name,
        joined,
        points,
        corners,
    };
    let [vertices, edges, faces, half_edges] = step.counts();
    let moved = (0..vertices).map(|v| step.catmull_clark_vertex(v));
    let on_edges = (0..edges).map(|edge| step.catmull_clark_edge(edge));
    let on_faces = (0..faces).map(|face| step.face_point(face));
    let positions = moved.chain(on_edges).chain(on_faces).collect();
    let new_faces = (0..half_edges).map(|h| {
        let of_edge = |h| vertices + joined.edge_of(h);
        let centre = vertices + edges + joined.face_of(h);
        let (after, before) = (of_edge(h), of_edge(joined.previous(h)));
        if name == "faces_turned_over" {
            [joined.origin(h), before, centre, after]
        } else {
            [joined.origin(h), after, centre, before]
        }
    });
    Some(Mesh::new(positions, new_faces).map_err(Into::into))
}

/// A step of Loop's scheme with a mistake, and with the right weights or others; `None` where it has none of this name.
pub fn loop_subdivision_with<P: VectorSpace>(
    name: &str,
    joined: &Connectivity,
    points: &[P],
    corners: Corners,
    alpha: &dyn Fn(usize) -> P::Scalar,
) -> Option<Refined<P>> {
    if !is_made_in("loop", name) || name == "printed_cosine" {
        return None;
    }
    Some(loop_step(
        &Step {
            name,
            joined,
            points,
            corners,
        },
        alpha,
    ))
}

/// A step of Loop's scheme with a mistake in its weight; `None` where it has none of this name.
pub fn loop_subdivision<P: VectorSpace>(
    name: &str,
    joined: &Connectivity,
    points: &[P],
    corners: Corners,
) -> Option<Refined<P>>
where
    P::Scalar: Real,
{
    let printed = |n: usize| loop_vertex_weight(turn_cosine(3, 2 * n));
    let step = Step {
        name,
        joined,
        points,
        corners,
    };
    (name == "printed_cosine").then(|| loop_step(&step, &printed))
}

fn loop_step<P: VectorSpace>(step: &Step<P>, alpha: &dyn Fn(usize) -> P::Scalar) -> Refined<P> {
    step.joined.must_be_triangles()?;
    step.joined.must_have_points(step.points.len())?;
    let [vertices, edges, faces, _] = step.counts();
    let moved = (0..vertices).map(|v| step.loop_vertex(v, alpha));
    let on_edges = (0..edges).map(|edge| step.loop_edge(edge));
    let positions = moved.chain(on_edges).collect();
    let new_faces = (0..faces).flat_map(|face| {
        let h = step.joined.half_edges_of(face).start;
        let [a, b, c] = [0, 1, 2].map(|i| step.joined.origin(h + i));
        let [d, e, f] = [0, 1, 2].map(|i| vertices + step.joined.edge_of(h + i));
        let middle = if step.name == "middle_turned_over" {
            [d, f, e]
        } else {
            [d, e, f]
        };
        [[a, d, f], [b, e, d], [c, f, e], middle]
    });
    Ok(Mesh::new(positions, new_faces)?)
}
