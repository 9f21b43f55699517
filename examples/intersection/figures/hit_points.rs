//! Figures of hit points: acne, leaks, and the box that a hit point lies in.

use facette::camera::{Camera, CameraFrame, ImageSize};
use facette::intersection::offset::{spawn_ray, spawn_ray_to};
use facette::intersection::{Group, Hit, Intersect, Plane, Sphere};
use facette::ray::Ray;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::render::Picture;
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};
use glam::DVec3;

type Surfaces = Group<Box<dyn Intersect<Point = DVec3>>>;

/// A ball of radius `unit` on a floor.
fn ball_on_a_floor(unit: f64) -> Surfaces {
    let ball = Sphere::new(DVec3::new(0.0, unit, 0.0), unit).expect("a positive radius");
    let floor = Plane::new(DVec3::ZERO, DVec3::Y).expect("a normal");
    Group::new(vec![Box::new(floor), Box::new(ball)])
}

/// A hit, the ray that made it, and the lamp.
struct Lit<'a> {
    scene: &'a Surfaces,
    arriving: Ray<DVec3>,
    hit: Hit<DVec3>,
    lamp: DVec3,
}

/// As ray tracers begin: from `o + t d`, and hits count from t > ε on.
fn in_shadow_by_epsilon(lit: &Lit, epsilon: f64) -> bool {
    let point = lit.arriving.point(lit.hit.t);
    let ray = Ray::new(point, (lit.lamp - point).normalize()).after(epsilon);
    lit.scene.is_hit_by(&ray.until(lit.lamp.distance(point)))
}

fn in_shadow_by_bound(lit: &Lit) -> bool {
    lit.scene.is_hit_by(&spawn_ray_to(&lit.hit, lit.lamp))
}

/// The ball and its shadow, in a scene of this size.
fn shadowed(scale: f64, in_shadow: impl Fn(&Lit) -> bool) -> Picture {
    let unit = scale / 4.0;
    let size = ImageSize::new(280, 210).expect("a picture has pixels");
    let eye = DVec3::new(0.5, 2.6, 6.0) * unit;
    let frame = CameraFrame::looking_at(eye, DVec3::new(0.4, 0.7, 0.0) * unit, DVec3::Y);
    let frame = frame.expect("the view is not vertical");
    let camera = Camera::with_field_of_view(frame, 0.55, size.aspect()).expect("a usable angle");
    let scene = ball_on_a_floor(unit);
    let lamp = DVec3::new(-4.0, 5.0, 3.0) * unit;
    let colours = [Colour::Faint, Colour::Sky].map(Colour::rgb);
    let mut rgba = Vec::new();
    for pixel in size.pixels_in_file_order() {
        let arriving = camera.pixel_ray(size, pixel);
        let Some((member, hit)) = scene.nearest(&arriving) else {
            rgba.extend([0; 4]);
            continue;
        };
        let scene = &scene;
        let is_dark = in_shadow(&Lit {
            scene,
            arriving,
            hit,
            lamp,
        });
        let facing = hit.normal.dot((lamp - hit.point).normalize()).max(0.0);
        let light = if is_dark { 0.25 } else { 0.25 + 0.75 * facing };
        // The square root is near enough to the screen's own curve.
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and 255"
        )]
        let shaded = colours[member].map(|c| (f64::from(c) * f64::sqrt(light)) as u8);
        rgba.extend(shaded);
        rgba.push(255);
    }
    Picture {
        width: size.columns(),
        height: size.rows(),
        rgba,
    }
}

/// Both failures of a fixed ε, and the bound.
pub fn acne_and_leaks() -> Figure {
    let drawing = panels(
        2,
        &[
            Panel::picture(
                "10^{7} units, *t* > 10^{−9}",
                shadowed(1e7, |lit| in_shadow_by_epsilon(lit, 1e-9)),
            ),
            Panel::picture(
                "10^{7} units, by the bound",
                shadowed(1e7, in_shadow_by_bound),
            ),
            Panel::picture(
                "10^{−3} units, *t* > 10^{−3}",
                shadowed(1e-3, |lit| in_shadow_by_epsilon(lit, 1e-3)),
            ),
            Panel::picture(
                "10^{−3} units, by the bound",
                shadowed(1e-3, in_shadow_by_bound),
            ),
        ],
    );
    Figure::drawn(
        "acne_and_leaks",
        "A ball on a floor, lit by a lamp at the upper left, in double precision. Left, a fixed $\\varepsilon$: in a scene of $10^7$ units $10^{-9}$ is less than a rounding, and lit points are shadowed by the surface that they lie on \
         (acne); in one of $10^{-3}$ units $10^{-3}$ jumps over the ball, and light leaks into its shadow. Right, shadow rays that begin where the error of their point ends.",
        "Four pictures of a ball on a floor. Upper left: the lit parts are speckled with dark points. Lower left: most of the shadow of the ball on the floor is missing. On the right both are clean, with a full shadow.",
        &drawing,
    )
}

/// From a point so far in a direction.
fn along(from: [f64; 2], direction: [f64; 2], length: f64) -> [f64; 2] {
    [
        from[0] + length * direction[0],
        from[1] + length * direction[1],
    ]
}

/// The computed point, the box around it, and where rays begin.
pub fn error_box() -> Figure {
    let (point, half) = ([300.0, 250.0], 60.0);
    let (normal, tangent) = ([-0.6, -0.8], [0.8, -0.6]);
    let reach = half * (0.6 + 0.8);
    // The true surface passes through the box, below the computed point.
    let on_surface = along(point, normal, -34.0);
    let [left, right] = [-300.0, 330.0].map(|length| along(on_surface, tangent, length));
    let origin = along(point, normal, 2.0 * reach);
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[x, y]| [point[0] + x * half, point[1] + y * half]);
    let mut drawing = Drawing::new(750.0, 430.0)
        .area(&corners, Colour::Sky, 0.25)
        .outline(&corners, Stroke::new(Colour::Sky, 1.5))
        .line(left, right, Stroke::new(Colour::Blue, 3.0));
    let dotted = Stroke::new(Colour::Ink, 1.0).dashes(Dashes::Dotted);
    for length in [reach, -reach] {
        let [from, to] =
            [-230.0, 230.0].map(|side| along(along(point, normal, length), tangent, side));
        drawing = drawing.line(from, to, dotted);
    }
    let [leaves, meets] = [
        along(origin, [0.95, -0.312], 240.0),
        along(point, [0.95, -0.312], 150.0),
    ];
    let [below, beside] = [
        [point[0], point[1] + half + 14.0],
        [point[0] + half, point[1] + half + 14.0],
    ];
    let drawing = drawing
        .arrow(point, origin, Stroke::new(Colour::Ink, 2.0))
        .arrow(origin, leaves, Stroke::new(Colour::Green, 3.0))
        .arrow(
            point,
            meets,
            Stroke::new(Colour::Vermilion, 2.0).dashes(Dashes::Dashed),
        )
        .line(below, beside, Stroke::new(Colour::Ink, 1.5))
        .text(
            [point[0] + half / 2.0, point[1] + half + 34.0],
            "*e*",
            18.0,
            Anchor::Middle,
        )
        .disc(point, 5.0, Colour::Ink)
        .disc(on_surface, 5.0, Colour::Blue)
        .disc(origin, 5.0, Colour::Green)
        .haloed_text(
            [point[0] - 14.0, point[1] + 6.0],
            "computed point",
            17.0,
            Anchor::End,
        )
        .haloed_text(
            [origin[0] - 14.0, origin[1] + 4.0],
            "origin",
            17.0,
            Anchor::End,
        )
        .haloed_text(
            [origin[0] + 64.0, origin[1] + 62.0],
            "2 *e* |*n*|_{1}",
            17.0,
            Anchor::Start,
        )
        .haloed_text(
            [right[0] - 20.0, right[1] + 40.0],
            "surface",
            17.0,
            Anchor::Middle,
        )
        .haloed_text(
            [meets[0] + 8.0, meets[1] + 5.0],
            "may meet the surface",
            17.0,
            Anchor::Start,
        )
        .haloed_text(
            [leaves[0] + 8.0, leaves[1] + 5.0],
            "leaves",
            17.0,
            Anchor::Start,
        );
    Figure::drawn(
        "error_box",
        "The surface passes somewhere through the box of half-side $e$ around the computed point. Here it passes below; on the other side, a ray from the point would meet it. Seen along the normal the box reaches \
         $e\\,|n|_1$ to either side (dotted). Twice that far, on the side that the ray points to, it begins safely.",
        "A square box around a point, crossed by a slanted line, the surface, below the point. An arrow along the normal leads out of the box to the origin of the ray that leaves.",
        &drawing,
    )
}

/// How far the origin moves, against the size of the scene.
pub fn offset_against_scale() -> Figure {
    let units: Vec<f64> = (0..=22)
        .map(|k| 10_f64.powf(-4.0 + f64::from(k) / 2.0))
        .collect();
    let line = |length: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
        units.iter().map(|&unit| [unit, length(unit)]).collect()
    };
    let offset = |unit: f64| {
        let sphere = Sphere::new(DVec3::new(0.0, unit, 0.0), unit).expect("a positive radius");
        let ray = Ray::new(
            DVec3::new(0.3, 2.0, 3.0) * unit,
            DVec3::new(-0.1, -0.4, -1.0),
        );
        let hit = sphere
            .intersect(&ray)
            .expect("the ray is aimed at the ball");
        spawn_ray(&hit, hit.normal).origin.distance(hit.point)
    };
    let plot = Plot::new("", "size of the scene (units)", "length (units)")
        .log_x()
        .log_y()
        .line("a hundredth of the scene", &line(&|unit| unit / 100.0))
        .line("fixed, 10⁻³", &line(&|_| 1e-3))
        .line("fixed, 10⁻⁹", &line(&|_| 1e-9))
        .line("offset by the bound", &line(&offset))
        .line(
            "spacing of the numbers",
            &line(&|unit| unit.next_up() - unit),
        )
        .to_drawing()
        .expect("positive lengths make a plot");
    Figure::drawn(
        "offset_against_scale",
        "What an offset must stay between, in double precision: above the spacing of the numbers, or there is acne, and below the details of the scene, say a hundredth of it, or light leaks. A fixed $\\varepsilon$ \
         is a horizontal line, and leaves the band at one end or the other. The offset by the bound runs along its lower edge.",
        "Five lines on logarithmic axes. The spacing of the numbers, the offset by the bound just above it and a hundredth of the scene rise in parallel; two horizontal lines, the fixed distances, cross them.",
        &plot,
    )
}
