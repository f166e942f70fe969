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
        assert_eq!(shown.chain(notes).collect::<Vec<_>>(), expected);
    }

    fn image(code: &str) -> Project {
        let main = "void mainImage(out vec4 o, vec2 u) { o = vec4(1); }";
        Project::from_shader("", &format!("{code}\n{main}")).unwrap()
    }

    #[test]
    fn marked_constants_get_sliders() {
        let code = "const float SPEED = 0.4; // how fast (0~1)\n\
            const int A = 3, // (1~8)\n  B = -2; // (-4~4)\n\
            const int FLAG = 1; // (0~1)\nconst uint U = 2u; //! slider[0, 3, 9]\n\
            const vec3 SKY = vec3(.2, .5, 1); // (color)\n\
            const vec3 SKY_COLOR = vec3(.2); // (0~1)\nconst vec3 AXIS = vec3(0, -1., 0); // (-1~1)\n\
            const bool ON = true;\nconst bool OFF = false; // whether it is off\n\
            #define GAIN (1.5) // in {0.0, 2.0}\n#define TINT vec4(1., .5, 0., 1.) // color: of all\n\
            const float PLAIN = 0.5; // see below\nconst float PAIR = 1.0, OTHER = 2.0; // (0~4)\n\
            const mat2 M = mat2(1.0); // (0~1)\n";
        check(
            SliderChoice::Marked,
            &image(code),
            &[
                "GAIN Float 1.5 [0.0] [2.0]",
                "TINT Color 1., .5, 0., 1. [0.0, 0.0, 0.0, 0.0] [1.0, 1.0, 1.0, 1.0]",
                "SPEED Float 0.4 [0.0] [1.0]",
                "A Int 3 [1.0] [8.0]",
                "B Int -2 [-4.0] [4.0]",
                "FLAG Bool 1 [0.0] [1.0]",
                "U Int 2u [0.0] [9.0]",
                "SKY Color .2, .5, 1 [0.0, 0.0, 0.0] [1.0, 1.0, 1.0]",
                "SKY_COLOR Color .2 [0.0, 0.0, 0.0] [1.0, 1.0, 1.0]",
                "AXIS Vector 0, -1., 0 [-1.0, -1.0, -1.0] [1.0, 1.0, 1.0]",
                "ON Bool true [0.0] [1.0]",
                "OFF Bool false [0.0] [1.0]",
                "OTHER Float 2.0 [0.0] [4.0]",
            ],
        );
        check(SliderChoice::None, &image(code), &[]);
    }

    /// Array sizes and other constants follow a slider, because the code is compiled again; a value
    /// with which it would not compile has none.
    #[test]
    fn sliders_that_break_the_shader_are_refused() {
        let code = "const int N = 3; // (0~4)\nconst int M = 3; // (1~4)\nconst int TWICE = 2 * M;\n\
            const float HALF = float(M) * 0.5; // (0~1)\nfloat a[N]; float b[TWICE];\n\
            #define LAST 2 // (0~9)\nfloat f() { return vec3(1)[LAST]; }\n";
        check(
            SliderChoice::Marked,
            &image(code),
            &[
                "M Int 3 [1.0] [4.0]",
                "no slider for `HALF`: its value is not a literal",
                "no slider for `N`: with 0 the shader does not compile: array size cannot be 0",
                "no slider for `LAST`: with 9 the shader does not compile: index 9 is out of range \
                    for `vec3`",
            ],
        );
    }

    #[test]
    fn unmarked_literals_get_proposals() {
        let code = "#define STEPS 12\n#define UNUSED 1.0\n#define PI 3.14159265\n\
            const float SHIFT = -0.5;\nconst vec3 FOG_COLOR = vec3(0.5);\nconst vec2 AT = vec2(0, 2);\n\
            const float MARKED = 1.0; // (0~8)\nconst float LEFT = 2.0;\nconst float R2 = 1.41421;\n\
            float f() { return float(STEPS) * PI * SHIFT * FOG_COLOR.x * AT.x * R2 * MARKED; }\n";
        check(
            SliderChoice::Auto,
            &image(code),
            &[
                "STEPS Int 12 [0.0] [24.0]",
                "SHIFT Float -0.5 [-1.0] [0.0]",
                "FOG_COLOR Color 0.5 [0.0, 0.0, 0.0] [1.0, 1.0, 1.0]",
                "AT Vector 0, 2 [0.0, 0.0] [1.0, 4.0]",
                "MARKED Float 1.0 [0.0] [8.0]",
                "proposed sliders: `STEPS` (0~24), `SHIFT` (-1~0), `FOG_COLOR` (color), \
                    `AT` (0~1, 0~4)",
            ],
        );
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
