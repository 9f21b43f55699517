//! Which typical mistake does the code under test behave like? Each suspect function tries it on a few fixed inputs that tell
//! all of them apart.

use facette::coons::{bicubic_point, bilinear_partials, bilinear_point, hermite_basis};

use crate::common::exact::{Exact, fraction};
use crate::common::law::LikelyMistake;
use crate::inputs::{Net, Place, Point, edges, hermite_boundary};
use crate::mistakes::{self, MISTAKES, Mistake};

/// A boundary without symmetries, and a parameter pair inside.
fn probe(u: Exact, v: Exact) -> Place {
    let at = |x, y, z| [x, y, z].map(|value| fraction(value, 1));
    let corners = [at(0, 0, 1), at(5, 1, 0), at(7, 6, 2), at(1, 4, 3)];
    let inner = [
        vec![at(2, -1, 3)],
        vec![at(3, 7, -1), at(5, 5, 4)],
        vec![at(-1, 2, 2)],
        vec![at(8, 2, 5)],
    ];
    Place {
        edges: edges(corners, inner),
        u,
        v,
    }
}

fn net() -> Net {
    let height = |i: i32, j: i32| fraction(i * i * j + 3 * j * j - i * j + 2 * i, 2);
    let row = |i: i32| {
        (0..4).map(move |j| [fraction(3 * i + j, 2), fraction(2 * j - i, 1), height(i, j)])
    };
    (0..4).map(|i| row(i).collect()).collect()
}

fn parameters() -> [[Exact; 2]; 3] {
    [[1, 2], [3, 1], [2, 4]].map(|pair| pair.map(|fifths| fraction(fifths, 5)))
}

/// The mistake among those of `exercise` that agrees with the code under test on all parameters; otherwise `general`.
fn found(
    exercise: &str,
    general: &'static str,
    agrees: impl Fn(&Mistake, [Exact; 2]) -> bool,
) -> LikelyMistake {
    let mut candidates = MISTAKES
        .iter()
        .filter(|mistake| mistake.exercise == exercise);
    let alike = candidates.find(|mistake| {
        parameters()
            .into_iter()
            .all(|parameters| agrees(mistake, parameters))
    });
    match alike {
        Some(Mistake { name, hint, .. }) => LikelyMistake { name, hint },
        None => LikelyMistake {
            name: "",
            hint: general,
        },
    }
}

/// Suspects for `bilinear_point`.
pub fn bilinear() -> LikelyMistake {
    found(
        "bilinear",
        "compare each term of S1, S2 and S3 with the page",
        |mistake, [u, v]| {
            let boundary = probe(u, v).boundary();
            let wrong = mistakes::bilinear_point(mistake.name, &boundary, u, v);
            wrong == Some(bilinear_point(&boundary, u, v))
        },
    )
}

/// Suspects for `bilinear_partials`.
pub fn derivative() -> LikelyMistake {
    let general =
        "differentiate S1, S2 and S3 one by one, each factor that depends on the parameter";
    found("derivative", general, |mistake, [u, v]| {
        let boundary = probe(u, v).boundary();
        let wrong = mistakes::bilinear_partials(mistake.name, &boundary, u, v);
        wrong == Some(bilinear_partials(&boundary, u, v))
    })
}

/// Suspects for `hermite_basis` and `bicubic_point`.
pub fn bicubic() -> LikelyMistake {
    let general =
        "check the order of the four cubics (value, slope, slope, value), then each of S1, S2, S3";
    found("bicubic", general, |mistake, [u, v]| {
        let data = hermite_boundary(&net());
        let basis = mistakes::hermite_basis::<Exact>(mistake.name, u);
        let point: Option<Point> = mistakes::bicubic_point(mistake.name, &data, u, v);
        match (basis, point) {
            (Some(wrong), _) => wrong == hermite_basis(u),
            (None, Some(wrong)) => wrong == bicubic_point(&data, u, v),
            (None, None) => false,
        }
    })
}

/// Suspects for what no exercise asks the reader to write.
pub fn library() -> LikelyMistake {
    LikelyMistake {
        name: "",
        hint: "a defect of the library: no exercise replaces this code",
    }
}
