//! Golden images: `FILE.golden.png` next to FILE, or `FILE.golden.2.5s.png` if there are several
//! times.

use super::super::image_file::decode;
use super::super::output::{Overwrite, write};
use super::super::run::{Undrawable, of_png, read};
use super::args::TestArgs;
use super::difference::difference;
use super::outcome::{Status, TestRow};
use crate::commands::run::heat::map;
use crate::commands::run::{Bitmap, ObservedRays, Shot, ShotSetting, shot};
use crate::commands::run::{size_of, time_of};
use crate::engine::inputs::Moment;
use crate::exec::Watch;
use crate::play::RenderedImage;
use crate::text::number::{percent, seconds, short};
use crate::text::path::slashed;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Default size of golden images in pixels.
const SIZE: [u32; 2] = [320, 180];
/// Marks the comment that sets size and times.
const MARK: &str = "// golden:";

/// A shader file whose golden images are compared.
pub struct GoldenSubject<'a> {
    /// Name of the file in messages.
    pub name: &'a str,
    /// Path of the file.
    pub path: &'a Path,
    /// What is drawn: the file, or the folder of its project. `None` unless it is a complete
    /// fragment shader without errors.
    pub project: Option<PathBuf>,
    /// Size and times from the comment in the shader.
    pub wish: Option<Wish>,
    /// Number of threads that draw.
    pub threads: usize,
}

/// Size and times that a shader sets for its golden images.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Wish {
    size: Option<[u32; 2]>,
    times: Option<Vec<f64>>,
}

/// A golden image, which may not exist yet.
struct Golden {
    time: f64,
    path: PathBuf,
    /// The existing image; `None` if there is none.
    known: Option<Result<Bitmap, String>>,
}

/// The results of the golden images of a file.
pub enum GoldenImages {
    /// The file has nothing to draw.
    None,
    /// There is something to draw, but no golden image, and --bless is not given.
    Unblessed,
    /// The images were compared or written.
    Compared(Vec<TestRow>),
}

/// Parses a comment on its own line such as `// golden: 320x180 at 0, 2.5`.
pub fn wish(text: &str) -> Result<Option<Wish>, String> {
    let mut lines = text.lines().zip(1..);
    let found = lines.find_map(|(line, number)| Some((line.trim().strip_prefix(MARK)?, number)));
    let Some((rest, number)) = found else {
        return Ok(None);
    };
    let wrong =
        || format!("line {number}: expected a size, times or both: `{MARK} 320x180 at 0, 2.5`");
    let (size, times) = match rest.trim().split_once("at ") {
        Some((size, times)) => (size.trim(), Some(times)),
        None => (rest.trim(), None),
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

/// Compares the images of a shader with its golden images, or writes them.
pub fn run(
    subject: &GoldenSubject,
    args: &TestArgs,
    is_requested: &dyn Fn(&str) -> bool,
) -> GoldenImages {
    let wished = subject.wish.as_ref();
    let times = wished.and_then(|wish| wish.times.as_ref());
    let goldens = goldens(subject.path, times.unwrap_or(&args.times));
    let is_known = goldens.iter().any(|g| g.known.is_some());
    let is_asked = wished.is_some() || is_known;
    let Some(project) = &subject.project else {
        let why = "only complete fragment shaders without errors can be drawn";
        return match is_asked {
            true => {
                GoldenImages::Compared(vec![TestRow::failed(subject.name, "golden image", why)])
            }
            false => GoldenImages::None,
        };
    };
    if !is_asked && !args.bless {
        return GoldenImages::Unblessed;
    }
    let requested = goldens.into_iter().filter(|g| is_requested(&g.title()));
    let requested: Vec<Golden> = requested.collect();
    if requested.is_empty() {
        return GoldenImages::None;
    }
    let first = requested
        .iter()
        .find_map(|g| g.known.as_ref()?.as_ref().ok());
    let size = wished.and_then(|w| w.size).or(args.size);
    let size = size.or_else(|| Some(first?.size)).unwrap_or(SIZE);
    let mut ready = match ready(project, size, subject.threads) {
        Ok(ready) => ready,
        Err(words) => {
            let rows = requested
                .iter()
                .map(|g| TestRow::failed(subject.name, &g.title(), &words));
            return GoldenImages::Compared(rows.collect());
        }
    };
    let rows = requested
        .iter()
        .map(|golden| golden.judge(&mut ready, subject, args));
    GoldenImages::Compared(rows.collect())
}

/// The golden images at some times.
fn goldens(path: &Path, times: &[f64]) -> Vec<Golden> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let golden = |&time: &f64| {
        let own = match times.len() {
            1 => format!("{name}.golden.png"),
            _ => format!("{name}.golden.{time}s.png"),
        };
        let path = path.with_file_name(own);
        let known = match fs::read(&path) {
            Ok(bytes) => Some(of_png(&bytes)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => Some(Err(error.to_string())),
        };
        Golden { time, path, known }
    };
    times.iter().map(golden).collect()
}

/// The golden images of a file that exist.
pub fn existing(path: &Path) -> Vec<PathBuf> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let start = format!("{name}.golden.");
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let images = entries.filter(|e| e.file_name().to_string_lossy().starts_with(&start));
    images
        .map(|entry| path.with_file_name(entry.file_name()))
        .collect()
}

/// A shader that is compiled and ready to draw.
fn ready(project: &Path, size: [u32; 2], threads: usize) -> Result<Shot, String> {
    let loaded = read(project, None, &[]).map_err(|why| match why {
        Undrawable::Errors(_) => "the shader has errors; `shaderlint run` lists them".to_string(),
        Undrawable::Words(words) => words,
    })?;
    let setting = ShotSetting {
        rays: ObservedRays::Nothing,
        size,
        threads,
        pass: None,
        show: None,
        uniforms: None,
        watch: Watch::Nothing,
        trace: false,
        decode: Some(decode),
    };
    shot(&loaded.shader, &setting)
}

fn shown(path: &Path) -> String {
    slashed(path.strip_prefix(".").unwrap_or(path))
}

impl Golden {
    fn title(&self) -> String {
        format!("golden image at {}", seconds(self.time))
    }

    fn shown(&self) -> String {
        shown(&self.path)
    }

    /// Draws the image and compares it with the golden image.
    fn judge(&self, ready: &mut Shot, subject: &GoldenSubject, args: &TestArgs) -> TestRow {
        let title = self.title();
        let failed = |message: String| TestRow::failed(subject.name, &title, message);
        let drawn = match ready.drawn(&Moment::at(self.time), &mut |_| {}) {
            Ok(drawn) => drawn,
            Err(words) => return failed(words),
        };
        let drawn = Bitmap::of(&RenderedImage::of(ready.code(), &drawn, 0));
        let row = match &self.known {
            None => failed(format!(
                "{} does not exist; use --bless to create it",
                self.shown()
            )),
            Some(Err(why)) => failed(format!("cannot read {}: {why}", self.shown())),
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
            let message = format!("expected {w}x{h} pixels as in {shown}, found {own_w}x{own_h}");
            return TestRow::failed(subject.name, &title, message);
        }
        let (found, distances) = difference(known, drawn);
        if found.visible * 100.0 <= args.tolerance {
            return TestRow {
                difference: Some(found),
                ..TestRow::passed(subject.name, &title)
            };
        }
        let [x, y] = found.worst;
        let mut message = format!(
            "{} of the pixels differ visibly from {} (tolerance: {}); the largest difference is {} at ({x}, {y})",
            percent(found.visible),
            self.shown(),
            percent(args.tolerance / 100.0),
            short(found.most),
        );
        let mut written = None;
        if args.diff && !args.bless {
            match self.draw_difference(drawn.size, &distances, args) {
                Ok(path) => written = Some(path),
                Err(why) => message.push_str(&format!("; {why}")),
            }
        }
        if let Some(written) = &written {
            message.push_str(&format!("; see {written}"));
        }
        TestRow {
            difference: Some(found),
            written,
            ..TestRow::failed(subject.name, &title, message)
        }
    }

    /// Writes an image of the differences.
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
                format!("{shown} already exists; use --force to overwrite it")
            }
            _ => format!("{shown}: {error}"),
        })?;
        Ok(shown)
    }

    /// Writes the golden image, replacing an existing one.
    fn bless(&self, drawn: &Bitmap, subject: &GoldenSubject, row: TestRow) -> TestRow {
        let shown = self.shown();
        let written = drawn.png().and_then(|content| {
            let written = write(&self.path, &content, Overwrite::Allowed);
            written.map_err(|error| error.to_string())
        });
        match written {
            Ok(()) => TestRow {
                status: Status::Recorded,
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
    fn golden_comments_set_sizes_and_times() {
        let rest = |text: &str| wish(&format!("void f() {{}}\n  {text}\n"));
        let some = |size, times: Option<&[f64]>| {
            let times = times.map(<[f64]>::to_vec);
            Ok(Some(Wish { size, times }))
        };
        assert_eq!(
            rest("// golden: 64x32 at 0, 2.5"),
            some(Some([64, 32]), Some(&[0.0, 2.5]))
        );
        assert_eq!(rest("// golden: 64x32"), some(Some([64, 32]), None));
        assert_eq!(rest("// golden: at 1"), some(None, Some(&[1.0])));
        assert_eq!(rest("// gold"), Ok(None));
        for wrong in ["// golden:", "// golden: big", "// golden: at noon"] {
            assert!(rest(wrong).unwrap_err().starts_with("line 2: "), "{wrong}");
        }
    }

    #[test]
    fn golden_images_are_next_to_their_shaders() {
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
