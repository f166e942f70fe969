//! Style options.

/// The formatting style.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Style {
    /// The indentation per level.
    pub indent: Indentation,
    /// Maximum line width in characters; longer lines are broken where possible.
    pub width: u32,
    /// The position of opening braces.
    pub brace: Brace,
}

/// The indentation per level.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Indentation {
    /// This many spaces.
    Spaces(u32),
    /// A tab, displayed with this width.
    Tab(u32),
}

/// The position of opening braces.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum Brace {
    /// On the same line as the header.
    #[default]
    Same,
    /// On the next line.
    Next,
}

impl Default for Style {
    fn default() -> Style {
        Style {
            indent: Indentation::Spaces(4),
            width: 100,
            brace: Brace::Same,
        }
    }
}

/// Style options that may be set; `None` for the others.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct StyleChoice {
    /// The indentation per level.
    pub indent: Option<Indentation>,
    /// Maximum line width in characters.
    pub width: Option<u32>,
    /// The position of opening braces.
    pub brace: Option<Brace>,
}

impl StyleChoice {
    /// These options, with `other` for those that are not set.
    pub fn or(self, other: StyleChoice) -> StyleChoice {
        StyleChoice {
            indent: self.indent.or(other.indent),
            width: self.width.or(other.width),
            brace: self.brace.or(other.brace),
        }
    }

    /// The style with these options, and defaults for the others.
    pub fn style(self) -> Style {
        let usual = Style::default();
        Style {
            indent: self.indent.unwrap_or(usual.indent),
            width: self.width.unwrap_or(usual.width),
            brace: self.brace.unwrap_or(usual.brace),
        }
    }
}

impl From<&Style> for StyleChoice {
    fn from(style: &Style) -> StyleChoice {
        StyleChoice {
            indent: Some(style.indent),
            width: Some(style.width),
            brace: Some(style.brace),
        }
    }
}

impl Indentation {
    /// The width of a level in columns.
    pub fn width(self) -> u32 {
        match self {
            Indentation::Spaces(width) | Indentation::Tab(width) => width,
        }
    }
}
