//! What is found by running a shader, and how much of it is run.

use super::scratch::Scratch;

/// A picture that is as good as black wherever it is looked at.
const BLACK: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
                     fragColor = vec4(0.01 * fract(fragCoord.x * 0.37), 0.0, 0.0, 1.0);\n}\n";

#[test]
fn so_many_pixels_are_run_as_are_asked_for() {
    let scratch = Scratch::new(&[("a.glsl", BLACK)]);
    let told = scratch.run(&["--run-samples", "2000", "a.glsl"]);
    assert_eq!(told.code, 0);
    assert!(told.out.contains("[dark-frame]"));
    assert!(
        told.out.contains("seen in a run of 1920 pixels"),
        "{}",
        told.out
    );
    let silent = scratch.run(&["--no-run", "a.glsl"]);
    assert!(silent.out.ends_with(", no findings\n"), "{}", silent.out);
    let both = scratch.run(&["--no-run", "--run-samples", "2000", "a.glsl"]);
    assert_eq!(both.code, 2);
}

#[test]
fn the_configuration_says_how_much_is_run() {
    let scratch = Scratch::new(&[("a.glsl", BLACK), ("silent.toml", "run_samples = 0\n")]);
    scratch.write("some.toml", "run_samples = 640\n");
    // The command line goes before the file, so that it must not speak of runs here.
    let run = |config: &str| {
        let mut command = std::process::Command::new(insta_cmd::get_cargo_bin("shaderlint"));
        let command = command.current_dir(scratch.path("")).env("NO_COLOR", "1");
        let done = command
            .args(["--config", config, "a.glsl"])
            .output()
            .unwrap();
        String::from_utf8(done.stdout).unwrap()
    };
    assert!(run("silent.toml").ends_with(", no findings\n"));
    let told = run("some.toml");
    assert!(told.contains("a run of 640 pixels"), "{told}");
}

/// What a text may do and a run never does is no warning, and what it does says so.
#[test]
fn a_run_judges_what_the_text_lets_suspect() {
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
        never.out.starts_with("note[sqrt-negative]"),
        "{}",
        never.out
    );
    assert!(
        never.out.contains("9216 times and never met this"),
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
    assert!(met.out.contains("a run met this"), "{}", met.out);
}
