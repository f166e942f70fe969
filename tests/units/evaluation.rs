//! What is known of the values of a script without running it: each script calls `show` with some.

use shaderlint::script::{
    EventCertainty, EventKind, ExternalScript, Loader, ObjectKind, Primitive, ScriptValue, World,
    evaluate,
};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The modules of the program `main.js`.
struct ProgramModules(&'static [(&'static str, &'static str)]);

impl Loader for ProgramModules {
    fn load(&self, path: &str, _from: &Path) -> Option<(PathBuf, Arc<str>)> {
        let (name, text) = self.0.iter().find(|(name, _)| *name == path)?;
        Some((PathBuf::from(name), (*text).into()))
    }

    fn script(&self, path: &Path, text: &str) -> Option<String> {
        path.extension()?
            .to_str()?
            .starts_with('j')
            .then(|| text.to_string())
    }

    fn element(&self, _text: &str, _id: &str) -> Option<(Range<usize>, String)> {
        None
    }

    fn scripts(&self, _path: &Path, _text: &str) -> Vec<ExternalScript> {
        Vec::new()
    }
}

/// A value in short: `?` for what is not known.
fn shown(world: &World, value: &ScriptValue) -> String {
    match value {
        ScriptValue::Undefined => "undefined".to_string(),
        ScriptValue::Null => "null".to_string(),
        ScriptValue::Bool(flag) => flag.to_string(),
        ScriptValue::Number(number) => number.to_string(),
        ScriptValue::Text(text) if text.is_open => format!("'{}'?", text.content),
        ScriptValue::Text(text) => format!("'{}'", text.content),
        ScriptValue::Any(Primitive::Number) => "number".to_string(),
        ScriptValue::Any(Primitive::Text) => "text".to_string(),
        ScriptValue::Any(Primitive::Bool) => "boolean".to_string(),
        ScriptValue::Object(id) => {
            let object = world.object(*id).unwrap();
            let more = if object.is_open { ", ?" } else { "" };
            match &object.kind {
                ObjectKind::Array(all) => {
                    let all: Vec<String> = all.iter().map(|v| shown(world, v)).collect();
                    format!("[{}{more}]", all.join(", "))
                }
                ObjectKind::Plain => {
                    let all = object.properties.iter();
                    let all: Vec<String> = all
                        .map(|p| format!("{}: {}", p.key, shown(world, &p.value)))
                        .collect();
                    format!("{{{}{more}}}", all.join(", "))
                }
                _ => "?".to_string(),
            }
        }
    }
}

/// What a program shows.
fn run(modules: &'static [(&'static str, &'static str)], text: &str) -> String {
    let read = |world: &World| {
        let calls = world.events.iter().filter_map(|event| match &event.kind {
            EventKind::Call(call) if &*call.name == "show" => {
                let values = call.arguments.iter().map(|(value, _)| shown(world, value));
                let mark = match event.certainty {
                    EventCertainty::Sure => "",
                    EventCertainty::Guarded => "if ",
                    EventCertainty::Alternative => "or ",
                };
                Some(format!("{mark}{}", values.collect::<Vec<_>>().join(" ")))
            }
            _ => None,
        });
        calls.collect::<Vec<_>>().join("; ")
    };
    evaluate((Path::new("main.js"), text), &ProgramModules(modules), read).unwrap()
}

/// Scripts with what they show.
const SCRIPTS: &[(&str, &str)] = &[
    ("show(1 + 2 * 3, 'a' + 1, `x${2}y`)", "7 'a1' 'x2y'"),
    (
        "const { a, ...r } = { a: 1, b: 2, c: 3 }; show(a, r)",
        "1 {b: 2, c: 3}",
    ),
    ("const [x, , y = 9] = [1, 2]; show(x, y)", "1 9"),
    (
        "show({ ...{ a: 1 }, b: 2 }, { ...other, b: 2 })",
        "{a: 1, b: 2} {b: 2, ?}",
    ),
    (
        "show([1, 2].map((x) => x * 2), ['a', 'b'].join('-'))",
        "[2, 4] 'a-b'",
    ),
    (
        "show(Object.entries({ a: 1 }), Object.fromEntries([['k', 2]]))",
        "[['a', 1]] {k: 2}",
    ),
    (
        "show('a b'.replace('a', 'c').split(' '), ' x '.trim())",
        "['c', 'b'] 'x'",
    ),
    (
        "show(location.href, Math.sin(1), !location, typeof 1)",
        "? number boolean 'number'",
    ),
    // Functions, classes and what is done later.
    (
        "function f(n, m = n) { return n + m; } show(f(2), f(1, 5))",
        "4 6",
    ),
    (
        "class A { n = 1; get two() { return this.n * 2; } } show(new A().two)",
        "2",
    ),
    (
        "class A { constructor(n) { this.n = n; } } class B extends A { constructor() { super(3); } } show(new B().n)",
        "3",
    ),
    (
        "class L extends Library { constructor() { super(); this.n = 1; } } show(new L().n)",
        "1",
    ),
    ("setTimeout(() => show(x)); let x = 5;", "5"),
    ("export function never(n) { show(n, 1); }", "? 1"),
    // Loops, known and unknown.
    (
        "let s = 0; for (let i = 0; i < 4; i++) s += i; show(s)",
        "6",
    ),
    ("let s = 0; for (const x of [1, 2]) s += x; show(s)", "3"),
    ("let s = 0; for (const x of list) s += 1; show(s)", "number"),
    ("let s = 0; while (more()) { s++; show(s); }", "if number"),
    // Conditions that are not known.
    ("let a = 1; if (c) a = 2; show(a)", "number"),
    ("let a; if (c) a = 2; show(a)", "2"),
    ("if (c) show(1); else show(2)", "or 1; or 2"),
    ("if (c) show(1)", "if 1"),
    (
        "function f() { if (c) { show(1); return; } show(2); } f()",
        "or 1; 2",
    ),
    (
        "const a = c ? 1 : 1, b = c ? 'x' : 'y'; show(a, b)",
        "1 ''?",
    ),
    (
        "const o = { a: 1 }; if (c) o.b = 2; show(o)",
        "{a: 1, b: 2}",
    ),
    ("const o = { a: 1 }; o[key] = 2; show(o)", "{a: 1, ?}"),
    (
        "switch (2) { case 1: show(1); break; case 2: show(2); break; default: show(3); }",
        "2",
    ),
    (
        "switch (c) { case 1: show(1); break; case 2: show(2); }",
        "or 1; or 2",
    ),
    ("try { show(1); } catch { show(2); }", "1; if 2"),
];

#[test]
fn scripts_are_evaluated_without_running_them() {
    for (text, expected) in SCRIPTS {
        assert_eq!(run(&[], text), *expected, "{text}");
    }
}

#[test]
fn modules_are_followed() {
    const MODULES: &[(&str, &str)] = &[
        (
            "./a.js",
            "export const a = 1; export default function f() { return 2; }",
        ),
        (
            "./b.js",
            "export * from './a.js'; export { a as c } from './a.js'; import './main.js';",
        ),
        ("./c.js", "module.exports = { d: 4 };"),
        ("./s.frag", "void main() {}"),
    ];
    for (text, expected) in [
        ("import f, { a } from './a.js'; show(a, f())", "1 2"),
        ("import * as b from './b.js'; show(b.a, b.c)", "1 1"),
        ("const { d } = require('./c.js'); show(d)", "4"),
        (
            "import source from './s.frag'; show(source)",
            "'void main() {}'",
        ),
        ("import x from './missing.js'; show(x)", "?"),
        ("const m = await import('./a.js'); show(m.a)", "1"),
    ] {
        assert_eq!(run(MODULES, text), expected, "{text}");
    }
}

#[test]
fn endless_programs_end() {
    for text in [
        "function f() { f(); f(); f(); } f(); show(1)",
        "while (true) { show(1); }",
        "for (let i = 0; i < 1e9; i++) { for (let j = 0; j < 1e9; j++) { x(i, j); } } show(1)",
        "function f(n) { return { a: [g(() => f(n + 1))] }; } const g = (h) => h(); f(0); show(1)",
        "const o = {}; o.o = o; show(JSON.stringify(o), 1)",
    ] {
        assert!(run(&[], text).contains('1'), "{text}");
    }
}
