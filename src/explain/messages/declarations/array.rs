//! Messages for [`ArrayError`].

use crate::messages::*;

impl Explain for ArrayError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use ArrayError as E;
        let report = |message: &str| c.error(error::INVALID_ARRAY, at, message);
        let later = |message| c.error(error::NEEDS_WEBGL2, at, message);
        match self {
            E::NoSize => report("missing array size"),
            E::NoSizeNorValue => report("missing array size").note(
                "an array without a size needs an initializer: `float a[] = float[](1.0, 2.0);`",
            ),
            E::NoSizeYet => later("missing array size")
                .note("GLSL ES 1.00 does not infer the size from an initializer"),
            E::BehindType => later("an array size after the type requires GLSL ES 3.00")
                .help("put it after the name: `float a[2]`"),
            E::OfArrays => report("GLSL ES 3.00 has no arrays of arrays")
                .note("they were added in GLSL ES 3.10, which WebGL2 does not support")
                .help("use one array and compute the index: `a[i * 4 + j]`"),
            E::OfPassedStructs => report("an array of structs cannot be passed between stages"),
            E::Attribute => report("an attribute cannot be an array"),
            E::Input => report("a vertex shader input cannot be an array"),
            E::Constant => report("GLSL ES 1.00 has no constant arrays"),
            E::Value => later("GLSL ES 1.00 has no array initializers")
                .help("assign the elements one by one in a function"),
            E::Constructor => later("array constructors require GLSL ES 3.00"),
            E::SizeType(ty) => {
                let name = c.name_of(ty);
                report(&format!("array size must be an integer, found `{name}`"))
            }
            E::SizeNotConstant(size) => {
                let message = "array size must be a constant expression";
                c.explain_not_constant(c.error(error::NOT_CONSTANT, at, message), size)
            }
            E::NegativeSize => report("array size cannot be negative"),
            E::ZeroSize => report("array size cannot be 0"),
        }
    }
}
