//! Inputs that a step of a scheme must survive, with values known beforehand.

use facette::algebra::Scalar;
use facette::subdivision::{Connectivity, Corners, catmull_clark};

use crate::common::exact::fraction;
use crate::meshes::cube;

/// **The first round.** A cube with corners $0$ and $1$: Catmull-Clark moves the corner at the origin to $\left(\tfrac29,\tfrac29,\tfrac29\right)$, and in the cube
/// with corners $\pm1$ every corner to $\pm\tfrac59$.
#[test]
fn first_round_of_the_cube() {
    let cube = cube();
    let connectivity = Connectivity::new(&cube).expect("a closed mesh");
    let refined =
        catmull_clark(&connectivity, &cube.positions, Corners::Sharp).expect("a closed mesh");
    assert_eq!(refined.positions[7], [fraction(5, 9); 3]);
    let edges = &refined.positions[8..20];
    let is_right = |point: &[_; 3]| {
        point.iter().all(|c: &crate::common::exact::Exact| {
            c.magnitude() == fraction(3, 4) || *c == fraction(0, 1)
        })
    };
    assert!(edges.iter().all(is_right));
}
