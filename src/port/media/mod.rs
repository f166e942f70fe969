//! Stand-ins for the files that ShaderToy keeps: textures, cube maps, volumes, films and music.
//!
//! A project names such files and does not hold them. What stands for one is drawn by a small shader
//! of our own, which the player runs once, into a texture of the file's size and format: a page grows
//! by a few hundred bytes, and has the same noise on every device, since that is made of integers.

mod stock;

use super::{Input, OutputId, Project};
use shaderlint_semantic::Pass;

/// What stands for a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StandIn {
    /// What the site calls the file; empty for one that is not known.
    pub title: &'static str,
    /// Width, height and depth; of a cube map those of a face, of a sound that of the texture which
    /// holds its samples.
    pub size: [u32; 3],
    /// Whether the player keeps one component only.
    pub is_gray: bool,
    /// What draws it.
    pub generator: Generator,
}

/// A shader that draws a stand-in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Generator {
    /// Its name, which no other has.
    pub name: &'static str,
    /// Declarations and `main`, what is shared, and its own.
    parts: &'static [&'static str],
}

impl Generator {
    /// The whole fragment shader, without its comments.
    pub fn fragment(&self) -> String {
        let lines = self.parts.iter().flat_map(|part| part.lines());
        let lines = lines.map(str::trim).filter(|l| !l.is_empty());
        let code = lines.filter(|l| !l.starts_with("//"));
        code.fold(String::new(), |text, line| text + line + "\n")
    }
}

/// Gives every channel whose file is not at hand what stands for it.
pub fn add_stand_ins(project: &mut Project) {
    let has_cube = project.passes.iter().any(|p| p.kind == Pass::Cubemap);
    for input in project.passes.iter_mut().flat_map(|p| &mut p.inputs) {
        let is_drawn = has_cube && input.id == OutputId::CUBE;
        if input.urls.is_empty() && !is_drawn {
            input.stand_in = stand_in(input);
        }
    }
}

/// What stands for the file of an input: that of the site's files which it names, else one of its
/// kind.
fn stand_in(input: &Input) -> Option<StandIn> {
    let known = stock::find(input).map(|file| file.stand_in);
    known.or_else(|| stock::of_kind(input.kind))
}

/// Whether the player keeps one component of an input's texture.
pub fn is_gray(input: &Input) -> bool {
    let known = stock::find(input).map(|file| file.stand_in);
    known.or(input.stand_in).is_some_and(|s| s.is_gray)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::InputKind;

    fn check(kind: InputKind, id: &str, src: &str, expected: &str) {
        let mut input = Input::empty(0, kind);
        (input.id, input.src) = (id.to_string(), src.to_string());
        let found = stand_in(&input);
        let said = found.map_or(String::new(), |s| {
            format!("{} {} {:?}", s.generator.name, s.title, s.size)
        });
        assert_eq!(said, expected, "{id} {src}");
    }

    #[test]
    fn files_are_known_by_id_and_by_path() {
        use InputKind::{Buffer, Cubemap, Music, Texture, Video, Volume, Webcam};
        let noise = "noise RGBA Noise Medium [256, 256, 1]";
        check(Texture, "Xsf3zn", "", noise);
        let path = "/media/a/f735bee5b64ef98879dc618b016ecf7939a5756040c2cde21ccb15e69a6e1cfb.png";
        check(Texture, "17", path, noise);
        check(Texture, "", "/presets/tex16.png", noise);
        check(Texture, "", "/presets/tex166.png", "picture  [512, 512, 1]");
        check(
            Texture,
            "",
            "/somewhere/tex16.png",
            "picture  [512, 512, 1]",
        );
        check(
            Cubemap,
            "",
            "/presets/cube00_0.jpg",
            "gallery Uffizi Gallery [512, 512, 1]",
        );
        check(Cubemap, "Xsf3zn", "", "sky  [256, 256, 1]");
        check(
            Volume,
            "XdX3Rr",
            "",
            "noise_volume RGBA Noise3D [32, 32, 32]",
        );
        check(Video, "4sX3Rn", "", "film  [512, 396, 1]");
        check(Music, "", "", "music  [1050, 672, 1]");
        check(Buffer, "4dXGR8", "", "");
        check(Webcam, "4sf3zn", "", "");
    }

    #[test]
    fn what_is_at_hand_needs_none() {
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
