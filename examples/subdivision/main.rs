//! The chapter *Subdivision*: makes its figures, or a fine mesh from a cage of your own.
//!
//! ```text
//! cargo run --release --example subdivision                  figures into target/figures/subdivision/
//! cargo run --release --example subdivision -- cage.obj --scheme catmull-clark --levels 3 --out fine.obj --picture fine.png
//! ```
//!
//! The schemes are `catmull-clark` and `doo-sabin` for any polygons, `loop` and `sqrt3` for triangles.
//!
//! | option | what it does |
//! | --- | --- |
//! | `--corners smooth` | rounds boundary vertices with a single face; `sharp` keeps them, and so does saying nothing |
//! | `--limit` | moves the vertices onto the limit surface and writes its normals; for Doo-Sabin the vertices are the middles of the faces |
//! | `--triangulate` | cuts faces into triangles first |
//! | `--repair` | turns faces over and cuts the mesh open until it is a manifold |

mod cage;
mod cage_from_file;
mod figures;
mod request;

use std::process::ExitCode;

use facette_figure::example::{exit_code, write_figures};

use request::Request;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = if arguments.is_empty() {
        write_figures("subdivision", figures::FIGURES).map_err(Into::into)
    } else {
        Request::parse(&arguments)
            .map_err(Into::into)
            .and_then(|request| cage_from_file::run(&request))
    };
    exit_code(done)
}
