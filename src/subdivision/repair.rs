//! The explicit way to a manifold: what [`Connectivity`](super::Connectivity) refuses, this mends by cutting.

use std::collections::{HashMap, HashSet};

use super::connectivity::index_of;
use crate::algebra::VectorSpace;
use crate::mesh::{Mesh, MeshError};

/// What [`repaired`] had to do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repair {
    /// Corners left out because the face had just visited their vertex.
    pub corners_dropped: usize,
    /// Faces left out: fewer than three distinct vertices, a vertex visited twice, or a repetition of an earlier face.
    pub faces_dropped: usize,
    /// Faces turned over, so that neighbours agree.
    pub faces_turned: usize,
    /// Vertices added where the surface was cut.
    pub vertices_added: usize,
}

/// The mesh made a consistently oriented manifold: a mesh that [`Connectivity::new`](super::Connectivity::new) accepts.
///
/// Repeated corners and unusable faces are left out; faces are turned over to agree with the first one that they hang together with;
/// the mesh is cut open along every edge where more than two faces meet, or two that cannot agree (as on a Möbius band), and in every
/// vertex where several fans touch: there each fan but the first gets a copy of the vertex, after all the old vertices. Positions are kept,
/// normals and parameters are not.
///
/// # Errors
///
/// [`MeshError::NotFinite`] where a position was made infinite or NaN after the mesh had been checked.
///
/// # Cost
///
/// O(n log n) in the number of corners, expected; a mesh without faults is copied.
///
/// # Examples
///
/// ```
/// use facette::mesh::Mesh;
/// use facette::subdivision::{Connectivity, repaired};
///
/// // Two triangles that touch in a vertex.
/// let corners = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-1.0, 0.0], [-1.0, -1.0]];
/// let bow_tie = Mesh::new(corners, [[0, 1, 2], [0, 3, 4]])?;
/// assert!(Connectivity::new(&bow_tie).is_err());
/// let (mended, repair) = repaired(&bow_tie)?;
/// assert_eq!(repair.vertices_added, 1);
/// assert!(Connectivity::new(&mended).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn repaired<P: VectorSpace>(mesh: &Mesh<P>) -> Result<(Mesh<P>, Repair), MeshError> {
    let mut repair = Repair::default();
    let mut faces = usable_faces(mesh, &mut repair);
    let mut positions = mesh.positions.clone();
    // Cutting a vertex may leave an edge with two faces that can now agree: turn and cut until nothing is left to cut.
    loop {
        turn_faces(&mut faces, &mut repair);
        if !cut(&mut faces, &mut positions) {
            break;
        }
    }
    repair.vertices_added = positions.len() - mesh.positions.len();
    Ok((Mesh::new(positions, faces)?, repair))
}

/// The faces that have distinct vertices and are no repetition.
fn usable_faces<P: VectorSpace>(mesh: &Mesh<P>, repair: &mut Repair) -> Vec<Vec<u32>> {
    let mut seen = HashSet::new();
    let mut usable = Vec::with_capacity(mesh.face_count());
    for face in mesh.faces() {
        let mut vertices = face.to_vec();
        vertices.dedup();
        if vertices.len() > 1 && vertices.first() == vertices.last() {
            vertices.pop();
        }
        repair.corners_dropped += face.len() - vertices.len();
        let mut sorted = vertices.clone();
        sorted.sort_unstable();
        let is_simple = sorted.windows(2).all(|pair| pair[0] != pair[1]);
        if vertices.len() >= 3 && is_simple && seen.insert(sorted) {
            usable.push(vertices);
        } else {
            repair.faces_dropped += 1;
        }
    }
    usable
}

/// A corner as face and place in it.
type Corner = (usize, usize);

/// The half-edges along each edge, each named by the corner that it leaves.
fn half_edges_by_edge(faces: &[Vec<u32>]) -> HashMap<[u32; 2], Vec<Corner>> {
    let mut along = HashMap::<_, Vec<_>>::new();
    for (face, vertices) in faces.iter().enumerate() {
        for place in 0..vertices.len() {
            let [a, b] = ends(faces, (face, place));
            along
                .entry([a.min(b), a.max(b)])
                .or_default()
                .push((face, place));
        }
    }
    along
}

fn ends(faces: &[Vec<u32>], (face, place): Corner) -> [u32; 2] {
    let vertices = &faces[face];
    [vertices[place], vertices[(place + 1) % vertices.len()]]
}

/// Turns faces over so that neighbours run along their common edge in opposite directions, as far as that can be had: each face follows
/// the one from which it was reached.
fn turn_faces(faces: &mut [Vec<u32>], repair: &mut Repair) {
    let along = half_edges_by_edge(faces);
    let mut is_turned = vec![None; faces.len()];
    for start in 0..faces.len() {
        if is_turned[start].is_some() {
            continue;
        }
        is_turned[start] = Some(false);
        let mut reached = vec![start];
        while let Some(face) = reached.pop() {
            for place in 0..faces[face].len() {
                let [a, b] = ends(faces, (face, place));
                let [(f, i), (g, j)] = along[&[a.min(b), a.max(b)]][..] else {
                    continue;
                };
                let other = if f == face { g } else { f };
                if is_turned[other].is_none() {
                    let disagree = ends(faces, (f, i)) == ends(faces, (g, j));
                    is_turned[other] = is_turned[face].map(|turned| turned != disagree);
                    reached.push(other);
                }
            }
        }
    }
    for (face, turned) in faces.iter_mut().zip(is_turned) {
        if turned == Some(true) {
            face.reverse();
            repair.faces_turned += 1;
        }
    }
}

/// Gives every fan of faces around a vertex a vertex of its own; whether there was anything to cut.
fn cut<P: VectorSpace>(faces: &mut [Vec<u32>], positions: &mut Vec<P>) -> bool {
    let mut starts = vec![0];
    for face in faces.iter() {
        starts.push(starts[starts.len() - 1] + face.len());
    }
    let number = |(face, place): Corner| starts[face] + place % faces[face].len();
    // Corners of one fan end up under one root.
    let mut parents: Vec<usize> = (0..starts[faces.len()]).collect();
    for half_edges in half_edges_by_edge(faces).into_values() {
        if let [h @ (f, i), g @ (e, j)] = half_edges[..]
            && ends(faces, h) != ends(faces, g)
        {
            join(&mut parents, number(h), number((e, j + 1)));
            join(&mut parents, number((f, i + 1)), number(g));
        }
    }
    let mut fans = HashMap::new();
    let mut owners = vec![None; positions.len()];
    let old_count = positions.len();
    for (corner, vertex) in faces.iter_mut().flatten().enumerate() {
        let root = root_of(&mut parents, corner);
        *vertex = *fans.entry(root).or_insert_with(|| {
            let owner = &mut owners[*vertex as usize];
            if owner.is_none() {
                *owner = Some(root);
                return *vertex;
            }
            positions.push(positions[*vertex as usize]);
            index_of(positions.len() - 1)
        });
    }
    positions.len() > old_count
}

fn root_of(parents: &mut [usize], mut corner: usize) -> usize {
    while parents[corner] != corner {
        parents[corner] = parents[parents[corner]];
        corner = parents[corner];
    }
    corner
}

fn join(parents: &mut [usize], a: usize, b: usize) {
    let [a, b] = [root_of(parents, a), root_of(parents, b)];
    // The smaller number is the root, so that the result does not depend on the order of joining.
    parents[a.max(b)] = a.min(b);
}
