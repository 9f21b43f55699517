//! Figures of slabs.

use facette::algebra::VectorSpace;
use facette::intersection::BoundingBox;
use facette::ray::Ray;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Anchor, Drawing, Panel, Stroke, panels};

type Point = [f64; 3];

const SCALE: f64 = 34.0;

/// The place of a point in the upper half of a panel.
fn place([x, y, _]: Point) -> [f64; 2] {
    [22.0 + SCALE * x, 190.0 - SCALE * y]
}

/// The interval of the slab of one axis along the ray; the whole line where it is parallel to the slab and in it.
fn slab(bounds: &BoundingBox<Point>, ray: &Ray<Point>, axis: usize) -> Option<[f64; 2]> {
    let mut wide = [[-1e3; 3], [1e3; 3]];
    wide[0][axis] = bounds.min()[axis];
    wide[1][axis] = bounds.max()[axis];
    let slab = BoundingBox::new(wide[0], wide[1]).expect("corners in order");
    slab.span(ray).map(|span| [span.entry, span.exit])
}

/// A box in the plane as two bands, a ray, and the intervals of both bands and of the box over the axis of t.
fn panel(origin: Point, direction: Point, length: f64) -> Drawing {
    let bounds = BoundingBox::new([2.0, 1.6, -1.0], [4.4, 3.8, 1.0]).expect("corners in order");
    let ray = Ray::new(origin, direction);
    let [min, max] = [bounds.min(), bounds.max()];
    let at = |x: f64, y: f64| place([x, y, 0.0]);
    let band = |drawing: Drawing, [a, b]: [[f64; 2]; 2], colour| {
        let corners = [
            at(a[0], a[1]),
            at(b[0], a[1]),
            at(b[0], b[1]),
            at(a[0], b[1]),
        ];
        drawing.area(&corners, colour, 0.2)
    };
    let mut drawing = Drawing::new(240.0, 330.0);
    drawing = band(drawing, [[min[0], 0.0], [max[0], 5.4]], Colour::Blue);
    drawing = band(drawing, [[-0.4, min[1]], [6.2, max[1]]], Colour::Orange);
    let corners = [
        at(min[0], min[1]),
        at(max[0], min[1]),
        at(max[0], max[1]),
        at(min[0], max[1]),
    ];
    drawing = drawing
        .outline(&corners, Stroke::new(Colour::Ink, 2.0))
        .arrow(
            place(origin),
            place(ray.point(length)),
            Stroke::new(Colour::Vermilion, 1.8),
        )
        .disc(place(origin), 3.5, Colour::Vermilion);
    // The axis of t, with a line for each slab and one for what they have in common.
    let along = |t: f64| 62.0 + 27.0 * t.clamp(-0.5, 6.1);
    let common = bounds.span(&ray).map(|span| [span.entry, span.exit]);
    let rows = [
        ("*x*", Colour::Blue, slab(&bounds, &ray, 0)),
        ("*y*", Colour::Orange, slab(&bounds, &ray, 1)),
        ("both", Colour::Green, common),
    ];
    for (index, (name, colour, interval)) in rows.into_iter().enumerate() {
        let y = 222.0 + 26.0 * index as f64;
        drawing = drawing.text([22.0, y + 5.0], name, 14.0, Anchor::Middle);
        let Some([entry, exit]) = interval else {
            drawing = drawing.text([150.0, y + 5.0], "empty", 14.0, Anchor::Middle);
            continue;
        };
        drawing = drawing.line(
            [along(entry), y],
            [along(exit), y],
            Stroke::new(colour, 6.0),
        );
        for t in [entry, exit] {
            let is_on_page = (-0.5..6.1).contains(&t);
            if is_on_page {
                drawing = drawing.disc(place(ray.point(t)), 4.0, colour);
            }
        }
    }
    drawing
        .arrow([46.0, 302.0], [238.0, 302.0], Stroke::new(Colour::Ink, 1.2))
        .line(
            [along(0.0), 297.0],
            [along(0.0), 307.0],
            Stroke::new(Colour::Ink, 1.2),
        )
        .text([along(0.0), 322.0], "0", 14.0, Anchor::Middle)
        .text([236.0, 322.0], "*t*", 15.0, Anchor::End)
}

/// A hit, a miss and a ray that is parallel to a slab.
pub fn slabs() -> Figure {
    let direction = [0.9, 0.55, 0.0];
    let drawing = panels(
        3,
        &[
            Panel::drawing("a hit", panel([0.2, 0.9, 0.0], direction, 6.2)),
            Panel::drawing(
                "a miss",
                panel([0.2, 2.6, 0.0], direction.plus([-0.25, 0.0, 0.0]), 4.7),
            ),
            Panel::drawing("parallel", panel([0.2, 2.6, 0.0], [0.9, 0.0, 0.0], 6.2)),
        ],
    );
    Figure::drawn(
        "slabs",
        "A box in the plane is what two bands have in common; in space there are three. Below, the intervals of $t$ in which the ray is in the band of $x$ (blue), in that of $y$ (orange), and in both (green). In both it is from the later entry to the earlier exit. Where the one band is left before the other is entered, \
         nothing is in common. A ray parallel to a band is in it for all $t$, or for none.",
        "Three panels, each with a rectangle where a vertical and a horizontal band cross, an arrow, and bars over an axis t below. Left, the bars of x and y overlap, and a third bar shows the overlap. In the middle they do not overlap, and the third row says empty. Right, the arrow runs horizontally inside the horizontal band: the bar of y covers the whole axis, and the third bar equals that of x.",
        &drawing,
    )
}
