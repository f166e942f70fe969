//! The server: lists the tools and dispatches calls.

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

/// Instructions that the client receives about all tools.
const INSTRUCTIONS: &str = "\
Tools for GLSL shaders in WebGL2 and ShaderToy. Call `check` after each change of a shader: an error \
means that the browser rejects it. `fix` applies fixes that do not change the image. `run` draws the \
shader without a GPU and returns the image with statistics of numbers and loops. `explain` documents \
a rule. `port` converts ShaderToy shaders to pages, modules or plain WebGL2 shaders. Paths are \
relative to the folder in which the server was started.";

/// The MCP server.
pub struct ToolServer {
    program: OwnProgram,
}

impl ToolServer {
    /// A server that runs commands of this program.
    ///
    /// # Errors
    /// If the path of this program cannot be determined.
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
            () = context.ct.cancelled() => ToolAnswer::failed("cancelled"),
        };
        Ok(CallToolResult::from(answer).into())
    }
}
