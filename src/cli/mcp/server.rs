//! The server: which tools there are, and who answers.

use super::answer::ToolAnswer;
use super::command::OwnProgram;
use super::tools;
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, Implementation, ListToolsResult,
    PaginatedRequestParams, ServerCapabilities, ServerConfig,
};
use rmcp::service::RequestContext;
use rmcp::{ErrorData, RoleServer, ServerHandler};
use std::io;

/// What the client is told of the tools as a whole.
const INSTRUCTIONS: &str = "\
GLSL for WebGL2 and ShaderToy. `check` after each change of a shader: an error means that the \
browser refuses it. `fix` mends what keeps the picture. `run` draws it without a GPU, so that you \
can look at it, and says what numbers and loops did. `explain` says what a rule means. `port` makes \
pages, modules and plain WebGL2 of ShaderToy code. Paths are relative to the folder in which the \
server was started.";

/// The server.
pub struct ToolServer {
    program: OwnProgram,
}

impl ToolServer {
    /// A server whose commands are this program's.
    ///
    /// # Errors
    /// Where the system does not say which program this is.
    pub fn new() -> io::Result<ToolServer> {
        OwnProgram::new().map(|program| ToolServer { program })
    }
}

impl ServerHandler for ToolServer {
    fn get_info(&self) -> ServerConfig {
        let capabilities = ServerCapabilities::builder().enable_tools().build();
        ServerConfig::new(capabilities)
            .with_server_info(Implementation::new("shaderlint", env!("CARGO_PKG_VERSION")))
            .with_instructions(INSTRUCTIONS)
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(tools::all()?))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let arguments = request.arguments.unwrap_or_default();
        let answer = tokio::select! {
            answer = tools::call(&request.name, arguments, &self.program) => answer?,
            () = context.ct.cancelled() => ToolAnswer::failed("it was cancelled"),
        };
        Ok(CallToolResult::from(answer).into())
    }
}
