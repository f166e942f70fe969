//! What the client can do and what its user has set.

use super::position::Columns;
use crate::ide::HintOptions;
use gen_lsp_types::{InitializeParams, MarkupKind};
use serde::Deserialize;

/// What the client can do.
#[derive(Clone, Default, Debug)]
pub struct Client {
    /// What columns count.
    pub columns: Columns,
    /// Whether it asks for diagnostics itself.
    pub pulls: bool,
    /// Whether it can be told to ask for diagnostics again.
    pub refreshes_diagnostics: bool,
    /// Whether it can be told to ask for hints and lenses again.
    pub refreshes_hints: bool,
    /// Whether completions may have places to fill in.
    pub snippets: bool,
    /// Whether hovers may be Markdown.
    pub markdown: bool,
    /// Whether it shows related places beside a diagnostic.
    pub related: bool,
    /// Whether it shows documents when told to.
    pub shows_documents: bool,
    /// Whether it can be told which files to watch.
    pub watches: bool,
    /// Whether it knows its settings when asked.
    pub configurations: bool,
    /// Whether folds may begin inside of a line.
    pub folds_inside_lines: bool,
    /// Whether it knows outlines with members.
    pub nested_outline: bool,
}

impl Client {
    /// What a client says of itself.
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

/// What a user can set. All have a value where nothing is said.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct UserSettings {
    /// Whether shaders are run in the background, for what only a run shows.
    pub run: bool,
    /// Whether hovers show what a variable looks like all over the picture.
    pub pictures: bool,
    /// What is written between the words.
    pub hints: UserHints,
    /// What stands above functions.
    pub lenses: bool,
    /// What is run to show a shader, where the client has a view of its own.
    pub preview_command: Option<String>,
}

/// Which hints are shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct UserHints {
    /// Names of parameters.
    pub parameters: bool,
    /// How often loops turn.
    #[serde(rename = "loopIterations")]
    pub turns: bool,
    /// Types of `?:` and of components.
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
            turns: true,
            types: false,
        }
    }
}

impl UserSettings {
    /// Reads settings; those of the tool may stand under its name. Clients without settings send
    /// something else than an object.
    ///
    /// # Errors
    /// In words, where one has a value that it cannot have.
    pub fn read(value: &serde_json::Value) -> Result<Option<UserSettings>, String> {
        let own = value.get("shaderlint").unwrap_or(value);
        if !own.is_object() {
            return Ok(None);
        }
        match UserSettings::deserialize(own) {
            Ok(settings) => Ok(Some(settings)),
            Err(error) => Err(format!(
                "shaderlint: the settings stay as they were: {error}"
            )),
        }
    }

    /// The hints that are wanted.
    pub fn hints(&self) -> HintOptions {
        HintOptions {
            parameters: self.hints.parameters,
            turns: self.hints.turns,
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
        assert!(settings.hints.types && settings.hints.turns && !settings.run);
        let read = |text: &str| UserSettings::read(&serde_json::from_str(text).unwrap());
        assert_eq!(read("{}"), Ok(Some(UserSettings::default())));
        assert_eq!(read("null"), Ok(None));
        let wrong = read(r#"{ "shaderlint": { "run": "never" } }"#).unwrap_err();
        assert!(wrong.contains("\"never\", expected a boolean"), "{wrong}");
    }
}
