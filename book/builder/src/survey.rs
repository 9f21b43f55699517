//! A first reading of all pages: what is cited where, and under which number.

use crate::directive::{self, Directive, Found};
use crate::markdown::{self, Outline};
use crate::page::Page;
use crate::problem::{Place, Problems};
use crate::theorem::{Kind, Topic};
use std::collections::{HashMap, HashSet};

/// Where something stands in the book, and its number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spot {
    /// The page's index.
    pub page: usize,
    /// The number, for example `1.2`.
    pub number: String,
    /// Its rank among all of its kind.
    pub rank: usize,
}

/// A remark on the course.
#[derive(Debug, Clone)]
pub struct Remark {
    /// The page's index.
    pub page: usize,
    /// What it remarks on.
    pub topic: Topic,
    /// The identifier of its box.
    pub anchor: String,
}

/// A page read once.
#[derive(Debug)]
pub struct Reading {
    /// Its directives outside of code.
    pub directives: Vec<Found>,
    /// Its outline.
    pub outline: Outline,
}

/// What all pages together cite.
#[derive(Debug, Default)]
pub struct Survey {
    /// One reading a page.
    pub readings: Vec<Reading>,
    /// Theorems and hard cases by kind and path.
    pub theorems: HashMap<(&'static str, String), Spot>,
    /// Figures by path.
    pub figures: HashMap<String, Spot>,
    /// Works cited in the pages.
    pub cited: HashSet<String>,
    /// Remarks in order.
    pub remarks: Vec<Remark>,
    /// The bibliography's page, as soon as it is known.
    pub bibliography: Option<usize>,
    counts: HashMap<(String, &'static str), usize>,
}

impl Survey {
    /// Reads all pages.
    #[must_use]
    pub fn new(pages: &[Page], problems: &mut Problems) -> Self {
        let mut survey = Survey::default();
        for (index, page) in pages.iter().enumerate() {
            let outline = markdown::outline(&page.text);
            let directives = directive::find(&page.text)
                .into_iter()
                .filter(|found| is_live(found, &outline))
                .collect::<Vec<_>>();
            for found in &directives {
                survey.note(index, page, found, problems);
            }
            Self::check_remarks(page, &directives, problems);
            survey.readings.push(Reading {
                directives,
                outline,
            });
        }
        survey
    }

    fn note(&mut self, index: usize, page: &Page, found: &Found, problems: &mut Problems) {
        let line = Place::new(&page.file, 1).line(&page.text, found.range.start);
        let twice = match &found.directive {
            Err(message) => {
                problems.add(&page.file, line, message.clone());
                return;
            }
            Ok(Directive::Theorem(path)) => self.statement(index, page, Kind::Theorem, path),
            Ok(Directive::HardCase(path)) => self.statement(index, page, Kind::HardCase, path),
            Ok(Directive::Figure(path)) => {
                let spot = self.spot(index, page, "figure");
                self.figures.insert(path.clone(), spot).map(|_| path)
            }
            Ok(Directive::Cite(key, _)) => {
                self.cited.insert(key.clone());
                None
            }
            Ok(Directive::Bibliography) => {
                if self.bibliography.replace(index).is_some() {
                    problems.add(&page.file, line, "a second bibliography: there is only one");
                }
                None
            }
            Ok(Directive::Remark(text)) => {
                self.remark(index, text, page, line, problems);
                None
            }
            Ok(_) => None,
        };
        if let Some(path) = twice {
            let message = format!("`{path}` stands in the book a second time");
            problems.add(&page.file, line, message);
        }
    }

    fn statement<'p>(
        &mut self,
        index: usize,
        page: &Page,
        kind: Kind,
        path: &'p String,
    ) -> Option<&'p String> {
        let spot = self.spot(index, page, kind.directive());
        let key = (kind.directive(), path.clone());
        self.theorems.insert(key, spot).map(|_| path)
    }

    fn spot(&mut self, index: usize, page: &Page, kind: &'static str) -> Spot {
        let count = self.counts.entry((page.chapter(), kind)).or_default();
        *count += 1;
        let number = page
            .number
            .map_or_else(|| count.to_string(), |chapter| format!("{chapter}.{count}"));
        Spot {
            page: index,
            number,
            rank: self.theorems.len() + self.figures.len(),
        }
    }

    fn remark(
        &mut self,
        index: usize,
        text: &str,
        page: &Page,
        line: usize,
        problems: &mut Problems,
    ) {
        match Topic::parse(text) {
            Ok(topic) => {
                let anchor = format!("remark-{}-{}", topic.id, self.remarks.len() + 1);
                self.remarks.push(Remark {
                    page: index,
                    topic,
                    anchor,
                });
            }
            Err(message) => problems.add(&page.file, line, format!("remark: {message}")),
        }
    }

    fn check_remarks(page: &Page, directives: &[Found], problems: &mut Problems) {
        let mut open: Option<usize> = None;
        for found in directives {
            let line = Place::new(&page.file, 1).line(&page.text, found.range.start);
            match found.directive {
                Ok(Directive::Remark(_)) if open.replace(line).is_some() => {
                    problems.add(
                        &page.file,
                        line,
                        "a remark within a remark: `{{#endremark}}` is missing before it",
                    );
                }
                Ok(Directive::EndRemark) if open.take().is_none() => {
                    problems.add(
                        &page.file,
                        line,
                        "`{{#endremark}}` without a remark before it",
                    );
                }
                _ => {}
            }
        }
        if let Some(line) = open {
            problems.add(&page.file, line, "this remark has no `{{#endremark}}`");
        }
    }

    /// Where a theorem or hard case stands.
    #[must_use]
    pub fn theorem(&self, kind: Kind, path: &str) -> Option<&Spot> {
        self.theorems.get(&(kind.directive(), path.to_owned()))
    }
}

/// Whether a directive is to be followed: includes everywhere, ours outside of code only.
fn is_live(found: &Found, outline: &Outline) -> bool {
    matches!(found.directive, Ok(Directive::Include(_)))
        || !outline
            .code
            .iter()
            .any(|code| code.contains(&found.range.start))
}
