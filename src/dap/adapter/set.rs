//! Breakpoints of the client.

use super::session::Session;
use super::{Answer, Client, Reply};
use crate::arguments::{Asked, SetBreakpoints};
use crate::breakpoints::{Breakpoint, place_at};
use crate::debuggee::Programs;
use serde_json::{Value, json};
use shaderlint_exec::Fault;

impl Session {
    /// Replaces the breakpoints of a source. Returns them for the client.
    pub(super) fn set(
        &mut self,
        client: &Client,
        programs: &dyn Programs,
        set: &SetBreakpoints,
    ) -> Vec<Value> {
        let file = self.file_of(programs, &set.source);
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
            let place = match file {
                Some(file) => place_at(&self.debuggee, file, (line, column)),
                None => Err("the file is not part of the program".to_string()),
            };
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
        let mut row = json!({ "id": breakpoint.id, "verified": breakpoint.place.is_ok() });
        let Some(fields) = row.as_object_mut() else {
            return row;
        };
        match &breakpoint.place {
            Ok(place) => {
                let program = self.debuggee.program();
                let file = program.and_then(|p| p.sources.file_at(place.span.start));
                if let Some(file) = file {
                    let line = file.position(place.span.start).line + self.first_line - 1;
                    fields.insert("line".to_string(), line.into());
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

    pub(super) fn data_breakpoint(&mut self, asked: &Asked) -> Reply {
        let found = match asked.variables_reference {
            0 => self.part_of(asked).ok().map(|(id, _)| id),
            _ => self
                .part_of(&Asked {
                    name: asked.name.clone(),
                    ..Asked::default()
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

    pub(super) fn set_data_breakpoints(&mut self, asked: &Asked) -> Reply {
        self.data.clone_from(&asked.breakpoints);
        let known = asked.breakpoints.iter();
        let rows: Vec<Value> = known
            .map(|data| json!({ "verified": data.data_id.parse::<u32>().is_ok() }))
            .collect();
        Reply::with(json!({ "breakpoints": rows }))
    }

    pub(super) fn exception(&self) -> Reply {
        let fault = self.fault;
        let id = match fault {
            Some(Fault::Exhausted(_)) => "exhausted",
            Some(Fault::Number(..)) => "number",
            None => "none",
        };
        let text = fault.map_or(String::new(), |fault| self.fault_text(fault));
        Reply::with(json!({
            "exceptionId": id,
            "description": text,
            "breakMode": "always",
        }))
    }

    pub(super) fn breakpoint_locations(&self, client: &Client, asked: &Asked) -> Answer {
        let program = self.debuggee.program().ok_or("the program is gone")?;
        let line = |line: u32| (line + 1).saturating_sub(client.first_line);
        let (from, to) = (line(asked.line), line(asked.end_line.unwrap_or(asked.line)));
        let places = self
            .debuggee
            .places
            .iter()
            .filter(|place| place.returned.is_none() && place.is_user);
        let mut found: Vec<(u32, u32)> = places
            .filter_map(|place| {
                let file = program.sources.file_at(place.span.start)?;
                let at = file.position(place.span.start);
                let is_own = asked
                    .source
                    .path
                    .as_deref()
                    .is_none_or(|path| path == file.path);
                (is_own && from <= at.line && at.line <= to).then_some((at.line, at.column))
            })
            .collect();
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
