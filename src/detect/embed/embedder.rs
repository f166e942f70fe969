//! What a page or script does with its shaders.

use super::DocumentLanguage;
use super::together::scripts;
use crate::script::parse;
use crate::script::tree::{BindingValue, NodeKind, ScriptNode, ScriptNodeId, ScriptTree};

/// What a file does with its shaders.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Embedder {
    /// It compiles shaders itself, without a library.
    pub hands_over: bool,
    /// It puts other texts of its own before or after what a function compiles.
    pub joins: bool,
    /// What it does with leading white space of shaders.
    pub leading_blanks: LeadingBlanks,
}

impl Embedder {
    /// Analyses a page or script.
    pub fn of(language: DocumentLanguage, text: &str) -> Embedder {
        let mut found = Embedder::default();
        let mut trims = false;
        let calls = ["shaderSource", "trim", "replace"];
        if !calls.iter().any(|name| text.contains(name)) {
            return found;
        }
        for script in scripts(language, text) {
            let text = text.get(script).unwrap_or("");
            let tree = parse(text);
            for node in tree.nodes.iter().filter(|node| node.kind == NodeKind::Call) {
                let mut parts = node.children.iter();
                let callee = parts.next().and_then(|id| tree.last_name(text, *id));
                let first = parts.next().and_then(|id| tree.node(*id));
                let first = first.and_then(|first| text.get(first.span.clone()));
                match (callee, first) {
                    (Some("shaderSource"), _) => found.compiles(text, &tree, node.children.get(2)),
                    (Some("trim" | "trimStart" | "trimLeft"), None) => trims = true,
                    (Some("replace"), Some(pattern)) => {
                        let starts = ["/^\\s", "/^[\\s", "/^\\n", "/^[\\n"];
                        trims |= starts.iter().any(|start| pattern.starts_with(start));
                    }
                    _ => {}
                }
            }
        }
        found.leading_blanks = match (trims, found.hands_over) {
            (true, _) => LeadingBlanks::Trimmed,
            (false, true) => LeadingBlanks::Kept,
            (false, false) => LeadingBlanks::Unknown,
        };
        found
    }

    /// Reads what the script compiles: a text, or a sum of a text that it does not know with others.
    fn compiles(&mut self, text: &str, tree: &ScriptTree, compiled: Option<&ScriptNodeId>) {
        let sum = compiled.and_then(|id| sum(text, tree, *id));
        let Some(sum) = sum else {
            self.hands_over = true;
            return;
        };
        let binding = |part: &ScriptNode| {
            let name = text
                .get(part.span.clone())
                .filter(|_| part.kind == NodeKind::Name);
            name.and_then(|name| tree.binding(name, part.span.start))
        };
        let parts: Vec<&ScriptNode> = sum
            .children
            .iter()
            .filter_map(|id| tree.node(*id))
            .collect();
        let is_known = |part: &&ScriptNode| match binding(part).map(|b| &b.value) {
            None => part.is_constant(),
            Some(value) => !matches!(value, BindingValue::Import(..)),
        };
        let is_given =
            |part: &&ScriptNode| binding(part).is_some_and(|b| b.value == BindingValue::Unknown);
        self.hands_over |= parts.iter().all(is_known);
        self.joins |= parts.iter().any(is_given);
    }
}

/// The sum or template that is the value of an expression, perhaps through a name.
fn sum<'t>(text: &str, tree: &'t ScriptTree, id: ScriptNodeId) -> Option<&'t ScriptNode> {
    let node = tree.node(id)?;
    let is_sum = |node: &&ScriptNode| match &node.kind {
        NodeKind::Template(_) => !node.is_constant(),
        kind => *kind == NodeKind::Sum,
    };
    let name = text.get(node.span.clone())?;
    let assigned = || {
        let assignments = tree.nodes.iter();
        let assignments = assignments.filter(|n| matches!(n.kind, NodeKind::Assignment(_)));
        let mut values = assignments.filter_map(|assignment| {
            let [target, value] = assignment.children[..] else {
                return None;
            };
            let target = tree.node(target)?;
            let is_own = text.get(target.span.clone()) == Some(name);
            tree.node(value).filter(|_| is_own)
        });
        values.find(is_sum)
    };
    let named = || match tree.binding(name, node.span.start)?.value {
        BindingValue::Node(value) => tree.node(value).filter(is_sum),
        _ => assigned(),
    };
    Some(node).filter(is_sum).or_else(named)
}

/// What happens to leading white space before the shader is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum LeadingBlanks {
    /// Unknown, because other code compiles the shader.
    #[default]
    Unknown,
    /// Removed.
    Trimmed,
    /// Kept.
    Kept,
}
