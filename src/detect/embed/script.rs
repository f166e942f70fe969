//! Shaders in string literals of a script.

use super::context::LiteralContext;
use super::embedded::{Embedded, ImportedTexts, InsertedPart, Wrapping, joined};
use super::holes::mask;
use super::receiver::{ReceiverReader, ShaderReceiver};
use super::text::{ScriptText, Texts};
use crate::kind::{Chunk, Scanned, chunks, has_main, may_be_shader};
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
        let chunks = match code.has_holes || !code.inserted.is_empty() {
            true => Vec::new(),
            false => chunks(&code.code),
        };
        match chunks.is_empty() {
            true => found.extend(script.shader(root, code, &context, wrapping)),
            false => found.extend(chunks.into_iter().map(|chunk| Embedded {
                start: code.start + chunk.start,
                wrapping,
                ..Embedded::from(chunk)
            })),
        }
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
        context.is_introduced
            || context.names_shader
            || may_be_shader(code)
            || self.texts.joins(root, has_main)
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
        // A macro for a shader may be an expression.
        if !all.contains([';', '{', '#', '\n']) || !is_taken(&all, context, self.is_named) {
            return None;
        }
        let masked = mask(&code.code);
        let grows = context
            .target
            .as_deref()
            .is_some_and(|t| self.texts.grows(t));
        let mut shader = Embedded {
            has_holes: code.has_holes || masked.is_some() || context.is_pattern || grows,
            inserted: code.inserted,
            stage: context.stage,
            receivers: self.receivers.of_text(root),
            ..Embedded::new(code.start, masked.unwrap_or(code.code), wrapping)
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
