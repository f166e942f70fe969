//! Answers a run: draws a frame or a contact sheet, traces a pixel, or compares two shaders.

use super::bitmap::Bitmap;
use super::compare::{Compared, compare, compared_moments};
use super::facts::{RunFacts, SheetFacts};
use super::frame::{Frame, frame};
use super::rays::rays;
use super::request::{RunFront, RunRequest};
use super::setting::{RunProgress, ShotSetting};
use super::sheet;
use super::shot::{Loaded, Shot, shot};
use super::trace::{TraceFacts, trace};
use serde::Serialize;
use shaderlint_engine::inputs::Moment;
use shaderlint_exec::Watch;

/// The answer of a run.
pub struct RunAnswer {
    /// What is printed.
    pub facts: AnswerFacts,
    /// The image, if there is one.
    pub image: Option<Bitmap>,
    /// Notes about inputs that were missing or replaced.
    pub notes: Vec<String>,
}

/// What a run found.
#[derive(Serialize)]
#[serde(untagged)]
pub enum AnswerFacts {
    /// About a frame.
    Frame(Box<RunFacts>),
    /// About the frames of a contact sheet.
    Sheet(SheetFacts),
    /// About a pixel.
    Pixel(TraceFacts),
    /// About two shaders.
    Compared(Compared),
}

impl AnswerFacts {
    /// The text for people.
    pub fn text(&self) -> String {
        match self {
            AnswerFacts::Frame(facts) => facts.text(),
            AnswerFacts::Sheet(facts) => facts.text(),
            AnswerFacts::Pixel(facts) => facts.text(),
            AnswerFacts::Compared(facts) => facts.text(),
        }
    }

    /// The JSON object for programs.
    pub fn json(&self) -> String {
        let text = match self {
            // It lists every step.
            AnswerFacts::Pixel(_) => serde_json::to_string(self),
            _ => serde_json::to_string_pretty(self),
        };
        text.unwrap_or_default() + "\n"
    }

    /// Whether a comparison found a difference.
    pub fn differ(&self) -> bool {
        matches!(self, AnswerFacts::Compared(facts) if !facts.same)
    }

    /// Notes the path of the image that was written.
    pub fn written(&mut self, path: Option<String>) {
        match self {
            AnswerFacts::Frame(facts) => facts.output = path,
            AnswerFacts::Sheet(facts) => facts.output = path,
            AnswerFacts::Compared(facts) => facts.output = path,
            AnswerFacts::Pixel(_) => {}
        }
    }
}

/// Answers a request about a shader; with `other`, compares both. `progress` is called before each frame
/// that is drawn.
///
/// # Errors
/// A message about what cannot be drawn.
pub fn answer(
    request: &RunRequest,
    (loaded, other): (&Loaded, Option<&Loaded>),
    front: &RunFront<'_>,
    progress: &mut dyn FnMut(RunProgress),
) -> Result<RunAnswer, String> {
    let uniforms = request.uniforms();
    let setting = request.setting(front, uniforms.as_deref())?;
    if let Some(other) = other.filter(|_| request.pixel.is_none()) {
        return compared(request, [loaded, other], setting, progress);
    }
    let mut shot = shot(loaded, &setting)?;
    let notes = shot.notes(&loaded.project);
    let moment = request.moment();
    let mut one = |frame| {
        progress(RunProgress {
            images: [0, 1],
            frames: [frame, moment.frame],
        });
    };
    let (facts, image) = if let Some(pixel) = request.pixel {
        let facts = trace(loaded, &mut shot, &moment, pixel, &mut one)?;
        (AnswerFacts::Pixel(facts), None)
    } else if let Some(count) = request.sheet {
        let (image, facts) = sheet::draw(request, (loaded, &mut shot), count, progress)?;
        (AnswerFacts::Sheet(facts), Some(image))
    } else {
        let Frame { bitmap, mut facts } =
            frame(loaded, &mut shot, &moment, request.view(), &mut one)?;
        if request.report {
            let setting = ShotSetting {
                show: None,
                ..setting
            };
            facts.rays = rays(loaded, &shot, &setting, &moment);
        }
        (AnswerFacts::Frame(Box::new(facts)), Some(bitmap))
    };
    Ok(RunAnswer {
        facts,
        image,
        notes,
    })
}

/// Compares two shaders, in one frame if it is given and else in several.
fn compared(
    request: &RunRequest,
    both: [&Loaded; 2],
    setting: ShotSetting<'_>,
    progress: &mut dyn FnMut(RunProgress),
) -> Result<RunAnswer, String> {
    // Comparisons do not print the cost.
    let setting = ShotSetting {
        show: None,
        watch: Watch::Nothing,
        ..setting
    };
    let [one, other] = both.map(|loaded| shot(loaded, &setting));
    let (mut one, mut other) = (one?, other?);
    let moments = match request.time.is_some() || request.frame.is_some() {
        true => vec![request.moment()],
        false => compared_moments(setting.size, request.mouse()),
    };
    let mut report = |number: usize, frame| {
        let last = moments
            .get(number)
            .map_or(0, |moment: &Moment| moment.frame);
        progress(RunProgress {
            images: [number, moments.len()],
            frames: [frame, last],
        });
    };
    let names = both.map(|loaded| &*loaded.name);
    let shots: [&mut Shot; 2] = [&mut one, &mut other];
    let (facts, image) = compare(shots, names, setting.size, &moments, &mut report)?;
    Ok(RunAnswer {
        facts: AnswerFacts::Compared(facts),
        image,
        notes: Vec::new(),
    })
}
