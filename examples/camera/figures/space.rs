//! Figures of cameras in space: the frame, the image rectangle, the two kinds of rays.

use facette::camera::{Camera, CameraFrame, ImageRectangle};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Dashes, Drawing, Panel, Stroke, panels};
use glam::DVec3;

use super::stage::{Stage, at, box_edges, looking};

fn ink(width: f64) -> Stroke {
    Stroke::new(Colour::Ink, width)
}

fn faint(width: f64) -> Stroke {
    Stroke::new(Colour::Faint, width)
}

fn thick(colour: Colour) -> Stroke {
    Stroke::new(colour, 3.0)
}

/// The corners of a rectangle at a depth in front of a frame.
fn corners(frame: &CameraFrame<DVec3>, rectangle: &ImageRectangle<f64>, depth: f64) -> [DVec3; 4] {
    let [l, r] = [rectangle.left(), rectangle.right()];
    let [b, t] = [rectangle.bottom(), rectangle.top()];
    [[l, b], [r, b], [r, t], [l, t]].map(|[u, v]| frame.point([u, v, -depth]))
}

/// The eye, its three axes, the image rectangle and one ray.
#[allow(
    clippy::too_many_lines,
    reason = "most of them list the labels and their places"
)]
pub fn frame_and_rectangle() -> Figure {
    let view = looking(at(-11.0, 9.5, 6.5), at(0.0, 1.75, 0.85));
    let frame = looking(at(0.0, 4.2, 1.2), at(0.0, 0.0, 0.6));
    let rectangle = ImageRectangle::new(-1.5, 1.1, -0.8, 1.1).expect("an extent");
    let [distance, eye, target] = [2.6, 0.0, 4.25];
    let [u, v] = [0.65, 0.55];
    let local = |u: f64, v: f64, w: f64| frame.point([u, v, w]);
    let mut stage = Stage::parallel(view, 3.7, [750, 440]);
    let plane = corners(&frame, &rectangle, distance);
    stage = stage.area(&plane, thick(Colour::Sky), 0.15);
    for part in 1..8 {
        let [across, up] = [
            rectangle.left() + rectangle.width() * f64::from(part) / 8.0,
            rectangle.bottom() + rectangle.height() * f64::from(part) / 8.0,
        ];
        let [low, high] =
            [rectangle.bottom(), rectangle.top()].map(|v| local(across, v, -distance));
        let [left, right] = [rectangle.left(), rectangle.right()].map(|u| local(u, up, -distance));
        stage = stage
            .line(&[low, high], faint(0.8))
            .line(&[left, right], faint(0.8));
    }
    let dashed = faint(1.6).dashes(Dashes::Dashed);
    let (e, s) = (local(0.0, 0.0, eye), local(u, v, -distance));
    stage = stage
        .outline(&plane, ink(2.0))
        .line(&[e, local(0.0, 0.0, -target)], dashed)
        .arrow(e, local(u * 1.7, v * 1.7, -distance * 1.7), ink(2.4))
        .disc(s, 5.0, ink(1.0))
        .disc(local(0.0, 0.0, -distance), 3.5, faint(1.0))
        .disc(local(0.0, 0.0, -target), 5.0, thick(Colour::Purple))
        .arrow(e, e + at(0.0, 0.0, 1.25), faint(2.2));
    for (end, colour) in [
        (local(1.0, 0.0, 0.0), Colour::Vermilion),
        (local(0.0, 1.0, 0.0), Colour::Green),
        (local(0.0, 0.0, 1.0), Colour::Blue),
    ] {
        stage = stage.arrow(e, end, thick(colour));
    }
    stage = stage.disc(e, 6.0, ink(1.0));
    let middle = [rectangle.left(), rectangle.right()].iter().sum::<f64>() / 2.0;
    let level = [rectangle.bottom(), rectangle.top()].iter().sum::<f64>() / 2.0;
    for (point, moved, text, stroke) in [
        (e, [2.0, 27.0], "**e**", ink(1.0)),
        (
            local(1.0, 0.0, 0.0),
            [16.0, 14.0],
            "**u**",
            thick(Colour::Vermilion),
        ),
        (
            local(0.0, 1.0, 0.0),
            [14.0, 2.0],
            "**v**",
            thick(Colour::Green),
        ),
        (
            local(0.0, 0.0, 1.0),
            [2.0, 24.0],
            "**w**",
            thick(Colour::Blue),
        ),
        (e + at(0.0, 0.0, 1.25), [-3.0, -9.0], "up", faint(1.0)),
        (s, [4.0, -13.0], "**s**", ink(1.0)),
        (
            local(0.0, 0.0, -target),
            [0.0, 27.0],
            "target",
            thick(Colour::Purple),
        ),
        (
            local(rectangle.left(), level, -distance),
            [-36.0, 6.0],
            "*u* = *l*",
            ink(1.0),
        ),
        (
            local(rectangle.right(), level, -distance),
            [36.0, 16.0],
            "*u* = *r*",
            ink(1.0),
        ),
        (
            local(middle, rectangle.bottom(), -distance),
            [-26.0, 24.0],
            "*v* = *b*",
            ink(1.0),
        ),
        (
            local(middle, rectangle.top(), -distance),
            [20.0, -9.0],
            "*v* = *t*",
            ink(1.0),
        ),
        (
            local(0.0, 0.0, -distance * 0.45),
            [8.0, 22.0],
            "*D*",
            ink(1.0),
        ),
    ] {
        stage = stage.label(point, moved, text, stroke);
    }
    Figure::drawn(
        "frame_and_rectangle",
        "The frame of a camera and its image rectangle. $\\mathbf w$ points *backwards*, away from the target; the rectangle lies at the distance $D$ in front of the eye $\\mathbf e$, \
         and need not be centred. A perspective ray leads from $\\mathbf e$ through a place $\\mathbf s$ of the rectangle. Up (grey) is not $\\mathbf v$: it only says which way $\\mathbf v$ leans.",
        "In space, an eye with three perpendicular arrows u, v and w. In front of it a rectangle divided into pixels, with the borders l, r, b and t; \
         behind it, the target. An arrow leads from the eye through a point s of the rectangle.",
        &stage.drawing,
    )
}

/// Two boxes of the same size, one behind the other.
fn boxes() -> [Vec<[DVec3; 2]>; 2] {
    let size = at(0.9, 0.9, 1.3);
    let [near, far] = [at(-1.1, 0.0, 0.0), at(0.4, -3.2, 0.0)];
    [box_edges(near, near + size), box_edges(far, far + size)]
}

/// The same two boxes, seen from outside with their rays, and as their images.
pub fn two_projections() -> Figure {
    let frame = looking(at(0.2, 4.0, 1.75), at(0.1, -1.2, 0.6));
    let wide = ImageRectangle::new(-1.95, 1.95, -1.29, 1.29).expect("an extent");
    let near = ImageRectangle::new(-0.85, 0.85, -0.563, 0.563).expect("an extent");
    let [flat, deep] = [
        Camera::orthographic(frame, wide),
        Camera::perspective(frame, near, 1.6).expect("a distance"),
    ];
    let of = |camera, rectangle, depth| outside(&camera, &rectangle, depth);
    let drawing = panels(
        2,
        &[
            Panel::drawing("orthographic: rays in parallel", of(flat, wide, 0.0)),
            Panel::drawing("perspective: rays from the eye", of(deep, near, 1.6)),
            Panel::drawing("boxes of the same size stay so", image(flat)),
            Panel::drawing("the far box is smaller", image(deep)),
        ],
    );
    Figure::drawn(
        "two_projections",
        "Two boxes of the same size, the farther one purple, under both projections. Orthographic rays begin on the image plane and run in parallel: both boxes have the same image but for its place. \
         Perspective rays begin at the eye and spread: the far box is smaller.",
        "Four drawings. Above, two boxes in space and an image rectangle with four rays through its corners: parallel on the left, spreading from an eye on the right. \
         Below, the two images: on the left both boxes have the same size, on the right the far one is smaller.",
        &drawing,
    )
}

const PANEL: [u32; 2] = [400, 290];

/// Of the near box and of the far one.
const BOX_COLOURS: [Colour; 2] = [Colour::Ink, Colour::Purple];

/// A camera seen from outside: its rectangle, the rays through its corners, and the boxes.
fn outside(camera: &Camera<DVec3>, rectangle: &ImageRectangle<f64>, depth: f64) -> Drawing {
    let view = looking(at(9.0, 4.0, 4.2), at(0.0, 0.3, 0.75));
    let mut stage = Stage::parallel(view, 6.6, PANEL);
    let frame = camera.frame();
    let plane = corners(frame, rectangle, depth);
    for (edges, colour) in boxes().into_iter().zip(BOX_COLOURS) {
        for [from, to] in edges {
            stage = stage.line(&[from, to], Stroke::new(colour, 1.6));
        }
    }
    let [l, r] = [rectangle.left(), rectangle.right()];
    let [b, t] = [rectangle.bottom(), rectangle.top()];
    for place in [[l, b], [r, b], [r, t], [l, t]] {
        let ray = camera.ray(place);
        let reach = 5.4 / -ray.direction.dot(frame.axes()[2]);
        let ray_stroke = Stroke::new(Colour::Vermilion, 1.4);
        stage = stage.arrow(ray.origin, ray.point(reach), ray_stroke);
    }
    stage = stage
        .area(&plane, thick(Colour::Sky), 0.3)
        .outline(&plane, Stroke::new(Colour::Blue, 2.2));
    let eye = frame.eye();
    stage
        .disc(eye, 5.0, ink(1.0))
        .label(eye, [12.0, -6.0], "**e**", ink(1.0))
        .drawing
}

/// What a camera sees of the boxes.
fn image(camera: Camera<DVec3>) -> Drawing {
    let [width, height] = [PANEL[0], 265];
    let mut stage = Stage::new(camera, width, height);
    for (edges, colour) in boxes().into_iter().zip(BOX_COLOURS) {
        for [from, to] in edges {
            stage = stage.line(&[from, to], Stroke::new(colour, 2.0));
        }
    }
    let [right, below] = [f64::from(width), f64::from(height)].map(|side| side - 1.0);
    let border = [[1.0, 1.0], [right, 1.0], [right, below], [1.0, below]];
    stage
        .drawing
        .outline(&border, Stroke::new(Colour::Blue, 2.2))
}
