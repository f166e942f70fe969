//! Findings from sampling, and how much is sampled.

use crate::scratch::Scratch;

/// An image that is almost black everywhere.
const BLACK: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
                     fragColor = vec4(0.01 * fract(fragCoord.x * 0.37), 0.0, 0.0, 1.0);\n}\n";

#[test]
fn run_samples_sets_the_number_of_pixels() {
    let scratch = Scratch::new(&[("a.glsl", BLACK)]);
    let reported = scratch.run(&["--run-samples", "2000", "a.glsl"]);
    assert_eq!(reported.code, 0);
    assert!(reported.out.contains("[dark-frame]"));
    assert!(
        reported.out.contains("sampled 1,968 pixels"),
        "{}",
        reported.out
    );
    let silent = scratch.run(&["--no-run", "a.glsl"]);
    assert!(
        silent.out.starts_with("All checks passed ("),
        "{}",
        silent.out
    );
    let both = scratch.run(&["--no-run", "--run-samples", "2000", "a.glsl"]);
    assert_eq!(both.code, 2);
}

#[test]
fn the_configuration_sets_the_number_of_samples() {
    let scratch = Scratch::new(&[("a.glsl", BLACK), ("silent.toml", "run_samples = 0\n")]);
    scratch.write("some.toml", "run_samples = 640\n");
    // The command line has priority over the file, so it must not mention sampling here.
    let run = |config: &str| {
        let mut command = std::process::Command::new(insta_cmd::get_cargo_bin("shaderlint"));
        let command = command.current_dir(scratch.path("")).env("NO_COLOR", "1");
        let done = command
            .args(["--config", config, "a.glsl"])
            .output()
            .unwrap();
        String::from_utf8(done.stdout).unwrap()
    };
    assert!(run("silent.toml").starts_with("All checks passed ("));
    let reported = run("some.toml");
    assert!(reported.contains("sampled 640 pixels"), "{reported}");
}

/// A possible problem that sampling never observes is not a warning; one that it observes is
/// reported with the evidence.
#[test]
fn sampling_confirms_or_dismisses_possible_problems() {
    let suspect = |offset: &str| {
        format!(
            "void mainImage(out vec4 fragColor, in vec2 fragCoord) {{\n    \
             vec2 uv = fragCoord / iResolution.xy;\n    \
             float x = sin(floor(uv.x * 4.0) * 6.2831853 + 0.5{offset});\n    \
             fragColor = vec4(uv, sqrt(x), 1.0);\n}}\n"
        )
    };
    let scratch = Scratch::new(&[
        ("never.glsl", &suspect("")),
        ("met.glsl", &suspect(" - 1.5")),
    ]);
    let never = scratch.run(&[
        "--run-samples",
        "9216",
        "--only",
        "sqrt-negative",
        "never.glsl",
    ]);
    assert!(
        never.out.starts_with("info[sqrt-negative]"),
        "{}",
        never.out
    );
    assert!(
        never
            .out
            .contains("did not occur in 9,216 sampled evaluations"),
        "{}",
        never.out
    );
    let met = scratch.run(&[
        "--run-samples",
        "9216",
        "--only",
        "sqrt-negative",
        "met.glsl",
    ]);
    assert!(met.out.starts_with("warning[sqrt-negative]"), "{}", met.out);
    assert!(met.out.contains("= occurred in "), "{}", met.out);
}
