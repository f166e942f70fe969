//! Type rules, from operand types to a result or type error.

use super::*;
use crate::types::*;
use shaderlint_syntax::ast::{BinaryOp, UnaryOp};
use shaderlint_syntax::{Names, TypeWord, Version};
use shaderlint_text::each_case;

/// Two structs: `S { float a; vec3 b; }` and `Arrays { float a[2]; sampler2D t; }`.
fn structs(names: &mut Names) -> Vec<Struct> {
    let mut record = |fields: &[(&str, &str)]| {
        let fields: Vec<Field> = fields
            .iter()
            .map(|&(name, ty)| Field {
                name: names.intern(name),
                ty: read(ty),
                token: 0,
            })
            .collect();
        let mut inside = Inside {
            nesting: 1,
            ..Inside::default()
        };
        for field in &fields {
            inside.add(Inside::of(field.ty, |_| Inside::default()));
        }
        Struct {
            name: None,
            token: 0,
            fields,
            inside,
        }
    };
    vec![
        record(&[("a", "float"), ("b", "vec3")]),
        record(&[("a", "float[2]")]),
        record(&[("t", "sampler2D")]),
    ]
}

/// A type as it is written.
fn read(text: &str) -> Type {
    let (base, array) = match text.strip_suffix(']').and_then(|t| t.split_once('[')) {
        Some((base, "")) => (base, Type::UNSIZED),
        Some((base, size)) => (base, size.parse().unwrap()),
        None => (text, 0),
    };
    let record = |id| Type::structure(id);
    let ty = match base {
        "void" => Type::VOID,
        "?" => Type::ERROR,
        "S" => record(0),
        "Arrays" => record(1),
        "Samplers" => record(2),
        word => {
            let mut all = TypeWord::ALL.into_iter();
            Type::of_word(all.find(|w| w.name() == word).expect(word))
        }
    };
    ty.array_of(array)
}

fn written(ty: Type) -> String {
    type_name(ty, |id| {
        ["S", "Arrays", "Samplers"][id as usize].to_string()
    })
}

/// The result as text: `vec2`, or `! ` and the type error.
fn shown(result: Result<Type, TypeMismatch>) -> String {
    let mismatch = match result {
        Ok(ty) => return written(ty),
        Err(mismatch) => mismatch,
    };
    let text = match mismatch {
        TypeMismatch::Operands(clash) | TypeMismatch::Value(clash) => format!("{clash:?}"),
        TypeMismatch::Operand(ty)
        | TypeMismatch::Condition(ty)
        | TypeMismatch::NoMembers(ty)
        | TypeMismatch::Letters(ty)
        | TypeMismatch::NoElements(ty)
        | TypeMismatch::Index(ty)
        | TypeMismatch::NotConstructible(ty)
        | TypeMismatch::NoArguments(ty)
        | TypeMismatch::Count(ty)
        | TypeMismatch::NothingReturned(ty)
        | TypeMismatch::Returned(ty) => {
            let name = format!("{mismatch:?}");
            format!("{} {}", name.split('(').next().unwrap(), written(ty))
        }
        TypeMismatch::Part(number, ty) => format!("Part {number} {}", written(ty)),
        TypeMismatch::NoNumber(number, ty) => format!("NoNumber {number} {}", written(ty)),
        TypeMismatch::Component(ty, number) => format!("Component {} {number}", written(ty)),
        TypeMismatch::TooFew(ty, given) => format!("TooFew {} {given}", written(ty)),
        TypeMismatch::TooMany(ty, given, first) => {
            format!("TooMany {} {given} {first}", written(ty))
        }
        mismatch => format!("{mismatch:?}"),
    };
    format!("! {text}")
}

fn with_types<T>(version: Version, run: impl FnOnce(Types, &mut Names) -> T) -> T {
    let mut names = Names::default();
    let structs = structs(&mut names);
    let types = Types {
        structs: &structs,
        version,
    };
    run(types, &mut names)
}

/// `l op r`, `l op= r`, `l = r` or `l , r`, between types.
fn operate(version: Version, input: &str) -> String {
    let [l, symbol, r] = input.split(' ').collect::<Vec<_>>()[..] else {
        panic!("{input}");
    };
    let (l, r) = (read(l), read(r));
    let find = |symbol: &str| BinaryOp::ALL.iter().find(|op| op.symbol() == symbol);
    with_types(version, |types, _| {
        shown(
            match (
                symbol,
                find(symbol),
                symbol.strip_suffix('=').and_then(find),
            ) {
                ("=", ..) => assign(types, l, r).map(|()| l),
                (",", ..) => sequence(types, l, r),
                (":", ..) => choice(l, r),
                (_, Some(op), _) => binary(types, *op, l, r),
                (_, _, Some(op)) => compound(types, *op, l, r),
                _ => panic!("{symbol}"),
            },
        )
    })
}

#[test]
fn operators_have_the_types_of_the_standard() {
    each_case(include_str!("cases.txt"), |input, expected| {
        let found = match input.strip_prefix("es 100: ") {
            Some(input) => operate(Version::Es100, input),
            None => operate(Version::Es300, input),
        };
        assert_eq!(found, expected, "{input}");
    });
}

/// Unary operators, conditions, values that are returned, members, elements and constructors.
fn form(word: &str, operands: &str) -> String {
    let given = operands.split(", ").filter(|of| !of.is_empty());
    let given: Vec<Type> = given.map(read).collect();
    let first = given.first().copied();
    let kinds = [
        ("-", UnaryOp::Minus),
        ("!", UnaryOp::Not),
        ("~", UnaryOp::BitNot),
        ("+", UnaryOp::Plus),
    ];
    if let Some((_, op)) = kinds.into_iter().find(|(symbol, _)| *symbol == word) {
        return shown(unary(op, first.unwrap()));
    }
    match (word, word.split_once([' ', '.'])) {
        ("++", _) => shown(step(first.unwrap())),
        ("if", _) => shown(condition(first.unwrap()).map(|()| Type::BOOL)),
        ("index", _) => shown(index(first.unwrap()).map(|()| Type::INT)),
        ("element", _) => {
            let found = element(first.unwrap());
            let size = found.map_or(0, |(_, size)| size);
            format!("{} {size}", shown(found.map(|(ty, _)| ty)))
        }
        (_, Some(("return", declared))) => {
            shown(returned(read(declared), first).map(|()| Type::VOID))
        }
        (_, Some(("new", ty))) => with_types(Version::Es300, |within, _| {
            let ty = sized(read(ty), given.len());
            shown(construct(within, ty, given.into_iter()).map(|()| ty))
        }),
        (_, Some(("", name))) => with_types(Version::Es300, |within, names| {
            match member(within, first.unwrap(), names.intern(name), name) {
                Ok(Member::Components(ty, lanes)) => {
                    format!("{} {:?}", written(ty), &lanes[..name.len()])
                }
                Ok(Member::Field(ty, offset)) => format!("{} {offset}", written(ty)),
                Err(mismatch) => shown(Err(mismatch)),
            }
        }),
        _ => panic!("{word}"),
    }
}

#[test]
fn forms_have_the_types_of_the_standard() {
    each_case(include_str!("forms.txt"), |input, expected| {
        let (word, operands) = input.split_once(" of").unwrap();
        assert_eq!(form(word, operands.trim()), expected, "{input}");
    });
}
