//! The figure of the pixel grid.

use facette::camera::{ImageRectangle, ImageSize, Pixel, pixel_centre, pixel_sample};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Anchor, Drawing, Stroke};

const SCALE: f64 = 92.0;
const ORIGIN: [f64; 2] = [140.0, 320.0];

/// Where a place (u, v) of the grid is drawn.
fn place([u, v]: [f64; 2]) -> [f64; 2] {
    [ORIGIN[0] + SCALE * (u + 1.5), ORIGIN[1] - SCALE * (v + 1.0)]
}

/// Pixels, their centres, and the two ways to count rows.
pub fn pixel_grid() -> Figure {
    let rectangle = ImageRectangle::new(-1.5, 3.5, -1.0, 2.0).expect("an extent");
    let size = ImageSize::new(5, 3).expect("pixels");
    let at = |column, row, within| {
        place(pixel_sample(
            &rectangle,
            size,
            Pixel { column, row },
            within,
        ))
    };
    let chosen = Pixel { column: 3, row: 1 };
    let mut drawing = Drawing::new(750.0, 400.0);
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let of_chosen = corners.map(|within| at(chosen.column, chosen.row, within));
    drawing = drawing.area(&of_chosen, Colour::Sky, 0.35);
    for column in 0..=5 {
        let ends = [at(column, 0, [0.0; 2]), at(column, 2, [0.0, 1.0])];
        drawing = drawing.line(ends[0], ends[1], Stroke::new(Colour::Faint, 1.2));
    }
    for row in 0..=3 {
        let ends = [at(0, row, [0.0; 2]), at(4, row, [1.0, 0.0])];
        drawing = drawing.line(ends[0], ends[1], Stroke::new(Colour::Faint, 1.2));
    }
    let border = [
        at(0, 0, [0., 0.]),
        at(4, 0, [1., 0.]),
        at(4, 2, [1., 1.]),
        at(0, 2, [0., 1.]),
    ];
    drawing = drawing.outline(&border, Stroke::new(Colour::Ink, 2.2));
    for pixel in size.pixels_in_file_order() {
        let centre = place(pixel_centre(&rectangle, size, pixel));
        drawing = drawing.disc(centre, 4.0, Colour::Vermilion);
    }
    drawing = axes_and_numbers(drawing, size);
    let [x, y] = place(pixel_centre(&rectangle, size, chosen));
    drawing = drawing
        .text([x, y - 12.0], "*i* = 3, *j* = 1", 15.0, Anchor::Middle)
        .text([x, y + 25.0], "(*u*, *v*)", 15.0, Anchor::Middle);
    let samples = [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]];
    for within in samples {
        drawing = drawing.circle(at(1, 0, within), 4.0, Stroke::new(Colour::Green, 2.0));
    }
    Figure::drawn(
        "pixel_grid",
        "An image of $5\\times3$ pixels on the rectangle from $l=-1.5$ to $r=3.5$ and from $b=-1$ to $t=2$. The centres (orange) are half a pixel inside the borders. The formula counts rows \
         from the bottom (left), an image file from the top (right). Four sub-pixel samples are marked in the pixel $i=1$, $j=0$ (green rings).",
        "A rectangle of five columns and three rows of pixels with a point in the middle of each. On the left the rows are numbered 0, 1, 2 from the bottom, on the right 0, 1, 2 from the top. \
         The borders are named l, r, b and t; one pixel has four rings inside.",
        &drawing,
    )
}

fn axes_and_numbers(mut drawing: Drawing, size: ImageSize) -> Drawing {
    let text =
        |drawing: Drawing, at: [f64; 2], words: &str, anchor| drawing.text(at, words, 16.0, anchor);
    for column in 0..size.columns() {
        let [x, y] = place([-1.0 + f64::from(column), -1.0]);
        drawing = text(drawing, [x, y + 22.0], &format!("{column}"), Anchor::Middle);
    }
    for row in 0..size.rows() {
        let v = -0.5 + f64::from(row);
        let ([left, y], [right, _]) = (place([-1.5, v]), place([3.5, v]));
        let from_top = size.rows() - 1 - row;
        drawing = text(
            drawing,
            [left - 14.0, y + 6.0],
            &format!("{row}"),
            Anchor::End,
        );
        drawing = text(
            drawing,
            [right + 14.0, y + 6.0],
            &format!("{from_top}"),
            Anchor::Start,
        );
    }
    let ([left, low], [right, high]) = (place([-1.5, -1.0]), place([3.5, 2.0]));
    let along = Stroke::new(Colour::Blue, 2.0);
    drawing = drawing
        .arrow([left, low + 36.0], [left + 90.0, low + 36.0], along)
        .arrow([left - 44.0, low], [left - 44.0, low - 90.0], along)
        .arrow(
            [right + 50.0, high],
            [right + 50.0, high + 90.0],
            Stroke::new(Colour::Purple, 2.0),
        );
    let name = |drawing: Drawing, at: [f64; 2], words: &str, anchor, colour| {
        drawing.coloured_text(at, words, 15.0, anchor, colour)
    };
    drawing = name(
        drawing,
        [left + 98.0, low + 41.0],
        "column *i*",
        Anchor::Start,
        Colour::Blue,
    );
    drawing = name(
        drawing,
        [left - 52.0, low - 100.0],
        "row *j*",
        Anchor::Middle,
        Colour::Blue,
    );
    drawing = name(
        drawing,
        [right + 66.0, high + 110.0],
        "row of",
        Anchor::Middle,
        Colour::Purple,
    );
    drawing = name(
        drawing,
        [right + 66.0, high + 128.0],
        "the file",
        Anchor::Middle,
        Colour::Purple,
    );
    for (at, words, anchor) in [
        ([left, high - 10.0], "*u* = *l*", Anchor::Middle),
        ([right, high - 10.0], "*u* = *r*", Anchor::Middle),
        ([left - 8.0, low + 18.0], "*v* = *b*", Anchor::End),
        ([left - 8.0, high + 18.0], "*v* = *t*", Anchor::End),
    ] {
        drawing = text(drawing, at, words, anchor);
    }
    drawing
}
