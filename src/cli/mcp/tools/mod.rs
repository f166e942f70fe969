//! The tools. Each one declares its arguments and translates them to a command.

mod check;
mod explain;
mod fix;
mod format;
mod port;
mod references;
mod run;
mod tool;

use super::answer::ToolAnswer;
use super::command::OwnProgram;
use check::CheckTool;
use explain::ExplainTool;
use fix::FixTool;
use format::FormatTool;
use port::PortTool;
use references::ReferencesTool;
use rmcp::ErrorData;
use rmcp::handler::server::tool::schema_for_input;
use rmcp::model::{JsonObject, ToolAnnotations};
use run::RunTool;
use serde_json::Value;
use tool::{Tool, ToolWrites};

/// The descriptions of all tools.
///
/// # Errors
/// If a schema cannot be generated.
pub fn all() -> Result<Vec<rmcp::model::Tool>, ErrorData> {
    Ok(vec![
        described::<CheckTool>()?,
        described::<FixTool>()?,
        described::<FormatTool>()?,
        described::<RunTool>()?,
        described::<ExplainTool>()?,
        described::<PortTool>()?,
        described::<ReferencesTool>()?,
    ])
}

/// Calls a tool.
///
/// # Errors
/// If no tool has this name.
pub async fn call(
    name: &str,
    arguments: JsonObject,
    program: &OwnProgram,
) -> Result<ToolAnswer, ErrorData> {
    Ok(match name {
        CheckTool::NAME => called::<CheckTool>(arguments, program).await,
        FixTool::NAME => called::<FixTool>(arguments, program).await,
        FormatTool::NAME => called::<FormatTool>(arguments, program).await,
        RunTool::NAME => called::<RunTool>(arguments, program).await,
        ExplainTool::NAME => called::<ExplainTool>(arguments, program).await,
        ReferencesTool::NAME => called::<ReferencesTool>(arguments, program).await,
        PortTool::NAME => called::<PortTool>(arguments, program).await,
        _ => {
            let message = format!("unknown tool `{name}`");
            return Err(ErrorData::invalid_params(message, None));
        }
    })
}

fn described<T: Tool>() -> Result<rmcp::model::Tool, ErrorData> {
    let schema = schema_for_input::<T>().map_err(|e| ErrorData::internal_error(e, None))?;
    let annotations = ToolAnnotations::with_title(T::TITLE)
        .read_only(T::WRITES == ToolWrites::Nothing)
        .destructive(T::WRITES == ToolWrites::Files)
        .idempotent(true)
        .open_world(false);
    Ok(rmcp::model::Tool::new(T::NAME, T::ABOUT, schema).with_annotations(annotations))
}

/// Invalid arguments are reported as an answer, so that the model reads the error.
async fn called<T: Tool>(arguments: JsonObject, program: &OwnProgram) -> ToolAnswer {
    let answer = match serde_json::from_value::<T>(Value::Object(arguments)) {
        Ok(tool) => tool.answer(program).await,
        Err(error) => Err(format!("invalid arguments: {error}")),
    };
    answer.unwrap_or_else(|why| ToolAnswer::failed(&why))
}
