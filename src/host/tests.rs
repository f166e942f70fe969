//! Tests of reading host files.

use super::*;

#[test]
fn the_head_of_a_preset_is_read() {
    let text = "// My engine\n//\n// Puts things: many.\n//\n// And more.\n// word: my_* uMine\n// package: mine @mine/\n\
        // version: 100\n// names: all\nuniform float uMine;\n";
    let preset = read(text).unwrap();
    assert_eq!(preset.title, "My engine");
    assert_eq!(preset.about, "Puts things: many.\n\nAnd more.");
    assert!(preset.has_word("my_x") && preset.has_word("uMine") && !preset.has_word("uMin"));
    assert!(preset.is_package("mine") && preset.is_package("@mine/core"));
    assert!(!preset.is_package("@mine2/core") && !preset.is_package("mine-too"));
    assert_eq!(preset.version, HostVersion::Es100);
    assert!(preset.is_complete);
    assert_eq!(preset.prelude, "\n\n\n\n\n\n\n\n\nuniform float uMine;\n");
    let error = read("// A\n// version: 2\n").unwrap_err();
    assert_eq!(
        (error.line, error.message.as_str()),
        (
            2,
            "expected one of `any`, `own`, `desktop`, `100`, `300 es`, found `2`"
        )
    );
    assert_eq!(
        read("// A\n// names: all\n// wrong: 2\n").unwrap_err().line,
        3
    );
}

#[test]
fn a_host_can_extend_another() {
    let text =
        "// Mine\n//\n// Like three.js.\n// base: three\nuniform float mine; // = time, own\n";
    let preset = read(text).unwrap();
    let three = super::preset("three").unwrap();
    assert_eq!(
        (preset.version, &preset.entries),
        (three.version, &three.entries)
    );
    assert!(preset.prelude.starts_with(&three.prelude));
    assert!(preset.prelude.contains("uniform float mine;"));
    assert_eq!(preset.meanings.feeds[0].name, "mine");
    assert!(preset.meanings.feeds.len() == three.meanings.feeds.len() + 1);
    assert!(preset.packages.is_empty() && preset.words.is_empty());
    let error = read("// A\n// base: threee\n").unwrap_err();
    assert!(
        error.message.ends_with("did you mean `three`?"),
        "{error:?}"
    );
}

#[test]
fn names_that_shaders_declare_are_not_in_the_prelude() {
    let text = "// A\nuniform float a; // = time\n#ifdef SHADER_DECLARES\n\
        uniform float b; // = frame\n#endif\nuniform float c; // = tim\n";
    let error = read(text).unwrap_err();
    assert_eq!(error.line, 6);
    let preset = read(&text.replace("= tim\n", "= time\n")).unwrap();
    let own: Vec<&str> = preset.prelude.lines().filter(|l| !l.is_empty()).collect();
    assert_eq!(own, ["uniform float a;", "uniform float c;"]);
    let declared = preset.meanings.feeds.iter().map(|r| r.is_declared);
    assert_eq!(declared.collect::<Vec<_>>(), [true, false, true]);
}

#[test]
fn doc_comments_describe_names() {
    let text = "// A\n/// How long\n/// it runs.\nuniform float a; // = time\nuniform float b;\n";
    let preset = read(text).unwrap();
    assert_eq!(
        preset.descriptions.get("a").map(String::as_str),
        Some("How long it runs.")
    );
    assert_eq!(preset.descriptions.len(), 1);
    assert_eq!(preset.prelude, "\n\n\nuniform float a;\nuniform float b;\n");
}

#[test]
fn every_preset_is_valid() {
    for (name, text) in FILES {
        let preset = read(text).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        assert!(
            !preset.title.is_empty() && !preset.about.is_empty(),
            "{name}"
        );
        assert!(!preset.source.is_empty(), "{name}");
    }
}
