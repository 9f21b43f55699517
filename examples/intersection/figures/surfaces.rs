//! Figures of curved surfaces: triangles against the patch itself.

use facette::algebra::VectorSpace;
use facette::bspline::{BsplineSurface, KnotVector};
use facette::camera::{Camera, CameraFrame, ImageSize};
use facette::intersection::bezier_patch::PatchIntersector;
use facette::intersection::hierarchy::{Hierarchy, HierarchyError};
use facette::intersection::nearest;
use facette::mesh::Mesh;
use facette::ray::Ray;
use facette::tessellation::{Tessellation, tessellate};
use facette_figure::Figure;
use facette_figure::palette::Colour;
use facette_figure::plot::Plot;
use facette_figure::render::Picture;
use facette_figure::svg::{Anchor, Dashes, Drawing, Panel, Stroke, panels};
use glam::{DVec3, Vec3};

/// A wavy sheet of 3 × 3 bicubic pieces, which rises to a hump and overhangs a little.
fn sheet() -> BsplineSurface<DVec3> {
    let knots = || KnotVector::clamped_uniform(3, 6).expect("six control points");
    let heights = [
        0.0, 0.2, -0.2, 0.1, 0.0, 0.3, 0.1, 0.7, 1.6, 1.4, 0.3, 0.0, 0.0, 1.3, 3.0, 2.8, 0.9, 0.1,
    ];
    let points = (0..36).map(|k| {
        let [i, j] = [k % 6, k / 6];
        let height = heights[if j < 3 { 6 * j + i } else { 6 * (5 - j) + i }];
        DVec3::new(i as f64 - 2.5 + 0.25 * height, j as f64 - 2.5, height)
    });
    BsplineSurface::new([knots(), knots()], points.collect()).expect("a net of 6 x 6")
}

// ANCHOR: to_hierarchy
/// The triangles of a tessellation, as a ray tracer takes them: in single precision, below a hierarchy of boxes.
pub fn to_hierarchy(tessellation: &Tessellation<DVec3>) -> Result<Hierarchy, HierarchyError> {
    Hierarchy::of_mesh(&tessellation.mesh)
}

/// The surface's parameters at a place on a triangle: those of the corners, in the same proportions.
pub fn parameters_at(mesh: &Mesh<DVec3>, corners: [u32; 3], weights: [f32; 3]) -> [f64; 2] {
    let of_corners = corners.map(|vertex| mesh.parameters[vertex as usize]);
    VectorSpace::combination(weights.map(f64::from), of_corners)
}
// ANCHOR_END: to_hierarchy

fn camera(size: ImageSize) -> Camera<DVec3> {
    let eye = DVec3::new(-2.0, -12.0, 3.2);
    let frame = CameraFrame::looking_at(eye, DVec3::new(0.3, 0.0, 0.75), DVec3::Z);
    let frame = frame.expect("the view is not vertical");
    Camera::with_field_of_view(frame, 0.33, size.aspect()).expect("a usable angle")
}

/// A picture of unit normals, seen from the ray's side and lit from the upper left.
fn picture(normal_along: impl Fn(&Ray<DVec3>) -> Option<DVec3>) -> Picture {
    let size = ImageSize::new(280, 210).expect("a picture has pixels");
    let camera = camera(size);
    let lamp = DVec3::new(-0.6, -0.5, 0.62).normalize();
    let mut rgba = Vec::new();
    for pixel in size.pixels_in_file_order() {
        let ray = camera.pixel_ray(size, pixel);
        let Some(normal) = normal_along(&ray) else {
            rgba.extend([0; 4]);
            continue;
        };
        let facing = if normal.dot(ray.direction) > 0.0 {
            -normal
        } else {
            normal
        };
        let light = f64::sqrt(0.2 + 0.8 * facing.dot(lamp).max(0.0));
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and 255"
        )]
        let shaded = Colour::Sky.rgb().map(|c| (f64::from(c) * light) as u8);
        rgba.extend(shaded);
        rgba.push(255);
    }
    Picture {
        width: size.columns(),
        height: size.rows(),
        rgba,
    }
}

fn single(ray: &Ray<DVec3>) -> Ray<Vec3> {
    Ray::new(ray.origin.as_vec3(), ray.direction.as_vec3())
}

/// The picture of triangles within a tolerance: flat, or with the surface's own normals at the interpolated parameters.
fn of_triangles(tolerance: f64, exact_normals: bool) -> Picture {
    use facette::surface::Surface;
    let surface = sheet();
    let tessellation = tessellate(&surface, tolerance).expect("a usable tolerance");
    let mesh = &tessellation.mesh;
    let corners: Vec<[u32; 3]> = mesh.triangles().collect();
    let hierarchy = to_hierarchy(&tessellation).expect("finite corners");
    picture(|ray| {
        let (triangle, hit) = hierarchy.query().nearest_hit(&single(ray))?;
        if !exact_normals {
            return Some(hit.normal.as_dvec3());
        }
        let [v, w] = hit.parameters?;
        let weights = [1.0 - v - w, v, w];
        let [u, v] = parameters_at(mesh, corners[triangle as usize], weights);
        surface.normal_vector(u, v).map(DVec3::normalize)
    })
}

/// What triangles lose, and what normals hide.
pub fn silhouette() -> Figure {
    let pieces = PatchIntersector::pieces_of(&sheet()).expect("a bicubic surface");
    let direct = picture(|ray| nearest(&pieces, ray).map(|(_, hit)| hit.normal));
    let drawing = panels(
        2,
        &[
            Panel::picture("triangles within 0.2", of_triangles(0.2, false)),
            Panel::picture("the same, exact normals", of_triangles(0.2, true)),
            Panel::picture("triangles within 0.002", of_triangles(0.002, true)),
            Panel::picture("the patches themselves", direct),
        ],
    );
    Figure::drawn(
        "silhouette",
        "A B-spline surface met by rays. Triangles within a coarse tolerance show their edges; the surface's normals at the hit's parameters hide them inside, but the silhouette stays a polygon, and so does the shadow it would cast. A \
         tolerance below a pixel, or no triangles at all, has neither.",
        "Four pictures of a humped sheet. The first has visible flat facets, the second a smooth shading but an angular outline, the last two are smooth in both and look alike.",
        &drawing,
    )
}

/// The largest error in t against the number of triangles.
pub fn error_against_triangles() -> Figure {
    let surface = sheet();
    let pieces = PatchIntersector::pieces_of(&surface).expect("a bicubic surface");
    let rays: Vec<Ray<DVec3>> = (0..900)
        .map(|k| {
            let [x, y] = [k % 30, k / 30].map(|i| f64::from(i) / 7.5 - 1.93);
            Ray::new(DVec3::new(x, y, 9.0).as_vec3().as_dvec3(), DVec3::NEG_Z)
        })
        .collect();
    let exact: Vec<f64> = rays
        .iter()
        .map(|ray| nearest(&pieces, ray).expect("above the sheet").1.t)
        .collect();
    let [mut found, mut promised] = [Vec::new(), Vec::new()];
    for halvings in 0..12 {
        let tolerance = 0.4 / f64::from(1 << halvings);
        let tessellation = tessellate(&surface, tolerance).expect("a usable tolerance");
        let hierarchy = to_hierarchy(&tessellation).expect("finite corners");
        let count = hierarchy.triangles().len() as f64;
        let errors = rays.iter().zip(&exact).map(|(ray, exact)| {
            let hit = hierarchy
                .query()
                .nearest(&single(ray))
                .expect("above the sheet");
            (f64::from(hit.hit.t) - exact).abs()
        });
        found.push([count, errors.fold(0.0, f64::max)]);
        promised.push([count, tolerance]);
    }
    let ends = [found[0][0], found[found.len() - 1][0]];
    let bound = exact
        .iter()
        .zip(&rays)
        .map(|(_, ray)| nearest(&pieces, ray).expect("as before").1.t_error);
    let bound = bound.fold(0.0, f64::max);
    let plot = Plot::new("", "triangles", "error in t (units)")
        .log_x()
        .log_y()
        .line("tolerance", &promised)
        .line("triangles, largest error", &found)
        .line("patches, largest bound", &ends.map(|x| [x, bound]))
        .to_drawing()
        .expect("positive errors make a plot");
    Figure::drawn(
        "direct_against_triangles",
        "The largest error in $t$ of 900 vertical rays on the sheet of the pictures. Ten times as many triangles leave a tenth of the error, which is about the tolerance: along a ray the way to the surface is a little longer than the distance. The patches met directly have no triangles; their own bound on \
         the error is eight decades below.",
        "On logarithmic axes two falling lines that nearly coincide, the tolerance and the error of the triangles, and far beneath them a horizontal line, the bound of the patches.",
        &plot,
    )
}

/// De Casteljau at 1/2: both halves of a control polygon.
fn halves(points: &[[f64; 2]]) -> [Vec<[f64; 2]>; 2] {
    let mut rest = points.to_vec();
    let mut lower = vec![rest[0]];
    while rest.len() > lower.len() {
        for i in 0..rest.len() - lower.len() {
            rest[i] = rest[i].lerp(rest[i + 1], 0.5);
        }
        lower.push(rest[0]);
    }
    [lower, rest]
}

/// The net, row by row, halved across v.
fn halves_across_v(net: &[[f64; 2]]) -> [Vec<[f64; 2]>; 2] {
    let mut both = [vec![[0.0; 2]; 16], vec![[0.0; 2]; 16]];
    for i in 0..4 {
        let column: Vec<[f64; 2]> = (0..4).map(|j| net[4 * j + i]).collect();
        for (half, points) in both.iter_mut().zip(halves(&column)) {
            for j in 0..4 {
                half[4 * j + i] = points[j];
            }
        }
    }
    both
}

/// A net and the box around it.
fn drawn_part(net: &[[f64; 2]], is_kept: bool) -> Drawing {
    let colour = if is_kept { Colour::Blue } else { Colour::Faint };
    let at = |[x, y]: [f64; 2]| [180.0 + 34.0 * x, 150.0 - 34.0 * y];
    let range = |axis: usize| {
        let values = net.iter().map(|p| p[axis]);
        [
            values.clone().fold(f64::INFINITY, f64::min),
            values.fold(f64::NEG_INFINITY, f64::max),
        ]
    };
    let ([x0, x1], [y0, y1]) = (range(0), range(1));
    let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(at);
    let mut drawing = Drawing::new(360.0, 300.0)
        .area(&corners, colour, 0.1)
        .outline(&corners, Stroke::new(colour, 1.5).dashes(Dashes::Dashed));
    for k in 0..4 {
        let row: Vec<[f64; 2]> = (0..4).map(|i| at(net[4 * k + i])).collect();
        let column: Vec<[f64; 2]> = (0..4).map(|j| at(net[4 * j + k])).collect();
        for line in [row, column] {
            drawing = drawing.polyline(&line, Stroke::new(colour, 2.0));
        }
    }
    drawing
        .line([0.0, 150.0], [360.0, 150.0], Stroke::new(Colour::Ink, 1.0))
        .line([180.0, 0.0], [180.0, 300.0], Stroke::new(Colour::Ink, 1.0))
        .disc([180.0, 150.0], 6.0, Colour::Vermilion)
        .text([192.0, 172.0], "ray", 16.0, Anchor::Start)
}

/// The patch in the ray's coordinates, halved twice.
pub fn as_the_ray_sees_it() -> Figure {
    let points = (0..16).map(|k| {
        let [i, j] = [f64::from(k % 4), f64::from(k / 4)];
        [
            2.2 * i - 2.5 + 0.3 * j * (j - 3.0) * (1.5 - i),
            1.7 * j - 3.75 - 0.35 * i * (3.0 - i) + 0.3 * i,
        ]
    });
    let net: Vec<[f64; 2]> = points.collect();
    let [lower, upper] = halves_across_v(&net);
    let rows = upper.chunks_exact(4).map(halves);
    let left: Vec<[f64; 2]> = rows.flat_map(|[left, _]| left).collect();
    let drawing = panels(
        2,
        &[
            Panel::drawing("whole patch", drawn_part(&net, true)),
            Panel::drawing("lower half: misses", drawn_part(&lower, false)),
            Panel::drawing("upper half: halve again", drawn_part(&upper, true)),
            Panel::drawing("its left half: certified", drawn_part(&left, true)),
        ],
    );
    Figure::drawn(
        "as_the_ray_sees_it",
        "A bicubic patch along the ray, which is a point. Whatever the patch does, it stays in the box around its control points: a box without the ray needs no second look. A part that is flat enough, so that its net is nearly a parallelogram, has one root at most, and \
         Newton's method finds it.",
        "Four nets of control points in a plane with a dot at the origin, the ray. The box of the whole net holds the dot, that of its lower half does not, those of its upper half and of a quarter do.",
        &drawing,
    )
}
