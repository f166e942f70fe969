//! What a host supplies for the inputs of a pass.

use super::used::{UsedInput, UsedValue};
use shaderlint_host::{Feed, FeedRow, Preset, TextureFeed};
use shaderlint_semantic::channel;

/// How an input of a pass gets its value.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Supplied {
    /// The name means the same in the host.
    Same,
    /// A global variable, with the expression that it is set to; `None` if no use of it runs.
    Global(Option<String>),
    /// The sampler of the host with this name.
    Sampler(String),
    /// A uniform of this name and type, which the application sets.
    Uniform(&'static str),
}

/// Whether the value of an input never changes in a host.
pub(super) fn rests(host: &Preset, input: &UsedInput) -> bool {
    matches!(input.value, UsedValue::Known(feed) if host.rests(feed))
}

/// How a host supplies an input; `None` if it does not.
pub(super) fn supplied(host: &Preset, input: &UsedInput) -> Option<Supplied> {
    match &input.value {
        UsedValue::Known(feed) => known(host, input, *feed),
        UsedValue::Screen => {
            let is_screen = |t: TextureFeed| t == TextureFeed::Screen;
            let rows = &host.meanings.textures;
            let screen = rows.iter().find(|r| is_screen(r.texture));
            // Only one of several channels can be what the host draws.
            let is_first = channel(&input.name).is_none_or(|number| number == 0);
            match (screen, set_by_application(host)) {
                (_, true) => Some(Supplied::Uniform("sampler2D")),
                (Some(row), _) if is_first => Some(Supplied::Sampler(row.name.clone())),
                _ => None,
            }
        }
        UsedValue::Image => set_by_application(host).then_some(Supplied::Uniform("sampler2D")),
        // The channel with the number of the program.
        UsedValue::Output(output) => {
            let number = output.number().filter(|n| *n < host.programs)?;
            Some(Supplied::Sampler(format!("iChannel{number}")))
        }
        UsedValue::Other => None,
    }
}

fn set_by_application(host: &Preset) -> bool {
    !host.setters.is_empty()
}

fn known(host: &Preset, input: &UsedInput, feed: Feed) -> Option<Supplied> {
    let rests = rests(host, input);
    let is_same = |r: &FeedRow| {
        let is_value = r.feed == feed || (rests && r.feed == Feed::Nothing);
        r.is_declared && r.name == input.name && is_value && r.types.contains(&input.ty)
    };
    if host.meanings.feeds.iter().any(is_same) {
        return Some(Supplied::Same);
    }
    if !input.is_live {
        return Some(Supplied::Global(None));
    }
    if let Some(expression) = host.meanings.expression(feed, &input.ty) {
        return Some(Supplied::Global(Some(expression)));
    }
    if rests {
        return Some(Supplied::Global(Some(format!("{}(0.0)", input.ty))));
    }
    let ty = match input.ty.as_str() {
        "float" | "int" => "float",
        "vec2" => "vec2",
        "vec3" => "vec3",
        "vec4" => "vec4",
        _ => return None,
    };
    set_by_application(host).then_some(Supplied::Uniform(ty))
}
