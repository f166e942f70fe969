//! Inputs of a project that are not available, and their substitutes.

use super::export::plain;
use crate::{Input, InputKind, OutputId, Project, ProjectPass};
use shaderlint_semantic::Pass;

/// An input that is not available.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Missing {
    /// The channel, such as `image.0`.
    pub place: String,
    /// What is missing.
    pub what: String,
    /// What the channel shows instead.
    pub stand_in: String,
    /// How to provide it; empty if that is not possible.
    pub help: String,
}

impl std::fmt::Display for Missing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}; {}", self.place, self.what, self.stand_in)?;
        if !self.help.is_empty() {
            write!(f, "; {}", self.help)?;
        }
        Ok(())
    }
}

const BLACK: &str = "the channel is black";
const SIGNAL: &str = "using a synthetic spectrum and waveform, as on ShaderToy";
const TUNE: &str = "using a synthetic tune";

/// The missing inputs, in the order of the passes.
pub fn missing(project: &Project) -> Vec<Missing> {
    let passes = project.passes.iter().filter(|p| p.kind != Pass::Common);
    let all = passes.flat_map(|pass| pass.inputs.iter().map(move |input| (pass, input)));
    all.filter_map(|(pass, input)| missing_input(project, pass, input))
        .collect()
}

fn missing_input(project: &Project, pass: &ProjectPass, input: &Input) -> Option<Missing> {
    let place = format!("{}.{}", pass.slug(), input.channel);
    let (what, stand_in) = match input.kind {
        _ if !input.urls.is_empty() => return None,
        InputKind::Keyboard => return None,
        InputKind::Buffer
            if project.draws(Pass::Buffer, &input.id) || project.draws(Pass::Image, &input.id) =>
        {
            return None;
        }
        InputKind::Cubemap
            if input.id == OutputId::CUBE
                && project.passes.iter().any(|p| p.kind == Pass::Cubemap) =>
        {
            return None;
        }
        InputKind::Buffer => (
            "no pass draws this buffer".to_string(),
            "the channel stays empty, as on ShaderToy".to_string(),
        ),
        InputKind::Webcam => (
            "the page asks for the camera".to_string(),
            "until then the channel is black".to_string(),
        ),
        InputKind::Microphone => (
            "the page asks for the microphone".to_string(),
            SIGNAL.to_string(),
        ),
        InputKind::Music | InputKind::MusicStream => (lacks("music", input), drawn(input)),
        kind => (lacks(kind.word(), input), drawn(input)),
    };
    let is_file = !matches!(
        input.kind,
        InputKind::Buffer | InputKind::Webcam | InputKind::Microphone
    );
    let shown = match &input.uniform {
        Some(name) => format!("{place} (`{name}`)"),
        None => place.clone(),
    };
    let help = if is_file {
        // Shells treat brackets as patterns.
        let name = input.uniform.as_ref().filter(|n| !n.contains('['));
        let channel = name.unwrap_or(&place);
        format!("use `--channel {channel}=FILE`, or drop a file on the page")
    } else {
        String::new()
    };
    Some(Missing {
        place: shown,
        what,
        stand_in,
        help,
    })
}

/// What a channel without its file shows.
fn drawn(input: &Input) -> String {
    let is_music = matches!(input.kind, InputKind::Music | InputKind::MusicStream);
    match input.stand_in {
        Some(_) if is_music => TUNE.to_string(),
        Some(stand_in) if stand_in.title.is_empty() => "using a generated stand-in".to_string(),
        Some(stand_in) => format!("using a generated stand-in for `{}`", stand_in.title),
        None if is_music => SIGNAL.to_string(),
        None => BLACK.to_string(),
    }
}

fn lacks(word: &str, input: &Input) -> String {
    match input.src.as_str() {
        "" => format!("no {word} file given"),
        src => format!("{word} file {} is not available", plain(src)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unavailable_media_are_reported() {
        let json = r#"{"renderpass":[{"type":"image","code":"","inputs":[
            {"type":"texture","channel":0,"filepath":"/media/a/x.jpg"},
            {"type":"keyboard","channel":1},{"type":"buffer","id":"4dXGR8","channel":2},
            {"type":"mic","channel":3}]}]}"#;
        let project = Project::from_json(json).unwrap();
        let messages: Vec<String> = missing(&project).iter().map(Missing::to_string).collect();
        assert_eq!(
            messages,
            [
                "image.0: texture file /media/a/x.jpg is not available; the channel is black; use \
                 `--channel image.0=FILE`, or drop a file on the page",
                "image.2: no pass draws this buffer; the channel stays empty, as on ShaderToy",
                "image.3: the page asks for the microphone; using a synthetic spectrum and waveform, \
                 as on ShaderToy",
            ]
        );
    }
}
