//! A temporary folder to run the programs in, for all tests.

use insta_cmd::get_cargo_bin;
use shaderlint::cli::{ProgramName, described};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

/// A folder that is deleted at the end of the test.
pub struct Scratch(tempfile::TempDir);

/// The commands, which check no files or sample them if asked.
static COMMANDS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut program = described(ProgramName::Shaderlint);
    program.build();
    let names = program.get_subcommands().map(|c| c.get_name().to_string());
    names.collect()
});

/// Result of a run.
#[derive(Debug)]
pub struct Ran {
    /// The exit code of the program.
    pub code: i32,
    /// Its standard output.
    pub out: String,
    /// Its standard error.
    pub err: String,
}

impl Scratch {
    /// A folder with these files.
    pub fn new(files: &[(&str, &str)]) -> Scratch {
        let scratch = Scratch(tempfile::tempdir().unwrap());
        for (name, text) in files {
            scratch.write(name, text);
        }
        scratch
    }

    /// The absolute path of a file in the folder.
    pub fn path(&self, name: &str) -> PathBuf {
        // The folder for temporary files may itself be a symbolic link.
        fs::canonicalize(self.0.path()).unwrap().join(name)
    }

    /// Writes a file, with its folders.
    pub fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Reads a file as text.
    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// A command that runs `shaderlint` in the folder. It disables sampling, because most texts
    /// here draw nothing of interest; sampling has its own tests.
    pub fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(get_cargo_bin("shaderlint"));
        let says_itself = |arg: &&str| COMMANDS.iter().any(|c| c == arg) || arg.contains("-run");
        if !args.iter().any(says_itself) {
            command.arg("--no-run");
        }
        command
            .current_dir(self.path(""))
            .args(args)
            .env("NO_COLOR", "1");
        command
    }

    /// Runs the program in the folder.
    pub fn run(&self, args: &[&str]) -> Ran {
        ran(&mut self.command(args), "")
    }

    /// Runs the program in a subfolder.
    pub fn run_in(&self, folder: &str, args: &[&str]) -> Ran {
        ran(self.command(args).current_dir(self.path(folder)), "")
    }

    /// Runs the program with this text as standard input.
    pub fn pipe(&self, text: &str, args: &[&str]) -> Ran {
        ran(&mut self.command(args), text)
    }

    /// A command that runs `shaderport` in the folder.
    pub fn port_command(&self, args: &str) -> Command {
        let mut command = Command::new(get_cargo_bin("shaderport"));
        command
            .current_dir(self.path(""))
            .args(args.split_whitespace());
        command
    }

    /// Exit code and messages of `shaderport`, without the notes about missing media files.
    pub fn port(&self, args: &str) -> (Option<i32>, String) {
        let out = self.port_command(args).output().unwrap();
        let message = String::from_utf8(out.stderr).unwrap();
        let lines = message.lines().filter(|l| !l.contains(" file given; "));
        let lines: Vec<&str> = lines.collect();
        (out.status.code(), lines.join("\n"))
    }

    /// Asserts that `shaderport` succeeds with this message.
    #[track_caller]
    pub fn ports(&self, args: &str, message: &str) {
        assert_eq!(self.port(args), (Some(0), message.to_string()), "{args}");
    }

    /// Asserts that `shaderport` fails with this message.
    #[track_caller]
    pub fn port_fails(&self, args: &str, message: &str) {
        let message = format!("shaderport: {message}");
        assert_eq!(self.port(args), (Some(2), message), "{args}");
    }

    /// The printed findings of a file, each as `line:column rule`.
    pub fn places(&self, args: &[&str]) -> Vec<String> {
        let ran = self.run(&[args, &["--info", "--format", "short"]].concat());
        let place = |line: &str| {
            let mut parts = line.splitn(4, ':');
            let at = format!("{}:{}", parts.nth(1)?, parts.next()?);
            let rule = parts.next()?.split(['[', ']']).nth(1)?.to_string();
            Some(format!("{at} {rule}"))
        };
        ran.out.lines().filter_map(place).collect()
    }
}

fn ran(command: &mut Command, input: &str) -> Ran {
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that needs no input may have ended already.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let out = child.wait_with_output().unwrap();
    Ran {
        code: out.status.code().unwrap(),
        out: String::from_utf8(out.stdout).unwrap(),
        err: String::from_utf8(out.stderr).unwrap(),
    }
}

/// The root of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A shader with one finding of each severity that default rules have; the warning is the only one
/// on its line.
pub const WARNED: &str = "\
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float wave = pow(iTime - 9.0, 2.0);
    float unused = 2.0;
    fragColor = vec4(wave);
}
";

/// A shader with two compile errors that have safe fixes, the second after characters of two and
/// four bytes.
pub const BROKEN: &str = "\
// größe 𝄞
float halfOf(float x) { return x / 2; }

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    /* 𝄞é */ float a = 1;
    fragColor = vec4(halfOf(a));
}
";

/// [`BROKEN`] after `--fix`.
pub fn after_fix() -> String {
    BROKEN
        .replace("x / 2;", "x / 2.0;")
        .replace("a = 1;", "a = 1.0;")
}

/// A shader without findings.
pub const CLEAN: &str = "\
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    fragColor = vec4(fragCoord / iResolution.xy, 0.0, 1.0);
}
";
