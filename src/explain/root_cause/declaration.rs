//! Declarations that other code needs to be different: a `const` that is missing, a size of an array,
//! a value that only a function can compute, a scope that is too small.

use super::candidate::RepairCandidate;
use super::{FaultyShader, MAX_LOOKED_AT};
use shaderlint_diagnostic::{Diagnostic, Fix, error};
use shaderlint_semantic::{Direction, Resolution, Storage, Variable};
use shaderlint_syntax::ast::{
    ArraySize, DeclKind, Declaration, Declarator, Expr, ExprId, ExprKind, Extent, FunctionDecl,
    Qualifier, QualifierKind, StmtId, StmtKind, TypeId,
};
use shaderlint_text::{Edit, Span};

/// Maximum number of variables that are looked at for an error.
const MAX_VARIABLES: usize = 8;

/// A declaration of one variable, in the user's text.
#[derive(Clone, Copy)]
struct SoleDeclaration<'a> {
    whole: Extent,
    qualifiers: &'a [Qualifier],
    ty: TypeId,
    declarator: &'a Declarator,
}

impl FaultyShader<'_> {
    /// Repairs of the declarations that the errors are about.
    pub(super) fn declarations(&self) -> Vec<RepairCandidate> {
        let mut all = Vec::new();
        for d in self.errors.iter().take(MAX_LOOKED_AT) {
            if d.is(error::NOT_CONSTANT) {
                self.lost_const(d, &mut all);
                all.extend(self.computed_value(d));
            }
            if d.is(error::CONSTRUCTOR_ARGUMENTS) || d.is(error::TYPE_MISMATCH) {
                self.array_size(d, &mut all);
            }
            if d.is(error::UNDECLARED_NAME) && d.fix.is_none() {
                self.ended_scope(d, &mut all);
                self.other_function(d, &mut all);
            }
        }
        all
    }

    /// Names that a statement assigns before any declaration of them.
    pub(super) fn lost_types(&self) -> Vec<RepairCandidate> {
        let mut all = Vec::new();
        let errors = self.errors.iter().take(MAX_LOOKED_AT);
        let unknown = errors.filter(|d| d.is(error::UNDECLARED_NAME) && d.fix.is_none());
        unknown.for_each(|d| all.extend(self.lost_type(d)));
        all
    }

    /// `int n = 3; float a[n];`: variables that are never written can be constants.
    fn lost_const(&self, d: &Diagnostic, all: &mut Vec<RepairCandidate>) {
        let mut edits: Vec<Edit> = Vec::new();
        let mut names: Vec<&str> = Vec::new();
        for variable in self.variables_in(d.span).into_iter().take(MAX_VARIABLES) {
            let is_own = matches!(variable.storage, Storage::Local | Storage::Global);
            if variable.is_const || !is_own {
                continue;
            }
            let Some(of) = self.sole_declaration(variable) else {
                return;
            };
            let edit = Edit::insert(self.program.span(of.whole).start, "const ");
            if variable.written || edits.contains(&edit) {
                continue;
            }
            edits.push(edit);
            names.push(self.program.names.text(variable.name));
        }
        if let Some(name) = names.first() {
            let fix = Fix::safe(format!("declare `{name}` as `const`"), edits);
            all.push(RepairCandidate::of_error(d, fix));
        }
    }

    /// `vec2 r = iResolution.xy;` at global scope: the entry function assigns it.
    fn computed_value(&self, d: &Diagnostic) -> Option<RepairCandidate> {
        let (program, tree) = (self.program, &self.program.tree);
        let is_meant = |of: &Declarator| of.init.is_some_and(|e| program.expr_span(e) == d.span);
        let (of, init) = self.global_declaration(is_meant)?;
        let entry = program.entry().and_then(|f| program.function(f));
        let entry = entry.and_then(|f| tree.function(f.definition?));
        let (entry, body) = entry.and_then(|f| Some((f, f.body?)))?;
        let name = program.sources.text(self.name_span(of.declarator));
        let before = Span::new(self.end_of_header(of.declarator), d.span.end);
        let mut edits = self.without_const(&of);
        edits.push(Edit::delete(before));
        let value = program.expr_text(init);
        let text = format!("\n    {name} = {value};");
        edits.push(Edit::insert(self.place_of_value(body, d.span), text));
        let entry = program.names.text(entry.ident.name);
        let fix = Fix::safe(format!("assign it at the start of `{entry}`"), edits);
        let mut found = RepairCandidate::of_error(d, fix);
        found.diagnostic.help.clear();
        Some(found)
    }

    /// Where a function can compute a value first: at its start, but after assignments of variables that the
    /// value reads.
    fn place_of_value(&self, body: StmtId, value: Span) -> u32 {
        let (program, tree) = (self.program, &self.program.tree);
        let read = self.variables_in(value);
        let first = Extent::token(tree.stmt(body).extent.first);
        let StmtKind::Block(list) = tree.stmt(body).kind else {
            return program.span(first).end;
        };
        let assigned = |id: &StmtId| match tree.stmt(*id).kind {
            StmtKind::Expr(id) => match tree.expr(id).kind {
                ExprKind::Assign(None, left, _) => program.variable(program.variable_of(left)?),
                _ => None,
            },
            _ => None,
        };
        let leading = tree.block(list).iter();
        let leading = leading.map_while(|id| Some((tree.stmt(*id).extent, assigned(id)?)));
        let is_read = |of: &Variable| read.iter().any(|v| v.token == of.token);
        let last = leading.filter(|(_, of)| is_read(of)).last();
        program.span(last.map_or(first, |(extent, _)| extent)).end
    }

    /// `vec3 a[3] = vec3[4](x, y, z);`: one of the sizes is not that of the value.
    fn array_size(&self, d: &Diagnostic, all: &mut Vec<RepairCandidate>) {
        let (program, tree) = (self.program, &self.program.tree);
        for of in tree.declarator_lists.iter() {
            let is_meant = program.span(of.extent).contains(d.span);
            let Some(init) = of.init.filter(|_| is_meant) else {
                continue;
            };
            let ExprKind::Construct(ty, args) = tree.expr(tree.unparen(init)).kind else {
                continue;
            };
            let count = tree.args(args).len().to_string();
            let declared = tree.decls.iter().find_map(|decl| match decl.kind {
                DeclKind::Variables { ty, .. } if decl.extent.contains(of.extent) => Some(ty),
                _ => None,
            });
            let declared = declared.map(|ty| tree.ty(ty).arrays);
            let declared = [Some(of.arrays), declared].into_iter().flatten();
            let sizes = declared.flat_map(|sizes| tree.arrays(sizes));
            let declared = sizes
                .filter_map(|size| self.other_size(size, &count))
                .next();
            let mut written = tree.arrays(tree.ty(ty).arrays).iter();
            let written = written.find_map(|size| self.other_size(size, &count));
            let both = [written.clone(), declared.clone()];
            let edits = [vec![written], vec![declared], both.to_vec()];
            for edits in edits {
                let edits: Vec<Edit> = edits.into_iter().flatten().collect();
                if !edits.is_empty() {
                    all.push(RepairCandidate::of_error(
                        d,
                        Fix::suggestion(format!("use the size {count}"), edits),
                    ));
                }
            }
            return;
        }
    }

    /// The edit that writes another size.
    fn other_size(&self, size: &ArraySize, count: &str) -> Option<Edit> {
        let tree = &self.program.tree;
        let is_number = |e: &Expr| matches!(e.kind, ExprKind::Int(_) | ExprKind::Uint(_));
        let expr = size.size.map(|id| tree.expr(id)).filter(|e| is_number(e))?;
        let span = self.program.span(expr.extent);
        let is_other = self.program.sources.text(span) != count;
        (is_other && self.program.is_direct(expr.extent)).then(|| Edit::replace(span, count))
    }

    /// `c = vec3(0.0);` before any declaration of `c`.
    fn lost_type(&self, d: &Diagnostic) -> Option<RepairCandidate> {
        let (program, tree) = (self.program, &self.program.tree);
        let value = tree.stmts.iter().find_map(|stmt| match stmt.kind {
            StmtKind::Expr(id) => match tree.expr(id).kind {
                ExprKind::Assign(None, left, right) if program.expr_span(left) == d.span => {
                    Some(right)
                }
                _ => None,
            },
            _ => None,
        });
        let ty = value.map(|value| program.ty(value));
        let ty = ty.filter(|ty| !ty.is_error() && !ty.is_array())?;
        let (ty, name) = (program.type_name(ty), program.sources.text(d.span));
        let edits = vec![Edit::insert(d.span.start, format!("{ty} "))];
        let title = format!("declare it: `{ty} {name}`");
        Some(RepairCandidate::of_error(d, Fix::suggestion(title, edits)))
    }

    /// A variable that is used after the block that declares it: it is declared before the block.
    fn ended_scope(&self, d: &Diagnostic, all: &mut Vec<RepairCandidate>) {
        let (program, tree) = (self.program, &self.program.tree);
        let Some(function) = self.function_at(d.span.start) else {
            return;
        };
        for variable in self.variables_named(d.span) {
            let Some(of) = self.sole_declaration(variable) else {
                continue;
            };
            let place = program.span(of.whole);
            if !program.span(function.extent).contains(place) || place.start > d.span.start {
                continue;
            }
            // Children come before their parents.
            let around = tree.stmts.iter().find_map(|stmt| match stmt.kind {
                StmtKind::Block(body) => {
                    let span = program.span(stmt.extent);
                    (span.contains(place) && span.contains(d.span)).then_some(body)
                }
                _ => None,
            });
            let Some(body) = around else { continue };
            let extents = tree.block(body).iter().map(|id| tree.stmt(*id).extent);
            let mut spans = extents.map(|extent| program.span(extent));
            let Some(before) = spans.find(|span| span.contains(place)) else {
                continue;
            };
            let Some((ty, value)) = self.type_and_zero(&of, variable) else {
                continue;
            };
            let name = program.sources.text(d.span);
            let indent = self.blanks_before(before);
            let text = format!("{ty} {name} = {value};\n{indent}");
            let mut edits = vec![Edit::insert(before.start, text)];
            edits.extend(self.as_assignment(&of));
            let fix = Fix::suggestion(format!("declare `{name}` before the block"), edits);
            all.push(RepairCandidate::of_error(d, fix));
        }
    }

    /// A variable of the function that calls this one: it becomes a global variable, and the place of
    /// the pixel is the built-in variable.
    fn other_function(&self, d: &Diagnostic, all: &mut Vec<RepairCandidate>) {
        let (program, tree) = (self.program, &self.program.tree);
        let Some(function) = self.function_at(d.span.start) else {
            return;
        };
        let name = program.sources.text(d.span);
        for variable in self.variables_named(d.span) {
            let entry = variable.function.filter(|f| Some(*f) == program.entry());
            if entry.is_some() && variable.storage == Storage::Param(Direction::In) {
                let edits = vec![Edit::replace(d.span, "gl_FragCoord.xy")];
                all.push(RepairCandidate::of_error(
                    d,
                    Fix::suggestion("use `gl_FragCoord.xy`", edits),
                ));
            }
            let declarer = variable.function.and_then(|f| program.function(f));
            let declarer = declarer.and_then(|f| tree.function(f.definition?));
            let Some(declarer) = declarer.filter(|f| self.calls(f, function)) else {
                continue;
            };
            let of = self.sole_declaration(variable);
            let Some(of) = of.filter(|of| declarer.extent.contains(of.whole)) else {
                continue;
            };
            let ty = program.span(tree.ty(of.ty).extent);
            let start = program.span(function.extent).start;
            let text = format!("{} {name};\n\n", program.sources.text(ty));
            let mut edits = vec![Edit::insert(start, text)];
            edits.extend(self.as_assignment(&of));
            let title = format!("make `{name}` a global variable");
            all.push(RepairCandidate::of_error(d, Fix::suggestion(title, edits)));
        }
    }

    /// Whether one function calls another.
    fn calls(&self, caller: &FunctionDecl, called: &FunctionDecl) -> bool {
        let program = self.program;
        program.calls.iter().any(|call| {
            let f = program.function(call.callee).and_then(|f| f.definition);
            let f = f.and_then(|f| program.tree.function(f));
            f.is_some_and(|f| f.extent == called.extent)
                && caller.extent.contains(program.tree.expr(call.expr).extent)
        })
    }

    /// The variables that an expression names.
    fn variables_in(&self, span: Span) -> Vec<&Variable> {
        let program = self.program;
        let exprs = program.tree.exprs.iter().zip(&program.exprs);
        let inside = exprs.filter(|(e, _)| {
            matches!(e.kind, ExprKind::Name(_)) && span.contains(program.span(e.extent))
        });
        let variables = inside.filter_map(|(_, info)| match info.resolution {
            Resolution::Variable(id) => program.variable(id),
            _ => None,
        });
        variables.collect()
    }

    /// The variables of functions with the name of an error.
    fn variables_named(&self, name: Span) -> Vec<&Variable> {
        let program = self.program;
        let name = program.names.get(program.sources.text(name));
        let variables = program.variables.iter();
        variables
            .filter(|v| Some(v.name) == name && v.function.is_some())
            .take(MAX_VARIABLES)
            .collect()
    }

    /// The declaration of a variable, unless it declares others too or comes from a macro.
    fn sole_declaration(&self, variable: &Variable) -> Option<SoleDeclaration<'_>> {
        let is_meant = |of: &Declarator| Some(of.ident.token) == variable.token;
        self.declaration(|_| true, is_meant)
    }

    /// A declaration at global scope, and its value.
    fn global_declaration(
        &self,
        is_meant: impl Fn(&Declarator) -> bool,
    ) -> Option<(SoleDeclaration<'_>, ExprId)> {
        let is_global = |decl: &Declaration| {
            let functions = &self.program.tree.functions;
            !functions.iter().any(|f| f.extent.contains(decl.extent))
        };
        let of = self.declaration(is_global, is_meant)?;
        Some((of, of.declarator.init?))
    }

    fn declaration(
        &self,
        is_place: impl Fn(&Declaration) -> bool,
        is_meant: impl Fn(&Declarator) -> bool,
    ) -> Option<SoleDeclaration<'_>> {
        let tree = &self.program.tree;
        tree.decls.iter().find_map(|decl| {
            let DeclKind::Variables {
                qualifiers,
                ty,
                declarators,
            } = decl.kind
            else {
                return None;
            };
            let [declarator] = tree.declarators(declarators) else {
                return None;
            };
            let is_it = is_meant(declarator) && is_place(decl);
            let of = SoleDeclaration {
                whole: decl.extent,
                qualifiers: tree.qualifiers(qualifiers),
                ty,
                declarator,
            };
            (is_it && self.program.is_direct(decl.extent)).then_some(of)
        })
    }

    /// Edits that make an assignment of a declaration with a value.
    fn as_assignment(&self, of: &SoleDeclaration) -> Vec<Edit> {
        let whole = self.program.span(of.whole);
        let name = self.name_span(of.declarator);
        match of.declarator.init {
            Some(_) => vec![Edit::delete(Span::new(whole.start, name.start))],
            None => vec![Edit::delete(whole)],
        }
    }

    /// Edits that remove `const` from a declaration.
    fn without_const(&self, of: &SoleDeclaration) -> Vec<Edit> {
        let mut consts = of.qualifiers.iter();
        let found = consts.find(|q| q.kind == QualifierKind::Const);
        let next = |q: &Qualifier| self.program.token(q.extent.last + 1).map(|t| t.span.start);
        let edit = found.and_then(|q| {
            let start = self.program.span(q.extent).start;
            Some(Edit::delete(Span::new(start, next(q)?)))
        });
        edit.into_iter().collect()
    }

    /// The type of a declaration as it is written, and a value of it.
    fn type_and_zero(&self, of: &SoleDeclaration, variable: &Variable) -> Option<(&str, String)> {
        let is_plain = of.qualifiers.iter().all(|q| q.kind != QualifierKind::Const);
        let span = self.program.span(self.program.tree.ty(of.ty).extent);
        let zero = variable.ty.zero().filter(|_| is_plain)?;
        Some((self.program.sources.text(span), zero))
    }

    fn name_span(&self, of: &Declarator) -> Span {
        let token = self.program.token(of.ident.token);
        token.map_or(Span::default(), |token| token.span)
    }

    /// Where the name of a declarator and its array sizes end.
    fn end_of_header(&self, of: &Declarator) -> u32 {
        let sizes = self.program.tree.arrays(of.arrays);
        let last = sizes.last().map(|size| self.program.span(size.extent));
        last.unwrap_or_else(|| self.name_span(of)).end
    }

    /// The definition of a function around an address.
    fn function_at(&self, at: u32) -> Option<&FunctionDecl> {
        let program = self.program;
        let place = Span::at(at);
        let mut functions = program.tree.functions.iter();
        functions.find(|f| f.body.is_some() && program.span(f.extent).contains(place))
    }
}
