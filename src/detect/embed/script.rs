//! Shaders in string literals of a script.

use super::context::LiteralContext;
use super::embedded::ImportedTexts;
use super::embedded::{Embedded, InsertedPart, Wrapping, joined};
use super::holes::mask;
use super::receiver::{ReceiverReader, ShaderReceiver};
use super::text::{ScriptText, Texts};
use crate::kind::{Chunk, Scanned, may_be_shader};
use crate::script::parse;
use crate::script::tree::{BindingValue, NodeKind, ScriptNodeId, ScriptTree};
use std::collections::HashSet;
use std::rc::Rc;
use std::sync::Arc;

/// Finds the shaders. If the name of the script indicates shaders, its literals need less evidence.
pub fn extract(
    text: &str,
    base: usize,
    is_named: bool,
    modules: &dyn ImportedTexts,
    found: &mut Vec<Embedded>,
) {
    let tree = parse(text);
    let script = Script {
        text,
        texts: Texts::new(text, &tree, modules),
        receivers: ReceiverReader::new(text, &tree),
        is_named,
    };
    let from = found.len();
    let mut done = 0;
    for (id, node) in tree.nodes.iter().enumerate() {
        let is_text = match node.kind {
            NodeKind::Text | NodeKind::Template(_) => true,
            _ => script.texts.joins_names(id),
        };
        if !is_text || node.span.start < done {
            continue;
        }
        let root = script.texts.root(id);
        let context = LiteralContext::of(text, &script.texts, root, id);
        // Each expression is read once, however many literals it has.
        done = tree.node(root).map_or(done, |n| n.span.end.max(done));
        if !script.may_hold(root, &context) {
            continue;
        }
        let Some(code) = script.texts.text_of(root) else {
            continue;
        };
        let end = code.start + code.code.len();
        let is_one = |id: ScriptNodeId| {
            matches!(tree.node(id).map(|n| &n.kind), Some(NodeKind::Template(_)))
        };
        let wrapping = match is_one(id) && tree.node(id).is_some_and(|n| n.span.end == end) {
            true => Wrapping::Template,
            false => Wrapping::Quotes,
        };
        // Strings in the code that is inserted belong to the text around them.
        done = end.max(done);
        found.extend(script.shader(root, code, &context, wrapping));
    }
    // Parts are checked in the shaders that insert them.
    let all = found.get_mut(from..).unwrap_or(&mut []);
    let mut parts = HashSet::new();
    all.iter()
        .for_each(|shader| starts(&shader.inserted, &mut parts));
    for shader in all {
        shader.is_part = parts.contains(&shader.start);
        shader.shift(base);
    }
}

/// A script that others import.
pub struct ParsedScript {
    text: Arc<str>,
    tree: Rc<ScriptTree>,
}

impl ParsedScript {
    /// Parses a script.
    pub fn new(text: Arc<str>) -> ParsedScript {
        let tree = parse(&text);
        ParsedScript { text, tree }
    }

    /// To what the script hands what it imports from some modules; `None` if the text is changed first, or goes
    /// elsewhere, too.
    pub fn receivers(&self, is_module: impl Fn(&str) -> bool) -> Option<Vec<ShaderReceiver>> {
        let is_meant = |id: &ScriptNodeId| {
            let node = self.tree.node(*id).filter(|n| n.kind == NodeKind::Name);
            let binding = node.and_then(|n| {
                let name = self.text.get(n.span.clone())?;
                self.tree.binding(name, n.span.start)
            });
            match binding.map(|b| &b.value) {
                Some(BindingValue::Import(path, _)) => is_module(path),
                _ => false,
            }
        };
        let reader = ReceiverReader::new(&self.text, &self.tree);
        let uses = (0..self.tree.nodes.len()).filter(is_meant);
        uses.map(|id| reader.of(id)).collect()
    }

    /// The text that it exports under a name.
    pub fn export(&self, name: &str, modules: &dyn ImportedTexts) -> Option<InsertedPart> {
        Texts::new(&self.text, &self.tree, modules).export(name)
    }
}

/// The starts of the texts of this file that are inserted somewhere.
fn starts(inserted: &[InsertedPart], found: &mut HashSet<usize>) {
    for part in inserted {
        if let (Some(start), None) = (part.start, &part.module) {
            found.insert(start);
        }
        starts(&part.inserted, found);
    }
}

/// What is known about a script.
struct Script<'s> {
    text: &'s str,
    texts: Texts<'s>,
    receivers: ReceiverReader<'s>,
    /// Whether the file name indicates shaders.
    is_named: bool,
}

impl Script<'_> {
    /// Whether an expression may be a shader: its texts, or what they are for, show it.
    fn may_hold(&self, root: ScriptNodeId, context: &LiteralContext) -> bool {
        let node = self.texts.tree.node(root);
        let code = node
            .and_then(|n| self.text.get(n.span.clone()))
            .unwrap_or("");
        context.is_introduced || context.names_shader || may_be_shader(code)
    }

    /// The shader in an expression, if it is one.
    fn shader(
        &self,
        root: ScriptNodeId,
        code: ScriptText,
        context: &LiteralContext,
        wrapping: Wrapping,
    ) -> Option<Embedded> {
        /// Minimum length of a text without a tag or comment.
        const SHORTEST: usize = 8;
        if !context.is_introduced && code.code.len() < SHORTEST {
            return None;
        }
        let all = joined(&code.code, &code.inserted);
        if all.trim().is_empty() || !is_taken(&all, context, self.is_named) {
            return None;
        }
        let masked = mask(&code.code);
        let grows = context
            .target
            .as_deref()
            .is_some_and(|t| self.texts.grows(t));
        let mut shader = Embedded {
            start: code.start,
            has_holes: code.has_holes || masked.is_some() || context.is_pattern || grows,
            code: masked.unwrap_or(code.code),
            inserted: code.inserted,
            wrapping,
            stage: context.stage,
            is_part: false,
            receivers: self.receivers.of_text(root),
            chapter: 0,
        };
        self.cut_start(root, &mut shader);
        Some(shader)
    }

    /// Removes what `.trim()` or `.slice(1)` removes.
    fn cut_start(&self, root: ScriptNodeId, shader: &mut Embedded) {
        let tree = self.texts.tree;
        let Some(callee) = tree.child(root, 0) else {
            return;
        };
        let first = tree.child(root, 1).and_then(|id| tree.node(id));
        let first = first.and_then(|node| self.text.get(node.span.clone()));
        match (tree.last_name(self.text, callee), first) {
            (Some("trim" | "trimStart" | "trimLeft"), _) => shader.trim_start(),
            (Some("slice" | "substring" | "substr"), Some("1"))
                if shader.code.starts_with(['\n', ' ']) =>
            {
                shader.cut(1);
            }
            _ => {}
        }
    }
}

/// Whether a text is a shader, or a shader fragment that can be checked.
fn is_taken(code: &str, context: &LiteralContext, is_named: bool) -> bool {
    // A search pattern or a replacement.
    if context.is_introduced {
        return true;
    }
    if context.is_pattern && !is_balanced(code) {
        return false;
    }
    let scanned = Scanned::of(code);
    let is_part = || scanned.chunk() != Chunk::No;
    if context.is_message || scanned.is_bare() || context.is_pattern && !is_part() {
        return false;
    }
    if scanned.is_shader() {
        return true;
    }
    is_balanced(code)
        && match scanned.chunk() {
            Chunk::Clear => true,
            Chunk::Likely => context.names_shader || is_named,
            Chunk::No => false,
        }
}

/// Whether all brackets match.
fn is_balanced(code: &str) -> bool {
    let count = |open: char, close: char| {
        let mut depth = 0_i32;
        for c in code.chars() {
            depth += i32::from(c == open) - i32::from(c == close);
            if depth < 0 {
                return false;
            }
        }
        depth == 0
    };
    count('{', '}') && count('(', ')')
}

#[cfg(test)]
mod tests {
    use super::super::embedded::NoModules;
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &[&str]) {
        let mut found = Vec::new();
        extract(text, 0, false, &NoModules, &mut found);
        for shader in &found {
            assert!(text.get(shader.start..shader.end()).is_some());
        }
        let codes: Vec<&str> = found.iter().map(|s| s.code.as_str()).collect();
        assert_eq!(codes, expected);
    }

    #[test]
    fn literals_with_shaders_are_found() {
        check(
            "const a = `#version 300 es\nx`, b = 'void 0';",
            &["#version 300 es\nx"],
        );
        check(
            "f(glsl`float f();`, /* glsl */ `x`, /*no*/`y`)",
            &["float f();", "x"],
        );
        check(
            "s = 'void  main ( ) {}'; t = \"void mainly()\"",
            &["void  main ( ) {}"],
        );
    }

    #[test]
    fn concatenated_literals_are_joined() {
        check(
            "s = 'void main() {\\n' +\n 'x;' + // it's\n '}';",
            &["void main() {\n       x;              }"],
        );
        check(
            "s = ['void main() {', '}'].join('\\n');",
            &["void main() {\n   }"],
        );
        check(
            "s = 'void main() {' + f(1) + '}';",
            &["void main() {            }"],
        );
    }

    #[test]
    fn decoded_escapes_keep_their_width() {
        check(
            r"s = 'void main() { \
}\t\x41\\\n';",
            &["void main() {   }     A \\\n "],
        );
    }

    #[test]
    fn holes_become_names_numbers_or_nothing() {
        check(
            "s = `void main() {\n${a}\nx = ${b};y = ${c}.0; z = vec${d}(1);}`",
            &["void main() {\n    \nx = hhhh;y = 1111.0; z = vechhh1(1);}"],
        );
    }

    #[test]
    fn interpolated_constants_are_inserted_and_other_values_are_holes() {
        let holes = |text: &str| {
            let mut found = Vec::new();
            extract(text, 0, false, &NoModules, &mut found);
            found.iter().map(|s| s.has_holes).collect::<Vec<_>>()
        };
        let sum = "const N = { max: 4 }; const s = `float a[${N.max + 1}]; void main() {}`;";
        check(sum, &["float a[5           ]; void main() {}"]);
        let constant = "const PR = 'highp'; const s = `precision ${PR} float; void main() {}`;";
        check(constant, &["precision highp float; void main() {}"]);
        assert_eq!(holes(constant), [false]);
        assert_eq!(holes("s = 'void main() {}' + x;"), [true]);
        assert_eq!(holes("s = x + /* glsl */ 'void main() {}';"), [true]);
        assert_eq!(holes("let s = 'void main() {'; s += x;"), [true]);
        assert_eq!(holes("s.replace(a, /* glsl */ 'void main() { b;')"), [true]);
        assert_eq!(holes("s = 'float a = {{ b }}; void main() {}'"), [true]);
        check(
            "s = 'float a[' + n + ']; void main() {}'.concat(b, 'float c;')",
            &["float a[hhhhhhhhh]; void main() {}             float c;"],
        );
        check(
            "s = ['void main() {', a ? 'b' : '', '}'].filter(c).join('\\n')",
            &["void main() {\n                \n}"],
        );
    }

    #[test]
    fn literals_without_shaders_are_skipped() {
        check("s.replace('void main() {', 'void main() {\\n x;')", &[]);
        check("if (s === '#version 300 es') {}", &[]);
        check("s = '#version 300 es\\n' + x;", &[]);
        check("throw new Error('no void main() { in it')", &[]);
        check("const a = 'float f(float b) { return b; }';", &[]);
        let part = "float f(float b) { return b; }";
        check(&format!("const aFrag = '{part}';"), &[part]);
        let clear = "vec3 f(vec2 b) { return vec3(b, 1.); }";
        check(&format!("a('{clear}');"), &[clear]);
    }

    #[test]
    fn text_that_the_script_trims_is_trimmed() {
        check("s = `\n#version 300 es\nx`.trim()", &["#version 300 es\nx"]);
        check(
            "s = `\n#version 300 es\nx`.slice(1)",
            &["#version 300 es\nx"],
        );
        check("s = `\n#version 300 es\nx`", &["\n#version 300 es\nx"]);
    }
}
