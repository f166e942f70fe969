//! The channels of a project whose inputs nobody gave, and a `channels.toml` that gives them.

use super::channel::STAND_IN;
use crate::{Input, InputKind, Project, ProjectPass, Wrapper};
use shaderlint_semantic::Pass;
use std::fmt::Write;

/// A channel that reads what its lookups require, because nothing says what it reads.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AssumedInput {
    /// The pass, such as `image`.
    pub pass: &'static str,
    /// The name of the sampler, such as `iChannel0`.
    pub channel: String,
    /// What the channel shows.
    pub shows: String,
}

/// The head of a file that gives inputs.
const HEAD: &str = "\
# Each channel reads a file, a pass such as \"buffer_a\", \"keyboard\", \"webcam\", \"mic\",
# or \"stand-in\": a generated image.
";

impl Project {
    /// The channels without a given input, in the order of the passes. An export gives all.
    pub fn assumed(&self) -> Vec<AssumedInput> {
        let all = self.assumed_inputs();
        let all = all.map(|(pass, input)| AssumedInput {
            pass: pass.slug(),
            channel: match &input.uniform {
                Some(name) => name.clone(),
                None => format!("iChannel{}", input.channel),
            },
            shows: shows(input),
        });
        all.collect()
    }

    fn assumed_inputs(&self) -> impl Iterator<Item = (&ProjectPass, &Input)> {
        let passes = self.passes.iter().filter(|p| p.kind != Pass::Common);
        let all = passes.flat_map(|pass| pass.inputs.iter().map(move |input| (pass, input)));
        all.filter(|(_, input)| !input.is_given && !self.is_export)
    }

    /// The text of a `channels.toml` that gives the assumed inputs, so that the project stays as it
    /// is.
    pub fn assumed_file(&self) -> String {
        let (mut samplers, mut tables) = (String::new(), String::new());
        let mut last = "";
        for (pass, input) in self.assumed_inputs() {
            let source = match input.kind {
                InputKind::Buffer => self.slug_of(&input.id).unwrap_or(STAND_IN),
                InputKind::Keyboard => "keyboard",
                InputKind::Webcam => "webcam",
                InputKind::Microphone => "mic",
                _ => STAND_IN,
            };
            let kind = input.kind.word();
            // A sampler is found in all passes that declare it.
            match (&input.uniform, pass.wrapper) {
                (Some(name), Wrapper::Own) => {
                    let line = format!("{name:?} = \"{source}\" # {kind}\n");
                    if !samplers.contains(&line) {
                        samplers.push_str(&line);
                    }
                }
                _ => {
                    if pass.slug() != last {
                        last = pass.slug();
                        let _ = write!(tables, "\n[{last}]\n");
                    }
                    let _ = writeln!(tables, "{} = \"{source}\" # {kind}", input.channel);
                }
            }
        }
        let gap = if samplers.is_empty() { "" } else { "\n" };
        format!("{HEAD}{gap}{samplers}{tables}")
    }

    /// The name of the pass with an output.
    fn slug_of(&self, output: &str) -> Option<&'static str> {
        let mut passes = self.passes.iter();
        let drawn = passes.find(|p| p.output.as_ref().is_some_and(|o| o.0 == output));
        drawn.map(ProjectPass::slug)
    }
}

fn shows(input: &Input) -> String {
    let kind = match input.kind {
        InputKind::Cubemap => "cube map",
        kind => kind.word(),
    };
    match (input.stand_in, input.kind) {
        (Some(_), _) => format!("generated {kind}"),
        (None, InputKind::Texture | InputKind::Volume | InputKind::Cubemap) => "black".to_string(),
        (None, _) => kind.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ChannelOrder, GatheredText, PassFile, PassRole, add_stand_ins};

    /// The project of passes with these codes, and the lines of its `channels.toml` without the head.
    fn written(parts: &[(PassRole, &str)], orders: &[&str]) -> (Project, String) {
        let parts = parts.iter().map(|(role, code)| PassFile {
            role: *role,
            file: role.name().to_string(),
            text: GatheredText::of(format!(
                "void mainImage(out vec4 c, in vec2 f) {{ c = {code}; }}"
            )),
        });
        let mut project = Project::from_parts("x", parts.collect()).unwrap();
        project.resolve("x").unwrap();
        for order in orders {
            project
                .put(&ChannelOrder::read(order).unwrap(), None)
                .unwrap();
        }
        add_stand_ins(&mut project);
        let text = project.assumed_file();
        (project, text.strip_prefix(HEAD).unwrap().to_string())
    }

    #[test]
    fn assumed_channels_are_written_and_read_back() {
        let image = "texture(iChannel0, f) + texture(iChannel1, vec3(f, 0.0))";
        let buffer = "texture(iChannel2, f)";
        let parts = [(PassRole::Image, image), (PassRole::Buffer(0), buffer)];
        let (project, text) = written(&parts, &["0=buffer_a"]);
        assert_eq!(
            text,
            "\n[image]\n1 = \"stand-in\" # cubemap\n\n[buffer_a]\n2 = \"stand-in\" # texture\n"
        );
        let assumed: Vec<_> = project.assumed().into_iter().collect();
        let shown = assumed
            .iter()
            .map(|a| format!("{}.{}: {}", a.pass, a.channel, a.shows));
        let expected = [
            "image.iChannel1: generated cube map",
            "buffer_a.iChannel2: generated texture",
        ];
        assert_eq!(shown.collect::<Vec<_>>(), expected);
        let given = ["0=buffer_a", "image.1=stand-in", "buffer_a.2=stand-in"];
        let (same, rest) = written(&parts, &given);
        assert_eq!((same.assumed(), rest.as_str()), (Vec::new(), ""));
        let inputs = |p: &Project| {
            let all = p.passes.iter().flat_map(|p| p.inputs.clone());
            let drawn = all.map(|i| (i.channel, i.kind, i.sampler, i.stand_in.map(|s| s.size)));
            let mut drawn: Vec<_> = drawn.collect();
            drawn.sort_by_key(|(channel, ..)| *channel);
            drawn
        };
        assert_eq!(inputs(&same), inputs(&project));
    }

    #[test]
    fn samplers_of_complete_shaders_keep_their_names() {
        let code = "precision highp float;\nuniform sampler2D maps[2];\n\
            void main() { gl_FragColor = texture2D(maps[1], vec2(0.5)); }\n";
        let project = Project::from_shader("", code).unwrap();
        let text = project.assumed_file();
        let lines =
            "\n\"maps[0]\" = \"stand-in\" # texture\n\"maps[1]\" = \"stand-in\" # texture\n";
        assert_eq!(text.strip_prefix(HEAD), Some(lines));
    }
}
