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

/// The table of speed against error of a chapter, one block a quantity, with the machine that it was measured on.
pub fn speed(expander: &mut Expander<'_>, chapter: &str, place: Place<'_>) -> Option<String> {
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
        Ok(table) => Some(speed_table(&table)),
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
    let mut quantity: Option<&str> = None;
    for row in &table.rows {
        if quantity != Some(row[0].as_str()) {
            quantity = Some(&row[0]);
            let _ = write!(
                text,
                "\n**{}** ({} evaluations, threads: {})\n\n| algorithm | scalar | inputs | ns | spread | ratio | max ulp | max error | rms |\n| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
                row[0], row[5], row[3]
            );
        }
        let shown = [1, 2, 4, 6, 7, 8, 9, 10, 11].map(|column| &row[column]);
        let cells = shown.map(|cell| cell.replace('|', "&#124;"));
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text.push_str("\n\n</div>\n\n");
    text
}
