//! What must hold of the scatter plot, on an invented report.

use super::*;

const HEADING: &str =
    "quantity,algorithm,scalar,threads,inputs,n,ns_per_eval,spread,ratio,max_ulp,max_abs,rms,wrong";

/// An invented report: nothing was measured.
const INVENTED: &str = "\
# processor: an invented one
# date: 2000-01-01
quantity,algorithm,scalar,threads,inputs,n,ns_per_eval,spread,ratio,max_ulp,max_abs,rms,wrong
point,direct,f64,1,typical,1000,20,0.01,1,3,4e-16,1e-16,
point,direct,f64,1,hard,1000,21,0.01,1,9,3e-13,1e-16,
point,direct,f32,1,typical,1000,14,0.01,0.7,3,2e-7,1e-8,
point,fused,f64,1,typical,1000,9,0.01,0.4,3,6e-16,1e-16,
point,rational,exact,1,typical,1000,9000,0.01,400,0,0,0,
point,write only,f64,1,typical,1000,1.5,0.01,0.1,,,,
normal,direct,f64,4,typical,1000,30,0.01,1,3,4e-16,1e-16,
normal,direct,f64,4,hard,1000,31,0.01,1,NaN,NaN,NaN,
";

fn figure(csv: &str) -> Result<Figure, SpeedError> {
    scatter(
        csv,
        "speed",
        "A caption.".to_string(),
        "A description.".to_string(),
    )
}

fn svg(csv: &str) -> String {
    match figure(csv).expect("a good report").content {
        Content::Svg(text) => text,
        Content::Png(_) => panic!("the scatter plot is an SVG"),
    }
}

#[test]
fn every_quantity_has_a_panel_and_every_variant_its_name_once() {
    let svg = svg(INVENTED);
    assert_eq!(svg.matches("time per evaluation / ns").count(), 2);
    for (text, count) in [
        (">direct</text>", 2),
        (">fused</text>", 1),
        (">rational</text>", 1),
        (">direct, 4 threads</text>", 1),
        (">write only</text>", 1),
        (">0 (exact)</text>", 1),
        (">measured on an invented one, 2000-01-01</text>", 1),
    ] {
        assert_eq!(svg.matches(text).count(), count, "{text}");
    }
}

#[test]
fn what_has_no_place_on_the_axis_is_told_in_words() {
    let told = "not shown: direct, f64, hard inputs, 31 ns: the error is not finite";
    assert!(svg(INVENTED).contains(told));
}

#[test]
fn different_sizes_are_named() {
    let more = format!("{INVENTED}normal,direct,f64,1,typical,8,40,0.01,1,3,4e-16,1e-16,\n");
    assert!(svg(&more).contains(">direct, n = 8</text>"));
}

#[test]
fn bad_lines_are_refused_with_their_number() {
    let cases = [
        (
            "point,direct",
            "line 2 of the speed report: has 2 fields, expected 13",
        ),
        (
            "p,a,f64,1,easy,9,1,0,1,0,0,0,",
            "the inputs are \"easy\", expected typical or hard",
        ),
        (
            "p,a,f64,1,hard,9,fast,0,1,0,0,0,",
            "ns_per_eval holds \"fast\", expected a number",
        ),
        (
            "p,a,f64,1,hard,9,0,0,1,0,0,0,",
            "expected a positive number of nanoseconds",
        ),
        (
            "p,a,f64,1,hard,9,NaN,0,1,0,0,0,",
            "expected a positive number of nanoseconds",
        ),
        (
            "p,a,f64,1,hard,9,1,0,1,0,-1,0,",
            "the largest absolute error is negative",
        ),
    ];
    for (line, expected) in cases {
        let error = figure(&format!("{HEADING}\n{line}\n"))
            .expect_err("a bad line")
            .to_string();
        assert!(error.contains(expected), "{error}");
    }
    let no_heading = figure("a,b\n").expect_err("no heading").to_string();
    assert!(no_heading.starts_with("line 1 of the speed report: expected the heading quantity,"));
    assert_eq!(figure(HEADING), Err(SpeedError::Empty));
    assert_eq!(figure(""), Err(SpeedError::Empty));
}

#[test]
fn a_quantity_with_nothing_to_place_is_refused_by_name() {
    let line = "cost,write only,f64,1,typical,9,1.5,0,1,,,,";
    let error = figure(&format!("{HEADING}\n{line}\n"))
        .expect_err("no point")
        .to_string();
    assert!(
        error.starts_with("the speed report's quantity \"cost\": "),
        "{error}"
    );
}
