//! `fmt`: written, printed and rejected files, and the source of the style.

use crate::scratch::Scratch;

const UGLY: &str = "void main(){gl_FragColor=vec4( 1.0 ) ;\n}\n";
const PRETTY: &str = "void main() {\n    gl_FragColor = vec4(1.0);\n}\n";

#[test]
fn files_are_written_in_place() {
    let scratch = Scratch::new(&[("a.frag", UGLY), ("lib/b.frag", PRETTY), ("c.txt", UGLY)]);
    let ran = scratch.run(&["fmt"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, ""));
    assert_eq!(
        ran.err,
        "shaderlint fmt: 1 file reformatted, 1 already formatted\n"
    );
    assert_eq!(scratch.read("a.frag"), PRETTY);
    assert_eq!(scratch.read("c.txt"), UGLY);
    let ran = scratch.run(&["fmt", "a.frag"]);
    assert_eq!(ran.err, "shaderlint fmt: 1 file already formatted\n");
    let ran = scratch.run(&["fmt", "-q", "a.frag"]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
}

#[test]
fn check_reports_differences_and_writes_nothing() {
    let scratch = Scratch::new(&[("a.frag", UGLY), ("b.frag", PRETTY)]);
    let ran = scratch.run(&["fmt", "--check", "."]);
    assert_eq!(
        (ran.code, ran.out.as_str()),
        (1, "a.frag:1: not formatted\n")
    );
    assert_eq!(
        ran.err,
        "shaderlint fmt: 1 file would be reformatted, 1 already formatted\n"
    );
    let ran = scratch.run(&["fmt", "--diff", "-q", "."]);
    let diff = "--- a/a.frag\n+++ b/a.frag\n@@ -1,2 +1,3 @@\n-void main(){gl_FragColor=vec4( 1.0 ) ;\n\
                +void main() {\n+    gl_FragColor = vec4(1.0);\n }\n";
    assert_eq!(
        (ran.code, ran.out.as_str(), ran.err.as_str()),
        (0, diff, "")
    );
    assert_eq!(scratch.read("a.frag"), UGLY);
}

#[test]
fn formatted_standard_input_is_printed() {
    let scratch = Scratch::new(&[(".editorconfig", "[*.vert]\nindent_size = 2\n")]);
    let ran = scratch.pipe(UGLY, &["fmt", "-"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, PRETTY));
    let ran = scratch.pipe(UGLY, &["fmt", "-", "--stdin-filename", "a.vert"]);
    assert_eq!(ran.out, PRETTY.replace("    ", "  "));
    let other = "float4 main() : SV_Target { return 1 ; }\n";
    let ran = scratch.pipe(other, &["fmt", "-", "--stdin-filename", "a.hlsl"]);
    assert_eq!((ran.code, ran.out.as_str()), (0, other));
}

/// Writing the output back to the input loses nothing.
#[test]
fn unformattable_text_is_unchanged() {
    let open = "void main(){\n  a = (b;\n}\n";
    let scratch = Scratch::new(&[("a.frag", open), ("b.frag", UGLY)]);
    let ran = scratch.run(&["fmt", "."]);
    assert_eq!(ran.code, 2);
    let (first, rest) = ran.err.split_once('\n').unwrap();
    assert_eq!(
        first,
        "shaderlint fmt: a.frag:2:7: not formatted: unclosed bracket"
    );
    assert_eq!(rest, "shaderlint fmt: 1 file reformatted\n");
    assert_eq!(scratch.read("a.frag"), open);
    assert_eq!(scratch.read("b.frag"), PRETTY);
    let ran = scratch.pipe(open, &["fmt", "-"]);
    assert_eq!((ran.code, ran.out.as_str()), (2, open));
    scratch.write("c.frag", b"void main(){ } // \xff");
    let ran = scratch.run(&["fmt", "c.frag"]);
    assert_eq!(
        (ran.code, ran.err.as_str()),
        (2, "shaderlint fmt: c.frag: the file is not valid UTF-8\n")
    );
}

#[test]
fn the_nearest_style_files_apply() {
    let scratch = Scratch::new(&[
        ("a.frag", UGLY),
        ("old/b.frag", UGLY),
        (
            ".editorconfig",
            "root = true\n[*]\nindent_style = tab\ncurly_bracket_next_line = true\n",
        ),
        (
            "shaderlint.toml",
            "[[overrides]]\npaths = [\"old\"]\nformat = { indent = 1, brace = \"same\" }\n",
        ),
    ]);
    assert_eq!(scratch.run(&["fmt", "."]).code, 0);
    let tabs = "void main()\n{\n\tgl_FragColor = vec4(1.0);\n}\n";
    assert_eq!(scratch.read("a.frag"), tabs);
    assert_eq!(scratch.read("old/b.frag"), PRETTY.replace("    ", " "));
    scratch.write("shaderlint.toml", "format.width = 7\n");
    let ran = scratch.run(&["fmt", "a.frag"]);
    let message =
        "shaderlint fmt: a.frag: shaderlint.toml:1:16: expected a number from 20 to 1000\n";
    assert_eq!((ran.code, ran.err.as_str()), (2, message));
}
