//! What can be chosen of the style.

/// How code is set.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Style {
    /// What a level is indented by.
    pub indent: Indentation,
    /// How many characters a line should have at most.
    pub width: u32,
    /// Where the brace of a block stands.
    pub brace: Brace,
}

/// What a level is indented by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Indentation {
    /// So many blanks.
    Spaces(u32),
    /// A tab, which is so wide.
    Tab(u32),
}

/// Where the brace of a block stands.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum Brace {
    /// In the line of what it belongs to.
    #[default]
    Same,
    /// In the next line.
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

/// What somebody says of the style; of the rest nothing is said.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct StyleChoice {
    /// What a level is indented by.
    pub indent: Option<Indentation>,
    /// How many characters a line should have at most.
    pub width: Option<u32>,
    /// Where the brace of a block stands.
    pub brace: Option<Brace>,
}

impl StyleChoice {
    /// What this says, and of the rest what another says.
    pub fn or(self, other: StyleChoice) -> StyleChoice {
        StyleChoice {
            indent: self.indent.or(other.indent),
            width: self.width.or(other.width),
            brace: self.brace.or(other.brace),
        }
    }

    /// The style that it asks for.
    pub fn style(self) -> Style {
        let usual = Style::default();
        Style {
            indent: self.indent.unwrap_or(usual.indent),
            width: self.width.unwrap_or(usual.width),
            brace: self.brace.unwrap_or(usual.brace),
        }
    }
}

impl Indentation {
    /// Columns of a level.
    pub fn width(self) -> u32 {
        match self {
            Indentation::Spaces(width) | Indentation::Tab(width) => width,
        }
    }
}
