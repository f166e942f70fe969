//! `--write-baseline` and `--baseline`.

use super::scratch::{BROKEN, Scratch, WARNED};

#[test]
fn what_was_there_is_left_out_and_what_is_new_is_not() {
    let scratch = Scratch::new(&[("src/a.glsl", WARNED), ("src/b.glsl", BROKEN)]);
    let ran = scratch.run(&["--write-baseline", "baseline.json", "src"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert_eq!(ran.err, "shaderlint: 4 findings written to baseline.json\n");
    let check = || scratch.run(&["-q", "--baseline", "baseline.json", "src"]);
    let ran = check();
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (0, "", ""));

    // Lines move; the findings stay known.
    scratch.write("src/a.glsl", format!("// a\n// b\n{WARNED}"));
    assert_eq!(check().out, "");
    // The same line once more is new, and so is the same text in another file.
    scratch.write(
        "src/a.glsl",
        WARNED.replace(
            "    float unused",
            "    wave += pow(iTime - 9.0, 2.0);\n    float unused",
        ),
    );
    assert!(check().out.contains("pow-negative-base"));
    scratch.write("src/a.glsl", WARNED);
    scratch.write("src/c.glsl", BROKEN);
    let ran = check();
    assert_eq!(ran.code, 1);
    assert!(ran.out.contains("src/c.glsl:2:36") && !ran.out.contains("src/b.glsl"));
}

#[test]
fn a_baseline_holds_from_every_folder() {
    let scratch = Scratch::new(&[("src/a.glsl", WARNED)]);
    scratch.run(&["--write-baseline", "baseline.json", "./src/a.glsl"]);
    let path = scratch.path("src/a.glsl");
    for file in [
        "src",
        "src/a.glsl",
        "./src/../src/a.glsl",
        path.to_str().unwrap(),
    ] {
        assert_eq!(
            scratch
                .run(&["-q", "--baseline", "baseline.json", file])
                .out,
            "",
            "{file}"
        );
    }
    let ran = scratch.run_in("src", &["-q", "--baseline", "../baseline.json", "a.glsl"]);
    assert_eq!(ran.out, "");
    assert!(
        !scratch
            .read("baseline.json")
            .contains(scratch.path("").to_str().unwrap())
    );
}

#[test]
fn what_is_no_baseline_is_told() {
    let scratch = Scratch::new(&[("a.glsl", WARNED), ("b.json", "{}"), ("c.json", "{")]);
    for file in ["b.json", "c.json", "missing.json"] {
        let ran = scratch.run(&["--baseline", file, "a.glsl"]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{file}");
        assert!(
            ran.err.starts_with(&format!("shaderlint: {file}: ")),
            "{}",
            ran.err
        );
    }
}

#[test]
fn what_is_gone_is_named_and_dropped() {
    let scratch = Scratch::new(&[
        ("src/a.glsl", WARNED),
        ("src/b.glsl", BROKEN),
        ("src/c.glsl", WARNED),
    ]);
    scratch.run(&["--write-baseline", "baseline.json", "src"]);
    scratch.write("src/a.glsl", WARNED.replace("iTime - 9.0", "9.0"));
    std::fs::remove_file(scratch.path("src/c.glsl")).unwrap();
    let ran = scratch.run(&["--baseline", "baseline.json", "src"]);
    assert_eq!(ran.code, 0);
    assert_eq!(
        ran.err,
        "shaderlint: src/a.glsl: `pow-negative-base` of the baseline is gone\n\
         shaderlint: src/c.glsl: `pow-negative-base` of the baseline is gone\n\
         shaderlint: src/c.glsl: `unused-variable` of the baseline is gone\n\
         shaderlint: --write-baseline takes out of the baseline what is gone\n"
    );
    let first = ran.out.lines().next();
    assert_eq!(
        first,
        Some("2 shaders in 2 files, no findings; 3 in the baseline")
    );
    // What is known of files that this run does not look at stays.
    let ran = scratch.run(&["--write-baseline", "baseline.json", "src/a.glsl"]);
    assert_eq!(
        ran.err.lines().next(),
        Some("shaderlint: src/a.glsl: `pow-negative-base` is gone")
    );
    let ran = scratch.run(&["--baseline", "baseline.json", "src"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    assert!(!scratch.read("baseline.json").contains("c.glsl"));
}
