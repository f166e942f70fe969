//! Projects with one file per pass, identified by file name.

use crate::dialect::framed;
use crate::{
    GatheredText, Info, Input, InputKind, OutputId, Project, ProjectPass, SamplerSettings,
    ShaderError,
};
use shaderlint_semantic::Pass;

/// The pass that a file is for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PassRole {
    /// The image.
    Image,
    /// Code shared by all passes.
    Common,
    /// A buffer, from 0 for A to 3 for D.
    Buffer(u8),
    /// The cube map.
    Cubemap,
    /// The sound.
    Sound,
}

impl PassRole {
    /// The role that the last words of a name indicate: `image`, `buffer_a`, `myBufB`, `x.common`.
    pub fn of_name(name: &str) -> Option<PassRole> {
        let words = words(name);
        let last = words.last()?.as_str();
        let before = words.len().checked_sub(2).and_then(|i| words.get(i));
        let is_buffer = |word: &str| matches!(word, "buffer" | "buf");
        let letter = |word: &str| match word {
            "a" | "0" => Some(0),
            "b" | "1" => Some(1),
            "c" | "2" => Some(2),
            "d" | "3" => Some(3),
            _ => None,
        };
        if before.is_some_and(|word| is_buffer(word)) {
            return letter(last).map(PassRole::Buffer);
        }
        if before.is_some_and(|word| word == "cube") && last == "a" {
            return Some(PassRole::Cubemap);
        }
        match last {
            "image" => Some(PassRole::Image),
            "common" => Some(PassRole::Common),
            "cubemap" | "cube" | "cubea" => Some(PassRole::Cubemap),
            "sound" => Some(PassRole::Sound),
            _ => {
                let rest = last.strip_prefix("buffer").or(last.strip_prefix("buf"))?;
                letter(rest).map(PassRole::Buffer)
            }
        }
    }

    /// The name in options and file names.
    pub const fn name(self) -> &'static str {
        match self {
            PassRole::Image => "image",
            PassRole::Common => "common",
            PassRole::Buffer(0) => "buffer_a",
            PassRole::Buffer(1) => "buffer_b",
            PassRole::Buffer(2) => "buffer_c",
            PassRole::Buffer(_) => "buffer_d",
            PassRole::Cubemap => "cubemap",
            PassRole::Sound => "sound",
        }
    }

    /// The kind of pass.
    pub const fn kind(self) -> Pass {
        match self {
            PassRole::Image => Pass::Image,
            PassRole::Common => Pass::Common,
            PassRole::Buffer(_) => Pass::Buffer,
            PassRole::Cubemap => Pass::Cubemap,
            PassRole::Sound => Pass::Sound,
        }
    }

    /// The id of its output; `None` for Common.
    pub fn output(self) -> Option<OutputId> {
        match self {
            PassRole::Image => Some(OutputId(OutputId::IMAGE.to_string())),
            PassRole::Buffer(number) => OutputId::buffer(number as usize),
            PassRole::Cubemap => Some(OutputId(OutputId::CUBE.to_string())),
            PassRole::Sound => Some(OutputId(OutputId::SOUND.to_string())),
            PassRole::Common => None,
        }
    }
}

impl PassRole {
    /// All roles.
    pub const ALL: [PassRole; 8] = [
        PassRole::Image,
        PassRole::Buffer(0),
        PassRole::Buffer(1),
        PassRole::Buffer(2),
        PassRole::Buffer(3),
        PassRole::Cubemap,
        PassRole::Sound,
        PassRole::Common,
    ];
}

/// The roles of the programs of a screen saver of XScreenSaver, by file name without extension:
/// `NAME-0` to `NAME-4`, of which the last draws the image, and `NAME-c` for common code. `None` if
/// the names have another form, or if only one of them is a program.
pub fn saver_roles(names: &[&str]) -> Option<Vec<PassRole>> {
    let split = |name: &&str| {
        let (saver, part) = name.rsplit_once('-')?;
        let number = match part {
            "c" => None,
            "0" | "1" | "2" | "3" | "4" => Some(part.parse::<u8>().ok()?),
            _ => return None,
        };
        Some((saver.to_string(), number))
    };
    let all: Vec<(String, Option<u8>)> = names.iter().map(split).collect::<Option<_>>()?;
    let saver = all.first().map(|(saver, _)| saver)?;
    let mut numbers: Vec<u8> = all.iter().filter_map(|(_, number)| *number).collect();
    numbers.sort_unstable();
    let last = *numbers.last()?;
    let is_complete = (0..=last).eq(numbers.iter().copied());
    if !is_complete || names.len() < 2 || all.iter().any(|(own, _)| own != saver) {
        return None;
    }
    let role = |number: Option<u8>| match number {
        None => PassRole::Common,
        Some(number) if number == last => PassRole::Image,
        Some(number) => PassRole::Buffer(number),
    };
    Some(all.iter().map(|(_, number)| role(*number)).collect())
}

/// The error for an unknown pass name.
pub fn unknown_pass(name: &str) -> String {
    match near(name, PassRole::ALL.map(PassRole::name)) {
        Some(near) => format!("unknown pass `{name}`; did you mean `{near}`?"),
        None => format!(
            "unknown pass `{name}`; expected `image`, `buffer_a` to `buffer_d`, `cubemap`, \
             `sound` or `common`"
        ),
    }
}

/// The most similar word, if it is similar enough.
pub(crate) fn near<'a>(name: &str, words: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_lowercase();
    let all = words.into_iter();
    let all = all.map(|word| (strsim::damerau_levenshtein(word, &name), word));
    let (distance, word) = all.min()?;
    (distance <= 1 + name.chars().count() / 4).then_some(word)
}

/// Splits a name into lower-case words, at punctuation and where a capital follows a lower-case
/// letter.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_small = false;
    for c in name.chars() {
        if !c.is_alphanumeric() || (c.is_uppercase() && was_small) {
            words.push(String::new());
        }
        was_small = c.is_lowercase();
        if let (true, Some(word)) = (c.is_alphanumeric(), words.last_mut()) {
            word.extend(c.to_lowercase());
        }
    }
    words.retain(|w| !w.is_empty());
    words
}

/// A file and its role.
#[derive(Clone, Debug)]
pub struct PassFile {
    /// The pass that it is for.
    pub role: PassRole,
    /// The path given by the user.
    pub file: String,
    /// The content, with what it includes.
    pub text: GatheredText,
}

/// Why files do not form a project.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum PartsError {
    /// Two files have the same role.
    Twice(PassRole, String, String),
    /// No file has the role Image.
    NoImage,
    /// A file cannot be used as a pass.
    Shader(String, ShaderError),
}

impl std::fmt::Display for PartsError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            PartsError::Twice(role, a, b) => {
                write!(f, "{a} and {b} both define the pass `{}`", role.name())
            }
            PartsError::NoImage => f.write_str(
                "no file defines the pass `image`; name one `image.glsl`, or use `--pass image=FILE`",
            ),
            PartsError::Shader(file, error) => write!(f, "{file}: {error}"),
        }
    }
}

impl Project {
    /// A project of several files with unknown channels; [`Project::resolve`] determines these.
    ///
    /// # Errors
    /// If the files do not form a project.
    pub fn from_parts(title: &str, mut parts: Vec<PassFile>) -> Result<Project, PartsError> {
        parts.sort_by_key(|p| p.role);
        for pair in parts.windows(2) {
            if let [a, b] = pair
                && a.role == b.role
            {
                return Err(PartsError::Twice(a.role, a.file.clone(), b.file.clone()));
            }
        }
        if parts.iter().all(|p| p.role != PassRole::Image) {
            return Err(PartsError::NoImage);
        }
        let commons = parts.iter().filter(|part| part.role == PassRole::Common);
        let common: String = commons.map(|part| &*part.text.text).collect();
        let passes = parts.into_iter().map(|part| {
            let kind = part.role.kind();
            let may_be_framed = matches!(kind, Pass::Image | Pass::Buffer);
            let framed = framed(&part.text.text, &common).filter(|_| may_be_framed);
            ProjectPass {
                name: part.role.name().to_string(),
                output: part.role.output(),
                file: Some(part.file),
                pieces: part.text.pieces,
                ..match framed {
                    Some(framed) => ProjectPass::completed(kind, framed),
                    None => ProjectPass::new(kind, part.text.text),
                }
            }
        });
        let info = Info {
            name: title.to_string(),
            ..Info::default()
        };
        Ok(Project {
            info,
            passes: passes.collect(),
            ..Project::default()
        })
    }
}

impl Project {
    /// Connects the programs of a screen saver of XScreenSaver: channel N of each is the output of
    /// program N, without filtering.
    pub fn link_programs(&mut self) {
        let outputs = self.passes.iter().filter_map(|p| p.output.clone());
        let outputs: Vec<_> = outputs
            .filter_map(|output| Some((output.number()?, output)))
            .collect();
        for pass in self.passes.iter_mut().filter(|p| p.kind != Pass::Common) {
            pass.inputs = outputs
                .iter()
                .map(|(number, output)| Input {
                    id: output.0.clone(),
                    sampler: SamplerSettings {
                        filter: "nearest".to_string(),
                        wrap: "clamp".to_string(),
                        ..SamplerSettings::usual(InputKind::Buffer)
                    },
                    ..Input::empty(*number as u8, InputKind::Buffer)
                })
                .collect();
        }
        let note =
            "read as XScreenSaver: `iChannel0` to `iChannel3` are the outputs of programs 0 to 3";
        self.notes.push(note.to_string());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::each_case;

    #[test]
    fn numbered_programs_of_screen_savers_are_passes() {
        let roles = |names: &[&str]| {
            let roles = saver_roles(names)?;
            Some(roles.into_iter().map(PassRole::name).collect::<Vec<_>>())
        };
        let three = ["sea-0", "sea-1", "sea-2", "sea-c"];
        let expected = ["buffer_a", "buffer_b", "image", "common"];
        assert_eq!(roles(&three), Some(expected.to_vec()));
        let reversed = roles(&["sea3-1", "sea3-0"]);
        assert_eq!(reversed, Some(vec!["image", "buffer_a"]));
        assert_eq!(roles(&["sea-0", "sea-c"]), Some(vec!["image", "common"]));
        for other in [
            &["sea-0"][..],
            &["sea-c"],
            &["sea-0", "sea-2"],
            &["sea-0", "lake-1"],
            &["sea-0", "sea-1", "sea-1"],
            &["sea-0", "sea-5"],
            &["sea-0", "sea-d"],
            &["sea0", "sea1"],
        ] {
            assert_eq!(roles(other), None, "{other:?}");
        }
    }

    #[test]
    fn file_names_identify_passes() {
        each_case(include_str!("file_names.txt"), |name, expected| {
            let role = PassRole::of_name(name).map_or("none", PassRole::name);
            assert_eq!(role, expected, "{name}");
        });
    }

    #[test]
    fn files_of_passes_form_a_project() {
        let part = |role, file: &str, code: &str| PassFile {
            role,
            file: file.to_string(),
            text: GatheredText::of(code),
        };
        let image = "void mainImage(out vec4 c, in vec2 f) { c = texture(iChannel0, D); }";
        let parts = vec![
            part(PassRole::Image, "image.glsl", image),
            part(PassRole::Common, "common.glsl", "#define D vec3(1.0)\n"),
        ];
        let mut project = Project::from_parts("x", parts.clone()).unwrap();
        project.resolve("x").unwrap();
        let kinds: Vec<_> = project.passes.iter().map(|p| p.kind).collect();
        assert_eq!(kinds, [Pass::Image, Pass::Common]);
        let kind = project.passes[0].inputs[0].kind;
        assert_eq!(kind, crate::InputKind::Cubemap, "what `vec3` needs");
        let twice = vec![parts[0].clone(), parts[0].clone()];
        assert!(matches!(
            Project::from_parts("x", twice),
            Err(PartsError::Twice(..))
        ));
        let none = Project::from_parts("x", vec![parts[1].clone()]);
        assert_eq!(none, Err(PartsError::NoImage));
    }
}
