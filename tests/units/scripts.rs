//! What scripts and pages say about shaders: which texts they hold, join, pair, set and name.

use shaderlint_detect::embed::{
    AskedWebGl, DocumentLanguage, Embedder, LeadingBlanks, MentionKind, NameRole, NamedStage,
    extract, lists, mentions, script_code, together,
};

#[track_caller]
fn check_shaders(text: &str, expected: &[&str]) {
    let found = extract(DocumentLanguage::Script, text);
    for shader in &found {
        assert!(text.get(shader.start..shader.end()).is_some());
    }
    let codes: Vec<&str> = found.iter().map(|s| s.code.as_str()).collect();
    assert_eq!(codes, expected);
}

#[test]
fn literals_with_shaders_are_found() {
    check_shaders(
        "const a = `#version 300 es\nx`, b = 'void 0';",
        &["#version 300 es\nx"],
    );
    check_shaders(
        "f(glsl`float f();`, /* glsl */ `x;`, /* glsl */ `f(x)`, /*no*/`y;`)",
        &["float f();", "x;"],
    );
    check_shaders(
        "s = 'void  main ( ) {}'; t = \"void mainly()\"",
        &["void  main ( ) {}"],
    );
}

#[test]
fn concatenated_literals_are_joined() {
    check_shaders(
        "s = 'void main() {\\n' +\n 'x;' + // it's\n '}';",
        &["void main() {\n       x;              }"],
    );
    check_shaders(
        "s = ['void main() {', '}'].join('\\n');",
        &["void main() {\n   }"],
    );
    check_shaders(
        "s = 'void main() {' + f(1) + '}';",
        &["void main() {            }"],
    );
}

#[test]
fn decoded_escapes_keep_their_width() {
    check_shaders(
        r"s = 'void main() { \
}\t\x41\\\n';",
        &["void main() {   }     A \\\n "],
    );
}

#[test]
fn holes_become_names_numbers_or_nothing() {
    check_shaders(
        "s = `void main() {\n${a}\nx = ${b};y = ${c}.0; z = vec${d}(1);}`",
        &["void main() {\n    \nx = hhhh;y = 1111.0; z = vechhh1(1);}"],
    );
}

#[test]
fn interpolated_constants_are_inserted_and_other_values_are_holes() {
    let holes = |text: &str| {
        let found = extract(DocumentLanguage::Script, text);
        found.iter().map(|s| s.has_holes).collect::<Vec<_>>()
    };
    let sum = "const N = { max: 4 }; const s = `float a[${N.max + 1}]; void main() {}`;";
    check_shaders(sum, &["float a[5           ]; void main() {}"]);
    let constant = "const PR = 'highp'; const s = `precision ${PR} float; void main() {}`;";
    check_shaders(constant, &["precision highp float; void main() {}"]);
    assert_eq!(holes(constant), [false]);
    assert_eq!(holes("s = 'void main() {}' + x;"), [true]);
    assert_eq!(holes("s = x + /* glsl */ 'void main() {}';"), [true]);
    assert_eq!(holes("let s = 'void main() {'; s += x;"), [true]);
    assert_eq!(holes("s.replace(a, /* glsl */ 'void main() { b;')"), [true]);
    assert_eq!(holes("s = 'float a = {{ b }}; void main() {}'"), [true]);
    check_shaders(
        "s = 'float a[' + n + ']; void main() {}'.concat(b, 'float c;')",
        &["float a[hhhhhhhhh]; void main() {}             float c;"],
    );
    check_shaders(
        "s = ['void main() {', a ? 'b' : '', '}'].filter(c).join('\\n')",
        &["void main() {\n                \n}"],
    );
}

#[test]
fn literals_without_shaders_are_skipped() {
    check_shaders("s.replace('void main() {', 'void main() {\\n x;')", &[]);
    check_shaders("if (s === '#version 300 es') {}", &[]);
    check_shaders("s = '#version 300 es\\n' + x;", &[]);
    check_shaders("throw new Error('no void main() { in it')", &[]);
    check_shaders("const a = 'float f(float b) { return b; }';", &[]);
    let part = "float f(float b) { return b; }";
    check_shaders(&format!("const aFrag = '{part}';"), &[part]);
    let clear = "vec3 f(vec2 b) { return vec3(b, 1.); }";
    check_shaders(&format!("a('{clear}');"), &[clear]);
}

/// A text of another language, in which a value that nothing is known of has no width.
#[test]
fn holes_without_width_are_allowed() {
    let script = "const lines = ['#usda 1.0', '{'];\nlines.push('    matrix4d m = ' + f(a));\n\
        lines.push('    float inputs = ' + (b ?? 0));\nlines.push('}');\ng(lines.join('\\n'));\n";
    extract(DocumentLanguage::Script, script);
}

/// A tag without an end must not be read to the end of the file for each `<`.
#[test]
fn components_in_templates_are_code_up_to_a_limit() {
    let code = |filler: usize| {
        let text = format!(
            "<template>\n<A :x=\"b\" {}/>\n</template>",
            " ".repeat(filler)
        );
        script_code(DocumentLanguage::Component, &text).unwrap()
    };
    assert_eq!(code(0).trim(), ";()=><A  x={b} />;");
    assert!(code(7_900).contains("<A"));
    assert_eq!(code(8_000).trim(), "");
}

#[test]
fn text_that_the_script_trims_is_trimmed() {
    check_shaders("s = `\n#version 300 es\nx`.trim()", &["#version 300 es\nx"]);
    check_shaders(
        "s = `\n#version 300 es\nx`.slice(1)",
        &["#version 300 es\nx"],
    );
    check_shaders("s = `\n#version 300 es\nx`", &["\n#version 300 es\nx"]);
}

/// Checks the lists of a script that hold a path, separated by `|`; `?` is an unknown text.
#[track_caller]
fn check_lists(script: &str, expected: &str) {
    let all = lists(DocumentLanguage::Script, script).into_iter();
    let shown = all.map(|list| {
        let texts = list.into_iter().map(|text| text.unwrap_or("?".to_string()));
        texts.collect::<Vec<_>>().join(" ")
    });
    let shown: Vec<String> = shown.filter(|list| list.contains(".frag")).collect();
    assert_eq!(shown.join(" | "), expected, "{script}");
}

#[test]
fn lists_of_loaded_imported_and_named_texts_are_found() {
    check_lists("['a.frag', `b.frag`].map(load)", "a.frag b.frag");
    check_lists("link('c.vert', ['a.frag', 'b.frag'])", "a.frag b.frag");
    check_lists("import a from './a.frag'; [a, b].join('')", "./a.frag ?");
    check_lists(
        "const p = 'lib/', a = await load(gl, p + 'a.frag', 'utf8'); s = a + load('b.frag');",
        "lib/ a.frag | lib/a.frag b.frag",
    );
    check_lists(
        "[fetch('a.frag').then((r) => r.text()), fetch('b.frag', {})]",
        "a.frag b.frag",
    );
    check_lists(
        "s = `${load('a.frag')}${require('b.frag')}`",
        "a.frag b.frag",
    );
}

/// Checks the groups of shaders in a script; each shader is `void main() { NAME; }`.
#[track_caller]
fn check_pairs(text: &str, expected: &str) {
    let language = if text.starts_with('<') {
        DocumentLanguage::Html
    } else {
        DocumentLanguage::Script
    };
    let all = extract(language, text);
    let name = |i: &usize| all[*i].code.split(['{', ';']).nth(1).unwrap().trim();
    let groups = together(language, text, &all);
    let groups: Vec<String> = groups
        .iter()
        .map(|g| g.iter().map(name).collect::<Vec<_>>().join("+"))
        .collect();
    assert_eq!(groups.join(" "), expected, "{text}");
}

#[test]
fn shaders_used_by_the_same_call_are_paired() {
    check_pairs(
        "const v = `void main() { a; }`; const f = \"void main() { b; }\"; link(gl, v, f);",
        "a+b",
    );
    check_pairs(
        "x({ vertexShader: `void main() { a; }`, fragmentShader: glsl`void main() { b; }` });\
         x({ vertexShader: `void main() { c; }`, fragmentShader: `void main() { d; }` });",
        "a+b c+d",
    );
    check_pairs(
        "const v = `void main() { a; }`, f = `void main() { b; }`; x.v = f; x({ v: 1, f });",
        "",
    );
    check_pairs(
        "<script type=\"x-shader/x-vertex\" id=\"v\">void main() { a; }</script>\
         <script type=\"x-shader/x-fragment\" id=\"f\">void main() { b; }</script>\
         <script>link(get('v'), document.querySelector('#f'));</script>",
        "a+b",
    );
}

/// Marks the mentions of `name` in a script: `<name>`, `+name+` for shorthands, `?name?` for
/// unclear ones.
#[track_caller]
fn check_mentions(role: NameRole, marked: &str) {
    let text = marked.replace(['<', '>', '+', '?'], "");
    let mut shown = text.clone();
    let mut all = mentions(DocumentLanguage::Script, &text, "name", role);
    all.reverse();
    for mention in all {
        let (open, close) = match mention.kind {
            MentionKind::Name | MentionKind::Edited => ("<", ">"),
            MentionKind::Shorthand => ("+", "+"),
            MentionKind::Unclear => ("?", "?"),
        };
        shown.insert_str(mention.range.end, close);
        shown.insert_str(mention.range.start, open);
    }
    assert_eq!(shown, marked);
}

#[test]
fn names_of_inputs_are_found_in_scripts() {
    let input = |text| check_mentions(NameRole::Input, text);
    input("const name = gl.getUniformLocation(p, '<name>'); use(name); // name");
    input("gl.getUniformLocation(p, `<name>[0].color`); a['names']; 'name this';");
    input("m({ uniforms: { <name>: { value: name }, other: name } }); f({ ?name?: 1 });");
    input("m({ uniforms: { +name+ } }); m({ uniforms: { a, +name+, '<name>': name } });");
    input("material.uniforms.<name>.value = 1; uniforms['<name>'] = name; mesh.?name?.x = 2;");
    input("gl.transformFeedbackVaryings(p, ['a', '<name>'], 1); shader.setUniform('<name>', 1);");
    input("log('?name?'); const { ?name? } = uniforms; call(a, name);");
}

#[test]
fn optional_members_updates_and_elements_refer_to_inputs() {
    let text = "c = uniforms?.name.value; uniforms.name++; a = <Quad uniforms={{ name: 1 }} />;\
        b = `x${name};`; function f({ uniforms }) {}";
    let all = mentions(DocumentLanguage::Script, text, "name", NameRole::Input);
    let found = all.iter().map(|m| (&text[m.range.clone()], m.kind));
    let expected = [("name", MentionKind::Name); 3];
    assert_eq!(found.collect::<Vec<_>>(), expected);
}

#[test]
fn calls_are_found_in_scripts_that_cannot_be_parsed() {
    let deep = "(".repeat(300);
    for rest in ["", "}", &deep] {
        let text = format!("gl.shaderSource(s, t.trim()); // gl.shaderSource\n{rest}");
        let found = Embedder::of(DocumentLanguage::Script, &text);
        assert!(found.hands_over, "{rest}");
        assert_eq!(found.leading_blanks, LeadingBlanks::Trimmed, "{rest}");
    }
    let comment = "// gl.shaderSource(s, t)\nconst a = 'gl.shaderSource(s, t)';";
    let found = Embedder::of(DocumentLanguage::Script, comment);
    assert_eq!(found, Embedder::default());
}

#[test]
fn names_in_edited_shader_texts_are_found() {
    let inner = |text| check_mentions(NameRole::Inner, text);
    inner("s.replace('<name>', 'x').replaceAll(/\\b<name>\\b/g, `<name> * 2.0`);");
    inner("const part = 'float name2 = ?name?(1.0);'; log('name'); a.name = 1;");
}

#[track_caller]
fn check_context(script: &str, (one, two, is_all): (bool, bool, bool), words: &[&str]) {
    let found = AskedWebGl::of(DocumentLanguage::Script, script);
    assert_eq!(
        (found.one, found.two, found.is_all),
        (one, two, is_all),
        "{script}"
    );
    assert_eq!(found.words, words, "{script}");
}

#[test]
fn contexts_and_extensions_are_read_from_scripts() {
    let lod = ["EXT_shader_texture_lod"];
    check_context(
        "const gl = c.getContext('webgl'); gl.getExtension('EXT_shader_texture_lod'); gl.shaderSource(s, f);",
        (true, false, true),
        &lod,
    );
    check_context(
        "const gl = c.getContext('webgl2') || c.getContext('webgl');",
        (true, true, false),
        &[],
    );
    check_context(
        "const gl = ['webgl2', 'webgl'].map((kind) => c.getContext(kind)).find(Boolean);",
        (true, true, false),
        &[],
    );
    check_context(
        "import { f } from './f.js'; const gl = c.getContext('webgl'); f(gl); gl.shaderSource(s, f);",
        (true, false, false),
        &[],
    );
    check_context(
        "const gl = c.getContext('webgl'); gl.shaderSource(s, f); all.forEach((e) => gl.getExtension(e));",
        (true, false, false),
        &[],
    );
    check_context(
        "const draw = regl({ extensions: ['EXT_shader_texture_lod'] });",
        (false, false, false),
        &lod,
    );
}

#[test]
fn only_the_scripts_of_a_page_are_read() {
    let page = "<p>getContext('webgl2')</p><script>c.getContext('webgl').shaderSource()</script>";
    let found = AskedWebGl::of(DocumentLanguage::Html, page);
    assert_eq!((found.one, found.two, found.is_all), (true, false, true));
    let page = "<script src=gl.js></script><script>c.getContext('webgl').shaderSource()</script>";
    assert!(!AskedWebGl::of(DocumentLanguage::Html, page).is_all);
}

#[test]
fn shaders_are_found_in_elements_and_scripts() {
    let text = "<!-- <script type='x-shader/x-fragment'>no</script> -->\
        <SCRIPT id=\"a>b\" type=\"x-shader/x-vertex\">\nvoid f() {}</script>\
        <script>x = `#version 300 es\nvoid main() {}`;</script>\
        <script type=\"application/json\">{\"a\": 1}</script>";
    let all = extract(DocumentLanguage::Html, text);
    let codes: Vec<&str> = all.iter().map(|s| s.code.as_str()).collect();
    assert_eq!(codes, ["\nvoid f() {}", "#version 300 es\nvoid main() {}"]);
    for shader in &all {
        assert_eq!(
            text.get(shader.start..shader.end()),
            Some(shader.code.as_str())
        );
    }
    assert_eq!(all[0].stage, Some(NamedStage::Vertex));
    assert_ne!(all[1].stage, all[0].stage);
}

#[test]
fn leading_newlines_are_dropped_if_the_page_trims_them() {
    let text = "<script type='x-shader/x-fragment'>\n#version 300 es\n</script>\
        <script>s(document.querySelector('script').textContent.trim())</script>";
    assert!(
        extract(DocumentLanguage::Html, text)[0]
            .code
            .starts_with("#version")
    );
}

/// Joins the shaders of a page with `|`.
#[track_caller]
fn check_listings(text: &str, expected: &str) {
    let found = extract(DocumentLanguage::Html, text);
    for shader in &found {
        assert!(text.get(shader.start..shader.end()).is_some());
    }
    let codes: Vec<String> = found.into_iter().map(|s| s.code).collect();
    assert_eq!(codes.join("|"), expected, "{text}");
}

#[test]
fn decoded_entities_keep_their_width() {
    check_listings(
        "<pre class='language-glsl'>a&lt;b&amp;&amp;c&gt;=d;</pre>",
        "a   <b        &&c   >=d;",
    );
    check_listings(
        "<PRE><code lang=glsl>a&#39;&#x3C;&copy;;</code></PRE>",
        "a         '<&copy;;",
    );
}

#[test]
fn glsl_elements_are_found_by_class_or_content() {
    check_listings(
        "<textarea>void main() { gl_FragColor = vec4(1 &lt; 2); }</textarea>",
        "void main() { gl_FragColor = vec4(1    < 2); }",
    );
    check_listings(
        "<code class=\"glsl\"><span class='k'>float</span> a;</code>",
        "                float        a;",
    );
    check_listings(
        "<code class='glsl'>vec3</code><pre>void main() in C</pre>",
        "",
    );
    check_listings(
        "<pre class='language-c'>void main() { vec3(vec2(1)); }</pre>",
        "",
    );
    check_listings("<script><pre class='glsl'>a;</pre></script>", "");
}
