//! Messages for [`CallError`].

use super::*;

impl Explain for CallError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        match self {
            CallError::Undefined(callee) => {
                let name = c.function_name(callee);
                let message = format!("function `{name}` is declared but never defined");
                let d = c.error(error::UNDEFINED_FUNCTION, at, message);
                c.with_declaration(d, c.function_token(callee), "declared here")
            }
            CallError::Recursion(cycle) => {
                let names: Vec<String> = cycle
                    .iter()
                    .map(|&f| format!("`{}`", c.function_name(f)))
                    .collect();
                let name = names.first().map_or("", String::as_str);
                let message = match names.len() {
                    2 => format!("{name} calls itself"),
                    _ => format!("{name} calls itself: {}", names.join(" -> ")),
                };
                c.error(error::RECURSION, at, message)
                    .note("GLSL does not allow recursion (section 6.1)")
                    .help("use a loop, with an array as the stack if needed")
            }
        }
    }
}
