//! Lowering of functions, declarations and statements.

use super::super::form::*;
use super::{Lowerer, precision};
use shaderlint_semantic::{Base, FunctionRef, Type, VariableId};
use shaderlint_syntax::ast::*;

impl Lowerer<'_> {
    /// Declares the parameters of a function, which calls need before any body is lowered.
    pub(super) fn parameters(&mut self, function: FunctionRef, id: FunctionId) {
        let (program, tree) = (self.program, &self.program.tree);
        let (Some(decl), Some(known)) = (tree.function(id), program.function(function)) else {
            return;
        };
        self.function = Some(function);
        let start = self.module.parameter_lists.len() as u32;
        for (i, declared) in known.params.iter().enumerate() {
            let at = decl.params.start as usize + i;
            let named = program.declared_params.get(at).copied().flatten();
            let variable = named.unwrap_or_else(|| {
                let root = match (declared.direction.writes(), declared.direction.reads()) {
                    (true, true) => Root::ParameterInout,
                    (true, false) => Root::ParameterOut,
                    _ => Root::Parameter,
                };
                self.new_variable(declared.ty, root)
            });
            self.module.parameter_lists.push(variable);
            let param = tree.params(decl.params).get(i);
            if let Some(param) = param {
                let precision =
                    self.precisions
                        .declared(self.program, param.qualifiers, declared.ty);
                self.set_precision(variable, precision);
            }
        }
        let precision = self
            .precisions
            .declared(self.program, decl.qualifiers, known.returns);
        self.returned.insert(function, precision);
        if let Some(slot) = self.module.functions.get_mut(function.0 as usize) {
            slot.parameters = List {
                start,
                len: known.params.len() as u32,
            };
        }
        self.function = None;
    }

    /// Lowers the body of a function.
    pub(super) fn body(&mut self, function: FunctionRef, id: FunctionId) {
        let Some(body) = self.program.tree.function(id).and_then(|d| d.body) else {
            return;
        };
        self.function = Some(function);
        let first = self.next_op();
        let body = self.region(|l| l.statement(body));
        let ops = self.run_from(first);
        if let Some(slot) = self.module.functions.get_mut(function.0 as usize) {
            slot.body = Some(body);
            slot.ops = ops;
        }
        self.function = None;
    }

    fn set_precision(&mut self, variable: VariableId, precision: Precision) {
        if let Some(slot) = self.module.variables.get_mut(variable.0 as usize) {
            slot.precision = precision;
        }
    }

    /// Lowers a declaration, at global scope or in a function.
    pub(super) fn declaration(&mut self, id: DeclId) {
        let tree = &self.program.tree;
        match tree.decl(id).map(|d| d.kind) {
            Some(DeclKind::Variables {
                qualifiers,
                declarators,
                ..
            }) => {
                for (i, declarator) in (0..).zip(tree.declarators(declarators)) {
                    self.declarator(declarators.start + i, qualifiers, declarator);
                }
            }
            Some(DeclKind::Precision {
                precision: kind,
                ty,
            }) => {
                if let (TypeBase::Word(word), Some(precision)) =
                    (tree.ty(ty).base, precision::of_qualifier(kind))
                {
                    self.precisions.set(Type::of_word(word), precision);
                }
            }
            _ => {}
        }
    }

    /// Lowers one declarator; without an initialiser, the variable is undefined from here on.
    fn declarator(&mut self, at: u32, qualifiers: List, declarator: &Declarator) {
        let declared = self.program.declared.get(at as usize).copied().flatten();
        let Some(variable) = declared else {
            return;
        };
        let Some(found) = self.module.variable(variable).copied() else {
            return;
        };
        let precision = self
            .precisions
            .declared(self.program, qualifiers, found.ty.element());
        self.set_precision(variable, precision);
        let mut given = self.program.tree.qualifiers(qualifiers).iter();
        if given.any(|q| q.kind == QualifierKind::Flat)
            && let Some(slot) = self.module.variables.get_mut(variable.0 as usize)
        {
            slot.is_flat = true;
        }
        let has_value = matches!(found.root, Root::Local | Root::Global | Root::Output);
        if !has_value && declarator.init.is_none() {
            return;
        }
        let value = declarator.init.map(|init| self.value(init));
        self.at_declaration(declarator.ident.token);
        let value = value.unwrap_or_else(|| self.op(OpKind::Undef, found.ty));
        let place = self.place_of(variable, found.ty);
        self.store(place, value);
    }

    /// Declares the members of an interface block without an instance name as variables.
    pub(super) fn block(&mut self, members: StructId) {
        let program = self.program;
        let Some(members) = program.tree.structure(members) else {
            return;
        };
        for field in program.tree.fields(members.fields) {
            for i in 0..field.declarators.len {
                let at = (field.declarators.start + i) as usize;
                if let Some(variable) = program.declared.get(at).copied().flatten()
                    && let Some(ty) = self.module.variable(variable).map(|v| v.ty)
                {
                    let precision =
                        self.precisions
                            .declared(self.program, field.qualifiers, ty.element());
                    self.set_precision(variable, precision);
                }
            }
        }
    }

    /// Lowers a statement; one that is nested too deeply becomes unknown.
    pub(super) fn statement(&mut self, id: StmtId) {
        if self.deeper(|l| l.statement_at(id)).is_none() {
            self.origin = Provenance::Stmt(id);
            self.op(OpKind::Unknown, Type::VOID);
        }
    }

    fn statement_at(&mut self, id: StmtId) {
        let tree = &self.program.tree;
        self.origin = Provenance::Stmt(id);
        match tree.stmt(id).kind {
            StmtKind::Error => {
                self.op(OpKind::Unknown, Type::VOID);
            }
            StmtKind::Empty | StmtKind::Case(_) | StmtKind::Default => {}
            StmtKind::Expr(expr) => {
                self.value(expr);
            }
            StmtKind::Decl(decl) => self.declaration(decl),
            StmtKind::Block(body) => {
                let precisions = self.precisions.clone();
                for &inner in tree.block(body) {
                    self.statement(inner);
                }
                self.precisions = precisions;
            }
            StmtKind::If {
                condition,
                then,
                otherwise,
            } => {
                let condition = self.value(condition);
                let then = self.region(|l| l.statement(then));
                let otherwise = otherwise.map(|s| self.region(|l| l.statement(s)));
                self.step(Step::If {
                    condition,
                    then,
                    otherwise: otherwise.unwrap_or_default(),
                    origin: Provenance::Stmt(id),
                });
            }
            StmtKind::Switch { selector, body } => self.switch(id, selector, body),
            StmtKind::For { .. } | StmtKind::While { .. } | StmtKind::Do { .. } => self.looped(id),
            StmtKind::Break => self.step(Step::Break(id)),
            StmtKind::Continue => self.step(Step::Continue(id)),
            StmtKind::Return(value) => {
                let value = value.map(|v| self.value(v));
                let is_void = value.is_none_or(|v| self.module.ty(v).is_void());
                self.step(Step::Return(value.filter(|_| !is_void), id));
            }
            StmtKind::Discard => self.step(Step::Discard(id)),
        }
    }

    fn looped(&mut self, id: StmtId) {
        let mut condition = None;
        let mut first = self.next_op();
        let mut made = Loop {
            test: Region::default(),
            condition: None,
            body: Region::default(),
            step: Region::default(),
            tests_first: true,
            ops: self.run_from(first),
            stmt: id,
        };
        match self.program.tree.stmt(id).kind {
            StmtKind::For {
                init,
                condition: test,
                step,
                body,
            } => {
                self.statement(init);
                first = self.next_op();
                if let Some(test) = test {
                    made.test = self.region(|l| condition = l.condition(test));
                }
                made.body = self.region(|l| l.statement(body));
                if let Some(step) = step {
                    made.step = self.region(|l| {
                        l.value(step);
                    });
                }
            }
            StmtKind::While {
                condition: test,
                body,
            } => {
                made.test = self.region(|l| condition = l.condition(test));
                made.body = self.region(|l| l.statement(body));
            }
            StmtKind::Do {
                body,
                condition: test,
            } => {
                made.tests_first = false;
                made.body = self.region(|l| l.statement(body));
                made.test = self.region(|l| condition = Some(l.value(test)));
            }
            _ => {}
        }
        made.condition = condition;
        made.ops = self.run_from(first);
        let at = LoopId(self.module.loops.len() as u32);
        self.module.loops.push(made);
        self.step(Step::Loop(at));
    }

    /// Lowers the condition of a loop: an expression, or a declaration with an initialiser.
    fn condition(&mut self, id: StmtId) -> Option<OpId> {
        let (program, tree) = (self.program, &self.program.tree);
        self.origin = Provenance::Stmt(id);
        match tree.stmt(id).kind {
            StmtKind::Expr(expr) => Some(self.value(expr)),
            StmtKind::Decl(decl) => {
                self.declaration(decl);
                let DeclKind::Variables { declarators, .. } = tree.decl(decl)?.kind else {
                    return None;
                };
                let at = declarators.start as usize;
                let variable = program.declared.get(at).copied().flatten()?;
                let place = self.place_of(variable, program.variable(variable)?.ty);
                Some(self.load(place))
            }
            _ => None,
        }
    }

    fn switch(&mut self, id: StmtId, selector: ExprId, body: List) {
        let tree = &self.program.tree;
        let selector = self.value(selector);
        let precisions = self.precisions.clone();
        let statements = tree.block(body);
        let is_label =
            |s: &StmtId| matches!(tree.stmt(*s).kind, StmtKind::Case(_) | StmtKind::Default);
        // Statements before the first label are unreachable.
        let first = statements.iter().position(is_label);
        let mut rest = first.and_then(|f| statements.get(f..)).unwrap_or(&[]);
        let mut cases = Vec::new();
        while !rest.is_empty() {
            let labels = rest.iter().take_while(|s| is_label(s)).count();
            let (heads, after) = rest.split_at(labels);
            let statements = after.iter().take_while(|s| !is_label(s)).count();
            let (own, next) = after.split_at(statements);
            rest = next;
            let start = self.module.label_lists.len() as u32;
            for head in heads {
                let label = self.label(*head);
                self.module.label_lists.push(label);
            }
            let body = self.region(|l| own.iter().for_each(|s| l.statement(*s)));
            cases.push(Case {
                labels: List {
                    start,
                    len: labels as u32,
                },
                body,
            });
        }
        self.precisions = precisions;
        let start = self.module.case_lists.len() as u32;
        let len = cases.len() as u32;
        self.module.case_lists.extend(cases);
        let at = SwitchId(self.module.switches.len() as u32);
        self.module.switches.push(Switch {
            selector,
            cases: List { start, len },
            stmt: id,
        });
        self.step(Step::Switch(at));
    }

    fn label(&self, id: StmtId) -> CaseLabel {
        let program = self.program;
        match program.tree.stmt(id).kind {
            StmtKind::Case(value) => match program.scalar(value) {
                Some(value) => CaseLabel::Value(value.as_int() as u32),
                None => CaseLabel::Value(0),
            },
            _ => CaseLabel::Default,
        }
    }

    /// Whether a type is a struct or block.
    pub(super) fn is_record(ty: Type) -> bool {
        matches!(ty.base, Base::Struct(_) | Base::Block(_))
    }
}
