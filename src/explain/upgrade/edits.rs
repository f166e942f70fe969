//! The edits of a conversion.

use super::obstacle::{ObstacleKind, UpgradeObstacle};
use super::scan::{RawScan, ScannedToken};
use super::words::WordMap;
use shaderlint_semantic::builtins::Stage;
use shaderlint_semantic::{Program, Storage, globals, late_values};
use shaderlint_syntax::{GlExtension, GroupDirective};
use shaderlint_text::{CompiledText, Edit, SetAt, Span, remove_lines};

/// Maps an offset after sorted edits to the text before them.
pub(super) fn original(edits: &[Edit], base: u32, offset: u32) -> u32 {
    let mut moved = 0_i64;
    for edit in edits {
        let start = i64::from(edit.span.start - base) + moved;
        let end = start + edit.text.len() as i64;
        if i64::from(offset) < start {
            break;
        }
        if i64::from(offset) < end {
            return edit.span.start - base;
        }
        moved += edit.text.len() as i64 - i64::from(edit.span.len());
    }
    u32::try_from(i64::from(offset) - moved).unwrap_or(0)
}

/// Removes the directives of extensions that are part of GLSL ES 3.00, and refuses conditions that depend
/// on the version or on an extension.
pub(super) fn directives(
    program: &Program,
    scan: &RawScan,
    edits: &mut Vec<Edit>,
) -> Result<(), UpgradeObstacle> {
    if let Some(token) = scan.tokens.iter().find(|t| t.text == "__VERSION__") {
        return Err(UpgradeObstacle::at(token.span, ObstacleKind::VersionTest));
    }
    let mut removed = vec![false; scan.directives.len()];
    for (index, directive) in scan.directives.iter().enumerate() {
        let rest = scan.rest(directive);
        match directive.name {
            "extension" if is_core(rest) => mark(&mut removed, index),
            "pragma" if program.stage == Stage::Fragment && is_invariant_all(rest) => {
                mark(&mut removed, index);
            }
            name if GroupDirective::of(name).is_some() => {
                let Some(tested) = rest.iter().find(|t| is_extension(program, t)) else {
                    continue;
                };
                let end = extension_group(scan, index).ok_or_else(|| {
                    let kind = ObstacleKind::ExtensionTest(tested.text.to_string());
                    UpgradeObstacle::at(tested.span, kind)
                })?;
                (index..=end).for_each(|i| mark(&mut removed, i));
            }
            _ => {}
        }
    }
    for (directive, _) in scan.directives.iter().zip(&removed).filter(|(_, r)| **r) {
        let edit = remove_lines(&program.sources, directive.span);
        // Blank lines of two removals may overlap.
        let is_free = |e: &Edit| !e.span.touches(edit.span) || e.span.end == edit.span.start;
        match edits.iter().all(is_free) {
            true => edits.push(edit),
            false => edits.push(Edit::delete(directive.span)),
        }
    }
    Ok(())
}

fn mark(removed: &mut [bool], index: usize) {
    removed.set_at(index, true);
}

/// Whether an `#extension` names an extension that is part of GLSL ES 3.00.
fn is_core(rest: &[ScannedToken]) -> bool {
    let name = rest.first().map_or("", |t| t.text);
    GlExtension::of_directive(name).is_some_and(|known| !known.facts().built_in.is_empty())
}

fn is_invariant_all(rest: &[ScannedToken]) -> bool {
    let words: Vec<&str> = rest.iter().map(|t| t.text).collect();
    words == ["STDGL", "invariant", "(", "all", ")"]
}

/// Whether a word in a condition is the macro of an extension.
fn is_extension(program: &Program, token: &ScannedToken) -> bool {
    let is_own = || {
        let mut macros = program.tokens.macros.iter();
        macros.any(|m| !m.name_span.is_empty() && program.names.text(m.name) == token.text)
    };
    let is_fixed = matches!(token.text, "GL_ES" | "GL_FRAGMENT_PRECISION_HIGH");
    token.is_word() && token.text.starts_with("GL_") && !is_fixed && !is_own()
}

/// The `#endif` of a condition after which there is nothing but `#extension` of known extensions.
fn extension_group(scan: &RawScan, index: usize) -> Option<usize> {
    let groups = scan.groups().all.into_iter();
    let mut own = groups.filter(|g| g.directives().next() == Some(&index));
    let group = own.next().filter(|g| g.branches.len() == 1)?;
    let end = group.end?;
    let mut held = scan.directives.get(index + 1..end)?.iter();
    let (start, last) = (scan.directives.get(index)?, scan.directives.get(end)?);
    let inside = |span: Span| start.span.end <= span.start && span.end <= last.span.start;
    let mut code = scan.tokens.iter().filter(|t| t.directive.is_none());
    let is_known = held.all(|d| d.name == "extension" && is_core(scan.rest(d)));
    (is_known && !code.any(|t| inside(t.span))).then_some(end)
}

/// Moves the initial values that are not constant in GLSL ES 3.00 to `main`.
pub(super) fn initial_values(
    program: &Program,
    edits: &mut Vec<Edit>,
) -> Result<(), UpgradeObstacle> {
    let late = |init| !program.expr(init).is_const;
    let mut all = globals(program);
    let Some(init) = all.find_map(|(_, d)| d.init.filter(|init| late(*init))) else {
        return Ok(());
    };
    let main = program
        .entry()
        .and_then(|f| program.function(f)?.definition);
    let main = main.and_then(|f| program.tree.function(f));
    let moved = main.and_then(|main| late_values(program, main, late));
    let span = program.expr_span(init);
    edits.extend(moved.ok_or_else(|| UpgradeObstacle::at(span, ObstacleKind::InitialValue))?);
    Ok(())
}

/// Removes `invariant` from inputs of fragment shaders.
pub(super) fn invariant_inputs(program: &Program, scan: &RawScan, edits: &mut Vec<Edit>) {
    if program.stage != Stage::Fragment {
        return;
    }
    for (at, token) in scan.tokens.iter().enumerate() {
        let Some(next) = scan.tokens.get(at + 1) else {
            return;
        };
        if token.text != "invariant" || token.directive.is_some_and(|_| next.text != "varying") {
            continue;
        }
        if next.text == "varying" {
            edits.push(Edit::delete(Span::new(token.span.start, next.span.start)));
            continue;
        }
        let names = scan.tokens.get(at + 1..).unwrap_or(&[]).iter();
        let statement: Vec<_> = names.take_while(|t| t.text != ";").collect();
        let end = scan.tokens.get(at + 1 + statement.len());
        let is_input = |name: &str| {
            let mut all = program.variables.iter();
            all.any(|v| program.names.text(v.name) == name && v.storage == Storage::Input)
        };
        let names = statement.iter().filter(|t| t.text != ",");
        if let Some(end) = end.filter(|_| names.clone().all(|t| is_input(t.text))) {
            let span = Span::new(token.span.start, end.span.end);
            edits.push(remove_lines(&program.sources, span));
        }
    }
}

/// Replaces words.
pub(super) fn words(scan: &RawScan, map: &WordMap, edits: &mut Vec<Edit>) {
    let is_removed: Vec<Span> = edits.iter().map(|e| e.span).collect();
    let is_removed = |span: Span| is_removed.iter().any(|r| r.contains(span));
    for (at, token) in scan.tokens.iter().enumerate() {
        let name = scan.directive_of(token).map_or("", |d| d.name);
        if !token.is_word() || matches!(name, "version" | "extension" | "pragma" | "error" | "line")
        {
            continue;
        }
        let Some(replacement) = map.get(token.text) else {
            continue;
        };
        let before = at.checked_sub(1).and_then(|i| scan.tokens.get(i));
        let is_member = before.is_some_and(|t| t.text == ".");
        let places = replacement.only.as_ref();
        let is_meant = places.is_none_or(|places| places.contains(&token.span.start));
        if is_meant && (!is_member || replacement.has_members) && !is_removed(token.span) {
            edits.push(Edit::replace(token.span, &*replacement.to));
        }
    }
    // Values that are moved to `main` are converted there.
    for edit in edits.iter_mut().filter(|e| e.span.is_empty()) {
        edit.text = converted(&edit.text, map);
    }
}

/// A text with its words replaced.
fn converted(text: &str, map: &WordMap) -> String {
    let code = CompiledText {
        text,
        base: 0,
        role: shaderlint_text::Role::User,
    };
    let mut out = String::new();
    let mut from = 0;
    for token in RawScan::of(&code).tokens {
        let replacement = map
            .get(token.text)
            .filter(|r| token.is_word() && r.only.is_none());
        let Some(replacement) = replacement else {
            continue;
        };
        out.push_str(text.get(from..token.span.start as usize).unwrap_or(""));
        out.push_str(&replacement.to);
        from = token.span.end as usize;
    }
    out + text.get(from..).unwrap_or("")
}

/// Puts `#version 300 es` in the first line.
pub(super) fn version(program: &Program, code: &CompiledText, edits: &mut Vec<Edit>) {
    const DIRECTIVE: &str = "#version 300 es";
    match program.tokens.version_span {
        Some(span) if span.start == code.base => edits.push(Edit::replace(span, DIRECTIVE)),
        old => {
            edits.extend(old.map(|span| remove_lines(&program.sources, span)));
            let first = edits.iter_mut().find(|e| e.span == Span::at(code.base));
            match first {
                Some(edit) => edit.text.insert_str(0, &format!("{DIRECTIVE}\n")),
                None => edits.push(Edit::insert(code.base, format!("{DIRECTIVE}\n"))),
            }
        }
    }
}
