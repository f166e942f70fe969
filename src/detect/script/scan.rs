//! The literals of a script that cannot be parsed, each with the name before it, and the calls.

use super::token::{ScriptToken, ScriptTokenKind, is_mark, tokens};
use super::tree::{NodeKind, ScriptNode, ScriptNodeId, ScriptTree};

/// Finds the literals of a script up to the first that is not closed.
pub fn scan(text: &str) -> ScriptTree {
    let all = tokens(text);
    let mut tree = ScriptTree::default();
    for (at, token) in all.iter().enumerate() {
        let kind = match &token.kind {
            ScriptTokenKind::Quoted => NodeKind::Text,
            ScriptTokenKind::Template(holes) => NodeKind::Template(holes.clone()),
            ScriptTokenKind::Comment => {
                tree.comments.push(token.range.clone());
                continue;
            }
            ScriptTokenKind::Mark(b'(') => {
                let callee = at.checked_sub(1).and_then(|at| all.get(at));
                if let Some(callee) = callee.filter(|t| t.kind == ScriptTokenKind::Word) {
                    let call = add(&mut tree, NodeKind::Call, callee, None);
                    add(&mut tree, NodeKind::Name, callee, Some(call));
                }
                continue;
            }
            _ => continue,
        };
        let parent = receiver(&mut tree, text, &all, at);
        add(&mut tree, kind, token, parent);
    }
    tree
}

/// Adds the construct that receives the literal at an index: a variable, a property, a tag or a call.
fn receiver(
    tree: &mut ScriptTree,
    text: &str,
    tokens: &[ScriptToken],
    literal: usize,
) -> Option<ScriptNodeId> {
    let before = |back: usize| literal.checked_sub(back);
    let word = |back: usize| {
        let token = tokens.get(before(back)?)?;
        let is_word = token.kind == ScriptTokenKind::Word;
        is_word.then_some(token)
    };
    let mark = |back: usize, mark: u8| before(back).is_some_and(|at| is_mark(tokens, at, mark));
    let touches = |token: &ScriptToken| {
        tokens
            .get(literal)
            .is_some_and(|t| t.range.start == token.range.end + 1)
    };
    if let Some(tag) = word(1).filter(|token| touches(token)) {
        let id = add(tree, NodeKind::Tagged, tag, None);
        add(tree, NodeKind::Name, tag, Some(id));
        return Some(id);
    }
    let key = before(2).and_then(|at| tokens.get(at));
    if let Some(key) = key.filter(|key| mark(1, b':') && key.kind != ScriptTokenKind::Comment) {
        return Some(add(tree, NodeKind::Property(key.range.clone()), key, None));
    }
    let name = word(2)?;
    if mark(1, b'=') && text.get(name.range.clone()).is_some() {
        return Some(add(
            tree,
            NodeKind::Variable(name.range.clone()),
            name,
            None,
        ));
    }
    if mark(1, b'(') {
        return tree.nodes.last().and_then(|callee| callee.parent);
    }
    None
}

fn add(
    tree: &mut ScriptTree,
    kind: NodeKind,
    token: &ScriptToken,
    parent: Option<ScriptNodeId>,
) -> ScriptNodeId {
    let id = tree.nodes.len();
    tree.nodes.push(ScriptNode {
        kind,
        span: token.range.clone(),
        parent,
        children: Vec::new(),
    });
    if let Some(parent) = parent.and_then(|p| tree.nodes.get_mut(p)) {
        parent.children.push(id);
    }
    id
}
