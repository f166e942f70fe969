//! What a script hands its shaders to: `new ShaderMaterial({ fragmentShader })`.

use crate::script::tree::{BindingValue, Export, NodeKind, ScriptNodeId, ScriptTree};
use std::cell::OnceCell;
use std::collections::HashMap;

/// A function, class or element that receives a shader.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ShaderReceiver {
    /// The last part of its name.
    pub name: String,
    /// The properties next to the shader: their names, and the texts of their values or the last parts of
    /// the names that they have.
    pub beside: Vec<(String, String)>,
}

/// Follows expressions of a script to what receives them.
pub struct ReceiverReader<'t> {
    text: &'t str,
    tree: &'t ScriptTree,
    /// Where each name is used; computed on first use.
    uses: OnceCell<HashMap<&'t str, Vec<ScriptNodeId>>>,
}

impl<'t> ReceiverReader<'t> {
    /// For a script.
    pub fn new(text: &'t str, tree: &'t ScriptTree) -> ReceiverReader<'t> {
        ReceiverReader {
            text,
            tree,
            uses: OnceCell::new(),
        }
    }

    /// What receives the text of an expression, directly or through a constant; empty if it goes elsewhere, too.
    pub fn of_text(&self, root: ScriptNodeId) -> Vec<ShaderReceiver> {
        let parent = self.tree.above(root).next();
        let all = match parent.and_then(|id| self.tree.node(id)).map(|n| &n.kind) {
            Some(NodeKind::Variable(name)) => {
                let name = self.text.get(name.clone()).unwrap_or("");
                let is_it = |id: &&ScriptNodeId| {
                    let at = self.tree.node(**id).map_or(0, |n| n.span.start);
                    let binding = self.tree.binding(name, at);
                    binding.is_some_and(|b| b.value == BindingValue::Node(root))
                };
                let is_exported = |export: &Export| match export {
                    Export::Name(exported) => self.text.get(exported.clone()) == Some(name),
                    _ => false,
                };
                match self.tree.exports.values().any(is_exported) {
                    true => None,
                    false => {
                        let uses = self.uses().get(name).map_or(&[][..], Vec::as_slice);
                        uses.iter().filter(is_it).map(|id| self.of(*id)).collect()
                    }
                }
            }
            _ => self.of(root).map(|one| vec![one]),
        };
        all.unwrap_or_default()
    }

    /// What an expression is handed to; `None` if it is changed first, or goes elsewhere.
    pub fn of(&self, id: ScriptNodeId) -> Option<ShaderReceiver> {
        let mut from = id;
        let mut beside = Vec::new();
        let named = |name: &str, beside| {
            let name = name.to_string();
            Some(ShaderReceiver { name, beside })
        };
        for above in self.tree.above(id) {
            let node = self.tree.node(above)?;
            match &node.kind {
                NodeKind::Call | NodeKind::New if node.children.first() != Some(&from) => {
                    let name = self.tree.last_name(self.text, *node.children.first()?)?;
                    return named(name, beside);
                }
                NodeKind::Element(name) => return named(self.text.get(name.clone())?, beside),
                NodeKind::Object => {
                    beside.extend(node.children.iter().filter_map(|p| self.property(*p)));
                }
                NodeKind::Property(_)
                | NodeKind::Array
                | NodeKind::Attribute(_)
                | NodeKind::Choice => {}
                _ => return None,
            }
            from = above;
        }
        None
    }

    /// The name and value of a property.
    fn property(&self, id: ScriptNodeId) -> Option<(String, String)> {
        let NodeKind::Property(name) = &self.tree.node(id)?.kind else {
            return None;
        };
        let value = self.tree.child(id, 0)?;
        let text = || self.text.get(self.tree.node(value)?.span.clone());
        let value = match self.tree.node(value)?.kind {
            NodeKind::Text => text(),
            _ => self.tree.last_name(self.text, value),
        };
        Some((
            self.text.get(name.clone())?.to_string(),
            value.unwrap_or("").to_string(),
        ))
    }

    fn uses(&self) -> &HashMap<&'t str, Vec<ScriptNodeId>> {
        self.uses.get_or_init(|| {
            let mut all: HashMap<&str, Vec<ScriptNodeId>> = HashMap::new();
            for (id, node) in self.tree.nodes.iter().enumerate() {
                if node.kind == NodeKind::Name {
                    let name = self.text.get(node.span.clone()).unwrap_or("");
                    all.entry(name).or_default().push(id);
                }
            }
            all
        })
    }
}
