//! The names of the keys that a project reads.

use crate::{Composed, InputKind, PassUnit, Project};
use shaderlint_flow::reaching_definitions::ReachingDefinitions;
use shaderlint_flow::{Calls, ColumnReads, column_reads};
use shaderlint_semantic::VariableId;
use std::collections::BTreeSet;

/// The width of the texture that holds the keyboard, one column for each key code.
const KEYS: u32 = 256;

/// More names than this are not shown.
const MAX_NAMES: usize = 12;

/// The names of the keys that a project reads; empty if they are not known or too many.
pub(super) fn key_names(project: &Project, composed: &Composed) -> Vec<String> {
    let mut columns = BTreeSet::new();
    for unit in &composed.units {
        let Some(pass) = project.passes.get(unit.pass) else {
            continue;
        };
        let keyboards = pass.inputs.iter().filter(|i| i.kind == InputKind::Keyboard);
        for input in keyboards {
            let channel = format!("iChannel{}", input.channel);
            let name = input.uniform.as_deref().unwrap_or(&channel);
            let read = read_by(composed, unit, name);
            if read.reads_others {
                return Vec::new();
            }
            columns.extend(read.columns);
        }
    }
    let columns: Vec<u32> = columns.into_iter().collect();
    named(&columns).unwrap_or_default()
}

/// The columns of a texture that a pass reads.
fn read_by(composed: &Composed, unit: &PassUnit, uniform: &str) -> ColumnReads {
    let program = &composed.analysis(unit).program;
    let name = program.names.get(uniform);
    let mut variables = (0..).map(VariableId).zip(&program.variables);
    let Some((uniform, _)) = variables.find(|(_, v)| Some(v.name) == name) else {
        return ColumnReads::default();
    };
    let module = shaderlint_ir::lower(program);
    let calls = Calls::of(&module);
    let definitions = ReachingDefinitions::of(program, &module, &calls);
    column_reads(&module, &definitions, &calls, uniform, KEYS)
}

/// Keys that are named together.
const GROUPS: [(&str, [u32; 4]); 2] =
    [("arrow keys", [37, 38, 39, 40]), ("WASD", [65, 68, 83, 87])];

/// The names of key codes in ascending order; runs of letters and digits as one: `A–Z`. `None` if a
/// code has no name, or there are many.
fn named(codes: &[u32]) -> Option<Vec<String>> {
    let is_read = |group: &[u32; 4]| group.iter().all(|code| codes.contains(code));
    let (together, groups): (Vec<&str>, Vec<[u32; 4]>) = GROUPS
        .into_iter()
        .filter(|(_, group)| is_read(group))
        .unzip();
    let is_single = |code: &&u32| !groups.iter().flatten().any(|grouped| grouped == *code);
    let single: Vec<u32> = codes.iter().filter(is_single).copied().collect();
    let is_character = |code: u32| matches!(code, 48..=57 | 65..=90);
    let runs = single.chunk_by(|a, b| a + 1 == *b && is_character(*a) && is_character(*b));
    let mut names: Vec<String> = together.into_iter().map(String::from).collect();
    for run in runs {
        match run {
            [first, _, .., last] => names.push(format!("{}–{}", name(*first)?, name(*last)?)),
            few => names.extend(
                few.iter()
                    .map(|code| name(*code))
                    .collect::<Option<Vec<_>>>()?,
            ),
        }
    }
    (names.len() <= MAX_NAMES).then_some(names)
}

/// The names of key codes that no range below covers: code, name.
const FIXED: &str = include_str!("keys.txt");

/// The name of a `keyCode` (UI Events, section "Fixed virtual key codes", and the codes of letters,
/// digits, function keys and the numeric pad, on which browsers agree).
fn name(code: u32) -> Option<String> {
    let number = code.to_string();
    let mut fixed = FIXED.lines().filter_map(|line| line.split_once(' '));
    if let Some((_, name)) = fixed.find(|(known, _)| *known == number) {
        return Some(name.to_string());
    }
    match code {
        48..=57 | 65..=90 => char::from_u32(code).map(String::from),
        96..=105 => Some(format!("numpad {}", code - 96)),
        112..=123 => Some(format!("F{}", code - 111)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(code: &str) -> Vec<String> {
        let json = serde_json::json!({"renderpass": [{
            "type": "image",
            "code": code,
            "inputs": [{"channel": 1, "ctype": "keyboard", "id": "33"}],
            "outputs": [{"channel": 0, "id": "37"}],
        }]});
        let mut project = Project::from_json(&json.to_string()).unwrap();
        let composed = project.resolve("").unwrap();
        assert!(!composed.has_errors());
        key_names(&project, &composed)
    }

    #[test]
    fn keys_that_a_shader_reads_are_named() {
        let code = "#define KEY(k) texelFetch(iChannel1, ivec2(k, 0), 0).x
            void mainImage(out vec4 c, in vec2 p) {
                c = vec4(KEY(37), KEY(39), KEY(65) + KEY(66) + KEY(67), KEY(32));
                c += texture(iChannel0, p);
            }";
        assert_eq!(keys(code), ["space", "←", "→", "A–C"]);
    }

    #[test]
    fn complete_groups_of_keys_have_one_name() {
        let all: Vec<u32> = [32, 65, 68, 83, 87].into_iter().chain(37..=40).collect();
        assert_eq!(named(&all).unwrap(), ["arrow keys", "WASD", "space"]);
        let without = named(&[37, 39, 65, 68, 83]).unwrap();
        assert_eq!(without, ["←", "→", "A", "D", "S"]);
    }

    #[test]
    fn unknown_keys_have_no_names() {
        let all = "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel1, p / 256.0); }";
        assert!(keys(all).is_empty());
        let unnamed =
            "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel1, ivec2(3, 0), 0); }";
        assert!(keys(unnamed).is_empty());
    }
}
