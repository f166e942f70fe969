//! Messages for [`Restriction`]: what WebGL1 does not accept of GLSL ES 1.00.

use super::*;

impl Explain for Restriction {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use Restriction as E;
        let message = match self {
            E::Loop(word) => format!("WebGL1 does not support `{word}` loops"),
            E::NoIndex => "a WebGL1 loop must declare its index: `for (int i = 0; ...`".into(),
            E::Indices => {
                "a WebGL1 loop must declare exactly one index: `for (int i = 0; ...`".into()
            }
            E::IndexType => "a WebGL1 loop index must be `int` or `float`".into(),
            E::Start => "a WebGL1 loop index must start at a constant".into(),
            E::NoCondition => "a WebGL1 loop must have a condition: `i < 10`".into(),
            E::Condition => "a WebGL1 loop must compare its index with a constant".into(),
            E::End => "the bound of a WebGL1 loop must be a constant".into(),
            E::Step => {
                "a WebGL1 loop must change its index by a constant: `i++` or `i += 2`".into()
            }
            E::IndexWritten => "a WebGL1 loop body must not change the loop index".into(),
            E::Subscript => "WebGL1 allows only constants and loop indices as an index here".into(),
            E::FragData => {
                let message = "`gl_FragData` has only one element here, at index 0";
                return c.error(error::INDEX_OUT_OF_RANGE, at, message).note(
                    "more elements need `WEBGL_draw_buffers` in WebGL1; WebGL2 has several `out` variables in `#version 300 es`",
                );
            }
        };
        c.error(error::WEBGL1_RESTRICTION, at, message)
            .note("required by GLSL ES 1.00 Appendix A; `#version 300 es` has no such rule")
    }
}
