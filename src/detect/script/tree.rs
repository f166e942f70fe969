//! The expressions of a script, as far as they say where a text comes from and where it goes.

use std::collections::HashMap;
use std::ops::Range;

/// Index of a node in [`ScriptTree::nodes`].
pub type ScriptNodeId = usize;

/// The expressions of a script. Ranges are offsets in its text.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct ScriptTree {
    /// The nodes in source order of their starts; a node comes before its children.
    pub nodes: Vec<ScriptNode>,
    /// What names refer to.
    pub bindings: Vec<ScriptBinding>,
    /// The comments in order.
    pub comments: Vec<Range<usize>>,
    /// By exported name, `default` for the default export: the name of the script or its value.
    pub exports: HashMap<String, Export>,
    /// The modules whose exports are all exported.
    pub passed_on: Vec<String>,
    /// By name: its bindings.
    pub(super) by_name: HashMap<String, Vec<usize>>,
}

/// A node.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScriptNode {
    /// What it is.
    pub kind: NodeKind,
    /// Its text; of a string or template only the contents.
    pub span: Range<usize>,
    /// The node that contains it.
    pub parent: Option<ScriptNodeId>,
    /// The nodes in it, in source order.
    pub children: Vec<ScriptNodeId>,
}

impl ScriptNode {
    /// Whether it is a literal without `${...}`.
    pub fn is_constant(&self) -> bool {
        match &self.kind {
            NodeKind::Text => true,
            NodeKind::Template(holes) => holes.is_empty(),
            _ => false,
        }
    }
}

/// What a node is. Ranges are those of names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum NodeKind {
    /// A string.
    Text,
    /// A template with the ranges of its `${...}`; the children are their expressions.
    Template(Vec<Range<usize>>),
    /// A number.
    Number,
    /// A name that refers to a binding.
    Name,
    /// `object.name`; the child is the object.
    Member(Range<usize>),
    /// `object[index]`; the children are both.
    Index,
    /// A call; the first child is the callee.
    Call,
    /// `new f(...)`; the first child is the callee.
    New,
    /// A template with a tag; the children are both.
    Tagged,
    /// An object; the children are properties.
    Object,
    /// A property of an object or class with its name; the child is the value.
    Property(Range<usize>),
    /// `...x`
    Spread,
    /// An array.
    Array,
    /// `a + b`
    Sum,
    /// A comparison.
    Comparison,
    /// `a ? b : c`, `a || b`: the children are the alternatives.
    Choice,
    /// `a = b`, or `a += b` if the flag is set; the children are both sides.
    Assignment(bool),
    /// A declared variable; the child is its value.
    Variable(Range<usize>),
    /// A function.
    Function,
    /// A class with the text of the class that it extends.
    Class(Range<usize>),
    /// The result of a function.
    Return,
    /// An element of JSX.
    Element(Range<usize>),
    /// An attribute of an element; the child is its value.
    Attribute(Range<usize>),
    /// `throw x`, which no name receives.
    Throw,
    /// Anything else that contains expressions.
    Other,
}

/// A name that is declared.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ScriptBinding {
    /// The name.
    pub name: Range<usize>,
    /// Where it is visible.
    pub scope: Range<usize>,
    /// What it refers to.
    pub value: BindingValue,
}

/// What a name refers to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BindingValue {
    /// This expression.
    Node(ScriptNodeId),
    /// An export of another module: its path and the exported name, `*` for all.
    Import(String, String),
    /// Something else.
    Unknown,
}

/// What a script exports under a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Export {
    /// The value of a name of the script.
    Name(Range<usize>),
    /// The value of an expression.
    Node(ScriptNodeId),
    /// The export of another module: its path and the name there.
    Other(String, String),
}

impl ScriptTree {
    /// Prepares [`ScriptTree::binding`].
    pub(super) fn index_names(&mut self, text: &str) {
        for (index, binding) in self.bindings.iter().enumerate() {
            let name = text.get(binding.name.clone()).unwrap_or("");
            self.by_name
                .entry(name.to_string())
                .or_default()
                .push(index);
        }
    }

    /// The innermost binding of a name that is visible at an offset; `None` if two are.
    pub fn binding(&self, name: &str, at: usize) -> Option<&ScriptBinding> {
        /// Maximum number of bindings of a name that are compared.
        const MAX_BINDINGS: usize = 64;
        let all = self.by_name.get(name)?.iter().take(MAX_BINDINGS);
        let all = all.filter_map(|index| self.bindings.get(*index));
        let visible: Vec<&ScriptBinding> = all.filter(|b| b.scope.contains(&at)).collect();
        let inner = visible.iter().map(|b| b.scope.len()).min()?;
        let mut inner = visible.into_iter().filter(|b| b.scope.len() == inner);
        inner.next().filter(|_| inner.next().is_none())
    }

    /// A node.
    pub fn node(&self, id: ScriptNodeId) -> Option<&ScriptNode> {
        self.nodes.get(id)
    }

    /// The child of a node with this index.
    pub fn child(&self, id: ScriptNodeId, index: usize) -> Option<ScriptNodeId> {
        self.nodes.get(id)?.children.get(index).copied()
    }

    /// The nodes that contain a node, the innermost first.
    pub fn above(&self, id: ScriptNodeId) -> impl Iterator<Item = ScriptNodeId> {
        std::iter::successors(self.nodes.get(id).and_then(|n| n.parent), |id| {
            self.nodes.get(*id).and_then(|n| n.parent)
        })
    }

    /// The last name of a callee or of another expression: `c` of `a.b.c`. For `super` that of the class.
    pub fn last_name<'t>(&self, text: &'t str, id: ScriptNodeId) -> Option<&'t str> {
        let node = self.nodes.get(id)?;
        match &node.kind {
            NodeKind::Name => text.get(node.span.clone()),
            NodeKind::Member(name) => text.get(name.clone()),
            NodeKind::Other if text.get(node.span.clone()) == Some("super") => {
                let extended =
                    self.above(id)
                        .find_map(|above| match &self.nodes.get(above)?.kind {
                            NodeKind::Class(extended) => text.get(extended.clone()),
                            _ => None,
                        });
                extended?.rsplit('.').next()
            }
            _ => None,
        }
    }
}
