//! Evidence for the language of a text.

use super::scan::{ScanKind, ScanToken, first_tokens, tokens};
use super::shader_language::ShaderLanguage;
use super::signs::SIGNS;
use rustc_hash::FxHashMap;
use shaderlint_text::is_respelled;
use std::sync::OnceLock;

/// Number of consecutive words that make a sentence.
const SENTENCE: usize = 5;
/// Number of consecutive names, without keywords, that no declaration has.
const NAMES: usize = 3;

/// A parsed sequence of [`SIGNS`].
struct SignRow {
    number: usize,
    language: ShaderLanguage,
    /// Tokens of the sequence, separated by blanks.
    row: &'static str,
    is_enough: bool,
    starts_line: bool,
    /// Index of the next sequence with the same first token.
    next: Option<usize>,
}

impl SignRow {
    fn of(number: usize, language: ShaderLanguage, text: &'static str) -> SignRow {
        let enough = text.strip_prefix("! ");
        let row = enough.unwrap_or(text);
        let at_start = row.strip_prefix("^ ");
        SignRow {
            number,
            language,
            row: at_start.unwrap_or(row),
            is_enough: enough.is_some(),
            starts_line: at_start.is_some(),
            next: None,
        }
    }

    fn first(&self) -> &'static str {
        self.row
            .split_once(' ')
            .map_or(self.row, |(first, _)| first)
    }
}

/// The sequences, indexed by first token.
struct Signs {
    all: Vec<SignRow>,
    heads: FxHashMap<&'static str, usize>,
    /// By first byte of a token, a bit for each length of a first token: most tokens start no
    /// sequence.
    lengths: [u32; 256],
}

impl Signs {
    fn get() -> &'static Signs {
        static SIGNS: OnceLock<Signs> = OnceLock::new();
        SIGNS.get_or_init(Signs::read)
    }

    fn read() -> Signs {
        let rows = SIGNS
            .iter()
            .flat_map(|(t, rows)| rows.iter().map(|r| (*t, *r)));
        let mut all: Vec<SignRow> = rows
            .enumerate()
            .map(|(number, (language, text))| SignRow::of(number, language, text))
            .collect();
        let mut heads = FxHashMap::default();
        heads.reserve(all.len());
        for (number, sign) in all.iter_mut().enumerate().rev() {
            sign.next = heads.insert(sign.first(), number);
        }
        let mut lengths = [0; 256];
        for head in heads.keys() {
            if let Some(slot) = lengths.get_mut(first_byte(head)) {
                *slot |= length_bit(head);
            }
        }
        Signs {
            all,
            heads,
            lengths,
        }
    }

    /// Whether a sequence may start with a token.
    fn may_start(&self, first: &str) -> bool {
        let lengths = self.lengths.get(first_byte(first)).copied().unwrap_or(0);
        lengths & length_bit(first) != 0
    }

    /// The sequences that start with a token, in order.
    fn starting_with(&self, first: &str) -> impl Iterator<Item = &SignRow> {
        let head = self.heads.get(first).and_then(|&head| self.all.get(head));
        std::iter::successors(head, |sign| self.all.get(sign.next?))
    }
}

fn first_byte(token: &str) -> usize {
    token.bytes().next().map_or(0, usize::from)
}

fn length_bit(token: &str) -> u32 {
    1 << token.len().min(31)
}

/// A sequence found in a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct SeenSign {
    number: usize,
    language: ShaderLanguage,
    is_enough: bool,
    start: usize,
    end: usize,
}

/// The `#version` of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VersionLine {
    /// Version number.
    pub number: u32,
    /// Whether `es` follows.
    pub is_es: bool,
    /// Start offset.
    pub at: usize,
}

impl VersionLine {
    /// Whether OpenGL, OpenGL ES or Vulkan has this version, but not WebGL.
    pub fn is_desktop(self) -> bool {
        match self.number {
            310 | 320 => self.is_es,
            110 | 120 | 130 | 140 | 150 | 330 | 400 | 410 | 420 | 430 | 440 | 450 | 460 => true,
            _ => false,
        }
    }
}

/// Evidence for the language of a text.
#[derive(Clone, Debug)]
pub struct Evidence<'a> {
    text: &'a str,
    /// The `#version` directive.
    pub version: Option<VersionLine>,
    seen: Vec<SeenSign>,
    has_quotes: bool,
    /// Number of lines that are sentences.
    sentences: usize,
    /// Whether consecutive words are prose.
    has_prose: bool,
    /// Number of lines that start as in a diff.
    changes: usize,
    /// The language that the first characters determine.
    start: Option<ShaderLanguage>,
    /// Number of closing tags and escaped angle brackets.
    tags: usize,
    /// How many of them are escaped angle brackets.
    entities: usize,
    /// Whether a type precedes a word, or a line is a GLSL directive.
    has_types: bool,
    /// Whether it defines a name that only TouchDesigner has.
    defines_names: bool,
}

impl<'a> Evidence<'a> {
    /// Collects the evidence in a text.
    pub fn of(text: &'a str) -> Evidence<'a> {
        Evidence::read(text, &tokens(text))
    }

    /// Collects the evidence in tokens.
    pub(super) fn read(text: &'a str, all: &[ScanToken]) -> Evidence<'a> {
        let mut evidence = Evidence {
            text,
            version: version(all),
            seen: Vec::new(),
            has_quotes: false,
            sentences: 0,
            has_prose: false,
            changes: 0,
            start: start(all),
            tags: 0,
            entities: 0,
            has_types: false,
            defines_names: false,
        };
        let signs = Signs::get();
        // Start of the current sequence of words.
        let mut row = 0;
        let mut in_directive = false;
        for (i, token) in all.iter().enumerate() {
            if token.is_first {
                evidence.check_row(all, row..i);
                (row, in_directive) = (i, token.text == "#");
                let is_margin = token.at == 0 || text.as_bytes().get(token.at - 1) == Some(&b'\n');
                let is_change = matches!(token.text, "+" | "-");
                evidence.changes += usize::from(is_margin && is_change);
            }
            if signs.may_start(token.text) {
                evidence.note(signs, all, i);
            }
            let is_tag = token.kind == ScanKind::Mark && is_tag(all, i);
            evidence.tags += usize::from(is_tag);
            evidence.entities += usize::from(is_tag && token.text == "&");
            if in_directive {
                evidence.has_types |=
                    matches!(token.text, "define" | "ifdef" | "endif" | "version");
                row = i + 1;
                continue;
            }
            if token.kind != ScanKind::Word {
                evidence.has_quotes |= token.kind == ScanKind::Quoted;
                evidence.check_row(all, row..i);
                row = i + 1;
            }
            let next = all.get(i + 1);
            evidence.has_types = evidence.has_types
                || next.is_some_and(|n| n.kind == ScanKind::Word || n.text == "(")
                    && is_type(token.text);
        }
        evidence.check_row(all, row..all.len());
        evidence.note_hook();
        evidence
    }

    /// Decides whether consecutive words are a sentence.
    fn check_row(&mut self, all: &[ScanToken], row: std::ops::Range<usize>) {
        if row.len() < NAMES {
            return;
        }
        let (mut words, mut names) = (0, 0);
        for token in all.get(row).unwrap_or(&[]) {
            if is_of_declarations(token.text) {
                words = 0;
                continue;
            }
            words += 1;
            names += usize::from(is_name(token.text));
            self.sentences += usize::from(words == SENTENCE);
            self.has_prose |= names == NAMES;
        }
    }

    /// Records the sequences that start with a token.
    fn note(&mut self, signs: &Signs, all: &[ScanToken], at: usize) {
        let Some(token) = all.get(at) else { return };
        for sign in signs.starting_with(token.text) {
            if self.seen.iter().any(|s| s.number == sign.number)
                || sign.starts_line && !token.is_first
            {
                continue;
            }
            let mut end = at;
            let fits = sign.row.split(' ').all(|part| {
                let token = all.get(end);
                end += 1;
                token.is_some_and(|t| is_part(t, part))
            });
            if fits {
                let before = at.checked_sub(1).and_then(|i| all.get(i));
                self.defines_names |= sign.is_enough
                    && sign.language == ShaderLanguage::TouchDesigner
                    && before.is_some_and(|t| t.text == "define" || is_type(t.text));
                let last = all.get(end - 1).unwrap_or(token);
                self.seen.push(SeenSign {
                    number: sign.number,
                    language: sign.language,
                    is_enough: sign.is_enough,
                    start: token.at,
                    end: last.at + last.text.len(),
                });
            }
        }
    }

    /// Records the line that hooks a user shader of mpv, which is a comment to other programs.
    fn note_hook(&mut self) {
        /// No number of a sequence.
        const LINE: usize = usize::MAX;
        let Some(line) = hook_line(self.text) else {
            return;
        };
        let sign = SeenSign {
            number: LINE,
            language: ShaderLanguage::Mpv,
            is_enough: true,
            start: line.start,
            end: line.end,
        };
        self.seen.insert(0, sign);
    }

    fn count(&self, language: ShaderLanguage) -> usize {
        self.seen.iter().filter(|s| s.language == language).count()
    }

    /// Whether there are `required` sequences of a language; strong ones count as three.
    fn has_enough(&self, language: ShaderLanguage, required: usize) -> bool {
        let of = self.seen.iter().filter(|s| s.language == language);
        of.map(|s| if s.is_enough { 3 } else { 1 }).sum::<usize>() >= required
    }

    /// Whether it contains something that only GLSL has.
    fn speaks_glsl(&self) -> bool {
        self.count(ShaderLanguage::Glsl) + self.count(ShaderLanguage::Web) > 0
    }

    /// The shading language other than GLSL ES that the text is clearly written in.
    pub fn foreign(&self) -> Option<ShaderLanguage> {
        use ShaderLanguage as L;
        if self.version.is_some_and(|v| !v.is_desktop()) {
            return None;
        }
        // Some of them require a `#version` of desktop GLSL.
        let engines = [
            L::Godot,
            L::RetroArch,
            L::Mpv,
            L::TouchDesigner,
            L::Obs,
            L::ReShade,
            L::MilkDrop,
        ];
        if let Some(engine) = engines.into_iter().find(|t| self.is_of_engine(*t)) {
            return Some(engine);
        }
        if self.version.is_some() {
            return Some(L::Desktop);
        }
        let complete = [L::ShaderLab, L::Sksl];
        if let Some(language) = complete.into_iter().find(|t| self.has_enough(*t, 3)) {
            return Some(language);
        }
        if self.has_enough(L::Desktop, 3) && self.count(L::Web) == 0 {
            return Some(L::Desktop);
        }
        let others = [L::Hlsl, L::Wgsl, L::Metal];
        let best = others.into_iter().filter(|t| self.has_enough(*t, 3));
        let best = best.max_by_key(|t| (self.has_certain(*t), self.count(*t)))?;
        let is_alone = !self.speaks_glsl() && self.count(L::Desktop) == 0;
        (is_alone || self.outweighs_glsl(best)).then_some(best)
    }

    /// Whether it clearly is for an engine.
    fn is_of_engine(&self, engine: ShaderLanguage) -> bool {
        let is_certain = self.has_certain(engine);
        match engine {
            // A text that defines these names does not need TouchDesigner.
            ShaderLanguage::TouchDesigner => is_certain && !self.defines_names,
            ShaderLanguage::RetroArch => self.has_enough(engine, 3),
            _ => is_certain || self.has_enough(engine, 3) && !has_main(self.text),
        }
    }

    /// Whether code that no GLSL has outweighs GLSL, as where macros name the types of GLSL.
    fn outweighs_glsl(&self, language: ShaderLanguage) -> bool {
        let glsl = self.count(ShaderLanguage::Glsl) + self.count(ShaderLanguage::Web);
        self.has_certain(language) && self.count(language) > glsl
    }

    /// Whether there is a sequence that is sufficient evidence of a language.
    fn has_certain(&self, language: ShaderLanguage) -> bool {
        let mut of = self.seen.iter().filter(|s| s.language == language);
        of.any(|s| s.is_enough)
    }

    /// The other language that the text is clearly written in.
    pub fn other(&self) -> Option<ShaderLanguage> {
        if self.start.is_some() {
            return self.start;
        }
        // GLSL copied from the source of a page is a mistake, not a page.
        let is_glsl = || self.version.is_some() || self.speaks_glsl();
        if self.tags >= 2 && !(self.entities == self.tags && is_glsl()) {
            return Some(ShaderLanguage::Markup);
        }
        if self.has_enough(ShaderLanguage::Diff, 3) {
            return Some(ShaderLanguage::Diff);
        }
        if self.version.is_some() || self.speaks_glsl() || self.foreign().is_some() {
            return None;
        }
        use ShaderLanguage::{C, FSharp, Python, Rust, Script};
        let all = [Script, C, FSharp, Rust, Python];
        // Words of another language next to GLSL declarations are mistakes.
        let required = if self.has_types { 4 } else { 2 };
        let named = all.into_iter().filter(|t| self.has_enough(*t, required));
        let prose = (self.sentences >= 2 && !self.has_types).then_some(ShaderLanguage::Prose);
        named.max_by_key(|t| self.count(*t)).or(prose)
    }

    /// Whether it clearly is GLSL ES.
    pub fn is_glsl(&self) -> bool {
        let is_else =
            |s: &SeenSign| !matches!(s.language, ShaderLanguage::Glsl | ShaderLanguage::Web);
        if self.seen.iter().any(is_else) || self.start.is_some() || self.foreign().is_some() {
            return false;
        }
        if self.has_quotes || self.has_prose || self.changes > 1 || self.tags > 0 {
            return false;
        }
        let signs = self.count(ShaderLanguage::Glsl) + self.count(ShaderLanguage::Web);
        self.version.is_some() || signs >= 2 || (signs >= 1 && has_main(self.text))
    }

    /// Whether a text with a `main` may be GLSL.
    pub fn may_be_glsl(&self) -> bool {
        self.other().is_none() && self.tags == 0 && (self.speaks_glsl() || !self.has_quotes)
    }

    /// Whether a text with GLSL declarations may be a shader fragment.
    pub fn may_be_part(&self) -> bool {
        let is_plain = !self.has_quotes && !self.has_prose && self.changes <= 1 && self.tags == 0;
        is_plain && self.has_glsl() && self.other().is_none() && self.foreign().is_none()
    }

    /// Whether anything in it may be GLSL.
    pub fn has_glsl(&self) -> bool {
        self.version.is_some() || self.speaks_glsl() || self.has_types
    }

    /// The range of the first code that is sufficient evidence of a language, or else of its first
    /// typical code.
    pub fn first_sign(&self, language: ShaderLanguage) -> Option<std::ops::Range<usize>> {
        let of = || self.seen.iter().filter(|s| s.language == language);
        let first = of().find(|s| s.is_enough).or_else(|| of().next());
        first.map(|s| s.start..s.end)
    }

    /// The first typical code of a language, as written.
    pub fn reported(&self, language: ShaderLanguage) -> Vec<&'a str> {
        const MOST: usize = 3;
        let of = self.seen.iter().filter(|s| s.language == language);
        let mut texts: Vec<&str> = Vec::new();
        for text in of.filter_map(|s| self.text.get(s.start..s.end)) {
            if texts.len() < MOST && !texts.contains(&text) && !text.contains('\n') {
                texts.push(text);
            }
        }
        texts
    }
}

/// Whether a token is a part of a sequence.
fn is_part(token: &ScanToken, part: &str) -> bool {
    match part {
        "_" => token.kind == ScanKind::Word,
        "\"" => token.kind == ScanKind::Quoted,
        part => match part.strip_suffix('*').filter(|start| !start.is_empty()) {
            Some(start) => token.text.starts_with(start),
            None => token.text == part,
        },
    }
}

/// The line that hooks a user shader of mpv. Such a text has further lines for mpv, and a function
/// `hook`.
fn hook_line(text: &str) -> Option<std::ops::Range<usize>> {
    if !text.contains("//!HOOK ") {
        return None;
    }
    let all = first_tokens(text, usize::MAX);
    let mut heads = all.windows(4).map(|w| w.iter().map(|t| t.text));
    if !heads.any(|head| head.eq(["hook", "(", ")", "{"])) {
        return None;
    }
    let mut start = 0;
    let mut hook = None;
    let mut others = 0;
    for line in text.split_inclusive('\n') {
        let at = start;
        start += line.len();
        let line = line.trim_end();
        match line.strip_prefix("//!").and_then(|l| l.split_once(' ')) {
            Some(("HOOK", _)) if hook.is_none() => hook = Some(at..at + line.len()),
            Some((word, _)) if word.bytes().all(|b| b.is_ascii_uppercase()) => others += 1,
            _ => {}
        }
    }
    hook.filter(|_| others > 0)
}

/// Whether a closing tag or an escaped angle bracket starts here.
fn is_tag(all: &[ScanToken], at: usize) -> bool {
    let text = |i: usize| all.get(at + i).map_or("", |t| t.text);
    match text(0) {
        "<" => text(1) == "/" && text(3) == ">",
        "&" => matches!(text(1), "lt" | "gt") && text(2) == ";",
        _ => false,
    }
}

/// Whether a text starts with the `#version` of a WebGL shader.
pub fn starts_as_web(text: &str) -> bool {
    /// `#version 300 es` and the next token.
    const HEAD: usize = 5;
    let version = version(&first_tokens(text, HEAD));
    version.is_some_and(|v| !v.is_desktop())
}

/// The first `#version`.
fn version(all: &[ScanToken]) -> Option<VersionLine> {
    let text = |i: usize| all.get(i).map_or("", |t| t.text);
    let is_version = |i: &usize| {
        let is_first = all.get(*i).is_some_and(|t| t.is_first);
        is_first && text(*i) == "#" && text(i + 1) == "version"
    };
    let at = (0..all.len()).find(is_version)?;
    let is_same_line = all.get(at + 3).is_some_and(|t| !t.is_first);
    Some(VersionLine {
        number: text(at + 2).parse().ok()?,
        is_es: is_same_line && text(at + 3) == "es",
        at: all.get(at)?.at,
    })
}

/// The language that the first tokens determine, because no shader starts that way.
fn start(all: &[ScanToken]) -> Option<ShaderLanguage> {
    let text = |i: usize| all.get(i).map_or("", |t| t.text);
    let is_word = |i: usize| all.get(i).is_some_and(|t| t.kind == ScanKind::Word);
    match (text(0), text(1)) {
        ("<", "!" | "?") => Some(ShaderLanguage::Markup),
        ("<", _) if is_word(1) => Some(ShaderLanguage::Markup),
        ("{", "\"" | "}") | ("[", "\"" | "{" | "]") => Some(ShaderLanguage::Json),
        ("#", "!") if text(2) == "/" => Some(ShaderLanguage::Shell),
        ("-", "-") if text(2) == "-" && all.get(3).is_some_and(|t| !t.is_first) => {
            Some(ShaderLanguage::Diff)
        }
        // The front matter of a static site generator.
        ("-", "-") if text(2) == "-" => Some(ShaderLanguage::Prose),
        _ => None,
    }
}

/// Words that follow each other in GLSL declarations.
fn is_of_declarations(word: &str) -> bool {
    let is_qualifier = matches!(
        word,
        "uniform"
            | "highp"
            | "mediump"
            | "lowp"
            | "flat"
            | "smooth"
            | "centroid"
            | "varying"
            | "attribute"
            | "precision"
            | "const"
    );
    is_qualifier || is_type(word)
}

/// Whether a word is neither a number nor a keyword before names.
fn is_name(word: &str) -> bool {
    let is_keyword = matches!(
        word,
        "return" | "else" | "if" | "case" | "do" | "for" | "while" | "in" | "out" | "inout"
    );
    !is_keyword && !word.starts_with(|c: char| c.is_ascii_digit())
}

/// Whether a word is a GLSL type.
pub fn is_type(word: &str) -> bool {
    let Some(digit) = word.bytes().position(|b| b.is_ascii_digit()) else {
        return matches!(
            word,
            "void" | "float" | "int" | "uint" | "bool" | "struct" | "samplerCube"
        );
    };
    matches!(
        word.get(..digit),
        Some("vec" | "ivec" | "uvec" | "bvec" | "mat" | "sampler" | "isampler" | "usampler")
    )
}

/// Whether a text defines `main` or `mainImage`, also as other languages do (`function mainImage(c, p)`) or
/// with a typo (`Void main()`, `void mian()`).
pub fn has_main(code: &str) -> bool {
    let words = ["void", "Void", "mainImage"];
    words.iter().any(|word| code.contains(word)) && defines_main(code)
}

fn defines_main(code: &str) -> bool {
    code.match_indices('(').any(|(at, _)| {
        let (before, name) = before_last_word(code.get(..at).unwrap_or(""));
        let is_image = is_respelled(name, "mainImage");
        if !is_image && !is_respelled(name, "main") || !before.ends_with(char::is_whitespace) {
            return false;
        }
        let (_, result) = before_last_word(before);
        let is_void = result.eq_ignore_ascii_case("void");
        let (params, rest) = code
            .get(at..)
            .and_then(|c| c.split_once(')'))
            .unwrap_or_default();
        let is_other = is_image && !result.is_empty() && rest.trim_start().starts_with('{');
        is_other || is_void && (params.contains('{') || rest.contains('{'))
    })
}

/// The last word of a text, and what is before it.
fn before_last_word(text: &str) -> (&str, &str) {
    let text = text.trim_end();
    let is_part = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
    let length = text.bytes().rev().take_while(is_part).count();
    text.split_at_checked(text.len() - length)
        .unwrap_or((text, ""))
}
