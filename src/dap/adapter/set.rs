//! Breakpoints of the client.

use super::motion::filter_of;
use super::reply::{ClientState, DebugAnswer, Reply};
use super::session::{DebugSession, StopCause};
use crate::arguments::{DebugArguments, SetBreakpoints};
use crate::breakpoints::{Breakpoint, place_at};
use crate::debuggee::ProgramSource;
use crate::files::FileLine;
use serde_json::{Value, json};

impl DebugSession {
    /// Replaces the breakpoints of a source. Returns them for the client.
    pub(super) fn set(
        &mut self,
        client: &ClientState,
        programs: &dyn ProgramSource,
        set: &SetBreakpoints,
    ) -> Vec<Value> {
        let mut old = Vec::new();
        for breakpoint in std::mem::take(&mut self.breakpoints) {
            match breakpoint.source == set.source {
                true => old.push(breakpoint),
                false => self.breakpoints.push(breakpoint),
            }
        }
        let first = self.breakpoints.len();
        for given in &set.breakpoints {
            // One that stays keeps its number and its count.
            if let Some(same) = old.iter().position(|known| known.given == *given) {
                self.breakpoints.push(old.swap_remove(same));
                continue;
            }
            let line = (given.line + 1).saturating_sub(client.first_line);
            let column = given
                .column
                .map(|column| (column + 1).saturating_sub(client.first_column));
            let lines = self.lines_of(programs, (&set.source, line));
            let mut places = lines
                .into_iter()
                .map(|(file, line, last)| place_at(&self.debuggee, file, ((line, column), last)));
            let first = places.next();
            let missing = || Err("the file is not part of the program".to_string());
            let place = match first {
                Some(Err(_)) => places.find(Result::is_ok).or(first),
                found => found,
            };
            let place = place.unwrap_or_else(missing);
            let id = self.next_breakpoint;
            self.next_breakpoint += 1;
            self.breakpoints
                .push(Breakpoint::of(id, &set.source, given, place));
        }
        (first..self.breakpoints.len())
            .map(|at| self.shown_breakpoint(at))
            .collect()
    }

    /// A breakpoint for the client.
    pub(super) fn shown_breakpoint(&self, at: usize) -> Value {
        let Some(breakpoint) = self.breakpoints.get(at) else {
            return Value::Null;
        };
        // Without a line, nvim-dap takes a row for that of all breakpoints of the file.
        let mut row = json!({
            "id": breakpoint.id,
            "verified": breakpoint.place.is_ok(),
            "line": breakpoint.given.line,
        });
        let Some(fields) = row.as_object_mut() else {
            return row;
        };
        match &breakpoint.place {
            Ok(place) => {
                let program = self.debuggee.program();
                let at = program.and_then(|p| self.line_at(p, place.span.start));
                if let Some(FileLine::Disk(_, line) | FileLine::Virtual(_, line)) = at {
                    fields.insert("line".to_string(), (line + self.first_line - 1).into());
                }
                if let Some(hits) = &breakpoint.hits {
                    fields.insert("message".to_string(), hits.as_str().into());
                }
            }
            Err(message) => {
                fields.insert("message".to_string(), message.as_str().into());
            }
        }
        row
    }

    pub(super) fn data_breakpoint(&mut self, asked: &DebugArguments) -> Reply {
        let found = match asked.variables_reference {
            0 => self.part_of(asked).ok().map(|(id, _)| id),
            _ => self
                .part_of(&DebugArguments {
                    name: asked.name.clone(),
                    ..DebugArguments::default()
                })
                .ok()
                .map(|(id, _)| id),
        };
        Reply::with(match found {
            Some(id) => json!({
                "dataId": id.0.to_string(),
                "description": asked.name,
                "accessTypes": ["write"],
                "canPersist": false,
            }),
            None => json!({
                "dataId": null,
                "description": format!("`{}` is not a variable", asked.name),
            }),
        })
    }

    pub(super) fn set_data_breakpoints(&mut self, asked: &DebugArguments) -> Reply {
        self.data.clone_from(&asked.breakpoints);
        let known = asked.breakpoints.iter();
        let rows: Vec<Value> = known
            .map(|data| json!({ "verified": data.data_id.parse::<u32>().is_ok() }))
            .collect();
        Reply::with(json!({ "breakpoints": rows }))
    }

    pub(super) fn exception(&self) -> Reply {
        let id = match self.cause {
            Some(StopCause::Fault(fault)) => filter_of(fault),
            Some(StopCause::Uninitialized) => "uninitialized",
            None => "none",
        };
        let text = self
            .cause
            .map_or(String::new(), |cause| self.cause_text(cause));
        Reply::with(json!({
            "exceptionId": id,
            "description": text,
            "breakMode": "always",
        }))
    }

    pub(super) fn breakpoint_locations(
        &self,
        client: &ClientState,
        programs: &dyn ProgramSource,
        asked: &DebugArguments,
    ) -> DebugAnswer {
        let program = self.debuggee.program().ok_or("the program is gone")?;
        let line = |line: u32| (line + 1).saturating_sub(client.first_line);
        let (from, to) = (line(asked.line), line(asked.end_line.unwrap_or(asked.line)));
        let mut found: Vec<(u32, u32)> = Vec::new();
        for (file, start, last) in self.lines_of(programs, (&asked.source, from)) {
            let end = start.saturating_add(to.saturating_sub(from)).min(last);
            let places = self.debuggee.places.iter();
            let own = places.filter(|place| place.returned.is_none() && place.is_user);
            found.extend(own.filter_map(|place| {
                let at = program.sources.file(file)?.position(place.span.start);
                let is_own = program.sources.file_id_at(place.span.start) == Some(file);
                let is_inside = is_own && start <= at.line && at.line <= end;
                is_inside.then(|| (from + at.line - start, at.column))
            }));
        }
        found.sort_unstable();
        found.dedup();
        let rows = found.into_iter().map(|(line, column)| {
            json!({
                "line": line + client.first_line - 1,
                "column": column + client.first_column - 1,
            })
        });
        Ok(Reply::with(
            json!({ "breakpoints": rows.collect::<Vec<_>>() }),
        ))
    }
}
