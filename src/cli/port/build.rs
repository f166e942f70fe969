//! Ports the input and reports notes, repairs and errors.

use super::args::PortArgs;
#[cfg(feature = "naga")]
use super::complete;
use super::load::{self, LoadedProject, name_of};
use super::report::{is_colored, report};
use super::save::OutputPlace;
use super::still::still;
use crate::cli::command::{CLEAN, FINDINGS};
use crate::cli::output::diff;
use crate::cli::progress::Progress;
use crate::engine::{Original, Repairs, Verified, repairable, verify};
use crate::exec::Equality;
#[cfg(feature = "naga")]
use crate::port::channels_to_set;
use crate::port::{File, Poster, Target, build, slider_notes};
use crate::project::{Composed, Project, missing};
use crate::report::{Format, Reporter};
use std::io::{self, Write};
use std::path::PathBuf;

/// The result of a run.
pub(super) struct MadeFiles {
    /// The files to write; empty if errors prevent it or a diff was printed.
    pub(super) files: Vec<File>,
    /// The files that were read.
    pub(super) read: Vec<PathBuf>,
    pub(super) code: u8,
}

/// Ports the input and reports about it. `version` is set for a served page, which reloads itself
/// when the server announces another version.
pub(super) fn build_output(args: &PortArgs, version: Option<&str>) -> Result<MadeFiles, String> {
    #[cfg(feature = "naga")]
    if let Some(shaders) = complete::load(args)? {
        let (files, code) = complete::build_output(args, &shaders)?;
        let read = args.input.clone();
        return Ok(MadeFiles { files, read, code });
    }
    let LoadedProject {
        project,
        composed,
        repairs,
        given,
        read,
        notes,
    } = load::load(args)?;
    for remark in project.remarks() {
        let _ = writeln!(io::stderr(), "note: {remark}");
    }
    match args.repair || args.diff || repairs.done.len() < 2 {
        true => print_repairs(&repairs).map_err(|e| e.to_string())?,
        false => {
            let count = repairs.done.len();
            let _ = writeln!(
                io::stderr(),
                "note: applied {count} repairs for WebGL2; `--diff` shows them"
            );
        }
    }
    if let Some(why) = &repairs.left {
        let _ = writeln!(io::stderr(), "note: {why}");
    }
    let nothing = |code| MadeFiles {
        files: Vec::new(),
        read: Vec::new(),
        code,
    };
    if args.diff {
        return print(diff_of(&repairs).as_bytes()).map(|()| nothing(CLEAN));
    }
    let target = args.target()?;
    let place = OutputPlace::of(args.request.output.as_deref(), target, &project.info.name);
    let poster = match args.embed {
        true => Some(poster(args, &project, &composed)?),
        false => None,
    };
    let order = args.order(target, place.output(), version, poster.as_ref());
    let made = build(&project, &composed, order).map_err(|e| e.to_string())?;
    let analyses = composed.units.iter().map(|u| composed.analysis(u));
    let found = analyses.flat_map(|a| &a.diagnostics);
    let summary = report(&composed.sources, found, &made.remarks).map_err(|e| e.to_string())?;
    if summary.errors > 0 && !args.repair {
        offer_repair(&project, &composed, &name_of(args));
    }
    // Other languages require code that compiles.
    if target != Target::Glsl && target.is_shaders() && summary.errors > 0 {
        return Ok(nothing(FINDINGS));
    }
    if !target.is_shaders() {
        print_notes(&project, &composed, target, notes);
    }
    let mut code = if summary.errors > 0 { FINDINGS } else { CLEAN };
    if args.verify {
        let passes = verify(&project, &composed, given.as_ref(), target, &made.files)?;
        if !is_verified(passes) {
            code = FINDINGS;
        }
    }
    Ok(MadeFiles {
        files: made.files,
        read,
        code,
    })
}

/// Prints the notes of the input, and what is missing in a page.
fn print_notes(project: &Project, composed: &Composed, target: Target, notes: Vec<String>) {
    let sliders = match target.has_sliders() {
        true => slider_notes(composed),
        false => &[],
    };
    let notes = notes.into_iter().chain(channel_notes(project, target));
    for note in notes.chain(sliders.iter().cloned()) {
        let _ = writeln!(io::stderr(), "note: {note}");
    }
}

/// Notes about channels without their content.
fn channel_notes(project: &Project, target: Target) -> Vec<String> {
    #[cfg(feature = "naga")]
    if target == Target::ThreeWebgpu {
        return channels_to_set(project).into_iter().collect();
    }
    let _ = target;
    let all = missing(project).into_iter();
    all.map(|what| what.to_string()).collect()
}

pub(super) fn print(text: &[u8]) -> Result<(), String> {
    let printed = io::stdout().lock().write_all(text);
    printed.map_err(|e| format!("cannot write the output: {e}"))
}

/// What the page shows until it plays. Notes say what is missing, and why.
fn poster(args: &PortArgs, project: &Project, composed: &Composed) -> Result<Poster, String> {
    if args.url.is_some() && !args.is_saved() {
        return Err("`--url` requires `-o FILE`: the still image is written beside it".to_string());
    }
    let progress = Progress::new(1);
    let drawn = still(project, composed);
    drop(progress);
    let mut stderr = io::stderr();
    if let Err(why) = &drawn {
        let _ = writeln!(stderr, "note: the page has no still image: {why}");
    }
    if args.url.is_none() {
        let _ = writeln!(
            stderr,
            "note: link previews show no image, because `og:image` requires an absolute address; \
             pass the address of the page with `--url`"
        );
    }
    Ok(Poster {
        still: drawn.ok(),
        address: args.url.clone(),
        click: args.click,
        shared: false,
    })
}

/// Reports for each pass whether the output draws the same as the original.
fn is_verified(passes: Vec<Verified>) -> bool {
    let mut is_so = true;
    for verified in passes {
        let Verified {
            pass,
            original,
            outcome,
        } = verified;
        let outcome_in_words = match &outcome {
            Ok(Equality::Proved) => "identical code".to_string(),
            Ok(Equality::SampledEqual { pixels }) => format!("identical on {pixels} pixels"),
            Ok(Equality::Differs { pixel: [x, y], .. }) => {
                format!("differs from the original, first at pixel ({x}, {y})")
            }
            Ok(Equality::TooLong) => "not compared: the sample run takes too long".to_string(),
            Err(why) => format!("not compared: {why}"),
        };
        is_so &= matches!(
            outcome,
            Ok(Equality::Proved | Equality::SampledEqual { .. })
        );
        let since = match original {
            Original::Given => "",
            Original::Repaired => {
                ", compared with the repaired code: the original does not compile"
            }
        };
        let _ = writeln!(io::stderr(), "{pass}: {outcome_in_words}{since}");
    }
    is_so
}

/// All repairs as a diff.
fn diff_of(repairs: &Repairs) -> String {
    let changed = repairs.changed().map(|(before, after)| {
        let name = match &before.part {
            Some(part) => format!("{}/{part}", before.path),
            None => before.path.clone(),
        };
        diff(&name, &before.text, after)
    });
    changed.collect()
}

/// Reports the repairs, at their positions in the original text.
fn print_repairs(repairs: &Repairs) -> io::Result<()> {
    if repairs.is_empty() {
        return Ok(());
    }
    let mut reporter = Reporter::new(Format::Human, io::stderr().lock(), is_colored());
    reporter.file("", &repairs.before, &repairs.done)?;
    reporter.finish().map(|_| ())
}

/// Suggests `--repair` if it would fix errors.
fn offer_repair(project: &Project, composed: &Composed, name: &str) {
    let help = match repairable(project, composed, name) {
        0 => return,
        1 => "help: `--repair` fixes 1 of these errors; `--diff` shows how".to_string(),
        n => format!("help: `--repair` fixes {n} of these errors; `--diff` shows how"),
    };
    let _ = writeln!(io::stderr(), "{help}");
}
