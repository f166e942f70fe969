//! Hovers, completions and signature help.

use crate::snapshot::{Answer, Snapshot};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use gen_lsp_types::*;
use shaderlint_engine::Analysis;
use shaderlint_ide::{self as ide, CompletionKind, Proposal, Symbol, SymbolKind, image_of};
use shaderlint_lint::Page;
use shaderlint_play::{RenderedImage, png};
use shaderlint_rules::page;
use shaderlint_text::Span;

/// The hover at a position.
pub fn hover(snapshot: &Snapshot, params: HoverParams) -> Answer<Option<Hover>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let document = snapshot.best(buffer);
    if let Some(rule) = rule_at(&buffer.text, offset) {
        return Ok(Some(hover_of(
            snapshot,
            buffer.lines(snapshot.columns()).range(rule.0),
            rule.1,
        )));
    }
    let seen = snapshot.seen(buffer);
    let shader = document.spot(offset).map(|spot| spot.shader);
    let seen = shader.and_then(|at| seen.get(at)).and_then(Option::as_ref);
    let Some(found) = ide::hover(&document, offset, seen, &snapshot.files) else {
        return Ok(None);
    };
    let mut text = found.text;
    if snapshot.settings.pictures && snapshot.client.markdown {
        text.push_str(&rendered(&document, offset).unwrap_or_default());
    }
    let range = buffer.lines(snapshot.columns()).range(found.span);
    Ok(Some(hover_of(snapshot, range, text)))
}

fn hover_of(snapshot: &Snapshot, range: Range, text: String) -> Hover {
    let (kind, text) = match snapshot.client.markdown {
        true => (MarkupKind::Markdown, text),
        false => (MarkupKind::PlainText, plain(&text)),
    };
    Hover {
        contents: Contents::MarkupContent(MarkupContent { kind, value: text }),
        range: Some(range),
    }
}

/// A hover as plain text, without fences, images and inline code.
fn plain(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("```"));
    let line = lines.map(|line| {
        let shown = line.split(" ![").next().unwrap_or(line);
        shown.replace('`', "")
    });
    line.collect::<Vec<_>>().join("\n").trim().to_string()
}

/// The rule that a suppression comment at a position names, and its documentation.
fn rule_at(text: &str, offset: u32) -> Option<(Span, String)> {
    let is_name = |c: char| c.is_ascii_alphanumeric() || c == '-';
    let before = text.get(..offset as usize)?;
    let start = before.trim_end_matches(is_name).len();
    let rest = text.get(start..)?;
    let end = start + rest.find(|c| !is_name(c)).unwrap_or(rest.len());
    let line = before.rsplit('\n').next()?;
    if !line.contains("shaderlint:") {
        return None;
    }
    let name = text.get(start..end)?;
    let summary = Page::new(page(name)?).summary;
    Some((
        Span::new(start as u32, end as u32),
        format!("`{name}`: {summary}"),
    ))
}

/// The values of the variable at a position over the whole frame, as a Markdown image.
fn rendered(document: &ide::Document, offset: u32) -> Option<String> {
    let spot = document.spot(offset)?;
    let name = spot.name()?;
    let Symbol::Variable(variable) = name.symbol else {
        return None;
    };
    let kind = name.symbol.kind(spot.program());
    let is_listed = matches!(
        kind,
        SymbolKind::Local | SymbolKind::Global | SymbolKind::Parameter
    );
    let is_number = name.symbol.ty(spot.program())?.numeric().is_some();
    if !is_listed || !is_number {
        return None;
    }
    let code = document.report.sources.file_at(name.span.start)?;
    let at = name.span.start - code.base;
    let (start, end) = code.lines().bounds(at, code.text.len() as u32);
    let line = Span::new(code.base + start, code.base + end);
    let analysis: &Analysis = spot.analysis;
    let image = image_of(analysis, variable, line)?;
    let file = enlarged(&image)?;
    Some(format!(
        "\n![its values over the whole frame](data:image/png;base64,{})\n",
        STANDARD.encode(file)
    ))
}

/// The image as a PNG file, enlarged.
fn enlarged(image: &RenderedImage) -> Option<Vec<u8>> {
    /// Each pixel of the frame is scaled up to this many pixels.
    const ZOOM: usize = 3;
    let [width, height] = image.size;
    let bytes = image.bytes();
    let mut rows = Vec::with_capacity(bytes.len() * ZOOM * ZOOM);
    for row in bytes.chunks_exact(width as usize * 3) {
        for _ in 0..ZOOM {
            for pixel in row.chunks_exact(3) {
                (0..ZOOM).for_each(|_| rows.extend_from_slice(pixel));
            }
        }
    }
    png([width, height].map(|n| n * ZOOM as u32), &rows).ok()
}

/// The completions at a position.
pub fn completion(
    snapshot: &Snapshot,
    params: CompletionParams,
) -> Answer<Option<CompletionResponse>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let document = snapshot.document(buffer);
    let (word, found) = ide::complete(&document, offset, &snapshot.files);
    let range = buffer.lines(snapshot.columns()).range(word);
    let items = found
        .into_iter()
        .map(|item| completion_item(snapshot, range, item));
    Ok(Some(CompletionResponse::CompletionList(CompletionList {
        items: items.collect(),
        ..CompletionList::default()
    })))
}

fn completion_item(snapshot: &Snapshot, range: Range, found: Proposal) -> CompletionItem {
    let snippet = found.snippet.filter(|_| snapshot.client.snippets);
    let format = snippet.as_ref().map(|_| InsertTextFormat::Snippet);
    let new_text = snippet.unwrap_or_else(|| found.label.clone());
    let documentation = Some(found.text).filter(|text| !text.is_empty());
    CompletionItem {
        kind: Some(completion_kind(found.kind)),
        detail: Some(found.detail).filter(|detail| !detail.is_empty()),
        documentation: documentation.map(|value| {
            Documentation::MarkupContent(MarkupContent {
                kind: MarkupKind::Markdown,
                value,
            })
        }),
        sort_text: Some(format!("{:04}{}", found.rank, found.label)),
        insert_text_format: format,
        text_edit: Some(CompletionItemTextEdit::TextEdit(TextEdit {
            range,
            new_text,
        })),
        label: found.label,
        ..CompletionItem::default()
    }
}

fn completion_kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Symbol(kind) => match kind {
            SymbolKind::Function => CompletionItemKind::Function,
            SymbolKind::Struct => CompletionItemKind::Struct,
            SymbolKind::Field => CompletionItemKind::Field,
            SymbolKind::Macro | SymbolKind::Constant => CompletionItemKind::Constant,
            _ => CompletionItemKind::Variable,
        },
        CompletionKind::Type => CompletionItemKind::Class,
        CompletionKind::Keyword => CompletionItemKind::Keyword,
        CompletionKind::Components => CompletionItemKind::Property,
        CompletionKind::Snippet => CompletionItemKind::Snippet,
        CompletionKind::File => CompletionItemKind::File,
        CompletionKind::Rule => CompletionItemKind::Value,
    }
}

/// The signatures of the call at a position.
pub fn signature_help(
    snapshot: &Snapshot,
    params: SignatureHelpParams,
) -> Answer<Option<SignatureHelp>> {
    let (buffer, offset) = snapshot.place(&params.text_document_position_params)?;
    let document = snapshot.document(buffer);
    let Some(found) = ide::signature_help(&document, offset, &snapshot.files) else {
        return Ok(None);
    };
    let signatures = found.signatures.into_iter().map(|signature| {
        // Labels are ASCII, so offsets are the same in every encoding.
        let parameters = signature
            .parameters
            .iter()
            .map(|span| ParameterInformation {
                label: ParameterInformationLabel::Tuple((span.start, span.end)),
                documentation: None,
            });
        SignatureInformation {
            parameters: Some(parameters.collect()),
            documentation: Some(Documentation::MarkupContent(MarkupContent {
                kind: MarkupKind::Markdown,
                value: signature.text,
            })),
            label: signature.label,
            active_parameter: None,
        }
    });
    Ok(Some(SignatureHelp {
        signatures: signatures.collect(),
        active_signature: Some(0),
        active_parameter: Some(ActiveParameter::Int(found.argument)),
    }))
}
