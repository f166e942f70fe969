//! What fixes make of a text, each round judged anew, and how many findings they mend.

use super::document::{Findings, check_with};
use super::host::Packages;
use super::include::Includes;
use super::options::{Desktop, DialectChoice, HostNames, Options};
use super::partner::NOBODY;
use crate::diagnostic::Diagnostic;
use crate::lint::{Allow, Fixed, Judged, Look, Settings, count_fixes, fix};
use crate::text::kind::Claim;
use crate::text::{Content, Span};

/// Mends what can be mended in the text of one shader file, judging it anew after each round.
pub fn fix_text(
    name: &str,
    text: &str,
    choice: DialectChoice,
    settings: &Settings,
    allow: Allow,
) -> Fixed {
    let options = Options {
        dialect: choice,
        settings,
        host: &HostNames::default(),
        includes: &Includes::none(),
        partners: &NOBODY,
        packages: &Packages::none(),
        desktop: Desktop::default(),
        claim: Claim::None,
    };
    fix_with(name, text, &options, allow)
}

/// Mends what can be mended in the text of one input, judging it anew after each round.
pub fn fix_with(name: &str, text: &str, options: &Options, allow: Allow) -> Fixed {
    fix(text, allow, |text| look(name, text, options))
}

fn look(name: &str, text: &str, options: &Options) -> Option<Look> {
    let mut findings = check_with(name, Content::utf8(text), options).ok()?;
    // What was not asked for is seen, and not mended.
    let others = findings.diagnostics.iter_mut();
    others
        .filter(|d| !options.settings.reports(d.rule))
        .for_each(|d| d.fix = None);
    findings.look(text)
}

impl Findings {
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
    pub fn of(findings: &Findings) -> Offer {
        let of = |allow: Allow| {
            let mendable = findings.diagnostics.iter().filter(|d| {
                let fix = d.fix.as_ref();
                fix.is_some_and(|f| allow.permits(f)) && findings.can_apply(d)
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
pub fn offer(name: &str, text: &str, options: &Options, findings: &Findings) -> Offer {
    let apparent = Offer::of(findings);
    match findings.look(text).filter(|_| apparent.all > 0) {
        Some(seen) => {
            let (safe, all) = count_fixes(text, seen, |text| look(name, text, options));
            Offer { safe, all }
        }
        None => Offer::default(),
    }
}
