//! One question has one answer: every command and protocol opens the same project.
//!
//! Each row is a project with one call of `glow`. As it is, nothing reports an error. With the call
//! misspelt, every front reports the error at the same place of the same file.

use super::scratch::{Ran, Scratch};
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

/// A project, and what is opened of it.
#[derive(Deserialize)]
struct Row {
    name: String,
    files: BTreeMap<String, String>,
    /// The file or folder that is opened.
    open: String,
    /// The file and the line of the call.
    call: (String, u32),
}

/// The rows, which the tests of the module for WebAssembly read, too.
fn rows() -> Vec<Row> {
    serde_json::from_str(include_str!("opening.json")).unwrap()
}

const GLOW: &str = "float glow(float x) { return sin(x); }\n";
const SHOWS: &str =
    "void mainImage(out vec4 c, in vec2 p) {\n    c = texture(iChannel0, p / iResolution.xy);\n}\n";

impl Row {
    /// The project with the call misspelt, or as it is.
    fn scratch(&self, is_broken: bool) -> Scratch {
        let files = self.files.iter();
        let files: Vec<(&str, &str)> = files.map(|(path, text)| (&**path, &**text)).collect();
        let scratch = Scratch::new(&files);
        let (file, _) = &self.call;
        if is_broken {
            let text = scratch.read(file);
            let at = text.rfind("glow(").unwrap();
            scratch.write(file, format!("{}glowx{}", &text[..at], &text[at + 4..]));
        }
        scratch
    }

    fn is_folder(&self) -> bool {
        !self.open.contains('.')
    }
}

/// A command or protocol that opens a project: its name, and how it answers.
type Front = (&'static str, fn(&Scratch, &str) -> Ran);

const FRONTS: &[Front] = &[
    ("check", |at, open| at.run(&[open, "--format", "short"])),
    ("fix", |at, open| {
        at.run(&["--fix", open, "--format", "short"])
    }),
    ("run", |at, open| at.run(&["run", open, "--size", "16x9"])),
    ("test", |at, open| at.run(&["test", open])),
    ("page", |at, open| {
        ported(at, &format!("{open} -o out/a.html"))
    }),
    ("module", |at, open| {
        ported(at, &format!("{open} -t module -o out/a.js"))
    }),
    ("text", |at, open| {
        ported(at, &format!("{open} -t glsl -o out"))
    }),
    ("debugger", debugged),
    ("preview", previewed),
];

fn ported(at: &Scratch, args: &str) -> Ran {
    let out = at.port_command(args).output().unwrap();
    Ran {
        code: out.status.code().unwrap(),
        out: String::from_utf8(out.stdout).unwrap(),
        err: String::from_utf8(out.stderr).unwrap(),
    }
}

/// Messages of a protocol with a header before each.
fn framed(messages: &[Value]) -> String {
    let framed = messages.iter().map(|message| {
        let text = message.to_string();
        format!("Content-Length: {}\r\n\r\n{text}", text.len())
    });
    framed.collect()
}

fn debugged(at: &Scratch, open: &str) -> Ran {
    let request = |seq: u32, command: &str, arguments: Value| json!({"seq": seq, "type": "request", "command": command, "arguments": arguments});
    let launch = json!({"program": at.path(open), "pixel": [1, 1], "size": [16, 9]});
    at.pipe(
        &framed(&[
            request(1, "initialize", json!({"adapterID": "shaderlint"})),
            request(2, "launch", launch),
            request(3, "configurationDone", json!({})),
            request(4, "disconnect", json!({})),
        ]),
        &["dap"],
    )
}

fn previewed(at: &Scratch, open: &str) -> Ran {
    let uri = format!("file://{}", at.path(open).display());
    let ask = |id: u32, method: &str, params: Value| json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params});
    let tell =
        |method: &str, params: Value| json!({"jsonrpc": "2.0", "method": method, "params": params});
    let document = json!({"uri": uri, "languageId": "glsl", "version": 1, "text": at.read(open)});
    let root = format!("file://{}", at.path("").display());
    let mut server = at.command(&["lsp"]);
    let mut server = server
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = server.stdin.take().unwrap();
    let mut output = BufReader::new(server.stdout.take().unwrap());
    let asked = framed(&[
        ask(
            1,
            "initialize",
            json!({"rootUri": root, "capabilities": {}}),
        ),
        tell("initialized", json!({})),
        tell("textDocument/didOpen", json!({"textDocument": document})),
        ask(2, "shaderlint/page", json!({"textDocument": {"uri": uri}})),
    ]);
    input.write_all(asked.as_bytes()).unwrap();
    let answer = loop {
        let message = read_message(&mut output);
        if message["id"] == 2 {
            break message;
        }
    };
    let end = framed(&[ask(3, "shutdown", Value::Null), tell("exit", Value::Null)]);
    input.write_all(end.as_bytes()).unwrap();
    server.wait().unwrap();
    let message = &answer["error"]["message"];
    Ran {
        code: i32::from(!message.is_null()),
        out: message.to_string(),
        err: String::new(),
    }
}

fn read_message(from: &mut impl BufRead) -> Value {
    let mut length = 0;
    loop {
        let mut line = String::new();
        from.read_line(&mut line).unwrap();
        match line.trim().strip_prefix("Content-Length: ") {
            Some(number) => length = number.parse().unwrap(),
            None if line.trim().is_empty() => break,
            None => {}
        }
    }
    let mut body = vec![0; length];
    from.read_exact(&mut body).unwrap();
    serde_json::from_slice(&body).unwrap()
}

#[test]
fn every_front_opens_the_same_project() {
    let mut wrong = Vec::new();
    for row in &rows() {
        for (front, answer) in FRONTS {
            // A preview is of a document.
            if *front == "preview" && row.is_folder() {
                continue;
            }
            for is_broken in [false, true] {
                // Without tests and golden images, nothing of the file is run.
                if is_broken && *front == "test" {
                    continue;
                }
                let ran = answer(&row.scratch(is_broken), &row.open);
                let said = format!("{}{}", ran.out, ran.err);
                let (file, line) = (&*row.call.0, row.call.1);
                let is_named = said.contains("glowx") && said.contains(&place(front, file, line));
                // `test` finds no tests in most of them.
                let fails = ran.code == 1 || ran.code != 0 && *front != "test";
                if is_named != is_broken || !is_broken && fails {
                    let start = said.len().saturating_sub(700);
                    let short = said.get(start..).unwrap_or(&said);
                    wrong.push(format!(
                        "{}: {front}, broken: {is_broken}, code {}: {short}",
                        row.name, ran.code
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn uses_and_errors_of_a_file_are_those_of_its_project() {
    let mut wrong = Vec::new();
    for row in rows().iter().filter(|row| !row.is_folder()) {
        let scratch = row.scratch(false);
        let (file, line) = (&*row.call.0, row.call.1);
        let uses = scratch.run(&["references", file, "glow"]);
        // Editors have no language for projects of KodeLife.
        let is_code = !file.ends_with(".klproj");
        if is_code && !uses.out.contains(&format!("{file}:{line}:")) {
            wrong.push(format!(
                "{}: references: {}{}",
                row.name, uses.out, uses.err
            ));
        }
        let reduced = scratch.run(&["reduce", &row.open]);
        if !reduced.err.contains("no errors to keep") {
            wrong.push(format!(
                "{}: reduce: {}{}",
                row.name, reduced.out, reduced.err
            ));
        }
        let ir = scratch.run(&["ir", &row.open]);
        if !ir.out.contains("glow") {
            wrong.push(format!("{}: ir: {}{}", row.name, ir.out, ir.err));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn every_command_reports_the_same_of_a_project() {
    let scratch = Scratch::new(&[
        ("common.glsl", GLOW),
        (
            "lib/half.glsl",
            "float half_of(float x) { return 0.5 * x; }\n",
        ),
        ("image.glsl", SHOWS),
        (
            "buffer_a.glsl",
            concat!(
                "#include \"lib/half.glsl\"\n",
                "void mainImage(out vec4 c, in vec2 p) { c = vec4(half_of(glow(p.x))); }\n"
            ),
        ),
    ]);
    let expected = [
        "passes: image (image.glsl), common (common.glsl), buffer_a (buffer_a.glsl)",
        "also read: lib/half.glsl",
        "image.0 = buffer_a (the only buffer)",
    ];
    let asked: &[&[&str]] = &[
        &["-v", "image.glsl"],
        &["-v", "--fix", "image.glsl"],
        &["fmt", "-v", "--check", "image.glsl"],
        &["run", "-v", "image.glsl", "--size", "16x9"],
        &["test", "-v", "image.glsl"],
        &["reduce", "-v", "image.glsl"],
        &["references", "-v", "image.glsl", "mainImage"],
    ];
    let mut all: Vec<(String, String)> = Vec::new();
    for args in asked {
        all.push((args.join(" "), scratch.run(args).err));
    }
    let ported = ported(&scratch, "-v image.glsl -o a.html");
    all.push(("shaderport".to_string(), ported.err));
    for (command, said) in all {
        let says = |line: &&str| said.lines().any(|l| l.ends_with(*line));
        let missing = expected.iter().find(|line| !says(line));
        assert_eq!(missing, None, "{command}: {said}");
    }
}

/// How a front writes a place. A preview is of the document, and names only the line.
fn place(front: &str, file: &str, line: u32) -> String {
    match front {
        "preview" => format!("line {line}:"),
        _ => format!("{file}:{line}:"),
    }
}
