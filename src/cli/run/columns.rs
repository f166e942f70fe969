//! Tables and numbers for people.

/// Rows as lines; in the first columns, so many of them, words begin below one another, in the others
/// numbers end there.
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

/// A time to a thousandth of a second.
pub fn seconds(time: f64) -> String {
    let text = format!("{time:.3}");
    format!("{} s", text.trim_end_matches('0').trim_end_matches('.'))
}

/// A share in percent; what is there is never told as none.
pub fn percent(share: f64) -> String {
    match share * 100.0 {
        0.0 => "0 %".to_string(),
        p if p < 0.01 => "under 0.01 %".to_string(),
        p if p < 1.0 => format!("{p:.2} %"),
        100.0 => "100 %".to_string(),
        p => format!("{:.1} %", p.min(99.9)),
    }
}
