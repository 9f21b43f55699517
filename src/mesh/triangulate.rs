//! Faces of any shape cut into triangles.

use super::Mesh;
use super::ears::ears;
use crate::algebra::{Vector3, divided, larger};
use num_traits::{One, Zero};

impl<P: Vector3> Mesh<P> {
    /// The same mesh with every face cut into triangles that lie in it, also where it is not convex.
    ///
    /// A face is cut as it looks along the coordinate axis that is nearest to its normal; so a face of a plane is cut right, and one that is slightly
    /// bent too.
    ///
    /// # Shape
    ///
    /// Vertices, normals and parameters stay as they are; a face of n vertices becomes n − 2 triangles that run around as it does.
    ///
    /// # Edge cases
    ///
    /// A face that crosses or touches itself, one without area, and one that is bent so far that it seems to cross itself is cut from its first
    /// vertex, as by [`Mesh::triangles`].
    ///
    /// # Cost
    ///
    /// O(n²) for a face of n vertices.
    ///
    /// # Source
    ///
    /// Ears: Meisters 1975. The normal: M. E. Newell, in Sutherland, Sproull, Schumacker, *A characterization of ten hidden-surface algorithms*, 1974.
    ///
    /// # Examples
    ///
    /// ```
    /// use facette::mesh::Mesh;
    ///
    /// let dart = vec![[0., 0., 0.], [2., -1., 0.], [1., 0., 0.], [2., 1., 0.]];
    /// let mesh = Mesh::new(dart, [[3, 0, 1, 2]])?.triangulated();
    /// assert!(mesh.triangles().all(|triangle| triangle.contains(&0) && triangle.contains(&2)));
    /// # Ok::<(), facette::mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn triangulated(&self) -> Self {
        let mut corners = Vec::with_capacity(3 * self.corners.len());
        for face in self.faces() {
            match self.ears_of(face) {
                Some(ears) => corners.extend(ears.iter().flatten().map(|&at| face[at as usize])),
                None => corners.extend(fan(face).flatten()),
            }
        }
        let ends = (3..=corners.len()).step_by(3).collect();
        Self {
            positions: self.positions.clone(),
            normals: self.normals.clone(),
            parameters: self.parameters.clone(),
            corners,
            ends,
        }
    }

    /// The triangles of a face by the places of its corners; `None` for a triangle, and where ears do not fill the face.
    fn ears_of(&self, face: &[u32]) -> Option<Vec<[u32; 3]>> {
        if face.len() == 3 {
            return None;
        }
        let ears = ears(&self.seen_along_its_normal(face)?);
        (ears.len() + 2 == face.len()).then_some(ears)
    }

    /// The face in the plane of two coordinates in which it is largest, running anticlockwise; `None` without area.
    // ANCHOR: newell
    fn seen_along_its_normal(&self, face: &[u32]) -> Option<Vec<[P::Scalar; 2]>> {
        let start = self.halved(face[0]);
        let from_start = face.iter().map(|&vertex| self.halved(vertex).minus(start));
        let mut points: Vec<P> = from_start.collect();
        let largest = points.iter().map(|point| point.largest_coordinate());
        let scale = largest.fold(P::Scalar::zero(), larger);
        let scale = if scale.is_zero() {
            P::Scalar::one()
        } else {
            scale
        };
        for point in &mut points {
            *point = divided(*point, scale);
        }
        let sides = points.windows(2).map(|side| side[0].cross(side[1]));
        let normal = sides.fold(P::origin(), P::plus);
        let size = normal.largest_coordinate();
        let axis = normal.largest_axis();
        let [mut across, mut up] = [(axis + 1) % 3, (axis + 2) % 3];
        if normal.coordinate(axis) < P::Scalar::zero() {
            (across, up) = (up, across);
        }
        let flat = points
            .iter()
            .map(|point| [point.coordinate(across), point.coordinate(up)]);
        (size > P::Scalar::zero()).then(|| flat.collect())
    }
    // ANCHOR_END: newell
}

/// The triangles of a face from its first vertex.
pub(super) fn fan(face: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    face[1..].windows(2).map(|side| [face[0], side[0], side[1]])
}
