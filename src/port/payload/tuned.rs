//! Finds the values in the code that have sliders.

use crate::{Composed, ControlKind, PassUnit};
use rustc_hash::FxHashSet;
use shaderlint_diagnostic::Severity;
use shaderlint_project::{Slider, SliderChoice, Sliders};
use shaderlint_semantic::Scalar;
use shaderlint_semantic::tunable::{
    Tunable, TunableChoice, TunableKind, chosen_tunables, untunables,
};
use shaderlint_text::{FileId, Sources, Span};

/// The sliders of all passes, each once.
pub(crate) fn sliders(composed: &Composed) -> &Sliders {
    composed.sliders.get_or_init(|| match composed.choice {
        SliderChoice::None => Sliders::default(),
        SliderChoice::Marked => find(composed, TunableChoice::Marked),
        SliderChoice::Auto => find(composed, TunableChoice::Proposed),
    })
}

/// Proposed sliders, and why values have none.
pub fn slider_notes(composed: &Composed) -> &[String] {
    &sliders(composed).notes
}

fn find(composed: &Composed, choice: TunableChoice) -> Sliders {
    let mut notes = Vec::new();
    let mut all: Vec<Tunable> = Vec::new();
    let mut known: FxHashSet<u32> = FxHashSet::default();
    for unit in &composed.units {
        let program = &composed.analysis(unit).program;
        for found in chosen_tunables(program, choice) {
            if owner(composed, found.value_span).is_some() && known.insert(found.value_span.start) {
                all.push(found);
            }
        }
        for found in untunables(program) {
            if owner(composed, found.name).is_some() && known.insert(found.name.start) {
                let name = composed.sources.text(found.name);
                notes.push(format!(
                    "no slider for `{name}`: its value is not a literal"
                ));
            }
        }
    }
    let is_proposed: Vec<&Tunable> = all.iter().filter(|t| t.is_proposed).collect();
    let is_refused = refused(composed, &all);
    let proposals = is_proposed.iter().filter(|t| {
        let is_other = |(other, _): &(usize, String)| all.get(*other) != Some(**t);
        is_refused.iter().all(is_other)
    });
    let proposals: Vec<String> = proposals
        .map(|t| range_words(&composed.sources, t))
        .collect();
    if !proposals.is_empty() {
        notes.insert(0, format!("proposed sliders: {}", proposals.join(", ")));
    }
    notes.extend(is_refused.iter().map(|(_, reason)| reason.clone()));
    let mut units = Units::default();
    let kept = all.iter().enumerate();
    let kept = kept.filter(|(i, _)| is_refused.iter().all(|(refused, _)| refused != i));
    let list = kept.filter_map(|(_, tunable)| slider(&composed.sources, tunable, &mut units));
    Sliders {
        list: list.collect(),
        notes,
    }
}

/// The file of the user's text that contains a span.
fn owner(composed: &Composed, span: Span) -> Option<FileId> {
    let file = composed.sources.file_id_at(span.start)?;
    composed.owner(file).map(|_| file)
}

/// The values with which the shader does not compile at an end of their range, and why. Other
/// values keep what they are.
fn refused(composed: &Composed, all: &[Tunable]) -> Vec<(usize, String)> {
    let mut found: Vec<(usize, String)> = Vec::new();
    if all.is_empty() || composed.has_errors() {
        return found;
    }
    for ends in [|t: &Tunable| t.min.clone(), |t: &Tunable| t.max.clone()] {
        let whole: Vec<&Tunable> = all.iter().collect();
        if error_with(composed, &whole, ends).is_none() {
            continue;
        }
        for (i, tunable) in all.iter().enumerate() {
            if found.iter().any(|(other, _)| *other == i) {
                continue;
            }
            if let Some(error) = error_with(composed, &[tunable], ends) {
                let name = composed.sources.text(tunable.name);
                let value = literals(tunable, &ends(tunable));
                found.push((
                    i,
                    format!(
                        "no slider for `{name}`: with {value} the shader does not compile: {error}"
                    ),
                ));
            }
        }
    }
    found
}

/// The first error of the passes with other values.
fn error_with(
    composed: &Composed,
    tunables: &[&Tunable],
    value: impl Fn(&Tunable) -> Vec<f64>,
) -> Option<String> {
    let mut texts: Vec<(FileId, String)> = Vec::new();
    let mut order: Vec<&&Tunable> = tunables.iter().collect();
    // Later positions first, so that the earlier ones stay valid.
    order.sort_by_key(|t| std::cmp::Reverse(t.value_span.start));
    for tunable in order {
        let span = tunable.value_span;
        let id = composed.sources.file_id_at(span.start)?;
        let file = composed.sources.file(id)?;
        if texts.iter().all(|(known, _)| *known != id) {
            texts.push((id, file.text.to_string()));
        }
        let (_, text) = texts.iter_mut().find(|(known, _)| *known == id)?;
        let (start, end) = (span.start - file.base, span.end - file.base);
        text.replace_range(
            start as usize..end as usize,
            &literals(tunable, &value(tunable)),
        );
    }
    let changed = composed.with_texts(&texts)?;
    let is_affected = |unit: &&PassUnit| texts.iter().any(|(id, _)| unit.files.contains(id));
    changed.units.iter().filter(is_affected).find_map(|unit| {
        let mut all = changed.analysis(unit).diagnostics.iter();
        let error = all.find(|d| d.severity == Severity::Error)?;
        Some(error.message.clone())
    })
}

/// A value as literals, as the player writes it.
fn literals(tunable: &Tunable, value: &[f64]) -> String {
    let each = value.iter().map(|v| match tunable.scalar {
        Scalar::Bool if *v == 0.0 => "false".to_string(),
        Scalar::Bool => "true".to_string(),
        Scalar::Int => format!("{v:.0}"),
        Scalar::Uint => format!("{v:.0}u"),
        Scalar::Float => format!("{v:?}"),
    });
    each.collect::<Vec<_>>().join(", ")
}

/// A proposed slider: `SPEED` (0~2).
fn range_words(sources: &Sources, tunable: &Tunable) -> String {
    let name = sources.text(tunable.name);
    let kind = match (tunable.kind, &*tunable.min, &*tunable.max) {
        (TunableKind::Color, ..) => "color".to_string(),
        (TunableKind::Bool, ..) => "on or off".to_string(),
        (_, [min], [max]) => format!("{min}~{max}"),
        (_, min, max) => {
            let ends = min.iter().zip(max).map(|(min, max)| format!("{min}~{max}"));
            ends.collect::<Vec<_>>().join(", ")
        }
    };
    format!("`{name}` ({kind})")
}

/// Converts byte offsets to UTF-16 offsets, incrementally for increasing offsets.
#[derive(Default)]
struct Units {
    file: Option<FileId>,
    bytes: usize,
    units: usize,
}

impl Units {
    fn before(&mut self, file: FileId, text: &str, offset: usize) -> Option<usize> {
        if self.file != Some(file) || offset < self.bytes {
            *self = Units {
                file: Some(file),
                ..Units::default()
            };
        }
        let between = text.get(self.bytes..offset)?;
        self.units += between.chars().map(char::len_utf16).sum::<usize>();
        self.bytes = offset;
        Some(self.units)
    }
}

fn slider(sources: &Sources, tunable: &Tunable, units: &mut Units) -> Option<Slider> {
    let span = tunable.value_span;
    let file = sources.file_id_at(span.start)?;
    let text = sources.file(file)?;
    let mut before = |address: u32| units.before(file, &text.text, (address - text.base) as usize);
    Some(Slider {
        name: sources.text(tunable.name).to_string(),
        label: tunable.label.clone(),
        kind: match tunable.kind {
            TunableKind::Float => ControlKind::Float,
            TunableKind::Int => ControlKind::Int,
            TunableKind::Bool => ControlKind::Bool,
            TunableKind::Vector => ControlKind::Vector,
            TunableKind::Color => ControlKind::Color,
        },
        scalar: tunable.scalar.name(),
        value: tunable.value.clone(),
        min: tunable.min.clone(),
        max: tunable.max.clone(),
        file,
        start: before(span.start)?,
        end: before(span.end)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Project;
    use shaderlint_project::compose;

    /// Name, kind, literals and range of each slider; then the notes.
    #[track_caller]
    fn check(choice: SliderChoice, project: &Project, expected: &[&str]) {
        let mut composed = compose(project, "").unwrap();
        assert!(!composed.has_errors());
        composed.choose_sliders(choice);
        let found = sliders(&composed);
        let shown = found.list.iter().map(|s| {
            let text = &composed.sources.file(s.file).unwrap().text;
            let (kind, text) = (s.kind, text.get(s.start..s.end).unwrap());
            format!("{} {kind:?} {text} {:?} {:?}", s.name, s.min, s.max)
        });
        let notes = found.notes.iter().cloned();
        let found: Vec<String> = shown.chain(notes).collect();
        assert_eq!(found, expected, "{choice:?}: {}", project.passes[0].code);
    }

    fn image(code: &str) -> Project {
        let main = "void mainImage(out vec4 o, vec2 u) { o = vec4(1); }";
        Project::from_shader("", &format!("{code}\n{main}")).unwrap()
    }

    /// Each case is a choice, a shader without its main function, and the sliders and notes.
    #[test]
    fn constants_get_sliders_by_choice() {
        let cases = include_str!("sliders.txt").lines();
        for case in cases.filter(|case| !case.starts_with("# ")) {
            let (given, expected) = case.split_once(" ⇒").unwrap();
            let (choice, code) = given.split_once(": ").unwrap();
            let choice = match choice {
                "Marked" => SliderChoice::Marked,
                "Auto" => SliderChoice::Auto,
                _ => SliderChoice::None,
            };
            let lines = expected.trim_start().split_terminator('↵');
            let expected: Vec<&str> = lines.collect();
            check(choice, &image(&code.replace('↵', "\n")), &expected);
        }
    }

    #[test]
    fn equal_constants_of_passes_share_a_slider() {
        let json = r#"{"renderpass":[
            {"type":"common","code":"const float GAIN = 0.5; // (0~1)"},
            {"type":"buffer","name":"Buffer A","outputs":[{"id":"4dXGR8"}],
             "code":"const int N = 1; // (1~4)\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(N); }"},
            {"type":"image","code":"const int N = 2; // (1~4)\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(N); }"}]}"#;
        let project = Project::from_json(json).unwrap();
        check(
            SliderChoice::Marked,
            &project,
            &[
                "GAIN Float 0.5 [0.0] [1.0]",
                "N Int 1 [1.0] [4.0]",
                "N Int 2 [1.0] [4.0]",
            ],
        );
        let composed = compose(&project, "").unwrap();
        let data = crate::player_data(&project, &composed);
        assert!(data.contains(r#""name":"N (Image)""#), "{data}");
    }
}
