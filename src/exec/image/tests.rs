//! Tests of texture lookups; the expected values were compared with Chromium.

use super::lookup::{fetch, lookup, size_of};
use super::*;
use crate::row::LANES;

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

/// The red component in the first lane, times 255; all lanes have the same coordinates.
fn red(texture: &Texture, at: &[f32], level: LevelOf<'_>, offset: [i32; 3]) -> f32 {
    let coordinates: Vec<_> = at.iter().map(|part| [*part; LANES]).collect();
    let found = lookup(
        texture,
        &TextureLookup {
            coordinates: &coordinates,
            reference: None,
            level,
            offset,
        },
        1,
    );
    f32::from_bits(found[0][0]) * 255.0
}

const HERE: LevelOf<'_> = LevelOf::Implicit { bias: None };

#[track_caller]
fn check(texture: &Texture, at: &[f32], expected: f32) {
    let found = red(texture, at, HERE, [0; 3]);
    assert!(
        (found - expected).abs() < 1e-3,
        "{found} instead of {expected}"
    );
}

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

#[test]
fn nearest_takes_a_texel_and_linear_interpolates() {
    let image = || gray(ImageShape::Flat, [4, 1, 1], &[0, 100, 200, 40]);
    let nearest = texture(image(), Filter::Nearest, Wrap::Clamp);
    check(&nearest, &[0.3, 0.5], 100.0);
    let linear = texture(image(), Filter::Linear, Wrap::Clamp);
    check(&linear, &[0.5, 0.5], 150.0);
    check(&linear, &[0.375, 0.5], 100.0);
    check(&linear, &[0.4375, 0.5], 125.0);
}

#[test]
fn the_wrap_mode_applies_outside_of_the_image() {
    let check_operands = |wrap, at, expected| {
        let image = gray(ImageShape::Flat, [4, 1, 1], &[0, 100, 200, 40]);
        check(&texture(image, Filter::Linear, wrap), &[at, 0.5], expected);
    };
    check_operands(Wrap::Clamp, -3.0, 0.0);
    check_operands(Wrap::Clamp, 1e30, 40.0);
    check_operands(Wrap::Repeat, 0.0, 20.0);
    check_operands(Wrap::Repeat, 7.375, 100.0);
    check_operands(Wrap::Repeat, -0.625, 100.0);
    check_operands(Wrap::Mirror, 1.125, 40.0);
    check_operands(Wrap::Mirror, -0.375, 100.0);
    check_operands(Wrap::Mirror, 2.375, 100.0);
}

#[test]
fn no_coordinate_reads_outside_of_the_image() {
    for wrap in [Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
        for at in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -1e-30] {
            let image = gray(ImageShape::Flat, [3, 1, 1], &[50; 3]);
            check(&texture(image, Filter::Linear, wrap), &[at, at], 50.0);
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
fn cube_maps_are_filtered_across_faces() {
    let texels: Vec<u8> = (0..6).flat_map(|face| [face * 40; 4]).collect();
    let cube = || gray(ImageShape::Cube, [2, 2, 6], &texels);
    let linear = texture(cube(), Filter::Linear, Wrap::Repeat);
    let axes = [
        ([1.0, 0.0, 0.0], 0.0),
        ([-1.0, 0.0, 0.0], 40.0),
        ([0.0, 1.0, 0.0], 80.0),
        ([0.0, -1.0, 0.0], 120.0),
        ([0.0, 0.0, 1.0], 160.0),
        ([0.0, 0.0, -1.0], 200.0),
    ];
    for (axis, expected) in axes {
        check(&linear, &axis, expected);
    }
    // At an edge the two faces contribute a half each, at a corner the three faces a third each.
    check(&linear, &[1.0, 1.0, 0.0], 40.0);
    check(&linear, &[0.0, -1.0, 1.0], 140.0);
    check(&linear, &[1.0, 1.0, 1.0], 80.0);
}

#[test]
fn volumes_and_layers_have_a_third_coordinate() {
    let slices = [0, 60, 120];
    let volume = texture(
        gray(ImageShape::Volume, [1, 1, 3], &slices),
        Filter::Linear,
        Wrap::Clamp,
    );
    check(&volume, &[0.5, 0.5, 1.0 / 3.0], 30.0);
    let layers = texture(
        gray(ImageShape::Layers, [1, 1, 3], &slices),
        Filter::Linear,
        Wrap::Clamp,
    );
    check(&layers, &[0.5, 0.5, 1.4], 60.0);
    check(&layers, &[0.5, 0.5, 7.0], 120.0);
    check(&layers, &[0.5, 0.5, -7.0], 0.0);
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
    let image = Image::new(
        ImageShape::Flat,
        [2, 1, 1],
        Texels::Int(vec![[-7, 0, 0, 1], [9, 0, 0, 1]]),
    )
    .unwrap();
    let given = TextureLookup {
        coordinates: &[[0.7; LANES], [0.5; LANES]],
        reference: None,
        level: LevelOf::Implicit { bias: None },
        offset: [0; 3],
    };
    let first = |found: [[u32; LANES]; 4]| found.map(|row| row[0] as i32);
    let nearest = texture(image.clone(), Filter::Nearest, Wrap::Clamp);
    assert_eq!(first(lookup(&nearest, &given, 1)), [9, 0, 0, 1]);
    let linear = texture(image, Filter::Linear, Wrap::Clamp);
    assert_eq!(first(lookup(&linear, &given, 1)), [0, 0, 0, 1]);
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
    let given = TextureLookup {
        coordinates: &[[0.5; LANES]; 3],
        reference: None,
        level: LevelOf::Implicit { bias: None },
        offset: [0; 3],
    };
    let found = lookup(&texture, &given, 1);
    assert_eq!(
        found.map(|row| f32::from_bits(row[0])),
        [0.0, 0.0, 0.0, 1.0]
    );
}
