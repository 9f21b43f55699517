//! The pages that are made from all others: theorem index, errata, slide map, glossary, bibliography.

use crate::expand::Expander;
use crate::page::{Page, first_of, full_name};
use crate::problem::Place;
use crate::survey::Spot;
use crate::tables::Work;
use crate::theorem::{Theorem, Topic};
use std::fmt::Write as _;

/// The theorems and hard cases that the book cites, in its order.
#[must_use]
pub fn in_order(expander: &Expander<'_>) -> Vec<(Spot, Theorem)> {
    let mut theorems: Vec<(Spot, Theorem)> = expander
        .material
        .theorems
        .iter()
        .filter_map(|theorem| {
            let spot = expander.survey.theorem(theorem.kind, &theorem.path())?;
            Some((spot.clone(), theorem.clone()))
        })
        .collect();
    theorems.sort_by_key(|(spot, _)| (spot.page, spot.rank));
    theorems
}

/// A link from `page` to a theorem's box: `[Theorem 1.2](coons.html#...)`.
#[must_use]
pub fn link(expander: &Expander<'_>, page: &Page, spot: &Spot, theorem: &Theorem) -> String {
    let home = &expander.pages[spot.page];
    let address = page.link(&format!("{}#{}", home.html(), theorem.anchor()));
    format!("[{} {}]({address})", theorem.kind.label(), spot.number)
}

/// A link from `page` to another page, by its name.
fn page_link(expander: &Expander<'_>, page: &Page, home: &Page) -> String {
    let name = full_name(expander.pages, home);
    format!("[{name}]({})", page.link(&home.html()))
}

/// Text that does not end a cell of a table.
fn cell(text: &str) -> String {
    text.replace('\n', " ").replace('|', "&#124;")
}

/// A test's name, which may break after its underscores.
fn test_name(theorem: &Theorem) -> String {
    let name = theorem.name.replace('_', "&#95;<wbr>");
    format!("<code>{name}</code>")
}

/// The number of `slide 10` or `slides 10-12`.
fn slide_number(topic: &Topic) -> &str {
    topic
        .slide
        .trim_start_matches(|c: char| !c.is_ascii_digit())
}

fn title(expander: &mut Expander<'_>, page: &Page, theorem: &Theorem) -> String {
    let place = Place::new(&theorem.file, theorem.line);
    let text = expander.prose(&theorem.title, page, place);
    cell(&text)
}

/// All theorems: number, title, test, where the course says it.
pub fn theorem_index(expander: &mut Expander<'_>, page: &Page) -> String {
    let mut text = String::new();
    let mut current = None;
    for (spot, theorem) in in_order(expander) {
        if current.as_ref() != Some(&theorem.chapter) {
            let home = first_of(expander.pages, &theorem.chapter);
            let home = home.unwrap_or(&expander.pages[spot.page]);
            let _ = write!(
                text,
                "\n\n## {}\n\n| statement | title | test | in the course |\n| --- | --- | --- | --- |\n",
                home.name
            );
            current = Some(theorem.chapter.clone());
        }
        let title = title(expander, page, &theorem);
        let topics: Vec<String> = theorem
            .topics
            .iter()
            .map(|t| format!("{} ({})", t.slide, t.id))
            .collect();
        let _ = writeln!(
            text,
            "| {} | {title} | {} | {} |",
            link(expander, page, &spot, &theorem),
            test_name(&theorem),
            topics.join(", ")
        );
    }
    text.push('\n');
    text
}

/// What the slides say that is wrong, and the theorem that says what is true.
pub fn errata(expander: &mut Expander<'_>, page: &Page) -> String {
    let mut text = String::from("\n\n");
    for (spot, theorem) in in_order(expander) {
        for erratum in &theorem.errata {
            let place = Place::new(&theorem.file, theorem.line);
            let said = expander.prose(erratum, page, place);
            let title = title(expander, page, &theorem);
            let link = link(expander, page, &spot, &theorem);
            let topics: Vec<String> = theorem
                .topics
                .iter()
                .map(|t| format!("{}, {} ({})", t.topic, t.slide, t.id))
                .collect();
            let _ = write!(
                text,
                "<section class=\"erratum\">\n<div class=\"box-title\">\n\n<span class=\"box-label\">Erratum</span> {}\n\n</div>\n\n{said}\n\nWhat is true: {link}, *{title}*. The test `{}` shows it.\n\n</section>\n\n",
                topics.join("; "),
                theorem.name
            );
        }
    }
    text
}

/// Course topic to chapter, theorem, test or remark.
pub fn slide_map(expander: &mut Expander<'_>, page: &Page) -> String {
    let mut rows: Vec<(Topic, String, String, String)> = Vec::new();
    for (spot, theorem) in in_order(expander) {
        let chapter = page_link(expander, page, &expander.pages[spot.page]);
        let mut link = link(expander, page, &spot, &theorem);
        if !theorem.errata.is_empty() {
            link.push_str(" (erratum)");
        }
        for topic in &theorem.topics {
            let test = test_name(&theorem);
            rows.push((topic.clone(), chapter.clone(), link.clone(), test));
        }
    }
    for remark in &expander.survey.remarks {
        let home = &expander.pages[remark.page];
        let chapter = page_link(expander, page, home);
        let address = page.link(&format!("{}#{}", home.html(), remark.anchor));
        let link = format!("[Remark]({address})");
        rows.push((remark.topic.clone(), chapter, link, String::new()));
    }
    rows.sort_by_key(|row| topic_order(&row.0));
    let mut text = String::from(
        "\n\n| claim | slide | topic | chapter | statement | test |\n| --- | --- | --- | --- | --- | --- |\n",
    );
    for (topic, chapter, link, test) in rows {
        let said = cell(&topic.topic);
        let _ = writeln!(
            text,
            "| {} | {} | {said} | {chapter} | {link} | {test} |",
            topic.id,
            slide_number(&topic)
        );
    }
    text.push('\n');
    text
}

/// By letter, then by number: A2 before A10.
fn topic_order(topic: &Topic) -> (String, usize, String) {
    let digits = topic
        .id
        .trim_start_matches(|c: char| c.is_ascii_uppercase());
    let letters = topic.id.trim_end_matches(|c: char| c.is_ascii_digit());
    (
        letters.to_owned(),
        digits.parse().unwrap_or_default(),
        topic.slide.clone(),
    )
}

/// French and English terms with their meaning.
pub fn glossary(expander: &mut Expander<'_>, page: &Page) -> String {
    let mut terms = expander.material.terms.rows.clone();
    terms.sort_by_key(|term| term.french.to_lowercase());
    let file = expander.material.terms.file.clone();
    let mut text =
        String::from("\n\n| French | English | meaning | chapter |\n| --- | --- | --- | --- |\n");
    for term in terms {
        let line = expander.material.terms.line("french", &term.french);
        let place = Place::new(&file, line);
        let english = expander.prose(&term.english, page, place);
        let meaning = expander.prose(&term.meaning, page, place);
        let chapter = match &term.chapter {
            None => String::new(),
            Some(name) => chapter_link(expander, page, name, place),
        };
        let _ = writeln!(
            text,
            "| *{}* | {} | {} | {chapter} |",
            cell(&term.french),
            cell(&english),
            cell(&meaning)
        );
    }
    text.push('\n');
    text
}

fn chapter_link(expander: &mut Expander<'_>, page: &Page, name: &str, place: Place<'_>) -> String {
    if let Some(home) = first_of(expander.pages, name) {
        return page_link(expander, page, home);
    }
    let message = format!("the book has no chapter `{name}`");
    expander.problems.add(place.file, place.first_line, message);
    String::new()
}

/// The works that the book cites, by their first author.
pub fn bibliography(expander: &mut Expander<'_>, page: &Page) -> String {
    let mut works: Vec<Work> = expander.material.works.rows.clone();
    works.sort_by_key(|work| (work.label().to_lowercase(), work.year));
    let file = expander.material.works.file.clone();
    let mut text = String::from("\n\n");
    for work in works {
        let place = Place::new(&file, expander.material.works.line("key", &work.key));
        let note = match &work.note {
            Some(note) => format!(" {}", expander.prose(note, page, place)),
            None => String::new(),
        };
        let _ = writeln!(
            text,
            "- <span class=\"work\" id=\"work-{}\">{}</span>, *{}*, {}, {}.{note}",
            work.key,
            work.authors.join(", "),
            work.title,
            work.published,
            work.year
        );
    }
    text.push('\n');
    text
}
