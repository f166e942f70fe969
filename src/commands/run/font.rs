//! A bitmap font of capital letters, digits and signs, three by five pixels.

use super::bitmap::Bitmap;

/// Distance between two characters at scale 1, in pixels.
const ADVANCE: u32 = 4;
/// Height of a character at scale 1, in pixels.
pub const HEIGHT: u32 = 5;

/// Lines of a character and its rows from the top, three bits each, left pixel in the highest bit.
const CHARACTERS: &str = include_str!("font.txt");

/// The rows of a character; none for one that the font lacks.
fn rows(character: char) -> impl Iterator<Item = u32> {
    let mut lines = CHARACTERS.lines();
    let found = lines.find_map(|line| line.strip_prefix(character));
    let digits = found.unwrap_or("").chars();
    digits.filter_map(|digit| digit.to_digit(8))
}

/// Width of a text in pixels.
pub fn width(text: &str, scale: u32) -> u32 {
    (text.chars().count() as u32 * ADVANCE).saturating_sub(1) * scale
}

/// Draws a text with its upper left corner at a position.
pub fn write(image: &mut Bitmap, text: &str, at: [u32; 2], scale: u32, color: [u8; 3]) {
    for (character, i) in text.chars().zip(0..) {
        for (row, y) in rows(character.to_ascii_uppercase()).zip(0..) {
            for x in (0..3).filter(|x| row >> (2 - x) & 1 == 1) {
                let left = at[0] + (i * ADVANCE + x) * scale;
                let dots = (0..scale).flat_map(|dy| (0..scale).map(move |dx| (dx, dy)));
                for (dx, dy) in dots {
                    image.set(left + dx, at[1] + y * scale + dy, color);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_drawn_as_pixels() {
        let mut image = Bitmap::filled([7, 5], [0; 3]);
        write(&mut image, "17", [0, 0], 1, [255; 3]);
        let row = |y| (0..7).map(move |x| (x, y));
        let text: Vec<String> = (0..5)
            .map(|y| {
                let lit = row(y).map(|(x, y)| image.pixel(x, y) == [255; 3]);
                lit.map(|is| if is { '#' } else { '.' }).collect()
            })
            .collect();
        assert_eq!(
            text,
            [".#..###", "##....#", ".#....#", ".#...#.", "###..#."]
        );
        assert_eq!(width("17", 2), 14);
    }
}
