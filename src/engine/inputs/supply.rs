//! The inputs of a shader in sample runs.

use super::moment::{Button, Moment, Mouse};
use super::player::{player_draw, player_gives};
use super::scene::GivenUniforms;
use crate::hosts::host::Hosts;
use rustc_hash::FxHashSet;
use shaderlint_exec::{Bytecode, Draw};
use shaderlint_host::{Feed, Preset};
use shaderlint_lint::sample::{Instant, Supplier};
use shaderlint_project::bindings;
use shaderlint_semantic::Program;
use std::cell::OnceCell;

/// The inputs of a checked shader, determined on demand.
pub(crate) struct Supply<'p> {
    program: &'p Program,
    /// The scripts around the shader.
    hosts: &'p Hosts<'p>,
    /// The host that the user names.
    host: Option<&'static Preset>,
    given: OnceCell<GivenUniforms>,
    /// The uniforms and varyings whose values every page sets alike.
    certain_names: OnceCell<FxHashSet<String>>,
}

impl<'p> Supply<'p> {
    pub fn of(
        program: &'p Program,
        host: Option<&'static Preset>,
        hosts: &'p Hosts<'p>,
    ) -> Supply<'p> {
        Supply {
            program,
            hosts,
            host,
            given: OnceCell::new(),
            certain_names: OnceCell::new(),
        }
    }

    fn certain_names(&self) -> &FxHashSet<String> {
        self.certain_names.get_or_init(|| {
            let bound = &self.given().bound;
            let varyings = bound.varyings.iter().map(|v| v.place.to_string());
            let mut certain: FxHashSet<String> = varyings.collect();
            for guessed in &bound.guessed {
                certain.remove(guessed);
            }
            let fed = bound.uniforms.iter().filter(|u| is_certain(u.source));
            certain.extend(fed.map(|u| u.name.to_string()));
            certain
        })
    }

    fn given(&self) -> &GivenUniforms {
        self.given.get_or_init(|| {
            let mut given = GivenUniforms::of(bindings(self.program, self.host));
            // A value that changes is one of many; the others stay zero.
            if !given.bound.controls.is_empty() || !given.bound.zeros.is_empty() {
                let all = self.hosts.scripted().into_iter().filter(|v| v.is_constant);
                all.for_each(|value| given.fix(&value.name, value.value));
            }
            given
        })
    }
}

impl Supplier for Supply<'_> {
    fn draw<'c>(&self, code: &'c Bytecode, size: [u32; 2], instant: &Instant) -> Draw<'c> {
        let moment = moment(instant);
        if !self.program.dialect.is_shadertoy() {
            return self.given().draw(code, size, &moment);
        }
        player_draw(code, size, &moment)
    }

    fn knows(&self, name: &str) -> bool {
        if self.program.dialect.is_shadertoy() {
            return player_gives(name) || is_built_in(name);
        }
        is_built_in(name) || self.certain_names().contains(name)
    }

    fn is_time(&self, name: &str) -> bool {
        let is_clock = |feed| matches!(feed, Feed::Time | Feed::Milliseconds);
        let mut fed = self.given().bound.uniforms.iter();
        fed.any(|u| u.name == name && is_clock(u.source))
    }
}

/// Whether a name is a built-in input.
fn is_built_in(name: &str) -> bool {
    matches!(name, "gl_FragCoord" | "gl_FrontFacing")
}

/// Whether every page sets this input to about the same value.
fn is_certain(feed: Feed) -> bool {
    match feed {
        Feed::Time
        | Feed::Milliseconds
        | Feed::Delta
        | Feed::Frame
        | Feed::FrameFromOne
        | Feed::FrameRate
        | Feed::Date
        | Feed::DateFromOne
        | Feed::Resolution
        | Feed::ResolutionAndPixel
        | Feed::Pixel
        | Feed::Aspect
        | Feed::PixelRatio
        | Feed::SurfaceSize
        | Feed::Mouse
        | Feed::Pointer
        | Feed::PointerUnit
        | Feed::PointerUnitDown
        | Feed::PointerUnitZero
        | Feed::PointerSigned
        | Feed::Button
        | Feed::Width
        | Feed::Height => true,
        Feed::SampleRate
        | Feed::ChannelTime
        | Feed::ChannelResolution
        | Feed::TextureSize
        | Feed::Spectrum
        | Feed::Volume
        | Feed::VolumeBytes
        | Feed::HistorySize
        | Feed::Camera
        | Feed::Identity
        | Feed::Progress
        | Feed::Cursor
        | Feed::CursorBefore
        | Feed::CursorTime
        | Feed::CursorColor
        | Feed::Ones
        | Feed::Control
        | Feed::Nothing => false,
    }
}

fn moment(instant: &Instant) -> Moment {
    let mut moment = Moment::at(instant.time);
    moment.mouse = instant.mouse.map(|press| Mouse {
        at: press.at,
        button: match press.is_down {
            true => Button::Down,
            false => Button::Up,
        },
    });
    moment
}
