//! The figure of a patch: its ring of ghosts, and the numbers of its points.

use facette::mesh::Mesh;
use facette::subdivision::{Connectivity, Corners, Refinement};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};

const SIZE: f64 = 400.0;
const SPACING: f64 = 58.0;
const TEXT: f64 = 16.0;

/// The place of a point of a grid, row 0 below.
fn place(row: f64, column: f64) -> [f64; 2] {
    let margin = 84.0;
    [margin + SPACING * column, SIZE - margin - SPACING * row]
}

/// A patch of side 4 and the ring around it.
fn ghosts() -> Drawing {
    let mut drawing = Drawing::new(SIZE, SIZE);
    let corners = [[0., 0.], [0., 4.], [4., 4.], [4., 0.]];
    let square = corners.map(|[row, column]| place(row, column));
    drawing = drawing.area(&square, Colour::Blue, 0.15);
    for line in -1..=5_i32 {
        let t = f64::from(line);
        let is_inside = (0..=4).contains(&line);
        let stroke = if is_inside {
            Stroke::new(Colour::Ink, 1.5)
        } else {
            Stroke::new(Colour::Faint, 1.5).dashes(Dashes::Dashed)
        };
        drawing = drawing.line(place(t, -1.0), place(t, 5.0), stroke);
        drawing = drawing.line(place(-1.0, t), place(5.0, t), stroke);
    }
    for row in -1..=5_i32 {
        for column in -1..=5_i32 {
            let at = place(row.into(), column.into());
            let is_patch = (0..=4).contains(&row) && (0..=4).contains(&column);
            drawing = if is_patch {
                drawing.disc(at, 5.0, Colour::Ink)
            } else {
                drawing.circle(at, 5.0, Stroke::new(Colour::Vermilion, 2.0))
            };
        }
    }
    drawing
}

/// The numbers that the library gives to the points of one patch of a pair.
fn numbers() -> Drawing {
    let points = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [2., 0.], [2., 1.]];
    let pair = Mesh::new(points.to_vec(), [[0, 1, 2, 3], [1, 4, 5, 2]]).expect("two squares");
    let connectivity = Connectivity::new(&pair).expect("a manifold");
    let plan = Refinement::catmull_clark(&connectivity, 2, Corners::Sharp).expect("a small mesh");
    let mut drawing = Drawing::new(SIZE, SIZE);
    for t in 0..=4_u8 {
        let t = f64::from(t);
        let stroke = Stroke::new(Colour::Faint, 1.5);
        drawing = drawing.line(place(t, 0.0), place(t, 4.0), stroke);
        drawing = drawing.line(place(0.0, t), place(4.0, t), stroke);
    }
    for row in 0..=4_u32 {
        for column in 0..=4_u32 {
            let on_side = [row, column].map(|t| t % 4 == 0);
            let (colour, radius) = match on_side {
                [true, true] => (Colour::Ink, 6.0),
                [false, false] => (Colour::Blue, 5.0),
                _ => (Colour::Vermilion, 5.0),
            };
            let at = place(row.into(), column.into());
            let number = plan.vertex(0, row, column).to_string();
            drawing = drawing.disc(at, radius, colour);
            drawing = drawing.haloed_text([at[0] + 7.0, at[1] - 8.0], &number, TEXT, Anchor::Start);
        }
    }
    drawing
}

/// A patch with its ring, and its numbers.
pub fn patch_of_points() -> Figure {
    let both = [
        Panel::drawing("a patch and its ring of ghosts", ghosts()),
        Panel::drawing("the numbers of its points", numbers()),
    ];
    Figure::drawn(
        "patch_of_points",
        "A patch of Catmull-Clark after two levels. Left: its 25 points, and around them the ring of points that belong to its neighbours. Right: the numbers, where the mesh is two squares and this is the first. First come the vertices of the mesh (0 to 3 here), then the insides of the edges, edge by edge (6 to 17 here), then the inside of the patch, row by row.",
        "Two panels. Left, a grid of five by five black points on a shaded square, surrounded by a ring of 24 hollow points joined by dashed lines. Right, the same five by five points with numbers: the four corners 0 to 3, three numbers on each side that follow each other, and nine consecutive numbers inside, row by row.",
        &panels(2, &both),
    )
}
