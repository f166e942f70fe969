//! Requests that go to another moment.

use super::reply::{DebugAnswer, DebugEvent, Reply, output};
use super::session::{DebugSession, StopCause, focused};
use crate::arguments::DebugArguments;
use crate::debuggee::Debuggee;
use crate::evaluate::EvaluatedExpression;
use crate::stepping::{StepKind, StepStart, moment_of, next, step, written};
use crate::uninitialized;
use serde_json::{Value, json};
use shaderlint_exec::{Fault, FaultKind, Replay};
use shaderlint_semantic::VariableId;

/// Maximum number of messages of breakpoints per motion.
const MOST_MESSAGES: usize = 1000;

/// Where a motion ends, and why.
struct MotionGoal {
    moment: u32,
    reason: &'static str,
    breakpoints: Vec<u32>,
    cause: Option<StopCause>,
}

impl MotionGoal {
    /// A moment without a breakpoint.
    fn at(moment: u32, reason: &'static str, cause: Option<StopCause>) -> MotionGoal {
        MotionGoal {
            moment,
            reason,
            breakpoints: Vec::new(),
            cause,
        }
    }
}

impl DebugSession {
    /// Chooses the pixel that a request is about.
    fn focus_on(&mut self, asked: &DebugArguments) -> Result<(), String> {
        self.complete()?;
        let lane = (asked.thread_id as usize)
            .checked_sub(1)
            .unwrap_or(self.focus);
        if lane != self.focus {
            let moment = self.at(lane, |_, now| moment_of(&now.pause, lane))?;
            (self.focus, self.moment) = (lane, moment);
        }
        Ok(())
    }

    /// Runs to the next breakpoint or fault, or to the end.
    pub fn resume(&mut self, asked: &DebugArguments) -> DebugAnswer {
        self.focus_on(asked)?;
        let from = self.moment;
        let goal = self.forwards()?;
        let messages = self.messages(from, goal.as_ref().map_or(u32::MAX, |goal| goal.moment));
        let body = json!({ "allThreadsContinued": true });
        self.arrive(goal, (true, body), messages)
    }

    /// Runs back to the last breakpoint or fault, or to the beginning.
    pub fn reverse(&mut self, asked: &DebugArguments) -> DebugAnswer {
        self.focus_on(asked)?;
        let goal = self.backwards()?;
        self.arrive(goal, (false, Value::Null), Vec::new())
    }

    /// Steps.
    pub fn step(&mut self, asked: &DebugArguments, kind: StepKind) -> DebugAnswer {
        self.focus_on(asked)?;
        let (lane, from) = (self.focus, self.moment);
        let place = self.at(lane, |debuggee, now| {
            debuggee.places.at(now.pause.site).copied()
        })?;
        let place = place.ok_or("the statement is gone")?;
        let start = StepStart {
            moment: from,
            place,
        };
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let moment = step(&self.debuggee, timeline, &draw, (kind, start));
        let moment = moment.map_err(|stop| stop.to_string())?;
        drop(draw);
        let is_forwards = !matches!(kind, StepKind::Back | StepKind::BackIn | StepKind::BackOut);
        let goal = moment.map(|moment| MotionGoal::at(moment, "step", None));
        // A breakpoint or a chosen fault inside a call ends the step over it.
        let is_next = goal.as_ref().is_some_and(|goal| goal.moment <= from + 1);
        let goal = match is_forwards && !is_next {
            true => match (self.forwards()?, goal) {
                (Some(first), Some(goal)) if first.moment >= goal.moment => Some(goal),
                (first, goal) => first.or(goal),
            },
            false => goal,
        };
        let to = goal.as_ref().map_or(u32::MAX, |goal| goal.moment);
        let messages = match is_forwards {
            true => self.messages(from, to),
            false => Vec::new(),
        };
        self.arrive(goal, (is_forwards, Value::Null), messages)
    }

    /// Goes back to the statement that wrote a variable or a part of it.
    pub fn written(&mut self, asked: &DebugArguments) -> DebugAnswer {
        self.complete()?;
        let (variable, part) = self.part_of(asked)?;
        let lane = self.focus;
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let moment = written(timeline, &draw, self.moment, (variable, part));
        let moment = moment.map_err(|stop| stop.to_string())?;
        drop(draw);
        let moment = moment.ok_or("nothing has written it before")?;
        self.moment = moment;
        self.forget_shown();
        Ok(Reply::events(vec![
            self.stopped("goto", Some("written here")),
        ]))
    }

    /// The first breakpoint or chosen fault after the current moment.
    fn forwards(&mut self) -> Result<Option<MotionGoal>, String> {
        let from = self.moment;
        let hits = self.hits()?;
        let first = hits
            .iter()
            .map(|(moment, _)| *moment)
            .filter(|m| *m > from)
            .min();
        // The fault of the current statement was seen if it is shown.
        let is_shown = self.cause.is_some();
        let watched = self.watched();
        let lane = self.focus;
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let (debuggee, filters) = (&self.debuggee, &self.filters);
        let mut goal = None;
        if !filters.is_empty() || !watched.is_empty() {
            timeline
                .scan(&draw, from, &mut |replay, pause| {
                    let now = pause.map_or(u32::MAX, |pause| moment_of(&pause, lane));
                    let fault = chosen_fault(debuggee, filters, replay);
                    let before = match pause {
                        Some(_) => now.saturating_sub(1),
                        None => 0,
                    };
                    let is_new = before > from || !is_shown;
                    let is_written = replay.writes().any(|(v, _)| watched.contains(&v));
                    goal = match fault.filter(|_| is_new && pause.is_some()) {
                        Some(fault) => Some(MotionGoal::at(
                            before,
                            "exception",
                            Some(StopCause::Fault(fault)),
                        )),
                        None if is_written && pause.is_some() => {
                            Some(MotionGoal::at(now, "data breakpoint", None))
                        }
                        None => None,
                    };
                    goal.is_some() || first.is_some_and(|first| now >= first)
                })
                .map_err(|stop| stop.to_string())?;
        }
        let goal = self.with_uninitialized(goal, (from + 1, u32::MAX))?;
        Ok(match (goal, first) {
            (Some(goal), first) if first.is_none_or(|first| goal.moment < first) => Some(goal),
            (_, Some(first)) => Some(goal_at(first, &hits)),
            (goal, None) => goal,
        })
    }

    /// The last breakpoint or chosen fault before the current moment.
    fn backwards(&mut self) -> Result<Option<MotionGoal>, String> {
        let before = self.moment;
        let hits = self.hits()?;
        let last = hits
            .iter()
            .map(|(moment, _)| *moment)
            .filter(|m| *m < before)
            .max();
        let watched = self.watched();
        let lane = self.focus;
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let (debuggee, filters) = (&self.debuggee, &self.filters);
        let mut goal = None;
        if !filters.is_empty() || !watched.is_empty() {
            // The fault of a statement is known at the stop after it.
            let seen = timeline.scan_back(&draw, before.saturating_add(1), &mut |replay, pause| {
                let now = moment_of(&pause, lane);
                let fault = chosen_fault(debuggee, filters, replay);
                let is_written = replay.writes().any(|(v, _)| watched.contains(&v));
                match fault {
                    Some(fault) if now > 1 && now - 1 < before => Some(MotionGoal::at(
                        now - 1,
                        "exception",
                        Some(StopCause::Fault(fault)),
                    )),
                    _ if is_written && now < before => {
                        Some(MotionGoal::at(now, "data breakpoint", None))
                    }
                    _ => None,
                }
            });
            goal = seen.map_err(|stop| stop.to_string())?;
        }
        let goal = match self.with_uninitialized(None, (0, before.saturating_sub(1)))? {
            Some(found) if goal.as_ref().is_none_or(|goal| goal.moment < found.moment) => {
                Some(found)
            }
            _ => goal,
        };
        Ok(match (goal, last) {
            (Some(goal), last) if last.is_none_or(|last| goal.moment > last) => Some(goal),
            (_, Some(last)) => Some(goal_at(last, &hits)),
            (goal, None) => goal,
        })
    }

    /// The earlier of a goal and the read of an uninitialised variable in a range of moments, if the client
    /// stops at those.
    fn with_uninitialized(
        &mut self,
        goal: Option<MotionGoal>,
        (first, last): (u32, u32),
    ) -> Result<Option<MotionGoal>, String> {
        if !self.filters.iter().any(|filter| filter == "uninitialized") {
            return Ok(goal);
        }
        let pixel = self.pixel();
        let moment = match self.uninitialized {
            Some((known, moment)) if known == pixel => moment,
            _ => uninitialized::first(&self.debuggee, pixel)?,
        };
        self.uninitialized = Some((pixel, moment));
        let moment = moment.filter(|moment| first <= *moment && *moment <= last);
        Ok(match moment {
            Some(moment) if goal.as_ref().is_none_or(|goal| moment < goal.moment) => Some(
                MotionGoal::at(moment, "exception", Some(StopCause::Uninitialized)),
            ),
            _ => goal,
        })
    }

    /// The moments at which breakpoints stop, with their numbers.
    fn hits(&mut self) -> Result<Vec<(u32, u32)>, String> {
        let lane = self.focus;
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let mut hits = Vec::new();
        for breakpoint in &mut self.breakpoints {
            if breakpoint.is_log() {
                continue;
            }
            let id = breakpoint.id;
            let moments = breakpoint.moments(&self.debuggee, timeline, &draw)?;
            hits.extend(moments.iter().map(|moment| (*moment, id)));
        }
        Ok(hits)
    }

    /// What breakpoints print between two moments.
    fn messages(&mut self, after: u32, until: u32) -> Vec<DebugEvent> {
        let mut messages: Vec<(u32, DebugEvent)> = Vec::new();
        for at in 0..self.breakpoints.len() {
            if let Err(message) = self.add_messages(at, (after, until), &mut messages) {
                messages.push((0, output("stderr", &message)));
            }
        }
        messages.sort_by_key(|(moment, _)| *moment);
        let cut = messages.len().saturating_sub(MOST_MESSAGES);
        messages.truncate(MOST_MESSAGES);
        let mut events: Vec<DebugEvent> = messages.into_iter().map(|(_, event)| event).collect();
        if cut > 0 {
            events.push(output(
                "console",
                &format!("{cut} more messages are not shown"),
            ));
        }
        events
    }

    fn add_messages(
        &mut self,
        at: usize,
        (after, until): (u32, u32),
        messages: &mut Vec<(u32, DebugEvent)>,
    ) -> Result<(), String> {
        let lane = self.focus;
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, lane)?;
        let Some(breakpoint) = self.breakpoints.get_mut(at) else {
            return Ok(());
        };
        let Some(text) = breakpoint.given.log_message.clone() else {
            return Ok(());
        };
        let moments = breakpoint
            .moments(&self.debuggee, timeline, &draw)?
            .to_vec();
        if !moments.iter().any(|m| *m > after && *m <= until) {
            return Ok(());
        }
        let Ok(place) = breakpoint.place else {
            return Ok(());
        };
        let starts = crate::breakpoints::starts(&self.debuggee, timeline, &draw, &place);
        let starts = starts.map_err(|stop| stop.to_string())?;
        let frame = crate::breakpoints::frame(&self.debuggee, &place)?;
        let mut parts = Vec::new();
        for (is_expression, part) in interpolated(&text) {
            let values = match is_expression {
                true => {
                    let evaluated = EvaluatedExpression::of(&self.debuggee, &frame, part)?;
                    let values = evaluated.values(self.timelines_pixel(lane), usize::MAX);
                    let values = values.map_err(|stop| stop.to_string())?;
                    let program = evaluated.program().ok_or("the program is gone")?;
                    values.iter().map(|value| value.text(program)).collect()
                }
                false => Vec::new(),
            };
            parts.push((part.to_string(), is_expression, values));
        }
        for moment in moments.into_iter().filter(|m| *m > after && *m <= until) {
            let number = starts.partition_point(|start| *start < moment);
            let line: String = parts
                .iter()
                .map(|(part, is_expression, values)| match is_expression {
                    true => values.get(number).map_or("?", String::as_str),
                    false => part.as_str(),
                })
                .collect();
            messages.push((moment, output("stdout", &line)));
        }
        Ok(())
    }

    fn timelines_pixel(&self, lane: usize) -> [u32; 2] {
        self.timelines.get(lane).map_or([0; 2], |t| t.pixel)
    }

    /// The variables of data breakpoints.
    fn watched(&self) -> Vec<VariableId> {
        let ids = self
            .data
            .iter()
            .filter_map(|data| data.data_id.parse().ok());
        ids.map(VariableId).collect()
    }

    /// Goes to a goal; without one, to the end or the beginning.
    fn arrive(
        &mut self,
        goal: Option<MotionGoal>,
        (is_forwards, body): (bool, Value),
        mut events: Vec<DebugEvent>,
    ) -> DebugAnswer {
        let goal = match goal {
            Some(goal) => goal,
            None => {
                let moment = self.last_moment(is_forwards)?;
                if is_forwards && moment == self.moment {
                    events.push(("terminated", Value::Null));
                    return Ok(Reply { body, events });
                }
                MotionGoal::at(moment, if is_forwards { "step" } else { "entry" }, None)
            }
        };
        self.moment = goal.moment;
        self.forget_shown();
        self.cause = goal.cause;
        let text = goal.cause.map(|cause| self.cause_text(cause));
        let (name, mut event) = self.stopped(goal.reason, text.as_deref());
        if let (false, Some(fields)) = (goal.breakpoints.is_empty(), event.as_object_mut()) {
            fields.insert("hitBreakpointIds".to_string(), json!(goal.breakpoints));
        }
        events.push((name, event));
        Ok(Reply { body, events })
    }

    /// The last moment, or the first, in code of the user.
    fn last_moment(&mut self, is_forwards: bool) -> Result<u32, String> {
        let draw = self.debuggee.build.draw();
        let timeline = focused(&mut self.timelines, self.focus)?;
        let lane = timeline.lane();
        if !is_forwards {
            let first = next(&self.debuggee, timeline, &draw, 0, &mut |_| true);
            return Ok(first.map_err(|stop| stop.to_string())?.unwrap_or(1));
        }
        let mut last = self.moment;
        let places = &self.debuggee.places;
        let ended = timeline.scan(&draw, self.moment, &mut |_, pause| {
            if let Some(pause) = pause
                && places.at(pause.site).is_some_and(|place| place.is_user)
            {
                last = moment_of(&pause, lane);
            }
            false
        });
        ended.map_err(|stop| stop.to_string())?;
        Ok(last)
    }

    /// Why the program has stopped, in words.
    pub fn cause_text(&self, cause: StopCause) -> String {
        let module = &self.debuggee.build.module;
        let program = self.debuggee.program();
        let fault = match cause {
            StopCause::Uninitialized => return "an uninitialised variable is read".to_string(),
            StopCause::Fault(fault) => fault,
        };
        match fault {
            Fault::Exhausted(_) => "the loop runs out of iterations".to_string(),
            Fault::Number(op, kind) => {
                let extent = program.and_then(|p| module.provenance(op).extent(&p.tree));
                let text = program.zip(extent).map(|(p, e)| p.sources.text(p.span(e)));
                let text = text.map_or(String::new(), |text| format!(" `{text}`"));
                let what = match kind {
                    FaultKind::Nan => "is NaN",
                    FaultKind::Infinite => "is infinite",
                    FaultKind::DivisionByZero => "divides by zero",
                    FaultKind::OutOfRange => "is out of range",
                    FaultKind::Undefined => "is undefined",
                };
                format!("{text} {what}").trim_start().to_string()
            }
        }
    }
}

/// The breakpoints at a moment.
fn goal_at(moment: u32, hits: &[(u32, u32)]) -> MotionGoal {
    let here = hits.iter().filter(|(at, _)| *at == moment);
    MotionGoal {
        moment,
        reason: "breakpoint",
        breakpoints: here.map(|(_, id)| *id).collect(),
        cause: None,
    }
}

/// A fault that a client chose to stop at.
fn chosen_fault(debuggee: &Debuggee, filters: &[String], replay: &Replay<'_>) -> Option<Fault> {
    let faults = replay.faults().iter().copied();
    let mut chosen = faults.filter(|fault| filters.iter().any(|f| f == filter_of(*fault)));
    chosen.find(|fault| match *fault {
        // Others end this way as a rule.
        Fault::Exhausted(id) => debuggee.ends_early(id),
        Fault::Number(..) => true,
    })
}

/// The filter of a fault.
pub const fn filter_of(fault: Fault) -> &'static str {
    match fault {
        Fault::Exhausted(_) => "exhausted",
        Fault::Number(_, FaultKind::Nan) => "nan",
        Fault::Number(_, FaultKind::Infinite) => "infinite",
        Fault::Number(_, FaultKind::DivisionByZero) => "division",
        Fault::Number(_, FaultKind::OutOfRange) => "index",
        Fault::Number(_, FaultKind::Undefined) => "undefined",
    }
}

/// The parts of a message: text, and expressions in braces.
fn interpolated(text: &str) -> Vec<(bool, &str)> {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        let Some((expression, next)) = after.split_once('}') else {
            break;
        };
        parts.extend([(false, before), (true, expression)]);
        rest = next;
    }
    parts.push((false, rest));
    parts
}
