//! The Book of Shaders: the text is compiled unchanged, and once more for each macro such as
//! `BUFFER_0` that it tests, with that macro defined; the output of that pass is `u_buffer0`.

use super::complete::{Completion, completions_of};
use super::{Clues, HostCode, Plan, PlannedPass};
use crate::OutputId;
use shaderlint_semantic::Pass;
use std::sync::Arc;

pub(super) static CODE: HostCode = HostCode {
    host: "book-of-shaders",
    signs: |_| Vec::new(),
    plan: Some(plan),
    declare: None,
};

/// The macros that require another pass, with the samplers that read its output.
fn buffers(clues: &Clues) -> Vec<(String, String)> {
    let all = (0..8).flat_map(|n| {
        [
            (format!("BUFFER_{n}"), format!("u_buffer{n}")),
            (format!("DOUBLE_BUFFER_{n}"), format!("u_doubleBuffer{n}")),
        ]
    });
    all.filter(|(name, _)| clues.has_word(name)).collect()
}

fn plan(clues: &Clues) -> Plan {
    let image = Plan::image(completions_of(clues));
    let buffers = buffers(clues);
    if buffers.is_empty() {
        return image;
    }
    // The branches of a buffer may have other requirements than the image, so each pass has all
    // candidates.
    let candidates = || completions_of(clues).into_iter();
    let passes = buffers.into_iter().map(|(name, sampler)| PlannedPass {
        kind: Pass::Buffer,
        name: sampler.clone(),
        output: OutputId::of_dialect(&sampler),
        candidates: candidates()
            .filter_map(|c| defining(&c, clues, &name))
            .collect(),
        inputs: Vec::new(),
        is_of_text: true,
        pieces: Vec::new(),
    });
    let mut all: Vec<PlannedPass> = passes.collect();
    all.extend(image.passes);
    Plan {
        passes: all,
        ..Plan::default()
    }
}

/// A candidate with a macro before it.
fn defining(candidate: &Completion, clues: &Clues, name: &str) -> Option<Completion> {
    let define = format!("#define {name}\n");
    match candidate.before.is_empty() {
        // A define can precede an unchanged text only if that has no `#version`.
        true => {
            let first = clues.text.trim_start().starts_with("#version");
            (!first).then(|| Completion {
                before: Arc::from(define),
                ..candidate.clone()
            })
        }
        false => Some(Completion {
            before: Arc::from(format!("{}{define}", candidate.before)),
            ..candidate.clone()
        }),
    }
}
