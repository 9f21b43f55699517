//! Reads one B-spline surface from the free-form statements of an OBJ file.
//!
//! ```text
//! v x y z                        the control points
//! cstype bspline
//! deg p q
//! surf u0 u1 v0 v1 1 2 3 ...     the domain, then the control points' numbers, u running fastest
//! parm u ...                     all knots in u; likewise parm v
//! end
//! ```

use facette::bspline::{BsplineSurface, KnotVector};
use facette::surface::Surface;
use glam::DVec3;

/// A statement that is not understood, or does not fit: the message begins with the file and the line.
fn fail<T>(file: &str, line: usize, what: impl std::fmt::Display) -> Result<T, String> {
    Err(format!("{file}:{line}: {what}"))
}

/// What the statements so far have said.
#[derive(Default)]
struct Found {
    points: Vec<DVec3>,
    degrees: Option<[usize; 2]>,
    surface: Option<([[f64; 2]; 2], Vec<usize>)>,
    knots: [Option<Vec<f64>>; 2],
}

/// The surface in the text of a file, whose name is for the messages.
pub fn parse(file: &str, text: &str) -> Result<BsplineSurface<DVec3>, String> {
    let mut found = Found::default();
    for (line, statement) in statements(text) {
        let words: Vec<&str> = statement.split_whitespace().collect();
        let understood = found.read(&words);
        understood.or_else(|what| fail(file, line, format!("{what} in \"{statement}\"")))?;
    }
    found.build(file)
}

/// The lines without comments, continued ones joined, each with its number.
fn statements(text: &str) -> Vec<(usize, String)> {
    let mut statements: Vec<(usize, String)> = Vec::new();
    let mut continues = false;
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim();
        let (part, goes_on) = line
            .strip_suffix('\\')
            .map_or((line, false), |part| (part, true));
        match statements.last_mut() {
            Some((_, last)) if continues => {
                last.push(' ');
                last.push_str(part);
            }
            _ => statements.push((index + 1, part.to_owned())),
        }
        continues = goes_on;
    }
    statements.retain(|(_, statement)| !statement.trim().is_empty());
    statements
}

/// All words as finite numbers.
fn numbers(words: &[&str]) -> Result<Vec<f64>, String> {
    let number = |word: &&str| {
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| format!("\"{word}\" is not a finite number"))
    };
    words.iter().map(number).collect()
}

impl Found {
    fn read(&mut self, words: &[&str]) -> Result<(), String> {
        match words {
            ["v", rest @ ..] => match numbers(rest)?[..] {
                [x, y, z] => self.points.push(DVec3::new(x, y, z)),
                _ => return Err("expected three numbers x y z".to_owned()),
            },
            ["cstype", "bspline"] => {}
            ["cstype", ..] => return Err("expected cstype bspline, without weights".to_owned()),
            ["deg", p, q] => {
                let degrees = [p, q].map(|word| word.parse::<usize>());
                let [Ok(p), Ok(q)] = degrees else {
                    return Err("expected two degrees".to_owned());
                };
                self.degrees = Some([p, q]);
            }
            ["deg", ..] => return Err("expected two degrees, of a surface".to_owned()),
            ["surf", ..] if self.surface.is_some() => {
                return Err("a second surface: expected one in the file".to_owned());
            }
            ["surf", rest @ ..] => self.read_surface(rest)?,
            ["parm", direction @ ("u" | "v"), rest @ ..] => {
                let place = &mut self.knots[usize::from(*direction == "v")];
                *place = Some(numbers(rest)?);
            }
            ["parm", ..] => return Err("expected parm u or parm v".to_owned()),
            // What else an OBJ file may say does not concern the surface.
            _ => {}
        }
        Ok(())
    }

    fn read_surface(&mut self, words: &[&str]) -> Result<(), String> {
        if words.len() < 5 {
            return Err("expected u0 u1 v0 v1 and the numbers of the control points".to_owned());
        }
        let (domain, points) = words.split_at(4);
        let domain = numbers(domain)?;
        let count = self.points.len();
        let index = |word: &&str| {
            let number = word.split('/').next().unwrap_or_default().parse::<i64>();
            let number = number.map_err(|_| format!("\"{word}\" is no number of a vertex"))?;
            let from_start = if number < 0 {
                i64::try_from(count).unwrap_or(i64::MAX) + number
            } else {
                number - 1
            };
            let index = usize::try_from(from_start)
                .ok()
                .filter(|&index| index < count);
            index.ok_or_else(|| {
                format!("vertex {number} is out of range: {count} vertices come before")
            })
        };
        let points = points.iter().map(index).collect::<Result<_, _>>()?;
        self.surface = Some(([[domain[0], domain[1]], [domain[2], domain[3]]], points));
        Ok(())
    }

    fn build(self, file: &str) -> Result<BsplineSurface<DVec3>, String> {
        let Some((domain, indices)) = self.surface else {
            return Err(format!(
                "{file}: there is no surface in it (a line \"surf u0 u1 v0 v1 1 2 3 ...\")"
            ));
        };
        let Some([p, q]) = self.degrees else {
            return Err(format!(
                "{file}: the degrees are missing (a line \"deg p q\")"
            ));
        };
        let [Some(u), Some(v)] = self.knots else {
            return Err(format!(
                "{file}: the knots are missing (lines \"parm u ...\" and \"parm v ...\")"
            ));
        };
        let named = |direction: &str, degree, knots| {
            KnotVector::new(degree, knots)
                .map_err(|error| format!("{file}: parm {direction}: {error}"))
        };
        let knots = [named("u", p, u)?, named("v", q, v)?];
        let points = indices
            .into_iter()
            .map(|index| self.points[index])
            .collect();
        let surface =
            BsplineSurface::new(knots, points).map_err(|error| format!("{file}: surf: {error}"))?;
        if surface.domain() != domain {
            return Err(format!(
                "{file}: surf: the domain is {domain:?}, but the knots say {:?}: a part of a surface is not read",
                surface.domain()
            ));
        }
        Ok(surface)
    }
}
