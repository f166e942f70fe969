//! The requests `debug` and `debugIdle`: messages of the Debug Adapter Protocol.

use super::project::{ShaderText, valid};
use serde_json::Value;
use shaderlint_commands::run::Loaded;
use shaderlint_dap::{Adapter, Launch, ProgramSource};
use shaderlint_play::Decode;
use std::sync::Arc;

/// A debugger of the texts that come with `launch`.
pub struct ModuleDebugger {
    adapter: Adapter<'static>,
}

impl Default for ModuleDebugger {
    fn default() -> ModuleDebugger {
        ModuleDebugger {
            adapter: Adapter::new(&SentPrograms),
        }
    }
}

impl ModuleDebugger {
    /// Handles a message of the client. Returns the messages for it.
    pub fn message(&mut self, message: &Value) -> Value {
        let messages = self.adapter.handle(message);
        if self.adapter.is_done {
            *self = ModuleDebugger::default();
        }
        messages.into()
    }

    /// Counts what new breakpoints hit. Returns messages for the client.
    pub fn idle(&mut self) -> Value {
        // No message can come while a worker is busy.
        self.adapter.idle(&Arc::default()).into()
    }
}

/// Programs in the arguments of `launch`.
struct SentPrograms;

impl ProgramSource for SentPrograms {
    fn load(&self, launch: &Launch) -> Result<Loaded, String> {
        valid(&ShaderText {
            name: launch.program.clone(),
            text: launch.text.clone().unwrap_or_default(),
            passes: launch.passes.clone(),
            files: launch.files.clone(),
            input: launch.input.clone(),
        })
    }

    fn decode(&self) -> Option<Decode> {
        None
    }

    fn threads(&self) -> usize {
        1
    }

    fn text(&self, _: &str) -> Option<String> {
        None
    }
}
