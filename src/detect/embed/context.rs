//! The context of a text in a script: the variable, property or call that receives it.

use super::embedded::NamedStage;
use super::text::Texts;
use crate::script::tree::{NodeKind, ScriptNodeId};

/// What the code around a text says about it.
pub struct LiteralContext {
    /// A tag or comment marks it as GLSL.
    pub is_introduced: bool,
    /// Its variable, property or call is named like a shader, or compiles it.
    pub names_shader: bool,
    /// The stage for which its variable, property or call is named.
    pub stage: Option<NamedStage>,
    /// It is a search pattern or a replacement.
    pub is_pattern: bool,
    /// It is a message for a person.
    pub is_message: bool,
    /// Name of the variable or property that receives it.
    pub target: Option<String>,
}

impl LiteralContext {
    /// Analyses the code around an expression whose first literal is given.
    pub fn of(
        text: &str,
        texts: &Texts,
        root: ScriptNodeId,
        literal: ScriptNodeId,
    ) -> LiteralContext {
        let read = ContextReader { text, texts };
        let target = read.target(root);
        let call = read.call(root);
        let words = target.map_or(Vec::new(), words);
        let has = |all: &[&str]| words.iter().any(|w| all.contains(&w.as_str()));
        LiteralContext {
            is_introduced: read.is_introduced(literal),
            names_shader: has(&SHADERS) || call == Some("shaderSource"),
            stage: NamedStage::of([target, call]),
            is_pattern: call.is_some_and(|c| PATTERNS.split(' ').any(|name| name == c))
                || read.is_compared(root),
            is_message: call.is_some_and(|c| c.ends_with("Error") || MESSAGES.contains(&c)),
            target: target.map(str::to_string),
        }
    }
}

impl NamedStage {
    /// The stage that some names show.
    pub(super) fn of<'n>(names: impl IntoIterator<Item = Option<&'n str>>) -> Option<NamedStage> {
        let names: Vec<&str> = names.into_iter().flatten().collect();
        let shows = |part: &str, short: [&str; 3]| {
            let is_short = |name: &str| words(name).iter().any(|w| short.contains(&w.as_str()));
            let mut names = names.iter();
            names.any(|name| name.to_ascii_lowercase().contains(part) || is_short(name))
        };
        let is_vertex = shows("vert", ["vs", "vsh", "vshader"]);
        match (is_vertex, shows("frag", ["fs", "fsh", "fshader"])) {
            (true, false) => Some(NamedStage::Vertex),
            (false, true) => Some(NamedStage::Fragment),
            _ => None,
        }
    }
}

/// Words in names of variables that hold shaders.
const SHADERS: [&str; 13] = [
    "shader", "shaders", "vert", "vertex", "frag", "fragment", "vs", "fs", "vsh", "fsh", "glsl",
    "webgl", "chunk",
];
/// String methods that search or replace.
const PATTERNS: &str = "\
    replace replaceAll indexOf lastIndexOf includes startsWith endsWith split match matchAll \
    search test RegExp";
/// Calls that show a text to a person.
const MESSAGES: [&str; 8] = [
    "log", "warn", "error", "info", "debug", "assert", "describe", "alert",
];

/// Whether the name of a file or of its folder indicates shaders.
pub fn is_file_of_shaders(name: &str) -> bool {
    let mut parts = name.rsplit(['/', '\\']);
    let file = parts.next().unwrap_or("");
    let file = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let is_shader = |w: &String| SHADERS.contains(&w.as_str()) && w != "webgl" && w != "chunk";
    words(file).last().is_some_and(is_shader)
        || parts
            .next()
            .is_some_and(|f| words(f).iter().all(is_shader) && !words(f).is_empty())
}

/// The words of a name in lower case: `aVertexShader_FS2` has a, vertex, shader and fs.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in name.chars() {
        if c.is_ascii_alphabetic() {
            let starts = !before.is_ascii_alphabetic()
                || c.is_ascii_uppercase() && before.is_ascii_lowercase();
            match words.last_mut().filter(|_| !starts) {
                Some(word) => word.push(c.to_ascii_lowercase()),
                None => words.push(c.to_ascii_lowercase().to_string()),
            }
        }
        before = c;
    }
    words
}

struct ContextReader<'t, 's> {
    text: &'t str,
    texts: &'t Texts<'s>,
}

impl<'t> ContextReader<'t, '_> {
    fn name(&self, id: ScriptNodeId) -> Option<&'t str> {
        self.texts.tree.last_name(self.text, id)
    }

    /// Whether a tag or comment marks a literal as GLSL.
    fn is_introduced(&self, literal: ScriptNodeId) -> bool {
        let tree = self.texts.tree;
        let Some(node) = tree.node(literal) else {
            return false;
        };
        let parent = node
            .parent
            .filter(|p| tree.node(*p).is_some_and(|n| n.kind == NodeKind::Tagged));
        if let Some(tag) = parent.and_then(|p| self.name(tree.child(p, 0)?)) {
            let tags = ["frag", "vert", "shader", "fs", "vs", "fragment", "vertex"];
            let tag = tag.to_ascii_lowercase();
            return tag.contains("glsl") || tags.contains(&tag.as_str());
        }
        let start = node.span.start.saturating_sub(1);
        let after = tree.comments.partition_point(|c| c.end <= start);
        let comment = after.checked_sub(1).and_then(|at| tree.comments.get(at));
        comment.is_some_and(|comment| {
            let between = self.text.get(comment.end..start).unwrap_or("x");
            let words = self.text.get(comment.clone()).unwrap_or("");
            let words = words
                .trim_matches(['/', '*', ' ', '\t', '@'])
                .to_ascii_lowercase();
            let words = words.strip_prefix("language=").unwrap_or(&words).trim();
            let is_glsl = words == "glsl" || words.starts_with("glsl ") && words.len() < 20;
            is_glsl && between.trim().is_empty()
        })
    }

    /// The name of the variable or property that receives a text, perhaps through a call with it alone.
    fn target(&self, root: ScriptNodeId) -> Option<&'t str> {
        let tree = self.texts.tree;
        let mut at = root;
        for parent in tree.above(root) {
            let node = tree.node(parent)?;
            match &node.kind {
                NodeKind::Property(name) | NodeKind::Variable(name) | NodeKind::Attribute(name) => {
                    return self.text.get(name.clone());
                }
                NodeKind::Assignment(_) => {
                    let target = *node.children.first().filter(|c| **c != at)?;
                    let index = || tree.node(tree.child(target, 1)?);
                    let index = index().filter(|n| n.kind == NodeKind::Text);
                    let index = index.and_then(|n| self.text.get(n.span.clone()));
                    return self.name(target).or(index);
                }
                NodeKind::Choice | NodeKind::Tagged | NodeKind::Array | NodeKind::Other => {}
                NodeKind::Return | NodeKind::Function | NodeKind::Member(_) => {}
                NodeKind::Call if node.children.len() <= 2 => {}
                _ => return None,
            }
            at = parent;
        }
        None
    }

    /// The function that is called with the text as an argument.
    fn call(&self, root: ScriptNodeId) -> Option<&'t str> {
        let tree = self.texts.tree;
        let mut at = root;
        for parent in tree.above(root) {
            let node = tree.node(parent)?;
            match &node.kind {
                NodeKind::Call | NodeKind::New if node.children.first() != Some(&at) => {
                    return self.name(*node.children.first()?);
                }
                NodeKind::Choice | NodeKind::Sum | NodeKind::Other => {}
                _ => return None,
            }
            at = parent;
        }
        None
    }

    /// Whether a text is compared: `a === "..."`.
    fn is_compared(&self, root: ScriptNodeId) -> bool {
        let parent = self.texts.tree.above(root).next();
        let parent = parent.and_then(|p| self.texts.tree.node(p));
        parent.is_some_and(|p| p.kind == NodeKind::Comparison)
    }
}

#[cfg(test)]
mod tests {
    use super::super::embedded::NoModules;
    use super::*;
    use crate::script::parse;
    use crate::script::tree::ScriptNode;

    /// Checks the context of the last literal in a script.
    #[track_caller]
    fn check(text: &str, expected: &str) {
        let tree = parse(text);
        let texts = Texts::new(text, &tree, &NoModules);
        let is_literal = |n: &ScriptNode| matches!(n.kind, NodeKind::Text | NodeKind::Template(_));
        let literal = tree.nodes.iter().rposition(is_literal).unwrap();
        let context = LiteralContext::of(text, &texts, texts.root(literal), literal);
        let reported = [
            (context.is_introduced, "introduced"),
            (context.names_shader, "named"),
            (context.stage == Some(NamedStage::Vertex), "vertex"),
            (context.is_pattern, "pattern"),
            (context.is_message, "message"),
        ];
        let reported: Vec<&str> = reported.iter().filter(|t| t.0).map(|t| t.1).collect();
        assert_eq!(reported.join(" "), expected, "{text}");
    }

    #[test]
    fn file_names_indicate_shaders() {
        let all = [
            "a/blur.frag.js",
            "BlurShader.ts",
            "src/shaders/blur.js",
            "vs2.js",
        ];
        assert!(all.iter().all(|n| is_file_of_shaders(n)));
        let none = [
            "shader-park.js",
            "a.js",
            "shader_tools/a.js",
            "fragments.js",
        ];
        assert!(!none.iter().any(|n| is_file_of_shaders(n)));
    }

    #[test]
    fn the_code_around_a_literal_shows_whether_it_is_glsl() {
        check("glsl`x`", "introduced");
        check("/* glsl */ `x`", "introduced");
        check("// language=GLSL\n`x`", "introduced");
        check("const blurFragShader: string = `x`", "named");
        check("a = { 'vertexShader': 'x'", "named vertex");
        check("gl.shaderSource(f(a), 'x')", "named");
        check("a.vs += 'x'", "named vertex");
        check("shader.replace(/a/, 'x')", "pattern");
        check("if (a === 'x') {}", "pattern");
        check("throw new TypeError('x')", "message");
        check("const a = { shaders: 1, b: 'x' }", "");
        check("const shader = a ? '' : 'x'", "named");
    }
}
