//! Uniform blocks: of one name in both stages, they are one block (GLSL ES 3.00 section 4.3.7).

use super::compare::{InterfaceComparison, PrecisionMatch};
use super::errors::{LinkErrors, LinkSite, SAME};
use super::interface::{Block, Interface};
use crate::{Base, Field, Type};
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::error;
use shaderlint_syntax::ast::TokenId;

/// A member of a block without an instance, whose name is a global one.
struct GlobalMember<'a, 'p> {
    interface: &'a Interface<'p>,
    block: &'p str,
    token: TokenId,
}

/// Asks that blocks of one name are the same, and that the names of members stand for one thing.
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
            let message = format!(
                "the block `{name}` {of_fragment} in the fragment shader, and {of_vertex} in the \
                 vertex shader"
            );
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

/// What two blocks say of their instances, the fragment shader's first, where it is not the same.
fn heads(vertex: &Block, fragment: &Block) -> Option<(String, String)> {
    let say = |block: &Block| match block.instance {
        None => "has no instance name".to_string(),
        Some((_, 0)) => "has an instance name".to_string(),
        Some((_, n)) => format!("is an array of {n}"),
    };
    let array = |b: &Block| b.instance.map(|(_, n)| n);
    (array(vertex) != array(fragment)).then(|| (say(fragment), say(vertex)))
}

/// Matrices lie by rows in both stages, or by columns.
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
    let mut tell = |what: &str, of_vertex: (TokenId, bool), of_fragment: (TokenId, bool)| {
        let message = format!(
            "{what} is {} in the fragment shader and {} in the vertex shader",
            word(of_fragment.1),
            word(of_vertex.1)
        );
        let first = LinkSite::new(fragment, of_fragment.0, word(of_fragment.1));
        let second = LinkSite::new(vertex, of_vertex.0, word(of_vertex.1));
        if let Some(d) = found.differ(error::LINK_BLOCK, message, first, second) {
            d.notes.push(SAME.to_string());
        }
    };
    // The browser compares them even where there is no matrix.
    if of_vertex.by_rows != of_fragment.by_rows {
        let [vertex_side, fragment_side] = [of_vertex, of_fragment].map(|b| (b.token, b.by_rows));
        return tell(&format!("the block `{name}`"), vertex_side, fragment_side);
    }
    let members = |interface, block: &Block| {
        let fields = fields(interface, block).iter();
        fields.zip(block.members_by_rows.clone())
    };
    let with_matrices = with_matrices(fragment);
    for (v, f) in members(vertex, of_vertex).zip(members(fragment, of_fragment)) {
        if v.1 != f.1 && holds_matrix(f.0.ty, &with_matrices) {
            let what = format!("`{name}.{}`", fragment.text(f.0.name));
            return tell(&what, (v.0.token, v.1), (f.0.token, f.1));
        }
    }
}

/// By struct: whether there is a matrix in it. What it holds is declared before it.
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

/// The name of a member of a block without an instance is no uniform, and no member of another such
/// block.
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
                "`{name}` is a uniform in one stage and a member of the block `{}` in the other",
                member.block
            );
            let first = LinkSite::new(interface, uniform.token, "the uniform");
            let label = format!("the member of `{}`", member.block);
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
        "`{name}` is a member of the block `{}` in one stage and of `{}` in the other",
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
