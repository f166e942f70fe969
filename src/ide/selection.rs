//! Selection ranges: expression, statement, block, function, document.

use super::document::Document;
use shaderlint_syntax::ast::Extent;
use shaderlint_text::Span;

/// Maximum number of nested ranges.
const MOST_DEEP: usize = 64;

/// The ranges around an offset, innermost first, each inside the next.
pub fn selection(document: &Document, offset: u32) -> Vec<Span> {
    let mut found = vec![Span::new(0, document.text.len() as u32)];
    if let Some(spot) = document.spot(offset) {
        let program = spot.program();
        let tree = &program.tree;
        let mut add = |extent: Extent| {
            let span = program.span(extent);
            if (span.start..=span.end).contains(&spot.address) {
                found.extend(document.report.in_input(span));
            }
        };
        tree.exprs.iter().for_each(|e| add(e.extent));
        tree.stmts.iter().for_each(|s| add(s.extent));
        tree.decls.iter().for_each(|d| add(d.extent));
        tree.functions.iter().for_each(|f| add(f.extent));
        tree.structs.iter().for_each(|s| add(s.extent));
        tree.param_lists.iter().for_each(|p| add(p.extent));
        found.extend(spot.name().and_then(|n| document.report.in_input(n.span)));
    }
    found.sort_by_key(|s| (s.len(), s.start));
    found.dedup();
    // Drops ranges that only touch the position, or do not contain the previous range.
    let mut nested: Vec<Span> = Vec::new();
    for span in found {
        if nested
            .last()
            .is_none_or(|inner| span.contains(*inner) && span != *inner)
        {
            nested.push(span);
        }
    }
    // Some clients cannot parse deeply nested answers.
    if nested.len() > MOST_DEEP {
        let left_out = nested.len() - MOST_DEEP;
        nested.drain(MOST_DEEP / 2..MOST_DEEP / 2 + left_out);
    }
    nested
}
