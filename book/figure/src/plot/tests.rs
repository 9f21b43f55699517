//! What must hold of every plot.

use super::*;

fn plot() -> Plot {
    let curve: Vec<[f64; 2]> = (0..=10).map(f64::from).map(|x| [x, x * x]).collect();
    Plot::new("Squares", "side x / m", "area / m²").line("x²", &curve)
}

#[test]
fn a_plot_names_its_axes_and_follows_the_theme() {
    let svg = plot().to_svg("A parabola.").expect("finite points");
    for text in [
        "side x / m",
        "area / m²",
        "<title>Squares</title>",
        "<desc>A parabola.</desc>",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(svg.contains("currentColor") && svg.contains("var(--figure-blue, #0072b2)"));
    assert!(!svg.contains("#000000") && !svg.contains("#FFFFFF"));
    assert_eq!(svg.matches("<svg").count(), 1);
    assert_eq!(svg.matches("</svg>").count(), 1);
}

#[test]
fn the_same_plot_gives_the_same_text() {
    assert_eq!(plot().to_svg("d"), plot().to_svg("d"));
}

#[test]
fn series_differ_by_more_than_colour() {
    let two = plot()
        .line("again", &[[0.0, 0.0], [10.0, 50.0]])
        .to_svg("d")
        .expect("finite points");
    assert_eq!(
        two.matches("stroke-dasharray").count(),
        2,
        "one in the plot, one in the legend"
    );
    let points = [[1.0, 1.0]];
    let shapes = Plot::new("t", "x", "y")
        .points("a", &points)
        .points("b", &points);
    let svg = shapes.to_svg("d").expect("finite points");
    assert!(svg.contains("<circle") && svg.contains("<polygon"));
}

#[test]
fn points_without_a_place_are_refused_by_name() {
    let cases = [
        (Plot::new("t", "x", "y"), [f64::NAN, 1.0]),
        (Plot::new("t", "x", "y"), [1.0, f64::INFINITY]),
        (Plot::new("t", "x", "y").log_x(), [-1.0, 1.0]),
        (Plot::new("t", "x", "y").log_y(), [1.0, 0.0]),
    ];
    for (plot, point) in cases {
        let found = plot.points("measured", &[[1.0, 1.0], point]).to_svg("d");
        let message = found.expect_err("no place on an axis").to_string();
        assert!(
            message.starts_with("point 1 of \"measured\" is ("),
            "{message}"
        );
    }
    let empty = Plot::new("Nothing", "x", "y")
        .to_svg("d")
        .expect_err("no points");
    assert_eq!(empty.to_string(), "the plot \"Nothing\" has no points");
}

#[test]
fn zero_is_marked_as_exact_on_a_logarithmic_axis_only() {
    let points = [[0.0, 1.0], [1e-16, 2.0]];
    let exact = Plot::new("t", "x", "y")
        .log_x()
        .points("a", &points)
        .to_svg("d");
    assert!(exact.is_ok_and(|svg| svg.contains("0 (exact)")));
    let linear = Plot::new("t", "x", "y").points("a", &points).to_svg("d");
    assert!(linear.is_ok_and(|svg| !svg.contains("0 (exact)")));
}

#[test]
#[allow(clippy::float_cmp, reason = "the ends of an axis are exact")]
fn values_keep_their_order_in_the_drawing() {
    let plot = plot();
    let frame = Frame {
        axes: [plot.axis(0), plot.axis(1)],
        area: [60.0, 700.0, 20.0, 350.0],
    };
    assert_eq!(frame.place([0.0, 0.0]), [60.0, 350.0]);
    assert_eq!(frame.place([10.0, 100.0]), [700.0, 20.0]);
}
