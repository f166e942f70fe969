//! Hostile inputs: for any text the output comes quickly and is short.
//!
//! Time is measured by counting allocations, which is the same on every machine.

mod counting;
mod patterns;
mod repetitions;

use counting::{Asked, Counting, asked};
use shaderlint::cli::STACK;
use shaderlint::diagnostic::Severity;
use shaderlint::engine::{DialectChoice, Options, check};
use shaderlint::lint::Settings;
use shaderlint::project::NoFiles;
use shaderlint::report::{Format, Reporter};
use shaderlint::rules::RULES;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Maximum total allocations. A text close to it takes some seconds.
const MAX_ASKED: Asked = Asked {
    times: 20_000_000,
    bytes: 2 << 30,
};
/// Maximum output length, in bytes.
const MAX_OUTPUT: usize = 1_000_000;

/// The compiler's expected verdict.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Verdict {
    Compiles,
    Refused,
}
use Verdict::{Compiles, Refused};

/// Checks a pass with the text `code`, on a thread with the same stack size as in the programs.
#[track_caller]
fn expect(code: &str, expected: Verdict) {
    std::thread::scope(|scope| {
        let builder = std::thread::Builder::new().stack_size(STACK);
        let thread = builder.spawn_scoped(scope, || expect_here(code, expected));
        if thread.unwrap().join().is_err() {
            panic!("see above");
        }
    });
}

fn expect_here(code: &str, expected: Verdict) {
    let (asked, ()) = asked(|| answer(code, expected));
    assert!(asked.times <= MAX_ASKED.times, "{asked:?}");
    assert!(asked.bytes <= MAX_ASKED.bytes, "{asked:?}");
}

fn answer(code: &str, expected: Verdict) {
    let options = Options::new(DialectChoice::Shadertoy, Settings::of_rules(RULES));
    let found = check("a.glsl", code, &options, &NoFiles);
    assert!(found.unread.is_none(), "not recognised as a shader");
    let mut refused = found.diagnostics.iter();
    let verdict = match refused.find(|d| d.severity == Severity::Error) {
        Some(_) => Refused,
        None => Compiles,
    };
    let first = found.diagnostics.first().map(|d| &d.message);
    assert_eq!(verdict, expected, "{first:?}");
    for format in [Format::Human, Format::Short, Format::Json] {
        let mut out = Vec::new();
        let mut reporter = Reporter::new(format, &mut out, false);
        reporter
            .file("", &found.sources, &found.diagnostics)
            .unwrap();
        reporter.finish().unwrap();
        assert!(
            out.len() <= MAX_OUTPUT,
            "{format:?}: {} bytes of output",
            out.len()
        );
    }
}

/// A pass with `body` as the body of `mainImage`.
fn body(body: &str) -> String {
    format!(
        "void mainImage(out vec4 o, in vec2 p) {{ float x = p.x; int n = int(p.y); o = vec4(x); {body} }}\n"
    )
}

/// Concatenates `text` for each number less than `count`.
fn each(count: usize, text: impl Fn(usize) -> String) -> String {
    (0..count).map(text).collect()
}

/// `inner`, surrounded by `count` copies of `before` and `after`.
fn nest(count: usize, before: &str, inner: &str, after: &str) -> String {
    format!("{}{inner}{}", before.repeat(count), after.repeat(count))
}

#[test]
fn deeply_nested_constructs_do_not_crash() {
    let constructs = [
        ("(", "1.0", ")"),
        ("-", "x", ""),
        ("- ", "x", ""),
        ("!", "true", ""),
        ("abs(", "x", ")"),
        ("vec4(", "x", ")"),
        ("float[](", "x", ")"),
        ("o[", "0", "]"),
        ("o[int(", "0.0", ")]"),
        ("x > 1.0 ? ", "x", " : x"),
        ("x > 1.0 ? x : ", "x", ""),
        ("x = ", "x", ""),
        ("(float) ", "x", ""),
        ("x, (", "x", ")"),
    ];
    for (before, inner, after) in constructs {
        expect(
            &body(&format!("x = {};", nest(50_000, before, inner, after))),
            Refused,
        );
    }
    let statements = [
        ("{", ";", "}"),
        ("if (x > 1.0) ", ";", ""),
        ("if (x > 1.0) {", ";", "}"),
        ("if (x > 1.0) ; else {", ";", "}"),
        ("for (;;) ", ";", ""),
        ("while (x > 1.0) {", ";", "}"),
        ("do ", ";", " while (x > 1.0);"),
        ("switch (n) { default: ", ";", "}"),
        ("struct S { ", "float a;", "};"),
        ("float f() { ", ";", "}"),
    ];
    for (before, inner, after) in statements {
        expect(&body(&nest(50_000, before, inner, after)), Refused);
    }
}

#[test]
fn unclosed_constructs_are_refused_quickly() {
    let opened = [
        "(",
        "[",
        "{",
        "f(",
        "o[",
        "vec4(",
        "if (",
        "for (",
        "while (",
        "do {",
        "switch (n) {",
        "struct S {",
        "case ",
        "? ",
        "x ? x : ",
        "#if 1\n",
        "#ifdef A\n",
        "#define A(\n",
        "layout(",
        "float a[",
        "/* ",
        "(float)",
        "void f(",
        "uniform B {",
        "#",
        "\"",
        "precision ",
        "else ",
        "return ",
    ];
    for text in opened {
        expect(&body(&text.repeat(20_000)), Refused);
        expect(&text.repeat(20_000), Refused);
    }
    // Closing tokens without an opening one.
    for text in [
        ")", "]", "}", "};", "*/", "#endif\n", "#else\n", ":", ";)", "},",
    ] {
        expect(&body(&text.repeat(20_000)), Refused);
    }
}

#[test]
fn long_chains_do_not_count_as_nesting() {
    let count = 200;
    expect(&body(&format!("x = {}x;", "x + ".repeat(count))), Compiles);
    let arms = each(5_000, |i| {
        format!("if (x < {i}.0) {{ o.x = {i}.0; }} else ")
    });
    expect(&body(&format!("{arms};")), Refused);
    expect(&body(&"x += 1.0; ".repeat(100_000)), Compiles);
    expect(&body(&format!("x = {}x;", "x + ".repeat(100_000))), Refused);
    expect(&body(&format!("x = {}x;", "x, ".repeat(100_000))), Refused);
    expect(
        &body(&format!("o = o{};", ".xyzw".repeat(50_000))),
        Compiles,
    );
    expect(&body(&format!("o = o{};", ".q.w".repeat(50_000))), Refused);
}

#[test]
fn many_errors_in_one_line_are_refused_quickly() {
    let many = |text: &str| text.repeat(100_000);
    for head in ["if (x; ", "while (x; ", "for (;; x; ", "for (x; "] {
        expect(&body(&many(head)), Refused);
    }
    let structs = many("struct S { float ; vec3 a( ; }; ");
    expect(&format!("{structs}{}", body("")), Refused);
    expect(&body(&structs), Refused);
}

/// Two candidate repairs that may remove the same token.
#[test]
fn overlapping_repairs_do_not_crash() {
    let code = "y 08 default: return \u{e9}, += f(uniform ; } /* note */ [o = vec4(x, y, 0.0, 1.0);\n\
                o ) vec3 #else\nx const ";
    expect(code, Refused);
}

#[test]
fn exponential_macro_expansion_is_limited() {
    let doubled = |depth: usize| {
        let lines = each(depth, |i| format!("#define M{} M{i} + M{i}\n", i + 1));
        format!("#define M0 1.0\n{lines}{}", body(&format!("x = M{depth};")))
    };
    expect(&doubled(60), Refused);
    let calls = |depth| nest(depth, "F(", "1.0", ")");
    let definitions = [
        ("x", Compiles),
        ("(x)", Compiles),
        ("x + x", Refused),
        ("x x", Refused),
        ("F(x)", Refused),
    ];
    for (definition, verdict) in definitions {
        for (depth, verdict) in [(25, verdict), (5_000, Refused)] {
            let code = body(&format!("x = {};", calls(depth)));
            expect(&format!("#define F(x) {definition}\n{code}"), verdict);
        }
    }
    let chain = each(50_000, |i| format!("#define M{} M{i}\n", i + 1));
    expect(
        &format!("#define M0 1.0\n{chain}{}", body("x = M50000;")),
        Compiles,
    );
    let ring = each(10_000, |i| format!("#define M{i} M{}\n", (i + 1) % 10_000));
    expect(
        &format!("{ring}{}", body("float M0 = 1.0; x = M0;")),
        Compiles,
    );
    let params: Vec<String> = (0..10_000).map(|i| format!("a{i}")).collect();
    let args = vec!["1.0"; 10_000].join(",");
    let code = body(&format!("x = F({args});"));
    expect(
        &format!("#define F({}) a0\n{code}", params.join(",")),
        Compiles,
    );
    expect(
        &format!("#define A {}\n{}", "A ".repeat(100_000), body("A")),
        Refused,
    );
    expect(
        &format!("#define E\n{}", body(&"E ".repeat(200_000))),
        Compiles,
    );
}

#[test]
fn extreme_directives_are_refused_quickly() {
    expect(
        &format!("#if {}\n#endif\n{}", nest(50_000, "(", "1", ")"), body("")),
        Refused,
    );
    expect(
        &format!("#if {}1\n#endif\n{}", "!".repeat(100_000), body("")),
        Refused,
    );
    let groups = nest(50_000, "#if 1\n", "", "#endif\n");
    expect(&format!("{groups}{}", body("")), Compiles);
    let arms = format!("#if 0\n{}#endif\n", "#elif 0\n".repeat(50_000));
    expect(&format!("{arms}{}", body("")), Compiles);
    for line in [
        "99999999999999999999",
        "-5 3",
        "2147483647",
        "0",
        "4294967295",
        "1 2 3",
        "x",
    ] {
        expect(&format!("#line {line}\n{}", body("undefined;")), Refused);
    }
    expect(
        &format!("{}{}", "#line 7\n".repeat(20_000), body("")),
        Compiles,
    );
    expect(
        &format!("{}{}", "#pragma x\n".repeat(50_000), body("")),
        Compiles,
    );
    expect(
        &format!("{}{}", "#nothing\n".repeat(50_000), body("")),
        Refused,
    );
}

#[test]
fn huge_tokens_are_refused_quickly() {
    expect(
        &body(&format!("float {} = 1.0;", "a".repeat(1_000_000))),
        Refused,
    );
    expect(
        &body(&format!("float {} = 1.0;", "a".repeat(1_024))),
        Compiles,
    );
    expect(&body(&format!("int i = {};", "9".repeat(100_000))), Refused);
    expect(
        &body(&format!("int i = 0x{};", "f".repeat(100_000))),
        Refused,
    );
    expect(&body(&format!("x = 1{}.0;", "0".repeat(100_000))), Compiles);
    expect(&body(&format!("x = 0.{}1;", "0".repeat(100_000))), Compiles);
    expect(&body("x = 1.0e999999999999;"), Compiles);
    expect(&body(&format!("o = o.{};", "x".repeat(100_000))), Refused);
    expect(
        &format!("/*{}*/{}", "line\n".repeat(100_000), body("")),
        Compiles,
    );
    expect(
        &format!("{}{}", "// line\n".repeat(100_000), body("")),
        Compiles,
    );
    expect(
        &format!("//{}\n{}", " \\\n".repeat(100_000), body("")),
        Compiles,
    );
    expect(
        &body(&format!("x{} = 1.0;", "\\\n".repeat(100_000))),
        Compiles,
    );
    expect(&body(&"x\\\n=\\\n1.\\\n0;".repeat(20_000)), Compiles);
    expect(&body(&"é".repeat(50_000)), Refused);
    expect(&body(&"é ".repeat(50_000)), Refused);
    expect(&body(&"\u{200b}$`@".repeat(50_000)), Refused);
    expect(&body(&each(20_000, |i| format!("é{i};"))), Refused);
    expect(&format!("{}{}", body(""), "\0".repeat(100_000)), Compiles);
}

/// Number of repetitions of a construct.
const COUNT: usize = 10_000;

/// Expects the verdict for these declarations before a shader with this body.
fn expect_after(declarations: &str, code: &str, verdict: Verdict) {
    expect(&format!("{declarations}{}", body(code)), verdict);
}

#[test]
fn many_functions_are_checked_quickly() {
    let functions = each(COUNT, |i| format!("float f{i}(float x) {{ return x; }}\n"));
    expect_after(&functions, "", Compiles);
    let first = "float f0(float x) { return x; }\n";
    let chain = each(COUNT, |i| {
        format!("float f{}(float x) {{ return f{i}(x); }}\n", i + 1)
    });
    expect_after(&format!("{first}{chain}"), "x = f10000(x);", Refused);
    let fan = each(60, |i| {
        let next = i + 1;
        format!("float f{next}(float x) {{ return f{i}(x) + f{i}(x); }}\n")
    });
    expect_after(&format!("{first}{fan}"), "x = f60(x);", Compiles);
    let overloads = each(5_000, |i| {
        format!("struct S{i} {{ float a; }}; float f(S{i} s) {{ return s.a; }}\n")
    });
    expect_after(&overloads, "S1 s; s.a = 1.0; x = f(s);", Compiles);
    expect_after(&overloads, &"x = f(x);".repeat(1_000), Refused);
}

#[test]
fn many_declarations_are_checked_quickly() {
    let variables = each(COUNT, |i| format!("float v{i} = x;"));
    expect(&body(&variables), Compiles);
    let scopes = each(COUNT, |i| format!("float v{i} = x; {{ float v{i} = x; }}"));
    expect(&body(&scopes), Compiles);
    let names: Vec<String> = (0..COUNT).map(|i| format!("v{i}")).collect();
    expect(&body(&format!("float {};", names.join(", "))), Compiles);
    let constants = each(COUNT, |i| format!("const int c{i} = {i};\n"));
    expect_after(&constants, "", Compiles);
    let structs = each(COUNT, |i| format!("struct S{i} {{ float a; }};\n"));
    expect_after(&structs, "", Compiles);
    let members = each(COUNT, |i| format!("float m{i};"));
    expect_after(&format!("struct S {{ {members} }};\n"), "", Compiles);
}

#[test]
fn many_cases_are_checked_quickly() {
    let cases = each(COUNT, |i| format!("case {i}: x = 1.0; break;\n"));
    expect(&body(&format!("switch (n) {{ {cases} }}")), Compiles);
    let same = "case 1: x = 1.0; break;\n".repeat(COUNT);
    expect(&body(&format!("switch (n) {{ {same} }}")), Refused);
}

#[test]
fn many_arguments_are_checked_quickly() {
    let args = vec!["x"; COUNT].join(", ");
    expect(&body(&format!("x = f({args});")), Refused);
    expect(&body(&format!("o = vec4({args});")), Refused);
    expect(&body(&format!("float a[] = float[]({args});")), Compiles);
    let params = vec!["float"; COUNT].join(", ");
    let function = format!("float f({params}) {{ return 1.0; }}\n");
    expect_after(&function, "", Refused);
}

#[test]
fn many_errors_are_refused_quickly() {
    expect(
        &body(&each(50_000, |i| format!("undefined{i};\n"))),
        Refused,
    );
    expect(&body(&"undefined;\n".repeat(50_000)), Refused);
    expect(&body(&"x = 1;\n".repeat(50_000)), Refused);
    expect(&body(&"x = ;\n".repeat(50_000)), Refused);
    expect(&body(&"float x float y\n".repeat(20_000)), Refused);
    expect(&"x y z\n".repeat(50_000), Refused);
    expect(
        &format!(
            "#define F undefined + 1\n{}",
            body(&"x = F;\n".repeat(20_000))
        ),
        Refused,
    );
    expect(
        &body(&format!("x = {};", "undefined + ".repeat(20_000))),
        Refused,
    );
    let long = format!("x = {}1; ", "x + ".repeat(10)).repeat(10_000);
    expect(&body(&long), Refused);
}

#[test]
fn huge_types_are_refused_quickly() {
    expect(&body("float a[2147483647]; x = a[0];"), Refused);
    expect(&body("float a[0]; float b[-1]; float c[n];"), Refused);
    expect(&body("int a[10000000]; int b[10000000]; a = b;"), Refused);
    let doubling = each(60, |i| format!("struct S{} {{ S{i} a, b; }};\n", i + 1));
    expect(
        &format!("struct S0 {{ float a, b; }};\n{doubling}{}", body("S60 s;")),
        Refused,
    );
    let nested = each(5_000, |i| format!("struct S{} {{ S{i} a; }};\n", i + 1));
    expect(
        &format!("struct S0 {{ float a; }};\n{nested}{}", body("")),
        Refused,
    );
    expect(
        "struct A { A a; }; struct B { C c; }; struct C { B b; };",
        Refused,
    );
    let constant = format!(
        "const float a[] = float[]({});\n",
        vec!["1.0"; 50_000].join(",")
    );
    expect(
        &format!(
            "{constant}{}",
            body(&each(1_000, |i| format!("x += a[{i}];")))
        ),
        Refused,
    );
    let copies = each(2_000, |i| format!("const float[1000] b{} = b{i};\n", i + 1));
    let first = format!(
        "const float[1000] b0 = float[1000]({});\n",
        vec!["1.0"; 1_000].join(",")
    );
    expect(&format!("{first}{copies}{}", body("")), Compiles);
}
