//! The figures: made in parallel, and made again only when something they depend on has changed.

use crate::sources;
use anyhow::{Context, Result};
use facette_figure::{Content, Figure, FigureMaker};
use indicatif::{ProgressBar, ProgressStyle};
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::IsTerminal;
use std::panic::catch_unwind;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// The figures of one chapter.
#[derive(Debug, Clone, Copy)]
pub struct ChapterFigures {
    /// The chapter: the example's name.
    pub chapter: &'static str,
    /// What its example lists.
    pub figures: &'static [FigureMaker],
}

/// A figure and its chapter.
#[derive(Debug, Clone)]
pub struct ChapterFigure {
    /// The chapter.
    pub chapter: String,
    /// The figure.
    pub figure: Figure,
}

/// How many figures were made, and how many kept from before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tally {
    /// Made in this run.
    pub made: usize,
    /// Taken from the cache.
    pub kept: usize,
}

/// What is kept of a figure beside its content.
#[derive(Serialize, Deserialize)]
struct Record {
    key: String,
    caption: String,
    alternative: String,
    picture: bool,
}

struct Task {
    chapter: &'static str,
    maker: FigureMaker,
    key: String,
}

/// Makes the figures of all `chapters`, or takes them from `root/target/figures/.cache`.
///
/// # Errors
/// Where a figure's function panics, gives a figure of another name, or a file cannot be read or written.
pub fn make(root: &Path, chapters: &[ChapterFigures]) -> Result<(Vec<ChapterFigure>, Tally)> {
    let mut tasks = Vec::new();
    let mut done: Vec<(usize, ChapterFigure)> = Vec::new();
    for chapter in chapters {
        let key = chapter_key(root, chapter.chapter)?;
        for maker in chapter.figures {
            let index = tasks.len() + done.len();
            match kept(root, chapter.chapter, *maker, &key) {
                Some(figure) => done.push((index, wrap(chapter.chapter, figure))),
                None => tasks.push((
                    index,
                    Task {
                        chapter: chapter.chapter,
                        maker: *maker,
                        key: key.clone(),
                    },
                )),
            }
        }
    }
    let tally = Tally {
        made: tasks.len(),
        kept: done.len(),
    };
    done.extend(make_all(root, &tasks)?);
    done.sort_by_key(|(index, _)| *index);
    Ok((done.into_iter().map(|(_, figure)| figure).collect(), tally))
}

fn wrap(chapter: &str, figure: Figure) -> ChapterFigure {
    ChapterFigure {
        chapter: chapter.to_owned(),
        figure,
    }
}

/// The key of a chapter's figures: it changes with the sources and the measurements.
fn chapter_key(root: &Path, chapter: &str) -> Result<String> {
    let mut files = sources::of_example(root, chapter)?;
    for folder in ["target/speed_against_error", "book/measurements"] {
        let csv = Path::new(folder).join(format!("{chapter}.csv"));
        if root.join(&csv).is_file() {
            files.insert(csv);
        }
    }
    sources::hash(root, &files, &[])
}

fn cache_folder(root: &Path, chapter: &str) -> std::path::PathBuf {
    root.join("target/figures/.cache").join(chapter)
}

/// The figure from the cache, if it is there whole and with this key.
fn kept(root: &Path, chapter: &str, maker: FigureMaker, key: &str) -> Option<Figure> {
    let folder = cache_folder(root, chapter);
    let record = fs::read_to_string(folder.join(format!("{}.toml", maker.name))).ok()?;
    let record: Record = toml::from_str(&record).ok()?;
    if record.key != key {
        return None;
    }
    let content = if record.picture {
        Content::Png(fs::read(folder.join(format!("{}.png", maker.name))).ok()?)
    } else {
        Content::Svg(fs::read_to_string(folder.join(format!("{}.svg", maker.name))).ok()?)
    };
    Some(Figure {
        name: maker.name,
        caption: record.caption,
        alternative: record.alternative,
        content,
    })
}

fn keep(root: &Path, chapter: &str, figure: &Figure, key: &str) -> Result<()> {
    let folder = cache_folder(root, chapter);
    let record = Record {
        key: key.to_owned(),
        caption: figure.caption.clone(),
        alternative: figure.alternative.clone(),
        picture: matches!(figure.content, Content::Png(_)),
    };
    figure
        .write(&folder)
        .with_context(|| format!("cannot keep the figure {chapter}::{}", figure.name))?;
    let path = folder.join(format!("{}.toml", figure.name));
    fs::write(&path, toml::to_string(&record)?)
        .with_context(|| format!("cannot write {}", path.display()))
}

/// Makes the figures with as many workers as the machine runs at once.
fn make_all(root: &Path, tasks: &[(usize, Task)]) -> Result<Vec<(usize, ChapterFigure)>> {
    let progress = Progress::new(tasks.len());
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::new());
    let workers = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..workers.min(tasks.len()) {
            scope.spawn(|| {
                while let Some((index, task)) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let result = make_one(root, task, &progress).map(|figure| (*index, figure));
                    if let Ok(mut results) = results.lock() {
                        results.push(result);
                    }
                }
            });
        }
    });
    progress.finish();
    let results = results.into_inner().unwrap_or_default();
    results.into_iter().collect()
}

fn make_one(root: &Path, task: &Task, progress: &Progress) -> Result<ChapterFigure> {
    let path = format!("{}::{}", task.chapter, task.maker.name);
    progress.begin(&path);
    let figure = catch_unwind(task.maker.make).ok().with_context(|| {
        format!("the function that makes the figure {path} panicked (see above)")
    })?;
    anyhow::ensure!(
        figure.name == task.maker.name,
        "the figure {path} calls itself `{}`: both names must be the same",
        figure.name
    );
    keep(root, task.chapter, &figure, &task.key)?;
    progress.end();
    Ok(wrap(task.chapter, figure))
}

/// A bar on a terminal, plain lines elsewhere.
struct Progress {
    bar: Option<ProgressBar>,
}

impl Progress {
    fn new(length: usize) -> Self {
        let bar = (length > 0 && std::io::stderr().is_terminal()).then(|| {
            let style = ProgressStyle::with_template("figures {bar:30} {pos}/{len} {wide_msg}")
                .unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(length as u64).with_style(style)
        });
        Progress { bar }
    }

    fn begin(&self, figure: &str) {
        match &self.bar {
            Some(bar) => bar.set_message(format!("making {figure}")),
            None => eprintln!("making the figure {figure}"),
        }
    }

    fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.inc(1);
        }
    }

    fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scratch::Scratch;

    fn square() -> Figure {
        Figure {
            name: "square",
            caption: "A square.".into(),
            alternative: "Four sides.".into(),
            content: Content::Svg("<svg viewBox=\"0 0 1 1\"></svg>".into()),
        }
    }

    fn misnamed() -> Figure {
        Figure {
            name: "other",
            ..square()
        }
    }

    const CHAPTERS: &[ChapterFigures] = &[ChapterFigures {
        chapter: "coons",
        figures: &[FigureMaker {
            name: "square",
            make: square,
        }],
    }];

    #[test]
    fn a_figure_is_made_once_and_again_when_its_source_changes() {
        let scratch = Scratch::new();
        scratch.write("examples/coons.rs", "use facette::coons;");
        scratch.write("src/coons.rs", "");
        scratch.write("src/camera.rs", "");
        let tally = || make(scratch.path(), CHAPTERS).expect("figures").1;
        assert_eq!(tally(), Tally { made: 1, kept: 0 });
        assert_eq!(tally(), Tally { made: 0, kept: 1 });
        scratch.write("src/camera.rs", "changed, but not used");
        assert_eq!(tally(), Tally { made: 0, kept: 1 });
        scratch.write("src/coons.rs", "changed");
        assert_eq!(tally(), Tally { made: 1, kept: 0 });
        let (figures, _) = make(scratch.path(), CHAPTERS).expect("figures");
        assert_eq!(figures[0].figure, square());
    }

    #[test]
    fn a_figure_of_another_name_is_refused() {
        let scratch = Scratch::new();
        let chapters = &[ChapterFigures {
            chapter: "coons",
            figures: &[FigureMaker {
                name: "square",
                make: misnamed,
            }],
        }];
        let error = make(scratch.path(), chapters).expect_err("misnamed");
        assert!(error.to_string().contains("calls itself `other`"));
    }
}
