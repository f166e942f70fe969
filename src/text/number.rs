//! Numbers as text, for messages and for code.

/// A share in percent, for a table. Only nothing is `0 %`, and only everything `100 %`.
pub fn percent(share: f64) -> String {
    percent_of(share, 1)
}

/// A share in percent, rounded for a sentence. Only nothing is `0 %`, and only everything `100 %`.
pub fn rounded_percent(share: f64) -> String {
    percent_of(share, 0)
}

fn percent_of(share: f64, decimals: usize) -> String {
    match share * 100.0 {
        0.0 => "0 %".to_string(),
        p if p < 0.01 => "< 0.01 %".to_string(),
        p if p < 1.0 => format!("{p:.2} %"),
        p if p < 10.0 => format!("{p:.1} %"),
        100.0 => "100 %".to_string(),
        p => format!(
            "{:.decimals$} %",
            p.min(100.0 - 0.1_f64.powi(decimals as i32))
        ),
    }
}

/// An integer with a comma between groups of three digits: `9,216`.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Infinity and NaN in words.
fn unusual(number: f64) -> Option<String> {
    let word = match number {
        f64::INFINITY => "infinity",
        f64::NEG_INFINITY => "-infinity",
        number if number.is_nan() => "NaN",
        _ => return None,
    };
    Some(word.to_string())
}

/// A number with at most so many decimals.
pub fn decimals(number: f64, most: usize) -> String {
    if let Some(word) = unusual(number) {
        return word;
    }
    let text = format!("{number:.most$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    let is_zero = text == "-0";
    text.get(usize::from(is_zero)..).unwrap_or("0").to_string()
}

/// The shortest decimal number that is this `float`.
pub fn shortest_decimal(number: f32) -> f64 {
    number.to_string().parse().unwrap_or(f64::from(number))
}

/// A time with up to three decimals.
pub fn seconds(time: f64) -> String {
    decimals(time, 3) + " s"
}

/// A float of GLSL with up to so many significant digits.
pub fn significant(number: f64, digits: i32) -> String {
    if let Some(word) = unusual(number) {
        return word;
    }
    if number == 0.0 || number.abs() < 1e-30 {
        return "0.0".to_string();
    }
    let decimals = digits - 1 - number.abs().log10().floor() as i32;
    if !(-8..=8).contains(&decimals) {
        let precision = usize::try_from(digits - 1).unwrap_or(0);
        let written = format!("{number:.precision$e}");
        let (digits, exponent) = written.split_once('e').unwrap_or((&written, "0"));
        let digits: f64 = digits.parse().unwrap_or(number);
        return format!("{digits:?}e{exponent}");
    }
    let scale = 10f64.powi(decimals);
    format!("{:?}", (number * scale).round() / scale)
}

/// A number in about four digits, for an image: `12K`.
pub fn short(number: f64) -> String {
    match number.abs() {
        n if n >= 1e7 => format!("{:.0}M", number / 1e6),
        n if n >= 1e4 => format!("{:.0}K", number / 1e3),
        n if n == n.trunc() => format!("{number:.0}"),
        n if n >= 10.0 => format!("{number:.1}"),
        n if n >= 0.01 => format!("{number:.3}"),
        _ => format!("{number:.6}"),
    }
}

/// A large count, rounded for a sentence: `1.5 thousand`.
pub fn rounded_count(count: f64) -> String {
    match count {
        n if n < 1e3 => format!("{n:.0}"),
        n if n < 1e6 => decimals(n / 1e3, 1) + " thousand",
        n if n < 1e9 => decimals(n / 1e6, 1) + " million",
        n => format!("{n:.1e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_percentages_are_not_printed_as_zero() {
        let shares = [0.0, 1e-7, 0.005, 0.05, 0.5, 0.9999, 1.0];
        let table = [
            "0 %", "< 0.01 %", "0.50 %", "5.0 %", "50.0 %", "99.9 %", "100 %",
        ];
        assert_eq!(shares.map(percent), table);
        let sentence = [
            "0 %", "< 0.01 %", "0.50 %", "5.0 %", "50 %", "99 %", "100 %",
        ];
        assert_eq!(shares.map(rounded_percent), sentence);
    }

    #[test]
    fn trailing_zeros_of_decimals_are_removed() {
        let all = [0.0, 2.0, 0.5, 10.0, 1.0 / 6.0].map(seconds);
        assert_eq!(all, ["0 s", "2 s", "0.5 s", "10 s", "0.167 s"]);
        assert_eq!(
            (decimals(-0.0001, 3), decimals(-1.0, 3)),
            ("0".into(), "-1".into())
        );
        assert_eq!(
            (decimals(100.0, 0), decimals(0.25, 1)),
            ("100".into(), "0.2".into())
        );
    }

    #[test]
    fn rounded_numbers_are_glsl_floats() {
        let all = [0.0, 0.1 + 0.2, 12345.678, -5.9604645e-8].map(|n| significant(n, 4));
        assert_eq!(all, ["0.0", "0.3", "12350.0", "-5.96e-8"]);
        assert_eq!(significant(2.0 / 3.0, 3), "0.667");
        let unusual = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        let words = ["infinity", "-infinity", "NaN"];
        assert_eq!(unusual.map(|n| significant(n, 4)), words);
        assert_eq!(unusual.map(|n| decimals(n, 4)), words);
    }

    #[test]
    fn counts_are_grouped_or_rounded() {
        assert_eq!(
            [0, 999, 9216, 1234567].map(grouped),
            ["0", "999", "9,216", "1,234,567"]
        );
        let rounded = [1.0, 1000.0, 1540.0, 2.5e6, 3e9].map(rounded_count);
        assert_eq!(
            rounded,
            ["1", "1 thousand", "1.5 thousand", "2.5 million", "3.0e9"]
        );
        assert_eq!([12.0, 0.5, 12345.0].map(short), ["12", "0.500", "12K"]);
    }
}
