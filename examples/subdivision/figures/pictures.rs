//! One cage and four schemes, in pictures.

use facette::mesh::Mesh;
use facette::subdivision::Corners;
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::render::{Material, Scene, View};
use facette_figure::svg::{Anchor, Drawing, PAGE_WIDTH, Panel, panels};
use glam::DVec3;

use super::cages::{bars, handkerchief, limit, piggy_bank, refined, scene_of, view_of};
use super::scheme::Scheme;

/// Half the width of a drawn edge of the piggy bank's cage.
const EDGE: f64 = 0.011;

/// A level of the piggy bank with flat faces, and edges that are thinner the more there are.
pub fn faceted(view: View, mesh: &Mesh<DVec3>, level: u32) -> Scene {
    let edge = EDGE / f64::from(level + 1);
    scene_of(view, mesh, Colour::Sky).surface(bars(mesh, edge), Material::matte(Colour::Ink))
}

/// The piggy bank's limit surface, smooth.
pub fn smooth(view: View, scheme: Scheme) -> Scene {
    let surface = limit(scheme, &piggy_bank(), Corners::Sharp);
    scene_of(view, &surface, Colour::Sky)
}

/// A cage, two steps, and where they lead.
pub fn piggy_bank_becomes_smooth() -> Figure {
    const SIZE: [u32; 2] = [620, 496];
    let cage = piggy_bank();
    let view = view_of(&cage, SIZE);
    let panel = |level: u32| {
        let mesh = refined(Scheme::CatmullClark, &cage, level, Corners::Sharp);
        let label = match level {
            0 => format!("the cage: {} faces", mesh.face_count()),
            _ => format!("level {level}: {} faces", grouped(mesh.face_count())),
        };
        Panel::picture(&label, faceted(view, &mesh, level).render(SIZE[0], SIZE[1]))
    };
    let limit = smooth(view, Scheme::CatmullClark).render(SIZE[0], SIZE[1]);
    let limit = Panel::picture("the limit", limit);
    Figure::drawn(
        "piggy_bank",
        "A *cage* of 114 faces, one and two steps of Catmull-Clark, and the limit surface. The cage has triangles, quadrilaterals and a hexagon; three, four, five or six edges meet in its vertices, and the slot in its back \
         is a boundary. No rectangular net of control points looks like this. After one step all faces are quadrilaterals.",
        "Four pictures of a piggy bank with a slot in its back. The first is made of large flat faces, with triangles on the ears and a hexagon for a snout. In the second and third the faces are smaller and smaller quadrilaterals. The last is perfectly smooth.",
        &panels(2, &[panel(0), panel(1), panel(2), limit]),
    )
}

/// The four limit surfaces of one cage.
pub fn four_limits() -> Figure {
    const SIZE: [u32; 2] = [620, 496];
    let view = view_of(&piggy_bank(), SIZE);
    let panel = |scheme: Scheme| {
        let picture = smooth(view, scheme).render(SIZE[0], SIZE[1]);
        Panel::picture(scheme.title(), picture)
    };
    Figure::drawn(
        "four_limits",
        "The limits of one cage under the four schemes, all seen from the same place. Doo-Sabin stays nearest to the cage: its feet and its snout still show the edges they came from. The others are rounder and a little smaller. Loop and √3 start \
         from the cage's faces cut into triangles, and their surfaces depend a little on how they were cut.",
        "Four pictures of a smooth piggy bank. The one by Doo-Sabin has the largest snout, with a visible rim, and feet with a hint of corners; those by Catmull-Clark, Loop and root 3 are rounder and look much alike.",
        &panels(2, &Scheme::ALL.map(panel)),
    )
}

/// Levels 0 to 4 and the limit, a column for each scheme.
pub fn level_by_level() -> Figure {
    const SIZE: [u32; 2] = [252, 206];
    const HEADER: f64 = 30.0;
    let cage = piggy_bank();
    let view = view_of(&cage, SIZE);
    let cell = |level: u32, scheme: Scheme| {
        let mesh = refined(scheme, &cage, level, Corners::Sharp);
        let label = format!("{level}: {} faces", grouped(mesh.face_count()));
        let scene = if level < 3 {
            faceted(view, &mesh, level)
        } else {
            scene_of(view, &mesh, Colour::Sky)
        };
        Panel::picture(&label, scene.render(SIZE[0], SIZE[1]))
    };
    let mut cells: Vec<Panel> = (0..=4)
        .flat_map(|level| Scheme::ALL.map(|scheme| cell(level, scheme)))
        .collect();
    cells.extend(
        Scheme::ALL
            .map(|scheme| Panel::picture("limit", smooth(view, scheme).render(SIZE[0], SIZE[1]))),
    );
    let sheet = panels(4, &cells);
    let [width, height] = sheet.size();
    let drawing =
        Drawing::new(width, height + HEADER).drawing([0.0, HEADER], [width, height], &sheet);
    let drawing =
        Scheme::ALL
            .iter()
            .zip([1.0, 3.0, 5.0, 7.0])
            .fold(drawing, |drawing, (scheme, eighths)| {
                let at = [PAGE_WIDTH * eighths / 8.0, 18.0];
                drawing.text(at, scheme.title(), 18.0, Anchor::Middle)
            });
    Figure::drawn(
        "level_by_level",
        "Level by level, with flat faces; the edges are drawn up to level 2. Catmull-Clark cuts every face into quadrilaterals. Doo-Sabin shrinks the faces, and puts new ones on edges and vertices: the hexagon of the snout is there on every level, ever smaller. \
         Loop cuts each triangle into four, √3 into three that run across the old edges. On level 1 of √3 the slot still has its six edges: its boundary is divided in every second step.",
        "Twenty-four small pictures of a piggy bank in four columns, one for each scheme, and six rows: the cage, four levels and the limit. From row to row the faces get smaller; from level 3 on the pictures look smooth.",
        &drawing,
    )
}

/// What becomes of a boundary and its corners.
pub fn sharp_and_smooth_corners() -> Figure {
    const SIZE: [u32; 2] = [560, 400];
    let cage = handkerchief();
    let view = View::around(&cage.positions, DVec3::new(0.35, 1.0, 0.9), SIZE);
    let panel = |scheme: Scheme, corners: Corners, label: &str| {
        let scene = scene_of(view, &limit(scheme, &cage, corners), Colour::Sky);
        let scene = scene.surface(bars(&cage, 0.006), Material::matte(Colour::Ink));
        let label = format!("{}, {label} corners", scheme.title());
        Panel::picture(&label, scene.render(SIZE[0], SIZE[1]))
    };
    let row = |scheme: Scheme| {
        [
            panel(scheme, Corners::Sharp, "sharp"),
            panel(scheme, Corners::Smooth, "smooth"),
        ]
    };
    Figure::drawn(
        "corners",
        "A boundary is a curve of its own, which depends on the boundary of the cage (bars) alone: a cubic spline for Catmull-Clark, a quadratic one for Doo-Sabin. A vertex with a single face is kept if corners are sharp, and rounded off like any other one if they \
         are smooth.",
        "Four pictures of a saddle with the nine squares of its cage drawn as thin bars. On the left the surface reaches the four corners of the cage; on the right its corners are rounded, more with Catmull-Clark than with Doo-Sabin.",
        &panels(
            2,
            &[row(Scheme::CatmullClark), row(Scheme::DooSabin)].concat(),
        ),
    )
}

/// A number with its digits in groups of three.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
