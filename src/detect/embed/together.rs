//! How a script uses its shaders: which ones it combines to a program, of which texts it makes one, as in
//! `load("common.frag") + load("own.frag")`, and which uniforms it sets.

use super::DocumentLanguage;
use super::embedded::Embedded;
use super::html;
use crate::script::parse;
use crate::script::token::{ScriptTokenKind, tokens};
use crate::script::tree::{BindingValue, NodeKind, ScriptNode, ScriptNodeId, ScriptTree};
use std::collections::HashMap;
use std::ops::Range;

/// Maximum number of shaders in one expression.
const MAX_GROUP: usize = 8;
/// Maximum number of expressions that lead from one to the next.
const MAX_NAMES: usize = 8;

/// The shaders that occur together in an expression of a script: a call, an object, a function. Indices
/// refer to `all`.
pub fn together(language: DocumentLanguage, text: &str, all: &[Embedded]) -> Vec<Vec<usize>> {
    let mut groups = Vec::new();
    for script in scripts(language, text) {
        let content = text.get(script.clone()).unwrap_or("");
        let tree = parse(content);
        let mut names = ShaderNames {
            text: content,
            base: script.start,
            tree: &tree,
            all,
            named: HashMap::new(),
        };
        for (index, shader) in all.iter().enumerate() {
            if let Some(id) = html::id_of(text, shader) {
                names.add(id, index);
            }
        }
        names.add_variables();
        names.groups(&mut groups);
    }
    groups.sort();
    groups.dedup();
    groups
}

/// The scripts in a file.
pub fn scripts(language: DocumentLanguage, text: &str) -> Vec<Range<usize>> {
    match language {
        DocumentLanguage::Script => std::iter::once(0..text.len()).collect(),
        DocumentLanguage::Markdown | DocumentLanguage::Kdl => Vec::new(),
        _ => html::scripts(text),
    }
}

/// The contents of quoted strings in the scripts of a file.
pub fn strings(language: DocumentLanguage, text: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for script in scripts(language, text) {
        let read = tokens(text.get(script.clone()).unwrap_or("")).into_iter();
        let quoted = read.filter(|t| t.kind == ScriptTokenKind::Quoted);
        found.extend(quoted.map(|t| script.start + t.range.start..script.start + t.range.end));
    }
    found
}

/// The names of shaders in a script.
struct ShaderNames<'a> {
    text: &'a str,
    base: usize,
    tree: &'a ScriptTree,
    all: &'a [Embedded],
    /// By variable, or by `id` of an element: the shader; `None` if several have the same name.
    named: HashMap<&'a str, Option<usize>>,
}

impl<'a> ShaderNames<'a> {
    fn add(&mut self, name: &'a str, index: usize) {
        let known = self.named.entry(name).or_insert(Some(index));
        if *known != Some(index) {
            *known = None;
        }
    }

    /// Adds the variables that a shader initialises: `const NAME = glsl\`...\``.
    fn add_variables(&mut self) {
        for node in &self.tree.nodes {
            if let NodeKind::Variable(name) = &node.kind
                && let Some(index) = node.children.first().and_then(|id| self.started(*id))
            {
                self.add(self.text.get(name.clone()).unwrap_or(""), index);
            }
        }
    }

    /// The shader that an expression starts with.
    fn started(&self, id: ScriptNodeId) -> Option<usize> {
        let node = self.tree.node(id)?;
        let inner = match node.kind {
            NodeKind::Text | NodeKind::Template(_) => return self.literal(node),
            NodeKind::Tagged => 1,
            NodeKind::Sum | NodeKind::Array | NodeKind::Member(_) | NodeKind::Call => 0,
            _ => return None,
        };
        self.started(*node.children.get(inner)?)
    }

    /// The shader that starts in a literal.
    fn literal(&self, node: &ScriptNode) -> Option<usize> {
        let (start, end) = (node.span.start + self.base, node.span.end + self.base);
        let index = self.all.partition_point(|s| s.start < start);
        let shader = self.all.get(index)?;
        (shader.start <= end && end > start).then_some(index)
    }

    /// The shader that an expression denotes.
    fn meant(&self, node: &ScriptNode) -> Option<usize> {
        let name = self.text.get(node.span.clone())?;
        let named = |name| self.named.get(name).copied().flatten();
        match node.kind {
            NodeKind::Text | NodeKind::Template(_) => {
                let found = self.literal(node);
                found.or_else(|| named(name.trim_start_matches('#')))
            }
            NodeKind::Name => named(name),
            _ => None,
        }
    }

    /// Finds the shaders in each expression that combines several.
    fn groups(&self, found: &mut Vec<Vec<usize>>) {
        let mut inside: Vec<Vec<usize>> = vec![Vec::new(); self.tree.nodes.len()];
        for (id, node) in self.tree.nodes.iter().enumerate().rev() {
            // The expressions in a node come after it.
            let mut own = inside.get_mut(id).map(std::mem::take).unwrap_or_default();
            own.extend(self.meant(node));
            own.sort_unstable();
            own.dedup();
            own.truncate(MAX_GROUP + 1);
            if let Some(outer) = node.parent.and_then(|parent| inside.get_mut(parent)) {
                outer.extend(&own);
            }
            let combines = matches!(
                node.kind,
                NodeKind::Call
                    | NodeKind::New
                    | NodeKind::Object
                    | NodeKind::Array
                    | NodeKind::Function
                    | NodeKind::Element(_)
            );
            if combines && (2..=MAX_GROUP).contains(&own.len()) {
                found.push(own);
            }
        }
    }
}

/// The lists of texts in the scripts of a file. A text is given by the path that it is imported or loaded from, or
/// by the string that it is; `None` if neither is known.
pub fn lists(language: DocumentLanguage, text: &str) -> Vec<Vec<Option<String>>> {
    let mut found = Vec::new();
    for script in scripts(language, text) {
        let text = text.get(script).unwrap_or("");
        let tree = parse(text);
        let is_list = |kind| {
            matches!(
                kind,
                &NodeKind::Array | NodeKind::Sum | NodeKind::Template(_)
            )
        };
        let lists = tree.nodes.iter().filter(|node| is_list(&node.kind));
        for list in lists.filter(|list| list.children.len() > 1) {
            let texts = list.children.iter();
            found.push(texts.map(|id| source(text, &tree, *id, 0)).collect());
        }
    }
    found
}

/// The path or the string that stands for the text of an expression.
fn source(text: &str, tree: &ScriptTree, id: ScriptNodeId, depth: usize) -> Option<String> {
    let node = tree.node(id).filter(|_| depth < MAX_NAMES)?;
    let own = text.get(node.span.clone())?;
    let inner = |id: ScriptNodeId| source(text, tree, id, depth + 1);
    match &node.kind {
        _ if node.is_constant() => Some(own.to_string()),
        NodeKind::Name => match &tree.binding(own, node.span.start)?.value {
            BindingValue::Import(path, _) => Some(path.clone()),
            BindingValue::Node(value) => inner(*value),
            BindingValue::Unknown => None,
        },
        NodeKind::Sum => node.children.iter().map(|id| inner(*id)).collect(),
        // `await`
        NodeKind::Other => node.children.first().and_then(|id| inner(*id)),
        NodeKind::Call => {
            let (callee, arguments) = node.children.split_first()?;
            let paths = arguments.iter().filter_map(|id| inner(*id));
            let mut paths = paths.filter(|path| path.contains('.'));
            match (paths.next(), paths.next()) {
                (Some(path), None) => Some(path),
                // `load(path).then(...)`
                (None, _) => inner(tree.child(*callee, 0)?),
                _ => None,
            }
        }
        _ => None,
    }
}
