//! What an example depends on: the files whose change makes its figures and measurements old.

use anyhow::{Context, Result};
use std::collections::BTreeSet;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// The files, relative to `root`, that the example `name` is made of: its own, the library modules that it
/// uses, directly or through others, `src/lib.rs`, the figure crate, and the versions in `Cargo.lock`.
///
/// # Errors
/// Where a file or folder cannot be read.
pub fn of_example(root: &Path, name: &str) -> Result<BTreeSet<PathBuf>> {
    let mut files = BTreeSet::new();
    let mut modules = BTreeSet::new();
    let examples = Path::new("examples");
    for own in [
        examples.join(format!("{name}.rs")),
        examples.join(name),
        Path::new("book/figure/src").to_path_buf(),
    ] {
        rust_files(root, &own, &mut files)?;
    }
    for file in files.clone() {
        example_modules(root, &file, &mut files)?;
    }
    for file in &files {
        modules.extend(used_modules(&read(root, file)?, &["facette::"]));
    }
    close_over_modules(root, modules, &mut files)?;
    for fixed in ["src/lib.rs", "Cargo.lock", "Cargo.toml"] {
        if root.join(fixed).is_file() {
            files.insert(PathBuf::from(fixed));
        }
    }
    Ok(files)
}

/// A number that changes when one of the files, or one of the `extras`, does.
///
/// # Errors
/// Where a file cannot be read.
pub fn hash(root: &Path, files: &BTreeSet<PathBuf>, extras: &[&str]) -> Result<String> {
    let mut hasher = DefaultHasher::new();
    for file in files {
        file.hash(&mut hasher);
        read(root, file)?.hash(&mut hasher);
    }
    extras.hash(&mut hasher);
    Ok(format!("{:016x}", hasher.finish()))
}

fn read(root: &Path, file: &Path) -> Result<String> {
    fs::read_to_string(root.join(file)).with_context(|| format!("cannot read {}", file.display()))
}

/// Adds the Rust file `path`, or all Rust files below the folder `path`; nothing where neither exists.
fn rust_files(root: &Path, path: &Path, files: &mut BTreeSet<PathBuf>) -> Result<()> {
    let whole = root.join(path);
    if whole.is_file() && path.extension().is_some_and(|e| e == "rs") {
        files.insert(path.to_path_buf());
    } else if whole.is_dir() {
        for entry in fs::read_dir(&whole)? {
            rust_files(root, &path.join(entry?.file_name()), files)?;
        }
    }
    Ok(())
}

/// Adds the modules that an example declares by `mod name;` or takes by `#[path = "..."]`.
fn example_modules(root: &Path, file: &Path, files: &mut BTreeSet<PathBuf>) -> Result<()> {
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut path = None;
    for line in read(root, file)?.lines().map(str::trim) {
        if let Some(quoted) = line.strip_prefix("#[path = \"") {
            path = quoted.split('"').next().map(str::to_owned);
        } else if let Some(name) = module_name(line) {
            let stems = [folder.join(name), folder.join(format!("{name}.rs"))];
            for stem in path.take().map(|p| folder.join(p)).iter().chain(&stems) {
                rust_files(root, stem, files)?;
            }
        }
    }
    Ok(())
}

fn module_name(line: &str) -> Option<&str> {
    let line = line.strip_prefix("pub ").unwrap_or(line);
    line.strip_prefix("mod ")?.strip_suffix(';')
}

/// Follows the modules through `crate::` and, in a file directly under `src`, `super::`.
fn close_over_modules(
    root: &Path,
    modules: BTreeSet<String>,
    files: &mut BTreeSet<PathBuf>,
) -> Result<()> {
    let mut waiting: Vec<String> = modules.iter().cloned().collect();
    let mut seen = modules;
    while let Some(module) = waiting.pop() {
        let mut own = BTreeSet::new();
        rust_files(
            root,
            &Path::new("src").join(format!("{module}.rs")),
            &mut own,
        )?;
        rust_files(root, &Path::new("src").join(&module), &mut own)?;
        for file in &own {
            let top = file.components().count() == 2 || file.ends_with("mod.rs");
            let prefixes: &[&str] = if top {
                &["crate::", "super::"]
            } else {
                &["crate::", "super::super::"]
            };
            for used in used_modules(&read(root, file)?, prefixes) {
                if seen.insert(used.clone()) {
                    waiting.push(used);
                }
            }
        }
        files.append(&mut own);
    }
    Ok(())
}

/// The names directly after one of the `prefixes`, those in braces included.
fn used_modules(text: &str, prefixes: &[&str]) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for prefix in prefixes {
        for (at, _) in text.match_indices(prefix) {
            let rest = &text[at + prefix.len()..];
            match rest.strip_prefix('{') {
                Some(list) => names.extend(braced_names(list)),
                None => names.extend(first_name(rest)),
            }
        }
    }
    names
}

fn first_name(text: &str) -> Option<String> {
    let name: String = text
        .trim_start()
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect();
    (!name.is_empty()).then_some(name)
}

/// The first names of the items of a list that was opened by `{`, up to its own `}`.
fn braced_names(list: &str) -> Vec<String> {
    let mut names = Vec::new();
    let (mut depth, mut item_begins) = (0, true);
    for (at, c) in list.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => item_begins = true,
            c if item_begins && !c.is_whitespace() => {
                names.extend(first_name(&list[at..]));
                item_begins = false;
            }
            _ => {}
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scratch::Scratch;

    #[test]
    fn names_after_a_prefix_are_found_in_braces_too() {
        let text = "use facette::{coons::{self, CoonsPatch}, mesh::Mesh,\n curve};\nfacette::algebra::f();";
        let names: Vec<String> = used_modules(text, &["facette::"]).into_iter().collect();
        assert_eq!(names, ["algebra", "coons", "curve", "mesh"]);
    }

    #[test]
    fn the_closure_follows_modules_and_leaves_others_out() {
        let scratch = Scratch::new();
        scratch.write("examples/coons.rs", "use facette::coons::f;\nmod style;\n");
        scratch.write("examples/style.rs", "");
        scratch.write("src/coons/mod.rs", "use super::curve::Curve;");
        scratch.write("src/coons/inner.rs", "use super::boundary;");
        scratch.write("src/curve.rs", "use crate::algebra::Scalar;");
        scratch.write("src/algebra.rs", "");
        scratch.write("src/display.rs", "");
        let files = of_example(scratch.path(), "coons").expect("readable");
        let names: Vec<String> = files.iter().map(|f| f.display().to_string()).collect();
        assert_eq!(
            names,
            [
                "examples/coons.rs",
                "examples/style.rs",
                "src/algebra.rs",
                "src/coons/inner.rs",
                "src/coons/mod.rs",
                "src/curve.rs"
            ]
        );
    }

    #[test]
    fn the_hash_follows_content_and_extras() {
        let scratch = Scratch::new();
        scratch.write("a.rs", "1");
        let files = BTreeSet::from([PathBuf::from("a.rs")]);
        let first = hash(scratch.path(), &files, &[]).expect("readable");
        assert_eq!(first, hash(scratch.path(), &files, &[]).expect("readable"));
        assert_ne!(
            first,
            hash(scratch.path(), &files, &["x"]).expect("readable")
        );
        scratch.write("a.rs", "2");
        assert_ne!(first, hash(scratch.path(), &files, &[]).expect("readable"));
    }
}
