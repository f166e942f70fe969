//! What fixes make of a text, each round judged anew, and how many findings they mend.

use super::World;
use super::document::{Report, judge};
use super::files::Files;
use super::options::Options;
use crate::diagnostic::Diagnostic;
use crate::lint::{Allow, Fixed, Judged, Look, count_fixes, fix};
use crate::text::{Encoding, Span};

/// Mends what can be mended in a text, judging it anew after each round.
pub fn mend(name: &str, text: &str, options: &Options, files: &dyn Files, allow: Allow) -> Fixed {
    let world = World::new(options, files);
    fix(text, allow, |text| look(name, text, world))
}

fn look(name: &str, text: &str, world: World) -> Option<Look> {
    let mut report = judge(name, text, Encoding::Utf8, world);
    if report.unread.is_some() {
        return None;
    }
    // What was not asked for is seen, and not mended.
    let others = report.diagnostics.iter_mut();
    others
        .filter(|d| !world.options.settings.reports(d.rule))
        .for_each(|d| d.fix = None);
    report.look(text)
}

impl Report {
    /// The findings as those of the text of the input, for the fix engine.
    fn look(&self, text: &str) -> Option<Look> {
        if let Some(export) = &self.export {
            let place = |d: &Diagnostic| export.finding(&self.sources, d.clone());
            return Some(Look {
                span: Span::new(0, text.len() as u32),
                diagnostics: self.diagnostics.iter().map(place).collect(),
                judged: self.judged.as_ref().map(|j| Judged {
                    done: export.spans(&self.sources, &j.done),
                    left: export.spans(&self.sources, &j.left),
                }),
                size: self.size(),
            });
        }
        Some(Look {
            span: self.sources.file(self.file?)?.span(),
            diagnostics: self.diagnostics.clone(),
            judged: self.judged.clone(),
            size: self.size(),
        })
    }

    /// How many tokens and macro calls were read.
    fn size(&self) -> usize {
        self.shaders.iter().map(|s| s.size).sum()
    }
}

/// How many findings can be fixed.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Offer {
    /// By the fixes that keep the picture.
    pub safe: usize,
    /// By all fixes.
    pub all: usize,
}

impl Offer {
    /// Those that findings hold as they stand.
    pub fn of(report: &Report) -> Offer {
        let of = |allow: Allow| {
            let mendable = report.diagnostics.iter().filter(|d| {
                let fix = d.fix.as_ref();
                fix.is_some_and(|f| allow.permits(f)) && report.can_apply(d)
            });
            mendable.count()
        };
        Offer {
            safe: of(Allow::Safe),
            all: of(Allow::Unsafe),
        }
    }
}

/// Counts the findings in the text of an input that `--fix` and `--unsafe-fixes` mend, those
/// included that come to light on the way: by mending it.
pub fn offer(
    name: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
    report: &Report,
) -> Offer {
    let world = World::new(options, files);
    let apparent = Offer::of(report);
    match report.look(text).filter(|_| apparent.all > 0) {
        Some(seen) => {
            let (safe, all) = count_fixes(text, seen, |text| look(name, text, world));
            Offer { safe, all }
        }
        None => Offer::default(),
    }
}
