//! The capabilities of the client and the settings of the user.

use super::position::Columns;
use serde::Deserialize;
use serde_json::Value;
use shaderlint_ide::HintOptions;

/// The capabilities of the client.
#[derive(Clone, Default, Debug)]
pub struct Client {
    /// Unit of columns.
    pub columns: Columns,
    /// Whether the client requests diagnostics itself.
    pub pulls: bool,
    /// Whether the server can ask the client to refresh diagnostics.
    pub refreshes_diagnostics: bool,
    /// Whether the server can ask the client to refresh inlay hints and code lenses.
    pub refreshes_hints: bool,
    /// Whether completions may be snippets.
    pub snippets: bool,
    /// Whether hovers may be Markdown.
    pub markdown: bool,
    /// Whether diagnostics may have related locations.
    pub related: bool,
    /// Whether the client can show documents.
    pub shows_documents: bool,
    /// Whether the server can register file watchers.
    pub watches: bool,
    /// Whether the server can request settings.
    pub configurations: bool,
    /// Whether folding ranges may start inside a line.
    pub folds_inside_lines: bool,
    /// Whether document symbols may be nested.
    pub nested_outline: bool,
    /// Whether edits may create files.
    pub creates_files: bool,
}

impl Client {
    /// Reads the capabilities from the parameters of `initialize`, by the paths of their fields: types for
    /// all of the protocol would be a tenth of a WebAssembly module.
    pub fn of(params: &Value) -> Client {
        let get = |path: &str| params.pointer(&format!("/capabilities/{path}"));
        let is = |path: &str| get(path).and_then(Value::as_bool).unwrap_or(false);
        let exists = |path: &str| get(path).is_some_and(Value::is_object);
        let names = |path: &str| {
            let all = get(path)?.as_array()?;
            Some(all.iter().filter_map(Value::as_str).collect::<Vec<_>>())
        };
        let formats = names("textDocument/hover/contentFormat");
        let operations = names("workspace/workspaceEdit/resourceOperations");
        Client {
            columns: Columns::choose(&names("general/positionEncodings").unwrap_or_default()),
            pulls: exists("textDocument/diagnostic"),
            refreshes_diagnostics: is("workspace/diagnostics/refreshSupport"),
            refreshes_hints: is("workspace/inlayHint/refreshSupport"),
            snippets: is("textDocument/completion/completionItem/snippetSupport"),
            markdown: formats.is_none_or(|all| all.contains(&"markdown")),
            related: is("textDocument/publishDiagnostics/relatedInformation"),
            shows_documents: is("window/showDocument/support"),
            watches: is("workspace/didChangeWatchedFiles/dynamicRegistration"),
            configurations: is("workspace/configuration"),
            folds_inside_lines: !is("textDocument/foldingRange/lineFoldingOnly"),
            creates_files: is("workspace/workspaceEdit/documentChanges")
                && operations.is_some_and(|all| all.contains(&"create")),
            nested_outline: is("textDocument/documentSymbol/hierarchicalDocumentSymbolSupport"),
        }
    }
}

/// The settings of the user, with their defaults.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct UserSettings {
    /// Whether shaders are executed in the background for findings of sample runs.
    pub run: bool,
    /// Whether hovers show an image of the values of a variable.
    pub pictures: bool,
    /// Which inlay hints are shown.
    pub hints: UserHints,
    /// Whether code lenses are shown.
    pub lenses: bool,
    /// Client command that opens its own preview, if it has one.
    pub preview_command: Option<String>,
    /// Client command that renames the name at a position, if it has one: a refactoring that writes a
    /// new name then asks for a better one.
    pub rename_command: Option<String>,
}

/// Which inlay hints are shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct UserHints {
    /// Whether names of parameters are shown.
    pub parameters: bool,
    /// Whether iteration counts of loops are shown.
    #[serde(rename = "loopIterations")]
    pub iterations: bool,
    /// Whether types of `?:` and of swizzles are shown.
    pub types: bool,
}

impl Default for UserSettings {
    fn default() -> UserSettings {
        UserSettings {
            run: true,
            pictures: true,
            hints: UserHints::default(),
            lenses: true,
            preview_command: None,
            rename_command: None,
        }
    }
}

impl Default for UserHints {
    fn default() -> UserHints {
        UserHints {
            parameters: true,
            iterations: true,
            types: false,
        }
    }
}

impl UserSettings {
    /// Reads settings, which may be nested under the name of the tool. Clients without settings may
    /// send values other than objects.
    ///
    /// # Errors
    /// A message if a setting has an invalid value.
    pub fn read(value: &serde_json::Value) -> Result<Option<UserSettings>, String> {
        let own = value.get("shaderlint").unwrap_or(value);
        if !own.is_object() {
            return Ok(None);
        }
        match UserSettings::deserialize(own) {
            Ok(settings) => Ok(Some(settings)),
            Err(error) => Err(format!("shaderlint: invalid settings are ignored: {error}")),
        }
    }

    /// The options of inlay hints.
    pub fn hints(&self) -> HintOptions {
        HintOptions {
            parameters: self.hints.parameters,
            iterations: self.hints.iterations,
            types: self.hints.types,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_read_by_their_names() {
        let value =
            serde_json::json!({ "shaderlint": { "hints": { "types": true }, "run": false } });
        let settings = UserSettings::read(&value).unwrap().unwrap();
        assert!(settings.hints.types && settings.hints.iterations && !settings.run);
        let read = |text: &str| UserSettings::read(&serde_json::from_str(text).unwrap());
        assert_eq!(read("{}"), Ok(Some(UserSettings::default())));
        assert_eq!(read("null"), Ok(None));
        let wrong = read(r#"{ "shaderlint": { "run": "never" } }"#).unwrap_err();
        assert!(wrong.contains("\"never\", expected a boolean"), "{wrong}");
    }
}
