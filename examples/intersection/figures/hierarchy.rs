//! Figures of the page *A hierarchy of boxes*: the boxes level by level, and how many of them a ray visits.

use facette::camera::{Camera, CameraFrame, ImageSize};
use facette::intersection::hierarchy::{Hierarchy, Visits};
use facette::mesh::Mesh;
use facette::ray::Ray;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::render::{Material, Picture, Scene, View};
use facette_figure::svg::{Anchor, Drawing, PAGE_WIDTH, Panel, panels};
use glam::{DVec3, Vec3};

use super::pictures::shadings;
use hierarchy_meshes::{Draws, bumpy_ball, cuts_for};

#[path = "../../../tests/intersection/hierarchy_meshes.rs"]
#[allow(
    dead_code,
    clippy::duplicate_mod,
    reason = "the tests use more of it than the figures, and include the figures too"
)]
mod hierarchy_meshes;

/// The pawn's triangles in single precision.
fn pawn() -> Hierarchy {
    let [_, _, mesh] = shadings();
    Hierarchy::of_mesh(&mesh).expect("finite corners")
}

/// A box as six faces with corners of their own.
fn solid([low, high]: [Vec3; 2]) -> Mesh<DVec3> {
    let [low, high] = [low.as_dvec3(), high.as_dvec3()];
    let corner = |index: u32| {
        let side = |axis: usize| {
            if index >> axis & 1 == 1 {
                high[axis]
            } else {
                low[axis]
            }
        };
        DVec3::new(side(0), side(1), side(2))
    };
    // The corners' bits are x, y, z; each face runs anticlockwise as seen from outside.
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    Mesh::new((0..8).map(corner).collect(), faces).expect("a box has eight corners")
}

fn view() -> View {
    let middle = DVec3::new(0.0, 1.2, 0.0);
    View::perspective(middle + DVec3::new(3.5, 3.0, 6.0), middle, DVec3::Y, 31.0)
}

/// The boxes of a level, and those leaves above it that have no boxes below.
fn with_leaves(levels: &[Vec<[Vec3; 2]>], level: usize) -> Vec<[Vec3; 2]> {
    let holds = |outer: &[Vec3; 2], inner: &[Vec3; 2]| {
        outer[0].cmple(inner[0]).all() && inner[1].cmple(outer[1]).all()
    };
    let is_leaf = |level: usize, bounds: &[Vec3; 2]| {
        let below = levels.get(level + 1);
        below.is_none_or(|below| !below.iter().any(|inner| holds(bounds, inner)))
    };
    let leaves = (0..level).flat_map(|above| {
        levels[above]
            .iter()
            .filter(move |&bounds| is_leaf(above, bounds))
    });
    leaves.chain(&levels[level]).copied().collect()
}

/// The boxes of the first levels around the pawn.
pub fn boxes_level_by_level() -> Figure {
    const COLOURS: [Colour; 5] = [
        Colour::Sky,
        Colour::Orange,
        Colour::Green,
        Colour::Purple,
        Colour::Blue,
    ];
    let levels = pawn().boxes();
    let mut row: Vec<_> = (0..3)
        .map(|level| {
            let boxes = with_leaves(&levels, level);
            let scene = (boxes.iter().zip(COLOURS.iter().cycle()))
                .fold(Scene::new(view()), |scene, (&bounds, &colour)| {
                    scene.surface(&solid(bounds), Material::matte(colour))
                });
            let label = format!("level {}: {} boxes", level + 1, boxes.len());
            Panel::picture(&label, scene.render(360, 480))
        })
        .collect();
    let [_, _, mesh] = shadings();
    let label = format!("{} triangles", mesh.triangles().count());
    let pawn = Scene::new(view()).surface(&mesh, Material::matte(Colour::Sky));
    row.push(Panel::picture(&label, pawn.render(360, 480)));
    Figure::drawn(
        "boxes_level_by_level",
        "A mesh and the boxes of its hierarchy, level by level. Each box of one level holds up to eight of the next, or is that of a leaf and stays. They close in on the mesh; a ray that misses the pawn by a hand's breadth is done after a few boxes.",
        "Four pictures. The first has a few large coloured boxes in the rough outline of a chess pawn, the second several dozen smaller ones, the third some hundred that follow the pawn's shape closely. The fourth is the pawn itself.",
        &panels(2, &row),
    )
}

/// From dark blue by green to yellow, ever lighter: `share` from 0 to 1.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "channels between 0 and 255"
)]
fn heat(share: f64) -> [u8; 3] {
    const STOPS: [[f64; 3]; 5] = [
        [40.0, 22.0, 92.0],
        [46.0, 84.0, 150.0],
        [34.0, 146.0, 140.0],
        [120.0, 202.0, 90.0],
        [253.0, 231.0, 60.0],
    ];
    let place = 4.0 * share.clamp(0.0, 1.0);
    let first = (place as usize).min(3);
    let along = place - first as f64;
    std::array::from_fn(|channel| {
        let [from, to] = [STOPS[first][channel], STOPS[first + 1][channel]];
        (from + along * (to - from)) as u8
    })
}

/// What the rays of a camera visit, pixel by pixel.
fn visits(hierarchy: &Hierarchy, camera: &Camera<DVec3>, size: ImageSize) -> Vec<Visits> {
    let mut query = hierarchy.query();
    size.pixels_in_file_order()
        .map(|pixel| {
            let ray = camera.pixel_ray(size, pixel);
            let ray = Ray::new(ray.origin.as_vec3(), ray.direction.as_vec3());
            query.visits(&ray).expect("an ordinary ray")
        })
        .collect()
}

/// A picture of numbers from 0 to `most`.
fn heat_map(size: ImageSize, numbers: &[u32], most: u32) -> Picture {
    let colour = |&number: &u32| heat(f64::from(number) / f64::from(most));
    Picture {
        width: size.columns(),
        height: size.rows(),
        rgba: numbers
            .iter()
            .flat_map(|number| colour(number).into_iter().chain([255]))
            .collect(),
    }
}

/// The colours of [`heat`] from left to right, with numbers below.
fn colour_bar(drawing: Drawing, [x, y]: [f64; 2], width: f64, most: u32) -> Drawing {
    let bar = Picture {
        width: 256,
        height: 10,
        rgba: (0..10 * 256)
            .map(|pixel| pixel % 256)
            .flat_map(|column| heat(f64::from(column) / 255.0).into_iter().chain([255]))
            .collect(),
    };
    let mut drawing = drawing.picture([x, y], [width, width * 10.0 / 256.0], &bar);
    for quarter in 0..=4 {
        let place = x + width * f64::from(quarter) / 4.0;
        let number = f64::from(most) * f64::from(quarter) / 4.0;
        drawing = drawing.text(
            [place, y + 32.0],
            &format!("{number}"),
            15.0,
            Anchor::Middle,
        );
    }
    drawing
}

/// How many nodes and triangles each pixel's ray visits.
pub fn visits_of_pixels() -> Figure {
    let size = ImageSize::new(540, 600).expect("a picture has pixels");
    let middle = DVec3::new(0.0, 1.3, 0.0);
    let frame = CameraFrame::looking_at(middle + DVec3::new(3.5, 3.0, 6.0), middle, DVec3::Y);
    let frame = frame.expect("the view is not vertical");
    let camera = Camera::with_field_of_view(frame, 25_f64.to_radians(), size.aspect());
    let camera = camera.expect("a usable angle");
    let visits = visits(&pawn(), &camera, size);
    let numbers: [Vec<u32>; 2] = [
        visits.iter().map(|visits| visits.nodes).collect(),
        visits.iter().map(|visits| visits.triangles).collect(),
    ];
    let width = (PAGE_WIDTH - 30.0) / 2.0;
    let height = width * 600.0 / 540.0;
    let mut drawing = Drawing::new(PAGE_WIDTH, height + 76.0);
    let names = ["nodes visited", "triangles tested"];
    for (index, (name, numbers)) in names.into_iter().zip(&numbers).enumerate() {
        // A scale that ends with a round number, of which the quarters are whole.
        let most = numbers.iter().copied().max().unwrap_or(1).div_ceil(8) * 8;
        let left = index as f64 * (width + 30.0);
        let middle = left + width / 2.0;
        drawing = drawing
            .text([middle, 18.0], name, 16.0, Anchor::Middle)
            .picture(
                [left, 28.0],
                [width, height],
                &heat_map(size, numbers, most),
            );
        drawing = colour_bar(drawing, [left + 20.0, height + 36.0], width - 40.0, most);
    }
    Figure::drawn(
        "visits_of_pixels",
        "What the ray of each pixel costs, from dark (nothing) to light (much). Rays beside the pawn visit the root, and no triangle. Most of those that meet it visit two to four nodes and test a dozen triangles. Where boxes lie behind each other and the ray slips past what is in them, as around the neck and at the foot, it visits up to eight. The loop would test all 542 triangles at each pixel.",
        "Two pictures in false colours of a chess pawn on a dark ground, one for the nodes visited and one for the triangles tested, with a colour scale below each. The background is dark. The pawn stands in overlapping shapes of boxes, brighter the more of them overlap, brightest beside the neck and where the stem meets the foot.",
        &drawing,
    )
}

/// The mean number of nodes and of triangles that a thousand rays at a ball visit.
fn mean_visits(triangles: &[[Vec3; 3]]) -> [f64; 2] {
    let hierarchy = Hierarchy::new(triangles).expect("finite corners");
    let mut query = hierarchy.query();
    let mut draws = Draws::new(4);
    let mut sums = [0.0; 2];
    for _ in 0..1000 {
        let origin = 3.0 * draws.direction();
        let ray = Ray::new(origin, draws.direction() - origin);
        let visits = query.visits(&ray).expect("an ordinary ray");
        sums[0] += f64::from(visits.nodes);
        sums[1] += f64::from(visits.triangles);
    }
    sums.map(|sum| sum / 1000.0)
}

/// Visits against the number of triangles.
pub fn visits_against_n() -> Figure {
    let [mut nodes, mut triangles, mut all] = [Vec::new(), Vec::new(), Vec::new()];
    for wanted in [30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000] {
        let ball = bumpy_ball(cuts_for(wanted));
        let count = ball.len() as f64;
        let means = mean_visits(&ball);
        nodes.push([count, means[0]]);
        triangles.push([count, means[1]]);
        all.push([count, count]);
    }
    let plot = Plot::new("Visits of a ray", "triangles n", "visits of a ray (mean)")
        .log_x()
        .log_y()
        .line("loop: triangles tested", &all)
        .line("hierarchy: triangles tested", &triangles)
        .line("hierarchy: nodes visited", &nodes)
        .to_drawing()
        .expect("positive numbers");
    Figure::drawn(
        "visits_against_n",
        "Visits of a ray at a bumpy ball, in the mean over a thousand rays from all sides. The loop tests all $n$ triangles. In the hierarchy the number of triangles hardly grows, and the number of nodes grows with the depth of the tree, $\\log_8 n$.",
        "A plot with logarithmic axes. The line of the loop rises straight from 32 to a hundred thousand. The two lines of the hierarchy stay nearly flat: from one node to about eight, and from six triangles to about twelve.",
        &plot,
    )
}
