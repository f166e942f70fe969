//! Identifies findings independently of the lines above them.

use sha2::{Digest, Sha256};
use shaderlint_diagnostic::Diagnostic;
use shaderlint_text::Sources;
use std::collections::HashMap;

/// Computes a fingerprint for each finding of one input, from its pass, its rule, its line without
/// white space, and the number of equal findings before it.
pub fn fingerprints(sources: &Sources, found: &[Diagnostic]) -> Vec<String> {
    let mut seen: HashMap<[u8; 32], u32> = HashMap::new();
    found
        .iter()
        .map(|diagnostic| {
            let mut hash = Sha256::new();
            let file = sources.file_at(diagnostic.span.start);
            let mut add = |text: &str| {
                hash.update(text.as_bytes());
                hash.update([0]);
            };
            add(file.and_then(|f| f.part.as_deref()).unwrap_or(""));
            add(diagnostic.rule);
            let line = file.map_or("", |f| {
                let number = f.lines().line(diagnostic.span.start - f.base);
                let start = f.lines().start(number).unwrap_or(0) as usize;
                let end = f
                    .lines()
                    .start(number + 1)
                    .map_or(f.text.len(), |e| e as usize);
                f.text.get(start..end).unwrap_or("")
            });
            line.split_whitespace().for_each(add);
            let like: [u8; 32] = hash.clone().finalize().into();
            let count = seen.entry(like).or_default();
            hash.update(count.to_le_bytes());
            *count += 1;
            hex(&hash.finalize())
        })
        .collect()
}

/// Hashes several texts into one fingerprint.
pub fn digest<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hash = Sha256::new();
    for text in texts {
        hash.update(text.as_bytes());
        hash.update([0]);
    }
    hex(&hash.finalize())
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().take(16).map(|b| format!("{b:02x}")).collect()
}
