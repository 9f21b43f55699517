//! Figures of what projections do: fields of view, vanishing points, rectangles off the centre.

use std::f64::consts::PI;

use facette::camera::{Camera, ImageRectangle, half_extent, project_perspective};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::stage::{Stage, at, box_edges, looking};

fn ink(width: f64) -> Stroke {
    Stroke::new(Colour::Ink, width)
}

/// A border around a drawing.
fn framed(drawing: Drawing) -> Drawing {
    let [right, below] = drawing.size().map(|side| side - 1.0);
    let border = [[1.0, 1.0], [right, 1.0], [right, below], [1.0, below]];
    drawing.outline(&border, Stroke::new(Colour::Blue, 2.0))
}

/// The triangle of the half angle, and one scene under three fields of view.
pub fn field_of_view() -> Figure {
    let of = |degrees: f64| {
        let frame = looking(at(1.6, 4.4, 1.9), at(-0.1, 0.6, 0.75));
        let camera = Camera::with_field_of_view(frame, degrees.to_radians(), 4.0 / 3.0);
        let mut stage = Stage::new(camera.expect("an angle"), 360, 270);
        for (x, y) in [(-1.4, 0.6), (0.2, -0.4), (1.2, 1.6)] {
            let low = at(x, y, 0.0);
            for [from, to] in box_edges(low, low + at(0.8, 0.8, 1.3)) {
                stage = stage.line(&[from, to], ink(1.8));
            }
        }
        Panel::drawing(&format!("*θ* = {degrees}°"), framed(stage.drawing))
    };
    let drawing = panels(
        2,
        &[
            Panel::drawing("*h* = *D* tan(*θ*/2)", triangle()),
            of(30.0),
            of(60.0),
            of(90.0),
        ],
    );
    Figure::drawn(
        "field_of_view",
        "Half the height of the image rectangle is the distance times the tangent of *half* the field of view. An image plane that is farther away, with a rectangle that is higher in proportion (dashed), gives the same rays. \
         A larger angle takes in more of the scene, and everything becomes smaller.",
        "First drawing: an eye, an image plane at distance D and another behind it, and two rays that enclose the angle theta and meet the plane at heights h and minus h. \
         Three more drawings: the same three boxes with fields of view of 30, 60 and 90 degrees, ever smaller.",
        &drawing,
    )
}

fn triangle() -> Drawing {
    let (eye, distance, angle) = ([30.0, 135.0], 150.0, PI / 3.0);
    let half = half_extent(angle, distance);
    let mut drawing = Drawing::new(360.0, 270.0);
    let far = 1.35 * distance;
    for sign in [-1.0, 1.0] {
        let reach = [eye[0] + far, eye[1] + sign * half_extent(angle, far)];
        drawing = drawing.line(eye, reach, Stroke::new(Colour::Vermilion, 2.0));
    }
    let plane = |distance: f64, half: f64| {
        [-1.0, 1.0].map(|sign: f64| [eye[0] + distance, eye[1] + sign * half])
    };
    let [top, bottom] = plane(distance, half);
    let [far_top, far_bottom] = plane(far, half_extent(angle, far));
    let arc: Vec<_> = (-12..=12)
        .map(|step| f64::from(step) / 12.0 * angle / 2.0)
        .map(|angle| [eye[0] + 52.0 * angle.cos(), eye[1] + 52.0 * angle.sin()])
        .collect();
    let axis_end = [eye[0] + 1.75 * distance, eye[1]];
    let guides = Stroke::new(Colour::Faint, 1.4);
    drawing
        .line(
            far_top,
            far_bottom,
            Stroke::new(Colour::Blue, 1.6).dashes(Dashes::Dashed),
        )
        .line(top, bottom, Stroke::new(Colour::Blue, 3.0))
        .line(eye, axis_end, guides)
        .polyline(&arc, ink(1.6))
        .disc(eye, 5.0, Colour::Ink)
        .text([eye[0] + 60.0, eye[1] - 8.0], "*θ*/2", 16.0, Anchor::Start)
        .text([eye[0] + 60.0, eye[1] + 19.0], "*θ*/2", 16.0, Anchor::Start)
        .text([eye[0] + 125.0, eye[1] + 20.0], "*D*", 17.0, Anchor::Middle)
        .text([top[0] - 10.0, top[1] + 46.0], "*h*", 17.0, Anchor::End)
        .text(
            [bottom[0] - 10.0, bottom[1] - 36.0],
            "*h*",
            17.0,
            Anchor::End,
        )
        .text([eye[0] - 8.0, eye[1] + 26.0], "**e**", 17.0, Anchor::Middle)
}

/// A street whose edges meet at one point, and a box turned so that two families do.
pub fn vanishing_points() -> Figure {
    let drawing = panels(
        2,
        &[
            Panel::drawing("one vanishing point", street()),
            Panel::drawing("two of them, on the horizon", corner()),
        ],
    );
    Figure::drawn(
        "vanishing_points",
        "Parallel lines of the scene meet at the image of their direction. Left: the edges of a street all run towards one point; its cross-bars are parallel to the image plane and stay parallel; they stand at equal distances, \
         but their images crowd together. Right: two families of horizontal lines have two vanishing points, both on the horizon; the verticals stay parallel, since the camera is level.",
        "Two drawings. On the left a street with equidistant cross-bars that narrows towards a point on the horizon. On the right the corner of a building: its horizontal edges are prolonged to the left and to the right, and meet in two points \
         on the horizon.",
        &drawing,
    )
}

fn street() -> Drawing {
    let frame = looking(at(0.0, 0.0, 1.6), at(0.0, -1.0, 1.6));
    let camera = Camera::with_field_of_view(frame, 1.0, 4.0 / 3.0).expect("an angle");
    let mut stage = Stage::new(camera, 400, 300);
    let far = 400.0;
    for (x, z) in [
        (-1.2, 0.0),
        (1.2, 0.0),
        (-1.8, 3.0),
        (1.8, 3.0),
        (-1.8, 0.0),
        (1.8, 0.0),
    ] {
        let line = [at(x, -3.2, z), at(x, -far, z)];
        stage = stage.line(&line, ink(1.8));
    }
    for bar in 0..40 {
        let y = -3.4 - f64::from(bar);
        stage = stage.line(&[at(-1.2, y, 0.0), at(1.2, y, 0.0)], ink(1.4));
        if bar % 4 == 0 {
            for x in [-1.8, 1.8] {
                stage = stage.line(&[at(x, y, 0.0), at(x, y, 3.0)], ink(1.4));
            }
        }
    }
    let vanishing = stage.place(at(0.0, -1e9, 1.6));
    let horizon = Stroke::new(Colour::Faint, 1.4).dashes(Dashes::Dashed);
    let drawing = stage.drawing;
    framed(
        drawing
            .line([0.0, vanishing[1]], [400.0, vanishing[1]], horizon)
            .disc(vanishing, 6.0, Colour::Vermilion),
    )
}

fn corner() -> Drawing {
    let frame = looking(at(0.0, 5.0, 1.4), at(0.0, 0.0, 1.4));
    let camera = Camera::with_field_of_view(frame, 1.43, 4.0 / 3.0).expect("an angle");
    let mut stage = Stage::new(camera, 400, 300);
    let turn = PI / 4.0 + 0.01;
    let [along, across] = [
        at(-turn.cos(), -turn.sin(), 0.0),
        at(turn.sin(), -turn.cos(), 0.0),
    ];
    let edge = at(-0.1, 2.3, 0.0);
    for (direction, length, colour) in [(along, 1.9, Colour::Green), (across, 2.3, Colour::Purple)]
    {
        for z in [0.35, 0.9, 1.7, 2.25] {
            let foot = edge + at(0.0, 0.0, z);
            let end = foot + direction * length;
            let beyond = foot + direction * 1e9;
            let thin = Stroke::new(colour, 1.0).dashes(Dashes::Dotted);
            stage = stage
                .line(&[end, beyond], thin)
                .line(&[foot, end], Stroke::new(colour, 2.4));
        }
        let side = edge + direction * length;
        stage = stage.line(
            &[side + at(0.0, 0.0, 0.35), side + at(0.0, 0.0, 2.25)],
            ink(2.0),
        );
    }
    stage = stage.line(
        &[edge + at(0.0, 0.0, 0.35), edge + at(0.0, 0.0, 2.25)],
        ink(2.6),
    );
    let [left, right] = [along, across].map(|direction| stage.place(frame.eye() + direction));
    let horizon = Stroke::new(Colour::Faint, 1.4).dashes(Dashes::Dashed);
    let drawing = stage
        .drawing
        .line([0.0, left[1]], [400.0, right[1]], horizon);
    framed(
        drawing
            .disc(left, 6.0, Colour::Vermilion)
            .disc(right, 6.0, Colour::Vermilion),
    )
}

/// A tower: seen level, with the camera tilted, and with the rectangle shifted.
pub fn shifted_rectangle() -> Figure {
    let eye = at(1.0, 4.5, 1.0);
    let level = looking(eye, at(0.5, 0.0, 1.0));
    let tilted = looking(eye, at(0.5, 0.0, 2.3));
    let centred = ImageRectangle::new(-0.6, 0.6, -0.6, 0.6).expect("an extent");
    let shifted = ImageRectangle::new(-0.6, 0.6, -0.3, 0.9).expect("an extent");
    let of = |frame, rectangle| {
        let camera = Camera::perspective(frame, rectangle, 1.0).expect("a distance");
        let mut stage = Stage::new(camera, 300, 300);
        for [from, to] in tower() {
            if project_perspective(&frame, 1.0, from).is_some() {
                stage = stage.line(&[from, to], ink(1.8));
            }
        }
        framed(clipped(&stage.drawing))
    };
    let drawing = panels(
        3,
        &[
            Panel::drawing("level", of(level, centred)),
            Panel::drawing("tilted upwards", of(tilted, centred)),
            Panel::drawing("level, rectangle shifted", of(level, shifted)),
        ],
    );
    Figure::drawn(
        "shifted_rectangle",
        "Three pictures of a tower from the same place. A level camera cuts its top off. Tilted upwards it sees the top, but the verticals converge, since they are no longer parallel to the image plane. A level camera with the rectangle \
         shifted upwards, $b=-0.3$ and $t=0.9$ instead of $\\mp0.6$, sees the whole tower with parallel verticals: what architects' cameras do.",
        "Three drawings of a tower. In the first its top is cut off. In the second it is whole, but narrows upwards. In the third it is whole, and its sides are parallel.",
        &drawing,
    )
}

fn tower() -> Vec<[DVec3; 2]> {
    let mut edges = box_edges(at(-0.7, -0.9, 0.0), at(0.7, 0.5, 3.9));
    for floor in 1..6 {
        let z = 0.65 * f64::from(floor);
        edges.push([at(-0.7, 0.5, z), at(0.7, 0.5, z)]);
        edges.push([at(0.7, 0.5, z), at(0.7, -0.9, z)]);
    }
    edges
}

/// The drawing cut off at its own borders.
fn clipped(drawing: &Drawing) -> Drawing {
    let [width, height] = drawing.size();
    Drawing::new(width, height).drawing([0.0, 0.0], [width, height], drawing)
}
