//! Generates pairs of stages: every kind of interface item, identical in both stages or different
//! in one aspect, used or not. Each pair is printed as a line of JSON with shaderlint's verdict, so
//! that a browser can be compared: `{"id", "vertex", "fragment", "compiles", "links", "why"}`.

use crate::mutate::Random;
use shaderlint::diagnostic::Severity;
use shaderlint::explain::analyze;
use shaderlint::explain::link::link;
use shaderlint::semantic::{Completeness, Dialect, Stage, Unit};
use shaderlint::syntax::GlContext;
use shaderlint::text::{Role, Sources};
use std::sync::Arc;

/// Prints `count` pairs.
pub fn print(seed: u64, count: usize) {
    let mut random = Random::new(seed);
    for number in 0..count {
        let (vertex, fragment) = pair(&mut random);
        let (compiles, why) = check_pair(&vertex, &fragment);
        println!(
            "{{\"id\": \"{seed}-{number}\", \"vertex\": {vertex:?}, \"fragment\": {fragment:?}, \
             \"compiles\": {compiles}, \"links\": {}, \"why\": {:?}}}",
            compiles && why.is_empty(),
            why.join("; ")
        );
    }
}

/// Whether both stages compile, and the link errors.
pub fn check_pair(vertex: &str, fragment: &str) -> (bool, Vec<String>) {
    let mut sources = Sources::new();
    let mut add = |name: &str, text: &str| sources.add(name, None, Role::User, text);
    let (Some(vert), Some(frag)) = (add("a.vert", vertex), add("a.frag", fragment)) else {
        return (false, Vec::new());
    };
    let sources = Arc::new(sources);
    let files = [[vert], [frag]];
    let of = |files, stage| {
        let analysis = analyze(&Unit {
            sources: &sources,
            files,
            stage,
            dialect: Dialect::WebGl,
            context: GlContext::WEBGL2,
            infer_channels: false,
            completeness: Completeness::Complete,
        });
        let mut all = analysis.diagnostics.iter();
        let is_well = !all.any(|d| d.severity == Severity::Error);
        is_well.then_some(analysis.program)
    };
    let Some(vertex) = of(&files[0], Stage::Vertex) else {
        return (false, Vec::new());
    };
    let Some(fragment) = of(&files[1], Stage::Fragment) else {
        return (false, Vec::new());
    };
    let found = link(&vertex, &fragment);
    (true, found.into_iter().map(|d| d.message).collect())
}

/// The declarations and the body of one stage.
#[derive(Default)]
struct Text {
    declarations: String,
    body: String,
}

fn pair(random: &mut Random) -> (String, String) {
    let is_300 = random.below(3) > 0;
    let mut vertex = Text::default();
    let mut fragment = Text::default();
    for stage in [&mut vertex, &mut fragment] {
        for ty in ["float", "int"] {
            if random.below(3) == 0 {
                let precision = ["lowp", "mediump", "highp"][random.below(3)];
                stage.declarations += &format!("precision {precision} {ty};\n");
            }
        }
    }
    if !fragment.declarations.contains("float") {
        fragment.declarations += "precision highp float;\n";
    }
    for number in 0..1 + random.below(3) {
        let kind = random.below(if is_300 { 6 } else { 4 });
        match kind {
            0 | 1 => varying(random, is_300, number, &mut vertex, &mut fragment),
            2 => uniform(random, is_300, number, &mut vertex, &mut fragment),
            3 if is_300 => attributes(random, number, &mut vertex),
            3 => builtins(random, &mut vertex, &mut fragment),
            4 => block(random, number, &mut vertex, &mut fragment),
            _ => uniform(random, is_300, number, &mut vertex, &mut fragment),
        }
    }
    let version = |is_300: bool| if is_300 { "#version 300 es\n" } else { "" };
    let other = random.below(40) == 0;
    let complete = |text: Text, head: &str| {
        let Text { declarations, body } = text;
        format!("{head}{declarations}void main() {{\n{body}}}\n")
    };
    (
        complete(vertex, version(is_300)),
        complete(fragment, version(is_300 != other)),
    )
}

/// A declaration, as its keywords and names.
#[derive(Clone)]
struct Words {
    invariant: bool,
    interpolation: &'static str,
    precision: &'static str,
    ty: String,
    name: String,
    array: usize,
    /// The struct declared before it: its name and members.
    record: Option<(String, Vec<Words>)>,
}

const PRECISIONS: [&str; 4] = ["", "lowp ", "mediump ", "highp "];

impl Words {
    fn random(random: &mut Random, types: &[&str], name: &str) -> Words {
        let ty = types[random.below(types.len())].to_string();
        Words {
            invariant: false,
            interpolation: "",
            precision: if ty.starts_with('b') {
                ""
            } else {
                PRECISIONS[random.below(4)]
            },
            ty,
            name: name.to_string(),
            array: [0, 0, 0, 1, 2, 3][random.below(6)],
            record: None,
        }
    }

    /// Replaces the type by a new struct; sometimes that contains another struct.
    fn with_record(mut self, random: &mut Random, types: &[&str], depth: u32) -> Words {
        let members = (0..1 + random.below(3)).map(|i| {
            let member = Words::random(random, types, &format!("m{i}"));
            if depth > 0 && random.below(3) == 0 {
                member.with_record(random, types, depth - 1)
            } else {
                member
            }
        });
        let members = members.collect();
        self.ty = format!("S{}{depth}", self.name);
        self.precision = "";
        self.record = Some((self.ty.clone(), members));
        self
    }

    fn change(&mut self, random: &mut Random, types: &[&str]) {
        match (random.below(8), &mut self.record) {
            (0 | 1, None) => self.ty = types[random.below(types.len())].to_string(),
            (2 | 3, None) => self.precision = PRECISIONS[random.below(4)],
            (0 | 1, Some((_, members))) => {
                let at = random.below(members.len());
                members[at].change(random, types);
            }
            (2, Some((_, members))) => members.reverse(),
            (3, Some((_, members))) => drop(members.pop()),
            (4, Some((name, _))) => {
                name.push('x');
                self.ty = name.clone();
            }
            (4 | 5, _) => self.array = (self.array + 1) % 3,
            (6, _) => self.name.push('x'),
            (_, _) => {}
        }
    }

    fn records(&self) -> String {
        let Some((name, members)) = &self.record else {
            return String::new();
        };
        let inner: String = members.iter().map(Words::records).collect();
        let fields: String = members.iter().map(|m| format!("{}; ", m.plain())).collect();
        format!("{inner}struct {name} {{ {fields}}};\n")
    }

    fn plain(&self) -> String {
        let array = match self.array {
            0 => String::new(),
            n => format!("[{n}]"),
        };
        format!("{}{} {}{array}", self.precision, self.ty, self.name)
    }

    fn declare(&self, storage: &str) -> String {
        let invariant = if self.invariant { "invariant " } else { "" };
        let interpolation = self.interpolation;
        format!(
            "{}{invariant}{interpolation}{storage} {};\n",
            self.records(),
            self.plain()
        )
    }
}

fn varying(
    random: &mut Random,
    is_300: bool,
    number: usize,
    vertex: &mut Text,
    fragment: &mut Text,
) {
    let floats = ["float", "vec2", "vec3", "vec4", "mat2", "mat3", "mat4"];
    let all = [
        "float", "vec2", "vec4", "mat2x3", "mat4", "int", "ivec2", "uint", "uvec3",
    ];
    let types: &[&str] = if is_300 && random.below(2) == 0 {
        &all
    } else {
        &floats
    };
    let mut given = Words::random(random, types, &format!("v{number}"));
    if is_300 && random.below(4) == 0 {
        given.array = 0;
        given = given.with_record(random, &floats, 0);
        if let Some((_, members)) = &mut given.record {
            members.iter_mut().for_each(|m| m.array = 0);
        }
    }
    if is_300 {
        let is_integer = given.ty.contains('i') || given.ty.starts_with('u');
        let words = [
            "",
            "",
            "flat ",
            "smooth ",
            "centroid ",
            "flat centroid ",
            "smooth centroid ",
        ];
        given.interpolation = if is_integer {
            "flat "
        } else {
            words[random.below(7)]
        };
    } else {
        given.invariant = random.below(4) == 0;
    }
    let mut read = given.clone();
    match random.below(6) {
        0 | 1 => read.change(random, types),
        2 if is_300 => read.interpolation = ["", "flat ", "centroid "][random.below(3)],
        2 => read.invariant = !read.invariant,
        _ => {}
    }
    let (out, into) = if is_300 {
        ("out", "in")
    } else {
        ("varying", "varying")
    };
    if random.below(8) > 0 {
        vertex.declarations += &given.declare(out);
        if random.below(2) == 0 {
            vertex.body += &format!("    {};\n", given.name);
        }
    }
    fragment.declarations += &read.declare(into);
    match random.below(5) {
        0 => {}
        1 => fragment.body += &format!("    if (false) {{ {}; }}\n", read.name),
        2 => fragment.declarations += &format!("void f{number}() {{ {}; }}\n", read.name),
        _ => fragment.body += &format!("    {};\n", read.name),
    }
}

fn uniform(
    random: &mut Random,
    is_300: bool,
    number: usize,
    vertex: &mut Text,
    fragment: &mut Text,
) {
    let old = [
        "float",
        "vec3",
        "mat4",
        "int",
        "ivec2",
        "bool",
        "bvec2",
        "sampler2D",
        "samplerCube",
    ];
    let new = [
        "float",
        "vec2",
        "mat3x2",
        "uint",
        "int",
        "uvec4",
        "bool",
        "sampler2D",
        "mat2",
    ];
    let types: &[&str] = if is_300 { &new } else { &old };
    let mut one = Words::random(random, types, &format!("u{number}"));
    if random.below(3) == 0 {
        one = one.with_record(random, types, 1);
    }
    let mut other = one.clone();
    if random.below(2) == 0 {
        other.change(random, types);
    }
    for (stage, words) in [(vertex, one), (fragment, other)] {
        if random.below(12) == 0 {
            continue;
        }
        stage.declarations += &words.declare("uniform");
        if random.below(3) > 0 {
            stage.body += &format!("    {};\n", words.name);
        }
    }
}

fn block(random: &mut Random, number: usize, vertex: &mut Text, fragment: &mut Text) {
    let types = ["float", "vec3", "mat4", "mat2x3", "int", "uint", "bool"];
    let mut head = [
        "",
        "layout(std140) ",
        "layout(row_major) ",
        "layout(std140, row_major) ",
    ][random.below(4)];
    let mut instance = [0, 0, 1, 2, 3][random.below(5)];
    let mut words =
        Words::random(random, &types, &format!("b{number}")).with_record(random, &types, 1);
    let mut inner = ["", "", "layout(row_major) ", "layout(column_major) "][random.below(4)];
    let change = random.below(8);
    for (is_fragment, stage) in [(false, vertex), (true, fragment)] {
        if is_fragment {
            match change {
                0 | 1 => words.change(random, &types),
                2 => head = ["", "layout(column_major) ", "layout(row_major) "][random.below(3)],
                3 => instance = (instance + 1) % 4,
                4 => inner = ["", "layout(row_major) "][random.below(2)],
                _ => {}
            }
        }
        if random.below(12) == 0 {
            continue;
        }
        let Some((_, members)) = &words.record else {
            continue;
        };
        let records: String = members.iter().map(Words::records).collect();
        let fields: String = members
            .iter()
            .enumerate()
            .map(|(i, m)| format!("{}{}; ", if i == 0 { inner } else { "" }, m.plain()))
            .collect();
        let name = &words.name;
        let (after, first) = match instance {
            0 => (String::new(), String::new()),
            1 => (format!(" i{name}"), format!("i{name}.")),
            n => (format!(" i{name}[{n}]"), format!("i{name}[0].")),
        };
        // Members of blocks without an instance name are global: usually each name is unique.
        let (fields, own) = if instance == 0 && random.below(6) > 0 {
            (
                fields.replace(" m", &format!(" g{number}m")),
                format!("g{number}"),
            )
        } else {
            (fields, String::new())
        };
        stage.declarations += &format!("{records}{head}uniform B{name} {{ {fields}}}{after};\n");
        if let Some(member) = members.first().filter(|_| random.below(2) == 0) {
            stage.body += &format!("    {first}{own}{};\n", member.name);
        }
    }
}

fn attributes(random: &mut Random, number: usize, vertex: &mut Text) {
    for i in 0..[1, 2, 3, 17][random.below(4)] {
        let ty = ["float", "vec4", "mat2", "mat4", "mat3x2"][random.below(5)];
        let location = match random.below(3) {
            0 => format!("layout(location = {}) ", random.below(16)),
            _ => String::new(),
        };
        vertex.declarations += &format!("{location}in {ty} a{number}_{i};\n");
    }
}

fn builtins(random: &mut Random, vertex: &mut Text, fragment: &mut Text) {
    if vertex.body.contains("gl_Position") || fragment.body.contains("gl_FragCoord") {
        return;
    }
    let lines = [
        "invariant gl_Position;\n",
        "#pragma STDGL invariant(all)\n",
        "invariant gl_PointSize;\n",
        "",
    ];
    vertex.declarations += lines[random.below(4)];
    let lines = [
        "invariant gl_FragCoord;\n",
        "invariant gl_PointCoord;\n",
        "",
    ];
    fragment.declarations += lines[random.below(3)];
    for (stage, lines) in [(vertex, VERTEX), (fragment, FRAGMENT)] {
        stage.body += lines[random.below(lines.len())];
    }
}

const VERTEX: [&str; 3] = [
    "    gl_Position = vec4(0.0);\n",
    "    gl_PointSize = 1.0;\n",
    "",
];
const FRAGMENT: [&str; 3] = [
    "    gl_FragCoord;\n",
    "    gl_FragColor = gl_FragCoord;\n",
    "    gl_FragColor.xy += gl_PointCoord;\n",
];
