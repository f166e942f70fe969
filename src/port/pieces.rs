//! The minified files of the player and its pages, of which an output has only those that it uses.
//!
//! `node tests/browser/minify.js` makes them from `player/*.js` and `player/page/*`.

use super::tuned::sliders;
use super::{Composed, InputKind, OutputId, Project, Wrapper};
use shaderlint_semantic::{Pass, Stage};
use shaderlint_text::Role;

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
pub(super) struct PlayerParts(Vec<PlayerPart>);

impl PlayerParts {
    /// Those of a project that is not known yet.
    pub(super) fn all() -> PlayerParts {
        let mut parts = PlayerParts::default();
        for part in PLAYER.iter().chain(&PANEL).filter_map(|(part, _)| *part) {
            parts.add(&[part]);
        }
        parts
    }

    /// Those of a project. In pages with a panel its channels also take other files.
    pub(super) fn of(project: &Project, composed: &Composed, has_panel: bool) -> PlayerParts {
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
    pub(super) fn player(&self) -> String {
        self.code(&PLAYER)
    }

    /// The script of a page with a panel.
    pub(super) fn panel(&self) -> String {
        self.code(&BASE) + &self.code(&PANEL)
    }

    /// The script of a page for frames.
    pub(super) fn frame(&self) -> String {
        self.code(&BASE) + include_str!("player/min/page_embed.js")
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
    (None, include_str!("player/min/parts.js")),
    (None, include_str!("player/min/frame.js")),
    (Some(PlayerPart::Own), include_str!("player/min/sources.js")),
    (
        Some(PlayerPart::Heard),
        include_str!("player/min/spectrum.js"),
    ),
    (None, include_str!("player/min/gl.js")),
    (None, include_str!("player/min/log.js")),
    (
        Some(PlayerPart::Tunables),
        include_str!("player/min/tunable.js"),
    ),
    (None, include_str!("player/min/mouse.js")),
    (
        Some(PlayerPart::Keyboard),
        include_str!("player/min/keyboard.js"),
    ),
    (
        Some(PlayerPart::Buffers),
        include_str!("player/min/buffer.js"),
    ),
    (Some(PlayerPart::Cube), include_str!("player/min/cube.js")),
    (
        Some(PlayerPart::Devices),
        include_str!("player/min/devices.js"),
    ),
    (None, include_str!("player/min/inputs.js")),
    (
        Some(PlayerPart::Images),
        include_str!("player/min/pictures.js"),
    ),
    (Some(PlayerPart::Films), include_str!("player/min/films.js")),
    (
        Some(PlayerPart::Heard),
        include_str!("player/min/signals.js"),
    ),
    (
        Some(PlayerPart::StandIns),
        include_str!("player/min/standins.js"),
    ),
    (None, include_str!("player/min/program.js")),
    (Some(PlayerPart::Own), include_str!("player/min/sizes.js")),
    (Some(PlayerPart::Own), include_str!("player/min/own.js")),
    (
        Some(PlayerPart::Vertices),
        include_str!("player/min/vertices.js"),
    ),
    (None, include_str!("player/min/programs.js")),
    (Some(PlayerPart::Sound), include_str!("player/min/sound.js")),
    (None, include_str!("player/min/clock.js")),
    (None, include_str!("player/min/context.js")),
    (None, include_str!("player/min/renderer.js")),
    (None, include_str!("player/min/player.js")),
    (None, include_str!("player/min/listen.js")),
    (None, include_str!("player/min/presence.js")),
    (
        Some(PlayerPart::Own),
        include_str!("player/min/samplers.js"),
    ),
];

/// What all pages use.
const BASE: [(Option<PlayerPart>, &str); 7] = [
    (None, include_str!("player/min/page_dom.js")),
    (None, include_str!("player/min/page_address.js")),
    (None, include_str!("player/min/page_notices.js")),
    (None, include_str!("player/min/page_bar.js")),
    (None, include_str!("player/min/page_keys.js")),
    (None, include_str!("player/min/page_open.js")),
    (
        Some(PlayerPart::Controls),
        include_str!("player/min/page_values.js"),
    ),
];

/// The panel, in order of dependency.
const PANEL: [(Option<PlayerPart>, &str); 17] = [
    (None, include_str!("player/min/page_keep.js")),
    (None, include_str!("player/min/page_write.js")),
    (None, include_str!("player/min/page_prose.js")),
    (None, include_str!("player/min/page_excerpt.js")),
    (None, include_str!("player/min/page_errors.js")),
    (None, include_str!("player/min/page_highlight.js")),
    (None, include_str!("player/min/page_editor.js")),
    (None, include_str!("player/min/page_code.js")),
    (
        Some(PlayerPart::Controls),
        include_str!("player/min/page_controls.js"),
    ),
    (
        Some(PlayerPart::Channels),
        include_str!("player/min/page_channels.js"),
    ),
    (None, include_str!("player/min/page_size.js")),
    (None, include_str!("player/min/page_webm.js")),
    (None, include_str!("player/min/page_film.js")),
    (None, include_str!("player/min/page_export.js")),
    (None, include_str!("player/min/page_panel.js")),
    (None, include_str!("player/min/page_help.js")),
    (None, include_str!("player/min/page_page.js")),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_piece_can_end_its_element() {
        for (_, text) in PLAYER.iter().chain(&BASE).chain(&PANEL) {
            assert!(!text.contains("</") && !text.contains("<!--"), "{text}");
        }
    }

    #[test]
    fn a_plain_shader_needs_nothing() {
        let code = "void mainImage(out vec4 o, vec2 u) { o = vec4(u / iResolution.xy, 0, 1); }";
        let project = Project::from_shader("", code).unwrap();
        let needs = PlayerParts::of(&project, &crate::compose(&project, "").unwrap(), true);
        assert_eq!(needs.0, []);
    }
}
