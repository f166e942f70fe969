//! What the browser's compiler refuses although the language allows it.

use super::*;

/// Deepest tree that the browser takes.
const MAX_DEPTH: u32 = 256;
/// A variable must be smaller, in bytes.
const MAX_PRIVATE: u64 = 64 * 1024;
/// All variables together, in bytes.
const MAX_TOTAL: u64 = 16 * 1024 * 1024;
/// A uniform or block must be smaller, in bytes.
const MAX_SIZE: u64 = 2 * 1024 * 1024 * 1024;

impl Checker<'_> {
    /// Asks that a node at `depth` of the browser's tree is not too deep; reports once a function.
    pub(super) fn check_depth(&mut self, depth: u32, extent: Extent) {
        if depth <= MAX_DEPTH || self.deep_reported == Some(self.current) {
            return;
        }
        self.deep_reported = Some(self.current);
        let d = self
            .error(error::BROWSER_LIMIT, extent, "this is too complex for the browser")
            .note("it takes code up to a depth of 256: nested statements and operators in a row both count")
            .help("split the expression, or move inner code into a function");
        self.report(d);
    }

    /// A declaration with a value is a node with the value below it.
    pub(super) fn check_declared_depth(&mut self, declarator: &Declarator) {
        if let Some(init) = declarator.init
            && self.current.is_some()
        {
            let height = self.info(init).height as u32;
            self.check_depth(self.level + 2 + height, declarator.extent);
        }
    }

    /// Asks that a variable, and all together, are not too large.
    pub(super) fn check_size(
        &mut self,
        ty: Type,
        storage: Storage,
        ident: Option<Ident>,
        extent: Extent,
    ) {
        if !self.diagnostics.is_empty() || ty.is_error() {
            return;
        }
        let is_uniform = storage == Storage::Uniform;
        let inside = self.inside(ty);
        let size = if is_uniform {
            inside.uniform_bytes
        } else {
            inside.bytes
        };
        let is_fragment_output = storage == Storage::Output && self.stage == Stage::Fragment;
        let is_vertex_input = storage == Storage::Input && self.stage == Stage::Vertex;
        let is_private = !is_uniform && !is_fragment_output && !is_vertex_input;
        if is_private {
            self.private_size = self.private_size.saturating_add(size);
        }
        let limit = if is_private { MAX_PRIVATE } else { MAX_SIZE };
        if size >= limit {
            let name = ident.map_or("this".to_string(), |i| format!("`{}`", self.text(i.name)));
            let d = self
                .error(
                    error::BROWSER_LIMIT,
                    extent,
                    format!("{name} takes {size} bytes; the browser allows less than {limit}"),
                )
                .help("keep large tables in a texture");
            self.report(d);
        }
    }

    pub(super) fn check_total_size(&mut self) {
        if self.private_size > MAX_TOTAL && self.diagnostics.is_empty() {
            let message = format!(
                "all variables together take {} bytes, and the browser allows {MAX_TOTAL}",
                self.private_size
            );
            let d = self.error(error::BROWSER_LIMIT, Extent::default(), message);
            self.report(d);
        }
    }
}
