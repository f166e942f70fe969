//! The chunks that hosts insert for `#include <name>`.

use super::Preset;
use std::collections::{BTreeSet, HashMap};
use std::ops::RangeInclusive;
use std::sync::OnceLock;

/// What the chunks of a host declare, set and read, and its releases, by the value of its fact `chunks`.
const TABLES: [(&str, &str); 1] = [("three.js", include_str!("chunks/three.glsl"))];

/// A chunk.
#[derive(Debug)]
pub struct HostChunk {
    /// Declarations and calls that have the effects of the chunk; empty if the host has it no more.
    pub code: String,
    /// Names that other releases of the host declare there.
    pub once: Vec<&'static str>,
    /// The releases of the host that have it.
    pub releases: RangeInclusive<u32>,
    /// The chunk with the same text that the next release has instead.
    pub successor: Option<&'static str>,
    /// The last release that inserts the successor for the old name.
    pub accepted: u32,
}

/// The library that inserts the chunks of a host.
#[derive(Debug)]
pub struct ChunkLibrary {
    /// The name in prose.
    pub title: &'static str,
    /// The npm package, whose versions are `0.RELEASE.PATCH`.
    pub package: &'static str,
    /// What stands before the number of a release in addresses of its scripts.
    cited: Vec<&'static str>,
    /// The name that a program reads its release from.
    pub asked: &'static str,
    /// The object that programs add chunks to.
    pub registry: &'static str,
}

impl ChunkLibrary {
    /// The releases that the addresses in a page or script name.
    pub fn cited_in(&self, text: &str) -> BTreeSet<u32> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
        let release = |(at, before): (usize, &str)| {
            // Another package may have a name that ends like this one.
            let is_other = text.get(..at)?.ends_with(is_part);
            let rest = text.get(at + before.len()..)?;
            let end = rest.find(|c: char| !c.is_ascii_digit())?;
            rest.get(..end)?.parse().ok().filter(|_| !is_other)
        };
        let places = self.cited.iter().flat_map(|c| text.match_indices(*c));
        places.filter_map(release).collect()
    }

    /// The chunks that a script adds, as members of the registry; one that it does not name is `*`.
    pub fn added_in(&self, text: &str) -> Vec<String> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let added = |(at, _): (usize, &str)| {
            let is_call = text.get(..at)?.lines().next_back()?.contains("assign(");
            let (target, value) = text.get(at + self.registry.len()..)?.split_once('=')?;
            let is_set =
                !target.contains([';', ',', '(', '{', '}', '\n']) && !value.starts_with(['=', '>']);
            let name = target.trim_matches(|c| !is_part(c));
            let is_named = target.contains(['.', '"', '\'', '`']) && name.chars().all(is_part);
            let name = if is_named && is_set { name } else { "*" };
            (is_set || is_call).then(|| self.member(name))
        };
        let places = text.match_indices(self.registry);
        places.filter_map(added).collect()
    }

    /// How a chunk is written as a member of the registry.
    pub fn member(&self, chunk: &str) -> String {
        format!("{}.{chunk}", self.registry)
    }
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

/// The libraries whose chunks are known.
pub fn chunk_libraries() -> &'static [ChunkLibrary] {
    static LIBRARIES: OnceLock<Vec<ChunkLibrary>> = OnceLock::new();
    LIBRARIES.get_or_init(|| {
        let library = |(title, text): &(&'static str, &'static str)| {
            let head = text.split("//# ").next().unwrap_or("").lines();
            let facts: HashMap<_, _> = head.filter_map(|line| line.split_once(": ")).collect();
            let fact = |name: &str| facts.get(name).copied().unwrap_or("");
            ChunkLibrary {
                title,
                package: fact("// package"),
                cited: fact("// cited").split(' ').collect(),
                asked: fact("// asked"),
                registry: fact("// registry"),
            }
        };
        TABLES.iter().map(library).collect()
    })
}

impl Preset {
    /// The library whose chunks the host inserts.
    pub fn chunk_library(&self) -> Option<&'static ChunkLibrary> {
        let mut all = chunk_libraries().iter();
        all.find(|library| library.title == self.chunks)
    }

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

/// The chunk that has the text of this one in an earlier release.
pub fn predecessor(name: &str, release: u32) -> Option<&'static str> {
    let is_old = |c: &HostChunk| c.successor == Some(name) && c.releases.contains(&release);
    let mut all = chunks().iter();
    all.find_map(|(old, chunk)| is_old(chunk).then_some(*old))
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
        releases: 0..=u32::MAX,
        successor: None,
        accepted: 0,
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
            Some(("from", first)) => {
                chunk.releases = first.parse().unwrap_or(0)..=u32::MAX;
                continue;
            }
            Some(("until", facts)) => {
                let mut facts = facts.split(' ');
                let number = |fact: Option<&str>| fact.and_then(|f| f.parse().ok());
                let last = number(facts.next()).unwrap_or(u32::MAX);
                chunk.releases = *chunk.releases.start()..=last;
                chunk.successor = facts.next();
                chunk.accepted = number(facts.next()).unwrap_or(0);
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
