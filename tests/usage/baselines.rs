//! `--write-baseline` and `--baseline`.

use crate::scratch::{BROKEN, Scratch, WARNED};

#[test]
fn baselines_hide_known_findings_only() {
    let scratch = Scratch::new(&[("src/a.glsl", WARNED), ("src/b.glsl", BROKEN)]);
    let ran = scratch.run(&["--write-baseline", "baseline.json", "src"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert_eq!(ran.err, "shaderlint: wrote 3 findings to baseline.json\n");
    let check = || scratch.run(&["-q", "--baseline", "baseline.json", "src"]);
    let ran = check();
    assert_eq!((ran.code, ran.out.as_str(), ran.err.as_str()), (0, "", ""));

    // Moving lines does not invalidate the baseline.
    scratch.write("src/a.glsl", format!("// a\n// b\n{WARNED}"));
    assert_eq!(check().out, "");
    // A second occurrence of the same line is new, and so is the same text in another file.
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
fn baselines_work_from_every_folder() {
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
fn invalid_baselines_are_reported() {
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
fn stale_baseline_entries_are_reported_and_removed() {
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
        "shaderlint: src/a.glsl: `pow-negative-base` is in the baseline but no longer reported\n\
         shaderlint: src/c.glsl: `pow-negative-base` is in the baseline but no longer reported\n\
         shaderlint: use --write-baseline to remove obsolete entries\n"
    );
    let first = ran.out.lines().next();
    assert_eq!(
        first,
        Some(
            "No findings in what could be checked (2 shaders in 2 files); 2 in the baseline; 1 info: --info"
        )
    );
    // Entries for files that are not checked in this run remain.
    let ran = scratch.run(&["--write-baseline", "baseline.json", "src/a.glsl"]);
    assert_eq!(
        ran.err.lines().next(),
        Some("shaderlint: src/a.glsl: removed `pow-negative-base`")
    );
    let ran = scratch.run(&["--baseline", "baseline.json", "src"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    assert!(!scratch.read("baseline.json").contains("c.glsl"));
}
