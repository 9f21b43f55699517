//! Small plane meshes for figures, and how to draw them.

use facette::mesh::Mesh;
use facette::subdivision::Connectivity;
use facette_figure::palette::Colour;
use facette_figure::svg::{Dashes, Drawing, Stroke};

/// A point of a drawing, y down.
pub type Place = [f64; 2];

/// The stroke of a mesh that is no more.
pub const OLD: Stroke = Stroke {
    colour: Colour::Faint,
    width: 1.8,
    dashes: Dashes::Dashed,
};

/// The mesh of these places and faces.
pub fn mesh<F: AsRef<[u32]>>(
    places: Vec<Place>,
    faces: impl IntoIterator<Item = F>,
) -> Mesh<Place> {
    Mesh::new(places, faces).expect("the figures' faces name their places")
}

/// How the faces of a figure's mesh are joined.
pub fn joined(mesh: &Mesh<Place>) -> Connectivity {
    Connectivity::new(mesh).expect("the figures' meshes are manifolds")
}

/// The edges of a mesh.
pub fn draw_edges(drawing: Drawing, mesh: &Mesh<Place>, stroke: Stroke) -> Drawing {
    let joined = joined(mesh);
    (0..)
        .take(joined.edge_count())
        .fold(drawing, |drawing, edge| {
            let h = joined.half_edge_of(edge);
            let [a, b] = [joined.origin(h), joined.target(h)].map(|v| mesh.positions[v as usize]);
            drawing.line(a, b, stroke)
        })
}

/// Places around a centre, the first one straight up, anticlockwise on the page.
pub fn around(centre: Place, radius: f64, count: usize) -> impl Iterator<Item = Place> {
    (0..count).map(move |i| {
        let angle = std::f64::consts::TAU * i as f64 / count as f64;
        [
            centre[0] - radius * angle.sin(),
            centre[1] - radius * angle.cos(),
        ]
    })
}

/// A place moved part of the way to another.
pub fn towards(from: Place, to: Place, part: f64) -> Place {
    [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]))
}
