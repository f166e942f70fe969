//! Too many of anything. What one device takes and another does not is no error: the limits here are
//! those that no implementation of WebGL exceeds.

use super::errors::{LinkErrors, LinkSite};
use super::interface::{Block, Interface, InterfaceVariable};
use crate::{Base, Stage, Type};
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::{Diagnostic, error};
use shaderlint_syntax::Feature;

/// Places for attributes.
const MAX_ATTRIBUTES: usize = 16;
/// Vectors of `uniform`s in one stage.
const MAX_UNIFORM_VECTORS: u64 = 4096;
/// Samplers in one stage.
const MAX_SAMPLERS: u64 = 32;
/// Blocks in one stage, each element of an array counted.
const MAX_BLOCKS: u64 = 16;
/// Vectors that pass between the stages.
const MAX_VARYING_VECTORS: u64 = 32;

/// Asks that all attributes have a place, and each its own (GLSL ES 3.00 sections 4.3.8.1 and 12.46).
pub fn attributes(vertex: &Interface, found: &mut LinkErrors) {
    let counts_all = vertex.program.version.has(Feature::UnreadAttributes);
    let all: Vec<&InterfaceVariable> = vertex
        .inputs
        .iter()
        .filter(|i| counts_all || i.is_active)
        .collect();
    let mut taken: [Option<&InterfaceVariable>; MAX_ATTRIBUTES] = [None; MAX_ATTRIBUTES];
    for item in &all {
        let Some(first) = item.location.and_then(|l| usize::try_from(l).ok()) else {
            continue;
        };
        let end = first.saturating_add(columns(item.ty) as usize);
        let name = vertex.text(item.name);
        if end > MAX_ATTRIBUTES {
            let message = format!("the attribute `{name}` goes past the last location, 15");
            let place = LinkSite::new(
                vertex,
                item.token,
                format!("it takes {} of them", columns(item.ty)),
            );
            found.at(error::LINK_ATTRIBUTE, message, place);
            continue;
        }
        for at in first..end {
            match taken.get_mut(at) {
                Some(Some(other)) => {
                    let message = format!(
                        "the attributes `{name}` and `{}` share location {at}",
                        vertex.text(other.name)
                    );
                    let second = LinkSite::new(vertex, other.token, "the other attribute");
                    let first = LinkSite::new(vertex, item.token, "");
                    found.differ(error::LINK_ATTRIBUTE, message, first, second);
                    break;
                }
                Some(slot) => *slot = Some(*item),
                None => {}
            }
        }
    }
    if found.diagnostics.is_empty() {
        places(vertex, &all, &taken, found);
    }
}

/// Gives those without a location the first free places, as the browser does.
fn places(
    vertex: &Interface,
    all: &[&InterfaceVariable],
    taken: &[Option<&InterfaceVariable>; MAX_ATTRIBUTES],
    found: &mut LinkErrors,
) {
    let mut taken = taken.map(|t| t.is_some());
    for item in all.iter().filter(|i| i.location.is_none()) {
        let width = columns(item.ty) as usize;
        let free = taken.windows(width).position(|w| w.iter().all(|t| !t));
        let Some(free) = free else {
            let message = format!(
                "there is no place for the attribute `{}`: WebGL has {MAX_ATTRIBUTES}",
                vertex.text(item.name)
            );
            let place = LinkSite::new(vertex, item.token, "");
            if let Some(d) = found.at(error::LINK_ATTRIBUTE, message, place) {
                d.notes.push(
                    "each attribute takes one place, a matrix one for each column".to_string(),
                );
                d.help
                    .push("put several values into one `vec4`".to_string());
            }
            return;
        };
        for slot in taken.iter_mut().skip(free).take(width) {
            *slot = true;
        }
    }
}

fn columns(ty: Type) -> u8 {
    match ty.base {
        Base::Numeric { columns, .. } => columns,
        _ => 1,
    }
}

/// What a uniform takes.
#[derive(Clone, Copy, Default)]
struct Need {
    vectors: u64,
    samplers: u64,
}

/// Counts what one stage needs.
pub fn counts(interface: &Interface, found: &mut LinkErrors) {
    let mut known = FxHashMap::default();
    let mut sum = Need::default();
    for item in interface.uniforms.iter().filter(|u| u.is_active) {
        let need = need(interface, item.ty, &mut known);
        sum.vectors = sum.vectors.saturating_add(need.vectors);
        sum.samplers = sum.samplers.saturating_add(need.samplers);
        let (count, limit, what) = if sum.vectors > MAX_UNIFORM_VECTORS {
            (sum.vectors, MAX_UNIFORM_VECTORS, "vectors of uniforms")
        } else if sum.samplers > MAX_SAMPLERS {
            (sum.samplers, MAX_SAMPLERS, "samplers")
        } else {
            continue;
        };
        too_many(interface, item.token, (count, limit, what), found);
        return;
    }
    let size = |b: &Block| b.instance.map_or(1, |(_, n)| n.max(1) as u64);
    let mut blocks = 0;
    for block in &interface.blocks {
        blocks += size(block);
        if blocks > MAX_BLOCKS {
            too_many(
                interface,
                block.token,
                (blocks, MAX_BLOCKS, "uniform blocks"),
                found,
            );
            return;
        }
    }
    if interface.program.stage == Stage::Fragment {
        varyings(interface, found);
    }
}

/// Counts vectors as if they were packed without a gap, which is the best that a browser can do.
fn varyings(fragment: &Interface, found: &mut LinkErrors) {
    let mut by_width = [0_u64; 5];
    for input in fragment.inputs.iter().filter(|i| i.is_used) {
        add_vectors(fragment, input.ty, &mut by_width);
        let [_, one, two, three, four] = by_width;
        let beside_three = one.saturating_sub(three);
        let pairs = two.div_ceil(2);
        let beside_pairs = beside_three.saturating_sub((pairs * 2 - two) * 2);
        let vectors = four + three + pairs + beside_pairs.div_ceil(4);
        if vectors > MAX_VARYING_VECTORS {
            let what = "vectors between the stages";
            return too_many(
                fragment,
                input.token,
                (vectors, MAX_VARYING_VECTORS, what),
                found,
            );
        }
    }
}

fn add_vectors(interface: &Interface, ty: Type, by_width: &mut [u64; 5]) {
    let count = ty.array.max(1) as u64;
    match ty.base {
        Base::Numeric { columns, rows, .. } => {
            if let Some(slot) = by_width.get_mut(rows as usize) {
                *slot = slot.saturating_add(count.saturating_mul(columns as u64));
            }
        }
        // Structs that are passed on hold no other structs.
        Base::Struct(id) => {
            let record = interface.program.structs.get(id as usize);
            for field in record.map_or(&[][..], |r| &r.fields) {
                if !matches!(field.ty.base, Base::Struct(_)) {
                    add_vectors(interface, field.ty, by_width);
                }
            }
        }
        _ => {}
    }
}

/// What a uniform of a type takes. Each struct is looked into once.
fn need(interface: &Interface, ty: Type, known: &mut FxHashMap<u16, Need>) -> Need {
    let one = match ty.base {
        Base::Numeric { columns, .. } => Need {
            vectors: columns as u64,
            samplers: 0,
        },
        Base::Sampler(_) => Need {
            vectors: 0,
            samplers: 1,
        },
        Base::Struct(id) => match known.get(&id) {
            Some(need) => *need,
            None => {
                let mut sum = Need::default();
                let record = interface.program.structs.get(id as usize);
                for field in record.map_or(&[][..], |r| &r.fields) {
                    let inner = need(interface, field.ty, known);
                    sum.vectors = sum.vectors.saturating_add(inner.vectors);
                    sum.samplers = sum.samplers.saturating_add(inner.samplers);
                }
                known.insert(id, sum);
                sum
            }
        },
        _ => Need::default(),
    };
    let count = ty.array.max(1) as u64;
    Need {
        vectors: one.vectors.saturating_mul(count),
        samplers: one.samplers.saturating_mul(count),
    }
}

fn too_many(
    interface: &Interface,
    token: u32,
    (count, limit, what): (u64, u64, &str),
    found: &mut LinkErrors,
) {
    let stage = match interface.program.stage {
        Stage::Vertex => "vertex",
        Stage::Fragment => "fragment",
    };
    let message = format!(
        "the {stage} shader needs {count} {what} up to here; no browser has more than {limit}"
    );
    let place = LinkSite::new(interface, token, "");
    if let Some(d) = found.at(error::BROWSER_LIMIT, message, place) {
        let d: &mut Diagnostic = d;
        d.notes
            .push("what both stages of a program may use is limited".to_string());
    }
}
