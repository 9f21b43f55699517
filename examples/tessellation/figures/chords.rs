//! Figures of the chord error.

use facette::mesh::tessellate_uniformly;
use facette::tessellation::tessellate;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::svg::{Anchor, Dashes, Drawing, Stroke};

use super::meshes::{bump, measured_error};

/// A curve, its chord, and the largest distance between them.
pub fn chord_error() -> Figure {
    let at = |t: f64| [60.0 + 630.0 * t, 250.0 - 800.0 * t * (1.0 - t) + 60.0 * t];
    let curve: Vec<[f64; 2]> = (0..=80).map(|i| at(f64::from(i) / 80.0)).collect();
    let ink = Stroke::new(Colour::Ink, 1.5);
    let [start, end, middle] = [at(0.0), at(1.0), at(0.5)];
    let below = [middle[0], f64::midpoint(start[1], end[1])];
    let mut drawing = Drawing::new(750.0, 350.0)
        .polyline(&curve, Stroke::new(Colour::Blue, 3.0))
        .line(start, end, Stroke::new(Colour::Vermilion, 3.0))
        .arrow(below, middle, ink)
        .arrow(middle, below, ink);
    for i in [1, 2, 3, 5, 6, 7] {
        let t = f64::from(i) / 8.0;
        let on_chord = [60.0 + 630.0 * t, start[1] * (1.0 - t) + end[1] * t];
        drawing = drawing.line(
            on_chord,
            at(t),
            Stroke::new(Colour::Ink, 1.0).dashes(Dashes::Dotted),
        );
    }
    let drawing = drawing
        .disc(start, 5.0, Colour::Ink)
        .disc(end, 5.0, Colour::Ink)
        .text(
            [start[0] - 8.0, start[1] + 28.0],
            "*C*(*a*)",
            19.0,
            Anchor::Middle,
        )
        .text(
            [end[0] - 4.0, end[1] + 30.0],
            "*C*(*a* + *ℓ*)",
            19.0,
            Anchor::Middle,
        )
        .haloed_text(
            [middle[0] + 10.0, 214.0],
            "at most *ℓ*^{2} *M* / 8",
            19.0,
            Anchor::Start,
        )
        .text([150.0, 100.0], "curve", 19.0, Anchor::Middle)
        .text([480.0, 308.0], "chord", 19.0, Anchor::Middle);
    Figure::drawn(
        "chord_error",
        "A piece of a curve over an interval of length $\\ell$ and its chord, points at the same parameter joined. When $|C''|\\le M$, none of these distances exceeds $\\ell^2M/8$; a parabola, as here, \
         attains it in the middle. Half the interval leaves a quarter of the distance.",
        "An arch over a straight segment with the same ends. Dashed lines join points of the segment with points of the arch; the longest, in the middle, is marked at most l squared M over 8.",
        &drawing,
    )
}

/// How the error falls with the number of triangles.
pub fn error_against_triangles() -> Figure {
    let surface = bump();
    let uniform: Vec<[f64; 2]> = [6, 9, 12, 18, 24, 36, 48, 72, 96, 144]
        .map(|cells| {
            let mesh = tessellate_uniformly(&surface, cells, cells)
                .expect("the figure's surface is finite");
            [mesh.face_count() as f64, measured_error(&surface, &mesh)]
        })
        .to_vec();
    let mut adaptive = Vec::new();
    let mut promised = Vec::new();
    for halvings in 0..10 {
        let tolerance = 0.25 / f64::from(1 << halvings);
        let mesh = tessellate(&surface, tolerance)
            .expect("the figure's tolerance is usable")
            .mesh;
        let count = mesh.face_count() as f64;
        adaptive.push([count, measured_error(&surface, &mesh)]);
        promised.push([count, tolerance]);
    }
    let plot = Plot::new("", "triangles", "largest distance")
        .log_x()
        .log_y()
        .line("uniform, measured", &uniform)
        .line("adaptive, measured", &adaptive)
        .line("adaptive, promised", &promised)
        .to_drawing()
        .expect("positive distances make a plot");
    Figure::drawn(
        "error_against_triangles",
        "The largest distance between the bump and its triangles, measured at fifteen points of each. All lines fall by a decade when the triangles grow tenfold. For the same measured distance adaptive triangles are about four times fewer; for a tolerance kept by promise, about two and a half; \
         what was promised, the tolerance, lies above what is measured, since the bound takes the worst of each piece.",
        "Three falling straight lines over the number of triangles on logarithmic axes. The measured adaptive one is lowest, the promised one a little above it, the uniform one highest.",
        &plot,
    )
}
