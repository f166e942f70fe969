//! Resource limits. Devices differ, so only what exceeds the limits of every WebGL implementation
//! is an error.

use super::errors::{LinkErrors, LinkSite};
use rustc_hash::FxHashMap;
use shaderlint_diagnostic::{Diagnostic, count, error};
use shaderlint_semantic::interface::{Block, Interface, InterfaceVariable};
use shaderlint_semantic::{Base, Stage, Type};
use shaderlint_syntax::Feature;

/// Number of attribute locations.
const MAX_ATTRIBUTES: usize = 16;
const MAX_UNIFORM_VECTORS: u64 = 4096;
/// Samplers per stage.
const MAX_SAMPLERS: u64 = 32;
/// Uniform blocks per stage, counting each array element.
const MAX_BLOCKS: u64 = 16;
/// Varying vectors between the stages.
const MAX_VARYING_VECTORS: u64 = 32;

/// Checks that every attribute has a location and that none overlap (GLSL ES 3.00 sections 4.3.8.1
/// and 12.46).
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
            let message = format!("attribute `{name}` exceeds the last location, 15");
            let label = format!("needs {}", count(columns(item.ty), "location"));
            let place = LinkSite::new(vertex, item.token, label);
            found.at(error::LINK_ATTRIBUTE, message, place);
            continue;
        }
        for at in first..end {
            match taken.get_mut(at) {
                Some(Some(other)) => {
                    let message = format!(
                        "attributes `{name}` and `{}` both use location {at}",
                        vertex.text(other.name)
                    );
                    let second = LinkSite::new(vertex, other.token, "also at this location");
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

/// Assigns the first free locations to attributes without one, as the browser does.
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
                "no location left for attribute `{}`; WebGL has {MAX_ATTRIBUTES}",
                vertex.text(item.name)
            );
            let place = LinkSite::new(vertex, item.token, "");
            if let Some(d) = found.at(error::LINK_ATTRIBUTE, message, place) {
                d.notes
                    .push("each attribute uses one location, a matrix one per column".to_string());
                d.help
                    .push("pack several values into one `vec4`".to_string());
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

/// Resources used by a uniform.
#[derive(Clone, Copy, Default)]
struct Need {
    vectors: u64,
    samplers: u64,
}

/// Counts the resources that a stage uses.
pub fn counts(interface: &Interface, found: &mut LinkErrors) {
    let mut known = FxHashMap::default();
    let mut sum = Need::default();
    for item in interface.uniforms.iter().filter(|u| u.is_active) {
        let need = need(interface, item.ty, &mut known);
        sum.vectors = sum.vectors.saturating_add(need.vectors);
        sum.samplers = sum.samplers.saturating_add(need.samplers);
        let (count, limit, what) = if sum.vectors > MAX_UNIFORM_VECTORS {
            (sum.vectors, MAX_UNIFORM_VECTORS, "uniform vectors")
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

/// Counts vectors as if packed without gaps, which is the best that a browser can do.
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
            let what = "varying vectors";
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
        // Varying structs contain no nested structs.
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

/// Resources used by a uniform of a type; cached per struct.
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
    let message = format!("{stage} shader needs {count} {what}; the limit is {limit}");
    let place = LinkSite::new(interface, token, "");
    if let Some(d) = found.at(error::BROWSER_LIMIT, message, place) {
        let d: &mut Diagnostic = d;
        d.notes.push(format!(
            "counted up to this declaration; no browser has more than {limit}"
        ));
    }
}
