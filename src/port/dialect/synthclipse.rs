//! Synthclipse: complete fragment shaders with comments that define the controls of their uniforms.
//!
//! Source: the user guide of Synthclipse (synthclipse.sourceforge.net/user_guide/fragx: commands,
//! uniform_controls, build_in_uniforms, file_types). A uniform declaration may be followed by `//!
//! slider[min, value, max]`, `islider[...]`, `checkbox[true]`, `color[r, g, b]`, with `a` or `minA,
//! a, maxA` before or after it, `combobox[index, "name", ...]`, `direction[(x, y, z)]`, `rotation[x,
//! y, z]`, `texture["file", wrap: GL_REPEAT, filter: GL_NEAREST, mipmap: true]` or `buffer[xbuf: 0]`;
//! other comments `//! <...>` define presets, groups and post-processing.

use super::complete::completions_of;
use super::vscode::{numbers, quoted};
use super::{Clues, HostCode, Plan, Sign, sampled};
use crate::{ControlChoice, ControlKind, Input, InputKind, UniformControl};
use shaderlint_host::OWN;
use std::f64::consts::PI;

pub(super) static CODE: HostCode = HostCode {
    host: "synthclipse",
    signs,
    plan: Some(plan),
    declare: Some(declare),
};

fn signs(clues: &Clues) -> Vec<Sign> {
    let mut marks = clues.text.match_indices('!');
    let is_comment = |at: usize| {
        let before = clues.text.get(..at).unwrap_or("");
        before.ends_with("//") || before.ends_with("/*")
    };
    if !marks.any(|(at, _)| is_comment(at)) {
        return Vec::new();
    }
    let described = commands(clues.text).next();
    let sign = described.map(|c| Sign::new(format!("`//! {}[...]`", c.word), 2 * OWN));
    sign.into_iter().collect()
}

/// A command in the comment after a uniform.
struct UniformCommand<'t> {
    ty: &'t str,
    name: &'t str,
    word: &'t str,
    /// The text in its brackets.
    inside: &'t str,
}

const WORDS: [&str; 10] = [
    "slider",
    "islider",
    "checkbox",
    "color",
    "combobox",
    "direction",
    "rotation",
    "texture",
    "sampler",
    "buffer",
];

/// The uniforms with a command, each on its own line.
fn commands(text: &str) -> impl Iterator<Item = UniformCommand<'_>> {
    text.lines().filter_map(|line| {
        let (code, comment) = line.split_once("//!").or_else(|| line.split_once("/*!"))?;
        let mut words = code.trim().strip_suffix(';')?.split_whitespace();
        if words.next()? != "uniform" {
            return None;
        }
        let mut words = words.filter(|w| !["lowp", "mediump", "highp"].contains(w));
        let (ty, declarator) = (words.next()?, words.next()?);
        // An initial value may follow.
        let name = declarator.split('=').next()?;
        let (word, rest) = comment.trim_start().split_once('[')?;
        let (inside, _) = rest.rsplit_once(']')?;
        WORDS.contains(&word.trim()).then_some(UniformCommand {
            ty,
            name,
            word: word.trim(),
            inside,
        })
    })
}

fn declare(_: &str, at: usize, control: &UniformControl) -> Option<(usize, String)> {
    let ([min, value, max], is_int) = control.slider()?;
    let (ty, word) = match is_int {
        true => ("int", "islider"),
        false => ("float", "slider"),
    };
    let name = &control.name;
    let line = format!("uniform {ty} {name}; //! {word}[{min}, {value}, {max}]\n");
    Some((at, line))
}

fn plan(clues: &Clues) -> Plan {
    let mut plan = Plan::image(completions_of(clues));
    for command in commands(clues.text) {
        let UniformCommand {
            name, word, inside, ..
        } = command;
        if word == "buffer" {
            let note = format!(
                "`{name}` reads the output of another file (`{word}[{inside}]`), which is not \
                 ported; `--channel {name}=FILE` sets an image"
            );
            plan.notes.push(note);
            continue;
        }
        let input = texture(&command);
        match (control(&command), input, plan.passes.first_mut()) {
            (Some(control), ..) => plan.controls.push(control),
            (_, Some(input), Some(pass)) => pass.inputs.push(input),
            _ => plan
                .notes
                .push(format!("cannot parse `{word}[{inside}]` of `{name}`")),
        }
    }
    if clues.text.contains("<post-processing") || clues.text.contains("<postprocessing") {
        let note = "post-processing is not run: only the first of the two shaders is shown";
        plan.notes.push(note.to_string());
    }
    plan
}

/// The input of a sampler.
fn texture(command: &UniformCommand) -> Option<Input> {
    let kind = match command.ty {
        "sampler2D" => InputKind::Texture,
        "samplerCube" => InputKind::Cubemap,
        "sampler3D" => InputKind::Volume,
        _ => return None,
    };
    let setting = |name: &str| {
        let mut settings = command.inside.split(',').filter_map(|s| s.split_once(':'));
        settings.find_map(|(word, value)| (word.trim() == name).then(|| value.trim()))
    };
    let filter = match (setting("filter"), setting("mipmap")) {
        (Some(filter), _) if filter.starts_with("GL_NEAREST") => "nearest",
        (_, Some("true")) => "mipmap",
        _ => "linear",
    };
    let is_clamped = setting("wrap").is_some_and(|wrap| wrap.starts_with("GL_CLAMP"));
    let wrap = if is_clamped { "clamp" } else { "repeat" };
    let mut input = sampled(command.name, kind, (filter, wrap));
    input.src = quoted(command.inside).unwrap_or("").to_string();
    Some(input)
}

fn control(command: &UniformCommand) -> Option<UniformControl> {
    let lanes = match command.ty.rsplit_once("vec") {
        Some((_, size)) => size.parse().ok().filter(|n| (2..=4).contains(n))?,
        None if ["float", "int", "uint", "bool"].contains(&command.ty) => 1,
        None => return None,
    };
    let parts: Vec<Vec<f64>> = top_level(command.inside).map(numbers).collect();
    let (name, all) = (command.name, parts.concat());
    match (command.word, parts.as_slice()) {
        ("checkbox", _) => {
            let value = f64::from(u8::from(command.inside.trim() == "true"));
            let range = (0.0, value, 1.0);
            Some(UniformControl::even(name, ControlKind::Bool, lanes, range))
        }
        ("color", _) => {
            let color = match all.as_slice() {
                [r, g, b] => vec![*r, *g, *b],
                [r, g, b, a] | [_, a, _, r, g, b] => vec![*r, *g, *b, *a],
                _ => return None,
            };
            let mut control = UniformControl::color(name, lanes, 0);
            control.value = color.into_iter().chain([1.0]).take(lanes).collect();
            (control.value.len() == lanes).then_some(control)
        }
        ("combobox", _) => {
            let labels = command.inside.split('"').skip(1).step_by(2);
            let choices = labels.zip(0..).map(|(label, i)| ControlChoice {
                label: label.to_string(),
                value: f64::from(i),
            });
            let range = (0.0, *all.first()?, 10.0);
            Some(UniformControl {
                choices: choices.collect(),
                ..UniformControl::even(name, ControlKind::Choice, 1, range)
            })
        }
        ("direction" | "rotation", _) if lanes > 1 && all.len() == lanes => {
            // A direction has length 1; a rotation consists of angles.
            let most = if command.word == "direction" { 1.0 } else { PI };
            let most = all.iter().fold(most, |most: f64, n| most.max(n.abs()));
            Some(UniformControl {
                value: all,
                ..UniformControl::even(name, ControlKind::Vector, lanes, (-most, 0.0, most))
            })
        }
        ("slider" | "islider", [min, value, max]) => {
            let is_int = command.word == "islider" || ["int", "uint"].contains(&command.ty);
            let kind = match lanes {
                1 if is_int => ControlKind::Int,
                1 => ControlKind::Float,
                _ => ControlKind::Vector,
            };
            let spread = |of: &[f64]| {
                let all = of.iter().copied().cycle().take(lanes);
                all.collect::<Vec<f64>>()
            };
            let control = UniformControl {
                min: spread(min),
                value: spread(value),
                max: spread(max),
                ..UniformControl::even(name, kind, lanes, (0.0, 0.0, 1.0))
            };
            (control.value.len() == lanes).then_some(control)
        }
        _ => None,
    }
}

/// Splits at commas outside of parentheses.
fn top_level(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_usize;
    text.split(move |c| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(line: &str, expected: &str) {
        let read = commands(line).next().and_then(|c| control(&c));
        let message = read.map_or("none".to_string(), |c| {
            format!("{:?} {:?} {:?} {:?}", c.kind, c.min, c.value, c.max)
        });
        assert_eq!(message, expected, "{line}");
    }

    #[test]
    fn commands_are_read() {
        check(
            "uniform float Gamma; //! slider[0.1, 2.2, 10]",
            "Float [0.1] [2.2] [10.0]",
        );
        check(
            "uniform int n; //! islider[0, 5, 11]",
            "Int [0.0] [5.0] [11.0]",
        );
        check(
            "uniform int n; //! slider[1, 1, 100]",
            "Int [1.0] [1.0] [100.0]",
        );
        check("uniform bool On; //! checkbox[true]", "Bool [] [1.0] []");
        check(
            "uniform vec3 c; //! color[0.1, 0.2, .3]",
            "Color [0.0, 0.0, 0.0] [0.1, 0.2, 0.3] [1.0, 1.0, 1.0]",
        );
        check(
            "uniform vec4 c; //! color[0.2, 0.59, 0.6, 0.7, 0.8, 0.9]",
            "Color [0.0, 0.0, 0.0, 0.0] [0.7, 0.8, 0.9, 0.59] [1.0, 1.0, 1.0, 1.0]",
        );
        check(
            "uniform vec2 p; //! slider[(-1, -2), (0, 0.5), (1, 2)]",
            "Vector [-1.0, -2.0] [0.0, 0.5] [1.0, 2.0]",
        );
        check(
            "uniform float Power=2.0;//!slider[0.0,0.25,1.0];",
            "Float [0.0] [0.25] [1.0]",
        );
        check(
            "uniform vec3 Light = vec3(0, -1, 0); //! direction[(0.0, -1.0, 0.0)]",
            "Vector [-1.0, -1.0, -1.0] [0.0, -1.0, 0.0] [1.0, 1.0, 1.0]",
        );
        check(
            "uniform vec2 a; //! rotation[0, 4]",
            "Vector [-4.0, -4.0] [0.0, 4.0] [4.0, 4.0]",
        );
        check("uniform mat3 m; //! rotation[0, 0, 0]", "none");
        check("uniform float x; //! slider[1, 2]", "none");
        check("uniform float x; // slider[1, 2, 3]", "none");
        check("float x = 1.0; //! slider[1, 2, 3]", "none");
    }

    #[test]
    fn settings_of_textures_are_read() {
        let read = |line: &str| {
            let input = commands(line).next().and_then(|c| texture(&c)).unwrap();
            [input.src, input.sampler.filter, input.sampler.wrap].join(" ")
        };
        let of = |inside: &str| read(&format!("uniform sampler2D t; //! texture[{inside}]"));
        assert_eq!(of("\"a.png\""), "a.png linear repeat");
        assert_eq!(
            of("\"a.png\", wrap: GL_CLAMP_TO_EDGE, filter: GL_NEAREST, mipmap: true"),
            "a.png nearest clamp"
        );
        assert_eq!(of("\"a.png\", mipmap: true"), "a.png mipmap repeat");
    }
}
