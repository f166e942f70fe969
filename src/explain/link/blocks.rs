//! Uniform blocks: blocks of the same name in both stages are one block (GLSL ES 3.00 section
//! 4.3.7).

use super::compare::{InterfaceComparison, PrecisionMatch};
use super::errors::{LinkErrors, LinkSite, SAME};
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::error;
use shaderlint_semantic::interface::{Block, Interface};
use shaderlint_semantic::{Base, Field, Type};
use shaderlint_syntax::ast::TokenId;

/// A member of a block without an instance name, which is a global name.
struct GlobalMember<'a, 'p> {
    interface: &'a Interface<'p>,
    block: &'p str,
    token: TokenId,
}

/// Checks that blocks of the same name match and that global member names are unambiguous.
pub fn check(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    names(vertex, fragment, found);
    let mut comparison = InterfaceComparison::new(vertex, fragment);
    let of_vertex = vertex.blocks.iter().map(|b| (vertex.text(b.name), b));
    let of_vertex: FxHashMap<&str, &Block> = of_vertex.collect();
    for block in &fragment.blocks {
        if found.is_full() {
            return;
        }
        let name = fragment.text(block.name);
        let Some(other) = of_vertex.get(name) else {
            continue;
        };
        let records = (other.record, block.record);
        if let Some(difference) = comparison.records(records.0, records.1, PrecisionMatch::Same) {
            found.difference(error::LINK_BLOCK, name, vertex, fragment, &difference);
        } else if let Some((of_fragment, of_vertex)) = heads(other, block) {
            let message = format!("instances of block `{name}` differ between the stages");
            let first = LinkSite::new(fragment, block.token, of_fragment);
            let second = LinkSite::new(vertex, other.token, of_vertex);
            if let Some(d) = found.differ(error::LINK_BLOCK, message, first, second) {
                d.notes.push(SAME.to_string());
            }
        } else {
            packing(vertex, fragment, (other, block), found);
        }
    }
}

fn fields<'a>(interface: &Interface<'a>, block: &Block) -> &'a [Field] {
    let record = interface.program.structs.get(block.record as usize);
    record.map_or(&[], |r| &r.fields)
}

/// Descriptions of the instances of two blocks, the fragment shader's first, if they differ.
fn heads(vertex: &Block, fragment: &Block) -> Option<(String, String)> {
    let description = |block: &Block| match block.instance {
        None => "no instance name".to_string(),
        Some((_, 0)) => "instance name".to_string(),
        Some((_, n)) => format!("array of {n}"),
    };
    let array = |b: &Block| b.instance.map(|(_, n)| n);
    (array(vertex) != array(fragment)).then(|| (description(fragment), description(vertex)))
}

/// Matrix layouts (row- or column-major) must match.
fn packing(
    vertex: &Interface,
    fragment: &Interface,
    (of_vertex, of_fragment): (&Block, &Block),
    found: &mut LinkErrors,
) {
    let word = |by_rows: bool| match by_rows {
        true => "`row_major`",
        false => "`column_major`",
    };
    let name = fragment.text(of_fragment.name);
    let mut report = |what: &str, of_vertex: (TokenId, bool), of_fragment: (TokenId, bool)| {
        let message = format!(
            "{what} is {} in the fragment but {} in the vertex shader",
            word(of_fragment.1),
            word(of_vertex.1)
        );
        let first = LinkSite::new(fragment, of_fragment.0, word(of_fragment.1));
        let second = LinkSite::new(vertex, of_vertex.0, word(of_vertex.1));
        if let Some(d) = found.differ(error::LINK_BLOCK, message, first, second) {
            d.notes.push(SAME.to_string());
        }
    };
    // The browser compares them even if there is no matrix.
    if of_vertex.by_rows != of_fragment.by_rows {
        let [vertex_side, fragment_side] = [of_vertex, of_fragment].map(|b| (b.token, b.by_rows));
        return report(&format!("block `{name}`"), vertex_side, fragment_side);
    }
    let members = |interface, block: &Block| {
        let fields = fields(interface, block).iter();
        fields.zip(block.members_by_rows.clone())
    };
    let with_matrices = with_matrices(fragment);
    for (v, f) in members(vertex, of_vertex).zip(members(fragment, of_fragment)) {
        if v.1 != f.1 && holds_matrix(f.0.ty, &with_matrices) {
            let what = format!("`{name}.{}`", fragment.text(f.0.name));
            return report(&what, (v.0.token, v.1), (f.0.token, f.1));
        }
    }
}

/// By struct: whether it contains a matrix. Nested structs come first.
fn with_matrices(interface: &Interface) -> Vec<bool> {
    let mut known: Vec<bool> = Vec::new();
    for record in &interface.program.structs {
        let holds = record.fields.iter().any(|f| holds_matrix(f.ty, &known));
        known.push(holds);
    }
    known
}

fn holds_matrix(ty: Type, with_matrices: &[bool]) -> bool {
    match ty.base {
        Base::Numeric { columns, .. } => columns > 1,
        Base::Struct(id) => with_matrices.get(id as usize).copied().unwrap_or(false),
        _ => false,
    }
}

/// The name of a member of a block without an instance name must not be a uniform or a member of
/// another such block.
fn names(vertex: &Interface, fragment: &Interface, found: &mut LinkErrors) {
    let mut members: FxHashMap<&str, GlobalMember> = FxHashMap::default();
    for interface in [vertex, fragment] {
        for block in interface.blocks.iter().filter(|b| b.instance.is_none()) {
            let name = interface.text(block.name);
            for field in fields(interface, block) {
                let member = interface.text(field.name);
                let this = GlobalMember {
                    interface,
                    block: name,
                    token: field.token,
                };
                match members.get(member) {
                    Some(other) if other.block != name => clash(member, &this, other, found),
                    Some(_) => {}
                    None => {
                        members.insert(member, this);
                    }
                }
            }
        }
    }
    for interface in [vertex, fragment] {
        for uniform in &interface.uniforms {
            let name = interface.text(uniform.name);
            let Some(member) = members.get(name) else {
                continue;
            };
            let message = format!(
                "`{name}` is a uniform in one stage but a member of block `{}` in the other",
                member.block
            );
            let first = LinkSite::new(interface, uniform.token, "declared as a uniform");
            let label = format!("member of block `{}`", member.block);
            let second = LinkSite::new(member.interface, member.token, label);
            if let Some(d) = found.differ(error::LINK_BLOCK, message, first, second) {
                d.notes.push(GLOBAL.to_string());
                d.help
                    .push("rename one, or give the block an instance name".to_string());
            }
        }
    }
}

const GLOBAL: &str = "members of a block without an instance name are global names of the program \
                      (section 4.3.7)";

fn clash(name: &str, this: &GlobalMember, other: &GlobalMember, found: &mut LinkErrors) {
    let message = format!(
        "`{name}` is a member of block `{}` in one stage and of `{}` in the other",
        this.block, other.block
    );
    let first = LinkSite::new(this.interface, this.token, format!("in `{}`", this.block));
    let second = LinkSite::new(
        other.interface,
        other.token,
        format!("in `{}`", other.block),
    );
    if let Some(d) = found.differ(error::LINK_BLOCK, message, first, second) {
        d.notes.push(GLOBAL.to_string());
        d.help
            .push("rename one, or give the blocks instance names".to_string());
    }
}
