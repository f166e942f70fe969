//! Scripts: JavaScript and TypeScript, with JSX.

mod build;
mod depth;
mod scan;
pub mod token;
pub mod tree;

use oxc_allocator::Allocator;
use oxc_parser::{ParseOptions, Parser};
use oxc_span::SourceType;
use tree::ScriptTree;

/// Parses a script. Where that fails, its literals are found without it.
pub fn parse(text: &str) -> ScriptTree {
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
