//! The theorems of rays and Bézier patches, in the order of the text. The book shows their doc comments.

use facette::algebra::VectorSpace;
use facette::intersection::Intersect;

use crate::patch_inputs::{ThroughAPoint, hard, wild};

#[test]
fn scratch() {
    use proptest::strategy::{Strategy, ValueTree};
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut missed = 0;
    let mut oblique = 0;
    let mut worst = 0.0_f64;
    for i in 0..4000 {
        let input: ThroughAPoint = if i % 4 > 0 {
            wild().new_tree(&mut runner).unwrap().current()
        } else {
            hard().new_tree(&mut runner).unwrap().current()
        };
        let patch = input.patch::<f64>();
        let ray = input.ray();
        let t = f64::from(input.t);
        let n = facette::surface::Surface::normal_vector(
            patch.surface(),
            input.parameters()[0],
            input.parameters()[1],
        );
        let cos = n.map_or(0.0, |n| {
            facette::algebra::Vector3::dot(n, ray.direction).abs()
                / facette::algebra::length(n)
                / facette::algebra::length(ray.direction)
        });
        let near = ray.after(t - 1e-7).until(t + 1e-7);
        match patch.intersect(&near) {
            None => {
                if cos > 1e-6 {
                    missed += 1;
                    println!("missed {input:?} cos {cos}");
                } else {
                    oblique += 1;
                }
            }
            Some(hit) => {
                let r = (hit.t - t).abs() / hit.t_error;
                if r > worst {
                    worst = r;
                    println!("{r} {} {cos}", hit.t_error);
                }
                let all = patch.intersect(&ray).expect("one");
                assert!(all.t <= t + all.t_error);
                let off = hit.point.minus(input.point()).largest_coordinate();
                if off > 1e-6 {
                    println!("off {off} {cos} {}", hit.t_error);
                }
            }
        }
    }
    println!("{missed} missed, {oblique} oblique");
}
#[test]
fn scratch2() {
    let input = ThroughAPoint {
        degrees: [3, 4],
        control_points: vec![
            [-4, -5, -5],
            [-5, -4, 3],
            [-8, 2, 0],
            [1, 8, -5],
            [2, -1, -3],
            [-7, -2, 1],
            [4, 5, 7],
            [-7, 4, -4],
            [-5, -2, -7],
            [0, -3, 4],
            [5, 3, -4],
            [-1, 3, -7],
            [2, -6, -7],
            [-8, -7, -7],
            [0, 1, 7],
            [5, 1, -2],
            [-5, 7, -5],
            [3, -3, 4],
            [6, 2, -4],
            [3, -1, 2],
        ],
        sixteenths: [16, 16],
        direction: [6, -8, -4],
        t: 128,
    };
    let patch = input.patch::<f64>();
    let ray = input.ray();
    for w in [1e-7, 1e-5, 1e-3, 1.0, 10.] {
        println!(
            "{:?}",
            patch.intersect(&ray.after(128. - w).until(128. + w))
        );
    }
}
