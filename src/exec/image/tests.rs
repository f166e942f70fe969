//! Tests of texture lookups; the expected values were compared with Chromium.

use super::lookup::{fetch, lookup, size_of};
use super::*;
use crate::row::LANES;
use shaderlint_text::each_case;

/// A grey image with these texel values, of 255.
fn gray(shape: ImageShape, size: [u32; 3], texels: &[u8]) -> Image {
    let texels = texels.iter().map(|gray| [*gray, 0, 0, 255]).collect();
    Image::new(shape, size, Texels::Unorm8(texels)).unwrap()
}

fn texture(image: Image, filter: Filter, wrap: Wrap) -> Texture {
    Texture {
        image: Arc::new(image),
        sampling: Sampling {
            filter,
            wrap: [wrap; 3],
        },
    }
}

/// What a lookup with the same coordinates in all lanes finds in the first lane.
fn first(texture: &Texture, at: &[f32], level: LevelOf<'_>, offset: [i32; 3]) -> [u32; 4] {
    let coordinates: Vec<_> = at.iter().map(|part| [*part; LANES]).collect();
    let given = TextureLookup {
        coordinates: &coordinates,
        reference: None,
        level,
        offset,
    };
    lookup(texture, &given, 1).map(|row| row[0])
}

/// The red component in the first lane, times 255; all lanes have the same coordinates.
fn red(texture: &Texture, at: &[f32], level: LevelOf<'_>, offset: [i32; 3]) -> f32 {
    f32::from_bits(first(texture, at, level, offset)[0]) * 255.0
}

const HERE: LevelOf<'_> = LevelOf::Implicit { bias: None };

#[test]
fn images_with_a_wrong_number_of_texels_are_refused() {
    let texels = |count| Texels::Unorm8(vec![[0; 4]; count]);
    let refused = Image::new(ImageShape::Flat, [2, 2, 1], texels(3));
    assert_eq!(
        refused,
        Err(ImageProblem::Count {
            expected: 4,
            given: 3
        })
    );
    let sizes = [
        (ImageShape::Flat, [0, 1, 1]),
        (ImageShape::Flat, [2, 2, 2]),
        (ImageShape::Cube, [2, 3, 6]),
        (ImageShape::Cube, [2, 2, 1]),
        (ImageShape::Layers, [9000, 1, 1]),
    ];
    for (shape, size) in sizes {
        let refused = Image::new(shape, size, texels(1));
        assert_eq!(refused, Err(ImageProblem::Size(size)));
    }
}

/// Each case is an image with its texels, a sampler, coordinates, and what is found there.
#[test]
fn lookups_read_the_texels_of_an_image() {
    each_case(include_str!("lookups.txt"), |given, expected| {
        let [image, sampler, at] = given.split(" ‖ ").collect::<Vec<_>>()[..] else {
            panic!("{given}");
        };
        let numbers = |text: &str| -> Vec<f32> {
            let words = text.split(' ');
            words.map(|word| word.parse().expect(given)).collect()
        };
        let ((shape, size), texels) = image
            .split_once(": ")
            .and_then(|(head, texels)| Some((head.split_once(' ')?, texels)))
            .expect(given);
        let shape = match shape {
            "flat" => ImageShape::Flat,
            "cube" => ImageShape::Cube,
            "volume" => ImageShape::Volume,
            _ => ImageShape::Layers,
        };
        let size: Vec<u32> = numbers(size).iter().map(|n| *n as u32).collect();
        let texels: Vec<u8> = numbers(texels).iter().map(|n| *n as u8).collect();
        let (filter, wrap) = sampler.split_once(' ').unwrap();
        let filter = match filter {
            "nearest" => Filter::Nearest,
            "linear" => Filter::Linear,
            _ => panic!("{given}"),
        };
        let wrap = match wrap {
            "clamp" => Wrap::Clamp,
            "repeat" => Wrap::Repeat,
            _ => Wrap::Mirror,
        };
        let image = gray(shape, [size[0], size[1], size[2]], &texels);
        let found = red(&texture(image, filter, wrap), &numbers(at), HERE, [0; 3]);
        let expected: f32 = expected.parse().expect(given);
        assert!((found - expected).abs() < 1e-3, "{found}: {given}");
    });
}

#[test]
fn no_coordinate_reads_outside_of_the_image() {
    for wrap in [Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
        for at in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -1e-30] {
            let image = gray(ImageShape::Flat, [3, 1, 1], &[50; 3]);
            let found = red(
                &texture(image, Filter::Linear, wrap),
                &[at; 2],
                HERE,
                [0; 3],
            );
            assert!((found - 50.0).abs() < 1e-3, "{found} at {at}");
        }
        let cube = gray(ImageShape::Cube, [3, 3, 6], &[50; 54]);
        for at in [f32::NAN, f32::INFINITY, 0.0] {
            let found = red(
                &texture(cube.clone(), Filter::Nearest, wrap),
                &[at; 3],
                HERE,
                [0; 3],
            );
            assert_eq!(found, 50.0);
        }
    }
}

#[test]
fn texture_offsets_are_in_texels_of_the_level() {
    let image = gray(ImageShape::Flat, [4, 1, 1], &[0, 100, 200, 40]);
    let texture = texture(image, Filter::Nearest, Wrap::Repeat);
    assert_eq!(red(&texture, &[0.1, 0.5], HERE, [-1, 0, 0]).round(), 40.0);
    assert_eq!(red(&texture, &[0.1, 0.5], HERE, [6, 0, 0]).round(), 200.0);
}

#[test]
fn mipmap_levels_are_averages_rounded_half_to_even() {
    let image = gray(ImageShape::Flat, [4, 2, 1], &[0, 1, 10, 20, 0, 1, 30, 42]).with_levels();
    let red = |level: usize| match image.level(level) {
        Some(Texels::Unorm8(texels)) => texels.iter().map(|texel| texel[0]).collect(),
        _ => Vec::new(),
    };
    // 0.5 and 25.5, rounded to even.
    assert_eq!(red(1), [0, 26]);
    assert_eq!(red(2), [13]);
    assert_eq!(image.level(3), None);
    let odd = gray(ImageShape::Flat, [5, 1, 1], &[0, 100, 200, 100, 0]).with_levels();
    let Some(Texels::Unorm8(texels)) = odd.level(1) else {
        panic!("there is a level")
    };
    // Interpolated between texels 0 and 1, and 3 and 4: at the centre of each half.
    assert_eq!([texels[0][0], texels[1][0]], [75, 75]);
}

#[test]
fn the_implicit_level_follows_the_derivatives_of_the_quad() {
    let image = gray(ImageShape::Flat, [4, 1, 1], &[0, 100, 200, 40]).with_levels();
    let texture = texture(image, Filter::Mipmap, Wrap::Repeat);
    let mut across = [0.125; LANES];
    for lane in (1..LANES).step_by(2) {
        across[lane] = 0.125 + 1.0;
    }
    let coordinates = [across, [0.5; LANES]];
    let given = TextureLookup {
        coordinates: &coordinates,
        reference: None,
        level: LevelOf::Implicit { bias: None },
        offset: [0; 3],
    };
    // Four texels wide: the smallest level.
    let found = lookup(&texture, &given, u32::MAX);
    assert!(
        found[0]
            .iter()
            .all(|bits| f32::from_bits(*bits) * 255.0 == 85.0)
    );
    let sharper = [-2.0; LANES];
    let biased = TextureLookup {
        level: LevelOf::Implicit {
            bias: Some(&sharper),
        },
        ..given
    };
    assert_eq!(f32::from_bits(lookup(&texture, &biased, 1)[0][0]), 0.0);
}

#[test]
fn explicit_levels_and_gradients_select_the_level() {
    let image = gray(ImageShape::Flat, [4, 1, 1], &[0, 100, 200, 40]).with_levels();
    let texture = texture(image, Filter::Mipmap, Wrap::Clamp);
    let of = |level| red(&texture, &[0.125, 0.5], level, [0; 3]).round();
    assert_eq!(of(LevelOf::Explicit(&[0.0; LANES])), 0.0);
    assert_eq!(of(LevelOf::Explicit(&[0.5; LANES])), 25.0);
    assert_eq!(of(LevelOf::Explicit(&[9.0; LANES])), 85.0);
    let (still, wide) = ([[0.0; LANES]; 2], [[0.5; LANES], [0.0; LANES]]);
    assert_eq!(
        of(LevelOf::Gradient {
            x: &still,
            y: &wide
        }),
        50.0
    );
    assert_eq!(
        of(LevelOf::Gradient {
            x: &wide,
            y: &still
        }),
        50.0
    );
}

#[test]
fn depths_are_compared_before_they_are_filtered() {
    let depths = vec![[0.2, 0.0, 0.0, 1.0], [0.6, 0.0, 0.0, 1.0]];
    let image = Image::new(ImageShape::Flat, [2, 1, 1], Texels::Float(depths)).unwrap();
    let texture = texture(image, Filter::Linear, Wrap::Clamp);
    let given = |reference| {
        let found = lookup(
            &texture,
            &TextureLookup {
                coordinates: &[[0.5; LANES]; 2],
                reference: Some(&[reference; LANES]),
                level: LevelOf::Implicit { bias: None },
                offset: [0; 3],
            },
            1,
        );
        f32::from_bits(found[0][0])
    };
    assert_eq!([0.1, 0.4, 0.6, 0.7].map(given), [1.0, 0.5, 0.5, 0.0]);
}

#[test]
fn integer_textures_are_not_filtered() {
    let texels = Texels::Int(vec![[-7, 0, 0, 1], [9, 0, 0, 1]]);
    let image = Image::new(ImageShape::Flat, [2, 1, 1], texels).unwrap();
    let of = |image, filter| {
        let texture = texture(image, filter, Wrap::Clamp);
        first(&texture, &[0.7, 0.5], HERE, [0; 3]).map(|bits| bits as i32)
    };
    assert_eq!(of(image.clone(), Filter::Nearest), [9, 0, 0, 1]);
    assert_eq!(of(image, Filter::Linear), [0, 0, 0, 1]);
}

#[test]
fn textures_with_missing_mipmaps_read_black() {
    let image = gray(ImageShape::Flat, [2, 2, 1], &[9; 4]);
    let texture = texture(image, Filter::Mipmap, Wrap::Clamp);
    assert_eq!(red(&texture, &[0.5, 0.5], HERE, [0; 3]), 0.0);
}

#[test]
fn texel_fetches_read_one_texel() {
    let image = gray(ImageShape::Flat, [4, 2, 1], &[1, 2, 3, 4, 5, 6, 7, 8]).with_levels();
    let texture = texture(image, Filter::Mipmap, Wrap::Repeat);
    let texel = |at: [i32; 2], level, offset| {
        let found = fetch(
            &texture,
            &at.map(|part| [part; LANES]),
            &[level; LANES],
            offset,
            1,
        );
        let [red, _, _, alpha] = found.map(|row| f32::from_bits(row[0]) * 255.0);
        [red.round(), alpha]
    };
    assert_eq!(texel([3, 1], 0, [0; 3]), [8.0, 255.0]);
    assert_eq!(texel([3, 1], 0, [-1, -1, 0]), [3.0, 255.0]);
    assert_eq!(texel([1, 0], 1, [0; 3]), [6.0, 255.0]);
    assert_eq!(texel([4, 1], 0, [0; 3]), [0.0, 0.0]);
    assert_eq!(texel([0, -1], 0, [0; 3]), [0.0, 0.0]);
    let sizes = size_of(&texture, &[1; LANES]).map(|row| row[0]);
    assert_eq!(sizes, [2, 1, 1]);
}

#[test]
fn only_requested_lanes_are_looked_up() {
    let image = gray(ImageShape::Flat, [1, 1, 1], &[255]);
    let texture = texture(image, Filter::Nearest, Wrap::Clamp);
    let given = TextureLookup {
        coordinates: &[[0.5; LANES]; 2],
        reference: None,
        level: LevelOf::Implicit { bias: None },
        offset: [0; 3],
    };
    let [red, ..] = lookup(&texture, &given, 1 << 31 | 1);
    let set: Vec<_> = red.iter().map(|bits| u32::from(*bits != 0)).collect();
    assert_eq!(set.iter().sum::<u32>(), 2);
    assert_eq!([red[0], red[31]], [1.0_f32.to_bits(); 2]);
}

#[test]
fn samplers_without_textures_read_black() {
    let texture = Texture::unbound(Sampler::SamplerCube);
    assert!(texture.fits(Sampler::SamplerCube));
    assert!(!texture.fits(Sampler::Sampler2D));
    assert!(Texture::unbound(Sampler::Usampler3D).fits(Sampler::Usampler3D));
    let found = first(&texture, &[0.5; 3], HERE, [0; 3]);
    assert_eq!(found.map(f32::from_bits), [0.0, 0.0, 0.0, 1.0]);
}
