//! What can be said only when all of the shader is known.

use super::super::host::EntryPoint;
use super::qualifier::{Qualified, Wanted};
use super::*;
use crate::diagnostic::Fix;
use crate::text::Edit;

/// Most outputs of a fragment shader.
const MAX_DRAW_BUFFERS: u64 = 8;
/// Deepest chain of calls that the browser takes.
const MAX_CALL_DEPTH: u32 = 256;

/// An output of a fragment shader.
#[derive(Clone, Copy, Debug)]
pub(super) struct Output {
    ident: Ident,
    location: Option<i32>,
    size: u32,
}

/// A loop that never ends, if its variable is never written to.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopCheck {
    pub variable: VariableId,
    pub keyword: Extent,
}

impl Checker<'_> {
    /// Remembers an output for the check of locations.
    pub(super) fn note_output(&mut self, declarator: &Declarator, qualified: &Qualified, ty: Type) {
        if self.stage == Stage::Fragment
            && qualified.storage == Wanted::Out
            && self.has(Feature::InOut)
            && !ty.is_error()
        {
            self.outputs.push(Output {
                ident: declarator.ident,
                location: qualified.layout.location,
                size: ty.array.max(1),
            });
        }
    }

    pub(super) fn finish(&mut self) {
        self.note_uses();
        self.check_entry();
        if !self.gave_up() {
            self.check_outputs();
            self.check_fragment_variables();
            self.check_total_size();
            for LoopCheck { variable, keyword } in std::mem::take(&mut self.loops) {
                if self
                    .variables
                    .get(variable.0 as usize)
                    .is_some_and(|v| !v.written)
                {
                    self.infinite_loop(keyword, Some(variable));
                }
            }
            self.check_calls();
        }
    }

    /// Says how often a name that nothing declares is used in all.
    fn note_uses(&mut self) {
        for (index, uses) in self.undeclared.values() {
            if let Some(d) = self.diagnostics.get_mut(*index).filter(|_| *uses > 0) {
                let times = if *uses == 1 {
                    "once".to_string()
                } else {
                    format!("{uses} times")
                };
                d.notes.push(format!("it is used {times} more"));
            }
        }
    }

    fn defines(&self, name: &str) -> bool {
        let functions = self.functions.iter().filter(|f| f.definition.is_some());
        functions.into_iter().any(|f| self.text(f.name) == name)
    }

    /// The place for what is missing from the shader as a whole: the start of its last text.
    fn whole_shader(&self) -> Span {
        let end = self.tokens.tokens.last().map_or(0, |t| t.span.end);
        self.sources
            .code_at(end)
            .map_or(Span::default(), |f| Span::at(f.base))
    }

    fn check_entry(&mut self) {
        match self.dialect.host().entry {
            Some(entry) if entry.is_called_by_host() => self.check_called_entry(entry),
            Some(entry) if !self.defines(entry.name) && !self.main_was_unreadable() => {
                self.missing_main();
            }
            _ => {}
        }
    }

    /// Whether `main` may be there after all, in text that could not be read.
    fn main_was_unreadable(&self) -> bool {
        self.syntax_errors && self.names.get("main").is_some()
    }

    fn missing_main(&mut self) {
        let decl = self
            .functions
            .iter()
            .find(|f| self.text(f.name) == "mainImage");
        let decl = decl.and_then(|f| self.tree.function(f.definition?));
        let d = match decl {
            Some(decl) => {
                let d = self.error(
                    error::UNWRAPPED_MAINIMAGE,
                    decl.header,
                    "`mainImage` is ShaderToy's; WebGL2 calls `main`",
                );
                self.wrap_main(d)
            }
            None => Diagnostic::error(
                error::MISSING_MAIN,
                self.whole_shader(),
                "the shader has no `main`",
            )
            .note("every shader starts at `void main()` (section 6.1)"),
        };
        self.report(d);
    }

    /// Adds the `main` that calls `mainImage`.
    fn wrap_main(&self, d: Diagnostic) -> Diagnostic {
        let end = self.tokens.tokens.last().map_or(0, |t| t.span.end);
        let output = self
            .outputs
            .first()
            .map(|o| self.text(o.ident.name).to_string());
        let mut text = String::from("\n");
        let name = output.unwrap_or_else(|| {
            text.push_str("out vec4 fragColor;\n");
            "fragColor".to_string()
        });
        text.push_str(&format!(
            "void main() {{\n    mainImage({name}, gl_FragCoord.xy);\n}}\n"
        ));
        d.help("`shaderport` makes the whole page").fix(Fix::safe(
            "add a `main` that calls it",
            vec![Edit::insert(end, text)],
        ))
    }

    /// The entry that a host declares and calls must be defined as it is declared.
    fn check_called_entry(&mut self, entry: EntryPoint) {
        let EntryPoint {
            name, signature, ..
        } = entry;
        let is_entry = |f: &&Function| self.text(f.name) == name;
        let wanted = self.functions.iter().find(is_entry);
        if wanted.is_none_or(|f| f.definition.is_some()) {
            return;
        }
        let other = self
            .functions
            .iter()
            .filter(is_entry)
            .find_map(|f| self.tree.function(f.definition?));
        if let Some(other) = other {
            return self.wrong_entry(other);
        }
        let unreadable = self.syntax_errors
            && self.names.get(name).is_some_and(|n| {
                self.tokens.tokens.iter().any(|t| {
                    t.kind == TokenKind::Identifier && t.value == n.0 && !self.in_prelude(t.span)
                })
            });
        if unreadable || self.unknown_functions.iter().any(|&n| self.text(n) == name) {
            return;
        }
        let message = format!("the pass has no `{name}`");
        let d = Diagnostic::error(error::MISSING_MAIN, self.whole_shader(), message)
            .note("the player calls it for every pixel or sample")
            .help(format!("define `{signature}`"));
        self.report(d);
    }

    fn in_prelude(&self, span: Span) -> bool {
        self.sources
            .file_at(span.start)
            .is_some_and(|f| f.role == Role::Prelude)
    }

    /// Outputs must not share a location, and several must all have one (section 4.3.8.2).
    fn check_outputs(&mut self) {
        let outputs = std::mem::take(&mut self.outputs);
        let mut taken: [Option<Ident>; MAX_DRAW_BUFFERS as usize] = Default::default();
        for output in &outputs {
            let name = self.text(output.ident.name);
            let first = output.location.unwrap_or(0) as u64;
            if first + output.size as u64 > MAX_DRAW_BUFFERS {
                let message = format!(
                    "the output `{name}` lies outside the {MAX_DRAW_BUFFERS} that there are"
                );
                let d = self.error_at(error::OUTPUT_LOCATION, output.ident.token, message);
                self.report(d);
                continue;
            }
            if output.location.is_none() {
                continue;
            }
            for at in first..first + output.size as u64 {
                match taken.get_mut(at as usize) {
                    Some(slot @ None) => *slot = Some(output.ident),
                    Some(Some(other)) => {
                        let other = *other;
                        let message = format!(
                            "the outputs `{name}` and `{}` share location {at}",
                            self.text(other.name)
                        );
                        let d = self
                            .error_at(error::OUTPUT_LOCATION, output.ident.token, message)
                            .label(self.token_span(other.token), "the other output");
                        self.report(d);
                        break;
                    }
                    None => {}
                }
            }
        }
        if outputs.len() > 1 {
            self.check_locations_given(&outputs);
        }
    }

    fn check_locations_given(&mut self, outputs: &[Output]) {
        let Some(without) = outputs.iter().find(|o| o.location.is_none()) else {
            return;
        };
        // The output of ShaderToy's own header has none: the user's is one too many.
        let users = outputs.iter().find(|o| !self.is_prelude(o.ident.token));
        if let (true, Some(output)) = (self.is_prelude(without.ident.token), users) {
            let message = format!(
                "the output `{}` stands beside that of the player",
                self.text(output.ident.name)
            );
            let d = self
                .error_at(error::OUTPUT_LOCATION, output.ident.token, message)
                .note("a ShaderToy pass has one output, the first parameter of its entry function");
            return self.report(d);
        }
        let name = self.text(without.ident.name);
        let d = self
            .error_at(
                error::OUTPUT_LOCATION,
                without.ident.token,
                format!("the output `{name}` has no location"),
            )
            .note("where a fragment shader has several outputs, each needs one (section 4.3.8.2)")
            .help(format!("write `layout(location = 0) out vec4 {name};`"));
        self.report(d);
    }

    fn check_fragment_variables(&mut self) {
        if let (Some(color), Some(data)) = (self.frag_color, self.frag_data) {
            let d = self
                .error_at(
                    error::OUTPUT_LOCATION,
                    color.max(data),
                    "`gl_FragColor` and `gl_FragData` cannot both be used",
                )
                .label(self.token_span(color.min(data)), "the other one");
            self.report(d);
        }
    }

    /// No recursion, no call of what is never defined, no chain that is too long.
    fn check_calls(&mut self) {
        let mut callees: Vec<Vec<(FunctionRef, ExprId)>> = vec![Vec::new(); self.functions.len()];
        let mut undefined: Vec<FunctionRef> = Vec::new();
        for call in std::mem::take(&mut self.calls) {
            self.calls.push(call);
            if let Some(list) = call.caller.and_then(|c| callees.get_mut(c.0 as usize))
                && !list.iter().rev().take(8).any(|(f, _)| *f == call.callee)
            {
                list.push((call.callee, call.expr));
            }
            let is_defined = self
                .functions
                .get(call.callee.0 as usize)
                .is_some_and(|f| f.definition.is_some());
            if !is_defined && !undefined.contains(&call.callee) {
                undefined.push(call.callee);
                self.report_undefined(call);
            }
        }
        self.walk_calls(&callees);
    }

    fn report_undefined(&mut self, call: Call) {
        let token = self.tree.expr(call.expr).extent.first;
        // The player's own call of a missing entry has been reported.
        if self.is_prelude(token) || self.syntax_errors {
            return;
        }
        let Some(function) = self.functions.get(call.callee.0 as usize) else {
            return;
        };
        let name = self.text(function.name);
        let declared = self
            .tree
            .function(function.declaration)
            .map(|f| f.ident.token);
        // What a host declares, it defines.
        if declared.is_some_and(|t| self.is_prelude(t)) {
            return;
        }
        let d = self.error_at(
            error::UNDEFINED_FUNCTION,
            token,
            format!("the function `{name}` is declared but never defined"),
        );
        let d = self.with_declaration(d, declared, "declared here");
        self.report(d);
    }

    /// Walks the call graph, callees first, without recursion.
    fn walk_calls(&mut self, callees: &[Vec<(FunctionRef, ExprId)>]) {
        #[derive(Clone, Copy, PartialEq)]
        enum Mark {
            New,
            Open,
            Done(u32),
        }
        let mut marks = vec![Mark::New; callees.len()];
        let mut reported_depth = false;
        for root in 0..callees.len() {
            let mut stack: Vec<(usize, usize)> = vec![(root, 0)];
            if marks.get(root) != Some(&Mark::New) {
                continue;
            }
            while let Some((function, next)) = stack.pop() {
                if let Some(mark) = marks.get_mut(function) {
                    *mark = Mark::Open;
                }
                let list = callees.get(function).map_or(&[][..], Vec::as_slice);
                if let Some(&(callee, _)) = list.get(next) {
                    stack.push((function, next + 1));
                    match marks.get(callee.0 as usize) {
                        Some(Mark::New) => stack.push((callee.0 as usize, 0)),
                        Some(Mark::Open) => {
                            let start = stack.iter().position(|(f, _)| *f == callee.0 as usize);
                            let cycle = stack.get(start.unwrap_or(0)..).unwrap_or(&[]);
                            let calls = cycle.iter().filter_map(|&(caller, next)| {
                                callees.get(caller)?.get(next.checked_sub(1)?)
                            });
                            let calls: Vec<_> = calls.copied().collect();
                            self.recursion(callee, &calls);
                        }
                        _ => {}
                    }
                    continue;
                }
                let depth = list
                    .iter()
                    .map(|(f, _)| match marks.get(f.0 as usize) {
                        Some(Mark::Done(depth)) => *depth,
                        _ => 0,
                    })
                    .max()
                    .unwrap_or(0)
                    + 1;
                if let Some(mark) = marks.get_mut(function) {
                    *mark = Mark::Done(depth);
                }
                if depth > MAX_CALL_DEPTH && !reported_depth {
                    reported_depth = true;
                    self.call_too_deep(function);
                }
            }
        }
    }

    /// Reports a function that calls itself by `calls`, the last of which is the one of `function`
    /// again. The place is the last call in the user's text.
    fn recursion(&mut self, function: FunctionRef, calls: &[(FunctionRef, ExprId)]) {
        let is_user =
            |call: &&(FunctionRef, ExprId)| !self.is_prelude(self.tree.expr(call.1).extent.first);
        let place = calls.iter().rev().find(is_user).or(calls.last());
        let Some(&(_, expr)) = place else {
            return;
        };
        let cycle: Vec<&str> = [function]
            .iter()
            .chain(calls.iter().map(|(callee, _)| callee))
            .filter_map(|f| self.functions.get(f.0 as usize))
            .map(|f| self.text(f.name))
            .collect();
        let name = cycle.first().copied().unwrap_or("");
        let message = if cycle.len() == 2 {
            format!("`{name}` calls itself")
        } else {
            let path: Vec<String> = cycle.iter().map(|n| format!("`{n}`")).collect();
            format!("`{name}` calls itself: {}", path.join(" calls "))
        };
        let d = self
            .error_expr(error::RECURSION, expr, message)
            .note("GLSL has no recursion (section 6.1)")
            .help("use a loop, and an array for what is still to do");
        self.report(d);
    }

    fn call_too_deep(&mut self, function: usize) {
        let decl = self
            .functions
            .get(function)
            .and_then(|f| self.tree.function(f.definition?));
        if let Some(decl) = decl {
            let d = self
                .error(
                    error::BROWSER_LIMIT,
                    decl.header,
                    "functions call functions to a depth of more than 256",
                )
                .note("the browser takes no longer chains of calls");
            self.report(d);
        }
    }
}
