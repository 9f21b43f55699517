//! What must hold of every picture.

use glam::DVec3;

use super::*;
use crate::palette::Colour;

fn front_view(height: f64) -> View {
    View::orthographic(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, height)
}

/// The square of side 2 around the origin, in the plane of this z.
fn square(z: f64) -> Triangles {
    Triangles::grid(3, 3, |u, v| {
        (DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, z), DVec3::Z)
    })
}

fn alphas(picture: &Picture) -> impl Iterator<Item = u8> {
    picture.rgba.chunks(4).map(|pixel| pixel[3])
}

#[test]
fn coverage_is_the_share_of_samples_inside() {
    // The square covers the middle half of an 8 x 8 picture, shifted by half a pixel to the right.
    let mesh = Triangles {
        positions: square(0.0)
            .positions
            .iter()
            .map(|p| *p + DVec3::new(0.25, 0.0, 0.0))
            .collect(),
        ..square(0.0)
    };
    let picture = Scene::new(front_view(4.0))
        .surface(mesh, Material::matte(Colour::Blue))
        .render(8, 8);
    let row: Vec<u8> = (0..8).map(|column| picture.pixel(column, 4)[3]).collect();
    assert_eq!(row, [0, 0, 128, 255, 255, 255, 128, 0]);
}

#[test]
fn no_sample_falls_between_neighbouring_triangles() {
    // Views whose edges run exactly through samples, and views where nothing is exact.
    for eye in [
        DVec3::new(0.0, 0.0, 3.0),
        DVec3::new(0.3, 0.7, 2.1),
        DVec3::new(0.1, -0.4, 1.7),
    ] {
        let view = View::perspective(eye, DVec3::ZERO, DVec3::Y, 20.0);
        let picture = Scene::new(view)
            .surface(square(0.0), Material::matte(Colour::Blue))
            .render(40, 40);
        assert!(alphas(&picture).all(|alpha| alpha == 255), "eye {eye}");
    }
}

#[test]
fn the_nearer_surface_is_seen_whatever_the_order() {
    let (near, far) = ((square(1.0), Colour::Orange), (square(0.0), Colour::Blue));
    let view = View::perspective(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, 20.0);
    let picture = |objects: [&(Triangles, Colour); 2]| {
        let add = |scene: Scene, (mesh, colour): &(Triangles, Colour)| {
            scene.surface(mesh, Material::matte(*colour))
        };
        objects
            .into_iter()
            .fold(Scene::new(view), add)
            .render(16, 16)
    };
    let both = picture([&near, &far]);
    assert_eq!(both, picture([&far, &near]));
    assert_eq!(both, picture([&near, &near]));
}

#[test]
fn both_sides_of_a_surface_look_the_same() {
    let turned = Triangles {
        normals: square(0.0).normals.iter().map(|normal| -*normal).collect(),
        triangles: square(0.0)
            .triangles
            .iter()
            .map(|&[a, b, c]| [a, c, b])
            .collect(),
        ..square(0.0)
    };
    let picture = |mesh: Triangles| {
        Scene::new(front_view(3.0))
            .surface(mesh, Material::matte(Colour::Green))
            .render(12, 12)
    };
    assert_eq!(picture(square(0.0)), picture(turned));
}

#[test]
fn a_plane_has_one_stripe_of_isophotes_and_a_fold_has_two() {
    let up = DVec3::Y;
    let count = |normal: fn(f64) -> DVec3| {
        let mesh = Triangles::grid(2, 2, |u, v| {
            (DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0), normal(v))
        });
        let picture = Scene::new(front_view(2.0))
            .surface(mesh, Material::isophotes(Colour::Blue, up, 2))
            .render(1, 9);
        (0..9).filter(|&row| picture.pixel(0, row)[0] > 128).count()
    };
    // n · y < 0 is the first stripe, in full colour; n · y > 0 the second, pale.
    assert_eq!(count(|_| DVec3::new(0.0, -0.5, 1.0)), 0);
    assert_eq!(count(|_| DVec3::new(0.0, 0.5, 1.0)), 9);
    assert_eq!(
        count(|v| DVec3::new(0.0, if v > 0.25 { 1.0 } else { -1.0 }, 1.0)),
        7
    );
}

#[test]
fn isolines_lie_at_multiples_of_the_step() {
    let lined = Scene::new(front_view(2.0))
        .surface(square(0.0), Material::matte(Colour::Sky).isolines(4))
        .render(64, 64);
    let plain = Scene::new(front_view(2.0))
        .surface(square(0.0), Material::matte(Colour::Sky))
        .render(64, 64);
    for column in 0..64 {
        // u = 1/4, 1/2, 3/4 are the borders of columns 16, 32, 48; a line takes half a pixel on either side.
        let is_line = matches!(column, 0 | 15 | 16 | 31 | 32 | 47 | 48 | 63);
        let is_darker = lined.pixel(column, 24)[1] < plain.pixel(column, 24)[1];
        assert_eq!(is_darker, is_line, "column {column}");
    }
}

#[test]
fn normals_become_colours() {
    let picture = Scene::new(front_view(1.0))
        .surface(square(0.0), Material::normals())
        .render(2, 2);
    // (0, 0, 1) is half red, half green, full blue; a half is the byte 188 of sRGB.
    assert_eq!(picture.pixel(0, 0), [188, 188, 255, 255]);
}

#[test]
fn triangles_that_cannot_be_seen_leave_no_trace() {
    let triangle = |points: [DVec3; 3]| Triangles {
        positions: points.to_vec(),
        triangles: vec![[0, 1, 2]],
        ..Triangles::default()
    };
    let (x, y) = (DVec3::X, DVec3::Y);
    let behind = 9.0 * DVec3::Z;
    let cases = [
        [x, x, y],
        [DVec3::ZERO, x, 2.0 * x],
        [x, y, DVec3::NAN],
        [x, y, DVec3::splat(f64::INFINITY)],
        [behind, behind + x, behind + y],
    ];
    let view = View::perspective(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, 60.0);
    for points in cases {
        let scene = Scene::new(view).surface(triangle(points), Material::matte(Colour::Blue));
        assert!(
            alphas(&scene.render(9, 9)).all(|alpha| alpha == 0),
            "{points:?}"
        );
    }
}

#[test]
fn a_plane_that_passes_behind_the_eye_is_seen_to_the_horizon() {
    let mesh = Triangles::grid(1, 1, |u, v| {
        (
            DVec3::new(200.0 * u - 100.0, -1.0, 200.0 * v - 100.0),
            DVec3::Y,
        )
    });
    let view = View::perspective(DVec3::ZERO, -DVec3::Z, DVec3::Y, 90.0);
    let picture = Scene::new(view)
        .surface(mesh, Material::matte(Colour::Blue))
        .render(8, 40);
    let column: Vec<u8> = (0..40).map(|row| picture.pixel(4, row)[3]).collect();
    assert!(column[..20].iter().all(|&alpha| alpha == 0), "{column:?}");
    assert!(column[21..].iter().all(|&alpha| alpha == 255), "{column:?}");
}

#[test]
fn points_and_tubes_are_seen_with_round_ends() {
    let scene = Scene::new(front_view(4.0)).tube(&[-DVec3::X, DVec3::X], 0.5, Colour::Ink);
    let picture = scene.render(40, 40);
    // From -1.5 to 1.5 across, that is 5 to 35 pixels, and 15 to 25 down.
    assert_eq!(
        [4, 6, 33, 35].map(|column| picture.pixel(column, 20)[3]),
        [0, 255, 255, 0]
    );
    assert_eq!(
        [14, 16, 23, 25].map(|row| picture.pixel(20, row)[3]),
        [0, 255, 255, 0]
    );
    assert_eq!(picture.pixel(5, 15)[3], 0);
}
