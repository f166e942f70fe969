//! What WebGL1 does not take of GLSL ES 1.00.

use super::*;

impl Explain for Restriction {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use Restriction as E;
        let message = match self {
            E::Loop(word) => format!("WebGL1 has no `{word}` loops"),
            E::NoIndex => "a WebGL1 loop must declare its index: `for (int i = 0; ...`".into(),
            E::Indices => "a WebGL1 loop must declare one index: `for (int i = 0; ...`".into(),
            E::IndexType => "the index of a WebGL1 loop must be `int` or `float`".into(),
            E::Start => "the index of a WebGL1 loop must start at a constant".into(),
            E::NoCondition => "a WebGL1 loop must have a condition: `i < 10`".into(),
            E::Condition => {
                "the condition of a WebGL1 loop must compare its index with a constant".into()
            }
            E::End => "a WebGL1 loop must end at a constant".into(),
            E::Step => {
                "a WebGL1 loop must change its index by a constant: `i++` or `i += 2`".into()
            }
            E::IndexWritten => "the body of a WebGL1 loop must not change its index".into(),
            E::Subscript => "WebGL1 takes only constants and loop indices as an index here".into(),
            E::FragData => {
                let message = "`gl_FragData` has one element here, with index 0";
                return c.error(error::INDEX_OUT_OF_RANGE, at, message).note(
                    "more need the extension `GL_EXT_draw_buffers`, which WebGL2 does not have",
                );
            }
        };
        c.error(error::WEBGL1_RESTRICTION, at, message)
            .note("GLSL ES 1.00 Appendix A; `#version 300 es` has no such rule")
    }
}
