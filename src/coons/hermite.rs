//! Hermite's cubics, and the data that a bicubically blended patch interpolates.

use super::boundary::{Boundary, CoonsError, Corner, Corners, Named, check_domain, check_meetings};
use crate::algebra::{Scalar, VectorSpace};
use crate::curve::Curve;

/// Hermite's four cubics at `t`, each of which carries one datum: the value at 0, the slope at 0, the slope at 1, the
/// value at 1.
///
/// ```text
/// (1 + 2t)(1 − t)²,   t (1 − t)²,   −t² (1 − t),   t² (3 − 2t)
/// ```
///
/// # Edge cases
///
/// `[1, 0, 0, 0]` at t = 0 and `[0, 0, 0, 1]` at t = 1, exactly.
///
/// # Source
///
/// Farin 2002, section 7.5.
// ANCHOR: hermite_basis
pub fn hermite_basis<S: Scalar>(t: S) -> [S; 4] {
    let [one, two, three] = [1, 2, 3].map(S::from_i32);
    let s = one - t;
    [
        (one + two * t) * s * s,
        t * s * s,
        -(t * t * s),
        t * t * (three - two * t),
    ]
}
// ANCHOR_END: hermite_basis

/// The derivatives of [`hermite_basis`] at `t`, in the same order.
pub fn hermite_basis_derivative<S: Scalar>(t: S) -> [S; 4] {
    let [one, two, three, six] = [1, 2, 3, 6].map(S::from_i32);
    let s = one - t;
    [
        -(six * t * s),
        s * (one - three * t),
        t * (three * t - two),
        six * t * s,
    ]
}

/// The four curves of derivatives across the edges: the slope that a patch takes as it leaves each edge.
#[derive(Clone, Debug)]
pub struct CrossDerivatives<C> {
    /// `S_v(u, 0)`, across `P1`.
    pub p1_v: C,
    /// `S_v(u, 1)`, across `P2`.
    pub p2_v: C,
    /// `S_u(0, v)`, across `Q1`.
    pub q1_u: C,
    /// `S_u(1, v)`, across `Q2`.
    pub q2_u: C,
}

/// The twist vectors `S_uv` at the four corners.
pub type Twists<P> = Corners<P>;

/// A boundary with the slope across it: what a bicubically blended patch interpolates.
///
/// The data must fit at each corner. A cross derivative begins and ends with the derivative of the edge curve that it
/// meets, `p1_v(0) = Q1'(0)`. The twist has two sources, the two orders of differentiation: `p1_v'(0) = S_vu` and
/// `q1_u'(0) = S_uv`; a smooth surface needs them equal. Where they are not, Gregory's blend takes each on its own edge.
///
/// # Shape
///
/// [`HermiteBoundary::corner_vectors`] holds 16 vectors. Rows are the u data (value at 0, slope at 0, slope at 1, value
/// at 1), columns the same v data; the four in the middle are the twists.
#[derive(Clone, Debug)]
pub struct HermiteBoundary<C: Curve> {
    boundary: Boundary<C>,
    cross: CrossDerivatives<C>,
    vectors: [[C::Point; 4]; 4],
    /// The twists as the cross derivatives of `Q1` and `Q2` give them.
    twists_from_q: Twists<C::Point>,
    /// The twists as the cross derivatives of `P1` and `P2` give them.
    twists_from_p: Twists<C::Point>,
}

impl<C: Curve> HermiteBoundary<C> {
    /// The data of a patch with the given twists, which both families of cross derivatives must confirm.
    ///
    /// # Errors
    ///
    /// [`CoonsError::DoNotMeet`] where a cross derivative does not begin with the edge's derivative, or where its own
    /// derivative is not the twist (the tolerance is 64 unit roundoffs of the largest coordinate of all corner vectors); [`CoonsError::DerivativeUnknown`], [`CoonsError::DomainIsNotUnit`] and [`CoonsError::NotFinite`] as
    /// they say.
    pub fn new(
        boundary: Boundary<C>,
        cross: CrossDerivatives<C>,
        twists: Twists<C::Point>,
    ) -> Result<Self, CoonsError<C::Point>> {
        let mut data = Self::gregory(boundary, cross)?;
        let Corners { a, b, c, d } = twists;
        let [p, q] = [data.twists_from_p, data.twists_from_q];
        let meetings = [
            (Corner::A, ("the twist", a), ("p1_v'(0)", p.a)),
            (Corner::A, ("the twist", a), ("q1_u'(0)", q.a)),
            (Corner::B, ("the twist", b), ("p1_v'(1)", p.b)),
            (Corner::B, ("the twist", b), ("q2_u'(0)", q.b)),
            (Corner::C, ("the twist", c), ("p2_v'(1)", p.c)),
            (Corner::C, ("the twist", c), ("q2_u'(1)", q.c)),
            (Corner::D, ("the twist", d), ("p2_v'(0)", p.d)),
            (Corner::D, ("the twist", d), ("q1_u'(1)", q.d)),
        ];
        check_meetings(&meetings, data.vectors.as_flattened(), None)?;
        data.twists_from_p = twists;
        data.twists_from_q = twists;
        Ok(data)
    }

    /// The data of a patch whose twists are read off the cross derivatives; where the two families disagree, the twist
    /// varies between them (Gregory's correction), see [`HermiteBoundary::corner_vectors`].
    ///
    /// # Errors
    ///
    /// As [`HermiteBoundary::new`], without the check of the twists.
    ///
    /// # Source
    ///
    /// Gregory 1974.
    pub fn gregory(
        boundary: Boundary<C>,
        cross: CrossDerivatives<C>,
    ) -> Result<Self, CoonsError<C::Point>> {
        let CrossDerivatives {
            p1_v,
            p2_v,
            q1_u,
            q2_u,
        } = &cross;
        let named = [
            ("p1_v", p1_v),
            ("p2_v", p2_v),
            ("q1_u", q1_u),
            ("q2_u", q2_u),
        ];
        for (name, curve) in named {
            check_domain(name, curve)?;
        }
        let vectors = known_vectors(&boundary, &cross);
        check_tangents(&boundary, &cross, &vectors)?;
        let [[p_a, p_b], [p_d, p_c], [q_a, q_d], [q_b, q_c]] = end_derivatives(named)?;
        Ok(Self {
            boundary,
            cross,
            vectors,
            twists_from_q: Corners {
                a: q_a,
                b: q_b,
                c: q_c,
                d: q_d,
            },
            twists_from_p: Corners {
                a: p_a,
                b: p_b,
                c: p_c,
                d: p_d,
            },
        })
    }

    /// The four edges.
    pub fn boundary(&self) -> &Boundary<C> {
        &self.boundary
    }

    /// The derivative across `P1`: `S_v(u, 0)`.
    pub fn p1_v(&self) -> &C {
        &self.cross.p1_v
    }

    /// The derivative across `P2`: `S_v(u, 1)`.
    pub fn p2_v(&self) -> &C {
        &self.cross.p2_v
    }

    /// The derivative across `Q1`: `S_u(0, v)`.
    pub fn q1_u(&self) -> &C {
        &self.cross.q1_u
    }

    /// The derivative across `Q2`: `S_u(1, v)`.
    pub fn q2_u(&self) -> &C {
        &self.cross.q2_u
    }

    /// The 16 vectors at the corners, as the point `(u, v)` sees them: where the two families give different twists
    /// `p` and `q`, it sees their mean `(x q + y p) / (x + y)`, with its distances `x` and `y` from the corner in u
    /// and in v. On an edge along u that is `q`, on an edge along v it is `p`.
    // ANCHOR: corner_vectors
    pub fn corner_vectors(&self, u: C::Scalar, v: C::Scalar) -> [[C::Point; 4]; 4] {
        let [far_u, far_v] = [u, v].map(|t| C::Scalar::from_i32(1) - t);
        let [p, q] = [self.twists_from_p, self.twists_from_q];
        let mut vectors = self.vectors;
        vectors[1][1] = gregory_twist(p.a, q.a, u, v);
        vectors[2][1] = gregory_twist(p.b, q.b, far_u, v);
        vectors[2][2] = gregory_twist(p.c, q.c, far_u, far_v);
        vectors[1][2] = gregory_twist(p.d, q.d, u, far_v);
        vectors
    }
    // ANCHOR_END: corner_vectors

    /// What the change of the twists with u and with v adds to the derivatives of `S₃`; zero where they are compatible.
    pub(super) fn turning_twists(&self, u: C::Scalar, v: C::Scalar) -> [C::Point; 2] {
        let one = C::Scalar::from_i32(1);
        let [far_u, far_v] = [one - u, one - v];
        let [in_u, in_v] = [hermite_basis(u), hermite_basis(v)];
        let [p, q] = [self.twists_from_p, self.twists_from_q];
        let corners = [
            turning_twist(p.a, q.a, [u, v], in_u[1] * in_v[1]),
            turning_twist(p.b, q.b, [far_u, v], in_u[2] * in_v[1]),
            turning_twist(p.c, q.c, [far_u, far_v], in_u[2] * in_v[2]),
            turning_twist(p.d, q.d, [u, far_v], in_u[1] * in_v[2]),
        ];
        // Seen from B and C, u grows towards the corner; seen from C and D, v does.
        let [with_u, with_v] = [[one, -one, -one, one], [one, one, -one, -one]];
        [
            C::Point::combination(with_u, corners.map(|[in_x, _]| in_x)),
            C::Point::combination(with_v, corners.map(|[_, in_y]| in_y)),
        ]
    }
}

/// `(x q + y p) / (x + y)`; `q` where they agree, and at the corner itself, where the twist has no weight.
// ANCHOR: gregory_twist
fn gregory_twist<P: VectorSpace>(p: P, q: P, x: P::Scalar, y: P::Scalar) -> P {
    let whole = x + y;
    if p == q || whole == P::Scalar::from_i32(0) {
        return q;
    }
    q.lerp(p, y / whole)
}
// ANCHOR_END: gregory_twist

/// The derivatives of [`gregory_twist`] in x and in y, `y (q − p) / (x + y)²` and `x (p − q) / (x + y)²`, times its weight.
///
/// The weight is not larger than x or y: divided first, it keeps the reciprocals of tiny distances from overflowing.
fn turning_twist<P: VectorSpace>(p: P, q: P, [x, y]: [P::Scalar; 2], weight: P::Scalar) -> [P; 2] {
    let whole = x + y;
    if p == q || whole == P::Scalar::from_i32(0) {
        return [P::origin(); 2];
    }
    let change = q.minus(p);
    let share = weight / whole;
    [
        change.times(share * (y / whole)),
        change.times(-(share * (x / whole))),
    ]
}

/// The derivatives of four curves at 0 and at 1.
fn end_derivatives<C: Curve>(
    curves: [(&'static str, &C); 4],
) -> Result<[[C::Point; 2]; 4], CoonsError<C::Point>> {
    let mut derivatives = [[C::Point::origin(); 2]; 4];
    for (ends, (name, curve)) in derivatives.iter_mut().zip(curves) {
        for (derivative, end) in ends.iter_mut().zip([0, 1]) {
            let parameter = C::Scalar::from_i32(end);
            *derivative = curve
                .derivative(parameter)
                .ok_or(CoonsError::DerivativeUnknown {
                    curve: name,
                    parameter,
                })?;
        }
    }
    Ok(derivatives)
}

/// Checks that each cross derivative begins and ends with the derivative of the edge that it meets there.
fn check_tangents<C: Curve>(
    boundary: &Boundary<C>,
    cross: &CrossDerivatives<C>,
    vectors: &[[C::Point; 4]; 4],
) -> Result<(), CoonsError<C::Point>> {
    let [[p1_a, p1_b], [p2_d, p2_c], [q1_a, q1_d], [q2_b, q2_c]] = end_derivatives([
        ("P1", boundary.p1()),
        ("P2", boundary.p2()),
        ("Q1", boundary.q1()),
        ("Q2", boundary.q2()),
    ])?;
    let start =
        |name, curve: &C| -> Named<C::Point> { (name, curve.point(C::Scalar::from_i32(0))) };
    let end = |name, curve: &C| -> Named<C::Point> { (name, curve.point(C::Scalar::from_i32(1))) };
    let meetings = [
        (Corner::A, start("p1_v(0)", &cross.p1_v), ("Q1'(0)", q1_a)),
        (Corner::B, end("p1_v(1)", &cross.p1_v), ("Q2'(0)", q2_b)),
        (Corner::D, start("p2_v(0)", &cross.p2_v), ("Q1'(1)", q1_d)),
        (Corner::C, end("p2_v(1)", &cross.p2_v), ("Q2'(1)", q2_c)),
        (Corner::A, start("q1_u(0)", &cross.q1_u), ("P1'(0)", p1_a)),
        (Corner::D, end("q1_u(1)", &cross.q1_u), ("P2'(0)", p2_d)),
        (Corner::B, start("q2_u(0)", &cross.q2_u), ("P1'(1)", p1_b)),
        (Corner::C, end("q2_u(1)", &cross.q2_u), ("P2'(1)", p2_c)),
    ];
    check_meetings(&meetings, vectors.as_flattened(), None)
}

/// The 12 corner vectors that are no twists, with zeros in the places of the four twists.
#[rustfmt::skip]
fn known_vectors<C: Curve>(
    boundary: &Boundary<C>,
    cross: &CrossDerivatives<C>,
) -> [[C::Point; 4]; 4] {
    let Corners { a, b, c, d } = boundary.corners();
    let ends = |curve: &C| [0, 1].map(|end| curve.point(C::Scalar::from_i32(end)));
    let [[a_v, b_v], [d_v, c_v]] = [ends(&cross.p1_v), ends(&cross.p2_v)];
    let [[a_u, d_u], [b_u, c_u]] = [ends(&cross.q1_u), ends(&cross.q2_u)];
    let twist = C::Point::origin();
    [
        [a,   a_v,   d_v,   d  ],
        [a_u, twist, twist, d_u],
        [b_u, twist, twist, c_u],
        [b,   b_v,   c_v,   c  ],
    ]
}
