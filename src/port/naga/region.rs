//! Lowers regions: sequences, branches and loops.

use super::body::Body;
use super::target::{Res, TargetLanguage, Value};
use super::types::Sink;
use ::naga::{Block, Expression, Statement, SwitchCase, SwitchValue, UnaryOperator};
use shaderlint_ir::{
    Case, CaseLabel, Loop, LoopId, Module, OpId, Provenance, Region, Step, Switch, Visit,
};
use shaderlint_semantic::Scalar;
use shaderlint_syntax::ast::StmtId;

impl<'p> Visit<'p> for Body<'_, 'p> {
    type Out = Res<()>;

    fn module(&self) -> &'p Module {
        self.lowerer.form
    }

    /// Lowers the steps of a region up to the first that ends it.
    fn region(&mut self, region: Region) -> Res<()> {
        self.depth += 1;
        self.steps(self.lowerer.form.steps(region))?;
        self.depth -= 1;
        Ok(())
    }

    fn op(&mut self, op: OpId) -> Res<()> {
        self.operation(op)
    }

    fn branch(&mut self, condition: OpId, sides: [Region; 2], _: Provenance) -> Res<()> {
        let [then, otherwise] = sides;
        let condition = self.value(condition)?;
        let accept = self.nested(|it| it.region(then))?;
        let reject = self.nested(|it| it.region(otherwise))?;
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        Ok(())
    }

    fn looped(&mut self, _: LoopId, looped: &'p Loop) -> Res<()> {
        let in_loop = std::mem::replace(&mut self.in_loop, true);
        let in_switch = std::mem::replace(&mut self.in_switch, false);
        let body = self.nested(|it| {
            if looped.tests_first {
                it.region(looped.test)?;
                if let Some(condition) = looped.condition {
                    let holds = it.value(condition)?;
                    it.leave_unless(holds)?;
                }
            }
            it.region(looped.body)
        })?;
        let mut break_if = None;
        let continuing = self.nested(|it| {
            it.region(looped.step)?;
            if !looped.tests_first {
                it.region(looped.test)?;
                if let Some(condition) = looped.condition {
                    let expr = it.value(condition)?;
                    let op = UnaryOperator::LogicalNot;
                    break_if = Some(it.add(Expression::Unary { op, expr }));
                }
            }
            Ok(())
        })?;
        self.in_loop = in_loop;
        self.in_switch = in_switch;
        self.push(Statement::Loop {
            body,
            continuing,
            break_if,
        });
        Ok(())
    }

    /// Naga allows fallthrough only for empty cases, so the bodies that follow are duplicated.
    fn switch(&mut self, switch: &'p Switch) -> Res<()> {
        let form = self.lowerer.form;
        let selector = self.value(switch.selector)?;
        let scalar = form.scalar(switch.selector);
        let in_switch = std::mem::replace(&mut self.in_switch, true);
        let written = form.cases(switch);
        let mut cases = Vec::new();
        for (at, case) in written.iter().enumerate() {
            let body = self.nested(|it| it.run_on(written.get(at..).unwrap_or(&[])))?;
            for label in form.labels(case) {
                cases.push(SwitchCase {
                    value: value(*label, scalar),
                    body: Block::new(),
                    fall_through: true,
                });
            }
            if let Some(last) = cases.last_mut() {
                last.body = body;
                last.fall_through = false;
            }
        }
        self.in_switch = in_switch;
        if !cases.iter().any(|c| c.value == SwitchValue::Default) {
            cases.push(SwitchCase {
                value: SwitchValue::Default,
                body: Block::new(),
                fall_through: false,
            });
        }
        self.push(Statement::Switch { selector, cases });
        Ok(())
    }

    fn breaks(&mut self, _: StmtId) -> Res<()> {
        self.push(Statement::Break);
        Ok(())
    }

    fn continues(&mut self, _: StmtId) -> Res<()> {
        self.push(Statement::Continue);
        Ok(())
    }

    fn returns(&mut self, value: Option<OpId>, _: StmtId) -> Res<()> {
        let value = value.map(|value| self.value(value)).transpose()?;
        self.push(Statement::Return { value });
        Ok(())
    }

    fn discards(&mut self, _: StmtId) -> Res<()> {
        self.push(Statement::Kill);
        Ok(())
    }
}

impl<'p> Body<'_, 'p> {
    fn steps(&mut self, steps: &'p [Step]) -> Res<()> {
        for (at, step) in steps.iter().enumerate() {
            self.check_limits()?;
            let rest = steps.get(at + 1..).unwrap_or(&[]);
            if let Step::If {
                condition,
                then,
                otherwise,
                ..
            } = *step
                && let Some(returning) = self.divides(rest, [then, otherwise])
            {
                return self.divided(condition, [then, otherwise], returning, rest);
            }
            self.step(step)?;
            if self.is_terminated() {
                break;
            }
        }
        Ok(())
    }

    /// The side of a branch that returns, if the steps after the branch belong to the other side.
    ///
    /// WebGPU's compiler for Vulkan makes a function return at its end only: the steps after the
    /// branch run under a condition, with variables that have the values of both sides. If they take
    /// derivatives, the pixels that returned would contribute values that the returning side
    /// assigned. In WebGL these assignments have no effect.
    fn divides(&self, rest: &[Step], sides: [Region; 2]) -> Option<usize> {
        /// Nesting up to which this is done; WGSL has a limit of 127.
        const MAX_NESTING: u32 = 40;
        let form = self.lowerer.form;
        let is_wgsl = self.lowerer.language == TargetLanguage::Wgsl;
        if rest.is_empty() || !is_wgsl || self.depth > MAX_NESTING {
            return None;
        }
        let returning = sides.iter().position(|side| returns(form, *side))?;
        let mut runs = form.steps_in(rest).filter_map(|step| match step {
            Step::Run(run) => Some(*run),
            _ => None,
        });
        let takes = runs.any(|run| self.lowerer.takes_derivatives(run));
        takes.then_some(returning)
    }

    /// Lowers a branch of which one side returns, with the steps after it in the other side.
    fn divided(
        &mut self,
        condition: OpId,
        sides: [Region; 2],
        returning: usize,
        rest: &'p [Step],
    ) -> Res<()> {
        let condition = self.value(condition)?;
        let mut blocks = [Block::new(), Block::new()];
        self.depth += 1;
        for (i, (block, side)) in blocks.iter_mut().zip(sides).enumerate() {
            *block = self.nested(|it| {
                it.region(side)?;
                if i == returning || it.is_terminated() {
                    return Ok(());
                }
                it.steps(rest)
            })?;
        }
        self.depth -= 1;
        let [accept, reject] = blocks;
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        Ok(())
    }

    fn leave_unless(&mut self, condition: Value) -> Res<()> {
        let reject = self.nested(|it| {
            it.push(Statement::Break);
            Ok(())
        })?;
        self.push(Statement::If {
            condition,
            accept: Block::new(),
            reject,
        });
        Ok(())
    }

    /// Lowers a case and those that it falls through to.
    fn run_on(&mut self, cases: &[Case]) -> Res<()> {
        for case in cases {
            self.region(case.body)?;
            if self.is_terminated() {
                break;
            }
        }
        Ok(())
    }
}

/// Whether a region always ends by returning.
fn returns(form: &Module, region: Region) -> bool {
    match form.steps(region).last() {
        Some(Step::Return(..)) => true,
        Some(Step::If {
            then, otherwise, ..
        }) => returns(form, *then) && returns(form, *otherwise),
        _ => false,
    }
}

/// The label of a case, with the type of the selector.
fn value(label: CaseLabel, scalar: Option<Scalar>) -> SwitchValue {
    match (label, scalar) {
        (CaseLabel::Default, _) => SwitchValue::Default,
        (CaseLabel::Value(bits), Some(Scalar::Uint)) => SwitchValue::U32(bits),
        (CaseLabel::Value(bits), _) => SwitchValue::I32(bits as i32),
    }
}
