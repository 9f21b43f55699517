//! Figures of how faces are joined, and of what a step makes of a mesh.

use facette::mesh::Mesh;
use facette::subdivision::{
    Connectivity, Corners, Counts, DooSabinWeights, Sqrt3Boundary, catmull_clark, doo_sabin,
    loop_subdivision, sqrt3,
};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::svg::{Anchor, Drawing, Panel, Stroke, panels};

use super::meshes::{OLD, Place, draw_edges, joined, mesh, towards};
use super::solids::octahedron;

const PANEL: [f64; 2] = [340.0, 270.0];
const TEXT: f64 = 17.0;

/// A sheet of quadrilaterals, one of them cut into two triangles.
fn sheet() -> Mesh<Place> {
    let places = vec![
        [24., 40.],
        [130., 22.],
        [232., 48.],
        [318., 24.],
        [40., 140.],
        [128., 128.],
        [224., 150.],
        [322., 130.],
        [22., 246.],
        [120., 236.],
        [214., 252.],
        [320., 244.],
    ];
    let faces: [&[u32]; 7] = [
        &[0, 4, 5, 1],
        &[1, 5, 6, 2],
        &[2, 6, 7],
        &[2, 7, 3],
        &[4, 8, 9, 5],
        &[5, 9, 10, 6],
        &[6, 10, 11, 7],
    ];
    mesh(places, faces)
}

/// The sheet with two of its faces joined to one of five corners.
fn polygons() -> Mesh<Place> {
    let sheet = sheet();
    let faces: [&[u32]; 6] = [
        &[0, 4, 5, 1],
        &[1, 5, 6, 7, 2],
        &[2, 7, 3],
        &[4, 8, 9, 5],
        &[5, 9, 10, 6],
        &[6, 10, 11, 7],
    ];
    mesh(sheet.positions, faces)
}

/// The sheet, all faces cut into triangles.
fn triangles() -> Mesh<Place> {
    let sheet = sheet();
    let triangles: Vec<[u32; 3]> = sheet.triangles().collect();
    mesh(sheet.positions, triangles)
}

fn panel_of(before: &Mesh<Place>, after: &Mesh<Place>) -> Drawing {
    let mut drawing = Drawing::new(PANEL[0], PANEL[1]);
    drawing = draw_edges(drawing, after, Stroke::new(Colour::Blue, 2.0));
    drawing = draw_edges(drawing, before, OLD);
    after.positions.iter().fold(drawing, |drawing, &place| {
        drawing.disc(place, 3.4, Colour::Vermilion)
    })
}

fn start_of(mesh: &Mesh<Place>) -> Drawing {
    let drawing = Drawing::new(PANEL[0], PANEL[1]);
    let drawing = draw_edges(drawing, mesh, Stroke::new(Colour::Ink, 2.0));
    mesh.positions.iter().fold(drawing, |drawing, &place| {
        drawing.disc(place, 4.0, Colour::Ink)
    })
}

/// One step of the two schemes for any polygons.
pub fn steps_of_polygons() -> Figure {
    let old = polygons();
    let (joined, points) = (joined(&old), &old.positions);
    let [sharp, smooth] = [Corners::Sharp, Corners::Smooth].map(|corners| {
        doo_sabin(&joined, points, DooSabinWeights::Own, corners).expect("a small mesh")
    });
    let quads = catmull_clark(&joined, points, Corners::Sharp).expect("a small mesh");
    let steps = [
        Panel::drawing("the mesh: faces of 3, 4 and 5 corners", start_of(&old)),
        Panel::drawing("Doo-Sabin", panel_of(&old, &sharp)),
        Panel::drawing("Catmull-Clark", panel_of(&old, &quads)),
        Panel::drawing("Doo-Sabin with smooth corners", panel_of(&old, &smooth)),
    ];
    Figure::drawn(
        "steps_of_polygons",
        "One step on a sheet with a boundary. Doo-Sabin makes a face of each face, each edge and each vertex, and all inner vertices have four edges. Catmull-Clark makes four-sided faces only: one for each corner of a face. The dashed mesh is the old one.",
        "Four panels. A sheet of six polygons. Then its faces, each shrunken, with bands between them along the old edges and small polygons around the old vertices. Then a net of quadrilaterals, whose corners are the moved vertices, points on the edges and points in the faces. Last the second panel again, its corners cut off.",
        &panels(2, &steps),
    )
}

/// One step of Loop's scheme, and two of √3.
pub fn steps_of_triangles() -> Figure {
    let old = triangles();
    let (joined_old, points) = (joined(&old), &old.positions);
    let quarters = loop_subdivision(&joined_old, points, Corners::Sharp).expect("a small mesh");
    let first = sqrt3(&joined_old, points, Sqrt3Boundary::Kept, Corners::Sharp);
    let first = first.expect("a small mesh");
    let second = sqrt3(
        &joined(&first),
        &first.positions,
        Sqrt3Boundary::Trisected,
        Corners::Sharp,
    );
    let steps = [
        Panel::drawing("the mesh: 12 triangles", start_of(&old)),
        Panel::drawing("Loop: 48", panel_of(&old, &quarters)),
        Panel::drawing("√3, first step: 36", panel_of(&old, &first)),
        Panel::drawing(
            "√3, second step: 108",
            panel_of(&first, &second.expect("a small mesh")),
        ),
    ];
    Figure::drawn(
        "steps_of_triangles",
        "Steps on triangles. Loop cuts each triangle into four. √3 puts a point into each and flips every inner edge; the boundary waits for the second step, which divides its edges by three. A corner with a single triangle stays, one with two is rounded off. (The dashed mesh of the last panel is the one before it.)",
        "Four panels. A sheet of twelve triangles. The same with each triangle cut into four. Then with a point in each triangle, joined to its corners and to the points in the neighbouring triangles, while the old inner edges are gone. Last a net nine times as fine as the first.",
        &panels(2, &steps),
    )
}

/// An arrow along a half-edge, a little to its left and shorter than the edge.
fn draw_half_edge(drawing: Drawing, [a, b]: [Place; 2], centre: Place, stroke: Stroke) -> Drawing {
    let inside = |place: Place| towards(place, centre, 0.12);
    let [from, to] = [inside(a), inside(b)];
    drawing.arrow(towards(from, to, 0.08), towards(from, to, 0.92), stroke)
}

/// A half-edge and its relatives.
pub fn half_edges() -> Figure {
    let places = [
        [60., 60.],
        [80., 270.],
        [350., 290.],
        [360., 50.],
        [680., 70.],
        [650., 270.],
    ];
    let quads = mesh(places.to_vec(), [[0, 1, 2, 3], [3, 2, 5, 4]]);
    let joined = joined(&quads);
    let mut drawing = Drawing::new(750.0, 330.0);
    drawing = draw_edges(drawing, &quads, Stroke::new(Colour::Faint, 3.0));
    let centre_of = |face: u32| {
        let vertices = joined.vertices_of(face);
        [0, 1].map(|axis| {
            vertices
                .iter()
                .map(|&v| places[v as usize][axis])
                .sum::<f64>()
                / 4.0
        })
    };
    let chosen = 2;
    let twin = joined.twin(chosen).expect("the edge in the middle");
    for h in (0..).take(joined.half_edge_count()) {
        let ends = [joined.origin(h), joined.target(h)].map(|v| places[v as usize]);
        let centre = centre_of(joined.face_of(h));
        let is_relative = [joined.next(chosen), joined.previous(chosen)].contains(&h);
        let colour = match h {
            _ if h == chosen => Colour::Vermilion,
            _ if h == twin => Colour::Purple,
            _ if is_relative => Colour::Blue,
            _ => Colour::Faint,
        };
        drawing = draw_half_edge(drawing, ends, centre, Stroke::new(colour, 3.0));
        let name = match h {
            _ if h == chosen => "*h*".to_owned(),
            _ if h == twin => "twin".to_owned(),
            _ if h == joined.next(chosen) => "next".to_owned(),
            _ if h == joined.previous(chosen) => "previous".to_owned(),
            _ => String::new(),
        };
        let label = if name.is_empty() {
            format!("{h}")
        } else {
            format!("{name} ({h})")
        };
        let middle = towards(ends[0], ends[1], 0.5);
        let place = towards(middle, centre, if h == twin { 0.44 } else { 0.36 });
        drawing = drawing.text([place[0], place[1] + 6.0], &label, TEXT, Anchor::Middle);
    }
    for (vertex, &place) in places.iter().enumerate() {
        drawing = drawing.disc(place, 5.0, Colour::Ink);
        let above = if place[1] < 150.0 { -14.0 } else { 28.0 };
        let label = [place[0], place[1] + above];
        drawing = drawing.text(label, &format!("vertex {vertex}"), TEXT, Anchor::Middle);
    }
    Figure::drawn(
        "half_edges",
        "Two faces and their half-edges, numbered face after face. Each belongs to the face on its left and to the corner where it begins. The half-edge 2 runs from vertex 2 to vertex 3; its twin is the same edge seen from the other face.",
        "Two four-sided faces side by side. Inside each, four arrows run anticlockwise along its sides, numbered 0 to 3 in the left face and 4 to 7 in the right one. The arrow 2, on the common edge, is marked as h; 3 is called next, 1 previous, and the arrow 4 on the other side of the common edge is its twin.",
        &drawing,
    )
}

/// Three ways in which faces cannot be joined.
pub fn refused_meshes() -> Figure {
    let shape = |places: &[&[Place]], common: &[Place]| {
        let mut drawing = Drawing::new(PANEL[0], 220.0);
        for (colour, face) in [Colour::Blue, Colour::Green, Colour::Orange]
            .into_iter()
            .zip(places)
        {
            drawing = drawing
                .area(face, colour, 0.35)
                .outline(face, Stroke::new(colour, 2.0));
        }
        match common {
            [a, b] => drawing.line(*a, *b, Stroke::new(Colour::Vermilion, 5.0)),
            _ => common.iter().fold(drawing, |drawing, &place| {
                drawing.disc(place, 7.0, Colour::Vermilion)
            }),
        }
    };
    let [top, bottom] = [[170.0, 36.0], [170.0, 186.0]];
    let three = shape(
        &[
            &[top, bottom, [40.0, 150.0]],
            &[top, bottom, [300.0, 160.0]],
            &[top, bottom, [250.0, 60.0]],
        ],
        &[top, bottom],
    );
    let middle = [170.0, 110.0];
    let touching = shape(
        &[
            &[middle, [40.0, 40.0], [40.0, 180.0]],
            &[middle, [300.0, 180.0], [300.0, 40.0]],
        ],
        &[middle],
    );
    let sides = [[[44.0, 110.0], top, bottom], [[296.0, 110.0], top, bottom]];
    let mut turned = shape(&[&sides[0], &sides[1]], &[top, bottom]);
    for [tip, top, bottom] in sides {
        let centre = [0, 1].map(|axis| (tip[axis] + top[axis] + bottom[axis]) / 3.0);
        for ends in [[top, bottom], [bottom, tip], [tip, top]] {
            turned = draw_half_edge(turned, ends, centre, Stroke::new(Colour::Ink, 2.0));
        }
    }
    let cases = [
        Panel::drawing("three faces, one edge", three),
        Panel::drawing("faces that only touch", touching),
        Panel::drawing("one face turned over", turned),
    ];
    Figure::drawn(
        "refused_meshes",
        "Three meshes that are refused, and the element that the error names (red). An edge is between two faces at most; the faces around a vertex hang together by edges; and neighbours run along their common edge in opposite directions.",
        "Three panels. Three triangles that share one edge, which is red. Two triangles that share only one corner, which is red. Two triangles with a common red edge; arrows along their sides run down that edge in both of them.",
        &panels(3, &cases),
    )
}

/// How many triangles the two schemes make, by steps and by the length of an edge.
pub fn triangle_counts() -> Figure {
    let octahedron = Connectivity::new(&octahedron::<f64>()).expect("a closed mesh");
    let [by_loop, by_sqrt3] = [true, false].map(|is_loop| {
        let mut counts = Counts::of(&octahedron);
        let mut rows = vec![[0.0, counts.faces as f64]];
        for step in 0..if is_loop { 8 } else { 10 } {
            let after = if is_loop {
                counts.after_loop()
            } else {
                counts.after_sqrt3(Sqrt3Boundary::Kept)
            };
            counts = after.expect("less than four thousand million");
            rows.push([f64::from(step + 1), counts.faces as f64]);
        }
        rows
    });
    let plot = Plot::new("", "steps", "triangles")
        .log_y()
        .line("Loop: 8 · 4^k", &by_loop)
        .line("√3: 8 · 3^k", &by_sqrt3);
    let drawing = plot.to_drawing().expect("counts are positive and finite");
    Figure::drawn(
        "triangle_counts",
        "Triangles after each step, from the octahedron's eight. √3 goes up in smaller leaps, so one stops nearer to what one needs.",
        "Two rising straight lines on a logarithmic scale of triangles. Loop's scheme reaches half a million in eight steps, √3 in ten.",
        &drawing,
    )
}
