//! Requests of editors, on texts that are being edited.

use shaderlint::diagnostic::Severity;
use shaderlint::engine::Options;
use shaderlint::ide::{
    Document, HintOptions, OutlineItem, actions, call_item, colors, complete, declaration,
    definition, folds, highlights, hints, hover, incoming, lenses, may_rename, outgoing, outline,
    presentations, references, rename, selection, semantic_tokens, signature_help, type_definition,
};
use shaderlint::project::NoFiles;
use shaderlint::syntax::{Version, WordClass, classify};
use shaderlint::text::{Span, apply_edits};
use std::sync::Arc;

/// Number of positions of a text that are queried.
const PLACES: usize = 5;

/// Largest number of tokens and macro calls of a text that is queried at positions.
const MOST_TOKENS: usize = 50_000;

/// All queries at some positions of a text; all results must be inside the text, and a renaming
/// must be reversible.
pub fn answers(text: &str) {
    let options = Arc::new(Options::default());
    let document = Document::new("/a.glsl", text.into(), options, &NoFiles);
    check_document(&document);
    // Large macro expansions take long and are read again for each name: the target `check` covers
    // them.
    let mut programs = document.report.analyses.iter().map(|a| &a.program);
    if programs.any(|program| program.size() > MOST_TOKENS) {
        return;
    }
    // The positions depend on the text, so that a failure is reproducible.
    let mut hash = text.bytes().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    });
    for _ in 0..PLACES {
        hash = hash.wrapping_mul(0x9e37_79b1).rotate_left(13) ^ 0x85eb_ca6b;
        let mut at = hash as usize % (text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at_place(&document, at as u32);
    }
}

/// Whether a span is inside the text of a document.
fn is_inside(document: &Document, span: Span) -> bool {
    document
        .text
        .get(span.start as usize..span.end as usize)
        .is_some()
}

fn check_document(document: &Document) {
    let all = Span::new(0, document.text.len() as u32);
    let mut end = 0;
    for token in semantic_tokens(document) {
        assert!(
            token.span.start >= end && is_inside(document, token.span),
            "{token:?}"
        );
        end = token.span.end;
    }
    outline(document)
        .iter()
        .for_each(|item| in_outline(document, item));
    for fold in folds(document) {
        assert!(is_inside(document, fold.span), "{fold:?}");
    }
    for found in colors(document) {
        for edit in presentations(document, found.span, found.color) {
            assert!(is_inside(document, edit.span), "{edit:?}");
        }
    }
    for lens in lenses(document, &[]) {
        assert!(is_inside(document, lens.span), "{lens:?}");
    }
    let options = HintOptions {
        parameters: true,
        iterations: true,
        types: true,
    };
    for hint in hints(document, all, options, &[]) {
        assert!(is_inside(document, Span::at(hint.offset)), "{hint:?}");
    }
    for action in actions(document, &NoFiles, all) {
        let changed = apply_edits(&document.text, 0, &action.edits);
        assert!(changed.is_ok(), "{action:?}");
    }
}

fn in_outline(document: &Document, item: &OutlineItem) {
    assert!(is_inside(document, item.span), "{item:?}");
    assert!(item.span.contains(item.name_span), "{item:?}");
    item.inner
        .iter()
        .for_each(|inner| in_outline(document, inner));
}

fn at_place(document: &Document, at: u32) {
    if let Some(hover) = hover(document, at, None, &NoFiles) {
        assert!(is_inside(document, hover.span), "{hover:?}");
    }
    let (word, _) = complete(document, at, &NoFiles);
    assert!(is_inside(document, word) && word.end == at, "{word:?}");
    for find in [definition, declaration, type_definition] {
        if let Some(place) = find(document, at, &NoFiles) {
            assert!(is_inside(document, place.span), "{place:?}");
        }
    }
    for (span, _) in highlights(document, at, &NoFiles) {
        assert!(is_inside(document, span), "{span:?}");
    }
    for (place, _) in references(&[document], document, at, &NoFiles) {
        assert!(is_inside(document, place.span), "{place:?}");
    }
    signature_help(document, at, &NoFiles);
    if call_item(document, at).is_some() {
        incoming(&[document], document, at);
        outgoing(document, at);
    }
    let around = selection(document, at);
    for pair in around.windows(2) {
        assert!(pair[1].contains(pair[0]) && pair[0] != pair[1], "{pair:?}");
    }
    renames(document, at);
}

/// Whether a name is unrestricted: macros may have any name, and members may begin with `gl_`.
fn is_free(name: &str) -> bool {
    let versions = [Version::Es100, Version::Es300];
    let is_plain = versions
        .iter()
        .all(|v| classify(name, *v) == WordClass::Plain);
    // In excerpts, whose errors are not reported, a name may start with a digit.
    let is_word = !name.starts_with(|c: char| c.is_ascii_digit());
    is_plain && is_word && !name.starts_with("gl_") && !name.contains("__")
}

/// Renaming keeps the number of uses, and renaming back restores the text.
fn renames(document: &Document, at: u32) {
    const NEW: &str = "renamedByFuzz";
    let Ok((span, old)) = may_rename(document, at, &NoFiles) else {
        return;
    };
    assert!(is_inside(document, span));
    let Ok(renaming) = rename(&[document], document, at, NEW, &NoFiles) else {
        return;
    };
    let edits = &renaming.edits["/a.glsl"];
    let text = apply_edits(&document.text, 0, edits).expect("overlapping edits");
    let before = edits.iter().filter(|edit| edit.span.start < span.start);
    let shift: i64 = before
        .map(|edit| NEW.len() as i64 - i64::from(edit.span.len()))
        .sum();
    let now = Document::new(
        "/a.glsl",
        text.as_str().into(),
        document.options.clone(),
        &NoFiles,
    );
    let place = (i64::from(span.start) + shift) as u32;
    let back = rename(&[&now], &now, place, &old, &NoFiles);
    // An error may disappear: the old name was reserved or declared twice.
    let is_wrong = document
        .report
        .diagnostics
        .iter()
        .any(|d| d.severity == Severity::Error);
    let back = match back {
        Err(_) if is_wrong || !is_free(&old) => return,
        back => back.expect("rename back"),
    };
    let text = apply_edits(&now.text, 0, &back.edits["/a.glsl"]).expect("overlapping edits");
    assert_eq!(text, *document.text, "rename and rename back");
}
