//! What `.editorconfig` says of how a file is set.

use crate::format::{Brace, Indentation, StyleChoice};
use ec4rs::Properties;
use ec4rs::property::{IndentSize, IndentStyle, MaxLineLen, TabWidth};
use std::path::Path;

/// Columns of a tab, where nothing is said of it.
const TAB: u32 = 4;
/// What is taken for a width, and for a level.
const WIDTHS: std::ops::RangeInclusive<usize> = 20..=1000;
const LEVELS: std::ops::RangeInclusive<usize> = 1..=16;

/// What the files above a path say of it. What cannot be read says nothing: it is for editors to
/// complain of.
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
        // Not one of the standard's own, but of those that its wiki lists.
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
