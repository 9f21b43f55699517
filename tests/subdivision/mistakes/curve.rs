//! Mistakes in one round of a scheme for polygons.

use facette::algebra::{Scalar, VectorSpace};
use facette::subdivision::curve::{Ends, edges, neighbours};

/// Chaikin's round with a mistake; `None` where it has none of this name.
pub fn chaikin_step<P: VectorSpace>(name: &str, points: &[P], ends: Ends) -> Option<Vec<P>> {
    let part = |numerator, denominator| P::Scalar::ratio(numerator, denominator);
    let [quarter, three_quarters] = [part(1, 4), part(3, 4)];
    let right = |[p, next]: [P; 2]| vec![p.lerp(next, quarter), p.lerp(next, three_quarters)];
    let with_ends = |inner: Vec<P>| match (ends, points) {
        (Ends::Kept, [first, ..]) => {
            let last = points[points.len() - 1];
            [&[*first][..], &inner, &[last]].concat()
        }
        _ => inner,
    };
    let cut = |on_edge: &dyn Fn([P; 2]) -> Vec<P>, ends| {
        edges(points, ends).flat_map(on_edge).collect::<Vec<P>>()
    };
    let at = |a, b| move |[p, next]: [P; 2]| vec![p.lerp(next, a), p.lerp(next, b)];
    Some(match name {
        "swapped_points" => with_ends(cut(&at(three_quarters, quarter), ends)),
        "thirds" => with_ends(cut(&at(part(1, 3), part(2, 3)), ends)),
        "one_point_on_an_edge" => with_ends(cut(&|[p, next]| vec![p.lerp(next, part(1, 2))], ends)),
        "cut_from_the_new_point" => {
            let on_edge = |[p, next]: [P; 2]| {
                let q = p.lerp(next, quarter);
                vec![q, q.lerp(next, three_quarters)]
            };
            with_ends(cut(&on_edge, ends))
        }
        "vertices_left_in" => {
            let on_edge = |edge: [P; 2]| [vec![edge[0]], right(edge)].concat();
            with_ends(cut(&on_edge, ends))
        }
        "closing_edge_forgotten" => with_ends(cut(&right, Ends::Open)),
        "open_polygon_closed" => with_ends(cut(&right, Ends::Closed)),
        "ends_lost" => cut(&right, ends),
        "one_end_kept" => {
            let mut finer = with_ends(cut(&right, ends));
            if ends == Ends::Kept {
                finer.pop();
            }
            finer
        }
        _ => return None,
    })
}

/// A round of the cubic scheme with a mistake; `None` where it has none of this name.
pub fn cubic_step<P: VectorSpace>(name: &str, points: &[P], ends: Ends) -> Option<Vec<P>> {
    let mask = |weights: [i32; 3]| {
        let sum = weights.iter().sum();
        weights.map(|weight| P::Scalar::ratio(weight, sum))
    };
    let half = P::Scalar::ratio(1, 2);
    let right = mask([1, 6, 1]);
    Some(match name {
        "limit_mask" => interleaved(points, ends, mask([1, 4, 1])),
        "tent_mask" => interleaved(points, ends, mask([1, 2, 1])),
        "vertices_stay" => interleaved(points, ends, mask([0, 1, 0])),
        "midpoints_of_moved_vertices" => {
            let moved: Vec<P> = (0..points.len())
                .map(|index| match neighbours(points, index, ends) {
                    [Some(before), Some(next)] => {
                        P::combination(right, [before, points[index], next])
                    }
                    _ => points[index],
                })
                .collect();
            let mut finer = interleaved(points, ends, right);
            let first_edge = usize::from(ends != Ends::Open);
            let middles = edges(&moved, ends).map(|[p, next]| p.lerp(next, half));
            for (place, middle) in finer.iter_mut().skip(first_edge).step_by(2).zip(middles) {
                *place = middle;
            }
            finer
        }
        "edges_first" => {
            let mut finer = interleaved(points, ends, right);
            if ends == Ends::Closed && !finer.is_empty() {
                finer.rotate_left(1);
            }
            finer
        }
        "first_and_last_vertex_forgotten" => {
            let ends = if ends == Ends::Closed {
                Ends::Open
            } else {
                ends
            };
            interleaved(points, ends, right)
        }
        "vertices_at_kept_ends_lost" => {
            let ends = if ends == Ends::Kept { Ends::Open } else { ends };
            interleaved(points, ends, right)
        }
        "ends_stay_when_open" => {
            let ends = if ends == Ends::Open { Ends::Kept } else { ends };
            interleaved(points, ends, right)
        }
        "ends_move" => {
            let mut finer = interleaved(points, ends, right);
            if let (Ends::Kept, [first, second, ..]) = (ends, points) {
                let count = points.len();
                let eighth = P::Scalar::ratio(1, 8);
                finer[0] = first.lerp(*second, eighth);
                let end = finer.len() - 1;
                finer[end] = points[count - 1].lerp(points[count - 2], eighth);
            }
            finer
        }
        _ => return None,
    })
}

/// Vertex and edge points in turn, the vertex points with this mask.
fn interleaved<P: VectorSpace>(points: &[P], ends: Ends, mask: [P::Scalar; 3]) -> Vec<P> {
    let mut finer = Vec::new();
    for (index, &p) in points.iter().enumerate() {
        let [before, next] = neighbours(points, index, ends);
        match (before, next) {
            (Some(before), Some(next)) => finer.push(P::combination(mask, [before, p, next])),
            _ if ends == Ends::Kept => finer.push(p),
            _ => {}
        }
        finer.extend(next.map(|next| p.lerp(next, P::Scalar::ratio(1, 2))));
    }
    finer
}

/// Lane and Riesenfeld's round with a mistake; `None` where it has none of this name.
pub fn double_and_average<P: VectorSpace>(
    name: &str,
    points: &[P],
    degree: usize,
) -> Option<Vec<P>> {
    let doubled = |points: &[P]| -> Vec<P> { points.iter().flat_map(|&p| [p, p]).collect() };
    let middle = |p: P, next: P| p.lerp(next, P::Scalar::ratio(1, 2));
    let averaged = |points: &[P]| -> Vec<P> {
        points
            .windows(2)
            .map(|pair| middle(pair[0], pair[1]))
            .collect()
    };
    let rounds =
        |points: Vec<P>, count: usize| (0..count).fold(points, |points, _| averaged(&points));
    Some(match name {
        "one_average_more" => rounds(doubled(points), degree + 1),
        "one_average_less" => rounds(doubled(points), degree - 1),
        "not_doubled" => rounds(points.to_vec(), degree),
        "list_twice" => rounds([points, points].concat(), degree),
        "averaged_with_the_new_neighbour" => {
            let mut finer = doubled(points);
            for _ in 0..degree {
                for index in (1..finer.len()).rev() {
                    finer[index - 1] = middle(finer[index - 1], finer[index]);
                }
                finer.pop();
            }
            finer
        }
        "last_point_left" => {
            let round = |points: Vec<P>| {
                let last = points.last().copied();
                averaged(&points)
                    .into_iter()
                    .chain(last)
                    .collect::<Vec<P>>()
            };
            (0..degree).fold(doubled(points), |points, _| round(points))
        }
        "closed_by_a_mean" => {
            let round = |points: Vec<P>| {
                let closing = points
                    .last()
                    .zip(points.first())
                    .map(|(&last, &first)| middle(last, first));
                averaged(&points)
                    .into_iter()
                    .chain(closing)
                    .collect::<Vec<P>>()
            };
            (0..degree).fold(doubled(points), |points, _| round(points))
        }
        "doubled_every_round" => {
            (0..degree).fold(points.to_vec(), |points, _| averaged(&doubled(&points)))
        }
        _ => return None,
    })
}
