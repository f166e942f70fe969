//! Declares outputs in place of `gl_FragColor` and `gl_FragData`.

use super::obstacle::{DRAW_BUFFERS, ObstacleKind, UpgradeObstacle};
use super::scan::RawScan;
use super::words::WordMap;
use shaderlint_semantic::Program;
use shaderlint_semantic::Value;
use shaderlint_semantic::builtins::Stage;
use shaderlint_syntax::TypeWord;
use shaderlint_syntax::ast::{DeclKind, ExprKind, Extent, Item, TypeBase};
use shaderlint_text::{Edit, Span};

/// Declares the output that a fragment shader uses, and replaces its name.
pub(super) fn declare(
    program: &Program,
    scan: &RawScan,
    map: &mut WordMap,
) -> Result<Vec<Edit>, UpgradeObstacle> {
    let (has_color, has_data) = (scan.has_word("gl_FragColor"), scan.has_word("gl_FragData"));
    if program.stage != Stage::Fragment || !has_color && !has_data {
        return Ok(Vec::new());
    }
    let mut edits = Vec::new();
    let count = if has_data { outputs(program)? } else { 1 };
    let only_first = first_elements(scan);
    let name = match only_first {
        Some(elements) => {
            if has_color {
                refuse_broadcast(program, scan)?;
            }
            let name = map.unused("fragColor", program, scan);
            map.replace("gl_FragColor", &name);
            edits.extend(elements.into_iter().map(|at| Edit::replace(at, &*name)));
            name
        }
        None => {
            let name = map.unused("fragData", program, scan);
            map.replace("gl_FragData", &name);
            map.replace("gl_FragColor", &format!("{name}[0]"));
            format!("{name}[{count}]")
        }
    };
    let (at, has_precision) = place(program, scan);
    let precision = if has_precision { "" } else { "mediump " };
    edits.push(Edit::insert(at, format!("out {precision}vec4 {name};\n")));
    Ok(edits)
}

/// The uses of `gl_FragData`, if all are `gl_FragData[0]`.
fn first_elements(scan: &RawScan) -> Option<Vec<Span>> {
    let mut found = Vec::new();
    for (i, token) in scan.tokens.iter().enumerate() {
        if token.text != "gl_FragData" {
            continue;
        }
        let rest = scan.tokens.get(i + 1..i + 4)?;
        let texts = rest.iter().map(|t| t.text);
        if !texts.eq(["[", "0", "]"]) {
            return None;
        }
        found.push(token.span.to(rest.last()?.span));
    }
    Some(found)
}

/// With the extension of several outputs, `gl_FragColor` is written to all of them.
fn refuse_broadcast(program: &Program, scan: &RawScan) -> Result<(), UpgradeObstacle> {
    let is_enabled = program.tokens.extensions.iter().any(|used| {
        let text = |name| program.names.text(name);
        text(used.name) == DRAW_BUFFERS && text(used.behavior) != "disable"
    });
    let color = scan.tokens.iter().find(|t| t.text == "gl_FragColor");
    match color.filter(|_| is_enabled) {
        Some(token) => Err(UpgradeObstacle::at(token.span, ObstacleKind::Broadcast)),
        None => Ok(()),
    }
}

/// The number of elements of `gl_FragData` that are used.
fn outputs(program: &Program) -> Result<u32, UpgradeObstacle> {
    let mut count = 1;
    let name = program.names.get("gl_FragData");
    for expr in &program.tree.exprs {
        let ExprKind::Index(object, index) = expr.kind else {
            continue;
        };
        let object = program.tree.expr(program.tree.unparen(object));
        let ExprKind::Name(used) = object.kind else {
            continue;
        };
        if Some(used) != name {
            continue;
        }
        match program.scalar(index) {
            Some(Value::Int(at)) if at >= 0 => count = count.max(at as u32 + 1),
            _ => {
                let span = program.expr_span(index);
                return Err(UpgradeObstacle::at(span, ObstacleKind::OutputIndex));
            }
        }
    }
    Ok(count)
}

/// Where an output may be declared: before the first declaration that is not a default precision and not
/// inside `#if`. Also whether `float` has a default precision there.
fn place(program: &Program, scan: &RawScan) -> (u32, bool) {
    let tree = &program.tree;
    let start = |extent: Extent| program.span(extent).start;
    let mut precisions = Vec::new();
    let mut first = None;
    for item in &tree.items {
        let decl = match item {
            Item::Decl(id) => tree.decl(*id),
            Item::Function(_) => None,
        };
        match (decl.map(|d| (d.kind, d.extent)), item) {
            (Some((DeclKind::Precision { ty, .. }, extent)), _) => {
                let is_float = tree.ty(ty).base == TypeBase::Word(TypeWord::Float);
                precisions.extend(is_float.then(|| start(extent)));
                continue;
            }
            (Some((_, extent)), _) => first = Some(start(extent)),
            (None, Item::Function(id)) => first = tree.function(*id).map(|f| start(f.extent)),
            (None, _) => {}
        }
        break;
    }
    let first = first.unwrap_or_default();
    let code = scan.tokens.iter().find(|t| t.directive.is_none());
    let at = match scan.open_group(first) {
        // A group at the start may contain what must precede all declarations.
        Some(group)
            if code.is_some_and(|t| t.span.start < group) || !has_extension(scan, group, first) =>
        {
            group
        }
        _ => first,
    };
    (at, precisions.iter().any(|p| *p < at))
}

/// Whether there is an `#extension` between two addresses.
fn has_extension(scan: &RawScan, from: u32, to: u32) -> bool {
    let inside = |span: Span| from <= span.start && span.start < to;
    let mut all = scan.directives.iter();
    all.any(|d| d.name == "extension" && inside(d.span))
}
