//! What stands beside the pages: drawings, pictures, the font of the formulas.

use crate::expand::{figure_mark, one_line};
use crate::figures::ChapterFigure;
use crate::markdown::escape;
use anyhow::{Context, Result, ensure};
use facette_figure::Content;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The font's name inside its file.
const FONT: &str = "NewCMMath-Regular";
/// The crate that carries the font, and its licence in a file of this name.
const CARRIER: (&str, &str) = ("typst-assets", "NOTICE");

/// Width and height of a PNG file, from its first chunk.
#[must_use]
pub fn png_size(bytes: &[u8]) -> Option<(u32, u32)> {
    let header = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    let chunk = header.get(4..)?.strip_prefix(b"IHDR")?;
    let number = |at: usize| Some(u32::from_be_bytes(chunk.get(at..at + 4)?.try_into().ok()?));
    Some((number(0)?, number(4)?))
}

/// Where the picture `coons::name` stands, relative to the book's root.
#[must_use]
pub fn picture_path(path: &str) -> String {
    format!("figures/{}.png", path.replace("::", "/"))
}

/// Puts the drawings into a written page, in place of their marks.
#[must_use]
pub fn inline_drawings(html: &str, figures: &[ChapterFigure]) -> String {
    let mut html = html.to_owned();
    for found in figures {
        let Content::Svg(svg) = &found.figure.content else {
            continue;
        };
        let path = format!("{}::{}", found.chapter, found.figure.name);
        let mark = figure_mark(&path);
        if html.contains(&mark) {
            let prefix = format!("{}-{}-", found.chapter, found.figure.name);
            html = html.replace(&mark, &drawing(svg, &prefix, &found.figure.alternative));
        }
    }
    html
}

/// An SVG document as an element of a page: no prolog, identifiers of its own, a role and a label.
fn drawing(svg: &str, prefix: &str, alternative: &str) -> String {
    let start = svg.find("<svg").unwrap_or(0);
    let mut text = svg[start..].trim().to_owned();
    for (before, after) in [
        ("id=\"", "\""),
        ("url(#", ")"),
        ("href=\"#", "\""),
        ("aria-labelledby=\"", "\""),
        ("aria-describedby=\"", "\""),
    ] {
        text = prefixed(&text, before, after, prefix);
    }
    let end = text.find('>').unwrap_or(0);
    let open = without(&without(&text[..end], "role"), "aria-label");
    let label = escape(&one_line(alternative));
    format!("{open} role=\"img\" aria-label=\"{label}\"{}", &text[end..])
}

/// The text with `prefix` before each of the names between `before` and `after`.
fn prefixed(text: &str, before: &str, after: &str, prefix: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(before) {
        let (head, tail) = rest.split_at(at + before.len());
        result.push_str(head);
        let whole = before.starts_with("id=") && !head[..at].ends_with(char::is_whitespace);
        let end = tail.find(after).unwrap_or(tail.len());
        let names: Vec<String> = tail[..end]
            .split_whitespace()
            .map(|name| {
                if whole {
                    name.to_owned()
                } else {
                    format!("{prefix}{name}")
                }
            })
            .collect();
        result.push_str(&names.join(" "));
        rest = &tail[end..];
    }
    result.push_str(rest);
    result
}

/// An opening tag without one of its attributes.
fn without(tag: &str, attribute: &str) -> String {
    let wanted = format!(" {attribute}=\"");
    let Some(at) = tag.find(&wanted) else {
        return tag.to_owned();
    };
    let value = &tag[at + wanted.len()..];
    let end = value.find('"').map_or(value.len(), |end| end + 1);
    format!("{}{}", &tag[..at], &value[end..])
}

/// Writes the pictures beside the pages.
///
/// # Errors
/// Where the folder cannot be written.
pub fn write_pictures(figures: &[ChapterFigure], output: &Path) -> Result<()> {
    for found in figures {
        if let Content::Png(bytes) = &found.figure.content {
            let path = format!("{}::{}", found.chapter, found.figure.name);
            let file = output.join(picture_path(&path));
            if let Some(folder) = file.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::write(&file, bytes).with_context(|| format!("cannot write {}", file.display()))?;
        }
    }
    Ok(())
}

/// Writes the font of the formulas and its licence.
///
/// # Errors
/// Where the font or the licence is not found in the crate that carries them, or cannot be written.
pub fn write_font(output: &Path) -> Result<()> {
    let folder = output.join("fonts");
    fs::create_dir_all(&folder)?;
    let font = font().with_context(|| format!("{} has no font {FONT}", CARRIER.0))?;
    fs::write(folder.join(format!("{FONT}.otf")), font)?;
    fs::write(folder.join(format!("{FONT}-LICENSE.txt")), font_licence()?)?;
    Ok(())
}

fn font() -> Option<&'static [u8]> {
    let name = FONT.as_bytes();
    typst_assets::fonts().find(|font| font.windows(name.len()).any(|part| part == name))
}

/// The licence of the font, from the sources of the crate that carries it.
fn font_licence() -> Result<String> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
    let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["metadata", "--format-version", "1", "--manifest-path"])
        .arg(manifest)
        .output()
        .context("cannot run `cargo metadata`")?;
    ensure!(output.status.success(), "`cargo metadata` failed");
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout)?;
    let folder = metadata["packages"]
        .as_array()
        .and_then(|packages| packages.iter().find(|p| p["name"] == CARRIER.0))
        .and_then(|package| package["manifest_path"].as_str())
        .and_then(|path| Path::new(path).parent())
        .with_context(|| format!("`cargo metadata` does not know {}", CARRIER.0))?;
    let notice = fs::read_to_string(folder.join(CARRIER.1))
        .with_context(|| format!("{} has no {}", CARRIER.0, CARRIER.1))?;
    let licence = notice
        .split("====\n")
        .find(|part| part.contains("The GUST Font License Version 1.0"))
        .with_context(|| {
            format!(
                "{} of {} does not hold the font's licence",
                CARRIER.1, CARRIER.0
            )
        })?;
    Ok(licence.trim_matches(|c| c == '=' || c == '\n').to_owned() + "\n")
}

/// Copies a folder with everything in it.
///
/// # Errors
/// Where a file cannot be read or written.
pub fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from).with_context(|| format!("cannot read {}", from.display()))? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy_folder(&entry.path(), &target)?;
        } else if entry.file_name() != ".lock" {
            fs::copy(entry.path(), &target)
                .with_context(|| format!("cannot write {}", target.display()))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_of_a_png_is_in_its_first_chunk() {
        let bytes = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x02\x80\0\0\x01\x90rest";
        assert_eq!(png_size(bytes), Some((640, 400)));
        assert_eq!(png_size(b"GIF"), None);
        assert_eq!(png_size(&bytes[..20]), None);
    }

    #[test]
    fn a_drawing_gets_a_role_a_label_and_identifiers_of_its_own() {
        let svg = "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 1 1\" role=\"x\" aria-labelledby=\"t d\"><title id=\"t\">T</title>\
                   <desc id=\"d\"/><use href=\"#m\"/><path id=\"m\" fill=\"url(#g)\" data-id=\"k\"/></svg>\n";
        let text = drawing(svg, "p-", "a \"quoted\"\nlabel");
        assert_eq!(
            text,
            "<svg viewBox=\"0 0 1 1\" aria-labelledby=\"p-t p-d\" role=\"img\" aria-label=\"a &quot;quoted&quot; label\">\
             <title id=\"p-t\">T</title><desc id=\"p-d\"/><use href=\"#p-m\"/><path id=\"p-m\" fill=\"url(#p-g)\" data-id=\"k\"/></svg>"
        );
    }

    #[test]
    fn the_font_and_its_licence_are_found() {
        assert!(font().is_some_and(|font| font.len() > 100_000));
        let licence = font_licence().expect("the sources of the crate are there");
        assert!(licence.contains("GUST Font License"));
        assert!(!licence.contains("GNU GENERAL PUBLIC LICENSE"));
    }
}
