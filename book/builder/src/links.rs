//! The link check: every page, anchor, image and rustdoc page that the book refers to exists in it.

use crate::api;
use crate::html::Document;
use crate::page::{Page, normal, slashed};
use crate::problem::{Problems, line_of};
use anyhow::{Context, Result};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Checks the written book in `output`; `sources` are the Markdown pages, tests and library files to name.
pub struct LinkCheck<'a> {
    root: &'a Path,
    output: &'a Path,
    documents: HashMap<PathBuf, Option<Document>>,
}

impl<'a> LinkCheck<'a> {
    /// A check of the book that was written to `output`.
    #[must_use]
    pub fn new(root: &'a Path, output: &'a Path) -> Self {
        LinkCheck {
            root,
            output,
            documents: HashMap::new(),
        }
    }

    /// Checks all pages, and the way back from the rustdoc pages.
    ///
    /// # Errors
    /// Where a page that was just written cannot be read.
    pub fn run(&mut self, pages: &[Page], problems: &mut Problems) -> Result<()> {
        for page in pages {
            let html = PathBuf::from(page.html());
            let document = self
                .read(&html)
                .with_context(|| format!("mdBook did not write {}", html.display()))?;
            let (links, resources) = (document.links.clone(), document.resources.clone());
            for id in document.doubles.clone() {
                let message = format!("the identifier `{id}` stands twice on the page");
                let line = find(&page.text, &id).unwrap_or(1);
                problems.add(&page.file, line, message);
            }
            for url in links.iter().chain(&resources) {
                if let Err(message) = self.check(&html, url) {
                    let (file, line) = self.source(page, url);
                    problems.add(&file, line, message);
                }
            }
            for url in resources.iter().filter(|url| is_remote(url)) {
                let (file, line) = self.source(page, url);
                let message =
                    format!("`{url}` is loaded from elsewhere: the book must stand by itself");
                problems.add(&file, line, message);
            }
        }
        self.back(problems)
    }

    /// Checks the links by which rustdoc pages leave their folder.
    fn back(&mut self, problems: &mut Problems) -> Result<()> {
        let mut waiting = vec![PathBuf::from(api::FOLDER).join("facette")];
        while let Some(folder) = waiting.pop() {
            if !self.output.join(&folder).is_dir() {
                continue;
            }
            for entry in fs::read_dir(self.output.join(&folder))? {
                let entry = entry?;
                let path = folder.join(entry.file_name());
                if entry.file_type()?.is_dir() {
                    waiting.push(path);
                } else if path.extension().is_some_and(|e| e == "html") {
                    self.back_from(&path, problems);
                }
            }
        }
        Ok(())
    }

    fn back_from(&mut self, page: &Path, problems: &mut Problems) {
        let links = self.read(page).map_or_else(Vec::new, |d| d.links.clone());
        for url in links {
            let target = page.parent().map(|folder| folder.join(strip(&url)));
            let target = target.and_then(|target| normal(&target));
            let leaves = target.is_none_or(|target| !target.starts_with(api::FOLDER));
            if leaves
                && !is_remote(&url)
                && let Err(message) = self.check(page, &url)
            {
                let (file, line) =
                    in_sources(self.root, &url).unwrap_or_else(|| (PathBuf::from("src/lib.rs"), 1));
                problems.add(&file, line, format!("in the rustdoc: {message}"));
            }
        }
    }

    /// Checks one address on one page.
    fn check(&mut self, page: &Path, url: &str) -> Result<(), String> {
        if is_remote(url) || url.starts_with("data:") || url.starts_with("mailto:") {
            return Ok(());
        }
        let folder = page.parent().unwrap_or(Path::new(""));
        let path = strip(url);
        let anchor = url.split_once('#').map_or("", |(_, anchor)| anchor);
        let mut target = if path.is_empty() {
            page.to_path_buf()
        } else {
            normal(&folder.join(path)).ok_or_else(|| format!("the link `{url}` leaves the book"))?
        };
        if self.output.join(&target).is_dir() {
            target.push("index.html");
        }
        if !self.output.join(&target).is_file() {
            return Err(format!(
                "dead link `{url}`: the book has no {}",
                slashed(&target)
            ));
        }
        if anchor.is_empty() || target.extension().is_none_or(|e| e != "html") {
            return Ok(());
        }
        let known = self.read(&target).is_some_and(|d| d.ids.contains(anchor));
        if known {
            Ok(())
        } else {
            Err(format!(
                "dead link `{url}`: {} has no `#{anchor}`",
                slashed(&target)
            ))
        }
    }

    fn read(&mut self, page: &Path) -> Option<&Document> {
        let file = self.output.join(page);
        self.documents
            .entry(page.to_path_buf())
            .or_insert_with(|| {
                let html = fs::read_to_string(&file).ok()?;
                Some(Document::read(&html))
            })
            .as_ref()
    }

    /// Where the address was written: in the page, or in a test whose statement the page shows.
    fn source(&self, page: &Page, url: &str) -> (PathBuf, usize) {
        if let Some(line) = find(&page.text, url) {
            return (page.file.clone(), line);
        }
        let tests = Path::new("tests").join(page.chapter());
        in_files(self.root, &tests, url).unwrap_or_else(|| (page.file.clone(), 1))
    }
}

fn is_remote(url: &str) -> bool {
    ["http://", "https://", "//"]
        .iter()
        .any(|start| url.starts_with(start))
}

/// The address without query and anchor.
fn strip(url: &str) -> &str {
    url.split(['#', '?']).next().unwrap_or(url)
}

/// The line of the text that holds the address, as it is or as its Markdown page.
fn find(text: &str, url: &str) -> Option<usize> {
    let markdown = url.replacen(".html", ".md", 1);
    let at = text.find(url).or_else(|| text.find(&markdown))?;
    Some(line_of(text, at))
}

fn in_sources(root: &Path, url: &str) -> Option<(PathBuf, usize)> {
    in_files(root, Path::new("src"), url)
}

fn in_files(root: &Path, folder: &Path, url: &str) -> Option<(PathBuf, usize)> {
    for entry in fs::read_dir(root.join(folder)).ok()?.flatten() {
        let path = folder.join(entry.file_name());
        let found = if root.join(&path).is_dir() {
            in_files(root, &path, url)
        } else {
            let text = fs::read_to_string(root.join(&path)).unwrap_or_default();
            find(&text, url).map(|line| (path, line))
        };
        if found.is_some() {
            return found;
        }
    }
    None
}
