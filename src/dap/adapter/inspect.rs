//! Requests about the moment that is shown: frames, variables, expressions.

use super::reply::{ClientState, DebugAnswer, Reply};
use super::session::{DebugSession, Handle};
use crate::arguments::DebugArguments;
use crate::evaluate::{DrawLimits, EvaluatedExpression, named};
use crate::places::StackFrame;
use crate::value::{DebugValue, is_simple};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};
use shaderlint_exec::QUAD;
use shaderlint_semantic::VariableId;
use std::ops::Range;
use std::rc::Rc;

/// The scopes of a frame.
const SCOPES: [(&str, &str); 3] = [
    ("Locals", "locals"),
    ("Globals", "globals"),
    ("Uniforms", "globals"),
];
/// Maximum number of expressions that stay compiled.
const MOST_COMPILED: usize = 64;

impl DebugSession {
    pub(super) fn threads(&self) -> Reply {
        let threads = self.timelines.iter().zip(1..).map(|(timeline, id)| {
            let [x, y] = timeline.pixel;
            json!({ "id": id, "name": format!("pixel {x},{y}") })
        });
        Reply::with(json!({ "threads": threads.collect::<Vec<_>>() }))
    }

    /// The lane of a thread.
    fn lane(&self, asked: &DebugArguments) -> usize {
        let lane = (asked.thread_id as usize).checked_sub(1);
        lane.filter(|lane| *lane < QUAD).unwrap_or(self.focus)
    }

    pub(super) fn stack(&mut self, client: &ClientState, asked: &DebugArguments) -> DebugAnswer {
        let lane = self.lane(asked);
        let frames = self.frames(lane)?;
        let levels = if asked.levels == 0 {
            frames.len()
        } else {
            asked.levels
        };
        let program = self.debuggee.program().ok_or("the program is gone")?;
        let shown = frames
            .iter()
            .enumerate()
            .skip(asked.start_frame)
            .take(levels);
        let shown = shown.map(|(at, frame)| {
            let function = frame.function.and_then(|f| program.function(f));
            let name = function.map_or("global variables", |f| program.names.text(f.name));
            let mut row = self.range(client, frame.span);
            let fields = json!({ "id": lane * 1000 + at + 1, "name": name });
            if let (Some(row), Some(fields)) = (row.as_object_mut(), fields.as_object()) {
                row.extend(fields.clone());
            }
            row
        });
        let shown: Vec<Value> = shown.collect();
        let body = json!({ "stackFrames": shown, "totalFrames": frames.len() });
        Ok(Reply::with(body))
    }

    /// The lane and frame of an id.
    fn frame(&mut self, id: Option<u32>) -> Result<(usize, usize, StackFrame), String> {
        let (lane, at) = match id.and_then(|id| id.checked_sub(1)) {
            Some(id) => (id as usize / 1000, id as usize % 1000),
            None => (self.focus, 0),
        };
        let frames = self.frames(lane)?;
        let frame = frames.get(at).copied();
        Ok((lane, at, frame.ok_or("there is no such frame")?))
    }

    pub(super) fn scopes(&mut self, asked: &DebugArguments) -> DebugAnswer {
        let (lane, at, frame) = self.frame(asked.frame_id)?;
        let variables = self.debuggee.variables(&frame);
        let mut scopes = Vec::new();
        for (number, ((name, hint), own)) in SCOPES.iter().zip(&variables).enumerate() {
            if own.is_empty() && number > 0 {
                continue;
            }
            self.handles.push(Handle::Scope {
                lane,
                frame: at,
                number,
            });
            scopes.push(json!({
                "name": name,
                "presentationHint": hint,
                "variablesReference": self.handles.len(),
                "namedVariables": own.len(),
                "expensive": false,
            }));
        }
        Ok(Reply::with(json!({ "scopes": scopes })))
    }

    pub(super) fn variables(&mut self, asked: &DebugArguments) -> DebugAnswer {
        let at = (asked.variables_reference as usize).checked_sub(1);
        let handle = at.and_then(|at| self.handles.get(at)).cloned();
        let mut rows = match handle.ok_or("these variables are no longer shown")? {
            Handle::Scope {
                lane,
                frame,
                number,
            } => self.scope(lane, frame, number)?,
            Handle::Parts(value, expression, variable) => {
                let program = self.debuggee.program().ok_or("the program is gone")?;
                let parts = value.parts(program).into_iter();
                parts
                    .map(|part| {
                        (
                            part.name,
                            part.value,
                            format!("{expression}{}", part.suffix),
                            variable,
                        )
                    })
                    .collect()
            }
        };
        if asked.count > 0 {
            rows = rows
                .into_iter()
                .skip(asked.start)
                .take(asked.count)
                .collect();
        }
        let rows: Vec<Value> = rows
            .into_iter()
            .map(|(name, value, expression, variable)| {
                let mut row = self.shown(&value, &expression, variable);
                if let Some(fields) = row.as_object_mut() {
                    fields.insert("name".to_string(), name.into());
                    fields.insert(
                        "value".to_string(),
                        fields.get("result").cloned().unwrap_or_default(),
                    );
                    fields.remove("result");
                    fields.insert("evaluateName".to_string(), expression.into());
                }
                row
            })
            .collect();
        Ok(Reply::with(json!({ "variables": rows })))
    }

    /// The variables of a scope that have values: name, value, expression, variable.
    #[expect(clippy::type_complexity, reason = "the rows of one table")]
    fn scope(
        &mut self,
        lane: usize,
        frame: usize,
        number: usize,
    ) -> Result<Vec<(String, DebugValue, String, Option<VariableId>)>, String> {
        let found = self.frames(lane)?.get(frame).copied();
        let found = found.ok_or("there is no such frame")?;
        let variables = self.debuggee.variables(&found);
        let own = variables.get(number).cloned().unwrap_or_default();
        self.at(lane, |debuggee, now| {
            let program = debuggee.program();
            let mut rows = Vec::new();
            if number == 0
                && frame == 0
                && let Some(value) = debuggee.returned(&now.replay, lane, &now.pause)
            {
                rows.push(("(returned)".to_string(), value, String::new(), None));
            }
            for id in own {
                let name = program.and_then(|p| Some(p.names.text(p.variable(id)?.name)));
                if let (Some(name), Some(value)) = (name, debuggee.value(&now.replay, lane, id)) {
                    rows.push((name.to_string(), value, name.to_string(), Some(id)));
                }
            }
            rows
        })
    }

    /// A value for the client.
    fn shown(
        &mut self,
        value: &DebugValue,
        expression: &str,
        variable: Option<VariableId>,
    ) -> Value {
        let Some(program) = self.debuggee.program() else {
            return Value::Null;
        };
        let (text, ty) = (value.text(program), program.type_name(value.ty));
        let parts = match is_simple(value.ty) {
            true => 0,
            false => value.parts(program).len(),
        };
        let reference = match parts {
            0 => 0,
            _ => {
                let handle = Handle::Parts(value.clone(), expression.to_string(), variable);
                self.handles.push(handle);
                self.handles.len()
            }
        };
        let counted = if value.ty.is_array() {
            "indexedVariables"
        } else {
            "namedVariables"
        };
        let mut row = json!({
            "result": text,
            "type": ty,
            "variablesReference": reference,
        });
        if let Some(fields) = row.as_object_mut() {
            if parts > 0 {
                fields.insert(counted.to_string(), parts.into());
            }
            if let Some(color) = value.color() {
                fields.insert("color".to_string(), color.into());
            }
        }
        row
    }

    pub(super) fn evaluate(&mut self, asked: &DebugArguments) -> DebugAnswer {
        let value = self.value_of(asked)?;
        Ok(Reply::with(self.shown(&value, &asked.expression, None)))
    }

    /// The value of an expression in a frame.
    fn value_of(&mut self, asked: &DebugArguments) -> Result<DebugValue, String> {
        let (lane, at, frame) = self.frame(asked.frame_id)?;
        let variables = self.debuggee.variables(&frame).concat();
        let simple = self.at(lane, |debuggee, now| {
            let program = debuggee.program()?;
            let name = |id: &VariableId| program.variable(*id).map(|v| program.names.text(v.name));
            named(program, &asked.expression, &mut |asked| {
                let id = variables.iter().find(|id| name(id) == Some(asked))?;
                debuggee.value(&now.replay, now.lane, *id)
            })
        })?;
        if let Some(value) = simple {
            return Ok(value);
        }
        let evaluated = self.compiled(&frame, &asked.expression)?;
        let count = self.count(lane, &frame)?;
        let pixel = self.timelines.get(lane).map_or([0; 2], |t| t.pixel);
        let values = evaluated.values(pixel, count);
        let mut values = values.map_err(|stop| stop.to_string())?;
        let is_reached = at == 0 || values.len() == count;
        let value = values.pop().filter(|_| is_reached);
        let value = value.ok_or("the expression has no value at this moment")?;
        self.own_type(value, &evaluated)
    }

    /// A value whose type is one of the debugged program; structs have the same numbers in its copies.
    fn own_type(
        &self,
        value: DebugValue,
        evaluated: &EvaluatedExpression,
    ) -> Result<DebugValue, String> {
        let other = evaluated.program().ok_or("the program is gone")?;
        let own = self.debuggee.program().ok_or("the program is gone")?;
        match own.type_name(value.ty) == other.type_name(value.ty) {
            true => Ok(value),
            false => Err("the type of the expression is unknown here".to_string()),
        }
    }

    /// An expression before the statement of a frame, compiled once.
    fn compiled(
        &mut self,
        frame: &StackFrame,
        expression: &str,
    ) -> Result<Rc<EvaluatedExpression>, String> {
        self.complete()?;
        let at = frame.extent.first;
        let mut known = self.compiled.iter();
        if let Some((.., known)) = known.find(|(place, text, _)| *place == at && text == expression)
        {
            return Ok(known.clone());
        }
        let made = Rc::new(EvaluatedExpression::of(&self.debuggee, frame, expression)?);
        if self.compiled.len() >= MOST_COMPILED {
            self.compiled.remove(0);
        }
        self.compiled
            .push((at, expression.to_string(), made.clone()));
        Ok(made)
    }

    /// The image of an expression over the screen, as a PNG.
    pub(super) fn image(&mut self, asked: &DebugArguments, threads: usize) -> DebugAnswer {
        let (.., frame) = self.frame(asked.frame_id)?;
        let evaluated = self.compiled(&frame, &asked.expression)?;
        let limits = DrawLimits {
            threads,
            budget: u64::MAX,
            interrupt: None,
        };
        let image = evaluated.image(&self.debuggee, limits)?;
        let image = image.map_err(|stop| stop.to_string())?;
        let bitmap = image.bitmap(&asked.expression);
        let [width, height] = bitmap.size;
        let png = bitmap.png()?;
        Ok(Reply::with(json!({
            "width": width,
            "height": height,
            "pixels": image.count(),
            "png": BASE64_STANDARD.encode(png),
        })))
    }

    /// The variable of a request, and which of its scalars are meant.
    pub(super) fn part_of(
        &mut self,
        asked: &DebugArguments,
    ) -> Result<(VariableId, Option<Range<usize>>), String> {
        let expression = match asked.expression.as_str() {
            "" => asked.name.as_str(),
            given => given,
        };
        let end = expression.find(['.', '[']).unwrap_or(expression.len());
        let (name, rest) = expression.split_at(end);
        let (lane, _, frame) = self.frame(asked.frame_id)?;
        let variables = self.debuggee.variables(&frame).concat();
        let program = self.debuggee.program().ok_or("the program is gone")?;
        let is_it = |id: &&VariableId| {
            let known = program.variable(**id);
            known.is_some_and(|v| program.names.text(v.name) == name)
        };
        let id = *variables
            .iter()
            .find(is_it)
            .ok_or_else(|| format!("unknown variable `{name}`"))?;
        if rest.is_empty() {
            return Ok((id, None));
        }
        let range = self.at(lane, |debuggee, now| {
            let program = debuggee.program()?;
            let whole = debuggee.value(&now.replay, lane, id)?;
            // The numbers of the scalars instead of their values show which are meant.
            let numbers = (0..whole.bits.len() as u32).collect();
            let numbered = DebugValue {
                ty: whole.ty,
                bits: numbers,
            };
            let part = named(program, expression, &mut |_| Some(numbered.clone()))?;
            let first = *part.bits.first()? as usize;
            Some(first..first + part.bits.len())
        })?;
        let range = range.ok_or_else(|| format!("`{expression}` is not a part of a variable"))?;
        Ok((id, Some(range)))
    }
}
