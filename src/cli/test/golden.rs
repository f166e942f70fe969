//! Pictures that were blessed: `FILE.golden.png` beside FILE, or `FILE.golden.2.5s.png` where several
//! moments are drawn.

use super::super::output::{Overwrite, write};
use super::super::port;
use super::super::run::{
    Bitmap, Progress, Shot, ShotSetting, Trouble, Undrawable, map, percent, read, seconds, short,
    shot, size_of, time_of,
};
use super::args::TestArgs;
use super::difference::difference;
use super::outcome::{Status, TestRow};
use crate::engine::play::{Moment, Picture};
use crate::exec::Watch;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// The size of pictures of which nothing else is said.
const SIZE: [u32; 2] = [320, 180];
/// What stands before the wishes of a shader.
const MARK: &str = "// golden:";

/// A shader file, and what is drawn of it.
pub struct GoldenSubject<'a> {
    /// How the file is called.
    pub name: &'a str,
    /// Where it lies.
    pub path: &'a Path,
    /// What is drawn: the file, or the folder of its project. `None` where it is not a whole fragment
    /// shader without errors.
    pub project: Option<PathBuf>,
    /// What the shader wishes.
    pub wish: Option<Wish>,
    /// How many threads draw.
    pub threads: usize,
}

/// What a shader says of its pictures.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Wish {
    size: Option<[u32; 2]>,
    times: Option<Vec<f64>>,
}

/// A picture that is blessed, or is to be.
struct Golden {
    time: f64,
    path: PathBuf,
    /// What there is.
    known: Option<Result<Bitmap, String>>,
}

/// What came of the pictures of a file.
pub enum Pictures {
    /// There is nothing to draw.
    None,
    /// There is, and nobody has blessed it or asked for it.
    Unblessed,
    /// They were compared or written.
    Compared(Vec<TestRow>),
}

/// What a text wishes in a line of its own like `// golden: 320x180 at 0, 2.5`.
pub fn wish(text: &str) -> Result<Option<Wish>, String> {
    let mut lines = text.lines().zip(1..);
    let found = lines.find_map(|(line, number)| Some((line.trim().strip_prefix(MARK)?, number)));
    let Some((said, number)) = found else {
        return Ok(None);
    };
    let wrong = || format!("line {number}: write `{MARK} 320x180 at 0, 2.5`, or one of both");
    let (size, times) = match said.trim().split_once("at ") {
        Some((size, times)) => (size.trim(), Some(times)),
        None => (said.trim(), None),
    };
    let times = times.map(|all| all.split(',').map(|t| time_of(t.trim())).collect());
    let wish = Wish {
        size: match size {
            "" => None,
            size => Some(size_of(size).map_err(|_| wrong())?),
        },
        times: times.transpose().map_err(|_: String| wrong())?,
    };
    match wish == Wish::default() {
        true => Err(wrong()),
        false => Ok(Some(wish)),
    }
}

/// Compares what a shader draws with what was blessed, or writes it.
pub fn run(subject: &GoldenSubject, args: &TestArgs, is_wanted: &dyn Fn(&str) -> bool) -> Pictures {
    let wished = subject.wish.as_ref();
    let times = wished.and_then(|wish| wish.times.as_ref());
    let goldens = goldens(subject.path, times.unwrap_or(&args.times));
    let is_known = goldens.iter().any(|g| g.known.is_some());
    let is_asked = wished.is_some() || is_known;
    let Some(project) = &subject.project else {
        let why = "only whole fragment shaders without errors are drawn";
        return match is_asked {
            true => Pictures::Compared(vec![TestRow::failed(subject.name, "picture", why)]),
            false => Pictures::None,
        };
    };
    if !is_asked && !args.bless {
        return Pictures::Unblessed;
    }
    let wanted = goldens.into_iter().filter(|g| is_wanted(&g.title()));
    let wanted: Vec<Golden> = wanted.collect();
    if wanted.is_empty() {
        return Pictures::None;
    }
    let first = wanted.iter().find_map(|g| g.known.as_ref()?.as_ref().ok());
    let size = wished.and_then(|w| w.size).or(args.size);
    let size = size.or_else(|| Some(first?.size)).unwrap_or(SIZE);
    let mut ready = match ready(project, size, subject.threads) {
        Ok(ready) => ready,
        Err(words) => {
            let rows = wanted
                .iter()
                .map(|g| TestRow::failed(subject.name, &g.title(), &words));
            return Pictures::Compared(rows.collect());
        }
    };
    let rows = wanted
        .iter()
        .map(|golden| golden.judge(&mut ready, subject, args));
    Pictures::Compared(rows.collect())
}

/// The pictures of some moments.
fn goldens(path: &Path, times: &[f64]) -> Vec<Golden> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let golden = |&time: &f64| {
        let own = match times.len() {
            1 => format!("{name}.golden.png"),
            _ => format!("{name}.golden.{time}s.png"),
        };
        let path = path.with_file_name(own);
        let known = match fs::read(&path) {
            Ok(bytes) => Some(Bitmap::of_png(&bytes)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => Some(Err(error.to_string())),
        };
        Golden { time, path, known }
    };
    times.iter().map(golden).collect()
}

/// A shader, ready to be drawn.
fn ready(project: &Path, size: [u32; 2], threads: usize) -> Result<Shot, String> {
    let loaded = read(project, None, &[]).map_err(|why| match why {
        Undrawable::Errors(_) => "the shader has errors; `shaderlint run` tells them".to_string(),
        Undrawable::Words(words) => words,
    })?;
    let setting = ShotSetting {
        size,
        threads,
        pass: None,
        show: None,
        uniforms: None,
        watch: Watch::Nothing,
    };
    shot(&loaded, &setting).map_err(|trouble| match trouble {
        Trouble::Errors => "the shader has errors".to_string(),
        Trouble::Words(words) => words,
    })
}

/// How a file is called in messages.
fn shown(path: &Path) -> String {
    port::shown(path.strip_prefix(".").unwrap_or(path))
}

impl Golden {
    fn title(&self) -> String {
        format!("picture at {}", seconds(self.time))
    }

    fn shown(&self) -> String {
        shown(&self.path)
    }

    /// Draws the picture and compares it with what there is.
    fn judge(&self, ready: &mut Shot, subject: &GoldenSubject, args: &TestArgs) -> TestRow {
        let title = self.title();
        let failed = |message: String| TestRow::failed(subject.name, &title, message);
        let drawn = match ready.drawn(&Moment::at(self.time), &Progress::unseen()) {
            Ok(drawn) => drawn,
            Err(words) => return failed(words),
        };
        let drawn = Bitmap {
            size: drawn.size,
            bytes: Picture::of(ready.code(), &drawn, 0).bytes(),
        };
        let row = match &self.known {
            None => failed(format!("there is no {}; --bless draws it", self.shown())),
            Some(Err(why)) => failed(format!("{} cannot be read: {why}", self.shown())),
            Some(Ok(known)) => self.compared(known, &drawn, subject, args),
        };
        match args.bless && row.status == Status::Failed {
            true => self.bless(&drawn, subject, row),
            false => row,
        }
    }

    fn compared(
        &self,
        known: &Bitmap,
        drawn: &Bitmap,
        subject: &GoldenSubject,
        args: &TestArgs,
    ) -> TestRow {
        let title = self.title();
        if known.size != drawn.size {
            let [[w, h], [own_w, own_h]] = [known.size, drawn.size];
            let shown = self.shown();
            let message = format!("{shown} has {w}x{h} pixels, and {own_w}x{own_h} are drawn");
            return TestRow::failed(subject.name, &title, message);
        }
        let (told, distances) = difference(known, drawn);
        if told.visible * 100.0 <= args.tolerance {
            return TestRow {
                difference: Some(told),
                ..TestRow::passed(subject.name, &title)
            };
        }
        let [x, y] = told.worst;
        let mut message = format!(
            "{} of the pixels differ visibly from {}, by {} at most, at ({x}, {y}); {} may",
            percent(told.visible),
            self.shown(),
            short(told.most),
            percent(args.tolerance / 100.0),
        );
        let mut written = None;
        if args.diff && !args.bless {
            match self.draw_difference(drawn.size, &distances, args) {
                Ok(path) => written = Some(path),
                Err(why) => message.push_str(&format!("; {why}")),
            }
        }
        if let Some(written) = &written {
            message.push_str(&format!("; {written} shows where"));
        }
        TestRow {
            difference: Some(told),
            written,
            ..TestRow::failed(subject.name, &title, message)
        }
    }

    /// Writes where pictures differ.
    fn draw_difference(
        &self,
        size: [u32; 2],
        distances: &[f64],
        args: &TestArgs,
    ) -> Result<String, String> {
        let path = self.path.with_extension("diff.png");
        let shown = shown(&path);
        let overwrite = match args.force {
            true => Overwrite::Allowed,
            false => Overwrite::Never,
        };
        let content = map(size, distances, "DIFFERENCE").png()?;
        write(&path, &content, overwrite).map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => {
                format!("{shown} is there already; --force writes over it")
            }
            _ => format!("{shown}: {error}"),
        })?;
        Ok(shown)
    }

    /// Writes the picture, in place of one that is there.
    fn bless(&self, drawn: &Bitmap, subject: &GoldenSubject, row: TestRow) -> TestRow {
        let shown = self.shown();
        let written = drawn.png().and_then(|content| {
            let written = write(&self.path, &content, Overwrite::Allowed);
            written.map_err(|error| error.to_string())
        });
        match written {
            Ok(()) => TestRow {
                status: Status::Blessed,
                difference: row.difference,
                written: Some(shown),
                ..TestRow::passed(subject.name, &self.title())
            },
            Err(why) => TestRow::failed(subject.name, &self.title(), format!("{shown}: {why}")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shaders_say_what_is_drawn() {
        let said = |text: &str| wish(&format!("void f() {{}}\n  {text}\n"));
        let some = |size, times: Option<&[f64]>| {
            let times = times.map(<[f64]>::to_vec);
            Ok(Some(Wish { size, times }))
        };
        assert_eq!(
            said("// golden: 64x32 at 0, 2.5"),
            some(Some([64, 32]), Some(&[0.0, 2.5]))
        );
        assert_eq!(said("// golden: 64x32"), some(Some([64, 32]), None));
        assert_eq!(said("// golden: at 1"), some(None, Some(&[1.0])));
        assert_eq!(said("// gold"), Ok(None));
        for wrong in ["// golden:", "// golden: big", "// golden: at noon"] {
            assert!(said(wrong).unwrap_err().starts_with("line 2: "), "{wrong}");
        }
    }

    #[test]
    fn pictures_lie_beside_their_shaders() {
        let paths = |times: &[f64]| {
            let all = goldens(Path::new("a/sea.frag"), times);
            all.into_iter().map(|g| shown(&g.path)).collect::<Vec<_>>()
        };
        assert_eq!(paths(&[3.0]), ["a/sea.frag.golden.png"]);
        assert_eq!(
            paths(&[0.0, 2.5]),
            ["a/sea.frag.golden.0s.png", "a/sea.frag.golden.2.5s.png"]
        );
    }
}
