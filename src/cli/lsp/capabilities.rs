//! The capabilities of the server.

use super::client::Client;
use crate::ide::{SymbolKind as Kind, TokenClass};
use gen_lsp_types::*;

/// Semantic token types, indexed by number.
pub const TOKEN_TYPES: [&str; 7] = [
    "variable",
    "parameter",
    "property",
    "function",
    "struct",
    "macro",
    "comment",
];
/// Semantic token modifiers, indexed by bit.
pub const TOKEN_MODIFIERS: [&str; 4] =
    ["declaration", "readonly", "modification", "defaultLibrary"];

/// The index of a class in [`TOKEN_TYPES`].
pub const fn token_type(class: TokenClass) -> u32 {
    match class {
        TokenClass::Variable => 0,
        TokenClass::Parameter => 1,
        TokenClass::Property => 2,
        TokenClass::Function => 3,
        TokenClass::Struct => 4,
        TokenClass::Macro => 5,
    }
}

/// The token type of code that the preprocessor removes.
pub const INACTIVE: u32 = 6;

/// Command that shows the documentation of a rule.
pub const EXPLAIN: &str = "shaderlint.explain";
/// Command that opens the preview in the browser.
pub const PREVIEW: &str = "shaderlint.openPreview";
/// Command that applies all safe fixes.
pub const FIX_ALL: &str = "shaderlint.fixAll";

/// The kind of code action that applies all safe fixes.
pub const FIX_ALL_KIND: CodeActionKind =
    CodeActionKind::Custom(std::borrow::Cow::Borrowed("source.fixAll.shaderlint"));

/// The capabilities announced to a client.
pub fn capabilities(client: &Client) -> ServerCapabilities {
    let words = |all: &[&str]| Some(all.iter().map(|s| s.to_string()).collect::<Vec<_>>());
    ServerCapabilities {
        position_encoding: Some(client.columns.kind()),
        text_document_sync: Some(TextDocumentSync::Options(TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::Incremental),
            save: Some(Save::Bool(true)),
            ..TextDocumentSyncOptions::default()
        })),
        completion_provider: Some(CompletionOptions {
            trigger_characters: words(&[".", "#", "\"", "/", "("]),
            ..CompletionOptions::default()
        }),
        hover_provider: Some(HoverProvider::Bool(true)),
        signature_help_provider: Some(SignatureHelpOptions {
            trigger_characters: words(&["(", ","]),
            retrigger_characters: words(&[")"]),
            ..SignatureHelpOptions::default()
        }),
        declaration_provider: Some(DeclarationProvider::Bool(true)),
        definition_provider: Some(DefinitionProvider::Bool(true)),
        type_definition_provider: Some(TypeDefinitionProvider::Bool(true)),
        references_provider: Some(ReferencesProvider::Bool(true)),
        document_highlight_provider: Some(DocumentHighlightProvider::Bool(true)),
        document_symbol_provider: Some(DocumentSymbolProvider::Bool(true)),
        workspace_symbol_provider: Some(WorkspaceSymbolProvider::Bool(true)),
        code_action_provider: Some(CodeActionProvider::CodeActionOptions(CodeActionOptions {
            code_action_kinds: Some(vec![CodeActionKind::QuickFix, FIX_ALL_KIND]),
            ..CodeActionOptions::default()
        })),
        code_lens_provider: Some(CodeLensOptions::default()),
        color_provider: Some(ColorProvider::Bool(true)),
        document_formatting_provider: Some(DocumentFormattingProvider::Bool(true)),
        document_range_formatting_provider: Some(DocumentRangeFormattingProvider::Bool(true)),
        document_on_type_formatting_provider: Some(DocumentOnTypeFormattingOptions {
            first_trigger_character: "}".to_string(),
            more_trigger_character: words(&[";"]),
        }),
        rename_provider: Some(RenameProvider::RenameOptions(RenameOptions {
            prepare_provider: Some(true),
            ..RenameOptions::default()
        })),
        folding_range_provider: Some(FoldingRangeProvider::Bool(true)),
        selection_range_provider: Some(SelectionRangeProvider::Bool(true)),
        execute_command_provider: Some(ExecuteCommandOptions {
            commands: [EXPLAIN, PREVIEW, FIX_ALL].map(str::to_string).to_vec(),
            ..ExecuteCommandOptions::default()
        }),
        call_hierarchy_provider: Some(CallHierarchyProvider::Bool(true)),
        semantic_tokens_provider: Some(tokens()),
        inlay_hint_provider: Some(InlayHintProvider::Bool(true)),
        diagnostic_provider: client.pulls.then(|| {
            DiagnosticProvider::DiagnosticOptions(DiagnosticOptions {
                identifier: Some("shaderlint".to_string()),
                inter_file_dependencies: true,
                workspace_diagnostics: true,
                ..DiagnosticOptions::default()
            })
        }),
        workspace: Some(WorkspaceOptions {
            workspace_folders: Some(WorkspaceFoldersServerCapabilities {
                supported: Some(true),
                change_notifications: Some(ChangeNotifications::Bool(true)),
            }),
            ..WorkspaceOptions::default()
        }),
        ..ServerCapabilities::default()
    }
}

fn tokens() -> SemanticTokensProvider {
    SemanticTokensProvider::SemanticTokensOptions(SemanticTokensOptions {
        legend: SemanticTokensLegend {
            token_types: TOKEN_TYPES.map(str::to_string).to_vec(),
            token_modifiers: TOKEN_MODIFIERS.map(str::to_string).to_vec(),
        },
        range: Some(SemanticTokensOptionsRange::Bool(true)),
        full: Some(Full::SemanticTokensFullDelta(SemanticTokensFullDelta {
            delta: Some(true),
        })),
        ..SemanticTokensOptions::default()
    })
}

/// The symbol kind of the protocol for a kind of symbol.
pub fn symbol_kind(kind: Kind) -> SymbolKind {
    match kind {
        Kind::Function => SymbolKind::Function,
        Kind::Struct => SymbolKind::Struct,
        Kind::Field => SymbolKind::Field,
        Kind::Constant | Kind::Macro => SymbolKind::Constant,
        Kind::Uniform | Kind::Input | Kind::Output => SymbolKind::Property,
        Kind::Local | Kind::Global | Kind::Parameter => SymbolKind::Variable,
    }
}
