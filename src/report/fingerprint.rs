//! Identifies findings independently of the lines above them.

use sha2::{Digest, Sha256};
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Sources;
use std::collections::HashMap;

/// Computes a fingerprint for each finding of one input, from its pass, its rule, its line without
/// white space, and the number of equal findings before it.
pub fn fingerprints(sources: &Sources, found: &[Diagnostic]) -> Vec<String> {
    let mut seen: HashMap<[u8; 32], u32> = HashMap::new();
    // A long line with many findings is hashed once for each rule.
    let mut hashed: HashMap<(u32, &str), Sha256> = HashMap::new();
    found
        .iter()
        .map(|diagnostic| {
            let line = line_of(sources, diagnostic.span.start);
            let hash = hashed.entry((line.start, diagnostic.rule));
            let mut hash = hash.or_insert_with(|| line.hash(diagnostic.rule)).clone();
            let like: [u8; 32] = hash.clone().finalize().into();
            let count = seen.entry(like).or_default();
            hash.update(count.to_le_bytes());
            *count += 1;
            hex(&hash.finalize())
        })
        .collect()
}

/// A line of a source file.
#[derive(Default)]
struct SourceLine<'s> {
    /// Address of its first character.
    start: u32,
    /// The pass that the file is.
    part: &'s str,
    text: &'s str,
}

impl SourceLine<'_> {
    /// The hash of a rule's findings in this line, before they are numbered.
    fn hash(&self, rule: &str) -> Sha256 {
        let mut hash = Sha256::new();
        let words = self.text.split_whitespace();
        for text in [self.part, rule].into_iter().chain(words) {
            add(&mut hash, text);
        }
        hash
    }
}

fn line_of(sources: &Sources, address: u32) -> SourceLine<'_> {
    let Some(file) = sources.file_at(address) else {
        return SourceLine::default();
    };
    let lines = file.lines();
    let number = lines.line(address - file.base);
    let start = lines.start(number).unwrap_or(0);
    let end = lines.start(number + 1);
    let end = end.map_or(file.text.len(), |end| end as usize);
    SourceLine {
        start: file.base + start,
        part: file.part.as_deref().unwrap_or(""),
        text: file.text.get(start as usize..end).unwrap_or(""),
    }
}

fn add(hash: &mut Sha256, text: &str) {
    hash.update(text.as_bytes());
    hash.update([0]);
}

/// Hashes several texts into one fingerprint.
pub fn digest<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hash = Sha256::new();
    texts.into_iter().for_each(|text| add(&mut hash, text));
    hex(&hash.finalize())
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().take(16).map(|b| format!("{b:02x}")).collect()
}
