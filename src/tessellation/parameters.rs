//! Triangles in the parameter plane, before they are lifted to the surface.

/// A triangle of the parameter plane, anticlockwise.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    /// Its corners, indices of [`ParameterMesh::vertices`].
    pub corners: [u32; 3],
    /// The piece `[column, row]` of the surface that it lies in.
    pub piece: [u32; 2],
}

/// Triangles over the domain of a surface, and which of their vertices are the same place of space.
#[derive(Clone, Debug)]
pub(super) struct ParameterMesh<S> {
    /// The vertices' parameters `[u, v]`.
    pub vertices: Vec<[S; 2]>,
    /// The triangles.
    pub triangles: Vec<Triangle>,
    /// Vertices that seams and collapsed sides join.
    pub same: Classes,
}

/// A partition of the vertices into classes; those that were never joined are alone in theirs.
#[derive(Clone, Debug, Default)]
pub(super) struct Classes {
    /// An earlier member of the class; short where only the first vertices were joined.
    parents: Vec<u32>,
}

impl Classes {
    /// The first member of the class of `vertex`.
    pub fn first(&self, vertex: u32) -> u32 {
        let mut member = vertex;
        while let Some(&parent) = self.parents.get(member as usize) {
            if parent == member {
                break;
            }
            member = parent;
        }
        member
    }

    /// Makes one class of two.
    pub fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [self.first(a), self.first(b)];
        let [early, late] = [a.min(b), a.max(b)];
        let known = u32::try_from(self.parents.len()).unwrap_or(u32::MAX);
        self.parents.extend(known..=late);
        self.parents[late as usize] = early;
    }
}
