//! Simple polygons of a plane cut into triangles.

use crate::algebra::{Scalar, larger};

/// Twice the area of the triangle `a b c`, positive where it turns left; 0 where rounding hides the sign.
///
/// # Source
///
/// The error bound of the two products: Shewchuk 1997, section 4.1, `ccwerrboundA`.
// ANCHOR: turn
pub(crate) fn turn<S: Scalar>(a: [S; 2], b: [S; 2], c: [S; 2]) -> S {
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    let u = S::unit_roundoff();
    let factor = (S::from_i32(3) + S::from_i32(16) * u) * u;
    let area = left - right;
    if area.magnitude() > factor * (left.magnitude() + right.magnitude()) {
        return area;
    }
    S::zero()
}
// ANCHOR_END: turn

/// What is left of a polygon while ears are cut from it; the lists run in step.
struct Rest<'a, S> {
    corners: &'a [[S; 2]],
    /// The numbers of the corners that are left, in order.
    left: Vec<u32>,
    /// Whether the polygon turns left there for sure.
    turns_left: Vec<bool>,
    /// The shape of the ear there; `None` where there is none.
    ears: Vec<Option<S>>,
}

/// The triangles of a simple polygon that runs anticlockwise, corner by corner the ear whose shape is best; fewer than
/// `corners.len() − 2` where rounding hides on which side of each other the last corners lie.
///
/// # Cost
///
/// O(n²) for n corners. Only two corners change when an ear is cut, and each is compared with those corners only at which the polygon may not
/// turn left. Each time that rounding hides all ears that are left, they are looked for once more among all corners, in O(n²).
///
/// # Source
///
/// Meisters 1975: every simple polygon with more than three corners has two ears.
// ANCHOR: ears
pub(crate) fn ears<S: Scalar>(corners: &[[S; 2]]) -> Vec<[u32; 3]> {
    let mut rest = Rest::new(corners);
    let mut triangles = Vec::new();
    while rest.left.len() >= 3 {
        let Some(best) = rest.best().or_else(|| rest.best_of_all()) else {
            break;
        };
        triangles.push(rest.around(best));
        rest.cut(best);
    }
    triangles
}
// ANCHOR_END: ears

impl<'a, S: Scalar> Rest<'a, S> {
    fn new(corners: &'a [[S; 2]]) -> Self {
        let count = corners.len();
        let mut rest = Self {
            corners,
            left: (0..).take(count).collect(),
            turns_left: vec![false; count],
            ears: vec![None; count],
        };
        rest.look_at((0..count).collect());
        rest
    }

    /// The numbers of the corner before, the corner itself and the one after.
    fn around(&self, at: usize) -> [u32; 3] {
        let count = self.left.len();
        [(at + count - 1) % count, at, (at + 1) % count].map(|place| self.left[place])
    }

    fn points(&self, ear: [u32; 3]) -> [[S; 2]; 3] {
        ear.map(|corner| self.corners[corner as usize])
    }

    /// Finds out anew at these places how the polygon turns, and then what ears there are.
    fn look_at(&mut self, places: Vec<usize>) {
        for &at in &places {
            let [a, b, c] = self.points(self.around(at));
            self.turns_left[at] = turn(a, b, c) > S::zero();
        }
        for at in places {
            self.ears[at] = self.ear(at);
        }
    }

    /// The shape of the ear at a corner; `None` where there is none, or where rounding hides it.
    ///
    /// Corners at which the polygon turns left need not be compared: if any corners lie in the triangle, the polygon does not turn left at that
    /// one of them which is nearest to the tip, counted from the base. For its two neighbours lie nearer to the base, or in line with it, while
    /// the way from it to the tip runs inside the polygon.
    // ANCHOR: ear
    fn ear(&self, at: usize) -> Option<S> {
        let ear = self.around(at);
        let points = self.points(ear);
        let is_in_the_way = |(&other, &turns_left): (&u32, &bool)| {
            !turns_left && !ear.contains(&other) && covers(points, self.corners[other as usize])
        };
        let mut others = self.left.iter().zip(&self.turns_left);
        let is_ear = self.turns_left[at] && !others.any(is_in_the_way);
        is_ear.then(|| shape(points))
    }
    // ANCHOR_END: ear

    /// The place of the ear with the best shape.
    fn best(&self) -> Option<usize> {
        let ears = self.ears.iter().enumerate();
        let ears = ears.filter_map(|(at, &shape)| Some((at, shape?)));
        let best = ears.reduce(|best, next| if next.1 > best.1 { next } else { best });
        best.map(|(at, _)| at)
    }

    /// The same, after a look at every corner: one that was in the way of an ear by rounding alone may turn left by now.
    fn best_of_all(&mut self) -> Option<usize> {
        self.look_at((0..self.left.len()).collect());
        self.best()
    }

    /// Cuts the ear at this place: its two neighbours have a new one.
    fn cut(&mut self, at: usize) {
        self.left.remove(at);
        self.turns_left.remove(at);
        self.ears.remove(at);
        let count = self.left.len();
        self.look_at(vec![(at + count - 1) % count, at % count]);
    }
}

/// Twice the area over the square of the longest side: the higher, the better shaped.
fn shape<S: Scalar>([a, b, c]: [[S; 2]; 3]) -> S {
    let square =
        |p: [S; 2], q: [S; 2]| (q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]);
    let longest = larger(larger(square(a, b), square(b, c)), square(c, a));
    turn(a, b, c) / longest
}

/// Whether a triangle, its edges included, covers the point.
fn covers<S: Scalar>([a, b, c]: [[S; 2]; 3], point: [S; 2]) -> bool {
    [[a, b], [b, c], [c, a]]
        .into_iter()
        .all(|[from, to]| turn(from, to, point) >= S::zero())
}
