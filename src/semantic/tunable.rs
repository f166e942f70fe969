//! Numbers, colours and switches that an author made tunable: `#define NAME value // (min~max)`,
//! `const float NAME = value; // (min~max)`, `const bool NAME = true;`.

use crate::tunable_mark::{MarkMeaning, TunableMark, description_after, mark_after};
use crate::{Program, Scalar, Variable};
use shaderlint_syntax::{Token, TokenKind};
use shaderlint_text::Span;

pub use crate::tunable_mark::{TunableRange, range_after};

/// A value that its author made tunable.
#[derive(Clone, PartialEq, Debug)]
pub struct Tunable {
    /// Span of the name in its `#define` or declaration.
    pub name: Span,
    /// Span of the literals, from the first sign or digit to the last digit.
    pub value_span: Span,
    /// The widget.
    pub kind: TunableKind,
    /// Type of the literals.
    pub scalar: Scalar,
    /// Value as written, with one number per component.
    pub value: Vec<f64>,
    /// Lower bound of each component.
    pub min: Vec<f64>,
    /// Upper bound of each component.
    pub max: Vec<f64>,
    /// Span of the range in the comment; `None` for a colour or a switch.
    pub range: Option<Span>,
    /// Text of the comment without the range.
    pub label: String,
    /// Whether the range is proposed from the value, because no comment gives one.
    pub is_proposed: bool,
}

/// The widget of a tunable value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TunableKind {
    /// A slider for a float.
    Float,
    /// A slider for an integer.
    Int,
    /// A checkbox.
    Bool,
    /// One slider per component.
    Vector,
    /// A colour picker.
    Color,
}

/// A value in the text, of a macro or a constant.
struct Literals {
    name: Span,
    /// The literals.
    span: Span,
    /// All of the value, with its constructor.
    whole: Span,
    scalar: Scalar,
    value: Vec<f64>,
}

/// A marked constant that cannot have a slider.
#[derive(Clone, PartialEq, Debug)]
pub struct Untunable {
    /// Span of the name.
    pub name: Span,
}

/// The punctuation between a constant and its comment.
const AFTER_CONSTANT: &[char] = &[';', ','];

/// Which values have sliders.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum TunableChoice {
    /// Those with a mark of their author, and constants of type `bool`.
    #[default]
    Marked,
    /// These, and all other literals with a name that the shader uses.
    Proposed,
}

/// The tunable values of a shader: those of macros, then those of constants, each in source order.
pub fn tunables(program: &Program) -> Vec<Tunable> {
    chosen_tunables(program, TunableChoice::Marked)
}

/// The values that are chosen, in the same order.
pub fn chosen_tunables(program: &Program, choice: TunableChoice) -> Vec<Tunable> {
    let is_proposed = |is_used: bool| is_used && choice == TunableChoice::Proposed;
    let macros = program.tokens.macros.iter();
    let macros = macros.filter(|d| d.params.is_none() && !d.name_span.is_empty());
    let defined = macros.filter_map(|definition| {
        let body: Vec<Token> = definition.body.iter().map(|piece| piece.token).collect();
        let name = definition.name_span;
        let literals = read(program, name, &body)?;
        let mark = mark_after(program, literals.whole, &[], &literals.value);
        match mark {
            Some(mark) => marked(program, literals, mark),
            None if is_proposed(definition.uses > 0 && program.is_user(name)) => {
                let label = description_after(program, literals.whole, &[]);
                proposed(program, literals, label)
            }
            None => None,
        }
    });
    let declared = constants(program).filter_map(|(name, variable, init)| {
        let literals = read(program, name, init)?;
        let mark = mark_after(program, literals.whole, AFTER_CONSTANT, &literals.value);
        let label = || description_after(program, literals.whole, AFTER_CONSTANT);
        match mark {
            Some(mark) => marked(program, literals, mark),
            // A constant of type `bool` has only two values, and needs no mark.
            None if literals.scalar == Scalar::Bool => {
                let label = label();
                switch(literals, label)
            }
            None if is_proposed(variable.read) => {
                let label = label();
                proposed(program, literals, label)
            }
            None => None,
        }
    });
    defined.chain(declared).collect()
}

/// The constants with a range in their comment whose value is not a literal.
pub fn untunables(program: &Program) -> Vec<Untunable> {
    let found = constants(program).filter_map(|(name, variable, init)| {
        let (_, columns, _) = variable.ty.numeric()?;
        let span = init.first()?.span.to(init.last()?.span);
        // A value inside the range is not known, so an interval is not a mark.
        let mark = mark_after(program, span, AFTER_CONSTANT, &[f64::NAN])?;
        let is_range = matches!(mark.meaning, MarkMeaning::Range(..)) && columns == 1;
        (is_range && read(program, name, init).is_none()).then_some(Untunable { name })
    });
    found.collect()
}

/// The global constants of the user's text: name, variable, and the tokens of the value.
fn constants(program: &Program) -> impl Iterator<Item = (Span, &Variable, &[Token])> {
    let lists = program.tree.declarator_lists.iter();
    program.declared.iter().zip(lists).filter_map(|(id, list)| {
        let variable = program.variable((*id)?)?;
        if !variable.is_const || variable.function.is_some() {
            return None;
        }
        let extent = program.tree.expr(list.init?).extent;
        let (first, last) = (extent.first, extent.last);
        let name = program.declared_at(variable)?;
        if !program.is_user(name) || !program.tokens.are_direct(first, last) {
            return None;
        }
        let tokens = &program.tokens.tokens;
        let init = tokens.get(first as usize..=last as usize)?;
        let named = program.token(variable.token?)?;
        named.is_direct().then_some((name, variable, init))
    })
}

/// A value with the mark in its comment; `None` if the mark does not fit the value.
fn marked(program: &Program, literals: Literals, mark: TunableMark) -> Option<Tunable> {
    let lanes = literals.value.len();
    let is_float = literals.scalar == Scalar::Float;
    match mark.meaning {
        _ if literals.scalar == Scalar::Bool => switch(literals, mark.label),
        MarkMeaning::Color if is_float && lanes > 2 => color(literals, mark.label),
        MarkMeaning::Switch if lanes == 1 && literals.scalar == Scalar::Int => {
            switch(literals, mark.label)
        }
        MarkMeaning::Range(min, max) => {
            let each = |ends: Vec<f64>| match ends.as_slice() {
                [one] => Some(vec![*one; lanes]),
                all => (all.len() == lanes).then_some(ends),
            };
            let (min, max) = (each(min)?, each(max)?);
            let is_unit = min.iter().all(|v| *v == 0.0) && max.iter().all(|v| *v == 1.0);
            let name = program.sources.text(literals.name);
            let kind = match lanes {
                1 if is_float => TunableKind::Float,
                1 if is_unit => TunableKind::Bool,
                1 => TunableKind::Int,
                3.. if is_unit && is_float && is_color(name) => TunableKind::Color,
                _ => TunableKind::Vector,
            };
            let range = Some(mark.span);
            Some(with_range(literals, kind, (min, max), range, mark.label))
        }
        MarkMeaning::Color | MarkMeaning::Switch => None,
    }
}

fn switch(literals: Literals, label: String) -> Option<Tunable> {
    let lanes = literals.value.len();
    let ends = (vec![0.0], vec![1.0]);
    (lanes == 1).then(|| with_range(literals, TunableKind::Bool, ends, None, label))
}

fn color(literals: Literals, label: String) -> Option<Tunable> {
    let lanes = literals.value.len();
    let ends = (vec![0.0; lanes], vec![1.0; lanes]);
    Some(with_range(literals, TunableKind::Color, ends, None, label))
}

fn with_range(
    literals: Literals,
    kind: TunableKind,
    (min, max): (Vec<f64>, Vec<f64>),
    range: Option<Span>,
    label: String,
) -> Tunable {
    Tunable {
        name: literals.name,
        value_span: literals.span,
        kind,
        scalar: literals.scalar,
        value: literals.value,
        min,
        max,
        range,
        label,
        is_proposed: false,
    }
}

/// A value with a range from zero to twice the value; from 0 to 1 for zero. `None` for constants of
/// mathematics, which have no other value.
fn proposed(program: &Program, literals: Literals, label: String) -> Option<Tunable> {
    let is_float = literals.scalar == Scalar::Float;
    let lanes = literals.value.len();
    let found = match lanes {
        _ if literals.scalar == Scalar::Bool => switch(literals, label)?,
        1 if is_float && literals.value.iter().any(|v| is_mathematical(*v)) => return None,
        3.. if is_float && is_color(program.sources.text(literals.name)) => color(literals, label)?,
        _ => {
            let end = |v: &f64| if *v == 0.0 { 1.0 } else { 2.0 * v };
            let ends: Vec<f64> = literals.value.iter().map(end).collect();
            let min = ends.iter().map(|end| end.min(0.0)).collect();
            let max = ends.iter().map(|end| end.max(0.0)).collect();
            let kind = match (lanes, is_float) {
                (1, true) => TunableKind::Float,
                (1, false) if literals.value == [0.0] => TunableKind::Bool,
                (1, false) => TunableKind::Int,
                _ => TunableKind::Vector,
            };
            with_range(literals, kind, (min, max), None, label)
        }
    };
    Some(Tunable {
        is_proposed: true,
        ..found
    })
}

/// Whether a number is a multiple or a fraction of π, or e, a root of a small number, or the golden
/// ratio, to at least four digits.
fn is_mathematical(value: f64) -> bool {
    use std::f64::consts::{E, LN_2, PI, SQRT_2};
    const GOLDEN: f64 = 1.618_033_988_749_895;
    let near = |known: f64| (value.abs() - known).abs() < 5e-5 * known;
    let factors = [1.0, 2.0, 0.5, 0.25, 4.0, 1.0 / 3.0, 1.0 / 180.0];
    let multiples = factors.iter().flat_map(|f| [f * PI, 1.0 / (f * PI)]);
    let others = [
        E,
        LN_2,
        SQRT_2,
        1.0 / SQRT_2,
        3.0_f64.sqrt(),
        GOLDEN,
        GOLDEN - 1.0,
    ];
    multiples.chain(others).any(near)
}

/// Whether a name is that of a colour.
pub fn is_color(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    ["color", "colour", "tint", "rgb"]
        .iter()
        .any(|word| name.contains(word))
}

/// Reads a value: a literal with an optional sign, or a vector of such literals.
fn read(program: &Program, name: Span, tokens: &[Token]) -> Option<Literals> {
    let (first, last) = (tokens.first()?, tokens.last()?);
    let whole = first.span.to(last.span);
    let word = program.sources.text(first.span);
    let (inside, constructed) = match tokens {
        [_, open, inside @ .., close]
            if open.kind == TokenKind::LeftParen && close.kind == TokenKind::RightParen =>
        {
            (inside, Some(vector(word)?))
        }
        [open, inside @ .., close]
            if open.kind == TokenKind::LeftParen && close.kind == TokenKind::RightParen =>
        {
            (inside, None)
        }
        all => (all, None),
    };
    let mut values = Vec::new();
    let mut scalar = Scalar::Float;
    let parts = inside.split(|token| token.kind == TokenKind::Comma);
    for part in parts {
        let (value, of) = literal(program, part)?;
        values.push(value);
        scalar = of;
    }
    if let Some((of, lanes)) = constructed {
        scalar = of;
        match (values.len(), values.first()) {
            (1, Some(one)) => values = vec![*one; lanes],
            (len, _) if len == lanes => {}
            _ => return None,
        }
    } else if values.len() != 1 {
        return None;
    }
    Some(Literals {
        name,
        span: inside.first()?.span.to(inside.last()?.span),
        whole,
        scalar,
        value: values,
    })
}

/// The component type and the number of components of a vector type that has sliders.
fn vector(word: &str) -> Option<(Scalar, usize)> {
    let (prefix, lanes) = word.split_once("vec")?;
    let scalar = match prefix {
        "" => Scalar::Float,
        "i" => Scalar::Int,
        "u" => Scalar::Uint,
        _ => return None,
    };
    let lanes = lanes.parse().ok()?;
    (2..=4).contains(&lanes).then_some((scalar, lanes))
}

/// The value and the type of a literal with an optional sign.
fn literal(program: &Program, tokens: &[Token]) -> Option<(f64, Scalar)> {
    let (sign, token) = match tokens {
        [one] => (1.0, one),
        [sign, one] if sign.kind == TokenKind::Minus => (-1.0, one),
        _ => return None,
    };
    let text = program.sources.text(token.span);
    let (value, scalar) = match token.kind {
        TokenKind::Int => (f64::from(token.value as i32), Scalar::Int),
        TokenKind::Uint => (f64::from(token.value), Scalar::Uint),
        // The value as written rather than rounded to 32 bits, because people see it.
        TokenKind::Float => (
            text.trim_end_matches(['f', 'F']).parse().ok()?,
            Scalar::Float,
        ),
        // In the body of a macro all words are identifiers.
        TokenKind::True | TokenKind::False | TokenKind::Identifier => match text {
            "true" => (1.0, Scalar::Bool),
            "false" => (0.0, Scalar::Bool),
            _ => return None,
        },
        _ => return None,
    };
    if scalar == Scalar::Bool && sign < 0.0 {
        return None;
    }
    Some((sign * value, scalar))
}
