//! From the pages to the written book, with mdBook as a library.

use crate::checks;
use crate::expand::Expander;
use crate::figures::ChapterFigure;
use crate::links::LinkCheck;
use crate::material::Material;
use crate::page::{Page, slashed};
use crate::problem::{Problem, Problems};
use crate::survey::Survey;
use crate::{api, assets, complaints};
use anyhow::{Context, Result};
use mdbook_driver::MDBook;
use mdbook_driver::book::BookItem;
use mdbook_driver::config::Config;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// What a book is built from, and where to.
#[derive(Debug)]
pub struct Job<'a> {
    /// The root of the repository.
    pub root: &'a Path,
    /// The figures of all chapters.
    pub figures: Vec<ChapterFigure>,
    /// The rustdoc pages.
    pub rustdoc: &'a Path,
    /// The folder of the written book.
    pub output: &'a Path,
}

/// Builds the book. Where something is wrong, the problems are returned and the output is left as it was.
///
/// # Errors
/// Where a file cannot be read or written, or the table of contents is broken.
pub fn build(job: Job<'_>) -> Result<Vec<Problem>> {
    let fresh = sibling(job.output, "new");
    remove(&fresh)?;
    let result = write(job.root, job.figures, job.rustdoc, &fresh);
    match result {
        Ok(problems) if problems.is_empty() => {
            swap(&fresh, job.output)?;
            Ok(problems)
        }
        other => {
            remove(&fresh)?;
            other
        }
    }
}

fn write(
    root: &Path,
    figures: Vec<ChapterFigure>,
    rustdoc: &Path,
    output: &Path,
) -> Result<Vec<Problem>> {
    let mut problems = Problems::default();
    let mut book = load(&root.join("book"), output)?;
    let pages = pages(&book);
    let mut material = Material::read(root, figures, rustdoc, &mut problems)?;
    let survey = Survey::new(&pages, &mut problems);
    checks::pages(root, &pages, &survey, &mut problems);
    let mut expander = Expander::new(&mut material, &pages, &survey, &mut problems);
    let mut texts: HashMap<&Path, String> = HashMap::new();
    for (index, page) in pages.iter().enumerate() {
        texts.insert(&page.path, expander.page(index));
    }
    checks::unused(&mut expander);
    // By path: mdBook comes to the pages below a page before it comes to that page.
    book.book.for_each_chapter_mut(|chapter| {
        let text = chapter.path.as_deref().and_then(|path| texts.remove(path));
        chapter.content = text.unwrap_or_default();
    });
    let (result, complaints) = complaints::hear(|| book.build());
    result.context("mdBook could not write the pages")?;
    for complaint in complaints {
        // The longest path: `basis.md` is a part of `bspline/basis.md`.
        let page = pages
            .iter()
            .filter(|page| complaint.contains(&slashed(&page.path)))
            .max_by_key(|page| page.path.as_os_str().len());
        let file = page.map_or(Path::new("book/book.toml"), |page| &page.file);
        problems.add(file, 1, format!("mdBook: {complaint}"));
    }
    finish(&pages, &material, output)?;
    LinkCheck::new(root, output).run(&pages, &mut problems)?;
    Ok(problems.into_sorted())
}

/// Everything that comes after mdBook: drawings, pictures, font, rustdoc.
fn finish(pages: &[Page], material: &Material, output: &Path) -> Result<()> {
    let mut written: Vec<PathBuf> = pages.iter().map(|page| output.join(page.html())).collect();
    written.push(output.join("index.html"));
    for file in written {
        let html = fs::read_to_string(&file)
            .with_context(|| format!("mdBook did not write {}", file.display()))?;
        fs::write(&file, assets::inline_drawings(&html, &material.figures))?;
    }
    assets::write_pictures(&material.figures, output)?;
    assets::write_font(output)?;
    assets::copy_folder(material.api.folder(), &output.join(api::FOLDER))
}

/// Loads the book with its output directed to `output` and our own command left out.
fn load(book: &Path, output: &Path) -> Result<MDBook> {
    let file = book.join("book.toml");
    let text =
        fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
    let config = configuration(&text, output).context("book/book.toml")?;
    MDBook::load_with_config(book, config)
}

/// The configuration for mdBook's own HTML renderer: a reader's `mdbook build` calls our command, which holds
/// that renderer's settings in its table `output.facette.html`.
fn configuration(text: &str, output: &Path) -> Result<Config> {
    let mut table: toml::Table = text.parse()?;
    if let Some(outputs) = table.get_mut("output").and_then(toml::Value::as_table_mut)
        && let Some(mut own) = outputs.remove("facette")
        && let Some(html) = own.as_table_mut().and_then(|own| own.remove("html"))
    {
        outputs.insert("html".to_owned(), html);
    }
    let mut config: Config = toml::to_string(&table)?.parse()?;
    config.build.build_dir = output.to_path_buf();
    config.build.create_missing = false;
    Ok(config)
}

fn pages(book: &MDBook) -> Vec<Page> {
    let source = Path::new("book").join(&book.config.book.src);
    book.iter()
        .filter_map(|item| match item {
            BookItem::Chapter(chapter) => Some(chapter),
            _ => None,
        })
        .filter_map(|chapter| {
            let path = chapter.path.clone()?;
            let number = chapter.number.as_ref().and_then(|n| n.first().copied());
            Some(Page {
                file: source.join(&path),
                path,
                name: chapter.name.clone(),
                number,
                text: chapter.content.clone(),
            })
        })
        .collect()
}

fn sibling(output: &Path, extension: &str) -> PathBuf {
    let name = output.file_name().unwrap_or_default().to_string_lossy();
    output.with_file_name(format!("{name}.{extension}"))
}

fn remove(folder: &Path) -> Result<()> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(error).with_context(|| format!("cannot remove {}", folder.display()))
        }
        _ => Ok(()),
    }
}

/// Puts the fresh book in the place of the old one.
fn swap(fresh: &Path, output: &Path) -> Result<()> {
    let old = sibling(output, "old");
    remove(&old)?;
    if output.exists() {
        fs::rename(output, &old).with_context(|| format!("cannot move {}", output.display()))?;
    }
    fs::rename(fresh, output).with_context(|| format!("cannot write {}", output.display()))?;
    remove(&old)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn our_own_command_gives_way_to_the_html_renderer() {
        let text = "[book]\ntitle = \"T\"\n[output.facette]\ncommand = \"x\"\n[output.facette.html]\ndefault-theme = \"light\"\n";
        let config = configuration(text, Path::new("out")).expect("well formed");
        assert!(!config.contains_key("output.facette"));
        let html = config.html_config().expect("the table was moved");
        assert_eq!(html.default_theme.as_deref(), Some("light"));
        assert_eq!(config.build.build_dir, Path::new("out"));
    }
}
