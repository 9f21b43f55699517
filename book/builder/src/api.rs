//! The rustdoc pages: made, copied beside the book, and linked to.

use anyhow::{Context, Result, ensure};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the rustdoc pages in the book.
pub const FOLDER: &str = "api";

/// The rustdoc pages of the library.
#[derive(Debug)]
pub struct Api {
    folder: PathBuf,
    pages: HashMap<PathBuf, String>,
}

/// Runs rustdoc into `root/target/rustdoc` and returns the folder of the pages.
///
/// # Errors
/// Where rustdoc cannot be run or finds something wrong; its own messages go to standard error.
pub fn document(root: &Path) -> Result<PathBuf> {
    let target = root.join("target/rustdoc");
    let status = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["doc", "--no-deps", "--quiet", "--package", "facette"])
        .arg("--target-dir")
        .arg(&target)
        .env("RUSTDOCFLAGS", "-D warnings")
        .current_dir(root)
        .status()
        .context("cannot run `cargo doc`")?;
    ensure!(
        status.success(),
        "`cargo doc` failed: the messages above name file and line"
    );
    Ok(target.join("doc"))
}

impl Api {
    /// The pages in `folder`, as rustdoc leaves them.
    #[must_use]
    pub fn new(folder: &Path) -> Self {
        Api {
            folder: folder.to_path_buf(),
            pages: HashMap::new(),
        }
    }

    /// Where the rustdoc pages are.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The address, relative to the book's root, of the item `coons::CoonsPatch` or `coons::Boundary::new`.
    pub fn resolve(&mut self, path: &str) -> Option<String> {
        let names: Vec<&str> = path.split("::").collect();
        let page = self.item(&names);
        if let Some(page) = page {
            return Some(format!("{FOLDER}/{page}"));
        }
        let (member, parent) = names.split_last()?;
        let page = self.item(parent)?;
        let text = self.page(Path::new(&page))?;
        let anchor = [
            "method",
            "tymethod",
            "variant",
            "structfield",
            "associatedconstant",
            "associatedtype",
        ]
        .iter()
        .map(|kind| format!("{kind}.{member}"))
        .find(|anchor| text.contains(&format!("id=\"{anchor}\"")))?;
        Some(format!("{FOLDER}/{page}#{anchor}"))
    }

    /// The page of an item, relative to the rustdoc folder.
    fn item(&self, names: &[&str]) -> Option<String> {
        let (name, parents) = names.split_last()?;
        let mut module = String::from("facette");
        for parent in parents {
            module = format!("{module}/{parent}");
        }
        let kinds = [
            "struct", "fn", "trait", "enum", "type", "constant", "macro", "union", "static",
        ];
        kinds
            .iter()
            .map(|kind| format!("{module}/{kind}.{name}.html"))
            .chain([format!("{module}/{name}/index.html")])
            .find(|page| self.folder.join(page).is_file())
    }

    fn page(&mut self, page: &Path) -> Option<&str> {
        if !self.pages.contains_key(page) {
            let text = fs::read_to_string(self.folder.join(page)).ok()?;
            self.pages.insert(page.to_path_buf(), text);
        }
        self.pages.get(page).map(String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scratch::Scratch;

    #[test]
    fn items_modules_and_methods_are_resolved() {
        let scratch = Scratch::new();
        scratch.write(
            "facette/coons/struct.Boundary.html",
            "<section id=\"method.new\">",
        );
        scratch.write("facette/coons/fn.bilinear_point.html", "");
        scratch.write("facette/coons/index.html", "");
        let mut api = Api::new(scratch.path());
        let mut resolve = |path: &str| api.resolve(path);
        assert_eq!(
            resolve("coons::Boundary").as_deref(),
            Some("api/facette/coons/struct.Boundary.html")
        );
        assert_eq!(
            resolve("coons::Boundary::new").as_deref(),
            Some("api/facette/coons/struct.Boundary.html#method.new")
        );
        assert_eq!(
            resolve("coons").as_deref(),
            Some("api/facette/coons/index.html")
        );
        assert_eq!(resolve("coons::Boundary::old"), None);
        assert_eq!(resolve("coons::Missing"), None);
    }
}
