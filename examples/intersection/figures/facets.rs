//! Pictures of the page *Triangles*: leaks and their cure, a twisted quadrilateral.

use facette::algebra::{Vector3, VectorSpace};
use facette::intersection::quadrilateral::Quadrilateral;
use facette::intersection::triangle::{
    half_planes, moller_trumbore, strict_half_planes, watertight,
};
use facette::intersection::{FacetHit, Intersect, Side};
use facette::mesh::tessellate_uniformly;
use facette::ray::Ray;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Picture, Scene, View};
use facette_figure::svg::{Anchor, Drawing, PAGE_WIDTH, Panel, panels};
use glam::DVec3;

type Point = [f32; 3];
type Test = fn(&[Point; 3], &Ray<Point>) -> Option<FacetHit<f32>>;

/// Cells along each side of the roof, and how many pixels wide each is. Powers of two keep all coordinates short.
const CELLS: i16 = 16;
const PIXELS_OF_A_CELL: i16 = 8;

/// A closed mesh: a vaulted roof over a square, and its floor. Corners stand over whole pixels.
struct Vault {
    triangles: Vec<[Point; 3]>,
    /// How it stands in space, rays and all.
    placed: fn([f64; 3]) -> Point,
}

/// A rotation by the quaternion along (5, 1, 2, 1), which leaves no coordinate short.
fn turned(p: [f64; 3]) -> [f64; 3] {
    let axis = [1.0, 2.0, 1.0];
    let twice = axis
        .cross(p)
        .times(5.0)
        .plus(axis.cross(axis.cross(p)))
        .times(2.0 / 31.0);
    p.plus(twice)
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "the pictures show what single precision does"
)]
fn upright(p: [f64; 3]) -> Point {
    p.map(|x| x as f32)
}

fn rotated(p: [f64; 3]) -> Point {
    upright(turned(p))
}

impl Vault {
    fn new(placed: fn([f64; 3]) -> Point) -> Self {
        let corner = |i: i16, j: i16, is_roof: bool| {
            let [x, y] = [i, j].map(|index| 2.0 * f64::from(index) / f64::from(CELLS) - 1.0);
            let height = (1.0 - x * x) * (1.0 - y * y);
            placed([x, y, if is_roof { height } else { 0.0 }])
        };
        let mut triangles = Vec::new();
        for is_roof in [true, false] {
            for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j))) {
                let at = |di, dj| corner(i + di, j + dj, is_roof);
                let [a, b, c, d] = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
                // Diagonals from the middle outwards: no triangle of the roof lies in the floor.
                let outwards = (i < CELLS / 2) == (j < CELLS / 2);
                let two = if outwards {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                };
                triangles.extend(two.map(|[p, q, r]| if is_roof { [p, q, r] } else { [p, r, q] }));
            }
        }
        Self { triangles, placed }
    }

    /// What the ray from above at a pixel meets first: the roof from outside, unless something is lost.
    fn nearest(&self, ray: &Ray<Point>, test: Test) -> Option<(usize, FacetHit<f32>)> {
        let mut nearest: Option<(usize, FacetHit<f32>)> = None;
        for (index, corners) in self.triangles.iter().enumerate() {
            let hit = test(corners, ray);
            if let Some(hit) = hit
                && nearest.is_none_or(|(_, nearest)| hit.t < nearest.t)
            {
                nearest = Some((index, hit));
            }
        }
        nearest
    }

    /// The picture, and how many rays were lost.
    fn picture(&self, test: Test) -> (Picture, usize) {
        let size = CELLS * PIXELS_OF_A_CELL;
        let mut rgba = Vec::new();
        let mut lost = 0;
        for (row, column) in (1..size).flat_map(|row| (1..size).map(move |column| (row, column))) {
            let [x, y] =
                [column, size - row].map(|pixel| 2.0 * f64::from(pixel) / f64::from(size) - 1.0);
            let ray = Ray::new((self.placed)([x, y, 3.0]), (self.placed)([0.0, 0.0, -1.0]));
            let colour = match self.nearest(&ray, test) {
                Some((index, hit)) if hit.side == Side::Front => self.shade(index),
                _ => {
                    lost += 1;
                    Colour::Vermilion.rgb()
                }
            };
            rgba.extend(colour.into_iter().chain([255]));
        }
        let side = u32::from((size - 1).unsigned_abs());
        (
            Picture {
                width: side,
                height: side,
                rgba,
            },
            lost,
        )
    }

    /// A grey-blue by the angle to a lamp on the upper left.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a brightness between 0 and 255"
    )]
    fn shade(&self, triangle: usize) -> [u8; 3] {
        let [a, b, c] = self.triangles[triangle];
        let n = b.minus(a).cross(c.minus(a));
        let lamp = (self.placed)([-0.5, 0.5, 0.7]);
        let cosine = n.dot(lamp) / (n.dot(n) * lamp.dot(lamp)).sqrt();
        let brightness = 0.35 + 0.65 * cosine.max(0.0);
        [150.0, 190.0, 225.0_f32].map(|channel| (channel * brightness) as u8)
    }
}

/// The picture enlarged without smoothing, so that single pixels are seen.
fn enlarged(picture: &Picture, factor: u32) -> Picture {
    let [width, height] = [picture.width * factor, picture.height * factor];
    let pixels =
        (0..height).flat_map(|row| (0..width).map(move |column| (row / factor, column / factor)));
    Picture {
        width,
        height,
        rgba: pixels
            .flat_map(|(row, column)| picture.pixel(column, row))
            .collect(),
    }
}

/// One mesh, three tests, and the rays that each of them loses.
pub fn leaks() -> Figure {
    let [short, long] = [Vault::new(upright), Vault::new(rotated)];
    let tests: [(&str, &Vault, Test); 4] = [
        (
            "half-planes with >, exact numbers",
            &short,
            strict_half_planes,
        ),
        ("half-planes with ≥, exact numbers", &short, half_planes),
        ("Möller-Trumbore, rounded numbers", &long, moller_trumbore),
        ("watertight, rounded numbers", &long, watertight),
    ];
    let row = tests.map(|(name, vault, test)| {
        let (picture, lost) = vault.picture(test);
        Panel::picture(&format!("{name}: {lost} lost"), enlarged(&picture, 3))
    });
    Figure::drawn(
        "leaks",
        "A closed mesh in `f32`, a vaulted roof over a square floor, and one ray a pixel; a third of the rays pass through edges. Orange: the roof has let the ray through. Above, the coordinates are so short that nothing is rounded: with $>$ every \
         ray at an edge is lost, with $\\ge$ none. Below, the same mesh and rays are turned together, and coordinates are rounded: Möller and Trumbore's test loses some rays at edges, the watertight test none.",
        "Four pictures of the same vaulted roof from above. In the first, orange lines of lost pixels draw the whole grid of edges. In the second there are none. In the third, orange pixels are scattered along the edges. The fourth has none.",
        &panels(2, &row),
    )
}

/// A twisted quadrilateral, a ray that meets it twice, and the rulings.
pub fn bilinear() -> Figure {
    let [width, height] = [PAGE_WIDTH, 430.0];
    let at = |x, y, z| DVec3::new(x, y, z);
    let corners = [
        at(0., 0., 0.),
        at(4., 0., 2.6),
        at(4., 4., 0.),
        at(0., 4., 2.6),
    ];
    let patch = Quadrilateral::new(corners).expect("finite corners");
    let ray = Ray::new(at(-1.6, -1.2, 0.92), at(1.0, 0.93, 0.01));
    let mut hits = Vec::new();
    let mut rest = ray;
    while let Some(hit) = patch.intersect(&rest) {
        hits.push(hit);
        rest = ray.after(hit.t);
    }
    let view = View::orthographic(at(8., -10., 15.), at(1.9, 2.1, 1.2), DVec3::Z, 7.0);
    let mesh = tessellate_uniformly(&patch, 32, 32).expect("a finite surface");
    let mut scene = Scene::new(view)
        .surface(&mesh, Material::matte(Colour::Sky).isolines(8))
        .tube(&[ray.point(0.0), ray.point(7.2)], 0.035, Colour::Vermilion);
    for hit in &hits {
        scene = scene.point(hit.point, 0.1, Colour::Green);
    }
    let picture = scene.render(2 * 750, 2 * 430);
    let mut drawing = Drawing::new(width, height).picture([0.0; 2], [width, height], &picture);
    let names = [
        ("a", [-14., 18.]),
        ("b", [18., 6.]),
        ("c", [18., 0.]),
        ("d", [-14., -8.]),
    ];
    for (corner, (name, shift)) in corners.into_iter().zip(names) {
        if let Some(place) = view.project(corner, 750, 430) {
            drawing = drawing.haloed_text(place.plus(shift), name, 19.0, Anchor::Middle);
        }
    }
    Figure::drawn(
        "bilinear",
        "A twisted quadrilateral with its straight lines. The ray (orange) meets it twice: at these two points (green) it lies in one plane with a line $u=$ const, and the quadratic equation has its roots there.",
        "A saddle-shaped surface over four corners a, b, c, d, with two families of straight lines on it. A straight ray enters it in front, leaves it, and passes through it again further on; both places are marked.",
        &drawing,
    )
}
