//! Who runs a shader, and detection of what a text is written for.

use super::builtins::{BuiltinId, LEGACY_FUNCTIONS, Stage};
use super::types::Sampler;
use rustc_hash::FxHashSet;
use shaderlint_syntax::{ConditionalGroups, Feature, GroupDirective, Version, WordClass, classify};
use shaderlint_text::is_respelled;
use std::ops::Range;

/// Lookups that only GLSL ES 1.00 has, used in most of its shaders.
const OLD_LOOKUPS: [BuiltinId; 2] = [BuiltinId::Texture2D, BuiltinId::TextureCube];
/// Lookups that only GLSL ES 3.00 has.
const NEW_LOOKUPS: [BuiltinId; 3] = [
    BuiltinId::Texture,
    BuiltinId::TexelFetch,
    BuiltinId::TextureLod,
];

/// Kinds of ShaderToy passes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Pass {
    /// Renders the visible image.
    Image,
    /// Renders into a buffer.
    Buffer,
    /// Renders a cube map.
    Cubemap,
    /// Computes sound samples.
    Sound,
    /// Code prepended to every other pass; never runs alone.
    Common,
}

/// Who runs the shader.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Dialect {
    /// ShaderToy, which adds a header before the pass.
    ShaderToy(Pass),
    /// A web page, which compiles the text as it is or completes it first.
    WebGl,
}

/// Type of each channel of a pass; `None` if it is unknown.
pub type Channels = [Option<Sampler>; 4];

/// Output declaration for a fragment that writes to `gl_FragColor` and is compiled as GLSL ES 3.00,
/// if its host declares none.
pub const CHUNK_OUTPUT: &str =
    "out highp vec4 host_FragColor;\n#define gl_FragColor host_FragColor\n";

/// Declarations added before a shader fragment, after its `#version`: default precisions and, as
/// hosts that compile as GLSL ES 3.00 do, macros for the names of 1.00.
pub fn chunk_declarations(version: Version, stage: Stage) -> String {
    const TYPES: &str = "float int sampler2D samplerCube";
    const NEW_SAMPLERS: &str = "\
        sampler3D sampler2DArray isampler2D isampler3D isamplerCube isampler2DArray usampler2D \
        usampler3D usamplerCube usampler2DArray sampler2DShadow samplerCubeShadow \
        sampler2DArrayShadow";
    let mut text = String::new();
    let new = match version.has(Feature::SamplerTypes) {
        true => NEW_SAMPLERS,
        false => "",
    };
    for ty in TYPES.split(' ').chain(new.split_whitespace()) {
        text.push_str(&format!("precision highp {ty};\n"));
    }
    if !version.has(Feature::InOut) {
        return text;
    }
    let varying = match stage {
        Stage::Vertex => "#define attribute in\n#define varying out\n",
        Stage::Fragment => "#define varying in\n#define gl_FragDepthEXT gl_FragDepth\n",
    };
    text.push_str(varying);
    for (old, new) in LEGACY_FUNCTIONS {
        text.push_str(&format!("#define {old} {new}\n"));
    }
    text
}

impl Dialect {
    /// Whether ShaderToy runs it.
    pub const fn is_shadertoy(self) -> bool {
        matches!(self, Dialect::ShaderToy(_))
    }
}

/// What a text is probably written for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Guess {
    /// Kind of text; `None` if nothing indicates it.
    pub kind: Option<GuessedKind>,
    /// Stage, if the text indicates it.
    pub stage: Option<Stage>,
    /// Whether it defines `main`.
    pub has_main: bool,
    /// Whether it sets a default precision, which WebGL1 requires in every fragment shader.
    pub has_precision: bool,
    /// Whether it declares attributes, as every vertex shader does.
    pub has_attribute: bool,
    /// Whether its `#version` is 300.
    pub is_300: bool,
    /// Whether it contains an `#include` or a `#pragma` outside GLSL, so that a program must
    /// complete it.
    pub is_completed: bool,
}

impl Guess {
    /// Whether it is a ShaderToy pass.
    pub fn is_shadertoy(&self) -> bool {
        matches!(self.kind, Some(GuessedKind::ShaderToy(_)))
    }
}

/// Kind of text, judged by its words.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum GuessedKind {
    /// A ShaderToy pass of this kind.
    ShaderToy(Pass),
    /// Has a `#version`.
    Versioned,
    /// Uses names of GLSL ES 1.00 and has no `#version`.
    WebGl1,
    /// Has a `main` and names of GLSL ES 3.00, but no `#version`.
    WebGl2,
}

impl GuessedKind {
    /// Whether texts of this kind are complete, or completed by a known host.
    pub fn is_complete(self) -> bool {
        matches!(self, GuessedKind::ShaderToy(_) | GuessedKind::Versioned)
    }
}

/// Guesses from the words of a text what it is written for: first from `#version`, then from
/// ShaderToy's entry functions, then from words of only one version of the language.
pub fn guess(text: &str) -> Guess {
    let has = |word: &str| text.contains(word);
    let mut seen = Seen::default();
    let any = [
        "version",
        "mage",
        "mainSound",
        "mainCubemap",
        "gl_",
        "precision",
        "attribute",
        "varying",
        "main",
        "texture",
    ];
    if any.iter().any(|w| has(w)) {
        seen.read(text);
    }
    let kind = if seen.version {
        Some(GuessedKind::Versioned)
    } else if let Some(pass) = seen.pass {
        Some(GuessedKind::ShaderToy(pass))
    } else if seen.has_near_entry && !seen.old && !has("uniform ") {
        Some(GuessedKind::ShaderToy(Pass::Image))
    } else if seen.old {
        Some(GuessedKind::WebGl1)
    } else if seen.main {
        Some(if seen.new {
            GuessedKind::WebGl2
        } else {
            GuessedKind::WebGl1
        })
    } else {
        None
    };
    // Every ShaderToy pass is a fragment shader, whatever names it contains.
    let stage = match kind {
        Some(GuessedKind::ShaderToy(_)) => Some(Stage::Fragment),
        _ if seen.vertex => Some(Stage::Vertex),
        _ if seen.fragment => Some(Stage::Fragment),
        _ => None,
    };
    Guess {
        kind,
        stage,
        has_main: seen.defines_main,
        has_precision: seen.precision,
        has_attribute: seen.attribute,
        is_300: seen.is_300,
        is_completed: has("#") && is_completed(text),
    }
}

/// Whether a text has directives that only a program completing it understands: `#include`,
/// `#import`, or a `#pragma` with arguments that is not one of GLSL ES (section 3.4).
fn is_completed(text: &str) -> bool {
    let word_of = |text: &str| {
        let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        end.unwrap_or(text.len())
    };
    text.match_indices('#').any(|(at, _)| {
        let before = text.get(..at).unwrap_or("");
        let before = before.trim_end_matches(|c: char| c != '\n' && c.is_whitespace());
        if !before.is_empty() && !before.ends_with('\n') {
            return false;
        }
        let line = text.get(at + 1..).unwrap_or("").lines().next();
        let line = line.unwrap_or("").trim_start();
        let (word, rest) = line.split_at(word_of(line));
        let is_own = || {
            let rest = rest.trim_start();
            let (name, after) = rest.split_at(word_of(rest));
            // A module adds nothing but the name that it is given: `name = require(path)`.
            let is_module = after
                .split_once('(')
                .is_some_and(|(before, _)| before.contains('='));
            !is_module
                && !matches!(name, "STDGL" | "optimize" | "debug")
                && after.trim_start().starts_with([':', '(', '<', '"'])
        };
        match word {
            "include" | "import" => true,
            "pragma" => is_own(),
            _ => false,
        }
    })
}

/// Whether a text needs GLSL ES 3.00: it contains keywords, types or literals that only this
/// version has, or declares `in` and `out` variables.
pub fn needs_300(text: &str) -> bool {
    first_of_300(text).is_some()
}

/// Position of the first word that only GLSL ES 3.00 has.
pub fn first_of_300(text: &str) -> Option<Range<usize>> {
    use shaderlint_syntax::{Lexer, RawKind, TokenKind, WordClass, classify};
    let is_new = |word: &str| {
        let is_word = |version| {
            let class = classify(word, version);
            matches!(class, WordClass::Keyword(_) | WordClass::Type(_))
        };
        is_word(Version::Es300) && !is_word(Version::Es100)
    };
    let is_type_or_name = |word: &str| {
        let class = classify(word, Version::Es300);
        !word.is_empty() && matches!(class, WordClass::Type(_) | WordClass::Plain)
    };
    let mut lexer = Lexer::new(text, 0);
    let mut depth = 0_u32;
    let mut in_directive = false;
    let mut starts = true;
    // Names declared by the text itself, which GLSL ES 1.00 allows.
    let mut own: Vec<&str> = Vec::new();
    let mut last = "";
    loop {
        let token = lexer.next_token();
        let range = token.span.start as usize..token.span.end as usize;
        let word = text.get(range.clone()).unwrap_or("");
        match token.kind {
            RawKind::End => return None,
            RawKind::Whitespace | RawKind::LineComment | RawKind::BlockComment => continue,
            RawKind::Newline => {
                starts |= in_directive;
                in_directive = false;
                continue;
            }
            RawKind::Hash => in_directive = true,
            RawKind::Word if in_directive => {}
            RawKind::Word if is_new(word) && is_type_or_name(last) => own.push(word),
            RawKind::Word if is_new(word) && !own.contains(&word) => return Some(range),
            RawKind::Word if depth == 0 && starts && matches!(word, "in" | "out") => {
                return Some(range);
            }
            RawKind::Integer if word.ends_with(['u', 'U']) => return Some(range),
            RawKind::Operator(TokenKind::LeftParen | TokenKind::LeftBrace) => depth += 1,
            RawKind::Operator(TokenKind::RightParen | TokenKind::RightBrace) => {
                depth = depth.saturating_sub(1);
            }
            _ => {}
        }
        last = match token.kind {
            RawKind::Word if !in_directive => word,
            _ => "",
        };
        let ends = [TokenKind::Semicolon, TokenKind::RightBrace].map(RawKind::Operator);
        starts = ends.contains(&token.kind);
    }
}

/// Words that indicate a vertex shader, even after a `#version`.
const VERTEX_WORDS: [&str; 5] = [
    "attribute",
    "gl_Position",
    "gl_VertexID",
    "gl_InstanceID",
    "gl_PointSize",
];

/// Inputs and outputs of fragment shaders.
const FRAGMENT_WORDS: [&str; 8] = [
    "gl_FragColor",
    "gl_FragData",
    "gl_FragCoord",
    "gl_FragDepth",
    "gl_FragDepthEXT",
    "gl_FrontFacing",
    "gl_PointCoord",
    "discard",
];

/// What a line is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TextLine {
    Code,
    Directive,
}

/// The `#if` groups of a text, by whether each branch is skipped as far as its line shows.
#[derive(Default)]
struct SkippedBranches<'t> {
    groups: ConditionalGroups<bool>,
    /// The macros defined so far.
    defined: FxHashSet<&'t str>,
}

impl<'t> SkippedBranches<'t> {
    /// Whether the current line is skipped.
    fn is_off(&self) -> bool {
        self.groups.open().any(|is_off| *is_off)
    }

    /// Reads a directive; `rest` is the text after its name.
    fn directive(&mut self, name: &str, rest: &'t str) {
        let rest = rest.lines().next().unwrap_or("");
        let end = |c: char| !c.is_ascii_alphanumeric() && c != '_';
        let word = rest.trim_start().split(end).next().unwrap_or("");
        if name == "define" {
            self.defined.insert(word);
        }
        let is_off = match name {
            "if" => rest.trim() == "0",
            "ifdef" => !word.starts_with("GL_") && !self.defined.contains(word),
            _ => false,
        };
        if let Some(effect) = GroupDirective::of(name) {
            self.groups.add(effect, is_off);
        }
    }
}

#[derive(Default)]
struct Seen {
    version: bool,
    pass: Option<Pass>,
    old: bool,
    new: bool,
    main: bool,
    vertex: bool,
    fragment: bool,
    defines_main: bool,
    precision: bool,
    attribute: bool,
    is_300: bool,
    /// Whether a function with another name has the parameters of `mainImage`: `mainimage`, or a
    /// `main` that cannot have any.
    has_near_entry: bool,
    /// A function without parameters that is called `main` but for a typo, and the number of its occurrences.
    near_main: (String, u32),
    /// Number of occurrences of `mainImage`.
    entries: u32,
}

impl Seen {
    fn read(&mut self, text: &str) {
        use shaderlint_syntax::{Lexer, RawKind};
        let mut lexer = Lexer::new(text, 0);
        let mut after_hash = false;
        let mut last = "";
        let mut line = TextLine::Code;
        let mut groups = SkippedBranches::default();
        loop {
            let token = lexer.next_token();
            match token.kind {
                RawKind::End => break,
                RawKind::Whitespace => continue,
                RawKind::Newline => line = TextLine::Code,
                RawKind::Hash if line == TextLine::Code => line = TextLine::Directive,
                RawKind::Word => {
                    let word = text.get(token.span.start as usize..token.span.end as usize);
                    let word = word.unwrap_or("");
                    let after = text.get(token.span.end as usize..).unwrap_or("");
                    if after_hash {
                        groups.directive(word, after);
                    }
                    match (line, word) {
                        (TextLine::Directive, "version") => {
                            self.word(word, after_hash, last, after)
                        }
                        // A macro may define the entry point, and gives other words a new meaning.
                        (TextLine::Directive, _) if !word.starts_with("main") => {}
                        (_, "main") if groups.is_off() => {}
                        _ => self.word(word, after_hash, last, after),
                    }
                    last = word;
                }
                _ => {}
            }
            after_hash = token.kind == RawKind::Hash;
        }
        // Nothing else calls it, and it does what only `main` does.
        if self.near_main.1 == 1 && !self.main && (self.version || self.vertex || self.fragment) {
            (self.main, self.defines_main) = (true, true);
        }
        // Only some words of a vertex shader exclude a fragment shader.
        self.vertex |= self.attribute && !self.fragment;
        // A text with its own `main` may call `mainImage` itself.
        if self.defines_main && self.entries > 1 {
            self.pass = None;
        }
    }

    fn word(&mut self, word: &str, after_hash: bool, last: &str, after: &str) {
        self.vertex |= VERTEX_WORDS.contains(&word) && word != "attribute";
        self.fragment |= FRAGMENT_WORDS.contains(&word);
        match word {
            "version" if after_hash => {
                self.version = true;
                self.is_300 = after.trim_start_matches([' ', '\t']).starts_with("300");
            }
            "mainImage" => {
                self.entries += 1;
                if may_be_entry(last, after) {
                    self.pass = Some(Pass::Image);
                }
            }
            "mainCubemap" if self.pass.is_none() => self.pass = Some(Pass::Cubemap),
            "mainSound" if self.pass.is_none() => self.pass = Some(Pass::Sound),
            "attribute" | "varying" | "gl_FragColor" | "gl_FragData" => {
                self.old = true;
                self.attribute |= word == "attribute";
            }
            "out" | "uint" | "flat" | "layout" => self.new = true,
            "precision" => self.precision = true,
            "main" => {
                self.main = true;
                self.defines_main |= last.eq_ignore_ascii_case("void");
                self.has_near_entry |= has_parameters_of_entry(last, after);
            }
            _ if is_respelled(word, "mainImage") => {
                self.has_near_entry |= has_parameters_of_entry(last, after);
            }
            _ if word == self.near_main.0 => self.near_main.1 += 1,
            _ if is_respelled(word, "main") && is_main(last, after) => {
                self.near_main = (word.to_string(), 1);
            }
            _ => {
                self.old |= OLD_LOOKUPS.iter().any(|f| f.name() == word);
                self.new |= NEW_LOOKUPS.iter().any(|f| f.name() == word);
            }
        }
    }
}

/// Whether the context of `mainImage` fits ShaderToy's entry function: others have more parameters
/// or return a value.
fn may_be_entry(last: &str, after: &str) -> bool {
    let params = after.trim_start().strip_prefix('(');
    let params = params.and_then(|p| p.split(['(', ')', '{', ';']).next());
    let gives = last == "void" || params.is_some_and(|p| p.contains("out "));
    let gives = gives || is_foreign_definition(last, after);
    gives && params.is_none_or(|p| p.matches(',').count() < 2)
}

/// Whether a function is defined as in another language: `function f(a) {`, `def f(a):`, `fn f(a) {`.
fn is_foreign_definition(last: &str, after: &str) -> bool {
    let is_word = matches!(
        classify(last, Version::Es300),
        WordClass::Plain | WordClass::Reserved
    );
    let rest = after
        .split_once(')')
        .map_or("", |(_, rest)| rest.trim_start());
    !last.is_empty() && is_word && rest.starts_with(['{', ':'])
}

/// Whether a function is defined as `main` is: without parameters and result.
fn is_main(last: &str, after: &str) -> bool {
    let body = after
        .trim_start()
        .strip_prefix('(')
        .and_then(|a| a.split_once(')'));
    last.eq_ignore_ascii_case("void")
        && body.is_some_and(|(params, rest)| {
            matches!(params.trim(), "" | "void") && rest.trim_start().starts_with('{')
        })
}

/// Whether a function has the parameters of `mainImage`.
fn has_parameters_of_entry(last: &str, after: &str) -> bool {
    let params = after.trim_start().strip_prefix('(');
    let params = params.and_then(|p| p.split([')', '{', ';']).next());
    let params = params.and_then(|p| p.split_once(','));
    last.eq_ignore_ascii_case("void")
        && params.is_some_and(|(color, place)| {
            let words = |text: &str, all: [&str; 2]| {
                text.to_ascii_lowercase().split_whitespace().take(2).eq(all)
            };
            let is_in = words(place, ["in", "vec2"]) || place.trim_start().starts_with("vec2 ");
            words(color, ["out", "vec4"]) && is_in && !place.contains(',')
        })
}
