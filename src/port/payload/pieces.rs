//! The minified files of the player and its pages, of which an output has only those that it uses.
//!
//! `node tests/browser/minify.js` makes them from the scripts and styles below `player`.

use super::tuned::sliders;
use crate::{Composed, InputKind, OutputId, Project, Wrapper};
use shaderlint_semantic::{Pass, Stage};
use shaderlint_text::Role;

/// A minified script of the player, by its path.
macro_rules! script {
    ($path:literal) => {
        include_str!(concat!("../player/min/", $path, ".js"))
    };
}

/// What a project needs of the player. The files of the player are in [`PLAYER`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum PlayerPart {
    /// Buffers, and images that are read.
    Buffers,
    /// The cube map pass.
    Cube,
    /// The keyboard as a channel.
    Keyboard,
    /// The sound pass.
    Sound,
    /// Videos, cameras, microphones or audio output.
    Devices,
    /// Music and microphones.
    Heard,
    /// Videos and cameras.
    Films,
    /// Images, cube maps and volumes.
    Images,
    /// Drawings for missing files.
    StandIns,
    /// Passes that declare their own uniforms.
    Own,
    /// Shaders of numbered vertices.
    Vertices,
    /// Numbers in the code that its author made tunable.
    Tunables,
    /// Uniforms that the user sets.
    Controls,
    /// Channels that take files or devices.
    Channels,
}

/// The needs of a project.
#[derive(Clone, Default, Debug)]
pub(crate) struct PlayerParts(Vec<PlayerPart>);

impl PlayerParts {
    /// Those of a project that is not known yet.
    pub(crate) fn all() -> PlayerParts {
        let mut parts = PlayerParts::default();
        for part in PLAYER.iter().chain(&PANEL).filter_map(|(part, _)| *part) {
            parts.add(&[part]);
        }
        parts
    }

    /// Those of a project. In pages with a panel its channels also take other files.
    pub(crate) fn of(project: &Project, composed: &Composed, has_panel: bool) -> PlayerParts {
        let mut needs = PlayerParts::default();
        for pass in &project.passes {
            needs.add(match pass.kind {
                Pass::Buffer => &[PlayerPart::Buffers],
                Pass::Cubemap => &[PlayerPart::Cube],
                Pass::Sound => &[PlayerPart::Sound, PlayerPart::Devices],
                Pass::Image | Pass::Common => &[],
            });
            if pass.wrapper == Wrapper::Own {
                needs.add(&[PlayerPart::Own]);
            }
            if pass.stage == Stage::Vertex {
                needs.add(&[PlayerPart::Vertices]);
            }
            for input in &pass.inputs {
                let is_cube = input.id == OutputId::CUBE;
                needs.add(match input.kind {
                    InputKind::Buffer => &[PlayerPart::Buffers],
                    InputKind::Keyboard => &[PlayerPart::Keyboard],
                    InputKind::Cubemap if is_cube => &[PlayerPart::Cube, PlayerPart::Images],
                    InputKind::Texture | InputKind::Cubemap | InputKind::Volume => {
                        &[PlayerPart::Images]
                    }
                    InputKind::Video | InputKind::Webcam => {
                        &[PlayerPart::Films, PlayerPart::Devices]
                    }
                    InputKind::Music | InputKind::MusicStream | InputKind::Microphone => {
                        &[PlayerPart::Heard, PlayerPart::Devices]
                    }
                });
                if input.stand_in.is_some() {
                    needs.add(&[PlayerPart::StandIns]);
                }
            }
        }
        let mut own = composed
            .sources
            .files()
            .iter()
            .filter(|f| f.role != Role::Prelude);
        // Users may fill channels without an input.
        if own.any(|f| f.text.contains("iChannel")) && is_read_empty(project) {
            needs.add(&[PlayerPart::Images]);
        }
        if !sliders(composed).list.is_empty() {
            needs.add(&[PlayerPart::Tunables, PlayerPart::Controls]);
        }
        if !project.controls.is_empty() {
            needs.add(&[PlayerPart::Controls]);
        }
        let takes_files = [PlayerPart::Images, PlayerPart::Films, PlayerPart::Heard];
        if has_panel && takes_files.iter().any(|need| needs.has(*need)) {
            needs.add(&takes_files);
            needs.add(&[PlayerPart::Channels, PlayerPart::Devices]);
        }
        needs
    }

    fn add(&mut self, more: &[PlayerPart]) {
        for need in more {
            if !self.has(*need) {
                self.0.push(*need);
            }
        }
    }

    fn has(&self, need: PlayerPart) -> bool {
        self.0.contains(&need)
    }

    fn code(&self, pieces: &[(Option<PlayerPart>, &str)]) -> String {
        let used = pieces
            .iter()
            .filter(|(need, _)| need.is_none_or(|need| self.has(need)));
        used.map(|(_, code)| *code).collect()
    }

    /// The player.
    pub(crate) fn player(&self) -> String {
        self.code(&PLAYER)
    }

    /// The script of a page with a panel.
    pub(crate) fn panel(&self) -> String {
        self.code(&BASE) + &self.code(&PANEL)
    }

    /// The script of a page for frames.
    pub(crate) fn frame(&self) -> String {
        self.code(&BASE) + script!("page/embed")
    }
}

/// Whether some pass has fewer inputs than channels.
fn is_read_empty(project: &Project) -> bool {
    let passes = &project.passes;
    passes
        .iter()
        .any(|p| p.kind != Pass::Common && p.inputs.len() < 4)
}

/// The files of the player, in order of dependency.
const PLAYER: [(Option<PlayerPart>, &str); 30] = [
    (None, script!("parts")),
    (None, script!("draw/frame")),
    (Some(PlayerPart::Own), script!("draw/sources")),
    (Some(PlayerPart::Heard), script!("channels/spectrum")),
    (None, script!("draw/gl")),
    (None, script!("draw/log")),
    (Some(PlayerPart::Tunables), script!("draw/tunable")),
    (None, script!("mouse")),
    (Some(PlayerPart::Keyboard), script!("channels/keyboard")),
    (Some(PlayerPart::Buffers), script!("draw/buffer")),
    (Some(PlayerPart::Cube), script!("draw/cube")),
    (Some(PlayerPart::Devices), script!("channels/devices")),
    (None, script!("channels/inputs")),
    (Some(PlayerPart::Images), script!("channels/pictures")),
    (Some(PlayerPart::Films), script!("channels/films")),
    (Some(PlayerPart::Heard), script!("channels/signals")),
    (Some(PlayerPart::StandIns), script!("channels/standins")),
    (None, script!("draw/program")),
    (Some(PlayerPart::Own), script!("draw/sizes")),
    (Some(PlayerPart::Own), script!("draw/own")),
    (Some(PlayerPart::Vertices), script!("draw/vertices")),
    (None, script!("draw/programs")),
    (Some(PlayerPart::Sound), script!("draw/sound")),
    (None, script!("clock")),
    (None, script!("context")),
    (None, script!("draw/renderer")),
    (None, script!("player")),
    (None, script!("listen")),
    (None, script!("presence")),
    (Some(PlayerPart::Own), script!("draw/samplers")),
];

/// What all pages use.
const BASE: [(Option<PlayerPart>, &str); 7] = [
    (None, script!("page/dom")),
    (None, script!("page/address")),
    (None, script!("page/notices")),
    (None, script!("page/bar")),
    (None, script!("page/keys")),
    (None, script!("page/open")),
    (Some(PlayerPart::Controls), script!("page/values")),
];

/// The panel, in order of dependency.
const PANEL: [(Option<PlayerPart>, &str); 17] = [
    (None, script!("page/panel/keep")),
    (None, script!("page/panel/write")),
    (None, script!("page/panel/prose")),
    (None, script!("page/panel/excerpt")),
    (None, script!("page/panel/errors")),
    (None, script!("page/panel/highlight")),
    (None, script!("page/panel/editor")),
    (None, script!("page/panel/code")),
    (Some(PlayerPart::Controls), script!("page/panel/controls")),
    (Some(PlayerPart::Channels), script!("page/panel/channels")),
    (None, script!("page/panel/size")),
    (None, script!("page/panel/webm")),
    (None, script!("page/panel/film")),
    (None, script!("page/panel/export")),
    (None, script!("page/panel/panel")),
    (None, script!("page/panel/help")),
    (None, script!("page/page")),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_the_player_cannot_end_their_element() {
        for (_, text) in PLAYER.iter().chain(&BASE).chain(&PANEL) {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn plain_shaders_need_no_optional_parts() {
        let code = "void mainImage(out vec4 o, vec2 u) { o = vec4(u / iResolution.xy, 0, 1); }";
        let project = Project::from_shader("", code).unwrap();
        let needs = PlayerParts::of(
            &project,
            &shaderlint_project::compose(&project, "").unwrap(),
            true,
        );
        assert_eq!(needs.0, []);
    }
}
