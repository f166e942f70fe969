//! Stand-ins for ShaderToy's media files: textures, cube maps, volumes, videos and music.
//!
//! A project refers to such files and does not contain them. A stand-in is drawn by a small shader,
//! which the player runs once, into a texture of the file's size and format. It adds a few hundred
//! bytes to a page, and its noise is the same on every device, since it uses integers.

mod stock;

use super::{Input, InputKind, OutputId, Project};
use shaderlint_semantic::Pass;

/// A stand-in for a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StandIn {
    /// The title of the file on ShaderToy; empty for an unknown file.
    pub title: &'static str,
    /// Width, height and depth in texels; for a cube map those of a face, for sound those of the
    /// texture with its samples.
    pub size: [u32; 3],
    /// Whether the player keeps only one component.
    pub is_gray: bool,
    /// The shader that draws it.
    pub generator: Generator,
}

/// A shader that draws a stand-in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Generator {
    /// The unique name.
    pub name: &'static str,
    /// Declarations and `main`, shared functions, and its own code.
    parts: &'static [&'static str],
}

impl Generator {
    /// The complete fragment shader, without its comments.
    pub fn fragment(&self) -> String {
        let lines = self.parts.iter().flat_map(|part| part.lines());
        let lines = lines.map(str::trim).filter(|l| !l.is_empty());
        let code = lines.filter(|l| !l.starts_with("//"));
        code.fold(String::new(), |text, line| text + line + "\n")
    }
}

/// Gives every channel with a missing file a stand-in.
pub fn add_stand_ins(project: &mut Project) {
    let has_cube = project.passes.iter().any(|p| p.kind == Pass::Cubemap);
    for input in project.passes.iter_mut().flat_map(|p| &mut p.inputs) {
        let is_drawn = has_cube && input.id == OutputId::CUBE;
        if input.urls.is_empty() && !is_drawn {
            input.stand_in = stand_in(input);
        }
    }
}

/// The stand-in for an input: the one for its file on ShaderToy, otherwise the one for its kind.
fn stand_in(input: &Input) -> Option<StandIn> {
    if input.kind == InputKind::Texture && input.id == OutputId::SCREEN {
        return Some(stock::of_screen());
    }
    let known = stock::find(input).map(|file| file.stand_in);
    known.or_else(|| stock::of_kind(input.kind))
}

/// Whether the player keeps only one component of an input's texture.
pub fn is_gray(input: &Input) -> bool {
    let known = stock::find(input).map(|file| file.stand_in);
    known.or(input.stand_in).is_some_and(|s| s.is_gray)
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_text::each_case;

    /// Each case is the kind of an input, its number, its path, and its placeholder.
    #[test]
    fn media_files_are_identified_by_id_or_path() {
        each_case(include_str!("media.txt"), |given, expected| {
            let [kind, id, src] = given.split(" ‖ ").collect::<Vec<_>>()[..] else {
                panic!("{given}");
            };
            let mut input = Input::empty(0, InputKind::of(kind).unwrap());
            (input.id, input.src) = (id.to_string(), src.to_string());
            let found = stand_in(&input).map_or("none".to_string(), |s| {
                format!("{} {} {:?}", s.generator.name, s.title, s.size)
            });
            assert_eq!(found, expected, "{given}");
        });
    }

    #[test]
    fn only_missing_media_get_placeholders() {
        let json = r#"{"renderpass":[
            {"type":"image","code":"","inputs":[
                {"type":"texture","channel":0,"filepath":"data:image/png;base64,AAAA"},
                {"type":"cubemap","channel":1,"id":"4dX3Rr"},
                {"type":"texture","channel":2,"id":"4dXGzn"}]},
            {"type":"cubemap","code":""}]}"#;
        let mut project = Project::from_json(json).unwrap();
        add_stand_ins(&mut project);
        let inputs = project.passes.iter().flat_map(|p| &p.inputs);
        let titles: Vec<_> = inputs.map(|i| i.stand_in.map(|s| s.title)).collect();
        assert_eq!(titles, [None, None, Some("Gray Noise Medium")]);
    }
}
