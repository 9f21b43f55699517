//! Figures of spheres, and of the nearest of many surfaces.

use facette::algebra::VectorSpace;
use facette::intersection::{
    BoundingBox, Group, Intersect, Plane, Sphere, roots_by_projection, roots_by_quadratic,
};
use facette::ray::Ray;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};

type Point = [f64; 3];

/// A part of the plane z = 0, drawn: so many units of the drawing for one of length, and where the origin lies.
struct Sheet {
    scale: f64,
    origin: [f64; 2],
}

impl Sheet {
    fn place(&self, point: Point) -> [f64; 2] {
        let [x, y, _] = point;
        [
            self.origin[0] + self.scale * x,
            self.origin[1] - self.scale * y,
        ]
    }
}

/// A line past the unit circle at the height h, and below it, on the same abscissa, the function whose roots are looked for.
fn circle_and_parabola(height: f64) -> Drawing {
    let sphere = Sphere::new([3.0, 0.0, 0.0], 1.0).expect("a positive radius");
    let ray = Ray::new([0.0, height, 0.0], [1.0, 0.0, 0.0]);
    let above = Sheet {
        scale: 44.0,
        origin: [16.0, 96.0],
    };
    let axis = Sheet {
        scale: 44.0,
        origin: [16.0, 268.0],
    };
    let thin = Stroke::new(Colour::Ink, 1.2);
    let mut drawing = Drawing::new(240.0, 330.0)
        .circle(
            above.place(sphere.centre()),
            above.scale,
            Stroke::new(Colour::Blue, 2.2),
        )
        .disc(above.place(sphere.centre()), 2.5, Colour::Blue)
        .arrow(
            above.place(ray.origin),
            above.place(ray.point(4.9)),
            Stroke::new(Colour::Vermilion, 1.8),
        )
        .disc(above.place(ray.origin), 3.5, Colour::Vermilion)
        .text(
            [
                above.place(ray.origin)[0] - 4.0,
                above.place(ray.origin)[1] + 18.0,
            ],
            "**o**",
            15.0,
            Anchor::Start,
        )
        .arrow(
            axis.place([-0.1, 0.0, 0.0]),
            axis.place([5.0, 0.0, 0.0]),
            thin,
        )
        .arrow(
            axis.place([0.0, -1.25, 0.0]),
            axis.place([0.0, 2.4, 0.0]),
            thin,
        )
        .text(axis.place([4.9, -0.42, 0.0]), "*t*", 15.0, Anchor::End)
        .text(
            axis.place([0.14, 2.1, 0.0]),
            "*f*(*t*)",
            15.0,
            Anchor::Start,
        );
    // f(t) is quadratic, so it is a Bézier curve of degree 2, here written as one of degree 3.
    let f = |t: f64| {
        let arm = ray.point(t).minus(sphere.centre());
        arm[0] * arm[0] + arm[1] * arm[1] - 1.0
    };
    let half_width = (2.3 + 1.0 - height * height).sqrt();
    let [start, end] = [3.0 - half_width, 3.0 + half_width];
    let samples: Vec<_> = (0..=60)
        .map(|index| start + (end - start) * f64::from(index) / 60.0)
        .map(|t| axis.place([t, f(t), 0.0]))
        .collect();
    drawing = drawing.polyline(&samples, Stroke::new(Colour::Green, 2.2));
    for t in sphere.chord(&ray).into_iter().flatten() {
        let [hit, root] = [above.place(ray.point(t)), axis.place([t, 0.0, 0.0])];
        drawing = drawing
            .line(
                hit,
                root,
                Stroke::new(Colour::Faint, 1.2).dashes(Dashes::Dashed),
            )
            .disc(hit, 4.0, Colour::Vermilion)
            .disc(root, 4.0, Colour::Green);
    }
    drawing
}

/// The chord of a sphere, the tangent, and the miss: as roots of a parabola.
pub fn quadratic() -> Figure {
    let drawing = panels(
        3,
        &[
            Panel::drawing("two roots", circle_and_parabola(0.6)),
            Panel::drawing("a double root", circle_and_parabola(1.0)),
            Panel::drawing("no root", circle_and_parabola(1.3)),
        ],
    );
    Figure::drawn(
        "quadratic",
        "A ray and a sphere, cut through. Below, on the same scale of $t$, the function $f(t)=\\lvert\\mathbf o+t\\,\\mathbf d-\\mathbf c\\rvert^2-r^2$ along the ray: a parabola, negative inside the sphere. Its roots are where the ray enters and leaves. The farther \
         from the centre the ray passes, the higher the parabola lies.",
        "Three panels. In each an arrow passes a circle, and a parabola stands below it over an axis t. Left, the arrow cuts the circle in two points, straight above the two roots. In the middle it touches the circle, and the parabola touches its axis. \
         Right it passes above the circle, and the parabola stays above the axis.",
        &drawing,
    )
}

/// The largest error of the near root among rays from so far away, in radii; none where a ray that hits is said to miss.
fn largest_error(distance: f64, roots: fn(Point32, Point32, f32) -> Option<[f32; 2]>) -> f64 {
    let part = |index: u32, factor: f64| (f64::from(index) * factor).fract() - 0.5;
    let error = |index: u32| {
        // A direction of length near 1 in general position, and a target at most 0.6 radii from the centre.
        let direction = [
            0.6 + 0.2 * part(index, 0.618),
            0.5 + 0.2 * part(index, 0.414),
            0.62,
        ];
        let target = [part(index, 0.732) * 0.6, part(index, 0.236) * 0.6, 0.0];
        #[allow(
            clippy::cast_possible_truncation,
            reason = "single precision is what is looked at"
        )]
        let [p, d] =
            [target.minus(direction.times(distance)), direction].map(|v| v.map(|x| x as f32));
        let [exact_p, exact_d] = [p, d].map(|vector| vector.map(f64::from));
        let truth = roots_by_projection(exact_p, exact_d, 1.0)?;
        let found = roots(p, d, 1.0).map_or(f64::INFINITY, |roots| f64::from(roots[0]));
        Some((found - truth[0]).abs().min(1.0))
    };
    (0..64).filter_map(error).fold(1e-8, f64::max)
}

type Point32 = [f32; 3];

/// What single precision leaves of a sphere, by distance.
pub fn lost_digits() -> Figure {
    let distances: Vec<f64> = (2..=28)
        .map(|quarter| 10.0_f64.powf(f64::from(quarter) / 4.0))
        .collect();
    let curve = |roots| -> Vec<[f64; 2]> {
        let errors = distances
            .iter()
            .map(|&distance| [distance, largest_error(distance, roots)]);
        errors.collect()
    };
    let plot = Plot::new("", "distance in radii", "largest error of t in radii")
        .log_x()
        .log_y()
        .height(330.0)
        .line("slides' quadratic", &curve(roots_by_quadratic))
        .line("by projection", &curve(roots_by_projection))
        .to_drawing()
        .expect("positive errors make a plot");
    Figure::drawn(
        "lost_digits",
        "The error of the near root in single precision, the largest of 64 rays from each distance; an error of 1, the whole sphere, includes rays that are said to miss. The quadratic loses two digits for each decade of distance, and at 4000 radii it knows nothing of the sphere any more. By projection \
         one digit is lost for each decade: that much lies in the coordinates of the origin themselves. In double precision the picture is the same, almost nine decades lower.",
        "Two rising lines over the distance on logarithmic axes. The line of the quadratic rises twice as steeply, and reaches an error of one radius between one thousand and ten thousand radii. The other stays far below it.",
        &plot,
    )
}

/// The surfaces of the figure on the nearest of many: a sphere, a box, a wall and another sphere.
fn many() -> Vec<(&'static str, Box<dyn Intersect<Point = Point>>)> {
    let sphere = |centre, radius| Sphere::new(centre, radius).expect("a positive radius");
    vec![
        (
            "0",
            Box::new(sphere([7.4, 1.2, 0.0], 0.9)) as Box<dyn Intersect<Point = Point>>,
        ),
        (
            "1",
            Box::new(Plane::new([9.2, 0.0, 0.0], [-1.0, 0.25, 0.0]).expect("a normal")),
        ),
        (
            "2",
            Box::new(
                BoundingBox::new([4.4, 0.2, -1.0], [5.8, 1.4, 1.0]).expect("corners in order"),
            ),
        ),
        ("3", Box::new(sphere([2.3, 2.35, 0.0], 0.7))),
    ]
}

/// A ray through several surfaces, and the slides' loop on its axis of t.
pub fn nearest_of_many() -> Figure {
    let ray = Ray::new([0.4, 0.5, 0.0], [1.0, 0.075, 0.0]);
    let sheet = Sheet {
        scale: 72.0,
        origin: [14.0, 240.0],
    };
    let at = |x: f64, y: f64| sheet.place([x, y, 0.0]);
    let outline = Stroke::new(Colour::Blue, 2.0);
    let mut drawing = Drawing::new(750.0, 372.0)
        .circle(at(7.4, 1.2), 0.9 * sheet.scale, outline)
        .line(at(9.2 + 0.25 * 3.1, 3.1), at(9.2 - 0.05, -0.2), outline)
        .outline(
            &[at(4.4, 0.2), at(5.8, 0.2), at(5.8, 1.4), at(4.4, 1.4)],
            outline,
        )
        .circle(at(2.3, 2.35), 0.7 * sheet.scale, outline)
        .arrow(
            sheet.place(ray.origin),
            sheet.place(ray.point(9.6)),
            Stroke::new(Colour::Vermilion, 1.8),
        )
        .disc(sheet.place(ray.origin), 3.5, Colour::Vermilion)
        .text(at(0.3, 0.2), "**o**", 15.0, Anchor::Start);
    for (name, place) in [
        ("0", at(7.4, 1.5)),
        ("1", at(9.62, 2.2)),
        ("2", at(5.1, 1.12)),
        ("3", at(2.3, 2.28)),
    ] {
        drawing = drawing.coloured_text(place, name, 16.0, Anchor::Middle, Colour::Blue);
    }
    let members = many();
    let mut shortened = ray;
    for (row, (name, surface)) in members.iter().enumerate() {
        let y = 276.0 + 24.0 * row as f64;
        let at_t = |t: f64| [sheet.place(ray.point(t))[0], y];
        let end = shortened.end.unwrap_or(8.9);
        let hit = surface.intersect(&shortened);
        drawing = drawing
            .line(at_t(0.0), at_t(end), Stroke::new(Colour::Vermilion, 1.6))
            .text([740.0, y + 5.0], &format!("asks {name}"), 14.0, Anchor::End);
        if let Some(hit) = hit {
            drawing = drawing.disc(at_t(hit.t), 4.5, Colour::Green).disc(
                sheet.place(hit.point),
                4.0,
                Colour::Green,
            );
            shortened = shortened.until(hit.t);
        }
    }
    let group = Group::new(members.into_iter().map(|(_, surface)| surface).collect());
    let nearest = group.intersect(&ray).expect("there are surfaces ahead");
    drawing = drawing.circle(
        sheet.place(nearest.point),
        9.0,
        Stroke::new(Colour::Green, 2.0),
    );
    Figure::drawn(
        "nearest_of_many",
        "The slides' loop over four surfaces, in the order of their numbers. Below, how far the ray reaches when each is asked: sphere 0 is hit (green) and shortens it; wall 1 lies beyond that, and is not hit any more; box 2 is nearer; sphere 3 is beside the ray. The ringed point is the answer.",
        "A ray to the right passes under a circle 3, through a box 2 and a circle 0 and a slanted wall 1. Below it four horizontal lines, one for each question. The first two are long, the first with a dot where circle 0 is hit, the second ends there. The third has a dot where the box begins, the fourth ends there. The point where the ray enters the box is ringed.",
        &drawing,
    )
}
