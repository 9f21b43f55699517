//! A parametric surface cut into triangles on a uniform grid of parameters.

use super::{Mesh, MeshError};
use crate::algebra::{Real, Scalar, Vector3, VectorSpace, unit_vector};
use crate::surface::Surface;

/// The mesh of `2 · columns · rows` triangles with corners at the points `S(u, v)` of a uniform grid of parameters, with
/// a unit normal and the parameters at each vertex.
///
/// # Shape
///
/// Vertex `row · (columns + 1) + column` is the point at column `column` of u and row `row` of v. Each cell is cut along
/// the diagonal from its lowest to its highest parameters.
///
/// # Errors
///
/// [`MeshError::UnusableGrid`] for a grid without cells or with 2³² vertices or more; [`MeshError::NotFinite`] where the
/// surface has no finite point.
///
/// # Edge cases
///
/// Where the surface gives no normal, the vertex takes that of its triangles ([`Mesh::vertex_normals`]).
///
/// # Examples
///
/// ```
/// use facette::coons::FergusonPatch;
/// use facette::mesh::tessellate_uniformly;
///
/// let flat = std::array::from_fn(|i| std::array::from_fn(|j| [i as f64, j as f64, 0.0]));
/// let mesh = tessellate_uniformly(&FergusonPatch::from_bezier(flat)?, 4, 2)?;
/// assert_eq!((mesh.positions.len(), mesh.face_count()), (15, 16));
/// assert_eq!(mesh.normals[0], [0.0, 0.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn tessellate_uniformly<S>(
    surface: &S,
    columns: usize,
    rows: usize,
) -> Result<Mesh<S::Point>, MeshError>
where
    S: Surface,
    S::Point: Vector3,
    S::Scalar: Real,
{
    let [columns_u32, rows_u32] = usable_grid(columns, rows)?;
    let [domain_u, domain_v] = surface.domain();
    let us = uniform_parameters(domain_u, columns_u32);
    let vs = uniform_parameters(domain_v, rows_u32);
    let mut positions = vec![S::Point::origin(); us.len() * vs.len()];
    surface.points_on_grid(&us, &vs, &mut positions);
    let mut mesh = Mesh::new(positions, grid_triangles(columns_u32, rows_u32))?;
    mesh.parameters = vs
        .iter()
        .flat_map(|&v| us.iter().map(move |&u| [u, v]))
        .collect();
    mesh.normals = surface_normals(surface, &mesh);
    Ok(mesh)
}

/// Both numbers of cells as indices, when every vertex of the grid has one.
fn usable_grid(columns: usize, rows: usize) -> Result<[u32; 2], MeshError> {
    let unusable = MeshError::UnusableGrid { columns, rows };
    let vertices = columns.checked_add(1).zip(rows.checked_add(1));
    let count = vertices.and_then(|(columns, rows)| columns.checked_mul(rows));
    if columns == 0 || rows == 0 || count.is_none_or(|count| u32::try_from(count).is_err()) {
        return Err(unusable);
    }
    let cells = [columns, rows].map(u32::try_from);
    let [Ok(columns), Ok(rows)] = cells else {
        return Err(unusable);
    };
    Ok([columns, rows])
}

/// `cells + 1` equidistant parameters, both ends exact.
fn uniform_parameters<S: Scalar>([start, end]: [S; 2], cells: u32) -> Vec<S> {
    let number = |value: u32| S::from_i32(i32::try_from(value).unwrap_or(i32::MAX));
    let parameter = |index| {
        let t = number(index) / number(cells);
        start * (S::one() - t) + end * t
    };
    (0..=cells).map(parameter).collect()
}

/// Two triangles for each cell, row by row.
fn grid_triangles(columns: u32, rows: u32) -> impl Iterator<Item = [u32; 3]> {
    let stride = columns + 1;
    (0..rows).flat_map(move |row| {
        (0..columns).flat_map(move |column| {
            let a = row * stride + column;
            let [b, c, d] = [a + 1, a + 1 + stride, a + stride];
            [[a, b, c], [a, c, d]]
        })
    })
}

/// The surface's unit normals at the mesh's vertices; those of the triangles where it has none.
fn surface_normals<S>(surface: &S, mesh: &Mesh<S::Point>) -> Vec<S::Point>
where
    S: Surface,
    S::Point: Vector3,
    S::Scalar: Real,
{
    let known = |&[u, v]: &[S::Scalar; 2]| surface.normal_vector(u, v).and_then(unit_vector);
    let normals: Vec<_> = mesh.parameters.iter().map(known).collect();
    if let Some(complete) = normals.iter().copied().collect() {
        return complete;
    }
    let of_triangles = mesh.vertex_normals();
    normals
        .into_iter()
        .zip(of_triangles)
        .map(|(normal, other)| normal.unwrap_or(other))
        .collect()
}
