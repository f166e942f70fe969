//! `? :` between structs, arrays or calls without a value, which desktop GLSL accepts and WebGL2 does not:
//! it becomes `if` and `else`, or a call of a function with them.

use shaderlint_diagnostic::Fix;
use shaderlint_semantic::{Program, Resolution};
use shaderlint_syntax::TokenKind;
use shaderlint_syntax::ast::{
    DeclKind, ExprId, ExprKind, Extent, Item, QualifierKind, StmtId, StmtKind,
};
use shaderlint_text::{Edit, Span};

/// A `condition ? yes : no` whose parts are written in the user's text.
struct TernaryChoice<'p> {
    program: &'p Program,
    id: ExprId,
    condition: ExprId,
    yes: ExprId,
    no: ExprId,
}

/// Replaces the choice at a span.
pub(super) fn choice(program: &Program, at: Span) -> Option<Fix> {
    let mut all = (0..).map(ExprId).zip(&program.tree.exprs);
    let (id, kind) = all.find_map(|(id, expr)| {
        let ExprKind::Ternary(..) = expr.kind else {
            return None;
        };
        let Extent { first, last } = expr.extent;
        let is_it = program.tokens.place(&program.sources, first, last) == at;
        is_it.then_some((id, expr.kind))
    })?;
    let ExprKind::Ternary(condition, yes, no) = kind else {
        return None;
    };
    let found = TernaryChoice {
        program,
        id,
        condition,
        yes,
        no,
    };
    found.as_statement().or_else(|| found.as_call())
}

impl TernaryChoice<'_> {
    /// Text of code that the user wrote, in the text itself.
    fn text(&self, extent: Extent) -> Option<&str> {
        Some(self.program.sources.text(self.span(extent)?))
    }

    fn span(&self, extent: Extent) -> Option<Span> {
        let (tokens, sources) = (&self.program.tokens, &self.program.sources);
        let span = self.program.span(extent);
        let exact = tokens.exact_place(sources, extent.first, extent.last)?;
        (exact.span == span).then_some(span)
    }

    fn expr_text(&self, id: ExprId) -> Option<&str> {
        self.text(self.program.tree.expr(id).extent)
    }

    /// The outermost choice of which this one is a result.
    fn whole(&self) -> ExprId {
        let tree = &self.program.tree;
        let mut whole = self.id;
        // An expression is stored after its operands.
        for (id, expr) in (0..).map(ExprId).zip(&tree.exprs) {
            if let ExprKind::Ternary(_, yes, no) = expr.kind
                && [yes, no].map(|e| tree.unparen(e)).contains(&whole)
            {
                whole = id;
            }
        }
        whole
    }

    /// `if` and `else` instead of the statement that uses nothing but the choice.
    fn as_statement(&self) -> Option<Fix> {
        let tree = &self.program.tree;
        let whole = self.whole();
        let extent = tree.expr(whole).extent;
        let mut all = (0..).map(StmtId).zip(&tree.stmts);
        let edits = all.find_map(|(id, stmt)| {
            if !stmt.extent.contains(extent) {
                return None;
            }
            let is_it = |e: ExprId| tree.unparen(e) == whole;
            let replaced = |before: &str| {
                let text = format!("{{ {} }}", self.branches(whole, before)?);
                Some(vec![Edit::replace(self.span(stmt.extent)?, text)])
            };
            match stmt.kind {
                StmtKind::Return(Some(value)) if is_it(value) => replaced("return "),
                StmtKind::Expr(e) if is_it(e) => replaced(""),
                StmtKind::Expr(e) => match tree.expr(tree.unparen(e)).kind {
                    ExprKind::Assign(None, left, right) if is_it(right) => {
                        replaced(&format!("{} = ", self.expr_text(left)?))
                    }
                    _ => None,
                },
                StmtKind::Decl(_) if tree.stmt_lists.contains(&id) => {
                    self.declared(stmt.kind, whole)
                }
                _ => None,
            }
        })?;
        Some(Fix::safe("use `if` and `else`", edits))
    }

    /// A statement for each value of a choice, also of those in it.
    fn branches(&self, id: ExprId, before: &str) -> Option<String> {
        let tree = &self.program.tree;
        let ExprKind::Ternary(condition, yes, no) = tree.expr(tree.unparen(id)).kind else {
            return Some(format!("{before}{};", self.expr_text(id)?));
        };
        let condition = self.expr_text(condition)?;
        let yes = match tree.expr(tree.unparen(yes)).kind {
            ExprKind::Ternary(..) => format!("{{ {} }}", self.branches(yes, before)?),
            _ => self.branches(yes, before)?,
        };
        let no = self.branches(no, before)?;
        Some(format!("if ({condition}) {yes} else {no}"))
    }

    /// Assigns the value of a variable after its declaration.
    fn declared(&self, statement: StmtKind, whole: ExprId) -> Option<Vec<Edit>> {
        let (program, tree) = (self.program, &self.program.tree);
        let StmtKind::Decl(id) = statement else {
            return None;
        };
        let DeclKind::Variables {
            qualifiers,
            declarators,
            ..
        } = tree.decl(id)?.kind
        else {
            return None;
        };
        let [declarator] = tree.declarators(declarators) else {
            return None;
        };
        let mut qualifiers = tree.qualifiers(qualifiers).iter();
        let is_const = qualifiers.any(|q| q.kind == QualifierKind::Const);
        let init = declarator
            .init
            .filter(|init| tree.unparen(*init) == whole)?;
        let sizes = tree.arrays(declarator.arrays);
        let name = declarator.ident;
        let value = tree.expr(init).extent;
        // The value may use a variable that the new one hides.
        let mut used = (value.first..=value.last).filter_map(|i| program.token(i));
        let hides = used.any(|t| t.kind == TokenKind::Identifier && t.value == name.name.0);
        if is_const || hides || sizes.iter().any(|s| s.size.is_none()) {
            return None;
        }
        let last = sizes.last().map_or(name.token, |s| s.extent.last);
        let head = self.span(Extent {
            first: name.token,
            last,
        })?;
        let end = self.span(value)?.end;
        let name = program.names.text(name.name);
        let text = self.branches(whole, &format!("{name} = "))?;
        // The last semicolon is that of the declaration.
        let text = format!("; {}", text.strip_suffix(';')?);
        Some(vec![Edit::replace(Span::new(head.end, end), text)])
    }

    /// A call of a new function instead of the choice, if it does not matter that both values are computed.
    fn as_call(&self) -> Option<Fix> {
        let (program, tree) = (self.program, &self.program.tree);
        let ty = program.expr(self.yes).ty;
        if ty.is_error() || self.acts(self.yes) || self.acts(self.no) {
            return None;
        }
        let extent = |id: ExprId| tree.expr(id).extent;
        let [condition, yes, no] = [self.condition, self.yes, self.no].map(extent);
        let between = |left: Extent, right: Extent| {
            let (left, right) = (self.span(left)?, self.span(right)?);
            (left.end <= right.start).then(|| Edit::replace(Span::new(left.end, right.start), ", "))
        };
        let item = tree.items.iter().find_map(|item| {
            let extent = match item {
                Item::Function(id) => tree.function(*id)?.extent,
                Item::Decl(id) => tree.decl(*id)?.extent,
            };
            extent.contains(tree.expr(self.id).extent).then_some(extent)
        })?;
        let whole = self.span(extent(self.id))?;
        let (name, ty) = (program.names.unused("choose"), program.type_name(ty));
        let function = format!(
            "{ty} {name}(bool condition, {ty} yes, {ty} no) {{\n    if (condition) return yes;\n    return no;\n}}\n"
        );
        let edits = vec![
            Edit::insert(self.span(item)?.start, function),
            Edit::insert(whole.start, format!("{name}(")),
            between(condition, yes)?,
            between(yes, no)?,
            Edit::insert(whole.end, ")"),
        ];
        Some(Fix::safe(format!("add `{name}`, and call it"), edits))
    }

    /// Whether an expression may write something, or costs more than the choice.
    fn acts(&self, id: ExprId) -> bool {
        let tree = &self.program.tree;
        let whole = tree.expr(id).extent;
        let all = tree.exprs.iter().zip(&self.program.exprs);
        let mut inside = all.filter(|(expr, _)| whole.contains(expr.extent));
        inside.any(|(expr, info)| match expr.kind {
            ExprKind::Assign(..) | ExprKind::Postfix(..) => true,
            ExprKind::Unary(op, _) => op.assigns(),
            ExprKind::Call(..) => matches!(info.resolution, Resolution::Function(_)),
            _ => false,
        })
    }
}
