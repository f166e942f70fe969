//! `layout(...)` (GLSL ES 3.00 section 4.3.8).

use super::qualifier::{LayoutQualifier, Qualified, StorageRequest};
use crate::checker::*;
use shaderlint_syntax::GlExtension;

/// The minimum that WebGL2 guarantees, and the limit that Chromium compiles with.
const MAX_VERTEX_ATTRIBS: i32 = 16;
/// The limit that Chromium compiles with.
const MAX_VIEWS: i32 = 4;

/// An error in a `layout(...)`.
#[derive(Clone, Copy, Debug)]
pub enum LayoutError {
    /// A block layout that WebGL does not support.
    NotInWebgl(Name),
    /// `location` without a number.
    NoNumber,
    Unknown(Name),
    /// An unknown layout qualifier with a value.
    UnknownNumber(Name),
    /// A location below 0.
    Negative,
    /// A block layout on a variable.
    OfBlock,
    /// A location where none is allowed.
    NoLocationHere,
    /// Two locations for one output.
    Twice,
    /// A location beyond the last input.
    OutOfRange(i32),
    /// A location for several variables.
    Shared,
    /// Another number of views than before, or too many.
    Views(i32),
    /// Qualifiers without a declaration.
    OfNothing,
    /// A default layout for anything but uniforms.
    NotUniform,
}

impl Checker<'_> {
    /// Adds the entries of one `layout(...)` to `layout`.
    pub(super) fn read_layout(&mut self, entries: List, layout: &mut LayoutQualifier) {
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

    fn layout_word(&mut self, ident: Ident, layout: &mut LayoutQualifier) {
        let problem = match self.text(ident.name) {
            "row_major" | "column_major" => {
                layout.matrix = true;
                return;
            }
            "std140" => {
                layout.block = true;
                return;
            }
            "shared" | "packed" => {
                layout.block = true;
                LayoutError::NotInWebgl(ident.name)
            }
            "location" => LayoutError::NoNumber,
            "depth_any" | "depth_greater" | "depth_less"
                if self.has_active(GlExtension::ConservativeDepth) =>
            {
                layout.depth = Some(ident);
                return;
            }
            _ => LayoutError::Unknown(ident.name),
        };
        self.reject(Extent::token(ident.token), problem);
    }

    fn layout_with_value(
        &mut self,
        ident: Ident,
        value: LayoutValue,
        layout: &mut LayoutQualifier,
    ) {
        match self.text(ident.name) {
            "location" if value.value >= 0 => {
                layout.location = Some(value.value);
                layout.locations += 1;
            }
            "location" => self.reject(Extent::token(value.token), LayoutError::Negative),
            "num_views"
                if self.stage == Stage::Vertex && self.has_active(GlExtension::Multiview) =>
            {
                let before = *self.views.get_or_insert(value.value);
                if before != value.value || !(1..=MAX_VIEWS).contains(&value.value) {
                    self.reject(Extent::token(value.token), LayoutError::Views(MAX_VIEWS));
                }
                layout.views = Some(value.value);
            }
            _ => self.reject(
                Extent::token(ident.token),
                LayoutError::UnknownNumber(ident.name),
            ),
        }
    }

    /// Whether the shader turns on an extension.
    pub(in crate::checker) fn has_active(&self, extension: GlExtension) -> bool {
        self.tokens.active.contains(extension)
    }

    /// Checks the layout of the declaration of a variable.
    pub(super) fn check_variable_layout(&mut self, qualified: &Qualified, extent: Extent) {
        let layout = &qualified.layout;
        let at = layout.extent.unwrap_or(extent);
        if layout.matrix || layout.block {
            return self.reject(at, LayoutError::OfBlock);
        }
        let Some(location) = layout.location else {
            return;
        };
        let vertex_in = self.stage == Stage::Vertex && qualified.storage == StorageRequest::In;
        let fragment_out =
            self.stage == Stage::Fragment && qualified.storage == StorageRequest::Out;
        if !vertex_in && !fragment_out {
            self.reject(at, LayoutError::NoLocationHere);
        } else if layout.locations > 1 && fragment_out {
            self.reject(at, LayoutError::Twice);
        } else if vertex_in && location >= MAX_VERTEX_ATTRIBS {
            self.reject(at, LayoutError::OutOfRange(location));
        }
    }

    /// `layout(std140) uniform;`
    pub(super) fn default_layout(&mut self, qualifiers: List, extent: Extent) {
        let qualified = self.qualifiers(qualifiers);
        let problem = if qualified.layout.is_empty() {
            LayoutError::OfNothing
        } else if qualified.layout.views.is_some() && qualified.storage == StorageRequest::In {
            return;
        } else if qualified.storage != StorageRequest::Uniform {
            LayoutError::NotUniform
        } else if qualified.layout.location.is_some() {
            LayoutError::Shared
        } else {
            return;
        };
        self.reject(extent, problem);
    }
}
