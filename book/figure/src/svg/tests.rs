//! What must hold of every drawing.

use super::*;

fn stroke() -> Stroke {
    Stroke::new(Colour::Ink, 2.0)
}

fn picture() -> Picture {
    Picture {
        width: 2,
        height: 1,
        rgba: vec![200; 8],
    }
}

fn everything() -> Drawing {
    let square = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]];
    Drawing::new(100.0, 50.5)
        .line([0.0, 0.0], [1.0, 1.0], stroke().dashes(Dashes::Dotted))
        .polyline(&square, stroke().dashes(Dashes::Dashed))
        .area(&square, Colour::Blue, 0.5)
        .outline(&square, stroke().dashes(Dashes::DashDotted))
        .bezier([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]], stroke())
        .disc([1.0, 2.0], 3.0, Colour::Green)
        .circle([1.0, 2.0], 3.0, stroke())
        .arrow([0.0, 0.0], [10.0, 0.0], stroke())
        .text([5.0, 5.0], "a < b", 12.0, Anchor::End)
        .haloed_text([5.0, 9.0], "c & d", 12.0, Anchor::Start)
        .picture([0.0, 0.0], [20.0, 10.0], &picture())
}

#[test]
fn a_drawing_follows_its_page() {
    let svg = everything().to_svg("Title & more", "What <is> seen");
    assert!(svg.starts_with(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50.5" role="img""#
    ));
    assert!(svg.contains("<title>Title &amp; more</title>\n<desc>What &lt;is&gt; seen</desc>"));
    let opening = svg.split('>').next().unwrap_or_default();
    assert!(
        !opening.contains(" width=") && !opening.contains(" height="),
        "{opening}"
    );
    assert!(
        !svg.contains(" id="),
        "an id would clash with another figure's"
    );
}

#[test]
fn numbers_have_two_decimals_and_elements_are_closed() {
    let svg = everything().to_svg("t", "d");
    for attribute in [" cx=\"", " r=\"", " x=\"", " stroke-width=\""] {
        let (_, rest) = svg
            .split_once(attribute)
            .expect("everything has every attribute");
        let (value, _) = rest.split_once('"').expect("attributes are closed");
        assert_eq!(
            value.rsplit_once('.').map(|(_, decimals)| decimals.len()),
            Some(2),
            "{value}"
        );
    }
    let opened = svg.matches('<').count() - svg.matches("</").count();
    assert_eq!(
        opened,
        svg.matches("</").count() + svg.matches("/>").count()
    );
}

#[test]
fn an_arrow_ends_in_its_point_and_one_without_length_is_not_drawn() {
    let arrow = Drawing::new(9.0, 9.0).arrow([0.0, 0.0], [0.0, 8.0], stroke());
    assert!(
        arrow.body.contains(r#"<polygon points="0.00,8.00 "#),
        "{}",
        arrow.body
    );
    let nothing = Drawing::new(9.0, 9.0).arrow([1.0, 1.0], [1.0, 1.0], stroke());
    assert_eq!(nothing, Drawing::new(9.0, 9.0));
}

#[test]
fn the_picture_in_a_drawing_is_the_png_of_the_picture() {
    let svg = everything().to_svg("t", "d");
    let (_, rest) = svg.split_once("base64,").expect("the picture is embedded");
    let (data, _) = rest.split_once('"').expect("attributes are closed");
    assert_eq!(data, base64::encode(&picture().to_png()));
}

#[test]
#[allow(
    clippy::float_cmp,
    reason = "the same sums of small numbers, which are exact"
)]
fn panels_fill_the_page_row_by_row() {
    let cells: Vec<Panel> = (0..5).map(|_| Panel::picture("*S*", picture())).collect();
    let drawing = panels(2, &cells);
    let width = (PAGE_WIDTH - 14.0) / 2.0;
    assert_eq!(
        drawing.size(),
        [PAGE_WIDTH, 3.0 * (width / 2.0 + 26.0) + 2.0 * 14.0]
    );
    assert_eq!(drawing.body.matches("<image").count(), 5);
    let right = format!("<image x=\"{:.2}\"", width + 14.0);
    assert_eq!(drawing.body.matches(&right).count(), 2);
    assert_eq!(panels(0, &[]).size(), [PAGE_WIDTH, 0.0]);
}

#[test]
fn signs_stand_between_panels() {
    let cells = [
        Panel::drawing("a", everything()),
        Panel::drawing("", everything()).preceded_by("="),
    ];
    let body = panels(2, &cells).body;
    assert!(
        body.contains(r#"<text x="375.00""#) && body.contains(">=</text>"),
        "{body}"
    );
}

#[test]
fn a_haloed_text_stands_in_ink_over_itself_in_the_colour_of_the_page() {
    let svg = Drawing::new(10.0, 10.0)
        .haloed_text([1.0, 2.0], "*Q*_1", 10.0, Anchor::Start)
        .to_svg("t", "d");
    let texts: Vec<_> = svg
        .lines()
        .filter(|line| line.starts_with("<text"))
        .collect();
    let [under, over] = texts[..] else {
        unreachable!("a halo and its text, not {texts:?}")
    };
    assert!(under.contains(r#"stroke="var(--bg, #ffffff)" stroke-width="3.00""#));
    assert!(over.contains(r#"fill="currentColor""#) && !over.contains("stroke"));
}
