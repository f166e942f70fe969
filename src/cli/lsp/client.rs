//! The capabilities of the client and the settings of the user.

use super::position::Columns;
use crate::ide::HintOptions;
use gen_lsp_types::{InitializeParams, MarkupKind};
use serde::Deserialize;

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
}

impl Client {
    /// Reads the capabilities from the initialisation parameters.
    pub fn of(params: &InitializeParams) -> Client {
        let all = &params.capabilities;
        let general = all.general.as_ref();
        let encodings = general.and_then(|g| g.position_encodings.as_deref());
        let text = all.text_document.clone().unwrap_or_default();
        let workspace = all.workspace.clone().unwrap_or_default();
        let window = all.window.unwrap_or_default();
        let item = text.completion.and_then(|c| c.completion_item);
        let formats = text.hover.and_then(|h| h.content_format);
        let folding = text.folding_range;
        let dynamic = workspace.did_change_watched_files;
        Client {
            columns: Columns::choose(encodings),
            pulls: text.diagnostic.is_some(),
            refreshes_diagnostics: (workspace.diagnostics.and_then(|d| d.refresh_support))
                .unwrap_or(false),
            refreshes_hints: (workspace.inlay_hint.and_then(|d| d.refresh_support))
                .unwrap_or(false),
            snippets: item.and_then(|i| i.snippet_support).unwrap_or(false),
            markdown: formats.is_none_or(|f| f.contains(&MarkupKind::Markdown)),
            related: text.publish_diagnostics.is_some_and(|p| {
                p.diagnostics_capabilities
                    .related_information
                    .unwrap_or(false)
            }),
            shows_documents: window.show_document.is_some_and(|s| s.support),
            watches: dynamic
                .and_then(|d| d.dynamic_registration)
                .unwrap_or(false),
            configurations: workspace.configuration.unwrap_or(false),
            folds_inside_lines: !folding.and_then(|f| f.line_folding_only).unwrap_or(false),
            nested_outline: (text.document_symbol)
                .and_then(|d| d.hierarchical_document_symbol_support)
                .unwrap_or(false),
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
