//! Drawings of the page *Triangles*: half-planes, areas, the shear, a fan.

use facette::algebra::VectorSpace;
use facette::intersection::triangle::{ShearedRay, watertight};
use facette::ray::Ray;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::svg::{Anchor, Dashes, Drawing, PAGE_WIDTH, Panel, Stroke, panels};

type Flat = [f64; 2];

/// The corners of the triangle in the drawings.
const CORNERS: [Flat; 3] = [[235.0, 315.0], [560.0, 270.0], [330.0, 115.0]];

/// The point with these weights of b and c.
fn at_weights([v, w]: [f64; 2]) -> Flat {
    VectorSpace::combination([1.0 - v - w, v, w], CORNERS)
}

fn middle(a: Flat, b: Flat) -> Flat {
    a.lerp(b, 0.5)
}

/// The names of the corners, outside of each.
fn with_names(drawing: Drawing) -> Drawing {
    let [a, b, c] = CORNERS;
    let names = [
        (a, "**a**", [-16.0, 20.0]),
        (b, "**b**", [18.0, 18.0]),
        (c, "**c**", [-2.0, -12.0]),
    ];
    names
        .into_iter()
        .fold(drawing, |drawing, (corner, name, shift)| {
            let at = corner.plus(shift);
            let name = name.trim_matches('*');
            drawing
                .disc(corner, 4.0, Colour::Ink)
                .haloed_text(at, name, 19.0, Anchor::Middle)
        })
}

/// Seven regions, and the three signs in each.
pub fn half_planes() -> Figure {
    let [width, height] = [PAGE_WIDTH, 410.0];
    let colours = [Colour::Blue, Colour::Vermilion, Colour::Green];
    let [a, b, c] = CORNERS;
    let mut drawing = Drawing::new(width, height).area(&CORNERS, Colour::Sky, 0.35);
    for ((from, to), colour) in [(a, b), (b, c), (c, a)].into_iter().zip(colours) {
        let along = to.minus(from);
        let line = cut(from, along, [width, height]);
        drawing = drawing
            .line(
                line[0],
                line[1],
                Stroke::new(colour, 1.5).dashes(Dashes::Dashed),
            )
            .arrow(from, to, Stroke::new(colour, 2.4));
    }
    // The signs of the half-planes of the edges ab, bc and ca: those of the weights w, u and v.
    let regions = [
        ([0.33, 0.33], "+ + +"),
        ([0.45, -0.35], "− + +"),
        ([0.72, 0.72], "+ − +"),
        ([-0.4, 0.45], "+ + −"),
        ([-0.3, -0.17], "− + −"),
        ([1.36, -0.17], "− − +"),
        ([-0.2, 1.36], "+ − −"),
    ];
    for (weights, signs) in regions {
        let size = if signs == "+ + +" { 21.0 } else { 17.0 };
        let at = at_weights(weights).plus([0.0, 6.0]);
        drawing = drawing.haloed_text(at, signs, size, Anchor::Middle);
    }
    Figure::drawn(
        "half_planes",
        "Three lines divide the plane into seven regions. The signs are those of the half-planes of the edges $\\mathbf{ab}$ (blue), $\\mathbf{bc}$ (orange) and $\\mathbf{ca}$ (green), in this order: plus to \
         the left of the arrow. Only inside are all three positive; nowhere are all three negative.",
        "A triangle with arrows along its edges, which run anticlockwise; the edges are continued as dashed lines. Inside stands plus plus plus. Beyond each edge one sign \
         is minus, beyond each corner two.",
        &with_names(drawing),
    )
}

/// The part of a line in the drawing's rectangle, a little away from its border.
fn cut(start: Flat, along: Flat, size: [f64; 2]) -> [Flat; 2] {
    let (mut first, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..2 {
        let ends = [8.0, size[axis] - 8.0].map(|end| (end - start[axis]) / along[axis]);
        first = first.max(ends[0].min(ends[1]));
        last = last.min(ends[0].max(ends[1]));
    }
    [first, last].map(|t| start.plus(along.times(t)))
}

/// A point of the triangle, and three areas.
pub fn barycentric_areas() -> Figure {
    let [a, b, c] = CORNERS;
    let x = at_weights([0.3, 0.25]);
    let parts = [
        ([x, b, c], Colour::Vermilion, "*u*"),
        ([x, c, a], Colour::Green, "*v*"),
        ([x, a, b], Colour::Blue, "*w*"),
    ];
    let mut drawing = Drawing::new(PAGE_WIDTH, 350.0);
    for (corners, colour, _) in parts {
        drawing = drawing
            .area(&corners, colour, 0.3)
            .outline(&corners, Stroke::new(Colour::Ink, 1.2));
    }
    for (corners, _, name) in parts {
        let centre = VectorSpace::combination([1.0 / 3.0; 3], corners).plus([0.0, 6.0]);
        drawing = drawing.haloed_text(centre, name, 21.0, Anchor::Middle);
    }
    let drawing = drawing.disc(x, 4.5, Colour::Ink).haloed_text(
        x.plus([12.0, -10.0]),
        "x",
        19.0,
        Anchor::Middle,
    );
    Figure::drawn(
        "barycentric_areas",
        "The barycentric coordinates of $\\mathbf x$ are areas, as parts of the whole: $u$ belongs to the corner $\\mathbf a$ and is the triangle opposite to it (orange), so $v$ to $\\mathbf b$ (green) and $w$ to \
         $\\mathbf c$ (blue). They add up to 1; as $\\mathbf x$ nears a corner, its area grows.",
        "A triangle a b c with a point x inside, joined to the three corners. The part opposite to a is called u, the one opposite to b is v, the one opposite to c is w.",
        &with_names(drawing),
    )
}

/// A point of space as the drawing of the shear shows it: x to the right, z up, y towards the upper right.
fn oblique([x, y, z]: [f64; 3]) -> Flat {
    [110.0 + 34.0 * (x + 0.45 * y), 325.0 - 31.0 * (z + 0.3 * y)]
}

/// The triangle and the ray before the shear, after it, and seen along the ray.
pub fn shear() -> Figure {
    let ray = Ray::new([0.0, 0.0, 0.0], [3.0, 1.0, 6.0]);
    let corners = [[0.4, -1.2, 4.4], [5.6, -0.4, 5.2], [3.0, 3.6, 7.6]];
    let sheared = ShearedRay::new(&ray);
    // Depth is kept for the drawing: the third sheared coordinate is t, and the direction's z is 6.
    let moved = corners.map(|corner| {
        let [x, y, t] = sheared.sheared(corner);
        [x, y, 6.0 * t]
    });
    let hit = watertight(&corners, &ray).expect("the ray is drawn through it");
    let before = solid(corners, ray.point(1.45), ray.point(hit.t));
    let after = solid(moved, [0.0, 0.0, 8.7], [0.0, 0.0, 6.0 * hit.t]);
    let drawing = panels(
        3,
        &[
            Panel::drawing("the ray and the triangle", before),
            Panel::drawing("sheared: the ray is the axis", after),
            Panel::drawing("seen along the ray", along_the_ray(moved)),
        ],
    );
    Figure::drawn(
        "shear",
        "Woop's test. A shear shifts every horizontal layer, so that the ray becomes the $z$ axis. Seen along it, the ray is a point, and each edge asks on which side of it that point lies: three areas $U$, $V$ and $W$ in a plane.",
        "Three panels. In the first an oblique arrow passes through a triangle. In the second both are sheared, and the arrow stands upright. In the third the triangle is seen from above, with the ray as a dot inside, \
         joined to the corners by three dashed lines that bound the areas U, V and W.",
        &drawing,
    )
}

/// A triangle, and a ray from the origin that passes through it at `hit`.
fn solid(corners: [[f64; 3]; 3], end: [f64; 3], hit: [f64; 3]) -> Drawing {
    let axis = Stroke::new(Colour::Faint, 1.6).dashes(Dashes::Dashed);
    let o = [0.0; 3];
    let flat = corners.map(oblique);
    Drawing::new(330.0, 360.0)
        .arrow(oblique(o), oblique([0.0, 0.0, 9.2]), axis)
        .arrow(oblique(o), oblique([4.4, 0.0, 0.0]), axis)
        .arrow(oblique(o), oblique([0.0, 4.0, 0.0]), axis)
        .text(oblique([4.5, 0.0, -0.9]), "*x*", 26.0, Anchor::Middle)
        .text(oblique([0.3, 4.6, 0.0]), "*y*", 26.0, Anchor::Middle)
        .text(oblique([0.7, 0.0, 8.8]), "*z*", 26.0, Anchor::Middle)
        .line(
            oblique(o),
            oblique(hit),
            Stroke::new(Colour::Vermilion, 3.2),
        )
        .area(&flat, Colour::Sky, 0.5)
        .outline(&flat, Stroke::new(Colour::Blue, 2.6))
        .arrow(
            oblique(hit),
            oblique(end),
            Stroke::new(Colour::Vermilion, 3.2),
        )
        .disc(oblique(hit), 6.0, Colour::Ink)
}

/// The sheared triangle without its depth, and the ray as a dot.
fn along_the_ray(corners: [[f64; 3]; 3]) -> Drawing {
    let flat = corners.map(|[x, y, _]| [135.0 + 56.0 * x, 190.0 - 56.0 * y]);
    let dot = [135.0, 190.0];
    let mut drawing = Drawing::new(330.0, 360.0)
        .area(&flat, Colour::Sky, 0.5)
        .outline(&flat, Stroke::new(Colour::Blue, 2.6));
    for (corner, name) in flat.into_iter().zip(["a", "b", "c"]) {
        let outwards = corner.minus(dot);
        let length = outwards[0].hypot(outwards[1]);
        let at = corner.plus(outwards.times(20.0 / length)).plus([0.0, 8.0]);
        drawing = drawing
            .line(
                dot,
                corner,
                Stroke::new(Colour::Ink, 1.6).dashes(Dashes::Dashed),
            )
            .text(at, name, 26.0, Anchor::Middle);
    }
    let [a, b, c] = flat;
    for (ends, name) in [([b, c], "*U*"), ([c, a], "*V*"), ([a, b], "*W*")] {
        let at = dot.lerp(middle(ends[0], ends[1]), 0.6).plus([0.0, 9.0]);
        drawing = drawing.haloed_text(at, name, 25.0, Anchor::Middle);
    }
    drawing.disc(dot, 7.0, Colour::Vermilion)
}

/// A fan from above, its spokes with the side that the ray passes on.
pub fn fan() -> Figure {
    let hub = [375.0, 185.0];
    let rim = [15.0, 68.0, 118.0, 172.0, 222.0, 274.0, 322.0].map(|degrees: f64| {
        let radius = if degrees % 4.0 < 0.5 { 160.0 } else { 145.0 };
        let angle = degrees.to_radians();
        hub.plus([1.5 * radius * angle.cos(), -radius * angle.sin()])
    });
    let ray = hub.plus([78.0, -50.0]);
    let side = |end: Flat| {
        let (spoke, to_ray) = (end.minus(hub), ray.minus(hub));
        spoke[1] * to_ray[0] - spoke[0] * to_ray[1]
    };
    let mut drawing = Drawing::new(PAGE_WIDTH, 370.0);
    for (index, &end) in rim.iter().enumerate() {
        let next = rim[(index + 1) % rim.len()];
        let is_crossed = (side(end) >= 0.0) != (side(next) >= 0.0);
        let is_hit = is_crossed && side(end) >= 0.0;
        if is_crossed {
            let colour = if is_hit { Colour::Sky } else { Colour::Faint };
            drawing = drawing.area(&[hub, end, next], colour, if is_hit { 0.6 } else { 0.2 });
        }
        drawing = drawing.line(end, next, Stroke::new(Colour::Ink, 1.4));
    }
    for &end in &rim {
        let (colour, dashes, sign) = if side(end) >= 0.0 {
            (Colour::Blue, Dashes::Solid, "+")
        } else {
            (Colour::Vermilion, Dashes::Dashed, "−")
        };
        let at = hub.lerp(end, 0.68).plus([0.0, 7.0]);
        drawing = drawing
            .line(hub, end, Stroke::new(colour, 2.4).dashes(dashes))
            .haloed_text(at, sign, 22.0, Anchor::Middle);
    }
    let drawing = drawing
        .disc(hub, 5.0, Colour::Ink)
        .haloed_text(hub.plus([-16.0, -12.0]), "hub", 17.0, Anchor::End)
        .disc(ray, 6.0, Colour::Green)
        .haloed_text(ray.plus([12.0, -8.0]), "ray", 17.0, Anchor::Start);
    Figure::drawn(
        "fan",
        "A fan, as the ray sees it. Every spoke is asked once on which side the ray passes: plus (blue) or minus (orange, dashed). Going round, the sign changes twice. In these two triangles (shaded) the outer edge decides; here it is the \
         one on the right that is hit.",
        "A hub with seven spokes and an outer polygon. Three neighbouring spokes are marked plus, the other four minus. The two triangles between spokes of different sign are shaded; one of them has the dot of the ray in it.",
        &drawing,
    )
}
