//! `layout(...)` (GLSL ES 3.00 section 4.3.8).

use super::qualifier::{Qualified, Wanted};
use super::*;

/// What WebGL2 has at least, and what Chromium compiles against.
const MAX_VERTEX_ATTRIBS: i32 = 16;

/// What a `layout(...)` says.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Layout {
    pub location: Option<i32>,
    /// How often a location was given.
    pub locations: u32,
    /// `row_major` or `column_major`.
    pub matrix: bool,
    /// `std140`, `shared` or `packed`.
    pub block: bool,
    /// Tokens of the entries.
    pub extent: Option<Extent>,
}

impl Layout {
    pub fn is_empty(&self) -> bool {
        self.location.is_none() && !self.matrix && !self.block
    }
}

impl Checker<'_> {
    /// Reads the entries of one `layout(...)` into `layout`.
    pub(super) fn read_layout(&mut self, entries: List, layout: &mut Layout) {
        let tree = self.tree;
        for entry in tree.layout(entries) {
            let extent = Extent::token(entry.ident.token);
            layout.extent = Some(layout.extent.map_or(extent, |e| e.to(extent)));
            match entry.value {
                Some(value) => self.layout_with_value(entry.ident, value, layout),
                None => self.layout_word(entry.ident, layout),
            }
        }
    }

    fn layout_word(&mut self, ident: Ident, layout: &mut Layout) {
        let message = match self.text(ident.name) {
            "row_major" | "column_major" => {
                layout.matrix = true;
                return;
            }
            "std140" => {
                layout.block = true;
                return;
            }
            word @ ("shared" | "packed") => {
                layout.block = true;
                format!("WebGL has no block layout `{word}`; only `std140`")
            }
            "location" => "`location` needs a number: `location = 0`".to_string(),
            word => format!("there is no layout `{word}` here"),
        };
        let d = self.error_at(error::INVALID_LAYOUT, ident.token, message);
        self.report(d);
    }

    fn layout_with_value(&mut self, ident: Ident, value: LayoutValue, layout: &mut Layout) {
        let word = self.text(ident.name);
        if word == "location" && value.value >= 0 {
            layout.location = Some(value.value);
            layout.locations += 1;
            return;
        }
        let d = if word == "location" {
            let message = "a location must not be negative";
            self.error_at(error::INVALID_LAYOUT, value.token, message)
        } else {
            let d = self.error_at(
                error::INVALID_LAYOUT,
                ident.token,
                format!("there is no layout `{word} = ...` here"),
            );
            match word {
                "binding" | "offset" => {
                    d.note("it comes with GLSL ES 3.10, which WebGL2 does not have")
                }
                _ => d,
            }
        };
        self.report(d);
    }

    /// What the layout of a variable's declaration must not say.
    pub(super) fn check_variable_layout(&mut self, qualified: &Qualified, extent: Extent) {
        let layout = &qualified.layout;
        let at = layout.extent.unwrap_or(extent);
        if layout.matrix || layout.block {
            let d = self.error(
                error::INVALID_LAYOUT,
                at,
                "this layout is for interface blocks",
            );
            return self.report(d);
        }
        let Some(location) = layout.location else {
            return;
        };
        let vertex_in = self.stage == Stage::Vertex && qualified.storage == Wanted::In;
        let fragment_out = self.stage == Stage::Fragment && qualified.storage == Wanted::Out;
        if !vertex_in && !fragment_out {
            let d = self
                .error(error::INVALID_LAYOUT, at, "no location can be given here")
                .note("only inputs of vertex shaders and outputs of fragment shaders have one (section 4.3.8)");
            self.report(d);
        } else if layout.locations > 1 && fragment_out {
            let d = self.error(error::INVALID_LAYOUT, at, "the location is given twice");
            self.report(d);
        } else if vertex_in && location >= MAX_VERTEX_ATTRIBS {
            let message = format!("location {location} is out of range");
            let d = self
                .error(error::INVALID_LAYOUT, at, message)
                .note("a vertex shader has 16 inputs, at locations 0 to 15");
            self.report(d);
        }
    }
}
