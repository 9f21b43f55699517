//! Running one theorem of the reader's test binary in a process of its own.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use crate::error::GraderError;
use crate::protocol::{self, Outcome};

/// A theorem takes well below a second; what takes longer than this will not end.
const TIME_LIMIT: Duration = Duration::from_mins(1);

/// How often the end of a test is looked for.
const POLL: Duration = Duration::from_millis(2);

/// A built test binary and the names of its tests.
#[derive(Clone, Debug)]
pub struct TestBinary {
    path: PathBuf,
    package: PathBuf,
    tests: Vec<String>,
}

impl TestBinary {
    /// The binary at `path`, of the package in the folder `package`.
    ///
    /// # Errors
    ///
    /// [`GraderError::Start`] where it cannot be run.
    pub fn open(path: &Path, package: &Path) -> Result<Self, GraderError> {
        let mut binary = Self {
            path: path.to_path_buf(),
            package: package.to_path_buf(),
            tests: Vec::new(),
        };
        let mut command = binary.command();
        let listed = command
            .arg("--list")
            .output()
            .map_err(binary.start_error())?;
        let text = String::from_utf8_lossy(&listed.stdout);
        let tests = text.lines().filter_map(|line| line.strip_suffix(": test"));
        binary.tests = tests.map(str::to_owned).collect();
        Ok(binary)
    }

    /// Runs the theorem whose test function has this name, with a typical mistake switched on or with none; ends it
    /// early once the flag is set.
    ///
    /// # Errors
    ///
    /// [`GraderError::Binary`] where the binary has no such test.
    pub fn run(
        &self,
        theorem: &str,
        mistake: Option<&str>,
        is_unwanted: &AtomicBool,
    ) -> Result<Outcome, GraderError> {
        let test = self.named(theorem)?;
        let mut command = self.command();
        command.args([
            "--exact",
            test,
            "--nocapture",
            "--include-ignored",
            "--test-threads=1",
        ]);
        if let Some(mistake) = mistake {
            command.env("FACETTE_MISTAKE", mistake);
        }
        let child = command.spawn().map_err(self.start_error())?;
        ended(child, TIME_LIMIT, is_unwanted).map_err(GraderError::file("run", &self.path))
    }

    /// What the test `list_mistakes` prints.
    ///
    /// # Errors
    ///
    /// [`GraderError::Binary`] where the binary has no such test.
    pub fn list_of_mistakes(&self) -> Result<String, GraderError> {
        let test = self.named("list_mistakes")?;
        let mut command = self.command();
        // Quiet, or the first line would stand behind the test's name.
        command.args(["--exact", test, "--nocapture", "--ignored", "--quiet"]);
        let printed = command.output().map_err(self.start_error())?;
        Ok(String::from_utf8_lossy(&printed.stdout).into_owned())
    }

    /// The path of the test function with this name.
    fn named(&self, name: &str) -> Result<&str, GraderError> {
        let mut tests = self.tests.iter().map(String::as_str);
        let found = tests.find(|test| test.rsplit("::").next() == Some(name));
        found.ok_or_else(|| GraderError::Binary {
            binary: self.path.clone(),
            message: format!(
                "has no test `{name}`: exercise.rs must include the module that has it"
            ),
        })
    }

    fn command(&self) -> Command {
        let mut command = Command::new(&self.path);
        command
            .current_dir(&self.package)
            .env("CARGO_MANIFEST_DIR", &self.package);
        command
            .env("FACETTE_EXERCISE", "1")
            .env("RUST_BACKTRACE", "0");
        command.env_remove("FACETTE_MISTAKE");
        command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    fn start_error(&self) -> impl FnOnce(std::io::Error) -> GraderError {
        let program = self.path.display().to_string();
        move |source| GraderError::Start { program, source }
    }
}

/// Waits for the end of a test and reads what it has shown; a test that does not end within the limit, or is no
/// longer wanted, is ended.
///
/// # Errors
///
/// Where the process cannot be waited for.
pub fn ended(
    mut child: Child,
    limit: Duration,
    is_unwanted: &AtomicBool,
) -> std::io::Result<Outcome> {
    let output = collected(child.stdout.take());
    let errors = collected(child.stderr.take());
    let start = Instant::now();
    let ending = loop {
        if let Some(status) = child.try_wait()? {
            break in_words(status);
        }
        if start.elapsed() > limit || is_unwanted.load(Ordering::Relaxed) {
            child.kill()?;
            child.wait()?;
            let seconds = limit.as_secs();
            return Ok(Outcome::Broken(format!(
                "the test did not end within {seconds} s"
            )));
        }
        thread::sleep(POLL);
    };
    let output = output.join().unwrap_or_default();
    let errors = errors.join().unwrap_or_default();
    Ok(protocol::outcome(ending, &output, &errors))
}

/// Reads a pipe beside the test, so that a test that writes much is not held up.
fn collected(pipe: Option<impl Read + Send + 'static>) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // What was read before an error is all there is to show.
            let _ = pipe.read_to_end(&mut bytes);
        }
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

fn in_words(status: ExitStatus) -> Result<(), String> {
    if status.success() {
        Ok(())
    } else {
        Err(format!("ended with {status}"))
    }
}
