//! Editor features independent of the protocol: definitions, references, completion, hovers,
//! renaming. Positions are byte offsets; front ends convert them to lines and columns.
#![cfg_attr(test, allow(clippy::string_slice))]

mod actions;
mod bound;
mod branches;
mod color;
mod complete;
mod cost;
mod document;
mod folding;
mod hints;
mod hover;
mod index;
mod lens;
mod library;
mod line_costs;
mod outline;
mod preview;
mod refactor;
mod references;
mod run;
mod selection;
mod signature;
mod symbol;
mod tokens;

pub use actions::{Action, ActionKind, actions, fix_all};
pub use bound::{BoundName, BoundNames, bound_at};
pub use color::{Color, ColorSpan, colors, presentations};
pub use complete::complete;
pub use complete::proposal::{CompletionKind, Proposal};
pub use cost::{CostSource, ShaderCost, shader_cost};
pub use document::{Document, FileSpan, Overlay, Spot};
pub use folding::{FoldKind, FoldingSpan, folds};
pub use hints::{Hint, HintKind, HintOptions, hints};
pub use hover::{Hover, hover};
pub use index::{Index, NameUse, Occurrence};
pub use lens::{Lens, LensCommand, lenses};
pub use outline::{OutlineItem, outline};
pub use preview::{preview_project, previewed};
pub use refactor::{
    NewFile, RefactorKind, Refactoring, ShownValue, WITHIN, refactorings, shown_value,
};
pub use references::calls::{CallItem, CallLink, call_item, incoming, outgoing};
pub use references::navigate::{
    declaration, definition, highlights, references, shared_name, type_definition,
};
pub use references::rename::{RenameRefusal, Renaming, may_rename, rename};
pub use run::{FrameCost, ObservedIterations, RunObservations, frame_cost, image_of, limits, run};
pub use selection::selection;
pub use signature::{Signature, SignatureHelp, signature_help};
pub use symbol::{Symbol, SymbolKind};
pub use tokens::{PlainClass, SemanticKind, SemanticToken, TokenClass, semantic_tokens};
