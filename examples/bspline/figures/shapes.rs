//! The surfaces that the figures show, and how they are cut, coloured and seen.

use facette::bspline::{BsplineSurface, Direction, KnotVector};
use facette::mesh::{Mesh, tessellate_uniformly};
use facette_figure::palette::Colour;
use facette_figure::render::{Scene, View};
use facette_figure::svg::{Anchor, Drawing, Stroke};

use glam::DVec3;

/// A surface in space.
pub type Surface = BsplineSurface<DVec3>;

/// A point from its coordinates.
pub fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The knot vector of this degree with these knots.
pub fn knot_vector(degree: usize, knots: &[f64]) -> KnotVector<f64> {
    KnotVector::new(degree, knots.to_vec()).expect("the figures' knots are valid")
}

/// The knot vector on `[0, end]` with these inner knots, its ends repeated `degree + 1` times.
pub fn clamped(degree: usize, inner: &[f64], end: f64) -> KnotVector<f64> {
    let breaks: Vec<f64> = [0.0].iter().chain(inner).chain(&[end]).copied().collect();
    KnotVector::clamped(degree, &breaks).expect("the figures' knots are valid")
}

/// The slides' first knot vectors: degrees 3 and 2, seven functions in u and eight in v, of which 3/5 is a double knot.
pub fn slide_15() -> [KnotVector<f64>; 2] {
    let (u, v) = (
        [0., 0., 0., 0., 0.25, 0.5, 0.75, 1., 1., 1., 1.],
        [0., 0., 0., 0.2, 0.4, 0.6, 0.6, 0.8, 1., 1., 1.],
    );
    [knot_vector(3, &u), knot_vector(2, &v)]
}

/// The surface with the control point `place(i, j)` at each place of the net.
pub fn surface(knots: [KnotVector<f64>; 2], place: impl Fn(usize, usize) -> DVec3) -> Surface {
    let [columns, rows] = knots.each_ref().map(KnotVector::control_point_count);
    let points = (0..rows).flat_map(|j| (0..columns).map(move |i| [i, j]));
    let points = points.map(|[i, j]| place(i, j)).collect();
    BsplineSurface::new(knots, points).expect("the figures' points are finite and fit the knots")
}

/// The smaller net of slides 18 and 20: degrees 3 and 2, five by five points, two by three spans.
pub fn five_by_five() -> Surface {
    const HEIGHTS: [[f64; 5]; 5] = [
        [0.0, 0.6, 1.2, 0.5, 0.0],
        [0.3, 1.5, 1.0, -0.3, 0.2],
        [0.9, 1.9, 0.6, -0.7, 0.6],
        [0.6, 0.9, 0.4, 0.3, 1.2],
        [0.0, 0.2, 0.8, 1.1, 0.7],
    ];
    let knots = [
        knot_vector(3, &[0., 0., 0., 0., 1., 2., 2., 2., 2.]),
        knot_vector(2, &[0., 0., 0., 1., 2., 3., 3., 3.]),
    ];
    surface(knots, |i, j| at(i as f64, j as f64, HEIGHTS[j][i]))
}

/// The larger net of slide 18: degrees 3 and 2, nine by nine points, six by seven spans; a hill and a hollow.
pub fn nine_by_nine() -> Surface {
    let knots = [
        clamped(3, &[1., 2., 3., 4., 5.], 6.0),
        clamped(2, &[1., 2., 3., 4., 5., 6.], 7.0),
    ];
    let bell = |x: f64, y: f64| 1.0 / (1.0 + 0.25 * (x * x + y * y));
    surface(knots, |i, j| {
        let (x, y) = (i as f64, j as f64);
        let height = 3.6 * bell(x - 2.6, y - 4.6) - 2.2 * bell(x - 6.4, y - 2.4);
        at(x, y, height)
    })
}

/// One Bézier patch of a surface as a mesh, and which it is: `[column, row]` among the spans.
pub struct Piece {
    /// The number of the span in u and in v, from 0.
    pub span: [usize; 2],
    /// Its parameters.
    pub domain: [[f64; 2]; 2],
    /// Its triangles; the normals are those of this patch alone, so that a crease stays sharp.
    pub mesh: Mesh<DVec3>,
}

/// All patches of a surface, each cut into `cells` by `cells`.
pub fn pieces(surface: &Surface, cells: usize) -> Vec<Piece> {
    let [us, vs] = surface.breaks();
    let number = |breaks: &[f64], start: f64| breaks.partition_point(|&knot| knot < start);
    let patches = surface.bezier_patches().into_iter();
    let piece = |patch: facette::bspline::BezierPatch<DVec3>| {
        let [[u, _], [v, _]] = patch.domain;
        Piece {
            span: [number(&us, u), number(&vs, v)],
            domain: patch.domain,
            mesh: tessellate_uniformly(&patch_surface(patch), cells, cells)
                .expect("the figures' surfaces are finite"),
        }
    };
    patches.map(piece).collect()
}

/// A Bézier patch as a surface over its own parameters.
fn patch_surface(patch: facette::bspline::BezierPatch<DVec3>) -> Surface {
    let [u, v] = [0, 1].map(|which| {
        KnotVector::bezier(patch.degrees[which])
            .reparametrised(patch.domain[which])
            .expect("a span is not empty")
    });
    BsplineSurface::new([u, v], patch.control_points).expect("a patch has points for its degrees")
}

/// A picture of a scene, to be drawn over.
pub struct Photo {
    /// The picture, and what has been drawn over it.
    pub drawing: Drawing,
    view: View,
    size: [u32; 2],
}

impl Photo {
    /// The picture of a scene, of this size in units of the drawing, two pixels for each.
    pub fn new(scene: &Scene, size: [u32; 2]) -> Self {
        let [width, height] = size;
        let picture = scene.render(2 * width, 2 * height);
        let extent = size.map(f64::from);
        Self {
            drawing: Drawing::new(extent[0], extent[1]).picture([0.0; 2], extent, &picture),
            view: *scene.view(),
            size,
        }
    }

    /// Where a point of the scene lies in the drawing.
    pub fn place(&self, point: DVec3) -> [f64; 2] {
        let [width, height] = self.size;
        let place = self.view.project(point, width, height);
        place.expect("a parallel projection sees every point")
    }

    /// The same with polylines of the scene over the picture, so that none of them is hidden, each in a halo.
    pub fn polylines(mut self, lines: &[Vec<DVec3>], stroke: Stroke) -> Self {
        let lines: Vec<Vec<_>> = lines
            .iter()
            .map(|line| line.iter().map(|&point| self.place(point)).collect())
            .collect();
        let halo = Stroke::new(Colour::Page, stroke.width + 2.2);
        for look in [halo, stroke] {
            for line in &lines {
                self.drawing = self.drawing.polyline(line, look);
            }
        }
        self
    }

    /// The same with a disc in a halo at each of these points of the scene.
    pub fn discs(mut self, points: &[DVec3], radius: f64, colour: Colour) -> Self {
        let halo = radius + 1.2;
        for &point in points {
            let place = self.place(point);
            self.drawing = self
                .drawing
                .disc(place, halo, Colour::Page)
                .disc(place, radius, colour);
        }
        self
    }

    /// The same with the control net of a surface over the picture.
    pub fn net(self, surface: &Surface, stroke: Stroke) -> Self {
        let [columns, rows] = net_size(surface);
        let along_u = (0..rows).map(|j| row(surface, j));
        let along_v = (0..columns).map(|i| column(surface, i));
        let lines: Vec<_> = along_u.chain(along_v).collect();
        self.polylines(&lines, stroke).discs(
            surface.control_points(),
            2.3 * stroke.width,
            stroke.colour,
        )
    }

    /// The same with a text beside a point of the scene.
    pub fn text(mut self, point: DVec3, [right, down]: [f64; 2], text: &str, size: f64) -> Self {
        let [x, y] = self.place(point);
        let at = [x + right, y + down];
        self.drawing = self.drawing.haloed_text(at, text, size, Anchor::Middle);
        self
    }
}

/// A column of the control net: the points P_ij of one i.
pub fn column(surface: &Surface, i: usize) -> Vec<DVec3> {
    let [_, rows] = net_size(surface);
    (0..rows).map(|j| surface.control_point(i, j)).collect()
}

/// A row of the control net: the points P_ij of one j.
pub fn row(surface: &Surface, j: usize) -> Vec<DVec3> {
    let [columns, _] = net_size(surface);
    (0..columns).map(|i| surface.control_point(i, j)).collect()
}

/// The number of control points in u and in v.
pub fn net_size(surface: &Surface) -> [usize; 2] {
    [Direction::U, Direction::V].map(|direction| surface.knots(direction).control_point_count())
}

/// A parameter as text: a quarter or a fifth as a fraction, a whole number as it is.
pub fn knot_text(knot: f64) -> String {
    for denominator in [1_u8, 2, 4, 5] {
        let numerator = knot * f64::from(denominator);
        if (numerator - numerator.round()).abs() <= f64::EPSILON * numerator.abs() {
            return match denominator {
                1 => format!("{numerator:.0}"),
                _ => format!("{numerator:.0}/{denominator}"),
            };
        }
    }
    format!("{knot}")
}
