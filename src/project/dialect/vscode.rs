//! VS Code Shader Toy: ShaderToy's names, and directives that define the inputs of channels.
//!
//! Source: README.md, `src/bufferprovider.ts`, `src/glsl_extension_grammar.txt`,
//! `src/extensions/preamble_extension.ts` and `keyboard/keyboard_shader_extension.ts` of
//! stevensona/shader-toy. The host declares ten channels and compiles for WebGL2 with the functions
//! of both versions; a `main` is added to a text that has only `mainImage`. The input of a channel
//! is another shader, `self` or a file; images are linear and repeated unless `::MagFilter`,
//! `::MinFilter` and `::WrapMode` set otherwise, and buffers have float components.

use super::complete::{self, Directive, modern};
use super::isf::is_identifier;
use super::{Clues, Completion, HostCode, Plan, PlannedPass, Sign, read_buffer, sampled};
use crate::{
    ControlKind, GatheredText, Input, InputKind, OutputId, PassDraw, UniformControl, kind_of_name,
};
use shaderlint_host::{OWN, matches_any, preset, shadertoy};
use shaderlint_semantic::Pass;
use shaderlint_text::TextPiece;
use shaderlint_text::path::slashed;
use std::sync::Arc;

/// The name of its preset.
const HOST: &str = "vscode-shader-toy";

pub(super) static CODE: HostCode = HostCode {
    host: HOST,
    signs,
    plan: Some(plan),
    declare: Some(declare),
};

fn signs(clues: &Clues) -> Vec<Sign> {
    let mut found: Vec<Sign> = Vec::new();
    // ShaderToy calls no `main`; other hosts that do declare no names of ShaderToy.
    if clues.guess.has_main && !clues.has_word("mainImage") {
        let player = shadertoy().map_or(&[][..], |host| &host.words);
        let is_old = |word: &str| preset(HOST).is_some_and(|host| host.defines(word));
        let free = clues.free_words(|word| player.iter().any(|own| own == word) || is_old(word));
        if let Some(word) = free.first() {
            found.push(Sign::new(format!("`main` and `{word}` undeclared"), OWN));
        }
    }
    let first = directives(clues.text).into_iter().next();
    found.extend(first.map(|directive| Sign::form(format!("`#{}`", directive.word), 3 * OWN)));
    found
}

/// Whether a text may contain directives of the host; a match may also be in a comment.
pub(super) fn may_have_directives(text: &str) -> bool {
    complete::may_have_directives(text, is_ours)
}

/// Whether a text contains directives of the host.
pub(super) fn has_directives(text: &str) -> bool {
    !directives(text).is_empty()
}

/// The lines of a text with directives of the host.
fn directives(text: &str) -> Vec<Directive<'_>> {
    complete::directives(text, is_ours)
}

/// Whether a directive with this name is one of the host.
fn is_ours(word: &str) -> bool {
    let own = preset(HOST).map_or(&[][..], |p| &p.directives);
    match word.starts_with("iChannel") {
        true => channel_of(word).is_some(),
        false => matches_any(own, word),
    }
}

fn channel_of(word: &str) -> Option<u8> {
    let number = word.strip_prefix("iChannel")?;
    number.parse().ok().filter(|n| *n < 10)
}

/// The settings in the directives of a shader and its includes.
#[derive(Default)]
struct DirectiveFacts {
    channels: Vec<ChannelComment>,
    /// The declarations of the uniforms that it defines.
    declared: String,
    controls: Vec<UniformControl>,
    has_keyboard: bool,
    is_strict: bool,
}

/// The settings of a channel.
#[derive(Clone, Default)]
struct ChannelComment {
    number: u8,
    source: String,
    filter: Option<&'static str>,
    wrap: Option<&'static str>,
    is_cube: bool,
}

/// Builds the plan of a shader and of those that it reads.
struct VscodeReader<'c, 't> {
    clues: &'c Clues<'t>,
    plan: Plan,
    /// The files of the shaders that are already passes or are becoming passes.
    seen: Vec<String>,
}

fn plan(clues: &Clues) -> Plan {
    let mut maker = VscodeReader {
        clues,
        plan: Plan::default(),
        seen: Vec::new(),
    };
    maker.shader("", clues.text, Vec::new());
    let plan = &mut maker.plan;
    let is_read = |name: &str| {
        let id = OutputId::of_dialect(name).0;
        let mut inputs = plan.passes.iter().flat_map(|p| &p.inputs);
        inputs.any(|i| i.id == id)
    };
    // If a pass reads the previous frame of the Image, that becomes a buffer and is copied.
    match (is_read(""), plan.passes.last_mut()) {
        (true, _) => {
            plan.passes.push(PlannedPass::copy_of(""));
            plan.draws.push(PassDraw::default());
        }
        (false, Some(last)) => {
            last.kind = Pass::Image;
            last.name = String::new();
            last.output = OutputId(OutputId::IMAGE.to_string());
        }
        _ => {}
    }
    maker.plan
}

impl VscodeReader<'_, '_> {
    /// Adds the shader of a file, after those that it reads.
    fn shader(&mut self, path: &str, text: &str, pieces: Vec<TextPiece>) {
        self.seen.push(path.to_string());
        let mut facts = DirectiveFacts::default();
        let code = &self.without_directives(text, &mut facts);
        let inputs = facts.channels.iter().filter_map(|c| self.input(path, c));
        let inputs: Vec<Input> = inputs.collect();
        let mut pass = PlannedPass::buffer(path, vec![completion(code, &facts)]);
        pass.is_of_text = path.is_empty();
        pass.pieces = pieces;
        pass.inputs = inputs;
        if facts.has_keyboard {
            let keys = sampled("iKeyboard", InputKind::Keyboard, ("nearest", "clamp"));
            pass.inputs.push(keys);
        }
        self.plan.passes.push(pass);
        self.plan.draws.push(PassDraw {
            is_float: true,
            ..PassDraw::default()
        });
        for control in facts.controls {
            if !self.plan.controls.iter().any(|c| c.name == control.name) {
                self.plan.controls.push(control);
            }
        }
    }

    /// A text with its directives as comments.
    fn without_directives(&mut self, text: &str, facts: &mut DirectiveFacts) -> String {
        let mut code = String::with_capacity(text.len());
        let mut from = 0;
        for directive in directives(text) {
            code.push_str(text.get(from..directive.start).unwrap_or(""));
            code.push_str("//");
            from = directive.start;
            self.obey(&directive, facts);
        }
        code.push_str(text.get(from..).unwrap_or(""));
        code
    }

    /// Path and content of a companion file. A file that has not been read yet is requested.
    fn load(&mut self, path: &str, name: &str) -> Option<(String, Arc<GatheredText>)> {
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        let mut candidates = vec![joined(folder, name)];
        if !folder.is_empty() {
            candidates.push(joined("", name));
        }
        for file in candidates {
            match self.clues.siblings.get(&file) {
                Some(Some(text)) => return Some((file, text.clone())),
                Some(None) => {}
                None => {
                    self.plan.requested.push(file);
                    return None;
                }
            }
        }
        self.note(format!("`{name}` was not found"));
        None
    }

    fn note(&mut self, note: String) {
        if !self.plan.notes.contains(&note) {
            self.plan.notes.push(note);
        }
    }

    fn obey(&mut self, directive: &Directive, facts: &mut DirectiveFacts) {
        match directive.word {
            "iUniform" => match uniform(directive.rest) {
                Some((line, control)) => {
                    facts.declared.push_str(&line);
                    facts.controls.push(control);
                }
                None => self.note(format!("cannot parse `#iUniform{}`", directive.rest)),
            },
            "iKeyboard" => facts.has_keyboard = true,
            "StrictCompatibility" => facts.is_strict = true,
            "iFirstPersonControls" => {
                self.note(
                    "`#iFirstPersonControls` has no effect: `iViewMatrix` does not change"
                        .to_string(),
                );
            }
            "iVertex" => {
                self.note("`#iVertex` has no effect: the shader covers the full image".to_string())
            }
            word => {
                if let Some(number) = channel_of(word) {
                    facts.set(number, directive.rest);
                }
            }
        }
    }

    /// The input of a channel.
    fn input(&mut self, path: &str, channel: &ChannelComment) -> Option<Input> {
        let uniform = format!("iChannel{}", channel.number);
        let source = channel.source.as_str();
        let is_remote = source.starts_with("http://") || source.starts_with("https://");
        let file = source.split_once("://").map_or(source, |(_, file)| file);
        let media = kind_of_name(file).and_then(|ty| ty.split('/').next());
        let usual = match media {
            _ if channel.is_cube => Some(InputKind::Cubemap),
            Some("image") => Some(InputKind::Texture),
            Some("video") => Some(InputKind::Video),
            Some("audio") => Some(InputKind::Music),
            Some(_) => Some(InputKind::Volume),
            None if is_remote => Some(InputKind::Texture),
            None => None,
        };
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        let mut input = match usual {
            Some(kind) => Input {
                src: match is_remote {
                    true => source.to_string(),
                    false => joined(folder, file),
                },
                ..sampled(&uniform, kind, ("linear", "repeat"))
            },
            None => read_buffer(&uniform, &self.buffer(path, file)?),
        };
        if let Some(filter) = channel.filter {
            input.sampler.filter = filter.to_string();
        }
        if let Some(wrap) = channel.wrap {
            input.sampler.wrap = wrap.to_string();
        }
        Some(input)
    }

    /// The buffer for a name in a text; its shader becomes a pass.
    fn buffer(&mut self, path: &str, name: &str) -> Option<String> {
        if name == "self" {
            return Some(path.to_string());
        }
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        let direct = joined(folder, name);
        let is_root = |file: &str| {
            let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
            !self.clues.name.is_empty() && stem == self.clues.name
        };
        if is_root(&direct) {
            return Some(String::new());
        }
        let (file, text) = self.load(path, name)?;
        if !self.seen.contains(&file) {
            self.shader(&file, &text.text, text.pieces.clone());
        }
        Some(file)
    }
}

impl DirectiveFacts {
    /// Applies a setting of a channel.
    fn set(&mut self, number: u8, rest: &str) {
        if !self.channels.iter().any(|c| c.number == number) {
            self.channels.push(ChannelComment {
                number,
                ..ChannelComment::default()
            });
        }
        let mut all = self.channels.iter_mut();
        if let Some(channel) = all.find(|c| c.number == number) {
            channel.set(rest);
        }
    }
}

impl ChannelComment {
    /// Applies the text after the number: a source, or `::` and a setting. Old versions of the
    /// extension had no quotes.
    fn set(&mut self, rest: &str) {
        let plain = rest.split(" //").next().unwrap_or("").trim();
        let Some(setting) = plain.strip_prefix("::") else {
            self.source = slashed(quoted(rest).unwrap_or(plain));
            return;
        };
        let value = quoted(rest)
            .or(setting.split_whitespace().nth(1))
            .unwrap_or("");
        let filter = match value {
            v if v.contains("MipMap") => "mipmap",
            v if v.starts_with("Nearest") => "nearest",
            _ => "linear",
        };
        if setting.starts_with("MinFilter") {
            self.filter = Some(filter);
        } else if setting.starts_with("MagFilter") {
            // There is only one filter: that for minification, if it uses mipmaps.
            self.filter = self.filter.filter(|f| *f == "mipmap").or(Some(filter));
        } else if setting.starts_with("WrapMode") {
            self.wrap = Some(if value == "Clamp" { "clamp" } else { "repeat" });
        } else if setting.starts_with("Type") {
            self.is_cube = value == "CubeMap";
        }
    }
}

/// The quoted part of a text.
pub(super) fn quoted(text: &str) -> Option<&str> {
    let at = text.find(['"', '\''])?;
    let quote = text.get(at..)?.chars().next()?;
    let inside = text.get(at + 1..)?;
    inside.split_once(quote).map(|(inside, _)| inside.trim())
}

/// Joins a path to a folder, without `.` and with as few `..` as possible.
pub(super) fn joined(folder: &str, path: &str) -> String {
    let path = slashed(path);
    let mut parts: Vec<&str> = Vec::new();
    for part in folder.split('/').chain(path.split('/')) {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|p| *p != "..") => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

fn declare(_: &str, at: usize, control: &UniformControl) -> Option<(usize, String)> {
    let ([min, value, max], is_int) = control.slider()?;
    let ty = if is_int { "int" } else { "float" };
    let name = &control.name;
    let line = format!("#iUniform {ty} {name} = {value:?} in {{ {min:?}, {max:?} }}\n");
    let line = match is_int {
        true => line.replace(".0", ""),
        false => line,
    };
    Some((at, line))
}

/// Parses `float x = 1.0 in { 0.0, 2.0 } step 0.1` as a declaration and a control.
fn uniform(text: &str) -> Option<(String, UniformControl)> {
    let text = text.split("//").next()?.trim().trim_end_matches(';');
    let (ty, rest) = text.split_once(char::is_whitespace)?;
    let (text, _) = rest.split_once(" step ").unwrap_or((rest, ""));
    let (text, range) = match text.split_once('{').or_else(|| text.split_once('[')) {
        Some((text, range)) => (text.trim_end().trim_end_matches("in"), Some(range)),
        None => (text, None),
    };
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    let name = name.trim();
    let (ty, kind, lanes) = match ty {
        "float" => (ty, ControlKind::Float, 1),
        "int" => (ty, ControlKind::Int, 1),
        "bool" => (ty, ControlKind::Bool, 1),
        "color3" => ("vec3", ControlKind::Color, 3),
        "color4" => ("vec4", ControlKind::Color, 4),
        "vec2" | "ivec2" => (ty, ControlKind::Vector, 2),
        "vec3" | "ivec3" => (ty, ControlKind::Vector, 3),
        "vec4" | "ivec4" => (ty, ControlKind::Vector, 4),
        _ => return None,
    };
    if !is_identifier(name) {
        return None;
    }
    let ends: Vec<Vec<f64>> = range.map(in_range).unwrap_or_default();
    let lane = |all: &[f64], i: usize| all.get(i).or(all.first()).copied();
    let first = numbers(value);
    let mut control = UniformControl::even(name, kind, lanes, (0.0, 0.0, 1.0));
    for i in 0..lanes {
        let min = ends.first().and_then(|all| lane(all, i));
        let max = ends.get(1).and_then(|all| lane(all, i));
        let value = lane(&first, i).or(min).unwrap_or(0.0);
        let usual = match kind {
            ControlKind::Color => (0.0, 1.0),
            _ => (value.min(0.0), (2.0 * value).max(1.0)),
        };
        for (list, number) in [
            (&mut control.value, value),
            (&mut control.min, min.unwrap_or(usual.0)),
            (&mut control.max, max.unwrap_or(usual.1)),
        ] {
            if let Some(slot) = list.get_mut(i) {
                *slot = number;
            }
        }
    }
    Some((format!("uniform {ty} {name};\n"), control))
}

/// The two limits of a range.
fn in_range(text: &str) -> Vec<Vec<f64>> {
    let mut depth = 0_usize;
    let at = text.find(|c| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    });
    let (min, max) = text
        .split_at_checked(at.unwrap_or(text.len()))
        .unwrap_or((text, ""));
    vec![numbers(min), numbers(max.trim_start_matches(','))]
}

/// The numbers of a value: `1.0`, `vec2(1, 2)`, `true`.
pub(super) fn numbers(text: &str) -> Vec<f64> {
    if text.trim() == "true" {
        return vec![1.0];
    }
    let inside = text.split_once('(').map_or(text, |(_, inside)| inside);
    let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '+');
    let words = inside.split(|c| !is_part(c)).filter(|w| !w.is_empty());
    words
        .filter_map(|w| w.trim_end_matches('f').parse().ok())
        .collect()
}

/// A shader after the declarations of the host.
fn completion(code: &str, facts: &DirectiveFacts) -> Completion {
    let clues = Clues::of(code);
    let mut before = modern(&clues);
    before.push_str(&host());
    for number in 0..10 {
        let name = format!("iChannel{number}");
        let is_cube = facts
            .channels
            .iter()
            .any(|c| c.number == number && c.is_cube);
        let ty = if is_cube { "samplerCube" } else { "sampler2D" };
        if clues.has_word(&name) {
            before.push_str(&format!("uniform {ty} {name};\n"));
        }
    }
    before.push_str(&facts.declared);
    if facts.has_keyboard {
        before.push_str(&keyboard(&clues));
    }
    if clues.guess.has_main && !facts.is_strict || !clues.has_word("mainImage") {
        return Completion::after(before, code);
    }
    let color = match clues.has_word("gl_FragColor") {
        true => "gl_FragColor",
        false => {
            before.push_str("out vec4 port_FragColor;\n");
            "port_FragColor"
        }
    };
    let end = format!("\nvoid main() {{\n    mainImage({color}, gl_FragCoord.xy);\n}}\n");
    Completion::after(before, code).with_end(&end)
}

/// The declarations of the host, without the channels: their types depend on the text.
fn host() -> String {
    let text = preset(HOST).map_or("", |p| &p.prelude);
    let is_own = |l: &&str| !l.is_empty() && !l.starts_with("uniform sampler");
    let lines = text.lines().filter(is_own);
    lines.map(|line| format!("{line}\n")).collect()
}

/// The keyboard functions, and the key constants that a text uses. Key releases are not supported.
fn keyboard(clues: &Clues) -> String {
    let mut text = "uniform sampler2D iKeyboard;\n".to_string();
    for (name, row) in [("Down", 0), ("Pressed", 1), ("Toggled", 2)] {
        text.push_str(&format!(
            "bool isKey{name}(int key) {{ return texelFetch(iKeyboard, ivec2(key, {row}), 0).r > 0.0; }}\n"
        ));
    }
    text.push_str("bool isKeyReleased(int key) { return false; }\n");
    for word in clues.free_words(|w| w.starts_with("Key_")) {
        if let Some(code) = word.strip_prefix("Key_").and_then(key_code) {
            text.push_str(&format!("const int {word} = {code};\n"));
        }
    }
    text
}

/// JavaScript's code of a key.
fn key_code(name: &str) -> Option<u32> {
    #[rustfmt::skip]
    const NAMED: &[(&str, u32)] = &[
        ("Backspace", 8), ("Tab", 9), ("Enter", 13), ("Shift", 16), ("Ctrl", 17), ("Alt", 18),
        ("Pause", 19), ("Caps", 20), ("Escape", 27), ("Space", 32), ("PageUp", 33),
        ("PageDown", 34), ("End", 35), ("Home", 36), ("LeftArrow", 37), ("UpArrow", 38),
        ("RightArrow", 39), ("DownArrow", 40), ("Insert", 45), ("Delete", 46), ("LeftWindow", 91),
        ("RightWindows", 92), ("Select", 93), ("NumpadMultiply", 106), ("NumpadAdd", 107),
        ("NumpadSubtract", 109), ("NumpadPeriod", 110), ("NumpadDivide", 111), ("NumLock", 144),
        ("ScrollLock", 145), ("SemiColon", 186), ("Equal", 187), ("Comma", 188), ("Dash", 189),
        ("Period", 190), ("ForwardSlash", 191), ("GraveAccent", 192), ("OpenBracket", 219),
        ("BackSlash", 220), ("CloseBraket", 221), ("SingleQuote", 222),
    ];
    let named = NAMED.iter().find(|(own, _)| *own == name);
    if let Some((_, code)) = named {
        return Some(*code);
    }
    let number = |prefix: &str| name.strip_prefix(prefix)?.parse::<u32>().ok();
    match name.as_bytes() {
        [sign @ (b'A'..=b'Z' | b'0'..=b'9')] => Some(u32::from(*sign)),
        _ => number("Numpad")
            .filter(|n| *n < 10)
            .map(|n| 96 + n)
            .or_else(|| {
                number("F")
                    .filter(|n| (1..=12).contains(n))
                    .map(|n| 111 + n)
            }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::each_case;

    fn read(text: &str) -> String {
        match uniform(text) {
            Some((line, c)) => format!("{line}{:?} {:?} {:?} {:?}", c.kind, c.value, c.min, c.max),
            None => "none".to_string(),
        }
    }

    #[test]
    fn uniform_directives_are_read() {
        each_case(include_str!("uniforms.txt"), |text, expected| {
            assert_eq!(read(text), expected, "{text}");
        });
    }

    #[test]
    fn relative_paths_are_joined() {
        assert_eq!(joined("a/b", "../c.glsl"), "a/c.glsl");
        assert_eq!(joined("", "./c.glsl"), "c.glsl");
        assert_eq!(joined("a", "..\\..\\c.glsl"), "../c.glsl");
    }

    #[test]
    fn keys_have_javascript_key_codes() {
        let codes = ["A", "9", "LeftArrow", "F12", "Numpad3"].map(key_code);
        assert_eq!(codes, [65, 57, 37, 123, 99].map(Some));
        assert_eq!(key_code("Foo"), None);
    }

    #[test]
    fn directives_in_comments_are_ignored() {
        let text = "// #iChannel0 \"a\"\n/* #iUniform float x */\n# iChannel1 \"file://b.glsl\"\n#iChannel12 \"c\"\n#define iChannel2 3\n";
        let words: Vec<_> = directives(text).iter().map(|d| d.word).collect();
        assert_eq!(words, ["iChannel1"]);
    }

    #[test]
    fn referenced_shaders_become_passes() {
        let text = "#iChannel0 \"file://./a/b.glsl\"\n#iChannel1 \"self\"\nvoid mainImage(out vec4 c, in vec2 p) \
            { c = texture(iChannel0, p) + texture(iChannel1, p); }";
        let mut siblings = super::super::SiblingTexts::new();
        let asked = plan(&Clues::with_siblings(text, "x", &siblings)).requested;
        assert_eq!(asked, ["a/b.glsl"]);
        let buffer = "void main() { gl_FragColor = vec4(0.5, iTime, 0.0, 1.0); }";
        let buffer = GatheredText::of(buffer);
        siblings.insert("a/b.glsl".to_string(), Some(Arc::new(buffer)));
        let plan = plan(&Clues::with_siblings(text, "x", &siblings));
        let (requested, notes) = (&plan.requested, &plan.notes);
        assert!(requested.is_empty() && notes.is_empty(), "{notes:?}");
        let names = plan.passes.iter();
        let names = names.map(|p| format!("{:?} {:?}", p.name, p.kind));
        // The Image reads itself: it is a buffer, which is copied.
        let expected = [r#""a/b.glsl" Buffer"#, r#""" Buffer"#, r#""Image" Image"#];
        assert_eq!(names.collect::<Vec<_>>(), expected);
        for pass in &plan.passes {
            let errors = pass.candidates[0].check().unwrap().diagnostics;
            assert!(errors.is_empty(), "{errors:?}");
        }
    }
}
