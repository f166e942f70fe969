//! What fixes make of a text, each round judged anew, and how many findings they mend.

use super::document::{Report, judge};
use super::files::Files;
use super::options::Options;
use super::world::World;
use crate::diagnostic::{Applicability, Diagnostic};
use crate::lint::{Allow, Fixed, Judged, Look, fix, fix_seen};
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
    /// Mended by the fixes that keep the picture.
    pub safe: usize,
    /// Found with a fix that has to be asked for; mending them may bring others to light.
    pub others: usize,
}

impl Offer {
    /// Those that findings hold as they stand.
    pub fn of(report: &Report) -> Offer {
        let of = |applicability: Applicability| {
            let mendable = report.diagnostics.iter().filter(|d| {
                let fix = d.fix.as_ref();
                fix.is_some_and(|f| f.applicability == applicability) && report.can_apply(d)
            });
            mendable.count()
        };
        Offer {
            safe: of(Applicability::Safe),
            others: of(Applicability::Unsafe),
        }
    }
}

/// Counts the findings in the text of an input that fixes mend: those that `--fix` mends by mending
/// it, so that the ones are counted that come to light on the way.
pub fn offer(
    name: &str,
    text: &str,
    options: &Options,
    files: &dyn Files,
    report: &Report,
) -> Offer {
    let world = World::new(options, files);
    let apparent = Offer::of(report);
    let seen = report.look(text).filter(|_| apparent.safe > 0);
    let look = |text: &str| look(name, text, world);
    let fixed = seen.map(|seen| fix_seen(text, seen, Allow::Safe, look));
    Offer {
        safe: fixed.map_or(0, |f| f.applied.len()),
        ..apparent
    }
}
