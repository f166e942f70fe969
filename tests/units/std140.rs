//! The layout of uniform blocks, against what Chromium says of the same 100 random blocks: `getActiveUniforms` with
//! UNIFORM_OFFSET and UNIFORM_ARRAY_STRIDE, and UNIFORM_BLOCK_DATA_SIZE.

use shaderlint::semantic::interface::Interface;
use shaderlint::semantic::{BlockLayout, Stage, Unit, check_shader};
use shaderlint::syntax::Search;
use shaderlint::text::{Role, Sources};
use std::sync::Arc;

/// The layout of the block of a shader, as in the table.
fn laid_out(block: &str) -> String {
    let text = format!("#version 300 es\nprecision highp float;\n{block}\nvoid main() {{}}\n");
    let mut sources = Sources::new();
    let file = sources.add("block.frag", None, Role::User, text).unwrap();
    let sources = Arc::new(sources);
    let files = [file];
    let unit = Unit::complete(&sources, &files, Stage::Fragment);
    let checked = check_shader(&unit, &mut Search::for_text());
    let interface = Interface::of(&checked.program);
    let layout = BlockLayout::of(&interface, &interface.blocks[0]).unwrap();
    let members = layout.members.iter().map(|m| match m.stride {
        0 => format!("{} {}", m.name, m.offset),
        stride => format!("{} {}/{stride}", m.name, m.offset),
    });
    format!(
        "{}: {}",
        layout.size,
        members.collect::<Vec<_>>().join(", ")
    )
}

#[test]
fn members_of_blocks_are_where_chromium_puts_them() {
    let lines: Vec<&str> = include_str!("std140.txt").lines().collect();
    let wrong: Vec<String> = lines
        .chunks(2)
        .filter(|pair| laid_out(pair[0]) != pair[1])
        .map(|pair| format!("{}\n{}\n{}", pair[0], pair[1], laid_out(pair[0])))
        .collect();
    assert!(
        wrong.is_empty(),
        "{} of 100\n{}",
        wrong.len(),
        wrong.join("\n")
    );
    assert_eq!(lines.len(), 200);
}
