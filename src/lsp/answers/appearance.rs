//! Semantic tokens, colours, inlay hints, folding and code lenses.

use crate::buffers::TextBuffer;
#[cfg(feature = "preview")]
use crate::capabilities::PREVIEW;
use crate::capabilities::{INACTIVE, plain_type, token_type};
use crate::position::text_edits;
use crate::snapshot::{Answer, Snapshot};
use gen_lsp_types::*;
use shaderlint_ide::{self as ide, FoldKind, HintKind, LensCommand, SemanticKind};
use shaderlint_text::Span;

/// The semantic tokens in the encoding of the protocol: five numbers per token.
fn colored(snapshot: &Snapshot, buffer: &TextBuffer, within: Option<Span>) -> Vec<u32> {
    let lines = buffer.lines(snapshot.columns());
    let mut data = Vec::new();
    let mut last = Position::default();
    for token in ide::semantic_tokens(&snapshot.document(buffer)) {
        if within.is_some_and(|within| !within.touches(token.span)) {
            continue;
        }
        let Range { start, end } = lines.range(token.span);
        if start.line != end.line {
            continue;
        }
        let kind = match token.kind {
            SemanticKind::Symbol(class) => token_type(class),
            SemanticKind::Inactive => INACTIVE,
            SemanticKind::Plain(class) => plain_type(class),
        };
        let bits = [
            token.is_declaration,
            token.is_readonly,
            token.is_modification,
            token.is_library,
        ];
        let modifiers = bits
            .iter()
            .zip(0..)
            .map(|(is_set, bit)| u32::from(*is_set) << bit);
        let column = match start.line == last.line {
            true => start.character - last.character,
            false => start.character,
        };
        let length = end.character - start.character;
        data.extend([
            start.line - last.line,
            column,
            length,
            kind,
            modifiers.sum(),
        ]);
        last = start;
    }
    data
}

fn as_tokens(data: &[u32]) -> Vec<SemanticToken> {
    let token = data.chunks_exact(5).filter_map(|five| match *five {
        [
            delta_line,
            delta_start,
            length,
            token_type,
            token_modifiers_bitset,
        ] => Some(SemanticToken {
            delta_line,
            delta_start,
            length,
            token_type,
            token_modifiers_bitset,
        }),
        _ => None,
    });
    token.collect()
}

/// Stores the tokens that are sent, and returns their result id.
fn keep(snapshot: &Snapshot, buffer: &TextBuffer, data: Vec<u32>) -> String {
    let id = buffer.state.to_string();
    snapshot
        .sent_tokens()
        .insert(buffer.path.clone(), (id.clone(), data));
    id
}

/// The semantic tokens of a document.
pub fn tokens(snapshot: &Snapshot, params: SemanticTokensParams) -> Answer<Option<SemanticTokens>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let data = colored(snapshot, buffer, None);
    Ok(Some(SemanticTokens {
        data: as_tokens(&data),
        result_id: Some(keep(snapshot, buffer, data)),
    }))
}

/// The changes to the semantic tokens that were sent last.
pub fn tokens_delta(
    snapshot: &Snapshot,
    params: SemanticTokensDeltaParams,
) -> Answer<Option<SemanticTokensDeltaResponse>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let data = colored(snapshot, buffer, None);
    let sent = snapshot.sent_tokens().get(&buffer.path).cloned();
    let known = sent.filter(|(id, _)| *id == params.previous_result_id);
    let answer = match known {
        None => SemanticTokens {
            data: as_tokens(&data),
            result_id: Some(keep(snapshot, buffer, data)),
        }
        .into(),
        Some((_, old)) => {
            let before = old.iter().zip(&data).take_while(|(a, b)| a == b).count();
            let most = old.len().min(data.len()) - before;
            let ends = old.iter().rev().zip(data.iter().rev()).take(most);
            let after = ends.take_while(|(a, b)| a == b).count();
            let edit = SemanticTokensEdit {
                start: before as u32,
                delete_count: (old.len() - before - after) as u32,
                data: data.get(before..data.len() - after).map(<[u32]>::to_vec),
            };
            let is_same = old == data;
            SemanticTokensDelta {
                result_id: Some(keep(snapshot, buffer, data)),
                edits: if is_same { Vec::new() } else { vec![edit] },
            }
            .into()
        }
    };
    Ok(Some(answer))
}

/// The semantic tokens of a range.
pub fn tokens_range(
    snapshot: &Snapshot,
    params: SemanticTokensRangeParams,
) -> Answer<Option<SemanticTokens>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let within = snapshot.span(buffer, params.range);
    Ok(Some(SemanticTokens {
        result_id: None,
        data: as_tokens(&colored(snapshot, buffer, Some(within))),
    }))
}

/// The inlay hints of a range.
pub fn hints(snapshot: &Snapshot, params: InlayHintParams) -> Answer<Option<Vec<InlayHint>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let within = snapshot.span(buffer, params.range);
    let document = snapshot.best(buffer);
    let seen = snapshot.seen(buffer);
    let found = ide::hints(&document, within, snapshot.settings.hints(), &seen);
    let lines = buffer.lines(snapshot.columns());
    let items = found.into_iter().map(|hint| InlayHint {
        position: lines.position(hint.offset),
        label: Label::String(hint.text),
        kind: Some(match hint.kind {
            HintKind::Parameter => InlayHintKind::Parameter,
            HintKind::Iterations | HintKind::Type => InlayHintKind::Type,
        }),
        text_edits: None,
        tooltip: None,
        padding_left: None,
        padding_right: (hint.kind == HintKind::Parameter).then_some(true),
        data: None,
    });
    Ok(Some(items.collect()))
}

/// The folding ranges of a document.
pub fn folds(snapshot: &Snapshot, params: FoldingRangeParams) -> Answer<Option<Vec<FoldingRange>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let lines = buffer.lines(snapshot.columns());
    let found = ide::folds(&snapshot.document(buffer));
    let items = found.into_iter().filter_map(|fold| {
        let Range { start, end } = lines.range(fold.span);
        let inside = snapshot.client.folds_inside_lines;
        // Complete lines are folded; the line with the closing bracket stays visible.
        let keeps_last = fold.kind != FoldKind::Comment && !inside;
        let end_line = end.line.checked_sub(u32::from(keeps_last))?;
        (end_line > start.line).then(|| FoldingRange {
            start_line: start.line,
            start_character: inside.then_some(start.character),
            end_line,
            end_character: inside.then_some(end.character),
            kind: match fold.kind {
                FoldKind::Block => None,
                FoldKind::Comment => Some(FoldingRangeKind::Comment),
                FoldKind::Group => Some(FoldingRangeKind::Region),
            },
            collapsed_text: None,
        })
    });
    Ok(Some(items.collect()))
}

/// The selection ranges around positions.
pub fn selections(
    snapshot: &Snapshot,
    params: SelectionRangeParams,
) -> Answer<Option<Vec<SelectionRange>>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let document = snapshot.document(buffer);
    let lines = buffer.lines(snapshot.columns());
    let around = |position: &Position| {
        let spans = ide::selection(&document, lines.offset(*position));
        let mut outer: Option<SelectionRange> = None;
        for span in spans.iter().rev() {
            outer = Some(SelectionRange {
                range: lines.range(*span),
                parent: outer.map(Box::new),
            });
        }
        outer.unwrap_or_default()
    };
    Ok(Some(params.positions.iter().map(around).collect()))
}

/// The colours in a document.
pub fn colors(snapshot: &Snapshot, params: DocumentColorParams) -> Answer<Vec<ColorInformation>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let lines = buffer.lines(snapshot.columns());
    let found = ide::colors(&snapshot.document(buffer)).into_iter();
    let items = found.map(|found| {
        let [red, green, blue] = found.color.rgb;
        ColorInformation {
            range: lines.range(found.span),
            color: Color {
                red,
                green,
                blue,
                alpha: found.color.alpha.unwrap_or(1.0),
            },
        }
    });
    Ok(items.collect())
}

/// The ways to write a colour.
pub fn presentations(
    snapshot: &Snapshot,
    params: ColorPresentationParams,
) -> Answer<Vec<ColorPresentation>> {
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let span = snapshot.span(buffer, params.range);
    let color = ide::Color {
        rgb: [params.color.red, params.color.green, params.color.blue],
        alpha: Some(params.color.alpha),
    };
    let edits = ide::presentations(&snapshot.document(buffer), span, color);
    let edits = text_edits(buffer.lines(snapshot.columns()), &edits).into_iter();
    let items = edits.map(|edit| ColorPresentation {
        label: edit.new_text.clone(),
        text_edit: Some(edit),
        additional_text_edits: None,
    });
    Ok(items.collect())
}

/// The code lenses above functions and numbers.
pub fn lenses(snapshot: &Snapshot, params: CodeLensParams) -> Answer<Option<Vec<CodeLens>>> {
    if !snapshot.settings.lenses {
        return Ok(None);
    }
    let buffer = snapshot.buffer(&params.text_document.uri)?;
    let lines = buffer.lines(snapshot.columns());
    let found = ide::lenses(&snapshot.best(buffer), &snapshot.seen(buffer));
    let own_view = snapshot.settings.preview_command.as_ref();
    let items = found.into_iter().filter_map(|lens| {
        let (command, arguments) = match lens.command {
            LensCommand::Nothing => (String::new(), None),
            LensCommand::Preview(shader) => {
                #[cfg(feature = "preview")]
                let command = own_view.cloned().unwrap_or_else(|| PREVIEW.to_string());
                #[cfg(not(feature = "preview"))]
                let command = own_view.cloned()?;
                (
                    command,
                    Some(vec![buffer.uri.0.clone().into(), shader.into()]),
                )
            }
            // Only clients with their own view have sliders.
            LensCommand::Tune {
                value_span,
                value,
                min,
                max,
            } => {
                own_view?;
                let range = serde_json::to_value(lines.range(value_span)).ok()?;
                let arguments = vec![
                    buffer.uri.0.clone().into(),
                    range,
                    value.into(),
                    min.into(),
                    max.into(),
                ];
                ("shaderlint.tune".to_string(), Some(arguments))
            }
        };
        Some(CodeLens {
            range: lines.range(lens.span),
            command: Some(Command {
                title: lens.title,
                command,
                arguments,
                tooltip: None,
            }),
            data: None,
        })
    });
    Ok(Some(items.collect()))
}
