//! The theorems of quadrilateral facets: bilinear patches, flat and twisted.

use std::cell::Cell;

use facette::algebra::{Real, Scalar, Vector3, VectorSpace};
use facette::intersection::quadrilateral::{Quadrilateral, bilinear_patch};
use facette::intersection::triangle::robust;
use facette::intersection::{Intersect, Side};
use facette::ray::Ray;
use facette::surface::Surface;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use crate::common::bound::Bound;
use crate::common::exact::Exact;
use crate::common::generators::{hard_parameter, parameter, point};
use crate::common::law::{Broken, Law, Verdict, expect_equal};
use crate::common::oracle::big;
use crate::quadrilateral_inputs::{
    Crossing, Place, crossings, exact_point, hard_twisted, parameter_of, planar, refined, twisted,
};
use crate::suspects;

/// How far from an edge, in u and v, a crossing must be for the rounding not to decide.
const MARGIN: f64 = 1e-6;

/// **Ruled twice.** The patch of four corners is $S(u,v)=(1-u)(1-v)\,\mathbf a+u(1-v)\,\mathbf b+uv\,\mathbf c+(1-u)v\,\mathbf d$: along every line $u=$ const and every line $v=$ const it is straight, with the
/// derivatives $S_u$ and $S_v$.
#[test]
fn quadrilateral_is_ruled_twice() {
    let corners = || [point(), point(), point(), point()];
    let law = Law::new(
        "intersection::quadrilateral_is_ruled_twice",
        suspects::library,
    );
    let hard = (
        corners(),
        [hard_parameter(), hard_parameter()],
        hard_parameter(),
    );
    law.holds(
        (corners(), [parameter(), parameter()], parameter()),
        hard,
        |&(corners, [u, v], step)| {
            let patch = Quadrilateral::new(corners).expect("fractions are finite");
            let [s, w] = [u, v].map(|x| Exact::one() - x);
            let expected = VectorSpace::combination([s * w, u * w, u * v, s * v], corners);
            expect_equal(&expected, &patch.point(u, v))?;
            let [s_u, s_v] = patch.partials(u, v).expect("always known");
            let moved = [patch.point(u + step, v), patch.point(u, v + step)];
            expect_equal(
                &[
                    expected.plus(s_u.times(step)),
                    expected.plus(s_v.times(step)),
                ],
                &moved,
            )
        },
    );
}

enum Answer<'a> {
    Clear(Option<&'a Crossing>),
    Unclear,
}

/// The nearest crossing inside, if it can be told by rounded numbers: not near an edge, not tangent, not equally far as another.
fn clear_answer(all: &[Crossing]) -> Answer<'_> {
    let is_clear = |crossing: &Crossing| crossing.is_clear(MARGIN) && !crossing.along.is_zero();
    // A flat quadrilateral that is not convex folds over itself: two places at the same t.
    let is_folded = all.len() == 2 && (&all[0].t - &all[1].t).abs() < big(1e-9);
    if is_folded
        || !all.iter().all(is_clear)
        || all.iter().any(|crossing| crossing.t.abs() < big(1e-9))
    {
        return Answer::Unclear;
    }
    let inside = all.iter().filter(|crossing| crossing.is_inside());
    Answer::Clear(inside.min_by(|a, b| a.t.cmp(&b.t)))
}

/// **The hits are the roots.** A line meets the bilinear patch where the rulings $u=$ const lie in one plane with it, which is a quadratic equation in $u$: in two points at most. The nearest of them with $0\le u,v\le1$ and $t>0$ is given, with $t$
/// within `t_error`, and the side by the sign of $\mathbf d\cdot(S_u\times S_v)$.
///
#[test]
fn quadrilateral_hits_are_the_roots() {
    let (told, twice) = (Cell::new(0), Cell::new(0));
    let bound = Bound::default();
    let law = Law::new(
        "intersection::quadrilateral_hits_are_the_roots",
        suspects::library,
    );
    law.on_cases(1000)
        .holds(twisted(), hard_twisted(), |place| {
            let Some(all) = parameter_of(place).and_then(|u| crossings(place, u)) else {
                return Ok(());
            };
            let Answer::Clear(nearest) = clear_answer(&all) else {
                return Ok(());
            };
            told.set(told.get() + 1);
            twice.set(
                twice.get()
                    + usize::from(all.iter().filter(|crossing| crossing.is_inside()).count() == 2),
            );
            nearest_is_found(place, nearest, &bound)
        });
    println!(
        "{} places told, {} of them with two hits",
        told.get(),
        twice.get()
    );
    assert!(told.get() > 600 && twice.get() > 10);
}

fn nearest_is_found(place: &Place, nearest: Option<&Crossing>, bound: &Bound) -> Verdict {
    let hit = place.patch().intersect(&place.ray());
    let sides = (
        nearest.map(|crossing| crossing.side),
        hit.map(|hit| hit.side),
    );
    expect_equal(&sides.0, &sides.1)?;
    let (Some(crossing), Some(hit)) = (nearest, hit) else {
        return Ok(());
    };
    bound.holds(hit.t, &crossing.t, hit.t_error)?;
    let facet = bilinear_patch(&place.corners, &place.ray()).map(|hit| hit.t);
    expect_equal(&Some(hit.t), &facet)
}

/// **The error of t on a patch.** A true crossing of the line and the patch lies within `t_error` of the computed $t$, in `f32` and in `f64`. Where the ray is so nearly tangent that no crossing is certain, `t_error` is infinite.
///
/// Let $\mathbf F$ be what the equations leave at the computed $(u,v,t)$, and $(x,y,z)$ what these lack. The patch is bilinear, so its Taylor expansion ends with the term $xy\,\mathbf k$: $\mathbf F+xS_u+yS_v-z\,\mathbf d+xy\,\mathbf k=0$. By Cramer's rule with
/// $D=\mathbf d\cdot(S_u\times S_v)$, $x$, $y$ and $z$ are the products of $\mathbf F+xy\,\mathbf k$ with $-S_v\times\mathbf d$, $-\mathbf d\times S_u$ and $S_u\times S_v$, over $D$. Let $\alpha,\beta,\gamma$ bound the parts with $\mathbf F$ and $\lambda,\mu,\nu$ those with $\mathbf k$. If
/// $4\lambda\beta\le1$ and $4\mu\alpha\le1$, the right-hand sides map the rectangle $\lvert x\rvert\le2\alpha$, $\lvert y\rvert\le2\beta$ into itself; by Brouwer's theorem there is a solution in it, and $\lvert z\rvert\le\gamma+4\nu\alpha\beta$. Errors come up to a twentieth of it or so: $\alpha$, $\beta$ and $\gamma$ add up the sizes of all terms, as if nothing cancelled.
#[test]
fn t_of_a_quadrilateral_stays_within_its_bound() {
    let bounds = [Bound::default(), Bound::default()];
    let certain = Cell::new(0);
    let law = Law::new(
        "intersection::t_of_a_quadrilateral_stays_within_its_bound",
        suspects::library,
    );
    law.on_cases(600)
        .holds(uneven(twisted()), uneven(hard_twisted()), |place| {
            t_is_within_its_bound::<f32>(place, &bounds[0], &certain)?;
            t_is_within_its_bound::<f64>(place, &bounds[1], &certain)
        });
    println!("{} crossings were certain", certain.get());
    assert!(certain.get() > 500);
    for bound in &bounds {
        bound.is_used_up_to(0.02);
    }
}

/// Places whose coordinates have all their digits in use.
fn uneven(places: impl Strategy<Value = Place>) -> impl Strategy<Value = Place> {
    places.prop_map(|place| Place {
        corners: place.corners.map(|corner| corner.map(|x| x / 3.0)),
        origin: place.origin.map(|x| x / 3.0),
        ..place
    })
}

fn t_is_within_its_bound<S: Real>(place: &Place, bound: &Bound, certain: &Cell<i32>) -> Verdict {
    let rounded = |point: [f64; 3]| point.map(S::from_f64);
    let patch = Quadrilateral::new(place.corners.map(rounded)).expect("finite corners");
    let ray = Ray::new(rounded(place.origin), rounded(place.direction));
    let Some(hit) = patch.intersect(&ray) else {
        return Ok(());
    };
    if !Scalar::is_finite(hit.t_error) {
        return Ok(());
    }
    let exact = |point: [S; 3]| point.map(Real::to_f64);
    let place = Place {
        corners: patch.corners().map(exact),
        origin: exact(ray.origin),
        direction: exact(ray.direction),
    };
    let [u, v] = hit
        .parameters
        .expect("a patch has parameters")
        .map(Real::to_f64);
    let Some([.., t]) = refined(&place, [u, v, hit.t.to_f64()]) else {
        return Err(Broken {
            expected: "a crossing near by".to_owned(),
            got: format!("none at {:?}", hit.t),
        });
    };
    certain.set(certain.get() + 1);
    bound.holds(hit.t.to_f64(), &t, hit.t_error.to_f64())
}

/// **A flat quadrilateral is two triangles.** A convex quadrilateral in a plane is hit where one of its two triangles is, at the same $t$, on the same side.
#[test]
fn flat_quadrilateral_is_two_triangles() {
    let hits = Cell::new(0);
    let law = Law::new(
        "intersection::flat_quadrilateral_is_two_triangles",
        suspects::library,
    );
    let shifted = planar().prop_map(|place| {
        let far = [2.0_f64.powi(24), 0.0, -2.0_f64.powi(23)];
        Place {
            corners: place.corners.map(|corner| corner.plus(far)),
            origin: place.origin.plus(far),
            ..place
        }
    });
    law.on_cases(400).holds(planar(), shifted, |place| {
        let [a, b, c, d] = place.corners;
        let triangles = [[a, b, c], [a, c, d]].map(|corners| robust(&corners, &place.ray()));
        let expected = triangles[0].or(triangles[1]);
        let hit = place.patch().intersect(&place.ray());
        hits.set(hits.get() + usize::from(hit.is_some()));
        expect_equal(&expected.map(|hit| hit.side), &hit.map(|hit| hit.side))?;
        let (Some(expected), Some(hit)) = (expected, hit) else {
            return Ok(());
        };
        let rounding = 4.0 * f64::EPSILON * expected.t.abs();
        if (expected.t - hit.t).abs() <= hit.t_error + rounding {
            return Ok(());
        }
        Err(Broken {
            expected: format!("t = {} within {}", expected.t, hit.t_error),
            got: format!("{}", hit.t),
        })
    });
    assert!(hits.get() > 300, "{} hits", hits.get());
}

/// **Turning the corners round exchanges the sides.** The patch of $\mathbf a,\mathbf d,\mathbf c,\mathbf b$ is the same surface with $u$ and $v$ exchanged and the normal reversed.
#[test]
fn reversing_a_quadrilateral_exchanges_the_sides() {
    let law = Law::new(
        "intersection::reversing_a_quadrilateral_exchanges_the_sides",
        suspects::library,
    );
    law.on_cases(400).holds(twisted(), hard_twisted(), |place| {
        let Some(all) = parameter_of(place).and_then(|u| crossings(place, u)) else {
            return Ok(());
        };
        if matches!(clear_answer(&all), Answer::Unclear) {
            return Ok(());
        }
        let [a, b, c, d] = place.corners;
        let reversed = Quadrilateral::new([a, d, c, b]).expect("finite corners");
        let [hit, reversed] = [place.patch(), reversed].map(|patch| patch.intersect(&place.ray()));
        let opposite = |side| {
            if side == Side::Front {
                Side::Back
            } else {
                Side::Front
            }
        };
        expect_equal(
            &hit.map(|hit| opposite(hit.side)),
            &reversed.map(|hit| hit.side),
        )?;
        let turned = hit
            .zip(reversed)
            .map(|(hit, reversed)| hit.normal.dot(reversed.normal));
        expect_equal(&true, &turned.is_none_or(|cosine| cosine < -0.999_999))
    });
}

/// **The point is on the patch.** The point of a hit is within `point_error` of a point of the patch, in every coordinate: $\mathbf u\lvert x\rvert+7\mathbf u\,\bigl(u((1-v)\lvert b-a\rvert+v\lvert c-d\rvert)+v\lvert d-a\rvert\bigr)$.
///
/// It is computed from $u$ and $v$: whatever error those have moves it along the patch.
#[test]
fn point_lies_on_the_quadrilateral_within_its_bound() {
    let bound = Bound::default();
    let law = Law::new(
        "intersection::point_lies_on_the_quadrilateral_within_its_bound",
        suspects::library,
    );
    law.on_cases(400)
        .holds(uneven(twisted()), uneven(hard_twisted()), |place| {
            let Some(hit) = place.patch().intersect(&place.ray()) else {
                return Ok(());
            };
            let exact = exact_point(
                place.corners,
                hit.parameters.expect("a patch has parameters"),
            );
            for (computed, exact) in hit.point.iter().zip(&exact) {
                bound.holds(*computed, exact, hit.point_error)?;
            }
            Ok(())
        });
    bound.is_used_up_to(0.05);
}
