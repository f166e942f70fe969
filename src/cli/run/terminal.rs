//! Draws images in a terminal: two pixels per character, in the colours of the terminal.

use crate::commands::run::Bitmap;
use std::fmt::Write;

/// The colours that a terminal supports.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Palette {
    /// 24-bit colours.
    True,
    /// 256 colours: a cube of 216, and greys.
    Indexed,
    /// 16 colours: eight normal and eight bright.
    Sixteen,
    /// None: characters show the brightness.
    Mono,
}

impl Palette {
    /// The palette that the environment variables declare.
    pub fn of(variable: impl Fn(&str) -> Option<String>) -> Palette {
        let term = variable("TERM").unwrap_or_default();
        let color = variable("COLORTERM").unwrap_or_default();
        let is_true = ["truecolor", "24bit"].contains(&color.as_str());
        match () {
            () if is_true || term.ends_with("-direct") => Palette::True,
            () if term.contains("256") => Palette::Indexed,
            () if term.is_empty() || term == "dumb" => Palette::Mono,
            () => Palette::Sixteen,
        }
    }

    /// The note about an image that is drawn in fewer colours.
    pub const fn note(self) -> Option<&'static str> {
        match self {
            Palette::True => None,
            Palette::Indexed => {
                Some("using 256 colours, as TERM declares; set COLORTERM=truecolor for all colours")
            }
            Palette::Sixteen => {
                Some("using 16 colours, as TERM declares; set COLORTERM=truecolor for all colours")
            }
            Palette::Mono => Some("drawing without colours; use -o OUT.png to write the image"),
        }
    }
}

/// The size of an image that fits into a terminal. A character is two pixels high.
pub fn fit(size: [u32; 2], columns: u32, lines: u32) -> [u32; 2] {
    let [width, height] = size.map(|n| f64::from(n.max(1)));
    let most = [f64::from(columns.max(1)), f64::from(2 * lines.max(1))];
    let scale = (most[0] / width).min(most[1] / height).min(1.0);
    [width, height].map(|side| ((side * scale).round() as u32).max(1))
}

/// The image as text with escape sequences.
pub fn draw(image: &Bitmap, palette: Palette) -> String {
    let mut text = String::new();
    let [width, height] = image.size;
    for row in 0..height.div_ceil(2) {
        let (above, below) = (2 * row, 2 * row + 1);
        let mut last = None;
        for x in 0..width {
            let upper = image.pixel(x, above);
            let lower = (below < height).then(|| image.pixel(x, below));
            if palette == Palette::Mono {
                text.push(shade(upper, lower.unwrap_or(upper)));
                continue;
            }
            let colors = (upper, lower);
            if last != Some(colors) {
                text.push_str("\x1b[");
                paint(&mut text, upper, palette, Ground::Front);
                match lower {
                    Some(lower) => {
                        text.push(';');
                        paint(&mut text, lower, palette, Ground::Back);
                    }
                    None => text.push_str(";49"),
                }
                text.push('m');
                last = Some(colors);
            }
            text.push('▀');
        }
        if palette != Palette::Mono {
            text.push_str("\x1b[0m");
        }
        text.push('\n');
    }
    text
}

/// Foreground or background colour.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ground {
    Front,
    Back,
}

/// Writes the escape sequence of a colour.
fn paint(text: &mut String, color: [u8; 3], palette: Palette, ground: Ground) {
    let [r, g, b] = color;
    let is_back = ground == Ground::Back;
    let extended = if is_back { 48 } else { 38 };
    // Writing to a string never fails.
    let _ = match palette {
        Palette::True => write!(text, "{extended};2;{r};{g};{b}"),
        Palette::Indexed => write!(text, "{extended};5;{}", indexed(color)),
        Palette::Sixteen | Palette::Mono => {
            let number = sixteen(color);
            let first = if number < 8 { 30 } else { 82 };
            write!(text, "{}", first + number + if is_back { 10 } else { 0 })
        }
    };
}

/// The nearest of the 256 colours: the cube starts at 16, the greys at 232.
fn indexed(color: [u8; 3]) -> u32 {
    const STEPS: [u8; 6] = [0, 95, 135, 175, 215, 255];
    let step = |lane: u8| {
        let steps = STEPS.iter().zip(0_u32..);
        steps
            .min_by_key(|(s, _)| s.abs_diff(lane))
            .map_or((0, 0), |(s, i)| (*s, i))
    };
    let [r, g, b] = color.map(step);
    let mean = color.iter().map(|lane| u32::from(*lane)).sum::<u32>() / 3;
    let gray = (mean.saturating_sub(3) / 10).min(23);
    let grays = [(8 + 10 * gray) as u8; 3];
    match distance(color, grays) < distance(color, [r.0, g.0, b.0]) {
        true => 232 + gray,
        false => 16 + 36 * r.1 + 6 * g.1 + b.1,
    }
}

/// The nearest of the 16 colours, as most terminals show them.
fn sixteen(color: [u8; 3]) -> u32 {
    let shown = |n: u32| match n {
        7 => [192; 3],
        8 => [128; 3],
        _ => {
            let level = if n < 8 { 128 } else { 255 };
            [0, 1, 2].map(|bit| if n >> bit & 1 == 1 { level } else { 0 })
        }
    };
    (0..16)
        .min_by_key(|n| distance(color, shown(*n)))
        .unwrap_or(0)
}

fn distance(a: [u8; 3], b: [u8; 3]) -> u32 {
    let lanes = a.iter().zip(&b);
    lanes.map(|(a, b)| u32::from(a.abs_diff(*b)).pow(2)).sum()
}

/// A character with the brightness of two pixels.
fn shade(upper: [u8; 3], lower: [u8; 3]) -> char {
    const SHADES: [char; 10] = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];
    let light = |[r, g, b]: [u8; 3]| 2 * u32::from(r) + 7 * u32::from(g) + u32::from(b);
    let mean = (light(upper) + light(lower)) / 2;
    let at = mean * SHADES.len() as u32 / (10 * 255 + 1);
    SHADES.get(at as usize).copied().unwrap_or(' ')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bitmap(pixels: &[[u8; 3]], width: u32) -> Bitmap {
        Bitmap {
            size: [width, pixels.len() as u32 / width],
            bytes: pixels.concat(),
        }
    }

    #[test]
    fn one_character_shows_two_pixels() {
        let two = bitmap(&[[1, 2, 3], [1, 2, 3], [4, 5, 6], [4, 5, 6]], 2);
        let text = draw(&two, Palette::True);
        assert_eq!(text, "\x1b[38;2;1;2;3;48;2;4;5;6m▀▀\x1b[0m\n");
        let one = bitmap(&[[255, 0, 0]], 1);
        assert_eq!(draw(&one, Palette::True), "\x1b[38;2;255;0;0;49m▀\x1b[0m\n");
        assert_eq!(draw(&one, Palette::Indexed), "\x1b[38;5;196;49m▀\x1b[0m\n");
        assert_eq!(draw(&one, Palette::Sixteen), "\x1b[91;49m▀\x1b[0m\n");
    }

    #[test]
    fn terminals_without_colours_show_brightness() {
        let ramp = bitmap(&[[0; 3], [127; 3], [255; 3], [0; 3], [127; 3], [255; 3]], 3);
        assert_eq!(draw(&ramp, Palette::Mono), " =@\n");
    }

    #[test]
    fn environment_variables_select_the_palette() {
        let with = |all: &'static [(&'static str, &'static str)]| {
            Palette::of(move |name| {
                let found = all.iter().find(|(n, _)| *n == name);
                found.map(|(_, v)| v.to_string())
            })
        };
        const TRUE: &[(&str, &str)] = &[("TERM", "xterm-256color"), ("COLORTERM", "truecolor")];
        assert_eq!(with(TRUE), Palette::True);
        assert_eq!(with(&[("TERM", "xterm-256color")]), Palette::Indexed);
        assert_eq!(with(&[("TERM", "linux")]), Palette::Sixteen);
        assert_eq!(with(&[("TERM", "dumb")]), Palette::Mono);
        assert_eq!(with(&[]), Palette::Mono);
    }

    #[test]
    fn images_are_shrunk_to_fit_and_never_enlarged() {
        assert_eq!(fit([640, 360], 80, 40), [80, 45]);
        assert_eq!(fit([640, 360], 200, 20), [71, 40]);
        assert_eq!(fit([1, 1], 80, 40), [1, 1]);
        assert_eq!(fit([1000, 1], 10, 10), [10, 1]);
    }
}
