//! Places for the names of points, so that they cover neither each other nor the points.

use crate::svg::estimated_width;

/// Where a label goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    /// The start of the text's baseline.
    pub baseline: [f64; 2],
    /// Where a line from the point to the label ends, if the label stands apart.
    pub leader: Option<[f64; 2]>,
}

/// A rectangle: left, right, top, bottom.
pub(super) type Rectangle = [f64; 4];

/// Half the size of a point's mark with its margin.
const MARK: f64 = 8.0;

/// What a label should not cover of a point's mark.
pub(super) fn around_mark([x, y]: [f64; 2]) -> Rectangle {
    [x - MARK, x + MARK, y - MARK, y + MARK]
}

/// What a label should not cover of a segment: a chain of small squares along it.
pub(super) fn along_segment([from, to]: [[f64; 2]; 2]) -> impl Iterator<Item = Rectangle> {
    (0..=32).map(move |step| {
        let t = f64::from(step) / 32.0;
        let [x, y] = [0, 1].map(|which| from[which] + t * (to[which] - from[which]));
        [x - 3.0, x + 3.0, y - 3.0, y + 3.0]
    })
}

/// The rectangle of a text whose baseline starts at a point.
pub(super) fn text_rectangle([left, baseline]: [f64; 2], text: &str, size: f64) -> Rectangle {
    let bottom = baseline + 0.22 * size;
    [
        left,
        left + estimated_width(text) * size,
        bottom - size,
        bottom,
    ]
}

/// The start of the baseline of a text that stands on or hangs from a horizontal guide, where it covers least: rather at
/// the right end than in the middle or at the left, rather above than below.
pub(super) fn on_guide(
    y: f64,
    text: &str,
    obstacles: &[Rectangle],
    area: Rectangle,
    size: f64,
) -> [f64; 2] {
    let [left, right, ..] = area;
    let free = right - left - 8.0 - estimated_width(text) * size;
    let places = [1.0, 0.75, 0.5, 0.25, 0.0].into_iter().flat_map(|part| {
        [y - 5.0, y + 4.0 + 0.78 * size].map(|baseline| [left + 4.0 + part * free, baseline])
    });
    let mut best = (f64::INFINITY, [left, y]);
    for place in places {
        let rectangle = text_rectangle(place, text, size);
        let covered: f64 = obstacles
            .iter()
            .map(|other| overlap(rectangle, *other))
            .sum();
        let inside = overlap(rectangle, area);
        if covered - inside < best.0 {
            best = (covered - inside, place);
        }
    }
    best.1
}

/// A place for each label (its point and text), the best of a fixed set of candidates around the point, one label
/// after the other, inside the area and off the obstacles.
pub(super) fn place(
    labels: &[([f64; 2], &str)],
    obstacles: Vec<Rectangle>,
    area: Rectangle,
    size: f64,
) -> Vec<Place> {
    let mut taken = obstacles;
    let mut places = Vec::with_capacity(labels.len());
    for (point, text) in labels {
        let extent = [estimated_width(text) * size, size];
        let cost = |rectangle: &Rectangle| {
            let outside = extent[0] * extent[1] - overlap(*rectangle, area);
            let covered: f64 = taken.iter().map(|other| overlap(*rectangle, *other)).sum();
            covered + 10.0 * outside
        };
        let mut best = (f64::INFINITY, candidate(*point, extent, 0, 0.0));
        for (order, (distance, direction)) in candidates().enumerate() {
            let rectangle = candidate(*point, extent, direction, distance);
            // Nearer places come first, but any overlap that could be seen counts for more.
            let total = 100.0 * cost(&rectangle) + order as f64;
            if total < best.0 {
                best = (total, rectangle);
            }
        }
        let rectangle = best.1;
        taken.push(rectangle);
        let [left, right, top, bottom] = rectangle;
        let nearest = [point[0].clamp(left, right), point[1].clamp(top, bottom)];
        let gap = (nearest[0] - point[0]).hypot(nearest[1] - point[1]);
        places.push(Place {
            baseline: [left, bottom - 0.22 * size],
            leader: (gap > 2.0 * MARK).then_some(nearest),
        });
    }
    places
}

fn candidates() -> impl Iterator<Item = (f64, usize)> {
    let distances = [0.0, 12.0, 26.0, 42.0, 60.0, 80.0];
    distances
        .into_iter()
        .flat_map(|distance| (0..8).map(move |direction| (distance, direction)))
}

/// The rectangle of a label in one of eight directions from its point, the most readable first.
fn candidate(
    [x, y]: [f64; 2],
    [width, height]: [f64; 2],
    direction: usize,
    distance: f64,
) -> Rectangle {
    let directions: [[f64; 2]; 8] = [
        [1.0, 0.0],
        [-1.0, 0.0],
        [0.0, -1.0],
        [0.0, 1.0],
        [0.7, -0.7],
        [0.7, 0.7],
        [-0.7, -0.7],
        [-0.7, 0.7],
    ];
    let [across, down] = directions[direction % directions.len()];
    let reach = MARK + 2.0 + distance;
    let centre = [
        x + across * (reach + width / 2.0),
        y + down * (reach + height / 2.0),
    ];
    [
        centre[0] - width / 2.0,
        centre[0] + width / 2.0,
        centre[1] - height / 2.0,
        centre[1] + height / 2.0,
    ]
}

/// The area that two rectangles share.
fn overlap(first: Rectangle, second: Rectangle) -> f64 {
    let width = first[1].min(second[1]) - first[0].max(second[0]);
    let height = first[3].min(second[3]) - first[2].max(second[2]);
    width.max(0.0) * height.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rectangle = [0.0, 400.0, 0.0, 300.0];

    fn marks(points: &[[f64; 2]]) -> Vec<Rectangle> {
        points.iter().copied().map(around_mark).collect()
    }

    #[test]
    fn a_lonely_label_stands_right_of_its_point() {
        let places = place(
            &[([100.0, 100.0], "direct")],
            marks(&[[100.0, 100.0]]),
            AREA,
            13.0,
        );
        assert!(places[0].baseline[0] > 100.0 && places[0].leader.is_none());
    }

    #[test]
    fn labels_of_points_in_a_heap_cover_neither_each_other_nor_points_and_stay_inside() {
        let points: Vec<[f64; 2]> = (0..8)
            .map(|index| [390.0, 150.0 + 4.0 * f64::from(index)])
            .collect();
        let texts = [
            "direct", "fused", "row-wise", "by eight", "lerp", "blend", "sum", "naive",
        ];
        let labels: Vec<_> = points.iter().copied().zip(texts).collect();
        let places = place(&labels, marks(&points), AREA, 13.0);
        let rectangles: Vec<_> = places
            .iter()
            .zip(texts)
            .map(|(place, text)| text_rectangle(place.baseline, text, 13.0))
            .collect();
        for (index, &first) in rectangles.iter().enumerate() {
            assert!(
                first[0] >= AREA[0] && first[1] <= AREA[1],
                "{first:?} leaves the plot"
            );
            for &second in &rectangles[..index] {
                assert!(overlap(first, second) <= 0.0, "{first:?} covers {second:?}");
            }
        }
    }

    #[test]
    fn a_label_keeps_off_a_line_through_its_point() {
        let ends = [[100.0, 100.0], [300.0, 100.0]];
        let line: Vec<_> = along_segment(ends).collect();
        let places = place(&[(ends[0], "direct")], line.clone(), AREA, 13.0);
        let found = text_rectangle(places[0].baseline, "direct", 13.0);
        assert!(
            line.iter().all(|&square| overlap(found, square) <= 0.0),
            "{found:?}"
        );
    }

    #[test]
    fn the_text_of_a_guide_keeps_off_points() {
        let area = AREA;
        assert!(on_guide(150.0, "yardstick", &[], area, 13.0)[0] > 300.0);
        let obstacles = marks(&[[370.0, 145.0], [370.0, 160.0]]);
        let place = on_guide(150.0, "yardstick", &obstacles, area, 13.0);
        let found = text_rectangle(place, "yardstick", 13.0);
        assert!(
            obstacles.iter().all(|&mark| overlap(found, mark) <= 0.0),
            "{found:?}"
        );
    }
}
