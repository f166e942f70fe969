//! Edits that create files.

use gen_lsp_types::*;

/// The changes that create a file.
pub fn new_file(uri: Uri, text: String) -> Vec<DocumentChange> {
    let identifier = OptionalVersionedTextDocumentIdentifier {
        version: None,
        text_document_identifier: TextDocumentIdentifier { uri: uri.clone() },
    };
    let content = TextEdit {
        range: Range::default(),
        new_text: text,
    };
    vec![
        DocumentChange::CreateFile(CreateFile {
            uri,
            options: None,
            annotation_id: None,
        }),
        DocumentChange::TextDocumentEdit(TextDocumentEdit::new(
            identifier,
            vec![Edit::TextEdit(content)],
        )),
    ]
}
