//! The capabilities of the server.

use super::client::Client;
use gen_lsp_types::{CodeActionKind, SymbolKind};
use serde_json::{Value, json};
use shaderlint_ide::{PlainClass, RefactorKind, SymbolKind as Kind, TokenClass};
use std::borrow::Cow;

/// Semantic token types, indexed by number.
pub const TOKEN_TYPES: [&str; 11] = [
    "variable",
    "parameter",
    "property",
    "function",
    "struct",
    "macro",
    "comment",
    "keyword",
    "number",
    "operator",
    "type",
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

/// The index of a class of tokens by their spelling in [`TOKEN_TYPES`].
pub const fn plain_type(class: PlainClass) -> u32 {
    match class {
        PlainClass::Variable => 0,
        PlainClass::Function => 3,
        PlainClass::Comment => 6,
        PlainClass::Keyword => 7,
        PlainClass::Number => 8,
        PlainClass::Operator => 9,
        PlainClass::Type => 10,
    }
}

/// What every client receives; `null` where something is inserted. Changes of documents are sent as
/// changes (2), not as full texts.
const CAPABILITIES: &str = include_str!("capabilities.json");

/// Command that shows the documentation of a rule.
pub const EXPLAIN: &str = "shaderlint.explain";
/// Command that opens the preview in the browser.
#[cfg(feature = "preview")]
pub const PREVIEW: &str = "shaderlint.openPreview";
/// Command that writes the inputs of channels that a preview assumes into a file.
#[cfg(feature = "preview")]
pub const WRITE_CHANNELS: &str = "shaderlint.writeChannels";
/// Command that applies all safe fixes.
pub const FIX_ALL: &str = "shaderlint.fixAll";

/// The commands of the server.
const COMMANDS: &[&str] = &[
    EXPLAIN,
    #[cfg(feature = "preview")]
    PREVIEW,
    #[cfg(feature = "preview")]
    WRITE_CHANNELS,
    FIX_ALL,
];

/// The kind of code action that applies all safe fixes.
pub const FIX_ALL_KIND: CodeActionKind =
    CodeActionKind::Custom(Cow::Borrowed("source.fixAll.shaderlint"));

/// The kind of code action of a refactoring.
pub const fn action_kind(kind: RefactorKind) -> CodeActionKind {
    let name = match kind {
        RefactorKind::ExtractVariable => "refactor.extract.variable",
        RefactorKind::ExtractConstant => "refactor.extract.constant",
        RefactorKind::ExtractFunction => "refactor.extract.function",
        RefactorKind::Inline => return CodeActionKind::RefactorInline,
        RefactorKind::Rewrite => return CodeActionKind::RefactorRewrite,
        RefactorKind::Move => return CodeActionKind::RefactorMove,
    };
    CodeActionKind::Custom(Cow::Borrowed(name))
}

/// The kinds of code actions.
fn action_kinds() -> Vec<CodeActionKind> {
    let refactorings = RefactorKind::ALL.into_iter().map(action_kind);
    // Not a kind of refactoring: it shows a value.
    let others = [
        CodeActionKind::QuickFix,
        CodeActionKind::Refactor,
        FIX_ALL_KIND,
    ];
    others.into_iter().chain(refactorings).collect()
}

/// The capabilities announced to a client.
pub fn capabilities(client: &Client) -> Value {
    let mut all: Value = serde_json::from_str(CAPABILITIES).unwrap_or_default();
    let known = [
        ("/positionEncoding", json!(client.columns.name())),
        ("/codeActionProvider/codeActionKinds", json!(action_kinds())),
        ("/executeCommandProvider/commands", json!(COMMANDS)),
        (
            "/semanticTokensProvider/legend/tokenTypes",
            json!(TOKEN_TYPES),
        ),
        (
            "/semanticTokensProvider/legend/tokenModifiers",
            json!(TOKEN_MODIFIERS),
        ),
    ];
    for (place, value) in known {
        if let Some(slot) = all.pointer_mut(place) {
            *slot = value;
        }
    }
    if let (true, Some(fields)) = (client.pulls, all.as_object_mut()) {
        let diagnostics = json!({
            "identifier": "shaderlint",
            "interFileDependencies": true,
            "workspaceDiagnostics": true,
        });
        fields.insert("diagnosticProvider".to_string(), diagnostics);
    }
    all
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
