//! The stages that names of shader files show.

use shaderlint_semantic::Stage;

/// The parts of file names that denote the stages.
const WORDS: [(&str, &str); 8] = [
    ("vert", "frag"),
    ("vertex", "fragment"),
    ("vs", "fs"),
    ("vsh", "fsh"),
    ("Vert", "Frag"),
    ("Vertex", "Fragment"),
    ("VS", "FS"),
    ("VERT", "FRAG"),
];

/// The file name of the other stage, and the stage of this file.
pub fn counterpart(name: &str) -> Option<(String, Stage)> {
    let StageName {
        before,
        other,
        after,
        stage,
    } = StageName::of(name)?;
    Some((format!("{before}{other}{after}"), stage))
}

/// The name that the files of both stages of a program share.
pub fn program_name(name: &str) -> String {
    let stem = || name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    match StageName::of(name) {
        Some(of) if !of.after.is_empty() => format!("{}{}", of.before, of.after),
        _ => stem().to_string(),
    }
}

/// A file name with a word for its stage.
pub struct StageName<'n> {
    before: &'n str,
    /// The word for the other stage.
    other: &'static str,
    after: &'static str,
    /// The stage of this file.
    pub stage: Stage,
}

impl<'n> StageName<'n> {
    /// Reads the path of a file.
    pub fn of(name: &'n str) -> Option<StageName<'n>> {
        let (folder, file) = match name.rfind('/') {
            Some(slash) => name.split_at(slash + 1),
            None => ("", name),
        };
        let (stem, extension) = match file.strip_suffix(".glsl") {
            Some(stem) => (stem, ".glsl"),
            None => (file, ""),
        };
        // Without `.glsl`, the word is the extension itself.
        let is_apart = |c: char, word: &str| match extension {
            "" => c == '.',
            _ => {
                let is_capital = word.starts_with(|w: char| w.is_ascii_uppercase());
                !c.is_ascii_alphanumeric() || (is_capital && !c.is_ascii_uppercase())
            }
        };
        let pairs = WORDS.iter().flat_map(|(v, f)| {
            let vertex = (*v, *f, Stage::Vertex);
            [vertex, (*f, *v, Stage::Fragment)]
        });
        for (own, other, stage) in pairs {
            if let Some(rest) = stem.strip_suffix(own) {
                let before = rest.chars().next_back();
                if before.map_or(!extension.is_empty(), |c| is_apart(c, own)) {
                    let before = name.get(..folder.len() + rest.len())?;
                    return Some(StageName {
                        before,
                        other,
                        after: extension,
                        stage,
                    });
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(name: &str, expected: &str) {
        let other = counterpart(name).map(|(other, _)| other);
        assert_eq!(other.as_deref().unwrap_or(""), expected, "{name}");
    }

    #[test]
    fn vertex_and_fragment_files_are_paired_by_name() {
        check("a/b.vert", "a/b.frag");
        check("b.fs", "b.vs");
        check("b.vert.glsl", "b.frag.glsl");
        check("water_fragment.glsl", "water_vertex.glsl");
        check("waterFrag.glsl", "waterVert.glsl");
        check("shaders/vertex.glsl", "shaders/fragment.glsl");
        check("convert.glsl", "");
        check("avert", "");
        check("vert", "");
        check("defrag.glsl", "");
        check("a.glsl", "");
    }
}
