//! Breakpoints: the moments at which a pixel hits them, and how many pixels of the image do.

use super::arguments::{BreakpointArgument, SourceArgument};
use super::debuggee::{Debuggee, message};
use super::evaluate::{DrawLimits, EvaluatedExpression};
use super::places::{StackFrame, StopPlace};
use super::stepping::moment_of;
use super::timeline::Timeline;
use shaderlint_exec::{CompileOptions, Draw, QUAD, Stop, draw};
use shaderlint_text::number::grouped;
use shaderlint_text::{FileId, SetAt};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The number of instructions per thread after which pixels are no longer counted: a second or two.
const COUNT_BUDGET: u64 = 100_000_000;
const UNCOUNTED: &str = "the image takes too long to count the pixels that hit it";

/// A breakpoint of a client.
pub struct Breakpoint {
    pub id: u32,
    /// The source as the client names it.
    pub source: SourceArgument,
    pub given: BreakpointArgument,
    /// The place that it stops at, or why there is none.
    pub place: Result<StopPlace, String>,
    /// By lane: the moments at which it is hit, once they are known.
    moments: [Option<Vec<u32>>; QUAD],
    /// How many pixels hit it, once that is known.
    pub hits: Option<String>,
}

impl Breakpoint {
    /// A breakpoint at the first statement on a line or after it.
    pub fn of(
        id: u32,
        source: &SourceArgument,
        given: &BreakpointArgument,
        place: Result<StopPlace, String>,
    ) -> Breakpoint {
        let hits = given.hit_condition.as_deref().map(HitCondition::read);
        Breakpoint {
            id,
            source: source.clone(),
            given: given.clone(),
            place: match hits {
                Some(Err(message)) => Err(message),
                _ => place,
            },
            moments: Default::default(),
            hits: None,
        }
    }

    /// Forgets at which moments pixels hit it: others are shown.
    pub fn forget(&mut self) {
        self.moments = Default::default();
    }

    /// Whether it prints a message instead of stopping.
    pub fn is_log(&self) -> bool {
        self.given.log_message.is_some()
    }

    /// The moments at which a pixel hits it, in order.
    ///
    /// # Errors
    /// The pixel ran out of fuel, or the condition cannot be evaluated.
    pub fn moments(
        &mut self,
        debuggee: &Debuggee,
        timeline: &mut Timeline,
        draw: &Draw<'_>,
    ) -> Result<&[u32], String> {
        let lane = timeline.lane();
        let is_known = self.moments.get(lane).is_some_and(Option::is_some);
        if !is_known {
            let found = self.find(debuggee, timeline, draw);
            if let Err(message) = &found {
                self.place = Err(message.clone());
            }
            self.moments.set_at(lane, Some(found.unwrap_or_default()));
        }
        let known = self.moments.get(lane).and_then(Option::as_ref);
        Ok(known.map_or(&[], |moments| moments))
    }

    fn find(
        &self,
        debuggee: &Debuggee,
        timeline: &mut Timeline,
        draw: &Draw<'_>,
    ) -> Result<Vec<u32>, String> {
        let Ok(place) = &self.place else {
            return Ok(Vec::new());
        };
        let mut moments =
            starts(debuggee, timeline, draw, place).map_err(|stop| stop.to_string())?;
        if let Some(condition) = &self.given.condition {
            let evaluated = EvaluatedExpression::of(debuggee, &frame(debuggee, place)?, condition)?;
            if !evaluated.is_condition() {
                return Err(format!("the condition `{condition}` is not a `bool`"));
            }
            let values = evaluated.values(timeline.pixel, usize::MAX);
            let values = values.map_err(|stop| stop.to_string())?;
            let mut values = values.iter();
            moments.retain(|_| values.next().is_some_and(|value| value.is_true()));
        }
        if let Some(text) = &self.given.hit_condition {
            let condition = HitCondition::read(text)?;
            let mut number = 0;
            moments.retain(|_| {
                number += 1;
                condition.holds(number)
            });
        }
        Ok(moments)
    }

    /// The pixels are not counted: never, or not yet.
    fn uncounted(&mut self, stop: &Stop) {
        if *stop != Stop::Cancelled {
            self.hits = Some(UNCOUNTED.to_string());
        }
    }

    /// Counts the pixels of the image that hit it, unless `interrupt` is set before the end.
    ///
    /// # Errors
    /// A message about a draw that cannot be run.
    pub fn count(
        &mut self,
        debuggee: &Debuggee,
        (threads, interrupt): (usize, &Arc<AtomicBool>),
    ) -> Result<(), String> {
        let Ok(place) = &self.place else {
            return Ok(());
        };
        let [width, height] = debuggee.size;
        let all = u64::from(width) * u64::from(height);
        let (pixels, times) = match &self.given.condition {
            Some(condition) => {
                let frame = frame(debuggee, place)?;
                let any = EvaluatedExpression::ever(debuggee, &frame, condition)?;
                let limits = DrawLimits {
                    threads,
                    budget: COUNT_BUDGET,
                    interrupt: Some(interrupt.clone()),
                };
                let image = match any.image(debuggee, limits)? {
                    Ok(image) => image,
                    Err(stop) => {
                        self.uncounted(&stop);
                        return Ok(());
                    }
                };
                (image.count_true(), None)
            }
            None => {
                let options = CompileOptions {
                    steps: true,
                    ..CompileOptions::default()
                };
                let variant = debuggee.variant(None, &options);
                let variant = variant.map_err(message)?;
                let mut whole = variant.draw();
                whole.budget = COUNT_BUDGET;
                whole.cancelled = Some(interrupt.clone());
                let drawn = match draw(&whole, threads) {
                    Ok(drawn) => drawn,
                    Err(stop) => {
                        self.uncounted(&stop);
                        return Ok(());
                    }
                };
                let mut statements = variant.code.statements().iter().zip(&drawn.seen.statements);
                let found = statements.find(|(extent, _)| **extent == place.extent);
                let seen = found.map(|(_, seen)| *seen).unwrap_or_default();
                (seen.pixels, Some(seen.times))
            }
        };
        let mut text = format!("hit by {} of {} pixels", grouped(pixels), grouped(all));
        if let Some(times) = times.filter(|times| *times > pixels) {
            text.push_str(&format!(", {} times", grouped(times)));
        }
        self.hits = Some(text);
        Ok(())
    }
}

/// The moments at which a pixel starts a statement.
pub fn starts(
    debuggee: &Debuggee,
    timeline: &mut Timeline,
    draw: &Draw<'_>,
    place: &StopPlace,
) -> Result<Vec<u32>, Stop> {
    let lane = timeline.lane();
    let mut moments = Vec::new();
    timeline.scan(draw, 0, &mut |_, pause| {
        if let Some(pause) = pause
            && let Some(found) = debuggee.places.at(pause.site)
            && found.extent == place.extent
            && found.returned.is_none()
        {
            moments.push(moment_of(&pause, lane));
        }
        false
    })?;
    Ok(moments)
}

/// The frame of a place, for expressions: of any call.
pub fn frame(debuggee: &Debuggee, place: &StopPlace) -> Result<StackFrame, String> {
    let mut sites = (0..).zip(debuggee.places.iter());
    let site = sites.find(|(_, p)| p.extent == place.extent && p.returned.is_none());
    let frames = site.map(|(site, _)| debuggee.frames(site));
    let frame = frames.and_then(|frames| frames.first().copied());
    frame.ok_or_else(|| "the statement is gone".to_string())
}

/// The place of a breakpoint: the first statement of a file that starts at a line, from 1, or after it,
/// until the line `last`.
///
/// # Errors
/// A message if there is none.
pub fn place_at(
    debuggee: &Debuggee,
    file: FileId,
    ((line, column), last): ((u32, Option<u32>), u32),
) -> Result<StopPlace, String> {
    let program = debuggee.program().ok_or("the program is gone")?;
    let text = program
        .sources
        .file(file)
        .ok_or("the file is not part of the program")?;
    let asked_at = (line, column.unwrap_or(0));
    let starts = debuggee.places.iter().filter_map(|place| {
        let is_own = text.span().contains(place.span) && place.returned.is_none();
        let at = text.position(place.span.start);
        let at = (at.line, at.column);
        let is_in_range = at >= asked_at && at.0 <= last;
        (is_own && place.is_user && is_in_range).then_some((at, place))
    });
    let first = starts.min_by_key(|(at, _)| *at);
    first
        .map(|(_, place)| *place)
        .ok_or_else(|| "there is no statement that runs".to_string())
}

/// After how many hits a breakpoint stops.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum HitCondition {
    Equal(u64),
    Less(u64),
    More(u64),
    EachOf(u64),
}

impl HitCondition {
    /// Reads `5`, `== 5`, `> 5`, `>= 5`, `< 5`, `<= 5` or `% 5`.
    fn read(text: &str) -> Result<HitCondition, String> {
        let text = text.trim();
        let digits = text.trim_start_matches(['=', '<', '>', '%']);
        let sign = text.strip_suffix(digits).unwrap_or("");
        let number = digits.trim().parse::<u64>().ok();
        let condition = number.and_then(|number| match sign {
            "" | "=" | "==" => Some(HitCondition::Equal(number)),
            "<" => Some(HitCondition::Less(number)),
            "<=" => Some(HitCondition::Less(number + 1)),
            ">" => Some(HitCondition::More(number)),
            ">=" => Some(HitCondition::More(number.saturating_sub(1))),
            "%" if number > 0 => Some(HitCondition::EachOf(number)),
            _ => None,
        });
        let expected = "expected a number of hits such as 5, >= 5 or % 5";
        condition.ok_or_else(|| expected.to_string())
    }

    const fn holds(self, number: u64) -> bool {
        match self {
            HitCondition::Equal(n) => number == n,
            HitCondition::Less(n) => number < n,
            HitCondition::More(n) => number > n,
            HitCondition::EachOf(n) => number.is_multiple_of(n),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hit_conditions_compare_the_hit_count() {
        let hits = |text: &str| -> Vec<u64> {
            let condition = HitCondition::read(text).unwrap();
            (1..=6).filter(|n| condition.holds(*n)).collect()
        };
        assert_eq!(hits("2"), [2]);
        assert_eq!(hits(">= 5"), [5, 6]);
        assert_eq!(hits("> 5"), [6]);
        assert_eq!(hits("<=2"), [1, 2]);
        assert_eq!(hits("% 3"), [3, 6]);
        assert!(HitCondition::read("% 0").is_err() && HitCondition::read("i > 3").is_err());
    }
}
