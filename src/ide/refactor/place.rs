//! The selected code, and how text is inserted around it.

use crate::document::Document;
use shaderlint_lint::Facts;
use shaderlint_project::Files;
use shaderlint_semantic::{FunctionRef, Program, VariableId};
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{Token, WordClass, classify};
use shaderlint_text::{CompiledText, Edit, Span};

/// The selected code of a shader without errors.
pub(super) struct RefactorPlace<'d> {
    pub document: &'d Document,
    pub files: &'d dyn Files,
    pub program: &'d Program,
    pub facts: Facts<'d>,
    /// Addresses of the selection, without white space at its ends.
    pub selection: Span,
}

/// A statement before which a declaration is inserted.
pub(super) struct InsertionPoint {
    pub stmt: StmtId,
    /// The statements that see the declaration.
    pub scope: Extent,
    /// Whether it is the body of a control statement, and needs braces.
    needs_braces: bool,
}

impl<'d> RefactorPlace<'d> {
    pub fn of(
        document: &'d Document,
        files: &'d dyn Files,
        selection: Span,
    ) -> Option<RefactorPlace<'d>> {
        let range = selection.start as usize..selection.end as usize;
        let text = document.text.get(range)?;
        let before = text.len() - text.trim_start().len();
        let start = selection.start + before as u32;
        let end = start + text.trim().len() as u32;
        let spot = document.spot(start)?;
        if spot.analysis.has_errors {
            return None;
        }
        let selection = Span::new(spot.address, document.report.address(end)?);
        let place = RefactorPlace {
            document,
            files,
            program: spot.program(),
            facts: spot.analysis.facts(),
            selection,
        };
        place
            .code()
            .is_some_and(|c| place.is_in(&c, selection))
            .then_some(place)
    }

    /// The code that contains the selection.
    pub fn code(&self) -> Option<CompiledText<'d>> {
        self.program.sources.code_at(self.selection.start)
    }

    fn is_in(&self, code: &CompiledText, span: Span) -> bool {
        code.base <= span.start && span.end <= code.base + code.text.len() as u32
    }

    /// The text of a span in the user's code.
    pub fn text(&self, span: Span) -> Option<&'d str> {
        let code = self.program.sources.code_at(span.start)?;
        let range = (span.start - code.base) as usize..(span.end.checked_sub(code.base)?) as usize;
        code.text.get(range)
    }

    pub fn text_of(&self, extent: Extent) -> Option<&'d str> {
        self.text(self.program.span(extent))
    }

    /// Whether a node consists of all tokens of its span: it starts and ends at no part of a macro.
    pub fn is_exact(&self, extent: Extent) -> bool {
        let span = self.program.span(extent);
        let is_outside = |token: Option<&Token>| token.is_none_or(|t| !span.contains(t.span));
        let before = extent.first.checked_sub(1);
        self.program.is_user(span)
            && is_outside(before.and_then(|t| self.program.token(t)))
            && is_outside(
                self.program
                    .token(extent.last + 1)
                    .filter(|t| !t.span.is_empty()),
            )
    }

    /// The outermost expression that is selected.
    pub fn expr(&self) -> Option<ExprId> {
        if self.selection.is_empty() {
            return None;
        }
        let is_selected =
            |e: &Expr| self.program.span(e.extent) == self.selection && self.is_exact(e.extent);
        let mut all = self.program.tree.exprs.iter();
        all.rposition(is_selected).map(|at| ExprId(at as u32))
    }

    /// The text of an expression as an initial value.
    pub fn value_text(&self, expr: ExprId) -> Option<&'d str> {
        let tree = &self.program.tree;
        let inner = tree.unparen(expr);
        let keeps = matches!(tree.expr(inner).kind, ExprKind::Comma(..));
        let extent = tree.expr(if keeps { expr } else { inner }).extent;
        // A macro may write the parentheses.
        match self.is_exact(extent) {
            true => self.text_of(extent),
            false => self.text_of(tree.expr(expr).extent),
        }
    }

    /// The statement before which a variable for an expression is declared.
    pub fn insertion_point(&self, expr: ExprId) -> Option<InsertionPoint> {
        let structure = self.facts.structure();
        let mut stmt = structure.stmt_of(expr)?;
        loop {
            let outer = structure.outer(stmt)?;
            let found = self.program.tree.stmt(outer);
            match found.kind {
                StmtKind::Block(_) | StmtKind::Switch { .. } => {
                    let first = self.program.tree.stmt(stmt).extent.first;
                    return Some(InsertionPoint {
                        stmt,
                        scope: Extent::new(first, found.extent.last),
                        needs_braces: false,
                    });
                }
                StmtKind::For {
                    init, condition, ..
                } if init == stmt || condition == Some(stmt) => stmt = outer,
                StmtKind::While { condition, .. } if condition == stmt => stmt = outer,
                _ => {
                    return Some(InsertionPoint {
                        stmt,
                        scope: self.program.tree.stmt(stmt).extent,
                        needs_braces: true,
                    });
                }
            }
        }
    }

    /// The edits that insert a statement.
    pub fn insert_before(&self, point: &InsertionPoint, text: &str) -> Option<Vec<Edit>> {
        let span = self.program.span(self.program.tree.stmt(point.stmt).extent);
        if point.needs_braces {
            let open = Edit::insert(span.start, format!("{{ {text} "));
            return Some(vec![open, Edit::insert(span.end, " }")]);
        }
        let before = match self.indent(span.start)? {
            Some(indent) => format!("{text}{}{indent}", self.line_break()),
            None => format!("{text} "),
        };
        Some(vec![Edit::insert(span.start, before)])
    }

    /// The white space before an address, if there is nothing else before it on its line.
    pub fn indent(&self, address: u32) -> Option<Option<&'d str>> {
        let code = self.program.sources.code_at(address)?;
        let before = code.text.get(..(address - code.base) as usize)?;
        let line = before.rsplit(['\n', '\r']).next()?;
        Some(line.trim().is_empty().then_some(line))
    }

    pub fn line_break(&self) -> &'static str {
        match self.code().is_some_and(|c| c.text.contains("\r\n")) {
            true => "\r\n",
            false => "\n",
        }
    }

    /// The indentation of one level.
    pub fn indentation(&self) -> &'d str {
        let lines = self.code().map_or("", |c| c.text).lines();
        let blanks = |l: &'d str| l.get(..l.len() - l.trim_start().len());
        let mut indents = lines.filter(|l| !l.trim().is_empty()).filter_map(blanks);
        let is_indent = |s: &&str| *s == "\t" || (s.len() > 1 && s.trim_matches(' ').is_empty());
        indents.find(is_indent).unwrap_or("    ")
    }

    /// Where an item is inserted before the function or declaration at an address: before the
    /// comments that belong to it.
    pub fn before_item(&self, address: u32) -> Option<u32> {
        let code = self.program.sources.code_at(address)?;
        let before = code.text.get(..(address - code.base) as usize)?;
        let mut start = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
        if !before.get(start..)?.trim().is_empty() {
            return Some(address);
        }
        loop {
            let above = before.get(..start)?.trim_end_matches(['\n', '\r']);
            let skipped = before.get(above.len()..start)?.matches('\n').count();
            let line = above.rfind(['\n', '\r']).map_or(0, |at| at + 1);
            let text = above.get(line..)?.trim();
            if skipped > 1 || !text.starts_with("//") {
                return Some(code.base + start as u32);
            }
            start = line;
        }
    }

    /// The item that contains an address, and its extent.
    pub fn item_at(&self, address: u32) -> Option<(Item, Extent)> {
        let tree = &self.program.tree;
        let items = tree.items.iter().filter_map(|item| {
            let extent = match item {
                Item::Function(id) => tree.function(*id)?.extent,
                Item::Decl(id) => tree.decl(*id)?.extent,
            };
            Some((*item, extent))
        });
        let mut items = items;
        items.find(|(_, extent)| {
            let span = self.program.span(*extent);
            span.start <= address && address <= span.end
        })
    }

    /// A name that nothing in the document uses.
    pub fn free_name(&self, base: &str) -> String {
        let is_taken = |name: &str| {
            self.program.names.get(name).is_some()
                || classify(name, self.program.version) != WordClass::Plain
                || self.document.text.contains(name)
        };
        let mut name = base.to_string();
        let mut number = 2;
        while is_taken(&name) {
            name = format!("{base}{number}");
            number += 1;
        }
        name
    }

    /// Other expressions in an extent with the same tokens as this one.
    pub fn same_exprs(&self, expr: ExprId, within: Extent) -> Vec<ExprId> {
        let tree = &self.program.tree;
        let own = tree.expr(expr).extent;
        let length = own.last - own.first;
        let token = |t: u32| self.program.token(t).map(|t| (t.kind, t.value));
        let is_same = |e: &Expr| {
            let other = e.extent;
            other != own
                && other.last.checked_sub(other.first) == Some(length)
                && within.contains(other)
                && self.program.is_direct(other)
                && (0..=length).all(|i| token(own.first + i) == token(other.first + i))
        };
        let all = tree.exprs.iter().zip(0..);
        let found = all.filter(|(e, _)| is_same(e)).map(|(_, id)| ExprId(id));
        // Of parentheses and their content, the first.
        let mut seen: Vec<Extent> = vec![own];
        found
            .filter(|e| {
                let extent = tree.expr(*e).extent;
                let is_new = !seen.contains(&extent);
                seen.push(extent);
                is_new
            })
            .collect()
    }

    /// The variables of the function that are mentioned in an extent, in the order of the text.
    pub fn locals_in(&self, extent: Extent) -> Vec<VariableId> {
        let mut found: Vec<(u32, VariableId)> = Vec::new();
        for (expr, id) in self.program.tree.exprs.iter().zip(0..) {
            let is_name = matches!(expr.kind, ExprKind::Name(_)) && extent.contains(expr.extent);
            let variable = is_name
                .then(|| self.program.variable_of(ExprId(id)))
                .flatten();
            if let Some(variable) = variable
                && self
                    .program
                    .variable(variable)
                    .is_some_and(|v| v.function.is_some())
            {
                found.push((expr.extent.first, variable));
            }
        }
        found.sort_unstable();
        let mut variables: Vec<VariableId> = Vec::new();
        for (_, variable) in found {
            if !variables.contains(&variable) {
                variables.push(variable);
            }
        }
        variables
    }

    /// Whether code in an extent writes to a variable.
    pub fn writes_in(&self, variable: VariableId, extent: Extent) -> bool {
        let writes = self.facts.writes().to(variable).iter();
        let mut extents = writes.map(|e| self.program.tree.expr(*e).extent);
        extents.any(|e| extent.contains(e))
    }

    /// The function around an expression.
    pub fn function_of(&self, expr: ExprId) -> Option<(FunctionRef, &'d FunctionDecl)> {
        let id = self.facts.structure().function_of_expr(expr)?;
        Some((id, self.definition(id)?))
    }

    pub fn definition(&self, id: FunctionRef) -> Option<&'d FunctionDecl> {
        let definition = self.program.function(id)?.definition?;
        self.program.tree.function(definition)
    }

    /// The text of `value` in the place of `replaced`: in parentheses, if it needs them.
    pub fn in_place_of(&self, replaced: ExprId, value: ExprId, text: &str) -> String {
        match self.is_separate(replaced) || self.is_tight(replaced, value) {
            true => text.to_string(),
            false => format!("({text})"),
        }
    }

    /// Whether an expression binds at least as tightly as the place of another requires.
    fn is_tight(&self, replaced: ExprId, value: ExprId) -> bool {
        let tree = &self.program.tree;
        let parent = self.facts.structure().parent(replaced);
        let parent = parent.map(|parent| tree.expr(parent).kind);
        match tree.expr(value).kind {
            ExprKind::Int(_) | ExprKind::Uint(_) | ExprKind::Float(_) | ExprKind::Bool(_) => {
                // A macro may write an operator.
                self.program.is_direct(tree.expr(value).extent)
            }
            ExprKind::Name(_)
            | ExprKind::Paren(_)
            | ExprKind::Call(..)
            | ExprKind::Construct(..)
            | ExprKind::Member(..)
            | ExprKind::Index(..) => true,
            ExprKind::Binary(inner, ..) => match parent {
                Some(ExprKind::Binary(outer, left, _)) => {
                    let (inner, outer) = (inner.precedence(), outer.precedence());
                    inner > outer || inner == outer && left == replaced
                }
                _ => false,
            },
            _ => false,
        }
    }

    /// Whether an expression can be replaced with any other but a comma: it is an argument, an
    /// initial value, or in parentheses.
    fn is_separate(&self, expr: ExprId) -> bool {
        let tree = &self.program.tree;
        match self.facts.structure().parent(expr) {
            None => true,
            Some(parent) => match tree.expr(parent).kind {
                ExprKind::Paren(_) | ExprKind::Call(..) | ExprKind::Construct(..) => true,
                ExprKind::Assign(_, _, value) => value == expr,
                ExprKind::Index(_, index) => index == expr,
                _ => false,
            },
        }
    }
}

/// An expression as the text of a macro: in parentheses, if it needs them anywhere.
pub(super) fn as_macro(program: &Program, value: ExprId, text: &str) -> String {
    let kind = program.tree.expr(value).kind;
    let is_open = matches!(
        kind,
        ExprKind::Unary(..)
            | ExprKind::Postfix(..)
            | ExprKind::Binary(..)
            | ExprKind::Assign(..)
            | ExprKind::Ternary(..)
            | ExprKind::Comma(..)
    );
    // Another macro may write an operator.
    let is_direct = program.is_direct(program.tree.expr(value).extent);
    match is_open || !is_direct {
        true => format!("({text})"),
        false => text.to_string(),
    }
}
