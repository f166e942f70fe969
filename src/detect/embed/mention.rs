//! Where scripts refer to a name of a shader: in `getUniformLocation(program, "name")`, in
//! `uniforms: { name: ... }`, in `source.replace("name", ...)`.

use super::DocumentLanguage;
use super::together::scripts;
use crate::kind::has_main;
use crate::script::parse;
use crate::script::tree::{NodeKind, ScriptNodeId, ScriptTree};
use std::ops::Range;

/// What scripts use a name for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NameRole {
    /// An input of a program: scripts set it by name.
    Input,
    /// Any other name: scripts know it only where they edit the text of a shader.
    Inner,
}

/// A place where a script refers to a name, or may do so.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mention {
    /// Range of the name in the file.
    pub range: Range<usize>,
    /// How it refers to the name.
    pub kind: MentionKind,
}

/// How a script refers to a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MentionKind {
    /// By the name alone.
    Name,
    /// By a property that also names a variable of the script: `uniforms: { name }`.
    Shorthand,
    /// In a text that it searches or changes: `source.replace("name", ...)`.
    Edited,
    /// It may also be something else with the same name.
    Unclear,
}

/// The places where the scripts of a file refer to a name.
pub fn mentions(
    language: DocumentLanguage,
    text: &str,
    name: &str,
    role: NameRole,
) -> Vec<Mention> {
    let mut found = Vec::new();
    if name.is_empty() {
        return found;
    }
    for script in scripts(language, text) {
        let content = text.get(script.clone()).unwrap_or("");
        let mut reader = MentionReader {
            text: content,
            tree: &parse(content),
            base: script.start,
            name,
            role,
            found: &mut found,
        };
        (0..reader.tree.nodes.len()).for_each(|id| reader.node(id));
    }
    found.sort_by_key(|mention| mention.range.start);
    found
}

struct MentionReader<'t, 'f> {
    text: &'t str,
    tree: &'t ScriptTree,
    base: usize,
    name: &'t str,
    role: NameRole,
    found: &'f mut Vec<Mention>,
}

impl<'t> MentionReader<'t, '_> {
    fn word(&self, range: &Range<usize>) -> &'t str {
        self.text.get(range.clone()).unwrap_or("")
    }

    /// Whether the last name of an expression says that it is about inputs of a program.
    fn is_about_inputs(&self, id: Option<ScriptNodeId>) -> bool {
        let name = id.and_then(|id| self.tree.last_name(self.text, id));
        name.is_some_and(is_about_inputs)
    }

    fn add(&mut self, range: Range<usize>, clear: Option<MentionKind>) {
        let kind = clear.unwrap_or(MentionKind::Unclear);
        let range = range.start + self.base..range.end + self.base;
        self.found.push(Mention { range, kind });
    }

    fn node(&mut self, id: ScriptNodeId) {
        let Some(node) = self.tree.node(id) else {
            return;
        };
        let is_named = |name| self.role == NameRole::Input && self.word(name) == self.name;
        match &node.kind {
            NodeKind::Text => self.string(id, &node.span, &[]),
            NodeKind::Template(holes) => self.string(id, &node.span, holes),
            // A regular expression.
            NodeKind::Other if self.word(&node.span).starts_with('/') => {
                self.edited(id, &node.span, &[]);
            }
            NodeKind::Member(name) if is_named(name) => {
                let is_clear = self.is_about_inputs(self.tree.child(id, 0));
                self.add(name.clone(), is_clear.then_some(MentionKind::Name));
            }
            NodeKind::Property(name) if is_named(name) => {
                let of_inputs = node.parent.is_some_and(|object| self.holds_inputs(object));
                self.add(name.clone(), of_inputs.then_some(MentionKind::Name));
                let value = self
                    .tree
                    .child(id, 0)
                    .and_then(|value| self.tree.node(value));
                let is_shorthand = value.is_some_and(|value| value.span == *name);
                if let Some(last) = self.found.last_mut().filter(|_| of_inputs && is_shorthand) {
                    last.kind = MentionKind::Shorthand;
                }
            }
            _ => {}
        }
    }

    /// Whether an object is that of uniforms or attributes: `uniforms: { ... }`.
    fn holds_inputs(&self, object: ScriptNodeId) -> bool {
        let object = self.tree.node(object);
        let object = object.filter(|node| node.kind == NodeKind::Object);
        let parent = object.and_then(|node| node.parent);
        match parent.and_then(|id| Some((id, &self.tree.node(id)?.kind))) {
            Some((
                _,
                NodeKind::Property(name) | NodeKind::Variable(name) | NodeKind::Attribute(name),
            )) => is_about_inputs(self.word(name)),
            Some((id, NodeKind::Assignment(_))) => self.is_about_inputs(self.tree.child(id, 0)),
            // `shaderMaterial({ name: 1 }, vertexShader, fragmentShader)`
            Some((id, NodeKind::Call | NodeKind::New)) => {
                let all = self.tree.node(id).map_or(&[][..], |node| &node.children);
                let mut all = all.iter().filter_map(|id| self.tree.node(*id));
                all.any(|node| {
                    let is_text = matches!(node.kind, NodeKind::Text | NodeKind::Template(_));
                    is_text && has_main(self.word(&node.span))
                })
            }
            _ => false,
        }
    }

    /// What a string is handed to or looked up in, and whether it is handed: a list of names is like a name.
    fn receiver(&self, id: ScriptNodeId) -> Option<(ScriptNodeId, bool)> {
        let mut from = id;
        for above in self.tree.above(id) {
            let node = self.tree.node(above)?;
            match node.kind {
                NodeKind::Call | NodeKind::New | NodeKind::Index => {
                    let is_call = node.kind != NodeKind::Index;
                    let callee = node.children.first().filter(|first| **first != from);
                    return callee.map(|callee| (*callee, is_call));
                }
                NodeKind::Array | NodeKind::Sum | NodeKind::Choice => from = above,
                _ => return None,
            }
        }
        None
    }

    /// Whether a function that searches or changes text is called with a node, perhaps indirectly.
    fn is_edited(&self, id: ScriptNodeId) -> bool {
        let mut from = id;
        self.tree.above(id).any(|above| {
            let inner = std::mem::replace(&mut from, above);
            let callee = self.tree.child(above, 0).filter(|first| *first != inner);
            let is_call = self
                .tree
                .node(above)
                .is_some_and(|node| matches!(node.kind, NodeKind::Call | NodeKind::New));
            let name = callee.and_then(|callee| self.tree.last_name(self.text, callee));
            is_call && name.is_some_and(|name| EDITORS.contains(&name))
        })
    }

    /// Whether people read a string: `{ label: 'speed' }`, `folder.add(speed, 'value').name('speed')`.
    fn is_label(&self, id: ScriptNodeId, receiver: Option<(ScriptNodeId, bool)>) -> bool {
        let parent = self.tree.node(id).and_then(|node| node.parent);
        let key = match parent.and_then(|id| self.tree.node(id)).map(|n| &n.kind) {
            Some(NodeKind::Property(name)) => self.word(name),
            _ => "",
        };
        let called = receiver.filter(|(_, is_call)| *is_call);
        let called = called.and_then(|(of, _)| self.tree.last_name(self.text, of));
        matches!(key, "label" | "title") || called == Some("name")
    }

    /// A string or template with the ranges of its `${...}`.
    fn string(&mut self, id: ScriptNodeId, span: &Range<usize>, holes: &[Range<usize>]) {
        let rest = self.word(span).strip_prefix(self.name);
        // `lights[0].color` refers to `lights`.
        let is_whole = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']));
        if !is_whole || self.is_edited(id) {
            return self.edited(id, span, holes);
        }
        let receiver = self.receiver(id);
        let is_clear = receiver.is_some_and(|(of, _)| self.is_about_inputs(Some(of)));
        if self.is_label(id, receiver) {
            return;
        }
        if self.role == NameRole::Input || is_clear && receiver.is_some_and(|(_, calls)| calls) {
            let range = span.start..span.start + self.name.len();
            self.add(range, is_clear.then_some(MentionKind::Name));
        }
    }

    /// A text that contains the name: a part of a shader, or a pattern for it.
    fn edited(&mut self, id: ScriptNodeId, span: &Range<usize>, holes: &[Range<usize>]) {
        let text = self.word(span);
        let is_code = text.contains([';', '{', '(', '=']);
        if !text.contains(self.name) || !is_code && !self.is_edited(id) {
            return;
        }
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
        for (start, _) in text.match_indices(self.name) {
            let end = start + self.name.len();
            let before = text.get(..start).and_then(|t| t.chars().next_back());
            let after = text.get(end..).and_then(|t| t.chars().next());
            // In `\bname\b`, the letter before belongs to the escape.
            let is_escape = text.get(..start).is_some_and(|t| t.ends_with("\\b"));
            let is_whole = is_escape || !before.is_some_and(is_word) && !after.is_some_and(is_word);
            let at = span.start + start;
            // What is inserted is an expression of the script.
            if is_whole && !holes.iter().any(|hole| hole.contains(&at)) {
                let is_edited = self.is_edited(id);
                self.add(
                    at..at + self.name.len(),
                    is_edited.then_some(MentionKind::Edited),
                );
            }
        }
    }
}

/// The functions that search or change text.
const EDITORS: [&str; 7] = [
    "replace",
    "replaceAll",
    "split",
    "includes",
    "indexOf",
    "match",
    "RegExp",
];

/// Whether a name of a script says that something is about inputs or outputs of a program.
fn is_about_inputs(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    ["uniform", "attrib", "varying"]
        .iter()
        .any(|part| word.contains(part))
}
