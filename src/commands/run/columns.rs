//! Tables and numbers for people.

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

/// Formats a time with up to three decimals.
pub fn seconds(time: f64) -> String {
    let text = format!("{time:.3}");
    format!("{} s", text.trim_end_matches('0').trim_end_matches('.'))
}

/// Formats a share as a percentage. Shares above 0 are never shown as 0 %.
pub fn percent(share: f64) -> String {
    match share * 100.0 {
        0.0 => "0 %".to_string(),
        p if p < 0.01 => "under 0.01 %".to_string(),
        p if p < 1.0 => format!("{p:.2} %"),
        100.0 => "100 %".to_string(),
        p => format!("{:.1} %", p.min(99.9)),
    }
}
