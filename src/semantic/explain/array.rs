//! What is wrong with arrays.

use super::*;

impl Explain for ArrayError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use ArrayError as E;
        let say = |message: &str| c.error(error::INVALID_ARRAY, at, message);
        let later = |message| c.error(error::NEEDS_WEBGL2, at, message);
        match self {
            E::NoSize => say("the array needs a size"),
            E::NoSizeNorValue => say("the array needs a size")
                .note("only an initializer can give it one: `float a[] = float[](1.0, 2.0);`"),
            E::NoSizeYet => {
                later("the array needs a size").note("GLSL ES 1.00 takes none from an initializer")
            }
            E::BehindType => later("an array size cannot stand behind the type here")
                .help("in GLSL ES 1.00 write it behind the name: `float a[2]`"),
            E::OfArrays => say("GLSL ES 3.00 has no arrays of arrays")
                .note("they come with GLSL ES 3.10, which WebGL2 does not have")
                .help("use one array, and compute the index: `a[i * 4 + j]`"),
            E::OfPassedStructs => say("an array of structs cannot be passed between stages"),
            E::Attribute => say("an attribute cannot be an array"),
            E::Input => say("an input of a vertex shader cannot be an array"),
            E::Constant => say("GLSL ES 1.00 has no constant arrays"),
            E::Value => later("GLSL ES 1.00 has no array initializers")
                .help("assign the elements one by one in a function"),
            E::Constructor => later("array constructors come with GLSL ES 3.00"),
            E::SizeType(ty) => {
                let name = c.name_of(ty);
                say(&format!("an array's size must be an integer, not `{name}`"))
            }
            E::SizeNotConstant(size) => {
                let message = "an array's size must be a constant expression";
                c.explain_not_constant(c.error(error::NOT_CONSTANT, at, message), size)
            }
            E::NegativeSize => say("an array's size cannot be negative"),
            E::ZeroSize => say("an array's size cannot be 0"),
        }
    }
}
