//! The reader's package: what is copied, what is kept, what is remembered. In scratch houses, without a compiler.

use std::fs;
use std::path::{Path, PathBuf};

use facette_grader::catalogue::Chapter;
use facette_grader::command_line::{Command, Target};
use facette_grader::commands;
use facette_grader::house::House;
use facette_grader::theorem;
use facette_grader::workshop;

const TABLE: &str = r#"
chapter = "coons"
page = "coons.html"
[[exercise]]
name = "bilinear"
title = "The bilinear patch"
file = "src/bilinear.rs"
functions = ["bilinear_point"]
hints = ["first", "second"]
"#;

fn write(path: &Path, text: &str) {
    workshop::write(path, text).expect("a scratch file can be written");
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("a scratch file can be read")
}

/// A house of its own for each test, with one chapter of one exercise.
fn house(name: &str) -> (PathBuf, House) {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if root.exists() {
        fs::remove_dir_all(&root).expect("the scratch folder can be removed");
    }
    let templates = root.join("book/exercises/coons");
    write(&templates.join("exercise.toml"), TABLE);
    write(&templates.join("Cargo.toml"), "path = \"@ROOT@\"\n");
    write(&templates.join("src/lib.rs"), "mod bilinear;\n");
    write(&templates.join("src/bilinear.rs"), "stub\n");
    write(&templates.join("solutions/bilinear.rs"), "solution\n");
    write(&root.join("Cargo.lock"), "versions\n");
    let house = House::around(&templates).expect("the templates are there");
    assert_eq!(house.root(), root);
    (root, house)
}

fn bilinear() -> Target {
    Target {
        chapter: "coons".to_owned(),
        exercise: Some("bilinear".to_owned()),
    }
}

fn says(house: &House, command: &Command) -> String {
    let mut screen = Vec::new();
    let outcome = commands::run_in(house, command, &mut screen);
    match outcome {
        Ok(_) => String::from_utf8(screen).expect("reports are UTF-8"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn the_package_is_copied_once_and_the_readers_file_is_never_overwritten() {
    let (root, house) = house("copied-once");
    let chapter = Chapter::read(&house, "coons").expect("the table is right");
    assert!(workshop::install(&house, &chapter).expect("it can be copied"));
    let package = root.join("exercises/coons");
    assert_eq!(read(&package.join("Cargo.toml")), "path = \"../..\"\n");
    assert_eq!(read(&package.join("Cargo.lock")), "versions\n");
    assert_eq!(read(&package.join("src/bilinear.rs")), "stub\n");

    write(&package.join("src/bilinear.rs"), "mine\n");
    write(&root.join("book/exercises/coons/src/lib.rs"), "newer\n");
    write(
        &root.join("book/exercises/coons/src/bilinear.rs"),
        "newer stub\n",
    );
    assert!(!workshop::install(&house, &chapter).expect("it can be refreshed"));
    assert_eq!(read(&package.join("src/lib.rs")), "newer\n");
    assert_eq!(read(&package.join("src/bilinear.rs")), "mine\n");
}

#[test]
fn what_is_up_to_date_keeps_its_time() {
    let (root, house) = house("keeps-its-time");
    let chapter = Chapter::read(&house, "coons").expect("the table is right");
    let files = ["Cargo.toml", "Cargo.lock", "src/lib.rs", "src/bilinear.rs"];
    let times = || {
        files.map(|file| {
            let data = fs::metadata(root.join("exercises/coons").join(file));
            data.and_then(|data| data.modified())
                .expect("the file has a time")
        })
    };
    workshop::install(&house, &chapter).expect("it can be copied");
    let before = times();
    workshop::install(&house, &chapter).expect("it can be copied");
    assert_eq!(before, times());
}

#[test]
fn reset_restores_the_stub_and_keeps_the_file_beside_it() {
    let (root, house) = house("reset");
    let file = root.join("exercises/coons/src/bilinear.rs");
    let reset = Command::Reset(bilinear());
    assert!(says(&house, &reset).contains("is the stub already"));
    write(&file, "mine\n");
    let report = says(&house, &reset);
    assert!(
        report.contains("kept as exercises/coons/src/bilinear.rs.previous"),
        "{report}"
    );
    assert_eq!(read(&file), "stub\n");
    assert_eq!(
        read(&root.join("exercises/coons/src/bilinear.rs.previous")),
        "mine\n"
    );
    assert!(says(&house, &reset).contains("is the stub already"));
    assert_eq!(
        read(&root.join("exercises/coons/src/bilinear.rs.previous")),
        "mine\n"
    );
}

#[test]
fn reset_needs_an_exercise() {
    let (_, house) = house("reset-what");
    let chapter = Target {
        chapter: "coons".to_owned(),
        exercise: None,
    };
    let complaint = says(&house, &Command::Reset(chapter));
    assert!(complaint.starts_with("reset needs an exercise of chapter coons: bilinear"));
}

#[test]
fn hints_come_one_by_one_and_then_the_solution() {
    let (_, house) = house("hints");
    let hint = Command::Hint(bilinear());
    assert!(says(&house, &hint).contains("first"));
    let second = says(&house, &hint);
    assert!(
        second.contains("hint 2 of 2") && second.contains("second"),
        "{second}"
    );
    assert!(!second.contains("solutions"), "{second}");
    let last = says(&house, &hint);
    assert!(
        last.contains("book/exercises/coons/solutions/bilinear.rs"),
        "{last}"
    );
}

#[test]
fn the_list_tells_the_state() {
    let (root, house) = house("list");
    assert!(says(&house, &Command::List(None)).contains("not started"));
    write(&root.join("exercises/coons/src/bilinear.rs"), "mine\n");
    assert!(says(&house, &Command::List(None)).contains("changed since the last check"));
}

#[test]
fn theorems_come_from_all_files_of_the_chapter_and_grade_their_exercises() {
    let (root, house) = house("theorems");
    let test = |name: &str, trailer: &str| {
        format!("/// **{name}.** Text.\n{trailer}#[test]\nfn {name}() {{}}\n")
    };
    let tests = root.join("tests/coons");
    write(
        &tests.join("bicubic_theorems.rs"),
        &test("blended", "/// Exercise: bilinear.\n"),
    );
    write(&tests.join("theorems.rs"), &test("ruled", ""));
    write(&tests.join("hard_cases.rs"), &test("hard", ""));
    let chapter = Chapter::read(&house, "coons").expect("the table is right");
    let theorems = theorem::read(&house, &chapter).expect("the files are there");
    let names: Vec<&str> = theorems
        .iter()
        .map(|theorem| theorem.name.as_str())
        .collect();
    assert_eq!(names, ["ruled", "blended"]);
    let grading = theorem::of_exercise(&theorems, "coons", "bilinear").expect("one grades it");
    assert_eq!(grading, [&theorems[1]]);
    let error = theorem::of_exercise(&theorems, "coons", "knots").expect_err("none grades it");
    assert!(
        error
            .to_string()
            .contains("needs the line `/// Exercise: knots.`"),
        "{error}"
    );
}

#[test]
fn chapters_and_theorems_of_several_pages_come_in_the_order_of_the_book() {
    let (root, house) = house("several-pages");
    let templates = root.join("book/exercises/bspline");
    let table = TABLE.replace("coons", "bspline");
    write(&templates.join("exercise.toml"), &table);
    write(&templates.join("src/bilinear.rs"), "stub\n");
    write(&templates.join("solutions/bilinear.rs"), "solution\n");
    let test = |name: &str| format!("/// **{name}.** Text.\n#[test]\nfn {name}() {{}}\n");
    let tests = root.join("tests/bspline");
    write(&tests.join("basis_theorems.rs"), &test("hat"));
    write(&tests.join("curve_theorems.rs"), &test("hull"));
    write(&tests.join("surface_theorems.rs"), &test("corners"));
    let pages = root.join("book/src");
    let summary = "- [Coons](coons.md)\n- [B-splines](bspline.md)\n  - [Surfaces](bspline/surfaces.md)\n  - [Basis](bspline/basis.md)\n";
    write(&pages.join("SUMMARY.md"), summary);
    write(&pages.join("bspline.md"), "{{#theorem bspline::hull}}");
    write(&pages.join("bspline/basis.md"), "{{#theorem bspline::hat}}");
    write(
        &pages.join("bspline/surfaces.md"),
        "{{#theorem bspline::corners}}",
    );

    let chapters = Chapter::read_all(&house).expect("the tables are right");
    let names: Vec<&str> = chapters.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["coons", "bspline"]);
    let theorems = theorem::read(&house, &chapters[1]).expect("the files are there");
    let places: Vec<(&str, &str)> = theorems
        .iter()
        .map(|theorem| (theorem.name.as_str(), theorem.page.as_str()))
        .collect();
    let expected = [
        ("hull", "bspline.html"),
        ("corners", "bspline/surfaces.html"),
        ("hat", "bspline/basis.html"),
    ];
    assert_eq!(places, expected);
}

#[test]
fn unknown_names_are_answered_with_the_known_ones() {
    let (_, house) = house("unknown");
    let named = |chapter: &str, exercise: &str| {
        Command::Hint(Target {
            chapter: chapter.to_owned(),
            exercise: Some(exercise.to_owned()),
        })
    };
    let chapter = says(&house, &named("bspline", "knots"));
    assert!(
        chapter.ends_with("the chapters with exercises are coons"),
        "{chapter}"
    );
    let exercise = says(&house, &named("coons", "knots"));
    assert!(
        exercise.ends_with("its exercises are bilinear"),
        "{exercise}"
    );
}

#[test]
fn a_table_that_names_a_missing_file_is_refused() {
    let (root, house) = house("missing-file");
    let solution = root.join("book/exercises/coons/solutions/bilinear.rs");
    fs::remove_file(solution).expect("the solution is there");
    let error = Chapter::read(&house, "coons")
        .expect_err("its solution is missing")
        .to_string();
    assert!(
        error.contains("needs the file solutions/bilinear.rs"),
        "{error}"
    );
}

#[test]
fn outside_the_house_the_grader_says_where_to_go() {
    let error = House::around(Path::new("/")).expect_err("the root folder is no house");
    assert!(error.to_string().contains("book/exercises"), "{error}");
}
