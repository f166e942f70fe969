//! Tests of the formatter on short texts.

use shaderlint::format::*;
use shaderlint::text::apply_edits;

#[track_caller]
fn formatted(text: &str, style: &Style) -> String {
    let apply = |text: &str| {
        let formatted = format(text, style, TextExtent::File, Lines::Free);
        assert_eq!(formatted.left, []);
        apply_edits(text, 0, &formatted.edits).unwrap()
    };
    let once = apply(text);
    assert_eq!(apply(&once), once, "not stable");
    once
}

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(formatted(text, &Style::default()), expected);
}

/// Checks the formatting of statements in a function.
#[track_caller]
fn body(text: &str, expected: &str) {
    let lines: Vec<String> = expected.lines().map(|l| format!("    {l}\n")).collect();
    let lines: String = lines.concat().replace("    \n", "\n");
    check(
        &format!("void f()\n{{\n{text}\n}}"),
        &format!("void f() {{\n{lines}}}\n"),
    );
}

#[test]
fn operators_have_spaces_around_them() {
    body("a=b+c*-d;", "a = b + c * -d;");
    body("a = b - - c;  d+ ++e;", "a = b - -c;\nd + ++e;");
    body("a [ 0 ].x = f ( a , b ) ;", "a[0].x = f(a, b);");
    body("a=b?c:d;i++;--j;", "a = b ? c : d;\ni++;\n--j;");
    body("return( a );", "return (a);");
    body(
        "float[ 2 ] a=float[ ]( 1. , 2. ) ;",
        "float[2] a = float[](1., 2.);",
    );
    body("a = !b && ~c==d;", "a = !b && ~c == d;");
    body("a = vec2( 1 ) ;;", "a = vec2(1);;");
    body("if(a){b;};", "if (a) { b; };");
}

#[test]
fn statements_have_their_own_lines() {
    body("a;b;", "a;\nb;");
    body("if(a)b;", "if (a) b;");
    body("if(a)\nb;else\nc;", "if (a)\n    b;\nelse\n    c;");
    body("if(a)b;else if(c)d;", "if (a) b; else if (c) d;");
    body(
        "if(a)\n{\nb;\n}\nelse\n{\nc;\n}",
        "if (a) {\n    b;\n} else {\n    c;\n}",
    );
    body(
        "if(a){b;}\nelse if(c){d;}",
        "if (a) { b; }\nelse if (c) { d; }",
    );
    body(
        "for(int i=0;i<3;i++){a;\nb;}",
        "for (int i = 0; i < 3; i++) {\n    a;\n    b;\n}",
    );
    body(
        "for(;;)\nfor(;;)\nif(a)\nb;\nelse\nc;d;",
        "for (;;)\n    for (;;)\n        if (a)\n            b;\n        else\n            c;\nd;",
    );
    body("do{a;\n}\nwhile(b);", "do {\n    a;\n} while (b);");
    body("while(a){}", "while (a) {}");
    body("{\na;}", "{\n    a;\n}");
    check(
        "struct A{float a;\nvec2 b;}c;",
        "struct A {\n    float a;\n    vec2 b;\n} c;\n",
    );
    check(
        "struct S{float a;}f(){\nreturn S(1.);}void g(){}",
        "struct S { float a; } f() {\n    return S(1.);\n}\nvoid g() {}\n",
    );
    check("uniform B{vec4 a;};", "uniform B { vec4 a; };\n");
    check(
        "float f(float x){return x*x;}",
        "float f(float x) { return x * x; }\n",
    );
}

#[test]
fn labels_are_indented_in_their_switch() {
    body(
        "switch(a){case 0:b;break;\ncase 1: {\nc;\n}\ndefault:\nd;\n}",
        "switch (a) {\n    case 0: b; break;\n    case 1: {\n        c;\n    }\n    default:\n        d;\n}",
    );
}

#[test]
fn comments_stay_next_to_their_code() {
    body(
        "a; // of a\n  // of b\n/* too */ b;",
        "a; // of a\n// of b\n/* too */ b;",
    );
    body(
        "if(a) // why\n{\nb;\n// last\n}",
        "if (a) // why\n{\n    b;\n    // last\n}",
    );
    body("a=f(b, // first\nc);", "a = f(b, // first\n      c);");
    body("f(/* x */a,b /* y */);", "f(/* x */ a, b /* y */);");
}

#[test]
fn at_most_two_empty_lines_are_kept() {
    check("\n\na;\n\n\n\n\nb;\n\nc;\n\n\n", "a;\n\n\nb;\n\nc;\n");
}

#[test]
fn directives_are_not_changed() {
    check(
        "#define  A   2.0*PI  \nfloat a=A;",
        "#define  A   2.0*PI\nfloat a = A;\n",
    );
    check(
        "#define A \\\n   b ; \\\n  c\nfloat a;",
        "#define A \\\n   b ; \\\n  c\nfloat a;\n",
    );
    check(
        "void f(){\n#ifdef A\nif(a){\n#else\nif(b){\n#endif\nc;\n}\n  #undef A\n}",
        "void f() {\n#ifdef A\n    if (a) {\n#else\n    if (b) {\n#endif\n        c;\n    }\n    #undef A\n}\n",
    );
}

#[test]
fn code_inside_conditionals_keeps_its_indentation() {
    body(
        "  #if A\n    a;\n  #else\n    if(b){\nc;}\n  #endif\n  d;",
        "#if A\n    a;\n#else\n    if (b) {\n        c;\n    }\n#endif\nd;",
    );
    check(
        "#ifdef A\n  #define B\n  float c ;\n#endif",
        "#ifdef A\n    #define B\n    float c;\n#endif\n",
    );
    // Directives around the start of a block are indented like the others.
    body(
        "  #if A\n  for(;;){\n  #else\n  b;\n  #endif\n  c;\n  #if A\n  }\n  #endif",
        "#if A\nfor (;;) {\n#else\nb;\n#endif\n    c;\n#if A\n}\n#endif",
    );
}

#[test]
fn inactive_code_is_not_formatted() {
    check(
        "#if 0\n it's  text (\n#endif\nfloat a ;",
        "#if 0\n it's  text (\n#endif\nfloat a;\n",
    );
}

#[test]
fn comments_switch_the_formatter_off_and_on() {
    check(
        "float a ;\n// shaderlint: fmt off\nfloat  b ;\n\n\n\n  float c ;\n// shaderlint: fmt on\nfloat  d ;",
        "float a;\n// shaderlint: fmt off\nfloat  b ;\n\n\n\n  float c ;\n// shaderlint: fmt on\nfloat d;\n",
    );
}

#[test]
fn aligned_tables_are_preserved() {
    check(
        "mat3 m=mat3( 0.00,  0.80,  0.60,\n         -0.80,  0.36, -0.48,\n         -0.60, -0.48,  0.64 );",
        "mat3 m = mat3( 0.00,  0.80,  0.60,\n           -0.80,  0.36, -0.48,\n           -0.60, -0.48,  0.64 );\n",
    );
    check(
        "const int A  =1;  // one\nconst int BCD=22; // two\n",
        "const int A   = 1;  // one\nconst int BCD = 22; // two\n",
    );
    body(
        "p.x=1.;   q.x=10.;\np.y=20.;  q.y=3.;",
        "p.x = 1.;   q.x = 10.;\np.y = 20.;  q.y = 3.;",
    );
}

#[test]
fn aligned_tables_of_expressions_are_preserved() {
    // All commas are below one another.
    body(
        "m=mat3( c.z,  s.z,    0,\n       -s.z,  c.z,    0,\n          0,    0,    1 );",
        "m = mat3( c.z,  s.z,    0,\n         -s.z,  c.z,    0,\n            0,    0,    1 );",
    );
    body(
        "m=mat2(vec2( a+b , c  , d),\nvec2(-a   , c+d, e));",
        "m = mat2(vec2( a+b , c  , d),\n         vec2(-a   , c+d, e));",
    );
    // Without additional space it is no table.
    body("f(a+b,c,d,\n  e+f,g,h);", "f(a + b, c, d,\n  e + f, g, h);");
    // Nor if the space changes nothing.
    body(
        "f( g(a,b), c+d,\n  g(e,f), h+i  );",
        "f(g(a, b), c + d,\n  g(e, f), h + i);",
    );
    // The last row is shorter.
    body(
        "a = b[]\n(\n  c( 1,  9), c(11,  9),\n  c( 2,  9)\n);",
        "a = b[]\n(\n  c( 1,  9), c(11,  9),\n  c( 2,  9)\n);",
    );
}

#[test]
fn aligned_bodies_are_preserved() {
    body(
        "if(a)   b=1;\nif(ccc) return;\nelse    d=2;",
        "if (a)   b = 1;\nif (ccc) return;\nelse     d = 2;",
    );
    check(
        "float a(float b)   {return b;}\nfloat ccc(float b) {return d;}\nfloat e(float b)   {\nreturn b;}\n",
        "float a(float b)   { return b; }\nfloat ccc(float b) { return d; }\nfloat e(float b) {\n    return b;\n}\n",
    );
}

#[test]
fn columns_align_items_of_the_same_kind() {
    // A coincidence.
    body(
        "a=b+c*(d-e);\nvec2   g=h;",
        "a = b + c * (d - e);\nvec2 g = h;",
    );
    body(
        "float a  = b;\nvec2  cc = d;",
        "float a  = b;\nvec2  cc = d;",
    );
    body(
        "m=mat2(cos(a),0,\n       0,     1);",
        "m = mat2(cos(a), 0,\n         0,      1);",
    );
}

#[test]
fn numbers_in_columns_keep_their_padding() {
    body(
        "a=f(vec2( 1.0,  0.0));\nb=f(vec2(-1.0, -1.0));\nc=f(vec2(10.0,  1.0));",
        "a = f(vec2( 1.0,  0.0));\nb = f(vec2(-1.0, -1.0));\nc = f(vec2(10.0,  1.0));",
    );
    body(
        "x+=x<<10u;\nx^=x>> 6u;\nx+=y;",
        "x += x << 10u;\nx ^= x >>  6u;\nx += y;",
    );
    body("a = vec2( 1.0, 2.0);", "a = vec2(1.0, 2.0);");
    // The brackets are no longer below one another.
    body(
        "a =b(vec2( 0.5, 1.0));\nc =b(vec2(-0.5, 1.0));\ndd=b(vec2(-0.5, 1.0));",
        "a = b(vec2( 0.5, 1.0));\nc = b(vec2(-0.5, 1.0));\ndd = b(vec2(-0.5, 1.0));",
    );
}

#[test]
fn similar_statements_may_share_a_line() {
    body("c(1);c(2);c(3);", "c(1); c(2); c(3);");
    body(
        "float f=.5*n(p);p=m*p;\nf+=.25*n(p);p=m*p*2.;",
        "float f = .5 * n(p); p = m * p;\nf += .25 * n(p); p = m * p * 2.;",
    );
    body("a=1.;b=2.;\nf(c);d=3.;", "a = 1.;\nb = 2.;\nf(c);\nd = 3.;");
    body("a=1.;   b=2.;\nf(c);", "a = 1.;  b = 2.;\nf(c);");
    body(
        "a+=f(1.)*.5  ; b*=2.;\na+=f(2.)*.125; b*=3.;",
        "a += f(1.) * .5;   b *= 2.;\na += f(2.) * .125; b *= 3.;",
    );
}

#[test]
fn long_lists_of_similar_statements_are_rewrapped() {
    let style = Style {
        width: 32,
        ..Style::default()
    };
    assert_eq!(
        formatted(
            "aa(1); aa(2); aa(3); aa(4); aa(5);\naa(6);\n\nb(1);",
            &style
        ),
        "aa(1); aa(2); aa(3); aa(4);\naa(5); aa(6);\n\nb(1);\n"
    );
    assert_eq!(
        formatted("aa(1); aa(2); aa(3); aa(4); aa(5); // a", &style),
        "aa(1); aa(2); aa(3); aa(4);\naa(5); // a\n"
    );
    // Rows of assignments are groups.
    assert_eq!(
        formatted("aa = 1; ab = 2; ac = 3; ad = 4; ae = 5;\nba = 1;", &style),
        "aa = 1; ab = 2; ac = 3; ad = 4;\nae = 5;\nba = 1;\n"
    );
}

/// However long their line is.
#[test]
fn empty_statements_are_not_wrapped() {
    let empty = ";".repeat(130);
    body(&format!("{empty}\na();"), &format!("{empty}\na();"));
    check(&format!("{empty}S x;"), &format!("{empty}\nS x;\n"));
    check(";   ;", ";;\n");
}

#[test]
fn rows_of_tables_may_exceed_the_line_width() {
    let style = Style {
        width: 30,
        ..Style::default()
    };
    let text = "m = mat3(aaaaaaaaaa + b, 0,      c,\n         0,              d + ee, 0);\n";
    assert_eq!(formatted(text, &style), text);
    let text =
        "float a(float b) { return bb  + c  * dd; }\nfloat b(float b) { return ccc + dd * ee; }\n";
    assert_eq!(formatted(text, &style), text);
}

#[test]
fn macro_calls_may_lack_a_semicolon() {
    check(
        "A(1)\nB(2) c\nD(3)\nvoid f(){}",
        "A(1)\nB(2) c\nD(3)\nvoid f() {}\n",
    );
    check(
        "int a = b(1)\n+c(2)\n;",
        "int a = b(1)\n    + c(2)\n    ;\n",
    );
}

#[test]
fn long_lines_are_broken_at_the_outermost_operator() {
    let style = Style {
        width: 30,
        ..Style::default()
    };
    let broken = |text: &str| formatted(text, &style);
    assert_eq!(
        broken("float a = max(min(bb, cc), dddddd);"),
        "float a = max(min(bb, cc),\n    dddddd);\n"
    );
    assert_eq!(
        broken("a = max(min(bb, cc), dddddd + e);"),
        "a = max(min(bb, cc),\n        dddddd + e);\n"
    );
    assert_eq!(
        broken("float a = bbbbbb * cccccc + dddddd * eeeeee;"),
        "float a = bbbbbb * cccccc\n    + dddddd * eeeeee;\n"
    );
}

#[test]
fn long_lines_have_one_form() {
    let style = Style {
        width: 40,
        ..Style::default()
    };
    let cases = [
        // The last line has more than one argument.
        (
            "a = f(bbbbbbbbb, cccccccc, dddddddd, eee);",
            "a = f(bbbbbbbbb, cccccccc,\n      dddddddd, eee);\n",
        ),
        // Arguments that fit nowhere else start a line.
        (
            "col.rgb = mix(cc, g(aaaaa, bbbbbb, dd + ee));",
            "col.rgb = mix(\n    cc, g(aaaaa, bbbbbb, dd + ee));\n",
        ),
        // One line after the assignment, rather than a short last line.
        (
            "float aaaaaa = bbbbbb(cccccc, ddddd) * e;",
            "float aaaaaa =\n    bbbbbb(cccccc, ddddd) * e;\n",
        ),
        // Terms fill lines, or each has its own.
        (
            "float a = bbbbbbbb + cccccccc + dddddddd + eeee;",
            "float a = bbbbbbbb + cccccccc\n    + dddddddd + eeee;\n",
        ),
        (
            "float a = bb + cccccc * f(dddddddd, eeeeeeee) * g + hhhhhhhhhhhh;",
            "float a = bb\n    + cccccc * f(dddddddd, eeeeeeee) * g\n    + hhhhhhhhhhhh;\n",
        ),
        // Factors of a term are indented further.
        (
            "float a = b + cccccccccccccccc * dddddddddd * eeeeeee;",
            "float a = b + cccccccccccccccc\n        * dddddddddd * eeeeeee;\n",
        ),
        (
            "a = bbbbbbb < c ? ddddddddd : bbbbbb < e ? ffffff : g;",
            "a = bbbbbbb < c ? ddddddddd\n  : bbbbbb < e ? ffffff\n  : g;\n",
        ),
        (
            "float a = bbbbbbb < ccccccc ? ddddddddd : eeeeee;",
            "float a = bbbbbbb < ccccccc\n    ? ddddddddd\n    : eeeeee;\n",
        ),
        // A short argument stays with a call, whose arguments are broken.
        (
            "d = min(d, f(aaaaaa - b, vec2(ccccccccc, dddd)));",
            "d = min(d, f(aaaaaa - b,\n             vec2(ccccccccc, dddd)));\n",
        ),
        // Arguments that would be broken far to the right are below.
        (
            "aaaaaaaa.bbb = max(f(ccccccccc, ddddddd, eeee), g(hhhhhhhhhhhhhhhhhhh, iiiiiiiiiiiiiii));",
            "aaaaaaaa.bbb = max(\n    f(ccccccccc, ddddddd, eeee),\n    g(hhhhhhhhhhhhhhhhhhh,\n      iiiiiiiiiiiiiii));\n",
        ),
        (
            "if (aaaaaaaaaaaaaaaaaa < bbbbbbbbbbbbbb(ccc)) d = 1.;",
            "if (aaaaaaaaaaaaaaaaaa\n    < bbbbbbbbbbbbbb(ccc))\n    d = 1.;\n",
        ),
        // Lines end with operators where the author's do.
        (
            "a = b +\nc;\nfloat d = eeeeeeeeeeee * fffffffff + gggggggggg;",
            "a = b +\n    c;\nfloat d = eeeeeeeeeeee * fffffffff +\n    gggggggggg;\n",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(formatted(text, &style), expected);
    }
}

#[test]
fn long_lists_of_similar_elements_are_rewrapped() {
    let style = Style {
        width: 40,
        ..Style::default()
    };
    let cases = [
        // Lines of equal length, if that takes no more than one line more.
        (
            "int a[] = int[](111, 222, 333, 444, 555, 666,\n777, 888);",
            "int a[] = int[](111, 222, 333, 444,\n                555, 666, 777, 888);\n",
        ),
        (
            "int a[] = int[](\n111, 222, 333, 444, 555, 666, 777, 888, 999,\n0, 1\n);",
            "int a[] = int[](\n    111, 222, 333, 444, 555, 666,\n    777, 888, 999, 0, 1\n);\n",
        ),
        // Lines that are columns of a matrix.
        (
            "m = mat2x3(1.25, 2.5, 3.75, 4.25, 5.5, 6.75);",
            "m = mat2x3(1.25, 2.5, 3.75,\n           4.25, 5.5, 6.75);\n",
        ),
        // Names and parameters.
        (
            "void f(float aaaaaaa, float bbbbbbbb, float c,\nfloat d) {}",
            "void f(float aaaaaaa, float bbbbbbbb,\n       float c, float d) {}\n",
        ),
        // Elements of several kinds stay in the author's lines.
        (
            "f(aaaaaaaaaaaa, bbbbbbbbbbbb + 1, c * dddddd,\ne, f);",
            "f(aaaaaaaaaaaa,\n  bbbbbbbbbbbb + 1, c * dddddd,\n  e, f);\n",
        ),
        // So do rows that are short enough.
        ("f(aaaa,\nbbbb, cccc);", "f(aaaa,\n  bbbb, cccc);\n"),
    ];
    for (text, expected) in cases {
        assert_eq!(formatted(text, &style), expected);
    }
}

#[test]
fn if_and_else_on_one_line_are_broken_together() {
    let style = Style {
        width: 40,
        ..Style::default()
    };
    let broken = |text: &str| formatted(&format!("void f(){{\n{text}}}"), &style);
    assert_eq!(
        broken("if(aaaaaaa)b=1;else if(ccccccc)d=1;else e=2;\n"),
        "void f() {\n    if (aaaaaaa) b = 1;\n    else if (ccccccc) d = 1;\n    else e = 2;\n}\n"
    );
    assert_eq!(
        broken("if(aaaaaaa){b;}else if(cccccccccc){d;}else{e;}\n"),
        "void f() {\n    if (aaaaaaa) { b; }\n    else if (cccccccccc) { d; }\n    else { e; }\n}\n"
    );
    assert_eq!(
        broken("if(a)b;else\nif(c)d;\n"),
        "void f() {\n    if (a) b;\n    else if (c) d;\n}\n"
    );
    assert_eq!(
        broken("if(a)_1 else if(b)_2\n"),
        "void f() {\n    if (a) _1 else if (b) _2\n}\n"
    );
    assert_eq!(
        broken("if(aaaaaaa)b=cccccccccccccccccccccc;else e=2;\n"),
        "void f() {\n    if (aaaaaaa)\n        b = cccccccccccccccccccccc;\n    else\n        e = 2;\n}\n"
    );
}

#[test]
fn line_breaks_of_the_author_are_kept() {
    body("a = b\n+ c;", "a = b\n    + c;");
    body("a = b\n  + c;", "a = b\n  + c;");
    body("float a = b\n        + c;", "float a = b\n        + c;");
    body("a = f(\nb,\nc\n);", "a = f(\n    b,\n    c\n);");
}

#[test]
fn line_breaks_before_line_macros_are_kept() {
    let text = "void f(){a;b;\n\n\n\n\nc(__LINE__);}";
    check(text, "void f() { a; b;\n\n\n\n\n    c(__LINE__); }\n");
}

#[test]
fn tabs_can_be_used_for_indentation() {
    let style = Style {
        indent: Indentation::Tab(4),
        brace: Brace::Next,
        ..Style::default()
    };
    let text = "void f(){if(a){b(c,\nd);\n}else{e;\n}}";
    let expected =
        "void f()\n{\n\tif (a)\n\t{\n\t\tb(c,\n\t\t  d);\n\t}\n\telse\n\t{\n\t\te;\n\t}\n}\n";
    assert_eq!(formatted(text, &style), expected);
}

#[test]
fn line_breaks_are_preserved() {
    check("float a;float b;\r\n", "float a;\r\nfloat b;\r\n");
}

#[test]
fn unmatched_brackets_are_refused() {
    for text in [
        "void f() {",
        "}",
        "a(]",
        "a(}",
        "/* b",
        "#define A /* b\n",
        "a)",
        "a; #b",
        "a; /* */ #b",
    ] {
        let formatted = format(text, &Style::default(), TextExtent::File, Lines::Free);
        assert_eq!(
            (&formatted.edits[..], formatted.left.len()),
            (&[][..], 1),
            "{text}"
        );
    }
    let deep = "(".repeat(300);
    let formatted = format(&deep, &Style::default(), TextExtent::File, Lines::Free);
    let [why] = &formatted.left[..] else {
        panic!("one reason")
    };
    assert_eq!(why.message, "the code is nested too deeply");
}

#[test]
fn functions_with_unmatched_brackets_are_not_changed() {
    let text = "float a( ) {return 1.;}\n#define EACH for (;;) {\nvoid b( ) {\nEACH  c;\n}\n}\n}\n\n\
                float d( ) {return 2.;}\n";
    let expected = "float a() { return 1.; }\n#define EACH for (;;) {\nvoid b( ) {\nEACH  c;\n}\n}\n}\n\n\
                    float d() { return 2.; }\n";
    let apply = |text: &str| {
        let formatted = format(text, &Style::default(), TextExtent::File, Lines::Free);
        let messages: Vec<String> = formatted.left.into_iter().map(|why| why.message).collect();
        assert_eq!(messages, ["unmatched closing bracket"]);
        apply_edits(text, 0, &formatted.edits).unwrap()
    };
    assert_eq!(apply(text), expected);
    assert_eq!(apply(expected), expected);
}
