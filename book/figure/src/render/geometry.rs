//! Triangles to be rendered: given surfaces, and the tubes and balls that draw curves and points.

use glam::DVec3;

/// Triangles over a list of positions, each with its normal and surface parameters where known.
///
/// # Examples
/// ```
/// use facette_figure::render::Triangles;
/// use glam::DVec3;
///
/// let plane = Triangles::grid(8, 8, |u, v| (DVec3::new(u, v, 0.0), DVec3::Z));
/// assert_eq!((plane.positions.len(), plane.triangles.len()), (81, 128));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Triangles {
    /// The vertices.
    pub positions: Vec<DVec3>,
    /// A normal of any length for each vertex, or nothing: the triangles are then flat.
    pub normals: Vec<DVec3>,
    /// The surface parameters u and v of each vertex, or nothing.
    pub parameters: Vec<[f64; 2]>,
    /// Three indices of vertices each.
    pub triangles: Vec<[u32; 3]>,
}

/// Segments around a tube, and meridians of a ball.
const AROUND: u32 = 24;

impl Triangles {
    /// A parametric surface over `[0, 1]²` in `columns` by `rows` cells of two triangles; `surface` gives the point
    /// and the normal at `(u, v)`.
    #[must_use]
    pub fn grid<F>(columns: u32, rows: u32, surface: F) -> Self
    where
        F: Fn(f64, f64) -> (DVec3, DVec3),
    {
        let mut mesh = Self::default();
        for row in 0..=rows {
            for column in 0..=columns {
                let (u, v) = (
                    f64::from(column) / f64::from(columns),
                    f64::from(row) / f64::from(rows),
                );
                let (position, normal) = surface(u, v);
                mesh.positions.push(position);
                mesh.normals.push(normal);
                mesh.parameters.push([u, v]);
            }
        }
        mesh.add_cells(columns, rows);
        mesh
    }

    /// The triangles of a grid of `columns` by `rows` cells whose vertices are listed row by row.
    fn add_cells(&mut self, columns: u32, rows: u32) {
        for row in 0..rows {
            for column in 0..columns {
                let a = row * (columns + 1) + column;
                let (b, c, d) = (a + 1, a + columns + 2, a + columns + 1);
                self.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }

    /// A ball around `centre`.
    #[must_use]
    pub fn ball(centre: DVec3, radius: f64) -> Self {
        let mut ball = Self::grid(AROUND, AROUND / 2, |u, v| {
            let ((cos_u, sin_u), (cos_v, sin_v)) = (cos_sin(u), cos_sin(v / 2.0));
            let normal = DVec3::new(sin_v * cos_u, sin_v * sin_u, cos_v);
            (centre + radius * normal, normal)
        });
        ball.parameters.clear();
        ball
    }

    /// A tube of this radius around a polyline, without its ends. Repeated points count once; fewer than two distinct
    /// points give nothing.
    #[must_use]
    pub fn tube(polyline: &[DVec3], radius: f64) -> Self {
        let mut points = polyline.to_vec();
        points.dedup();
        let rows = u32::try_from(points.len())
            .unwrap_or(u32::MAX)
            .saturating_sub(1);
        let mut tube = Self::default();
        if rows == 0 {
            return tube;
        }
        let mut side = DVec3::ZERO;
        for (index, &point) in points.iter().enumerate() {
            let tangent = tangent(&points, index);
            // The frame is carried along the curve by projection, so that the tube does not twist.
            side = (side - side.dot(tangent) * tangent)
                .try_normalize()
                .unwrap_or_else(|| tangent.any_orthonormal_vector());
            let other = tangent.cross(side);
            for step in 0..=AROUND {
                let (cos, sin) = cos_sin(f64::from(step) / f64::from(AROUND));
                let normal = cos * side + sin * other;
                tube.positions.push(point + radius * normal);
                tube.normals.push(normal);
            }
        }
        tube.add_cells(AROUND, rows);
        tube
    }
}

/// The unit tangent of a polyline without repeated points: the mean of the directions before and after.
fn tangent(points: &[DVec3], index: usize) -> DVec3 {
    let direction = |from: usize, to: usize| (points[to] - points[from]).normalize_or_zero();
    let before = if index > 0 {
        direction(index - 1, index)
    } else {
        DVec3::ZERO
    };
    let after = if index + 1 < points.len() {
        direction(index, index + 1)
    } else {
        DVec3::ZERO
    };
    (before + after)
        .try_normalize()
        .unwrap_or(if index > 0 { before } else { after })
}

/// The cosine and sine of an angle in full turns, by plain arithmetic, so that the bits are the same on every machine.
///
/// The angle is brought to at most 1/8 turn, where the Taylor series to the 17th power is exact to rounding.
pub(crate) fn cos_sin(turns: f64) -> (f64, f64) {
    let quarters = (4.0 * turns).round();
    let angle = (turns - quarters / 4.0) * std::f64::consts::TAU;
    let (mut cos, mut sin, mut term) = (1.0, angle, angle);
    for power in 2..=17 {
        term = term * angle / f64::from(power);
        let sign = if power % 4 < 2 { 1.0 } else { -1.0 };
        if power % 2 == 0 {
            cos += sign * term;
        } else {
            sin += sign * term;
        }
    }
    match quarters.rem_euclid(4.0) {
        quarter if quarter < 0.5 => (cos, sin),
        quarter if quarter < 1.5 => (-sin, cos),
        quarter if quarter < 2.5 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[allow(clippy::float_cmp, reason = "rounded to whole numbers")]
    fn cosine_and_sine_are_right_to_a_few_roundings() {
        for step in -400..=400 {
            let turns = f64::from(step) / 160.0;
            let (cos, sin) = cos_sin(turns);
            let angle = turns * std::f64::consts::TAU;
            // The angle handed to the standard functions is itself rounded: half a unit of an angle up to 16.
            let bound = 10.0 * f64::EPSILON;
            assert!((cos - angle.cos()).abs() <= bound, "cos {turns}");
            assert!((sin - angle.sin()).abs() <= bound, "sin {turns}");
        }
        assert_eq!(
            [0.0, 0.25, 0.5, 0.75].map(|turns| cos_sin(turns).0.round()),
            [1.0, 0.0, -1.0, 0.0]
        );
    }

    #[test]
    fn every_point_of_a_straight_tube_lies_at_the_radius_from_its_line() {
        let line: Vec<_> = (0..5)
            .map(|step| DVec3::new(1.0, 2.0, f64::from(step)))
            .collect();
        let tube = Triangles::tube(&line, 0.25);
        for position in &tube.positions {
            let distance = (*position - DVec3::new(1.0, 2.0, position.z)).length();
            assert!((distance - 0.25).abs() <= 8.0 * f64::EPSILON, "{distance}");
        }
    }

    #[test]
    fn tubes_survive_corners_turns_back_and_repeated_points() {
        let (a, b) = (DVec3::ZERO, DVec3::X);
        for line in [
            vec![a, b, a],
            vec![a, a, b, b],
            vec![a, b, b + DVec3::Y, b + DVec3::Z],
        ] {
            let tube = Triangles::tube(&line, 0.1);
            assert!(!tube.triangles.is_empty());
            assert!(tube.positions.iter().all(|position| position.is_finite()));
        }
        assert_eq!(Triangles::tube(&[a, a], 0.1), Triangles::default());
        assert_eq!(Triangles::tube(&[], 0.1), Triangles::default());
    }

    #[test]
    fn every_triangle_of_a_ball_faces_outwards() {
        let centre = DVec3::new(3.0, -1.0, 2.0);
        let ball = Triangles::ball(centre, 0.5);
        for corners in &ball.triangles {
            let [a, b, c] = corners.map(|corner| ball.positions[corner as usize]);
            let outward = (b - a).cross(c - a).dot(a - centre);
            // At the poles triangles collapse; elsewhere the grid runs with the meridians downwards.
            assert!(outward <= 1e-15, "{outward}");
        }
    }
}
