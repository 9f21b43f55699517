//! How a surface looks: matte colour, lines of constant parameter, and the patterns that show its smoothness.

use glam::DVec3;

use super::colour::decode;
use crate::palette::Colour;

/// How a surface looks, on both of its sides.
///
/// Stripes are computed from the normal at every sample, never across two surfaces: where two patches meet with
/// different tangent planes the stripes break.
///
/// # Examples
/// ```
/// use facette_figure::palette::Colour;
/// use facette_figure::render::Material;
/// use glam::DVec3;
///
/// let patch = Material::matte(Colour::Sky).isolines(8);
/// let smoothness = Material::isophotes(Colour::Blue, DVec3::Z, 24);
/// assert_ne!(patch, smoothness);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    colour: Colour,
    pattern: Pattern,
    isolines: u32,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Pattern {
    Matte,
    Isophotes {
        direction: DVec3,
        stripes: u32,
    },
    ReflectionLines {
        along: DVec3,
        across: DVec3,
        stripes: u32,
    },
    Normals,
}

/// What is known about one point of a surface, for its shading.
pub(super) struct Sample {
    /// The unit normal, on whichever side the surface has it.
    pub normal: DVec3,
    /// The unit vector towards the eye.
    pub to_eye: DVec3,
    /// The parameters u and v, each with the length of its gradient over the picture, per pixel.
    pub parameters: Option<[(f64, f64); 2]>,
    /// Half the width of an isoparametric line, in pixels.
    pub half_line: f64,
}

impl Material {
    /// A matte surface of this colour.
    #[must_use]
    pub fn matte(colour: Colour) -> Self {
        Self {
            colour,
            pattern: Pattern::Matte,
            isolines: 0,
        }
    }

    /// Stripes whose edges are isophotes, the lines of constant `normal · direction`: as many stripes as given from −1
    /// to 1. Two smooth patches meet with a continuous tangent plane exactly when every isophote is continuous.
    #[must_use]
    pub fn isophotes(colour: Colour, direction: DVec3, stripes: u32) -> Self {
        let direction = direction.normalize_or_zero();
        Self {
            colour,
            pattern: Pattern::Isophotes { direction, stripes },
            isolines: 0,
        }
    }

    /// The mirror image of `stripes` parallel stripes of light (rounded up to an even number) all around, which run
    /// along a direction far away. A kink of the surface breaks them.
    #[must_use]
    pub fn reflection_lines(colour: Colour, along: DVec3, stripes: u32) -> Self {
        let along = along.try_normalize().unwrap_or(DVec3::Z);
        let across = along.any_orthonormal_vector();
        let stripes = stripes.next_multiple_of(2);
        Self {
            colour,
            pattern: Pattern::ReflectionLines {
                along,
                across,
                stripes,
            },
            isolines: 0,
        }
    }

    /// Each coordinate of the normal as a colour: −1 to 1 in x, y, z becomes none to full in red, green, blue.
    #[must_use]
    pub fn normals() -> Self {
        Self {
            colour: Colour::Ink,
            pattern: Pattern::Normals,
            isolines: 0,
        }
    }

    /// The same material with the lines where u or v is a multiple of `1/n`; 0 means none.
    #[must_use]
    pub fn isolines(self, n: u32) -> Self {
        Self {
            isolines: n,
            ..self
        }
    }

    /// The linear colour of one point in the light from these directions.
    pub(super) fn shade(&self, sample: &Sample, lights: [DVec3; 2]) -> DVec3 {
        let base = linear(self.colour);
        let colour = match self.pattern {
            Pattern::Matte => base,
            Pattern::Normals => return sample.normal.midpoint(DVec3::ONE),
            Pattern::Isophotes { direction, stripes } => {
                let height = f64::midpoint(sample.normal.dot(direction), 1.0);
                striped(base, height * f64::from(stripes))
            }
            Pattern::ReflectionLines {
                along,
                across,
                stripes,
            } => {
                let (normal, to_eye) = (sample.normal, sample.to_eye);
                let mirrored = 2.0 * normal.dot(to_eye) * normal - to_eye;
                let angle = turn(mirrored.dot(across), mirrored.dot(along.cross(across)));
                striped(base, angle * f64::from(stripes))
            }
        };
        let lit = colour * illumination(sample, lights);
        if self.is_on_isoline(sample) {
            0.3 * lit
        } else {
            lit
        }
    }

    fn is_on_isoline(&self, sample: &Sample) -> bool {
        let Some(parameters) = sample.parameters.filter(|_| self.isolines > 0) else {
            return false;
        };
        let n = f64::from(self.isolines);
        parameters.iter().any(|&(parameter, gradient)| {
            let nearest = (parameter * n).round() / n;
            (parameter - nearest).abs() < sample.half_line * gradient
        })
    }
}

fn linear(colour: Colour) -> DVec3 {
    DVec3::from_array(colour.rgb().map(decode))
}

/// The colour in every other interval between integers, and a pale tint of it in those between.
fn striped(colour: DVec3, position: f64) -> DVec3 {
    let is_odd = position.floor().rem_euclid(2.0) > 0.5;
    if is_odd {
        colour.lerp(DVec3::ONE, 0.75)
    } else {
        colour
    }
}

/// A monotone measure of the direction (x, y), 0 to 1 around the circle, without inverse trigonometry: the position on
/// the square |x| + |y| = 1.
fn turn(x: f64, y: f64) -> f64 {
    let around = y / (x.abs() + y.abs());
    let quarters = if x >= 0.0 { around } else { 2.0 - around };
    quarters.rem_euclid(4.0) / 4.0
}

/// Ambient, key and fill light, which hang at the camera: the same for both sides of the surface.
fn illumination(sample: &Sample, [key, fill]: [DVec3; 2]) -> f64 {
    let facing = sample.normal.dot(sample.to_eye) >= 0.0;
    let normal = if facing {
        sample.normal
    } else {
        -sample.normal
    };
    let lambert = |light: DVec3| normal.dot(light).max(0.0);
    0.22 + 0.78 * lambert(key) + 0.2 * lambert(fill)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::geometry::cos_sin;

    #[test]
    fn turn_grows_all_the_way_around_the_circle() {
        let mut before = -1.0;
        for step in 0..360 {
            let (cos, sin) = cos_sin(f64::from(step) / 360.0);
            let now = turn(cos, sin);
            assert!(now > before && now < 1.0, "{step}: {now} after {before}");
            before = now;
        }
    }

    #[test]
    fn stripes_change_at_integers_below_zero_too() {
        let colour = DVec3::ZERO;
        let is_pale = |position| striped(colour, position) != colour;
        assert_eq!(
            [-1.5, -0.5, 0.5, 1.5].map(is_pale),
            [false, true, false, true]
        );
    }

    #[test]
    fn an_odd_number_of_reflected_stripes_is_made_even_so_that_they_close() {
        let odd = Material::reflection_lines(Colour::Blue, DVec3::X, 7);
        assert_eq!(odd, Material::reflection_lines(Colour::Blue, DVec3::X, 8));
    }
}
