//! What the command line asks for.

use std::path::PathBuf;

use facette::subdivision::Corners;

use super::figures::scheme::Scheme;

pub const USAGE: &str = "usage: subdivision [CAGE.obj --scheme catmull-clark|doo-sabin|loop|sqrt3 --levels NUMBER [--out FINE.obj] [--picture FINE.png] \
     [--corners sharp|smooth] [--limit] [--triangulate] [--repair]]";

/// A cage to subdivide, and what to make of it.
#[derive(Debug)]
pub struct Request {
    /// The file of the cage.
    pub cage: PathBuf,
    pub scheme: Scheme,
    pub levels: u32,
    /// Where the refined mesh goes.
    pub out: Option<PathBuf>,
    /// Where its picture goes.
    pub picture: Option<PathBuf>,
    pub corners: Corners,
    /// Whether the vertices are moved onto the limit surface.
    pub limit: bool,
    /// Whether faces are cut into triangles first.
    pub triangulate: bool,
    /// Whether what is no manifold is cut open first.
    pub repair: bool,
}

impl Request {
    /// The request in the arguments, which may come in any order.
    pub fn parse(arguments: &[String]) -> Result<Self, String> {
        let (mut cage, mut scheme, mut levels) = (None, None, None);
        let (mut out, mut picture, mut corners) = (None, None, Corners::Sharp);
        let [mut limit, mut triangulate, mut repair] = [false; 3];
        let mut rest = arguments.iter().map(String::as_str);
        while let Some(argument) = rest.next() {
            let mut value = || {
                let value = rest.next().filter(|value| !value.starts_with("--"));
                value.ok_or_else(|| format!("nothing follows {argument}; {USAGE}"))
            };
            match argument {
                "--scheme" => scheme = Some(scheme_named(value()?)?),
                "--levels" => levels = Some(level_count(value()?)?),
                "--out" => out = Some(path_ending(value()?, "obj")?),
                "--picture" => picture = Some(path_ending(value()?, "png")?),
                "--corners" => corners = corners_named(value()?)?,
                "--limit" => limit = true,
                "--triangulate" => triangulate = true,
                "--repair" => repair = true,
                option if option.starts_with('-') => {
                    return Err(format!("there is no option {option}; {USAGE}"));
                }
                file if cage.is_none() => cage = Some(PathBuf::from(file)),
                second => return Err(format!("one cage at a time, not {second} too; {USAGE}")),
            }
        }
        if out.is_none() && picture.is_none() {
            return Err(format!(
                "--out or --picture must say what to write; {USAGE}"
            ));
        }
        let missing = |what: &str| format!("{what} is missing; {USAGE}");
        Ok(Self {
            cage: cage.ok_or_else(|| missing("the cage's file"))?,
            scheme: scheme.ok_or_else(|| missing("--scheme"))?,
            levels: levels.ok_or_else(|| missing("--levels"))?,
            out,
            picture,
            corners,
            limit,
            triangulate,
            repair,
        })
    }
}

fn scheme_named(name: &str) -> Result<Scheme, String> {
    match name {
        "catmull-clark" => Ok(Scheme::CatmullClark),
        "doo-sabin" => Ok(Scheme::DooSabin),
        "loop" => Ok(Scheme::Loop),
        "sqrt3" => Ok(Scheme::Sqrt3),
        _ => Err(format!(
            "there is no scheme {name}: it must be catmull-clark, doo-sabin, loop or sqrt3"
        )),
    }
}

fn corners_named(name: &str) -> Result<Corners, String> {
    match name {
        "sharp" => Ok(Corners::Sharp),
        "smooth" => Ok(Corners::Smooth),
        _ => Err(format!("corners are sharp or smooth, not {name}")),
    }
}

fn level_count(word: &str) -> Result<u32, String> {
    word.parse()
        .map_err(|_| format!("--levels takes a whole number from 0, not {word}"))
}

fn path_ending(word: &str, extension: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(word);
    if path.extension().is_some_and(|found| found == extension) {
        return Ok(path);
    }
    Err(format!("{word}: the name must end in .{extension}"))
}
