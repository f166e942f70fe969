//! A program that is debugged: the moment that is shown, and what the client asked about.

use super::reply::DebugEvent;
use crate::arguments::{DataBreakpointArgument, Launch};
use crate::breakpoints::{Breakpoint, starts};
use crate::debuggee::{Debuggee, ProgramSource};
use crate::evaluate::EvaluatedExpression;
use crate::files::{FileLine, ProgramFiles};
use crate::places::{StackFrame, StopPlace};
use crate::stepping::next;
use crate::timeline::Timeline;
use crate::value::DebugValue;
use serde_json::json;
use shaderlint_exec::{Fault, Pause, QUAD, Replay, lane_of};
use shaderlint_semantic::{Program, VariableId};
use shaderlint_text::SourceFile;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A program that is debugged.
pub struct DebugSession {
    pub debuggee: Debuggee,
    pub files: ProgramFiles,
    pub launch: Launch,
    /// By lane: the moments of its pixel.
    pub timelines: [Timeline; QUAD],
    /// The lane that is debugged.
    pub focus: usize,
    /// Its moment.
    pub moment: u32,
    /// Why the program has stopped, unless at a breakpoint or after a step.
    pub cause: Option<StopCause>,
    /// A pixel, and the moment at which it reads an uninitialised variable.
    pub uninitialized: Option<([u32; 2], Option<u32>)>,
    pub breakpoints: Vec<Breakpoint>,
    pub data: Vec<DataBreakpointArgument>,
    pub filters: Vec<String>,
    pub next_breakpoint: u32,
    /// 1 if the client counts lines from 1.
    pub first_line: u32,
    /// What references to variables refer to, while the program is stopped.
    pub handles: Vec<Handle>,
    /// Expressions that were compiled: the statement, the text, the program.
    pub compiled: Vec<(u32, String, Rc<EvaluatedExpression>)>,
}

/// What a program stops at besides breakpoints.
#[derive(Clone, Copy)]
pub enum StopCause {
    Fault(Fault),
    /// An uninitialised variable is read.
    Uninitialized,
}

/// What a reference to variables refers to.
#[derive(Clone)]
pub enum Handle {
    /// The variables of a frame: its lane, the index of the frame, and which of its scopes.
    Scope {
        lane: usize,
        frame: usize,
        number: usize,
    },
    /// The parts of a value, with its expression.
    Parts(DebugValue, String, Option<VariableId>),
}

/// A place to come back to after the program has changed.
pub struct Mark {
    line: FileLine,
    column: u32,
    /// The text with the line: its path and part, and what it has from the line on, by which the line is
    /// found after changes before it.
    text: (String, Option<String>),
    rest: String,
    /// How often the statement had been started.
    count: usize,
}

/// What is at a moment of a lane.
pub struct Now<'d> {
    pub replay: Replay<'d>,
    pub pause: Pause,
    pub lane: usize,
}

impl Mark {
    /// The line in a text that may have changed before it.
    fn line_in(&self, file: &SourceFile) -> Option<u32> {
        if file.path != self.text.0 || file.part != self.text.1 {
            return None;
        }
        let before = file.text.strip_suffix(&*self.rest)?;
        Some(before.matches('\n').count() as u32 + 1)
    }
}

impl DebugSession {
    /// A session at the first statement of a pixel.
    pub fn of(
        debuggee: Debuggee,
        (launch, pixel): (Launch, [u32; 2]),
        programs: &dyn ProgramSource,
    ) -> Result<DebugSession, String> {
        let mut session = DebugSession {
            files: ProgramFiles::of(&debuggee, programs),
            debuggee,
            launch,
            timelines: quad(pixel),
            focus: lane_of(pixel),
            moment: 1,
            cause: None,
            uninitialized: None,
            breakpoints: Vec::new(),
            data: Vec::new(),
            filters: Vec::new(),
            next_breakpoint: 1,
            first_line: 1,
            handles: Vec::new(),
            compiled: Vec::new(),
        };
        session.moment = session.first()?;
        Ok(session)
    }

    /// Shows another pixel, at its first statement.
    pub fn show_pixel(&mut self, pixel: [u32; 2]) -> Result<(), String> {
        self.timelines = quad(pixel);
        self.focus = lane_of(pixel);
        self.launch.request.pixel = Some(pixel);
        self.moment = self.first()?;
        for breakpoint in &mut self.breakpoints {
            breakpoint.forget();
        }
        self.forget_shown();
        Ok(())
    }

    /// The first moment in code of the user.
    fn first(&mut self) -> Result<u32, String> {
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, self.focus)?;
        let first = next(&self.debuggee, timeline, &draw, 0, &mut |_| true);
        let first = first.map_err(|stop| stop.to_string())?;
        first.ok_or_else(|| "the shader has no statement that this pixel runs".to_string())
    }

    /// Waits for the passes that the frame depends on. Before that, only the first stop is correct.
    pub fn complete(&mut self) -> Result<(), String> {
        let is_new = self.debuggee.is_pending();
        self.debuggee.complete()?;
        if is_new {
            self.timelines = self.timelines.each_ref().map(|t| Timeline::of(t.pixel));
            self.breakpoints.iter_mut().for_each(Breakpoint::forget);
            self.uninitialized = None;
        }
        Ok(())
    }

    /// Forgets what depends on the moment.
    pub fn forget_shown(&mut self) {
        self.handles.clear();
        self.cause = None;
    }

    /// The pixel that is debugged.
    pub fn pixel(&self) -> [u32; 2] {
        self.timelines.get(self.focus).map_or([0; 2], |t| t.pixel)
    }

    /// Calls `ask` with what is at the current moment of a lane; that of another lane is its last one
    /// before.
    pub fn at<T>(
        &mut self,
        lane: usize,
        ask: impl FnOnce(&Debuggee, &mut Now<'_>) -> T,
    ) -> Result<T, String> {
        let moment = match lane == self.focus {
            true => self.moment,
            false => self.moment_of_lane(lane)?,
        };
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let found = timeline
            .at(&draw, moment)
            .map_err(|stop| stop.to_string())?;
        let (replay, pause) = found.ok_or("the pixel does not run")?;
        let mut now = Now {
            replay,
            pause,
            lane,
        };
        Ok(ask(&self.debuggee, &mut now))
    }

    /// The last moment of another lane before the current one.
    fn moment_of_lane(&mut self, lane: usize) -> Result<u32, String> {
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, self.focus)?;
        let found = timeline
            .at(&draw, self.moment)
            .map_err(|stop| stop.to_string())?;
        let moment = found.and_then(|(_, pause)| pause.moments.get(lane).copied());
        Ok(moment.unwrap_or(1).max(1))
    }

    /// The frames of a lane at the current moment.
    pub fn frames(&mut self, lane: usize) -> Result<Vec<StackFrame>, String> {
        self.at(lane, |debuggee, now| debuggee.frames(now.pause.site))
    }

    /// How often the statement of a frame was started until the current moment.
    pub fn count(&mut self, lane: usize, frame: &StackFrame) -> Result<usize, String> {
        let token = frame.extent.first;
        let place = self.debuggee.places.iter().find(|place| {
            place.returned.is_none() && place.extent.first <= token && token <= place.extent.last
        });
        let place = *place.ok_or("the statement does not run")?;
        let moment = self.at(lane, |_, now| now.pause.moments.get(lane).copied())?;
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let starts = starts(&self.debuggee, timeline, &draw, &place);
        let starts = starts.map_err(|stop| stop.to_string())?;
        Ok(starts.partition_point(|start| *start <= moment.unwrap_or(0)))
    }

    /// The line that is shown, to come back to.
    pub fn mark(&mut self) -> Option<Mark> {
        let lane = self.focus;
        let frame = *self.frames(lane).ok()?.first()?;
        let count = self.count(lane, &frame).ok()?;
        let program = self.debuggee.program()?;
        let line = self.line_at(program, frame.span.start)?;
        let file = program.sources.file_at(frame.span.start)?;
        let position = file.position(frame.span.start);
        let before = position.line.saturating_sub(1);
        let lines = file.text.split_inclusive('\n');
        Some(Mark {
            line,
            column: position.column,
            text: (file.path.clone(), file.part.clone()),
            rest: lines.skip(before as usize).collect(),
            count,
        })
    }

    /// The line at an address.
    pub fn line_at(&self, program: &Program, address: u32) -> Option<FileLine> {
        let id = program.sources.file_id_at(address)?;
        let line = program.sources.file(id)?.position(address).line;
        self.files.line(id, line)
    }

    /// Goes to a place, as far as it exists.
    pub fn go_to_mark(&mut self, mark: &Option<Mark>) {
        let mark = mark.as_ref().filter(|_| self.complete().is_ok());
        if let Some(moment) = mark.and_then(|mark| self.moment_of_mark(mark)) {
            self.moment = moment;
        }
        self.forget_shown();
    }

    fn moment_of_mark(&mut self, mark: &Mark) -> Option<u32> {
        let program = self.debuggee.program()?;
        let files = program.sources.files().iter();
        let lines: Vec<(u32, u32)> = files
            .filter_map(|file| Some((file.base, mark.line_in(file)?)))
            .collect();
        let mut on_line = self.debuggee.places.iter().filter(|place| {
            let here = program.sources.file_at(place.span.start);
            let is_it =
                match here.and_then(|here| lines.iter().find(|(base, _)| *base == here.base)) {
                    Some((_, line)) => {
                        here.is_some_and(|here| here.position(place.span.start).line == *line)
                    }
                    None => self.line_at(program, place.span.start).as_ref() == Some(&mark.line),
                };
            is_it && place.returned.is_none() && place.is_user
        });
        // Such as the parts of `for`, of which each is a statement.
        let column = |place: &StopPlace| {
            let file = program.sources.file_at(place.span.start);
            file.map(|file| file.position(place.span.start).column)
        };
        let first = on_line.next()?;
        let mut all = std::iter::once(first).chain(on_line);
        let place = all.find(|place| column(place) == Some(mark.column));
        let place = *place.unwrap_or(first);
        let draw = self.debuggee.build.draw();
        let timeline = self.timelines.get_mut(self.focus)?;
        let starts = starts(&self.debuggee, timeline, &draw, &place).ok()?;
        starts
            .get(mark.count.min(starts.len()).checked_sub(1)?)
            .copied()
    }

    /// The event that the program has stopped.
    pub fn stopped(&self, reason: &str, description: Option<&str>) -> DebugEvent {
        let mut body = json!({
            "reason": reason,
            "threadId": self.focus + 1,
            "allThreadsStopped": true,
            "moment": self.moment,
        });
        if let (Some(text), Some(fields)) = (description, body.as_object_mut()) {
            fields.insert("description".to_string(), text.into());
            fields.insert("text".to_string(), text.into());
        }
        ("stopped", body)
    }

    /// Notes about inputs that were missing or replaced.
    pub fn notes(&self) -> Vec<DebugEvent> {
        let notes = self.debuggee.notes.iter();
        notes
            .map(|note| super::reply::output("console", &format!("note: {note}")))
            .collect()
    }

    /// Counts the pixels that hit breakpoints until `interrupt` is set, and tells the client.
    pub fn count_hits(
        &mut self,
        (threads, interrupt): (usize, &Arc<AtomicBool>),
    ) -> Vec<DebugEvent> {
        let mut events = Vec::new();
        let is_counted = |known: &Breakpoint| known.hits.is_some() || known.place.is_err();
        if self.debuggee.is_drawing() || self.breakpoints.iter().all(is_counted) {
            return events;
        }
        // The message is that of the motion that needs it.
        if self.complete().is_err() {
            return events;
        }
        for at in 0..self.breakpoints.len() {
            let Some(breakpoint) = self.breakpoints.get_mut(at) else {
                continue;
            };
            if is_counted(breakpoint) {
                continue;
            }
            if let Err(message) = breakpoint.count(&self.debuggee, (threads, interrupt)) {
                breakpoint.place = Err(message);
            }
            if !is_counted(breakpoint) {
                break;
            }
            let body = json!({ "reason": "changed", "breakpoint": self.shown_breakpoint(at) });
            events.push(("breakpoint", body));
        }
        events
    }
}

/// The moments of a lane.
pub fn focused(timelines: &mut [Timeline; QUAD], lane: usize) -> Result<&mut Timeline, String> {
    timelines
        .get_mut(lane)
        .ok_or_else(|| "there is no such thread".to_string())
}

/// The moments of the pixels of a quad.
fn quad([x, y]: [u32; 2]) -> [Timeline; QUAD] {
    let (x, y) = (x & !1, y & !1);
    [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]].map(Timeline::of)
}
