//! Images and volumes that are embedded in a project.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use shaderlint_exec::{Image, ImageProblem, ImageShape, Texels};
use shaderlint_project::{Input, InputKind, VolumeHead, is_gray};
use std::sync::Arc;

/// A decoded image.
#[derive(Clone, PartialEq, Debug)]
pub struct Decoded {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Red, green, blue and alpha of each pixel, top row first.
    pub colors: Vec<[u8; 4]>,
}

/// Decodes an image file, or returns a message.
pub type Decode = fn(&[u8]) -> Result<Decoded, String>;

/// The images and volumes of a project, each decoded once.
pub(super) struct Stills<'p> {
    decode: Option<Decode>,
    made: Vec<(&'p Input, Arc<Image>)>,
}

impl<'p> Stills<'p> {
    pub fn new(decode: Option<Decode>) -> Stills<'p> {
        Stills {
            decode,
            made: Vec::new(),
        }
    }

    /// The image of an input, as the player uploads it.
    ///
    /// # Errors
    /// Why it cannot be decoded.
    pub fn get(&mut self, input: &'p Input) -> Result<Arc<Image>, String> {
        let is_alike = |other: &Input| {
            let facts = |i: &Input| (i.kind, i.sampler.vflip, i.sampler.has_mipmaps(), is_gray(i));
            facts(other) == facts(input) && other.urls == input.urls
        };
        if let Some((_, image)) = self.made.iter().find(|(made, _)| is_alike(made)) {
            return Ok(Arc::clone(image));
        }
        let image = self.read(input)?;
        let image = Arc::new(match input.sampler.has_mipmaps() {
            true => image.with_levels(),
            false => image,
        });
        self.made.push((input, Arc::clone(&image)));
        Ok(image)
    }

    fn read(&self, input: &Input) -> Result<Image, String> {
        let texels = |number: usize| -> Result<Decoded, String> {
            let url = input.urls.get(number).or(input.urls.first());
            let file = bytes(url.map_or("", String::as_str))?;
            let decode = self.decode.ok_or("image files are not supported here")?;
            let mut image = decode(&file)?;
            if input.sampler.vflip {
                flip(&mut image);
            }
            Ok(image)
        };
        let made = match input.kind {
            InputKind::Volume => {
                let first = input.urls.first();
                let (size, texels) = volume(&bytes(first.map_or("", String::as_str))?)?;
                Image::new(ImageShape::Volume, size, texels)
            }
            InputKind::Cubemap => {
                // Flipping swaps the top and bottom faces.
                let order = match input.sampler.vflip {
                    true => [0, 1, 3, 2, 4, 5],
                    false => [0, 1, 2, 3, 4, 5],
                };
                let mut side = [0; 2];
                let mut colors = Vec::new();
                for face in order {
                    let image = texels(face)?;
                    side = image.size;
                    colors.extend(image.colors);
                }
                let size = [side[0], side[1], 6];
                Image::new(ImageShape::Cube, size, Texels::Unorm8(colors))
            }
            InputKind::Texture => {
                let Decoded { size, mut colors } = texels(0)?;
                if is_gray(input) {
                    for [_, green, blue, opacity] in &mut colors {
                        (*green, *blue, *opacity) = (0, 0, 255);
                    }
                }
                let size = [size[0], size[1], 1];
                Image::new(ImageShape::Flat, size, Texels::Unorm8(colors))
            }
            _ => return Err("video and music files are not supported".to_string()),
        };
        made.map_err(|problem| match problem {
            ImageProblem::Size([width, height, _]) => {
                format!("texture size {width}x{height} is not supported")
            }
            ImageProblem::Count { .. } => "the data is incomplete".to_string(),
        })
    }
}

/// The bytes of a `data:` URL.
fn bytes(url: &str) -> Result<Vec<u8>, String> {
    let (head, text) = url.split_once(',').unwrap_or_default();
    if !head.starts_with("data:") || !head.ends_with(";base64") {
        return Err("expected a base64 `data:` URL".to_string());
    }
    let read = BASE64_STANDARD.decode(text.trim());
    read.map_err(|e| format!("invalid base64: {e}"))
}

/// Reverses the order of rows.
fn flip(image: &mut Decoded) {
    let width = image.size[0].max(1) as usize;
    let rows = image.colors.chunks(width).rev();
    image.colors = rows.flatten().copied().collect();
}

/// The size and texels of a ShaderToy volume file.
fn volume(file: &[u8]) -> Result<([u32; 3], Texels), String> {
    let wrong = "not a ShaderToy volume file";
    let head = VolumeHead::read(file).ok_or(wrong)?;
    let data = file.get(VolumeHead::LENGTH..).ok_or(wrong)?;
    let texels = data.chunks_exact(head.components * head.width);
    let made = match head.width {
        1 => Texels::Unorm8(texels.map(|texel| filled(texel, [0, 0, 0, 255])).collect()),
        _ => {
            let floats = |texel: &[u8]| -> Vec<f32> {
                let each = texel.chunks_exact(4).filter_map(|b| b.try_into().ok());
                each.map(f32::from_le_bytes).collect()
            };
            let texels = texels.map(|t| filled(&floats(t), [0.0, 0.0, 0.0, 1.0]));
            Texels::Float(texels.collect())
        }
    };
    Ok((head.size, made))
}

/// The components of a texel, with defaults for components that its format lacks.
fn filled<T: Copy>(texel: &[T], mut rest: [T; 4]) -> [T; 4] {
    for (component, given) in rest.iter_mut().zip(texel) {
        *component = *given;
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use shaderlint_exec::ImageShape;

    /// An image of one column whose colours are the bytes of the file.
    fn column(file: &[u8]) -> Result<Decoded, String> {
        let colors: Vec<[u8; 4]> = file.iter().map(|byte| [*byte; 4]).collect();
        Ok(Decoded {
            size: [1, colors.len() as u32],
            colors,
        })
    }

    fn input(kind: InputKind, files: &[&[u8]]) -> Input {
        let url = |file: &&[u8]| format!("data:image/png;base64,{}", BASE64_STANDARD.encode(file));
        let mut input = Input {
            urls: files.iter().map(url).collect(),
            ..Input::empty(0, kind)
        };
        input.sampler.filter = "nearest".to_string();
        input
    }

    fn check(input: &Input, shape: ImageShape, size: [u32; 3], texels: Texels) {
        let image = Image::new(shape, size, texels).unwrap();
        assert_eq!(Stills::new(Some(column)).get(input), Ok(Arc::new(image)));
    }

    #[test]
    fn rows_and_faces_are_flipped_as_in_the_player() {
        let bytes = |bytes: &[u8]| Texels::Unorm8(bytes.iter().map(|b| [*b; 4]).collect());
        let mut image = input(InputKind::Texture, &[&[1, 2, 3]]);
        for (vflip, rows) in [(true, [3, 2, 1]), (false, [1, 2, 3])] {
            image.sampler.vflip = vflip;
            check(&image, ImageShape::Flat, [1, 3, 1], bytes(&rows));
        }
        let faces: [&[u8]; 6] = [&[1], &[2], &[3], &[4], &[5], &[6]];
        let mut cube = input(InputKind::Cubemap, &faces);
        for (vflip, order) in [(true, [1, 2, 4, 3, 5, 6]), (false, [1, 2, 3, 4, 5, 6])] {
            cube.sampler.vflip = vflip;
            check(&cube, ImageShape::Cube, [1, 1, 6], bytes(&order));
        }
    }

    #[test]
    fn volumes_of_bytes_and_of_floats_are_read() {
        let head = |components: u8, format: u8| {
            let mut file = b"BIN\0\x01\0\0\0\x01\0\0\0\x02\0\0\0".to_vec();
            file.extend([components, 0, format, 0]);
            file
        };
        let mut file = head(1, 0);
        file.extend([7, 9]);
        let texels = Texels::Unorm8(vec![[7, 0, 0, 255], [9, 0, 0, 255]]);
        let volume = input(InputKind::Volume, &[&file]);
        check(&volume, ImageShape::Volume, [1, 1, 2], texels);
        let mut file = head(2, 10);
        for number in [0.5_f32, -2.0, 3.0, 0.0] {
            file.extend(number.to_le_bytes());
        }
        let texels = Texels::Float(vec![[0.5, -2.0, 0.0, 1.0], [3.0, 0.0, 0.0, 1.0]]);
        let volume = input(InputKind::Volume, &[&file]);
        check(&volume, ImageShape::Volume, [1, 1, 2], texels);
    }

    #[test]
    fn unreadable_media_are_reported() {
        let check = |input: &Input, why: &str| {
            assert_eq!(Stills::new(Some(column)).get(input).unwrap_err(), why);
        };
        let mut huge = b"BIN\0".to_vec();
        huge.extend([0xff; 12]);
        huge.extend([4, 0, 0, 0, 1, 2, 3, 4]);
        let volume = input(InputKind::Volume, &[&huge]);
        check(&volume, "not a ShaderToy volume file");
        let mut long = b"BIN\0\x28\x23\0\0\x01\0\0\0\x01\0\0\0\x01\0\0\0".to_vec();
        long.extend([0; 9000]);
        let volume = input(InputKind::Volume, &[&long]);
        check(&volume, "texture size 9000x1 is not supported");
        let short = input(InputKind::Volume, &[b"BIN\0"]);
        check(&short, "not a ShaderToy volume file");
        let faces: [&[u8]; 2] = [&[1], &[1, 2]];
        let cube = input(InputKind::Cubemap, &faces);
        check(&cube, "the data is incomplete");
        let mut address = input(InputKind::Texture, &[]);
        address.urls.push("media/a.png".to_string());
        check(&address, "expected a base64 `data:` URL");
        let image = input(InputKind::Texture, &[&[1]]);
        let none = Stills::new(None).get(&image);
        assert_eq!(none.unwrap_err(), "image files are not supported here");
    }
}
