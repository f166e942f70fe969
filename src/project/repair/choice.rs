//! `? :` between structs, arrays or calls without a value, which desktop GLSL accepts and WebGL2 does not:
//! it becomes `if` and `else`, or a call of a function with them.

use shaderlint_diagnostic::Fix;
use shaderlint_semantic::{Program, Resolution, Type};
use shaderlint_syntax::TokenKind;
use shaderlint_syntax::ast::{
    DeclKind, ExprId, ExprKind, Extent, Item, QualifierKind, StmtId, StmtKind,
};
use shaderlint_text::{Edit, Span};

/// A `condition ? yes : no`.
struct TernaryChoice<'p> {
    program: &'p Program,
    id: ExprId,
    condition: ExprId,
    yes: ExprId,
    no: ExprId,
}

/// Replaces the choice at a span.
pub(crate) fn choice(program: &Program, at: Span) -> Option<Fix> {
    let found = choices(program).find(|choice| {
        let Extent { first, last } = program.tree.expr(choice.id).extent;
        choice.is_refused() && program.tokens.place(&program.sources, first, last) == at
    })?;
    found.as_statement().or_else(|| found.as_call())
}

/// The choices of a program.
fn choices(program: &Program) -> impl Iterator<Item = TernaryChoice<'_>> {
    let all = (0..).map(ExprId).zip(&program.tree.exprs);
    all.filter_map(move |(id, expr)| match expr.kind {
        ExprKind::Ternary(condition, yes, no) => Some(TernaryChoice {
            program,
            id,
            condition,
            yes,
            no,
        }),
        _ => None,
    })
}

/// Whether two choices have text in common.
fn overlap(left: &[Span; 3], right: &[Span; 3]) -> bool {
    let whole = |parts: &[Span; 3]| parts[0].to(parts[2]);
    let (left, right) = (whole(left), whole(right));
    left.start <= right.end && right.start <= left.end
}

/// Most bytes of white space around the `?` and `:` of a choice.
const MAX_GAP: u32 = 1_000;

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
        let head = self.span(Extent::new(name.token, last))?;
        let end = self.span(value)?.end;
        let name = program.names.text(name.name);
        let text = self.branches(whole, &format!("{name} = "))?;
        // The last semicolon is that of the declaration.
        let text = format!("; {}", text.strip_suffix(';')?);
        Some(vec![Edit::replace(Span::new(head.end, end), text)])
    }

    /// Calls of new functions instead of this choice and all others that cannot become statements, if it
    /// does not matter that both values are computed. In the body of a macro this changes all calls, whose
    /// types may differ.
    fn as_call(&self) -> Option<Fix> {
        let program = self.program;
        let mut places: Vec<[Span; 3]> = Vec::new();
        for choice in choices(program).filter(|c| c.is_refused() && c.as_statement().is_none()) {
            if let Some(parts) = choice.parts()
                && !places.iter().any(|other| overlap(&parts, other))
                && choices(program).all(|c| c.parts() != Some(parts) || c.is_free())
            {
                places.push(parts);
            }
        }
        let own = self.parts()?;
        if !places.contains(&own) {
            return None;
        }
        let name = program.names.unused("choose");
        let mut edits: Vec<Edit> = Vec::new();
        let mut made: Vec<Type> = Vec::new();
        for choice in choices(program) {
            let ty = choice.ty();
            let is_called = choice.parts().is_some_and(|parts| places.contains(&parts));
            if is_called && !ty.is_error() && !made.contains(&ty) {
                made.push(ty);
                let ty = program.type_name(ty);
                let function = format!(
                    "{ty} {name}(bool condition, {ty} yes, {ty} no) {{\n    if (condition) return yes;\n    return no;\n}}\n"
                );
                let place = Span::at(choice.item()?);
                match edits.iter_mut().find(|edit| edit.span == place) {
                    Some(edit) => edit.text.push_str(&function),
                    None => edits.push(Edit::replace(place, function)),
                }
            }
        }
        for [condition, yes, no] in places {
            edits.extend([
                Edit::insert(condition.start, format!("{name}(")),
                Edit::replace(Span::new(condition.end, yes.start), ", "),
                Edit::replace(Span::new(yes.end, no.start), ", "),
                Edit::insert(no.end, ")"),
            ]);
        }
        Some(Fix::safe(format!("add `{name}`, and call it"), edits))
    }

    /// The type of its values; an error if both are refused choices.
    fn ty(&self) -> Type {
        let [yes, no] = [self.yes, self.no].map(|value| self.program.expr(value).ty);
        if yes.is_error() { no } else { yes }
    }

    /// Whether WebGL2 refuses it.
    fn is_refused(&self) -> bool {
        let ty = self.ty();
        !ty.is_scalar() && !ty.is_vector() && !ty.is_matrix()
    }

    /// Whether a function can compute it. If both values have different types, that is repaired first.
    fn is_free(&self) -> bool {
        let [yes, no] = [self.yes, self.no].map(|value| self.program.expr(value).ty);
        let is_typed = yes == no || yes.is_error() || no.is_error();
        is_typed && !yes.is_void() && !self.acts(self.yes) && !self.acts(self.no)
    }

    /// The condition and both values in the text, or in the body of a macro.
    fn parts(&self) -> Option<[Span; 3]> {
        let (program, sources) = (self.program, &self.program.sources);
        let tree = &program.tree;
        let place = |id: ExprId| {
            let Extent { first, last } = tree.expr(id).extent;
            Some(program.tokens.exact_place(sources, first, last)?.span)
        };
        // Parts of different macros have other text between them.
        let is_between = |left: Span, right: Span, mark: &str| {
            let is_ordered = left.end <= right.start && right.start - left.end < MAX_GAP;
            is_ordered && sources.text(Span::new(left.end, right.start)).trim() == mark
        };
        let parts = [self.condition, self.yes, self.no].map(place);
        if let [Some(condition), Some(yes), Some(no)] = parts
            && is_between(condition, yes, "?")
            && is_between(yes, no, ":")
        {
            return Some([condition, yes, no]);
        }
        // A part that is an argument is written in the call, and its parameter in the body.
        let mark = |value: ExprId| {
            let before = tree.expr(value).extent.first.checked_sub(1)?;
            Some(program.token(before)?.spelled)
        };
        let (question, colon) = (mark(self.yes)?, mark(self.no)?);
        let holds = |span: &Span| span.start < question && question < colon && colon < span.end;
        let bodies = program.tokens.macros.iter().filter(|m| !m.predefined);
        let mut bodies = bodies.filter_map(|m| {
            let (first, last) = (m.body.first()?, m.body.last()?);
            Some(first.token.span.to(last.token.span))
        });
        let whole = Some(place(self.id)?).filter(holds);
        // The macro may consist of the choice alone.
        let whole = whole.or_else(|| bodies.find(holds))?;
        let trimmed = |start: u32, end: u32| {
            let text = sources.text(Span::new(start, end));
            let blank = (text.len() - text.trim_start().len()) as u32;
            Span::new(start + blank, start + blank + text.trim().len() as u32)
        };
        Some([
            trimmed(whole.start, question),
            trimmed(question + 1, colon),
            trimmed(colon + 1, whole.end),
        ])
    }

    /// The start of the function or declaration that it is in.
    fn item(&self) -> Option<u32> {
        let tree = &self.program.tree;
        let extents = tree.items.iter().filter_map(|item| match item {
            Item::Function(id) => Some(tree.function(*id)?.extent),
            Item::Decl(id) => Some(tree.decl(*id)?.extent),
        });
        let own = tree.expr(self.id).extent;
        let mut items = extents.filter(|extent| extent.contains(own));
        let token = self.program.token(items.next()?.first)?;
        token.is_direct().then_some(token.span.start)
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
