//! The texts that a script puts together: literals, concatenated or joined, with the values of what is
//! inserted.

use super::embedded::{ImportedTexts, InsertedPart};
use super::hole::{Hole, HoleContent};
use super::holes::fill;
use crate::kind::{Chunk, Scanned, has_main};
use crate::script::tree::{BindingValue, Export, NodeKind, ScriptNodeId, ScriptTree};
use std::cell::Cell;
use std::collections::HashSet;
use std::ops::Range;

/// Maximum number of names that lead from one to the next.
const MAX_NAMES: usize = 12;
/// Maximum number of expressions of a script that are evaluated.
const MAX_VALUES: usize = 5_000;
/// Maximum number of bytes that are inserted into the texts of a script.
const MAX_INSERTED: usize = 1 << 21;

/// A text that a script puts together.
pub struct ScriptText {
    /// Start offset in the file.
    pub start: usize,
    /// Code of the same length as in the file.
    pub code: String,
    /// What is inserted into it.
    pub inserted: Vec<InsertedPart>,
    /// Whether unknown parts are inserted at run time.
    pub has_holes: bool,
}

/// Evaluates the expressions of a script.
pub struct Texts<'s> {
    text: &'s str,
    pub tree: &'s ScriptTree,
    modules: &'s dyn ImportedTexts,
    /// Names that are assigned after their declaration.
    assigned: HashSet<&'s str>,
    /// Names to which text is appended.
    grown: HashSet<&'s str>,
    /// Number of expressions and of bytes that may still be evaluated.
    budget: Cell<(usize, usize)>,
}

/// One of the expressions whose texts are joined.
enum JoinedPart {
    Literal(ScriptNodeId),
    Other(ScriptNodeId),
    /// A separator that contains a line break.
    Line,
}

impl<'s> Texts<'s> {
    pub fn new(text: &'s str, tree: &'s ScriptTree, modules: &'s dyn ImportedTexts) -> Texts<'s> {
        let mut texts = Texts {
            text,
            tree,
            modules,
            assigned: HashSet::new(),
            grown: HashSet::new(),
            budget: Cell::new((MAX_VALUES, MAX_INSERTED)),
        };
        for node in &tree.nodes {
            let NodeKind::Assignment(adds) = node.kind else {
                continue;
            };
            let target = node.children.first().copied();
            if let Some(name) = target.and_then(|id| tree.last_name(text, id)) {
                texts.assigned.insert(name);
                if adds {
                    texts.grown.insert(name);
                }
            }
        }
        texts
    }

    /// Whether the script appends text to a name.
    pub fn grows(&self, name: &str) -> bool {
        self.grown.contains(name)
    }

    /// The outermost expression whose text a literal is a part of.
    pub fn root(&self, literal: ScriptNodeId) -> ScriptNodeId {
        let mut root = literal;
        while let Some(parent) = self.tree.node(root).and_then(|n| n.parent) {
            let next = match self.tree.node(parent).map(|n| &n.kind) {
                Some(NodeKind::Sum) => Some(parent),
                Some(NodeKind::Tagged) if self.tree.child(parent, 1) == Some(root) => Some(parent),
                Some(NodeKind::Member(_)) => self.called(parent),
                Some(NodeKind::Call) if self.is_concat(parent) => Some(parent),
                Some(NodeKind::Array) => self.joined(parent),
                _ => None,
            };
            match next {
                Some(next) => root = next,
                None => break,
            }
        }
        root
    }

    /// The call of a method that keeps or cuts a text.
    fn called(&self, member: ScriptNodeId) -> Option<ScriptNodeId> {
        let keeps = [
            "concat",
            "trim",
            "trimStart",
            "trimLeft",
            "trimEnd",
            "trimRight",
            "slice",
            "substring",
            "substr",
            "toString",
        ];
        let name = self.tree.last_name(self.text, member)?;
        let call = self.tree.node(member)?.parent?;
        let is_callee = self.tree.node(call)?.kind == NodeKind::Call
            && self.tree.child(call, 0) == Some(member);
        (is_callee && keeps.contains(&name)).then_some(call)
    }

    fn is_concat(&self, call: ScriptNodeId) -> bool {
        let callee = self.tree.child(call, 0);
        let callee = callee.filter(|c| self.tree.node(*c).is_some_and(|n| !n.children.is_empty()));
        callee.and_then(|c| self.tree.last_name(self.text, c)) == Some("concat")
    }

    /// The call `[...].join(...)` of an array, perhaps with `filter` before.
    fn joined(&self, array: ScriptNodeId) -> Option<ScriptNodeId> {
        let mut object = array;
        loop {
            let member = self.tree.node(object)?.parent?;
            let call = self.tree.node(member)?.parent?;
            let is_callee = self.tree.child(call, 0) == Some(member)
                && self.tree.node(call)?.kind == NodeKind::Call;
            match self.tree.last_name(self.text, member)? {
                "join" if is_callee => return Some(call),
                "filter" if is_callee => object = call,
                _ => return None,
            }
        }
    }

    /// The parts of an expression.
    fn parts(&self, id: ScriptNodeId, found: &mut Vec<JoinedPart>) {
        let Some(node) = self.tree.node(id) else {
            return;
        };
        match &node.kind {
            NodeKind::Text | NodeKind::Template(_) => found.push(JoinedPart::Literal(id)),
            NodeKind::Sum => node.children.iter().for_each(|c| self.parts(*c, found)),
            NodeKind::Tagged => {
                node.children
                    .iter()
                    .skip(1)
                    .for_each(|c| self.parts(*c, found));
            }
            NodeKind::Call => self.parts_of_call(id, found),
            NodeKind::Array if self.is_list(id) => self.elements(&node.children, true, found),
            _ => found.push(JoinedPart::Other(id)),
        }
    }

    /// The parts of the elements of an array, perhaps with a line break between them.
    fn elements(&self, all: &[ScriptNodeId], are_lines: bool, found: &mut Vec<JoinedPart>) {
        for (index, element) in all.iter().enumerate() {
            if index > 0 && are_lines {
                found.push(JoinedPart::Line);
            }
            self.parts(*element, found);
        }
    }

    /// Whether an array lists the texts of one shader: names of texts, of which only the last has an entry
    /// function. The script joins them elsewhere.
    fn is_list(&self, array: ScriptNodeId) -> bool {
        let node = self.tree.node(array).filter(|n| n.kind == NodeKind::Array);
        let names = node.map_or(&[][..], |n| &n.children);
        let texts: Option<Vec<&str>> = names.iter().map(|id| self.named(*id)).collect();
        let is_part = |text: &&str| !has_main(text) && Scanned::of(text).chunk() != Chunk::No;
        let hole = |id: &ScriptNodeId| format!("${{{}", self.name(*id));
        let inserts = |text: &str| names.iter().any(|id| text.contains(&hole(id)));
        texts.is_some_and(|texts| match texts.split_last() {
            Some((last, others)) if !others.is_empty() => {
                let is_last = has_main(last) && !last.contains("#version") && !inserts(last);
                is_last && others.iter().all(is_part)
            }
            _ => false,
        })
    }

    fn name(&self, id: ScriptNodeId) -> &'s str {
        self.tree.node(id).map_or("", |node| self.slice(&node.span))
    }

    /// The code of the expression that a name refers to.
    fn named(&self, id: ScriptNodeId) -> Option<&'s str> {
        let node = self.tree.node(id).filter(|n| n.kind == NodeKind::Name)?;
        match self.tree.binding(self.name(id), node.span.start)?.value {
            BindingValue::Node(value) => Some(self.name(value)),
            _ => None,
        }
    }

    /// Whether an expression joins texts of names, for one of which this holds.
    pub fn joins(&self, id: ScriptNodeId, holds: impl Fn(&str) -> bool) -> bool {
        let mut parts = Vec::new();
        self.parts(id, &mut parts);
        let names = parts.iter().flat_map(|part| match part {
            JoinedPart::Other(id) => std::slice::from_ref(id),
            // What a template inserts.
            JoinedPart::Literal(id) => self.tree.node(*id).map_or(&[][..], |n| &n.children),
            JoinedPart::Line => &[],
        });
        let texts: Option<Vec<&str>> = names.map(|id| self.named(*id)).collect();
        texts.is_some_and(|texts| texts.len() > 1 && texts.into_iter().any(holds))
    }

    fn parts_of_call(&self, call: ScriptNodeId, found: &mut Vec<JoinedPart>) {
        let children = self
            .tree
            .node(call)
            .map_or(&[][..], |n| n.children.as_slice());
        let callee = children.first().copied();
        let is_method = callee.filter(|c| {
            matches!(
                self.tree.node(*c).map(|n| &n.kind),
                Some(NodeKind::Member(_))
            )
        });
        let object = is_method.and_then(|c| self.tree.child(c, 0));
        let name = callee.and_then(|c| self.tree.last_name(self.text, c));
        match (object, name) {
            (Some(object), Some("join")) if self.array(object).is_some() => {
                let separator = children.get(1).and_then(|s| self.tree.node(*s));
                let separator = separator.map_or("", |s| self.slice(&s.span));
                let is_line = separator.contains("\\n") || separator.contains('\n');
                let array = self.array(object).and_then(|a| self.tree.node(a));
                self.elements(array.map_or(&[], |a| &a.children), is_line, found);
            }
            (Some(object), Some("concat")) => {
                self.parts(object, found);
                children.iter().skip(1).for_each(|c| self.parts(*c, found));
            }
            (Some(object), _) if callee.and_then(|c| self.called(c)).is_some() => {
                self.parts(object, found);
            }
            _ => found.push(JoinedPart::Other(call)),
        }
    }

    /// The array of `array` or `array.filter(...)`.
    fn array(&self, id: ScriptNodeId) -> Option<ScriptNodeId> {
        let node = self.tree.node(id)?;
        match node.kind {
            NodeKind::Array => Some(id),
            NodeKind::Call => {
                let member = self.tree.child(id, 0)?;
                let is_filter = self.tree.last_name(self.text, member) == Some("filter");
                self.array(self.tree.child(member, 0)?)
                    .filter(|_| is_filter)
            }
            _ => None,
        }
    }

    fn slice(&self, range: &Range<usize>) -> &'s str {
        self.text.get(range.clone()).unwrap_or("")
    }

    /// Whether an expression joins texts of which it contains none.
    pub fn joins_names(&self, id: ScriptNodeId) -> bool {
        let is_joined = match self.tree.node(id).map(|n| &n.kind) {
            Some(NodeKind::Sum) => true,
            Some(NodeKind::Array) => self.is_list(id),
            Some(NodeKind::Call) => {
                let callee = self.tree.child(id, 0);
                let callee = callee.filter(|c| self.tree.child(*c, 0).is_some());
                callee.and_then(|c| self.tree.last_name(self.text, c)) == Some("join")
            }
            _ => false,
        };
        let mut parts = Vec::new();
        if is_joined {
            self.parts(id, &mut parts);
        }
        parts.len() > 1 && !parts.iter().any(|p| matches!(p, JoinedPart::Literal(_)))
    }

    /// The text of an expression, if it contains a literal or joins several texts.
    pub fn text_of(&self, root: ScriptNodeId) -> Option<ScriptText> {
        self.joined_text(root, 0)
    }

    fn joined_text(&self, root: ScriptNodeId, depth: usize) -> Option<ScriptText> {
        let mut parts = Vec::new();
        self.parts(root, &mut parts);
        let literal = |part: &JoinedPart| match part {
            JoinedPart::Literal(id) => self.tree.node(*id).map(|n| n.span.clone()),
            _ => None,
        };
        let first = parts.iter().find_map(literal);
        let last = parts.iter().rev().find_map(literal);
        let (start, end) = match (first, last) {
            (Some(first), Some(last)) => (first.start, last.end),
            _ if parts.len() > 1 => {
                let span = &self.tree.node(root)?.span;
                (span.start, span.end)
            }
            _ => return None,
        };
        let mut joined = JoinedBytes {
            texts: self,
            bytes: vec![b' '; end.checked_sub(start)?],
            start,
            holes: Vec::new(),
            values: Vec::new(),
            depth,
            goes_on: false,
        };
        joined.add_parts(&parts, end);
        joined.finish()
    }

    /// The text of the value of an expression.
    fn value(&self, id: ScriptNodeId, depth: usize) -> Option<InsertedPart> {
        let (values, bytes) = self.budget.get();
        self.budget.set((values.checked_sub(1)?, bytes));
        if depth > MAX_NAMES {
            return None;
        }
        let node = self.tree.node(id)?;
        match &node.kind {
            NodeKind::Number => number(self.slice(&node.span)).map(InsertedPart::known),
            NodeKind::Sum => self
                .sum(&node.children, depth)
                .or_else(|| Some(self.inserted(self.joined_text(id, depth)?))),
            NodeKind::Name => self.value_of_name(self.slice(&node.span), node.span.start, depth),
            NodeKind::Member(name) => {
                let object = *node.children.first()?;
                self.value_of_member(object, self.slice(name), depth)
            }
            NodeKind::Call => self
                .value_of_call(id, depth)
                .or_else(|| Some(self.inserted(self.joined_text(id, depth)?))),
            NodeKind::Choice => {
                let mut alternatives = node.children.iter();
                let first = alternatives.find_map(|c| self.value(*c, depth + 1))?;
                Some(InsertedPart {
                    is_choice: true,
                    ..first
                })
            }
            _ => Some(self.inserted(self.joined_text(id, depth)?)),
        }
        .filter(|found| self.pays(found))
    }

    /// Whether a text may be inserted once more.
    fn pays(&self, found: &InsertedPart) -> bool {
        let (values, bytes) = self.budget.get();
        let left = bytes.checked_sub(found.length());
        self.budget.set((values, left.unwrap_or(0)));
        left.is_some()
    }

    fn inserted(&self, text: ScriptText) -> InsertedPart {
        InsertedPart {
            at: 0..0,
            start: Some(text.start),
            code: text.code,
            module: None,
            inserted: text.inserted,
            has_holes: text.has_holes,
            is_choice: false,
        }
    }

    fn value_of_name(&self, name: &str, at: usize, depth: usize) -> Option<InsertedPart> {
        if self.assigned.contains(name) {
            return None;
        }
        match &self.tree.binding(name, at)?.value {
            BindingValue::Node(id) => self.value(*id, depth + 1),
            BindingValue::Import(path, name) => self.modules.text(path, name),
            BindingValue::Unknown => None,
        }
    }

    /// The sum of numbers.
    fn sum(&self, terms: &[ScriptNodeId], depth: usize) -> Option<InsertedPart> {
        let mut total = 0.0;
        for term in terms {
            self.tree.node(*term).filter(|n| n.kind != NodeKind::Text)?;
            total += self.value(*term, depth + 1)?.short()?.parse::<f64>().ok()?;
        }
        number(&total.to_string()).map(InsertedPart::known)
    }

    fn value_of_member(
        &self,
        object: ScriptNodeId,
        name: &str,
        depth: usize,
    ) -> Option<InsertedPart> {
        let node = self.tree.node(object)?;
        let is_name = node.kind == NodeKind::Name;
        let object = match is_name {
            true => {
                let of = self.slice(&node.span);
                match &self.tree.binding(of, node.span.start)?.value {
                    BindingValue::Node(id) => *id,
                    BindingValue::Import(path, all) if all == "*" => {
                        return self.modules.text(path, name);
                    }
                    _ => return None,
                }
            }
            false => object,
        };
        let object = self
            .tree
            .node(object)
            .filter(|n| n.kind == NodeKind::Object)?;
        let property = object.children.iter().find_map(|id| {
            let node = self.tree.node(*id)?;
            match &node.kind {
                NodeKind::Property(key) if self.slice(key) == name => node.children.first(),
                _ => None,
            }
        });
        self.value(*property?, depth + 1)
    }

    /// The value of a function with one result.
    fn value_of_call(&self, call: ScriptNodeId, depth: usize) -> Option<InsertedPart> {
        let callee = self.tree.node(self.tree.child(call, 0)?)?;
        if callee.kind != NodeKind::Name {
            return None;
        }
        let name = self.slice(&callee.span);
        let BindingValue::Node(function) = self.tree.binding(name, callee.span.start)?.value else {
            return None;
        };
        let function = self
            .tree
            .node(function)
            .filter(|n| n.kind == NodeKind::Function)?;
        let mut results = function.children.iter().filter(|id| {
            self.tree
                .node(**id)
                .is_some_and(|n| n.kind == NodeKind::Return)
        });
        let result = results.next().filter(|_| results.next().is_none())?;
        self.value(self.tree.child(*result, 0)?, depth + 1)
    }

    /// The text of an export.
    pub fn export(&self, name: &str) -> Option<InsertedPart> {
        match self.tree.exports.get(name) {
            Some(Export::Name(range)) => self.value_of_name(self.slice(range), range.start, 0),
            Some(Export::Node(id)) => self.value(*id, 0),
            Some(Export::Other(path, name)) => self.modules.text(path, name),
            None => self
                .tree
                .passed_on
                .iter()
                .find_map(|path| self.modules.text(path, name)),
        }
    }
}

/// A number as JavaScript prints it: 7.0 as `7`.
fn number(text: &str) -> Option<String> {
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite())?;
    let is_plain = number == 0.0 || (1e-6..1e21).contains(&number.abs());
    is_plain.then(|| format!("{number}"))
}

/// The bytes of joined literals.
struct JoinedBytes<'t, 's> {
    texts: &'t Texts<'s>,
    bytes: Vec<u8>,
    start: usize,
    holes: Vec<Hole>,
    /// By hole: what is inserted there.
    values: Vec<Option<InsertedPart>>,
    depth: usize,
    /// Whether unknown text precedes or follows.
    goes_on: bool,
}

impl JoinedBytes<'_, '_> {
    fn add_parts(&mut self, parts: &[JoinedPart], end: usize) {
        // End of the last literal, the expressions after it, and whether line breaks are around them.
        let mut last: Option<usize> = None;
        let mut others: Vec<ScriptNodeId> = Vec::new();
        let mut is_line = false;
        for part in parts {
            match part {
                JoinedPart::Line => is_line = true,
                JoinedPart::Other(id) => others.push(*id),
                JoinedPart::Literal(id) => {
                    let Some(node) = self.texts.tree.node(*id) else {
                        continue;
                    };
                    let from = last.unwrap_or(self.start);
                    self.between(from..node.span.start, &others, is_line);
                    self.literal(*id);
                    last = Some(node.span.end);
                    (others, is_line) = (Vec::new(), false);
                }
            }
        }
        match last {
            Some(_) => self.between(end..end, &others, is_line),
            None => self.between(self.start..end, &others, is_line),
        }
    }

    /// Adds the expressions between two literals. Everything between the literals belongs to them, so
    /// that they are adjacent to the text as at run time.
    fn between(&mut self, mut range: Range<usize>, others: &[ScriptNodeId], is_line: bool) {
        if is_line && range.len() > 1 {
            self.set(range.start, b'\n');
            range.start += 1;
            if !others.is_empty() {
                range.end -= 1;
                self.set(range.end, b'\n');
            }
        }
        let node = |id: &ScriptNodeId| self.texts.tree.node(*id).map_or(0..0, |n| n.span.clone());
        let (Some(first), Some(last)) = (others.first(), others.last()) else {
            return;
        };
        let text = self.texts.slice(&(node(first).start..node(last).end));
        let values = others
            .iter()
            .map(|id| self.texts.value(*id, self.depth + 1));
        let values: Option<Vec<InsertedPart>> = values.collect();
        let value = values.map(|mut values| match (values.len(), is_line) {
            (1, _) if !(is_line && range.is_empty()) => values.remove(0),
            (_, false) => InsertedPart::several(values),
            // At the ends of the text, no literal contains the line break.
            (_, true) => {
                let is_first = range.is_empty() && range.start == self.start;
                InsertedPart::lines(values, is_first, range.is_empty() && !is_first)
            }
        });
        self.put(range, text, value);
    }

    fn put(&mut self, range: Range<usize>, expression: &str, value: Option<InsertedPart>) {
        let of = |at: usize| at.saturating_sub(self.start);
        let range = of(range.start)..of(range.end);
        if range.is_empty() && value.is_none() {
            self.goes_on = true;
            return;
        }
        let expression = expression.trim().to_string();
        let short = value
            .as_ref()
            .and_then(|v| Some((v.short()?.to_string(), v.is_choice)));
        let content = match short {
            Some((short, true)) => HoleContent::Chosen(expression, short),
            Some((short, false)) => HoleContent::Known(short),
            None => HoleContent::Expression(expression),
        };
        let inserted = value.as_ref().filter(|v| !v.is_choice);
        self.holes.push(Hole {
            range,
            content,
            inserted: inserted.and_then(InsertedPart::ends),
        });
        self.values.push(value);
    }

    fn set(&mut self, at: usize, byte: u8) {
        let place = at.checked_sub(self.start);
        if let Some(place) = place.and_then(|i| self.bytes.get_mut(i)) {
            *place = byte;
        }
    }

    fn literal(&mut self, id: ScriptNodeId) {
        let Some(node) = self.texts.tree.node(id) else {
            return;
        };
        let holes: &[Range<usize>] = match &node.kind {
            NodeKind::Template(holes) => holes,
            _ => &[],
        };
        let mut holes = holes.iter().zip(0..).peekable();
        let bytes = self.texts.text.as_bytes();
        let mut at = node.span.start;
        while at < node.span.end {
            if let Some((hole, index)) = holes.next_if(|(hole, _)| hole.start == at) {
                let inner = hole.start + 2..hole.end.saturating_sub(1);
                let value = node.children.get(index as usize);
                let value = value.and_then(|v| self.texts.value(*v, self.depth + 1));
                self.put(hole.clone(), self.texts.slice(&inner), value);
                at = hole.end;
                continue;
            }
            let byte = bytes.get(at).copied().unwrap_or(b' ');
            if byte == b'\\' {
                at += self.escape(at);
            } else {
                self.set(at, byte);
                at += 1;
            }
        }
    }

    /// Decodes an escape sequence; returns its length.
    fn escape(&mut self, at: usize) -> usize {
        let rest = self.texts.text.get(at + 1..).unwrap_or("");
        let Some(c) = rest.chars().next() else {
            return 1;
        };
        match c {
            // First, so that a backslash before it still continues the line.
            'n' => self.set(at, b'\n'),
            'x' => return self.number(at, rest.get(1..3), 4),
            'u' if rest.starts_with("u{") => {
                let end = rest.find('}').unwrap_or(1);
                return self.number(at, rest.get(2..end), end + 2);
            }
            'u' => return self.number(at, rest.get(1..5), 6),
            '\r' if rest.starts_with("\r\n") => return 3,
            c if c.is_ascii_punctuation() => self.set(at + 1, c as u8),
            _ => {}
        }
        1 + c.len_utf8()
    }

    /// A character given by its code.
    fn number(&mut self, at: usize, digits: Option<&str>, length: usize) -> usize {
        let value = digits.and_then(|d| u8::from_str_radix(d, 16).ok());
        if let Some(value) = value.filter(u8::is_ascii) {
            self.set(at + length - 1, value);
        }
        length
    }

    fn finish(mut self) -> Option<ScriptText> {
        let filled = fill(&mut self.bytes, &self.holes);
        let mut has_holes = self.goes_on || filled.is_unknown;
        let mut inserted = Vec::new();
        let all = self.holes.into_iter().zip(self.values).enumerate();
        for (index, (hole, value)) in all {
            if let Some(value) = value.filter(|_| filled.inserted.contains(&index)) {
                has_holes |= value.has_holes;
                inserted.push(InsertedPart {
                    at: hole.range,
                    ..value
                });
            }
        }
        Some(ScriptText {
            start: self.start,
            code: String::from_utf8(self.bytes).ok()?,
            inserted,
            has_holes,
        })
    }
}
