//! Figures of the masks of the schemes, with the weights that a step really uses.

use facette::mesh::Mesh;
use facette::subdivision::{
    Connectivity, Corners, DooSabinWeights, Sqrt3Boundary, catmull_clark, doo_sabin,
    loop_subdivision, sqrt3,
};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Anchor, Drawing, Panel, Stroke, panels};

use super::meshes::{Place, around, draw_edges, joined, mesh};

const PANEL: [f64; 2] = [340.0, 300.0];
const TEXT: f64 = 18.0;

/// A step as a function of the points alone.
type Step = fn(&Connectivity, &[f64]) -> Mesh<f64>;

fn by_catmull_clark(joined: &Connectivity, points: &[f64]) -> Mesh<f64> {
    catmull_clark(joined, points, Corners::Sharp).expect("a small mesh")
}

fn by_doo_sabin(joined: &Connectivity, points: &[f64]) -> Mesh<f64> {
    doo_sabin(joined, points, DooSabinWeights::Own, Corners::Sharp).expect("a small mesh")
}

fn by_averaging(joined: &Connectivity, points: &[f64]) -> Mesh<f64> {
    doo_sabin(joined, points, DooSabinWeights::Averaging, Corners::Sharp).expect("a small mesh")
}

fn by_loop(joined: &Connectivity, points: &[f64]) -> Mesh<f64> {
    loop_subdivision(joined, points, Corners::Sharp).expect("a small mesh of triangles")
}

fn by_sqrt3(joined: &Connectivity, points: &[f64]) -> Mesh<f64> {
    sqrt3(joined, points, Sqrt3Boundary::Kept, Corners::Sharp).expect("a small mesh of triangles")
}

/// The weights of all old points in a new one: what the step makes of a 1 in one of them and 0 in the others.
fn weights(old: &Mesh<Place>, step: Step, new: usize) -> Vec<f64> {
    let joined = joined(old);
    let count = old.positions.len();
    let of_one = |vertex: usize| {
        let mut points = vec![0.0; count];
        points[vertex] = 1.0;
        step(&joined, &points).positions[new]
    };
    (0..count).map(of_one).collect()
}

/// A mesh with the old points of a mask ringed and weighed, and the new point that is their mean. Weights are written over a common
/// denominator, or as decimals where that is 0.
fn stencil(old: &Mesh<Place>, step: Step, new: usize, denominator: i32) -> Drawing {
    let mut drawing = Drawing::new(PANEL[0], PANEL[1]);
    drawing = draw_edges(drawing, old, Stroke::new(Colour::Faint, 2.0));
    let weights = weights(old, step, new);
    let mut mean = [0.0; 2];
    for (place, weight) in old.positions.iter().zip(&weights) {
        mean = [0, 1].map(|axis| mean[axis] + weight * place[axis]);
    }
    drawing = drawing.disc(mean, 7.0, Colour::Vermilion);
    for (&place, &weight) in old.positions.iter().zip(&weights) {
        if weight.abs() < 1e-9 {
            continue;
        }
        let text = if denominator == 0 {
            format!("{weight:.3}")
        } else {
            format!("{:.0}/{denominator}", weight * f64::from(denominator))
        };
        drawing = drawing
            .circle(place, 8.0, Stroke::new(Colour::Blue, 2.4))
            .haloed_text(label_of(place, mean), &text, TEXT, Anchor::Middle);
    }
    drawing
}

/// Where the weight of an old point is written: away from the new one, above or below the old point.
fn label_of([x, y]: Place, mean: Place) -> Place {
    let up = y < mean[1] + 1.0;
    [x, if up { y - 16.0 } else { y + 28.0 }]
}

/// Quadrilaterals in a slanted grid, 3 x 3 vertices.
fn quads() -> Mesh<Place> {
    let place = |i: i32, j: i32| [f64::from(i) * 118.0 + 52.0, f64::from(j) * 98.0 + 48.0];
    let places = (0..3)
        .flat_map(|j| (0..3).map(move |i| place(i, j)))
        .collect();
    let quad = |i: u32, j: u32| {
        let first = i + 3 * j;
        [first, first + 3, first + 4, first + 1]
    };
    mesh(places, (0..2).flat_map(|j| (0..2).map(move |i| quad(i, j))))
}

/// Triangles around a vertex, number 0.
fn fan(count: usize) -> Mesh<Place> {
    let centre = [170.0, 150.0];
    let places = std::iter::once(centre).chain(around(centre, 112.0, count));
    let number = |i: usize| u32::try_from(i % count + 1).expect("a small figure");
    let faces: Vec<_> = (0..count).map(|i| [0, number(i), number(i + 1)]).collect();
    mesh(places.collect(), faces)
}

/// One face.
fn polygon(count: usize) -> Mesh<Place> {
    let places = if count == 4 {
        vec![[60.0, 50.0], [60.0, 246.0], [280.0, 246.0], [280.0, 50.0]]
    } else {
        around([170.0, 160.0], 116.0, count).collect()
    };
    let face: Vec<u32> = (0..).take(count).collect();
    mesh(places, [face])
}

/// Two triangles that share an edge, and a square's worth of air.
fn diamond() -> Mesh<Place> {
    let places = vec![[170.0, 48.0], [44.0, 150.0], [296.0, 150.0], [170.0, 252.0]];
    mesh(places, [[0, 1, 2], [1, 3, 2]])
}

fn number_of_edge(mesh: &Mesh<Place>, a: u32, b: u32) -> usize {
    let joined = joined(mesh);
    let is_it = |&edge: &u32| {
        let h = joined.half_edge_of(edge);
        [joined.origin(h), joined.target(h)] == [a, b]
            || [joined.target(h), joined.origin(h)] == [a, b]
    };
    let mut edges = (0..).take(joined.edge_count());
    let edge = edges.find(is_it).expect("an edge of the figure");
    mesh.positions.len() + edge as usize
}

/// The masks of Catmull-Clark on quadrilaterals.
pub fn catmull_clark_masks() -> Figure {
    let quads = quads();
    let (vertices, edges) = (quads.positions.len(), joined(&quads).edge_count());
    let masks = [
        Panel::drawing(
            "face point",
            stencil(&quads, by_catmull_clark, vertices + edges, 4),
        ),
        Panel::drawing(
            "edge point",
            stencil(&quads, by_catmull_clark, number_of_edge(&quads, 1, 4), 16),
        ),
        Panel::drawing(
            "vertex point, four edges",
            stencil(&quads, by_catmull_clark, 4, 64),
        ),
        Panel::drawing(
            "vertex point on the boundary",
            stencil(&quads, by_catmull_clark, 1, 8),
        ),
    ];
    Figure::drawn(
        "catmull_clark_masks",
        "The masks of Catmull-Clark where all faces are quadrilaterals: the old points (rings) with their weights, and the new point (orange). Face and edge points are averaged into one another, so the weights of an edge point and of a vertex reach over all faces around.",
        "Four panels with a grid of four quadrilaterals. Weights 1/4 at the four corners of one of them, the new point in its middle. 6/16 at the ends of an inner edge and 1/16 at the four other corners beside it. 36/64 at the middle vertex, 6/64 at its four neighbours, 1/64 at the four corners. 6/8 at a vertex of the boundary and 1/8 at its neighbours along the boundary.",
        &panels(2, &masks),
    )
}

/// The masks of Doo-Sabin.
pub fn doo_sabin_masks() -> Figure {
    let [quad, pentagon] = [polygon(4), polygon(5)];
    let masks = [
        Panel::drawing(
            "four corners: both weights",
            stencil(&quad, by_doo_sabin, 0, 16),
        ),
        Panel::drawing(
            "five corners: the slides' mean",
            stencil(&pentagon, by_averaging, 0, 40),
        ),
        Panel::drawing(
            "five corners: Doo's and Sabin's own",
            stencil(&pentagon, by_doo_sabin, 0, 0),
        ),
        Panel::drawing("on the boundary", stencil(&quad, by_doo_sabin, 4, 4)),
    ];
    Figure::drawn(
        "doo_sabin_masks",
        "The masks of Doo-Sabin: a corner (the heaviest ring) moves into its face, to the orange point. In a quadrilateral both kinds of weights are products of Chaikin's 3/4 and 1/4. In other faces they differ a little. On the boundary a step is Chaikin's.",
        "Four panels. A quadrilateral with the weights 9/16 at its upper left corner, 3/16 at the two beside it and 1/16 opposite. A pentagon with 22/40 at its top, 7/40 at the two corners beside it and 2/40 at the other two; the same with 0.500, 0.181 and 0.069. The quadrilateral with 3/4 and 1/4 at the ends of one side.",
        &panels(2, &masks),
    )
}

/// The masks of the schemes for triangles.
pub fn triangle_masks() -> Figure {
    let (fan, diamond) = (fan(6), diamond());
    let masks = [
        Panel::drawing(
            "Loop: edge point",
            stencil(&diamond, by_loop, number_of_edge(&diamond, 1, 2), 8),
        ),
        Panel::drawing(
            "Loop: vertex point, six edges",
            stencil(&fan, by_loop, 0, 16),
        ),
        Panel::drawing("√3: new point", stencil(&diamond, by_sqrt3, 4, 3)),
        Panel::drawing(
            "√3: vertex point, six edges",
            stencil(&fan, by_sqrt3, 0, 18),
        ),
    ];
    Figure::drawn(
        "triangle_masks",
        "The masks of the two schemes for triangles. Both move the old vertices towards the mean of their neighbours: at valence 6, Loop's by 3/8 of the way, √3 by 1/3.",
        "Four panels. Two triangles with a common edge: weights 3/8 at its ends, 1/8 at the two other corners, a new point in the middle. Six triangles around a vertex: 10/16 in the middle, 1/16 around it. Two triangles with 1/3 at the three corners of one, the new point inside it. Six triangles again: 12/18 in the middle, 1/18 around it.",
        &panels(2, &masks),
    )
}

/// The place of an entry of the slides' matrix in its figure.
const CELL: f64 = 76.0;

/// The nine weights of each of the nine points of the slides' matrix.
pub fn biquadratic_matrix() -> Figure {
    let quads = quads();
    // The corner points of all faces on the 3 x 3 net, by the place where they are drawn: that of row i, column j of the slide.
    let joined = joined(&quads);
    let refined = doo_sabin(
        &joined,
        &quads.positions,
        DooSabinWeights::Own,
        Corners::Sharp,
    )
    .expect("a small mesh");
    let mut drawing = Drawing::new(750.0, 3.0 * (3.0 * CELL / 2.4 + 34.0) + 6.0);
    for row in 0..3_usize {
        for column in 0..3_usize {
            let wanted = [row, column].map(|index| (2 * index + 1) as f64 / 4.0);
            let new = refined.positions[..joined.half_edge_count()]
                .iter()
                .position(|place| {
                    let [i, j] = [(place[1] - 48.0) / 98.0, (place[0] - 52.0) / 118.0];
                    (i - wanted[0]).abs() + (j - wanted[1]).abs() < 1e-6
                });
            let new = new.expect("nine of the sixteen corner points");
            let weights = weights(&quads, by_doo_sabin, new);
            let is_wrong = [row, column] == [1, 2];
            let corner = [150.0 + 160.0 * column as f64, 4.0 + 128.0 * row as f64];
            drawing = draw_entry(drawing, &weights, corner, is_wrong);
        }
    }
    Figure::drawn(
        "biquadratic_matrix",
        "The nine entries of the matrix $16P'$, each as a table of the weights of $P_{00}$ to $P_{22}$. Transposing the whole figure and every table in it leaves it as it is. The framed entry is the one that the slide prints wrongly, with 9 and 3 exchanged in its middle column.",
        "Nine small tables of three rows and three columns, in three rows. In the first table the number 9 stands at the upper left with a 3 to its right and a 3 below it, and a 1 between them. In the others the same square of 9, 3, 3 and 1 has other places and is mirrored. The table in the second row and third column is framed; it has 0 3 1, 0 9 3, 0 0 0.",
        &drawing,
    )
}

fn draw_entry(drawing: Drawing, weights: &[f64], corner: Place, is_wrong: bool) -> Drawing {
    let size = 3.0 * CELL / 2.4;
    let [x, y] = corner;
    let frame = [
        [x, y],
        [x + size + 40.0, y],
        [x + size + 40.0, y + size + 14.0],
        [x, y + size + 14.0],
    ];
    let stroke = if is_wrong {
        Stroke::new(Colour::Vermilion, 3.4)
    } else {
        Stroke::new(Colour::Faint, 1.4)
    };
    let mut drawing = drawing.outline(&frame, stroke);
    for (index, weight) in weights.iter().enumerate() {
        let [row, column] = [index / 3, index % 3];
        let place = [
            x + 27.0 + 40.0 * column as f64,
            y + 30.0 + 33.0 * row as f64,
        ];
        let sixteenths = format!("{:.0}", 16.0 * weight);
        let colour = if *weight < 1e-9 {
            Colour::Faint
        } else {
            Colour::Ink
        };
        drawing = drawing.coloured_text(place, &sixteenths, TEXT, Anchor::Middle, colour);
    }
    drawing
}
