//! The four schemes under one name: their steps, and the mesh of limit points.

use facette::mesh::{Mesh, MeshError};
use facette::subdivision::limit::{
    Limit, catmull_clark_limits, doo_sabin_limits, loop_limits, sqrt3_limits,
};
use facette::subdivision::{
    Connectivity, Corners, DooSabinWeights, Sqrt3Boundary, SubdivisionError, catmull_clark,
    doo_sabin, loop_subdivision, sqrt3,
};
use glam::DVec3;

/// A scheme of the chapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    CatmullClark,
    DooSabin,
    Loop,
    Sqrt3,
}

impl Scheme {
    pub const ALL: [Self; 4] = [Self::CatmullClark, Self::DooSabin, Self::Loop, Self::Sqrt3];

    /// The name in a text.
    pub fn title(self) -> &'static str {
        match self {
            Self::CatmullClark => "Catmull-Clark",
            Self::DooSabin => "Doo-Sabin",
            Self::Loop => "Loop",
            Self::Sqrt3 => "√3",
        }
    }

    /// Whether it subdivides triangles only.
    pub fn wants_triangles(self) -> bool {
        matches!(self, Self::Loop | Self::Sqrt3)
    }

    /// The mesh after `levels` steps.
    // ANCHOR: refined
    pub fn refined(
        self,
        cage: &Mesh<DVec3>,
        levels: u32,
        corners: Corners,
    ) -> Result<Mesh<DVec3>, SubdivisionError> {
        let mut mesh = cage.clone();
        for level in 0..levels {
            let connectivity = Connectivity::new(&mesh)?;
            let points = &mesh.positions;
            mesh = match self {
                Self::CatmullClark => catmull_clark(&connectivity, points, corners),
                Self::DooSabin => doo_sabin(&connectivity, points, DooSabinWeights::Own, corners),
                Self::Loop => loop_subdivision(&connectivity, points, corners),
                Self::Sqrt3 => {
                    let boundary = Sqrt3Boundary::in_step(level);
                    sqrt3(&connectivity, points, boundary, corners)
                }
            }?;
        }
        Ok(mesh)
    }
    // ANCHOR_END: refined

    /// The mesh with its vertices on the limit surface, and the surface's unit normals there.
    ///
    /// For Doo-Sabin, which knows the limit in the middle of faces, it is the dual mesh: a vertex for each face, a face for each vertex.
    /// For √3 a mesh with a boundary must be one of an even level.
    pub fn on_limit(
        self,
        mesh: &Mesh<DVec3>,
        corners: Corners,
    ) -> Result<Mesh<DVec3>, SubdivisionError> {
        let connectivity = Connectivity::new(mesh)?;
        let points = &mesh.positions;
        let limits = match self {
            Self::DooSabin => return doo_sabin_limit_mesh(&connectivity, points, corners),
            Self::CatmullClark => catmull_clark_limits(&connectivity, points, corners),
            Self::Loop => loop_limits(&connectivity, points, corners),
            Self::Sqrt3 => sqrt3_limits(&connectivity, points, corners),
        }?;
        Ok(limit_mesh(&limits, mesh.faces())?)
    }
}

/// The mesh of limit points. Where the surface has no normal, its vertex takes that of the faces around, or any if they have none.
fn limit_mesh<F: AsRef<[u32]>>(
    limits: &[Limit<DVec3>],
    faces: impl IntoIterator<Item = F>,
) -> Result<Mesh<DVec3>, MeshError> {
    let positions = limits.iter().map(|limit| limit.position).collect();
    let mut mesh = Mesh::new(positions, faces)?;
    let of_faces = mesh.vertex_normals();
    let normals = limits.iter().zip(of_faces);
    mesh.normals = normals
        .map(|(limit, of_faces)| limit.normal().or(of_faces.try_normalize()))
        .map(|normal| normal.unwrap_or(DVec3::Z))
        .collect();
    Ok(mesh)
}

/// The limit points in the middle of the faces, and of the edges along the boundary; a face for each vertex that joins those around it.
fn doo_sabin_limit_mesh(
    connectivity: &Connectivity,
    points: &[DVec3],
    corners: Corners,
) -> Result<Mesh<DVec3>, SubdivisionError> {
    let mut limits = doo_sabin_limits(connectivity, points)?;
    let on_edges = boundary_limits(connectivity, points, corners)?;
    let mut numbers = vec![None; connectivity.edge_count()];
    for (edge, limit) in on_edges {
        numbers[edge] = Some(number(limits.len()));
        limits.push(limit);
    }
    let mut faces = Vec::new();
    for vertex in (0..).take(connectivity.vertex_count()) {
        let around: Vec<u32> = connectivity.around(vertex).collect();
        let mut face: Vec<u32> = around.iter().map(|&h| connectivity.face_of(h)).collect();
        let ends = around.first().zip(around.last());
        if let Some((&first, &last)) = ends.filter(|_| connectivity.is_boundary_vertex(vertex)) {
            let arriving = connectivity.edge_of(connectivity.previous(last));
            face.extend(numbers[arriving as usize]);
            if corners == Corners::Sharp && around.len() == 1 {
                face.push(number(limits.len()));
                limits.push(corner_limit(connectivity, points, first));
            }
            face.extend(numbers[connectivity.edge_of(first) as usize]);
        }
        if face.len() > 2 {
            faces.push(face);
        }
    }
    Ok(limit_mesh(&limits, faces)?)
}

/// The limits in the middle of the boundary's edges: after a step each is in the middle of a side of a quadrilateral, and the surface leaves
/// it towards the opposite side.
fn boundary_limits(
    connectivity: &Connectivity,
    points: &[DVec3],
    corners: Corners,
) -> Result<Vec<(usize, Limit<DVec3>)>, SubdivisionError> {
    let finer = doo_sabin(connectivity, points, DooSabinWeights::Own, corners)?;
    let quads = finer.faces().skip(connectivity.face_count()).enumerate();
    let quads = quads.take(connectivity.edge_count());
    let on_boundary = quads.filter(|&(edge, _)| connectivity.is_boundary_edge(number(edge)));
    Ok(on_boundary
        .map(|(edge, quad)| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| finer.positions[quad[i] as usize]);
            let tangents = Some([c - b, a.midpoint(d) - b.midpoint(c)]);
            let position = b.midpoint(c);
            (edge, Limit { position, tangents })
        })
        .collect())
}

/// The limit at a corner that stays: itself, between its two sides.
fn corner_limit(connectivity: &Connectivity, points: &[DVec3], leaving: u32) -> Limit<DVec3> {
    let at = |vertex: u32| points[vertex as usize];
    let position = at(connectivity.origin(leaving));
    let next = at(connectivity.target(leaving));
    let previous = at(connectivity.origin(connectivity.previous(leaving)));
    Limit {
        position,
        tangents: Some([next - position, previous - position]),
    }
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
