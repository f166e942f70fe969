//! A bitmap font of capital letters, digits and signs, three by five pixels.

use super::bitmap::Bitmap;

/// Distance between two characters at scale 1, in pixels.
const ADVANCE: u32 = 4;
/// Height of a character at scale 1, in pixels.
pub const HEIGHT: u32 = 5;

/// The rows of a character from the top, three bits each, left pixel in the highest bit.
const fn rows(character: char) -> [u8; 5] {
    match character {
        '0' => [7, 5, 5, 5, 7],
        '1' => [2, 6, 2, 2, 7],
        '2' => [7, 1, 7, 4, 7],
        '3' => [7, 1, 3, 1, 7],
        '4' => [5, 5, 7, 1, 1],
        '5' => [7, 4, 7, 1, 7],
        '6' => [7, 4, 7, 5, 7],
        '7' => [7, 1, 1, 2, 2],
        '8' => [7, 5, 7, 5, 7],
        '9' => [7, 5, 7, 1, 7],
        'A' => [2, 5, 7, 5, 5],
        'B' => [6, 5, 6, 5, 6],
        'C' => [3, 4, 4, 4, 3],
        'D' => [6, 5, 5, 5, 6],
        'E' => [7, 4, 6, 4, 7],
        'F' => [7, 4, 6, 4, 4],
        'G' => [3, 4, 5, 5, 3],
        'H' => [5, 5, 7, 5, 5],
        'I' => [7, 2, 2, 2, 7],
        'J' => [1, 1, 1, 5, 2],
        'K' => [5, 5, 6, 5, 5],
        'L' => [4, 4, 4, 4, 7],
        'M' => [5, 7, 7, 5, 5],
        'N' => [6, 5, 5, 5, 5],
        'O' => [2, 5, 5, 5, 2],
        'P' => [6, 5, 6, 4, 4],
        'Q' => [2, 5, 5, 6, 3],
        'R' => [6, 5, 6, 5, 5],
        'S' => [3, 4, 2, 1, 6],
        'T' => [7, 2, 2, 2, 2],
        'U' => [5, 5, 5, 5, 7],
        'V' => [5, 5, 5, 5, 2],
        'W' => [5, 5, 7, 7, 5],
        'X' => [5, 5, 2, 5, 5],
        'Y' => [5, 5, 2, 2, 2],
        'Z' => [7, 1, 2, 4, 7],
        '.' => [0, 0, 0, 0, 2],
        ',' => [0, 0, 0, 2, 4],
        '>' => [4, 2, 1, 2, 4],
        ':' => [0, 2, 0, 2, 0],
        '-' => [0, 0, 7, 0, 0],
        '%' => [5, 1, 2, 4, 5],
        '/' => [1, 1, 2, 4, 4],
        '_' => [0, 0, 0, 0, 7],
        _ => [0; 5],
    }
}

/// Width of a text in pixels.
pub fn width(text: &str, scale: u32) -> u32 {
    (text.chars().count() as u32 * ADVANCE).saturating_sub(1) * scale
}

/// Draws a text with its upper left corner at a position.
pub fn write(image: &mut Bitmap, text: &str, at: [u32; 2], scale: u32, color: [u8; 3]) {
    for (character, i) in text.chars().zip(0..) {
        for (row, y) in rows(character.to_ascii_uppercase()).into_iter().zip(0..) {
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
