//! Scripts: JavaScript and TypeScript, with JSX.

mod build;
mod depth;
mod scan;
pub mod token;
pub mod tree;

use oxc_allocator::Allocator;
use oxc_parser::{ParseOptions, Parser};
use oxc_span::SourceType;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::cell::RefCell;
use std::hash::BuildHasher;
use std::rc::Rc;
use tree::ScriptTree;

/// Maximum number of bytes of the scripts whose trees are kept, except for the last one.
const MAX_KEPT: usize = 1 << 21;

thread_local! {
    /// The scripts that were parsed last, with their trees: a file is asked several questions in a row.
    static PARSED: RefCell<Vec<(Box<str>, Rc<ScriptTree>)>> = const { RefCell::new(Vec::new()) };
}

/// The tree of a script, which is parsed once.
pub fn parse(text: &str) -> Rc<ScriptTree> {
    PARSED.with_borrow_mut(|kept| {
        if let Some(at) = kept.iter().rposition(|(script, _)| **script == *text) {
            let known = kept.remove(at);
            kept.push(known);
        } else {
            kept.push((text.into(), Rc::new(parsed(text))));
            while kept.len() > 1 && kept.iter().map(|k| k.0.len()).sum::<usize>() > MAX_KEPT {
                kept.remove(0);
            }
        }
        kept.last()
            .map(|(_, tree)| tree.clone())
            .unwrap_or_default()
    })
}

/// Whether the nesting of a script is limited. Modules are asked by each script that imports them, so the answers
/// are kept.
pub fn is_limited_once(text: &str) -> bool {
    /// Maximum number of answers that are kept.
    const MAX_ANSWERS: usize = 4096;
    thread_local! {
        static ANSWERS: RefCell<FxHashMap<(usize, u64), bool>> = RefCell::default();
    }
    let key = (text.len(), FxBuildHasher.hash_one(text));
    ANSWERS.with_borrow_mut(|answers| {
        if answers.len() >= MAX_ANSWERS {
            answers.clear();
        }
        *answers
            .entry(key)
            .or_insert_with(|| depth::is_limited(text))
    })
}

/// Parses a script. Where that fails, its literals are found without it.
fn parsed(text: &str) -> ScriptTree {
    if !depth::is_limited(text) {
        return scan::scan(text);
    }
    let types = [
        SourceType::tsx(),
        SourceType::ts(),
        SourceType::script().with_jsx(true),
    ];
    for source_type in types {
        let allocator = Allocator::default();
        let parsed = Parser::new(&allocator, text, source_type)
            .with_options(ParseOptions {
                preserve_parens: false,
                ..ParseOptions::default()
            })
            .parse();
        if !parsed.panicked {
            return build::build(text, &parsed.program);
        }
    }
    scan::scan(text)
}
