//! The chunks that hosts insert for `#include <name>`.

use super::Preset;
use std::collections::HashMap;
use std::sync::OnceLock;

/// What the chunks of a host declare, set and read, by the value of its fact `chunks`.
const TABLES: [(&str, &str); 1] = [("three.js", include_str!("chunks/three.glsl"))];

/// A chunk.
#[derive(Debug)]
pub struct HostChunk {
    /// Declarations and calls that have the effects of the chunk; empty if the host has it no more.
    pub code: String,
    /// Names that other releases of the host declare there.
    pub once: Vec<&'static str>,
}

/// By name: the chunks of a host.
fn chunks() -> &'static HashMap<&'static str, HostChunk> {
    static CHUNKS: OnceLock<HashMap<&'static str, HostChunk>> = OnceLock::new();
    CHUNKS.get_or_init(|| {
        let all = TABLES
            .iter()
            .flat_map(|(_, text)| text.split("//# ").skip(1));
        let all = all.filter_map(|part| part.split_once('\n'));
        all.map(|(name, lines)| (name, read(lines))).collect()
    })
}

impl Preset {
    /// The chunk that the host inserts for a name.
    pub fn chunk(&self, name: &str) -> Option<&'static HostChunk> {
        let has_chunks = TABLES.iter().any(|(of, _)| *of == self.chunks);
        chunks().get(name).filter(|_| has_chunks)
    }
}

/// Whether a host inserts a chunk of this name.
pub fn is_chunk(name: &str) -> bool {
    chunks().contains_key(name)
}

/// The names of all chunks.
pub fn chunk_names() -> impl Iterator<Item = &'static str> {
    chunks().keys().copied()
}

/// Whether only other releases of a host declare a name, in any chunk.
pub fn was_in_chunk(name: &str) -> bool {
    chunks().values().any(|chunk| chunk.once.contains(&name))
}

/// The types of variables that chunks set and read.
const TYPES: [&str; 9] = [
    "float", "int", "bool", "vec2", "vec3", "vec4", "mat2", "mat3", "mat4",
];

/// The functions that the code of chunks calls.
pub fn chunk_prelude() -> String {
    let sets = TYPES
        .iter()
        .map(|ty| format!("void chunk_sets(inout {ty} of);\n"));
    let samplers = ["sampler2D", "samplerCube"];
    let reads = TYPES.iter().chain(&samplers);
    let reads = reads.map(|ty| format!("void chunk_reads({ty} of);\n"));
    sets.chain(reads).collect()
}

/// Reads the lines of a chunk.
fn read(lines: &'static str) -> HostChunk {
    let mut chunk = HostChunk {
        code: String::new(),
        once: Vec::new(),
    };
    let is_inside = lines
        .lines()
        .any(|l| l.starts_with("sets ") || l.starts_with("reads "));
    for line in lines.lines() {
        let calls = |function: &str, names: &str| {
            let names = names.split(' ');
            names
                .map(|name| format!("chunk_{function}({name}); "))
                .collect::<String>()
        };
        let code = match line.split_once(' ') {
            Some(("once", names)) => {
                chunk.once.extend(names.split(' '));
                continue;
            }
            Some((function @ ("sets" | "reads"), names)) => calls(function, names),
            Some((ty, name)) if is_inside && TYPES.contains(&ty) => {
                line.to_string() + " " + &calls("sets", name.trim_end_matches(';'))
            }
            _ => line.to_string(),
        };
        chunk.code.push_str(&code);
        chunk.code.push('\n');
    }
    chunk
}
