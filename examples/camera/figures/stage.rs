//! A stage: a camera of the library, and a drawing on which it projects lines of space.

use facette::camera::{Camera, CameraFrame, ImageRectangle, ImageSize};
use facette_figure::svg::{Anchor, Drawing, Stroke};
use glam::DVec3;

/// A point from its coordinates.
pub fn at(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// The frame of a view with z up.
pub fn looking(eye: DVec3, target: DVec3) -> CameraFrame<DVec3> {
    CameraFrame::looking_at(eye, target, DVec3::Z).expect("no figure looks straight up")
}

/// A drawing in space.
pub struct Stage {
    camera: Camera<DVec3>,
    size: ImageSize,
    /// What has been drawn.
    pub drawing: Drawing,
}

impl Stage {
    /// An empty stage of this size in pixels, seen by a camera.
    pub fn new(camera: Camera<DVec3>, width: u32, height: u32) -> Self {
        let size = ImageSize::new(width, height).expect("a figure has pixels");
        Self {
            camera,
            size,
            drawing: Drawing::new(f64::from(width), f64::from(height)),
        }
    }

    /// An empty stage seen by parallel rays, `height` units of the scene high.
    pub fn parallel(frame: CameraFrame<DVec3>, height: f64, [width, pixels]: [u32; 2]) -> Self {
        let aspect = f64::from(width) / f64::from(pixels);
        let rectangle = ImageRectangle::centred(aspect * height, height).expect("an extent");
        Self::new(Camera::orthographic(frame, rectangle), width, pixels)
    }

    /// Where a point appears, in the units of the drawing.
    ///
    /// # Panics
    ///
    /// For a point that the camera does not see in front of it: the figures have none.
    pub fn place(&self, point: DVec3) -> [f64; 2] {
        let place = self.camera.position_in_file(self.size, point);
        place.expect("the figures draw what is in front of the camera")
    }

    /// Adds a polyline.
    pub fn line(mut self, points: &[DVec3], stroke: Stroke) -> Self {
        let places: Vec<_> = points.iter().map(|&point| self.place(point)).collect();
        self.drawing = self.drawing.polyline(&places, stroke);
        self
    }

    /// Adds a closed polygon's outline.
    pub fn outline(self, points: &[DVec3], stroke: Stroke) -> Self {
        let closed: Vec<_> = points.iter().chain(points.first()).copied().collect();
        self.line(&closed, stroke)
    }

    /// Adds a filled polygon.
    pub fn area(mut self, points: &[DVec3], stroke: Stroke, opacity: f64) -> Self {
        let places: Vec<_> = points.iter().map(|&point| self.place(point)).collect();
        self.drawing = self.drawing.area(&places, stroke.colour, opacity);
        self
    }

    /// Adds an arrow.
    pub fn arrow(mut self, from: DVec3, to: DVec3, stroke: Stroke) -> Self {
        let [from, to] = [self.place(from), self.place(to)];
        self.drawing = self.drawing.arrow(from, to, stroke);
        self
    }

    /// Adds a disc.
    pub fn disc(mut self, point: DVec3, radius: f64, stroke: Stroke) -> Self {
        let place = self.place(point);
        self.drawing = self.drawing.disc(place, radius, stroke.colour);
        self
    }

    /// Adds a text beside a point, moved to the right and down.
    pub fn label(mut self, point: DVec3, moved: [f64; 2], text: &str, stroke: Stroke) -> Self {
        let [x, y] = self.place(point);
        let baseline = [x + moved[0], y + moved[1]];
        let anchor = Anchor::Middle;
        self.drawing = self
            .drawing
            .coloured_text(baseline, text, 18.0, anchor, stroke.colour);
        self
    }
}

/// The twelve edges of a box, as pairs of corners.
pub fn box_edges(low: DVec3, high: DVec3) -> Vec<[DVec3; 2]> {
    let corner = |bits: usize| {
        let pick = |axis: usize| {
            if bits >> axis & 1 == 0 {
                low[axis]
            } else {
                high[axis]
            }
        };
        at(pick(0), pick(1), pick(2))
    };
    (0..8)
        .flat_map(|bits| (0..3).map(move |axis| (bits, axis)))
        .filter(|(bits, axis)| bits >> axis & 1 == 0)
        .map(|(bits, axis)| [corner(bits), corner(bits | 1 << axis)])
        .collect()
}
