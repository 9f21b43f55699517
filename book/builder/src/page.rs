//! A page of the book, as it was written.

use std::path::{Component, Path, PathBuf};

/// A page's Markdown and where it belongs.
#[derive(Debug, Clone)]
pub struct Page {
    /// The file, relative to the root of the repository.
    pub file: PathBuf,
    /// The same, relative to the book's source folder.
    pub path: PathBuf,
    /// The page's name in the table of contents.
    pub name: String,
    /// The number of its chapter; none for pages outside the numbering.
    pub number: Option<u32>,
    /// The Markdown.
    pub text: String,
}

impl Page {
    /// The chapter: the page's name, or the folder's where a chapter has several pages.
    #[must_use]
    pub fn chapter(&self) -> String {
        let first = self.path.components().next();
        let first = first.map_or_else(String::new, |c| {
            c.as_os_str().to_string_lossy().into_owned()
        });
        first.trim_end_matches(".md").to_owned()
    }

    /// Whether it is a page of this chapter: `<chapter>.md` or a page of the folder `<chapter>/`.
    #[must_use]
    pub fn is_of(&self, chapter: &str) -> bool {
        self.chapter() == chapter
    }

    /// The written page, relative to the book's root, with forward slashes.
    #[must_use]
    pub fn html(&self) -> String {
        slashed(&self.path.with_extension("html"))
    }

    /// The way from this page to the book's root: empty, `../`, `../../`, ...
    #[must_use]
    pub fn to_root(&self) -> String {
        "../".repeat(self.path.components().count().saturating_sub(1))
    }

    /// A link from this page to `target`, an address relative to the book's root.
    #[must_use]
    pub fn link(&self, target: &str) -> String {
        match target.strip_prefix(&self.html()) {
            Some(anchor) if anchor.starts_with('#') => anchor.to_owned(),
            _ => format!("{}{target}", self.to_root()),
        }
    }
}

/// The first page of a chapter, which bears the chapter's name in the table of contents.
#[must_use]
pub fn first_of<'p>(pages: &'p [Page], chapter: &str) -> Option<&'p Page> {
    pages.iter().find(|page| page.is_of(chapter))
}

/// The name under which other pages refer to `page`: a further page of a chapter bears the chapter's name before its own.
#[must_use]
pub fn full_name(pages: &[Page], page: &Page) -> String {
    match first_of(pages, &page.chapter()) {
        Some(first) if first.path != page.path => format!("{}: {}", first.name, page.name),
        _ => page.name.clone(),
    }
}

/// A path with forward slashes on every system.
#[must_use]
pub fn slashed(path: &Path) -> String {
    let parts: Vec<_> = path
        .components()
        .map(|c| c.as_os_str().to_string_lossy().into_owned())
        .collect();
    parts.join("/")
}

/// A relative path without `.` and `..`, where these can be resolved inside it; none where it leaves its root.
#[must_use]
pub fn normal(path: &Path) -> Option<PathBuf> {
    let mut parts = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                if !parts.pop() {
                    return None;
                }
            }
            other => parts.push(other),
        }
    }
    Some(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(path: &str) -> Page {
        Page {
            file: Path::new("book/src").join(path),
            path: path.into(),
            name: "P".into(),
            number: Some(1),
            text: String::new(),
        }
    }

    #[test]
    fn links_are_relative_to_the_page() {
        let flat = page("coons.md");
        assert_eq!(flat.link("coons.html#a"), "#a");
        assert_eq!(flat.link("errata.html#a"), "errata.html#a");
        let deep = page("bspline/knots.md");
        assert_eq!(deep.chapter(), "bspline");
        assert_eq!(deep.link("coons.html#a"), "../coons.html#a");
        assert_eq!(deep.link("bspline/knots.html#a"), "#a");
    }

    #[test]
    fn the_pages_of_a_folder_bear_the_chapters_name() {
        let named = |path: &str, name: &str| Page {
            name: name.into(),
            ..page(path)
        };
        let pages = [
            named("coons.md", "Coons patches"),
            named("bspline.md", "B-splines"),
            named("bspline/basis.md", "The basis"),
        ];
        let names = pages.each_ref().map(|page| full_name(&pages, page));
        assert_eq!(
            names,
            ["Coons patches", "B-splines", "B-splines: The basis"]
        );
        let first = first_of(&pages, "bspline").map(Page::html);
        assert_eq!(first.as_deref(), Some("bspline.html"));
        assert!(first_of(&pages, "mesh").is_none());
    }

    #[test]
    fn paths_are_resolved_inside_their_root_only() {
        assert_eq!(normal(Path::new("a/./b/../c")), Some(PathBuf::from("a/c")));
        assert_eq!(normal(Path::new("a/../../c")), None);
    }
}
