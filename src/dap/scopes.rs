//! Which variables a statement can name.

use shaderlint_ir::{Module, Root};
use shaderlint_semantic::{FunctionRef, Program, VariableId};
use shaderlint_syntax::ast::{Extent, StmtKind, TokenId};

/// The variables of a program, with their scopes.
pub struct VariableScopes {
    /// Parameters and local variables, in the order of their declarations.
    locals: Vec<Local>,
    /// Global variables, inputs and outputs.
    pub globals: Vec<VariableId>,
    /// Uniforms.
    pub uniforms: Vec<VariableId>,
}

struct Local {
    variable: VariableId,
    function: FunctionRef,
    /// The token of its name.
    declared: TokenId,
    /// The last token of its scope.
    end: TokenId,
}

impl VariableScopes {
    pub fn of(program: &Program, module: &Module) -> VariableScopes {
        let mut scopes = VariableScopes {
            locals: Vec::new(),
            globals: Vec::new(),
            uniforms: Vec::new(),
        };
        let mut declared = Vec::new();
        for (id, known) in (0..).map(VariableId).zip(&module.variables) {
            let Some(token) = program.variable(id).and_then(|v| v.token) else {
                // Built-in variables that the shader uses.
                let is_used = program.variable(id).is_some_and(|v| v.read || v.written);
                if is_used && known.function.is_none() && known.root != Root::Uniform {
                    scopes.globals.push(id);
                }
                continue;
            };
            match (known.root, known.function) {
                (Root::Temporary, _) => {}
                (Root::Uniform, _) => scopes.uniforms.push(id),
                (_, Some(function)) => declared.push((token, id, function)),
                // Not those of the host.
                _ if program
                    .token(token)
                    .is_some_and(|t| program.is_user(t.span)) =>
                {
                    scopes.globals.push(id);
                }
                _ => {}
            }
        }
        declared.sort_by_key(|(token, ..)| *token);
        let blocks = blocks(program);
        let mut blocks = blocks.iter().peekable();
        let mut open: Vec<Extent> = Vec::new();
        for (token, variable, function) in declared {
            while let Some(block) = blocks.next_if(|block| block.first <= token) {
                open.push(*block);
            }
            open.retain(|block| token <= block.last);
            let end = open.last().map_or(token, |block| block.last);
            scopes.locals.push(Local {
                variable,
                function,
                declared: token,
                end,
            });
        }
        scopes
    }

    /// The parameters and local variables that a statement of a function can name, in the order of
    /// their declarations.
    pub fn locals(&self, program: &Program, function: FunctionRef, at: Extent) -> Vec<VariableId> {
        let is_visible = |local: &&Local| {
            local.function == function && local.declared < at.first && at.first <= local.end
        };
        let name = |id: VariableId| program.variable(id).map(|v| v.name);
        let mut seen: Vec<VariableId> = Vec::new();
        for local in self.locals.iter().filter(is_visible) {
            seen.retain(|outer| name(*outer) != name(local.variable));
            seen.push(local.variable);
        }
        seen
    }
}

/// What limits scopes, outer ones first.
fn blocks(program: &Program) -> Vec<Extent> {
    let statements = program.tree.stmts.iter().filter(|stmt| {
        let kind = &stmt.kind;
        kind.is_loop() || matches!(kind, StmtKind::Block(_) | StmtKind::Switch { .. })
    });
    let functions = program.tree.functions.iter().map(|f| f.extent);
    let mut blocks: Vec<Extent> = statements
        .map(|stmt| stmt.extent)
        .chain(functions)
        .collect();
    blocks.sort_by_key(|block| (block.first, std::cmp::Reverse(block.last)));
    blocks
}
