//! The parts of a chapter page that are made from tables: exercises, speed against error.

use crate::expand::Expander;
use crate::indexes::{in_order, link};
use crate::markdown::fenced;
use crate::measure;
use crate::page::Page;
use crate::problem::Place;
use crate::tables::{Exercise, ExerciseList, field_line};
use std::fmt::Write as _;
use std::path::Path;

/// The exercises of a chapter: what to write, how to be graded, by which theorems.
pub fn exercises(
    expander: &mut Expander<'_>,
    chapter: &str,
    page: &Page,
    place: Place<'_>,
) -> Option<String> {
    let list = expander
        .material
        .exercises
        .iter()
        .find(|list| list.chapter == chapter)
        .cloned();
    let Some(list) = list else {
        let message =
            format!("no exercises of `{chapter}`: expected book/exercises/{chapter}/exercise.toml");
        expander.problems.add(place.file, place.first_line, message);
        return None;
    };
    if list.page != page.html() {
        let message = format!(
            "page = \"{}\", but `{{{{#exercises {chapter}}}}}` stands in {}: expected page = \"{}\"",
            list.page,
            page.file.display(),
            page.html()
        );
        let line = field_line(&list.text, "page", &list.page);
        expander.problems.add(&list.file, line, message);
    }
    let mut text = String::from("\n\n");
    for (index, exercise) in list.exercises.iter().enumerate() {
        text.push_str(&exercise_box(expander, &list, exercise, index, page));
    }
    Some(text)
}

fn exercise_box(
    expander: &Expander<'_>,
    list: &ExerciseList,
    exercise: &Exercise,
    index: usize,
    page: &Page,
) -> String {
    let number = page
        .number
        .map_or_else(String::new, |chapter| format!("{chapter}."));
    let functions: Vec<String> = exercise
        .functions
        .iter()
        .map(|f| format!("`{f}`"))
        .collect();
    let command = format!("$ cargo exercise {}/{}", list.chapter, exercise.name);
    let mut text = format!(
        "<section class=\"exercise\" id=\"exercise-{}\">\n<div class=\"box-title\">\n\n<span class=\"box-label\">Exercise {number}{}</span> {}\n\n</div>\n\nWrite {} in `exercises/{}/{}`, then run:\n\n{}\n",
        exercise.name,
        index + 1,
        exercise.title,
        functions.join(" and "),
        list.chapter,
        exercise.file,
        fenced("console", &command),
    );
    let graded: Vec<String> = in_order(expander)
        .iter()
        .filter(|(_, t)| t.chapter == list.chapter && t.exercises.contains(&exercise.name))
        .map(|(spot, theorem)| link(expander, page, spot, theorem))
        .collect();
    let _ = write!(
        text,
        "It is graded by {}.\n\n</section>\n\n",
        graded.join(", ")
    );
    text
}

/// The table of speed against error of a chapter, one block a quantity, with the machine that it was measured on; only the quantities
/// that begin with `beginning` where it is given.
pub fn speed(
    expander: &mut Expander<'_>,
    chapter: &str,
    beginning: Option<&str>,
    place: Place<'_>,
) -> Option<String> {
    let Some(file) = measure::table_file(&expander.material.root, chapter) else {
        let message =
            format!("no measurements of `{chapter}`: expected book/measurements/{chapter}.csv");
        expander.problems.add(place.file, place.first_line, message);
        return None;
    };
    let read = std::fs::read_to_string(expander.material.root.join(&file))
        .map_err(|error| (1, error.to_string()))
        .and_then(|text| measure::parse(&text));
    match read {
        Ok(mut table) => {
            let beginning = beginning.unwrap_or_default();
            table.rows.retain(|row| row[0].starts_with(beginning));
            if table.rows.is_empty() {
                let message = format!(
                    "no quantity of {} begins with `{beginning}`",
                    file.display()
                );
                expander.problems.add(place.file, place.first_line, message);
                return None;
            }
            Some(speed_table(&table))
        }
        Err((line, message)) => {
            expander.problems.add(Path::new(&file), line, message);
            None
        }
    }
}

fn speed_table(table: &measure::Measurements) -> String {
    let labels: Vec<String> = table
        .labels
        .iter()
        .map(|(key, value)| format!("{key}: {value}"))
        .collect();
    let mut text = format!("\n\n<div class=\"speed\">\n\n{}\n\n", labels.join("; "));
    for rows in table.rows.chunk_by(|row, next| row[0] == next[0]) {
        text.push_str(&speed_block(rows));
    }
    text.push_str("\n\n</div>\n\n");
    text
}

/// The rows of one quantity. Where `n` or the number of threads differs between them it has a column, and so has the share of wrong answers
/// where there are answers.
fn speed_block(rows: &[Vec<String>]) -> String {
    const NAMES: [(&str, usize); 12] = [
        ("algorithm", 1),
        ("scalar", 2),
        ("threads", 3),
        ("inputs", 4),
        ("n", 5),
        ("ns", 6),
        ("spread", 7),
        ("ratio", 8),
        ("max ulp", 9),
        ("max error", 10),
        ("rms", 11),
        ("wrong", 12),
    ];
    let first = &rows[0];
    let varies = |column: usize| rows.iter().any(|row| row[column] != first[column]);
    let is_shown = |column: usize| match column {
        3 | 5 => varies(column),
        12 => rows.iter().any(|row| !row[12].is_empty()),
        _ => true,
    };
    let columns = NAMES.iter().filter(|(_, column)| is_shown(*column));
    let columns: Vec<_> = columns.collect();
    let common = [
        (5, format!("evaluations: {}", first[5])),
        (3, format!("threads: {}", first[3])),
    ];
    let common: Vec<_> = common
        .into_iter()
        .filter_map(|(column, text)| (!varies(column)).then_some(text))
        .collect();
    let mut text = format!("\n**{}**", first[0]);
    if !common.is_empty() {
        let _ = write!(text, " ({})", common.join(", "));
    }
    text.push_str("\n\n|");
    for (name, _) in &columns {
        let _ = write!(text, " {name} |");
    }
    text.push_str("\n|");
    for (_, column) in &columns {
        text.push_str(if *column < 5 { " --- |" } else { " ---: |" });
    }
    text.push('\n');
    for row in rows {
        let cells = columns
            .iter()
            .map(|(_, column)| row[*column].replace('|', "&#124;"));
        let cells: Vec<_> = cells.collect();
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text
}
