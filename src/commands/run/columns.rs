//! Tables for people.

/// Formats rows as lines. The first `words` columns are left-aligned, the others right-aligned.
pub fn columns<const N: usize>(rows: &[[String; N]], words: usize) -> String {
    let mut widths = [0; N];
    for row in rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = cell.chars().count().max(*width);
        }
    }
    let mut text = String::new();
    for row in rows {
        let mut line = String::from(" ");
        for ((cell, width), column) in row.iter().zip(widths).zip(0..) {
            let cell = match column < words {
                true => format!(" {cell:width$} "),
                false => format!(" {cell:>width$} "),
            };
            line.push_str(&cell);
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}
