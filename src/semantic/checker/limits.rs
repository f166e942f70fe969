//! Limits of the browser's compiler that the language itself does not have.

use super::*;

/// Deepest tree that the browser accepts.
const MAX_DEPTH: u32 = 256;
/// Variables must be smaller than this, in bytes.
const MAX_PRIVATE: u64 = 64 * 1024;
/// Most bytes of all variables together.
const MAX_TOTAL: u64 = 16 * 1024 * 1024;
/// Uniforms and blocks must be smaller than this, in bytes.
const MAX_SIZE: u64 = 2 * 1024 * 1024 * 1024;

/// A limit of the browser that the shader exceeds.
#[derive(Clone, Copy, Debug)]
pub enum LimitError {
    /// Nesting depth of statements and operators.
    Depth,
    /// Size of a variable in bytes, and the limit that it must be below.
    Size(Option<Name>, u64, u64),
    /// Size of all variables together in bytes, and the most that is allowed.
    Total(u64, u64),
    /// Number of members of a struct or block.
    Members,
    /// Nesting depth of structs.
    Nesting,
    /// Number of parameters of a function.
    Parameters,
    /// Depth of the call chain.
    CallDepth,
}

impl Checker<'_> {
    /// Checks that `depth` in the browser's tree is not too deep; reports once per function.
    pub(super) fn check_depth(&mut self, depth: u32, extent: Extent) {
        if depth <= MAX_DEPTH || self.deep_reported == Some(self.current) {
            return;
        }
        self.deep_reported = Some(self.current);
        self.reject(extent, LimitError::Depth);
    }

    /// Checks the depth of a declaration, which is a node with its initializer below it.
    pub(super) fn check_declared_depth(&mut self, declarator: &Declarator) {
        if let Some(init) = declarator.init
            && self.current.is_some()
        {
            let height = self.info(init).height as u32;
            self.check_depth(self.level + 2 + height, declarator.extent);
        }
    }

    /// Checks the size of a variable, and adds it to the size of all variables.
    pub(super) fn check_size(
        &mut self,
        ty: Type,
        storage: Storage,
        ident: Option<Ident>,
        extent: Extent,
    ) {
        if !self.problems.is_empty() || ty.is_error() {
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
            let name = ident.map(|i| i.name);
            self.reject(extent, LimitError::Size(name, size, limit));
        }
    }

    pub(super) fn check_total_size(&mut self) {
        if self.private_size > MAX_TOTAL && self.problems.is_empty() {
            let problem = LimitError::Total(self.private_size, MAX_TOTAL);
            self.reject(Extent::default(), problem);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::finds;

    #[test]
    fn exceeded_limits_are_found() {
        let deep = format!("void f(float x) {{ {}x; }}", "x - ".repeat(300));
        let large = "float a[65536];";
        let arrays: String = (0..2000).map(|i| format!("vec4 a{i}[1024];")).collect();
        let members: String = (0..17_000).map(|i| format!("float f{i};")).collect();
        let structs: Vec<String> = (1..5)
            .map(|i| format!("struct S{i} {{ S{} s; }};", i - 1))
            .collect();
        let nested = format!("struct S0 {{ float f; }}; {}", structs.concat());
        let parameters = vec!["float"; 256].join(", ");
        let calls: String = (1..300)
            .map(|i| format!("void f{i}() {{ f{}(); }}", i - 1))
            .collect();
        let table = format!(
            "{deep} => Depth
            {large} => Size
            {arrays} void main() {{}} => Total
            struct S {{ {members} }}; => Members
            {nested} => Nesting
            void f({parameters}) {{}} => Parameters
            void f0() {{}} {calls} void main() {{}} => CallDepth"
        );
        finds(include_str!("limits.rs"), "LimitError", &table);
    }
}
