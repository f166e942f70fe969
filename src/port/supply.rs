//! What a project reads and the converter does not have, and what stands in its place.

use super::export::plain;
use super::{Input, InputKind, OutputId, Project, ProjectPass};
use shaderlint_semantic::Pass;

/// Something that is not at hand.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Missing {
    /// What reads it, like `image.0`.
    pub place: String,
    /// What it is.
    pub what: String,
    /// What stands in its place.
    pub stand_in: String,
    /// How to supply it; empty where it cannot be.
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

const BLACK: &str = "it is black";
const SIGNAL: &str = "a made-up spectrum and wave stand for it, as on the site";
const TUNE: &str = "a tune of our own is played for it";

/// What is missing, in the order of the passes.
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
            "no pass draws the buffer that it reads".to_string(),
            "it stays empty, as on the site".to_string(),
        ),
        InputKind::Webcam => (
            "the camera is asked for on the page".to_string(),
            "until then it is black".to_string(),
        ),
        InputKind::Microphone => (
            "the microphone is asked for on the page".to_string(),
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
        // Shells read brackets as patterns.
        let name = input.uniform.as_ref().filter(|n| !n.contains('['));
        let channel = name.unwrap_or(&place);
        format!("give it with `--channel {channel}=FILE`, or drop a file onto the page")
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

/// What an input reads instead of its file.
fn drawn(input: &Input) -> String {
    let is_music = matches!(input.kind, InputKind::Music | InputKind::MusicStream);
    match input.stand_in {
        Some(_) if is_music => TUNE.to_string(),
        Some(stand_in) if stand_in.title.is_empty() => "something like it is drawn".to_string(),
        Some(stand_in) => format!("something like `{}` is drawn for it", stand_in.title),
        None if is_music => SIGNAL.to_string(),
        None => BLACK.to_string(),
    }
}

fn lacks(word: &str, input: &Input) -> String {
    let article = if word == "music" { "" } else { "a " };
    match input.src.as_str() {
        "" => format!("it reads {article}{word}, and there is none"),
        src => format!(
            "it reads {article}{word} ({}) that lies on the site",
            plain(src)
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_at_hand_is_said() {
        let json = r#"{"renderpass":[{"type":"image","code":"","inputs":[
            {"type":"texture","channel":0,"filepath":"/media/a/x.jpg"},
            {"type":"keyboard","channel":1},{"type":"buffer","id":"4dXGR8","channel":2},
            {"type":"mic","channel":3}]}]}"#;
        let project = Project::from_json(json).unwrap();
        let said: Vec<String> = missing(&project).iter().map(Missing::to_string).collect();
        assert_eq!(
            said,
            [
                "image.0: it reads a texture (/media/a/x.jpg) that lies on the site; it is black; \
                 give it with `--channel image.0=FILE`, or drop a file onto the page",
                "image.2: no pass draws the buffer that it reads; it stays empty, as on the site",
                "image.3: the microphone is asked for on the page; a made-up spectrum and wave \
                 stand for it, as on the site",
            ]
        );
    }
}
