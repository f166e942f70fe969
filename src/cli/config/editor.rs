//! The formatting settings in `.editorconfig`.

use crate::format::{Brace, Indentation, StyleChoice};
use ec4rs::Properties;
use ec4rs::property::{IndentSize, IndentStyle, MaxLineLen, TabWidth};
use std::path::Path;

/// Width of a tab if the settings do not define it.
const TAB: u32 = 4;
/// Accepted line widths.
const WIDTHS: std::ops::RangeInclusive<usize> = 20..=1000;
/// Accepted indentation widths.
const LEVELS: std::ops::RangeInclusive<usize> = 1..=16;

/// The settings for a path from the files above it. Invalid settings are ignored; editors report
/// them.
pub fn choice(path: &Path) -> StyleChoice {
    let Ok(mut properties) = ec4rs::properties_of(path) else {
        return StyleChoice::default();
    };
    properties.use_fallbacks();
    StyleChoice {
        indent: indent(&properties),
        width: match properties.get::<MaxLineLen>() {
            Ok(MaxLineLen::Value(width)) if WIDTHS.contains(&width) => Some(width as u32),
            _ => None,
        },
        // Not part of the EditorConfig specification, but listed in its wiki.
        brace: match properties
            .get_raw_for_key("curly_bracket_next_line")
            .into_str()
        {
            "true" => Some(Brace::Next),
            "false" => Some(Brace::Same),
            _ => None,
        },
    }
}

fn indent(properties: &Properties) -> Option<Indentation> {
    let tab = match properties.get::<TabWidth>() {
        Ok(TabWidth::Value(width)) if LEVELS.contains(&width) => width as u32,
        _ => TAB,
    };
    match (
        properties.get::<IndentStyle>(),
        properties.get::<IndentSize>(),
    ) {
        (Ok(IndentStyle::Tabs), _) => Some(Indentation::Tab(tab)),
        (_, Ok(IndentSize::Value(blanks))) if LEVELS.contains(&blanks) => {
            Some(Indentation::Spaces(blanks as u32))
        }
        _ => None,
    }
}
