//! How far two pictures are apart, and the check of a picture against its snapshot.
//!
//! Differences are taken of sRGB bytes multiplied by alpha, and of alpha itself, in units of the full scale: 0 for equal
//! pictures, 1 for black against white. What a transparent pixel hides does not count.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use crate::render::Picture;
use crate::write_atomically;

/// How far two pictures of one size are apart, in units of the full scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Difference {
    /// The largest difference in any channel of any pixel.
    pub largest: f64,
    /// The root of the mean square over all channels of all pixels.
    pub root_mean_square: f64,
}

impl Difference {
    /// The same bound for the largest difference and a tenth of it for the root mean square: a few samples along edges
    /// may fall on the other side, the picture as a whole may not change.
    #[must_use]
    pub fn bound(largest: f64) -> Self {
        Self {
            largest,
            root_mean_square: largest / 10.0,
        }
    }

    /// Whether both measures are at most those of `bound`.
    #[must_use]
    pub fn is_within(&self, bound: &Self) -> bool {
        self.largest <= bound.largest && self.root_mean_square <= bound.root_mean_square
    }
}

/// The difference of two pictures; `None` when their sizes differ.
///
/// # Examples
/// ```
/// use facette_figure::difference::difference;
/// use facette_figure::render::Picture;
///
/// let clear = Picture { width: 1, height: 1, rgba: vec![9, 9, 9, 0] };
/// let white = Picture { width: 1, height: 1, rgba: vec![255, 255, 255, 255] };
/// assert_eq!(difference(&clear, &white).map(|d| d.largest), Some(1.0));
/// ```
#[must_use]
pub fn difference(first: &Picture, second: &Picture) -> Option<Difference> {
    let differences = channel_differences(first, second)?;
    let (mut largest, mut squares) = (0.0_f64, 0.0);
    for &difference in differences.iter().flatten() {
        largest = largest.max(difference);
        squares += difference * difference;
    }
    let count = 4.0 * differences.len().max(1) as f64;
    Some(Difference {
        largest,
        root_mean_square: (squares / count).sqrt(),
    })
}

/// A picture of where two pictures differ: black where they agree, brighter and redder the more they do not, four
/// times enhanced. `None` when their sizes differ.
#[must_use]
pub fn difference_picture(first: &Picture, second: &Picture) -> Option<Picture> {
    let differences = channel_differences(first, second)?;
    let rgba = differences.iter().flat_map(|channels| {
        let worst = channels.iter().copied().fold(0.0, f64::max);
        let strength = (4.0 * worst).min(1.0);
        [byte(strength), byte(strength * strength / 2.0), 0, u8::MAX]
    });
    Some(Picture {
        width: first.width,
        height: first.height,
        rgba: rgba.collect(),
    })
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the value lies between 0 and 1, and a cast saturates"
)]
fn byte(value: f64) -> u8 {
    (255.0 * value).round() as u8
}

fn channel_differences(first: &Picture, second: &Picture) -> Option<Vec<[f64; 4]>> {
    let is_same_size = (first.width, first.height, first.rgba.len())
        == (second.width, second.height, second.rgba.len());
    is_same_size.then(|| {
        let pixels = first.rgba.chunks(4).zip(second.rgba.chunks(4));
        pixels.map(|(a, b)| pixel_difference(a, b)).collect()
    })
}

fn pixel_difference(first: &[u8], second: &[u8]) -> [f64; 4] {
    let premultiplied = |pixel: &[u8], channel: usize| {
        let value = |channel: usize| f64::from(pixel.get(channel).copied().unwrap_or(0)) / 255.0;
        if channel == 3 {
            value(3)
        } else {
            value(channel) * value(3)
        }
    };
    std::array::from_fn(|channel| {
        (premultiplied(first, channel) - premultiplied(second, channel)).abs()
    })
}

/// The environment variable that makes [`assert_picture_matches`] write snapshots instead of comparing with them.
pub const UPDATE_VARIABLE: &str = "FACETTE_UPDATE_SNAPSHOTS";

/// Checks a picture against the snapshot, a PNG file, within a bound.
///
/// On a mismatch the picture is written beside the snapshot as `<stem>.new.png`, and where the sizes agree also
/// `<stem>.difference.png`. With `FACETTE_UPDATE_SNAPSHOTS=1` in the environment the picture becomes the snapshot.
///
/// # Panics
/// When the pictures differ by more than the bound, when there is no snapshot or it cannot be read: this is for tests.
pub fn assert_picture_matches(snapshot: &Path, picture: &Picture, bound: &Difference) {
    let update = env::var_os(UPDATE_VARIABLE).is_some_and(|value| value == "1");
    if let Err(message) = check_snapshot(snapshot, picture, bound, update) {
        panic!("{message}");
    }
}

/// [`assert_picture_matches`] with the message as a value.
fn check_snapshot(
    snapshot: &Path,
    picture: &Picture,
    bound: &Difference,
    update: bool,
) -> Result<(), String> {
    if update {
        return write_atomically(snapshot, &picture.to_png()).map_err(|error| error.to_string());
    }
    let (new, differing) = (beside(snapshot, "new"), beside(snapshot, "difference"));
    let found = compare(snapshot, picture, bound);
    if found.is_ok() {
        // What an earlier failure left is out of date.
        let _ = (fs::remove_file(new), fs::remove_file(differing));
        return Ok(());
    }
    let mut written = write_atomically(&new, &picture.to_png());
    if let Some(image) = read(snapshot)
        .ok()
        .and_then(|old| difference_picture(&old, picture))
    {
        written = written.and(write_atomically(&differing, &image.to_png()));
    }
    found.map_err(|message| match written {
        Ok(()) => format!(
            "{message}\nthe new picture is {}; {UPDATE_VARIABLE}=1 makes it the snapshot",
            new.display()
        ),
        Err(error) => format!("{message}\n{error}"),
    })
}

fn compare(snapshot: &Path, picture: &Picture, bound: &Difference) -> Result<(), String> {
    let place = snapshot.display();
    let old = read(snapshot)?;
    let Some(found) = difference(&old, picture) else {
        return Err(format!(
            "{place}: the snapshot is {old:?}, the new one is {picture:?}"
        ));
    };
    if found.is_within(bound) {
        return Ok(());
    }
    Err(format!(
        "{place}: the picture has changed: largest difference {:.4} (bound {:.4}), root mean square {:.5} (bound {:.5})",
        found.largest, bound.largest, found.root_mean_square, bound.root_mean_square
    ))
}

fn read(path: &Path) -> Result<Picture, String> {
    let bytes = fs::read(path)
        .map_err(|error| format!("cannot read the snapshot {}: {error}", path.display()))?;
    Picture::from_png(&bytes).map_err(|error| format!("{}: {error}", path.display()))
}

/// `<stem>.<what>.png` in the folder of the snapshot.
fn beside(snapshot: &Path, what: &str) -> PathBuf {
    snapshot.with_extension(format!("{what}.png"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(value: u8, alpha: u8) -> Picture {
        Picture {
            width: 2,
            height: 2,
            rgba: [value, value, value, alpha].repeat(4),
        }
    }

    /// A folder of its own for one test, removed at the end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            Self(env::temp_dir().join(format!("facette-{name}-{}", std::process::id())))
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn difference_is_a_distance_in_units_of_the_full_scale() {
        let (black, white) = (grey(0, 255), grey(255, 255));
        let far = difference(&black, &white).expect("one size");
        // Three of four channels differ by 1.
        assert_eq!((far.largest, far.root_mean_square), (1.0, 0.75_f64.sqrt()));
        assert_eq!(difference(&white, &black), Some(far));
        assert_eq!(
            difference(&white, &white),
            Some(Difference {
                largest: 0.0,
                root_mean_square: 0.0
            })
        );
    }

    #[test]
    fn what_a_transparent_pixel_hides_does_not_count() {
        let found = difference(&grey(0, 0), &grey(255, 0)).expect("one size");
        assert!(found.is_within(&Difference::bound(0.0)));
    }

    #[test]
    fn pictures_of_different_sizes_are_not_compared() {
        let wide = Picture {
            width: 4,
            height: 1,
            ..grey(0, 255)
        };
        assert_eq!(difference(&wide, &grey(0, 255)), None);
        assert_eq!(difference_picture(&wide, &grey(0, 255)), None);
    }

    #[test]
    fn the_difference_picture_is_black_where_pictures_agree() {
        let mut other = grey(10, 255);
        other.rgba[0] = 250;
        let image = difference_picture(&grey(10, 255), &other).expect("one size");
        assert_eq!(image.pixel(0, 0), [255, 128, 0, 255]);
        assert_eq!(image.pixel(1, 1), [0, 0, 0, 255]);
    }

    #[test]
    fn a_missing_snapshot_fails_and_an_update_makes_it() {
        let folder = Folder::new("missing");
        let path = folder.0.join("coons__patch.png");
        let (picture, bound) = (grey(90, 255), Difference::bound(0.0));
        let missing = check_snapshot(&path, &picture, &bound, false);
        assert!(missing.is_err_and(|message| message.contains("cannot read the snapshot")));
        assert!(beside(&path, "new").exists());
        assert_eq!(check_snapshot(&path, &picture, &bound, true), Ok(()));
        assert_eq!(check_snapshot(&path, &picture, &bound, false), Ok(()));
        assert!(
            !beside(&path, "new").exists(),
            "a success removes what a failure left"
        );
    }

    #[test]
    fn a_mismatch_names_measure_and_bound_and_leaves_both_pictures() {
        let folder = Folder::new("mismatch");
        let path = folder.0.join("coons__patch.png");
        let bound = Difference::bound(0.01);
        assert_eq!(check_snapshot(&path, &grey(90, 255), &bound, true), Ok(()));
        let message =
            check_snapshot(&path, &grey(141, 255), &bound, false).expect_err("51/255 apart");
        assert!(
            message.contains("largest difference 0.2000 (bound 0.0100)"),
            "{message}"
        );
        assert!(folder.0.join("coons__patch.new.png").exists());
        assert!(folder.0.join("coons__patch.difference.png").exists());
        // One byte of sixteen is off by one: 1/255 at the most, a quarter of it in the mean.
        let mut close = grey(90, 255);
        close.rgba[0] += 1;
        assert_eq!(check_snapshot(&path, &close, &bound, false), Ok(()));
    }

    #[test]
    #[should_panic(expected = "cannot read the snapshot")]
    fn the_assertion_panics_with_the_message() {
        let nowhere = Path::new("/nonexistent-folder/none.png");
        let message = compare(nowhere, &grey(0, 0), &Difference::bound(0.0)).expect_err("no file");
        panic!("{message}");
    }
}
