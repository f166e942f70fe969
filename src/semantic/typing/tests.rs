//! Type rules, from operand types to a result or type error.

use super::*;
use crate::types::*;
use shaderlint_syntax::ast::{BinaryOp, UnaryOp};
use shaderlint_syntax::{Names, TypeWord, Version};

const SYMBOLS: [(&str, BinaryOp); 12] = [
    ("*", BinaryOp::Mul),
    ("/", BinaryOp::Div),
    ("%", BinaryOp::Rem),
    ("+", BinaryOp::Add),
    ("-", BinaryOp::Sub),
    ("<<", BinaryOp::ShiftLeft),
    ("<", BinaryOp::Less),
    ("==", BinaryOp::Equal),
    ("&", BinaryOp::BitAnd),
    ("&&", BinaryOp::And),
    ("^^", BinaryOp::Xor),
    ("!=", BinaryOp::NotEqual),
];

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
    let find = |symbol: &str| {
        SYMBOLS
            .iter()
            .find(|(s, _)| *s == symbol)
            .map(|(_, op)| *op)
    };
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
                (_, Some(op), _) => binary(types, op, l, r),
                (_, _, Some(op)) => compound(types, op, l, r),
                _ => panic!("{symbol}"),
            },
        )
    })
}

fn check(input: &str, expected: &str) {
    assert_eq!(operate(Version::Es300, input), expected, "{input}");
}

fn check_100(input: &str, expected: &str) {
    assert_eq!(operate(Version::Es100, input), expected, "{input}");
}

#[test]
fn operators_have_the_types_of_the_standard() {
    let cases = include_str!("cases.txt").lines();
    for case in cases.filter(|case| !case.starts_with("# ")) {
        let (input, expected) = case.split_once(" ⇒ ").unwrap();
        check(input, expected);
    }
}

#[test]
fn only_glsl_es_3_compares_and_assigns_arrays() {
    check("float[2] == float[2]", "bool");
    check("float[2] == float[3]", "! ArraySize");
    check("float[2] == int[2]", "! Scalars");
    check("vec2[2] == vec3[2]", "! Shape");
    check("float[2] == float", "! Array");
    check("float[2] + float[2]", "! Array");
    check("float[2] = float[2]", "float[2]");
    check_100("float[2] == float[2]", "! Array");
    check_100("float[2] = float[2]", "! Array");
    check("Arrays == Arrays", "bool");
    check_100("Arrays == Arrays", "! StructInside");
    check("Samplers = Samplers", "! StructInside");
}

#[test]
fn unary_operators_check_their_operand() {
    let check = |op, operand, expected: &str| assert_eq!(shown(unary(op, read(operand))), expected);
    check(UnaryOp::Minus, "vec2", "vec2");
    check(UnaryOp::Minus, "bool", "! Operand bool");
    check(UnaryOp::Not, "bool", "bool");
    check(UnaryOp::Not, "bvec2", "! Operand bvec2");
    check(UnaryOp::BitNot, "uvec2", "uvec2");
    check(UnaryOp::BitNot, "float", "! Operand float");
    check(UnaryOp::Plus, "void", "! Void(0)");
    assert_eq!(shown(step(read("bool"))), "! Operand bool");
    let reported = |ty| shown(condition(read(ty)).map(|()| Type::BOOL));
    assert_eq!(reported("int"), "! Condition int");
    assert_eq!(reported("void"), "! Void(0)");
}

#[test]
fn return_values_have_the_declared_type() {
    let check = |declared, value: Option<&str>, expected: &str| {
        let result = returned(read(declared), value.map(read));
        assert_eq!(shown(result.map(|()| Type::VOID)), expected);
    };
    check("void", None, "void");
    check("float", None, "! NothingReturned float");
    check("float", Some("float"), "void");
    check("float", Some("int"), "! Returned float");
    check("float", Some("void"), "! Void(0)");
    check("void", Some("float"), "! ValueReturned");
    check("void", Some("void"), "! ValueReturned");
    check("?", Some("int"), "void");
    check("float", Some("?"), "void");
}

#[test]
fn members_are_components_and_fields() {
    let check = |object, name: &str, expected: &str| {
        let found = with_types(Version::Es300, |types, names| {
            let word = names.intern(name);
            match member(types, read(object), word, name) {
                Ok(Member::Components(ty, lanes)) => {
                    format!("{} {:?}", written(ty), &lanes[..name.len()])
                }
                Ok(Member::Field(ty, offset)) => format!("{} {offset}", written(ty)),
                Err(mismatch) => shown(Err(mismatch)),
            }
        });
        assert_eq!(found, expected, "{object}.{name}");
    };
    check("vec3", "zyx", "vec3 [2, 1, 0]");
    check("ivec2", "g", "int [1]");
    check("vec2", "xyz", "! Component vec2 2");
    check("vec4", "xg", "! Letters vec4");
    check("vec4", "xxxxx", "! Letters vec4");
    check("S", "b", "vec3 1");
    check("S", "c", "! Field(0)");
    check("S[2]", "a", "! ArrayMember");
    check("float", "x", "! NoMembers float");
    check("void", "x", "! Void(0)");
}

#[test]
fn arrays_matrices_and_vectors_have_elements() {
    let check = |object, expected: &str| {
        let found = element(read(object));
        let size = found.map_or(0, |(_, size)| size);
        assert_eq!(
            format!("{} {size}", shown(found.map(|(ty, _)| ty))),
            expected
        );
    };
    check("vec3[4]", "vec3 4");
    check("mat2x3", "vec3 2");
    check("vec3", "float 3");
    check("float", "! NoElements float 0");
    check("S", "! NoElements S 0");
    assert_eq!(
        shown(index(Type::FLOAT).map(|()| Type::INT)),
        "! Index float"
    );
}

#[test]
fn constructors_accept_components_elements_and_members() {
    let check = |ty, arguments: &[&str], expected: &str| {
        let found = with_types(Version::Es300, |types, _| {
            let arguments = arguments.iter().map(|a| read(a));
            let ty = sized(read(ty), arguments.len());
            shown(construct(types, ty, arguments).map(|()| ty))
        });
        assert_eq!(found, expected, "{ty} of {arguments:?}");
    };
    check("vec3", &["float"], "vec3");
    check("vec3", &["vec2", "int"], "vec3");
    check("vec3", &["vec2"], "! TooFew vec3 2");
    check("vec3", &["vec2", "vec2"], "vec3");
    check("vec3", &["vec3", "float"], "! TooMany vec3 4 1");
    check("vec3", &[], "! NoArguments vec3");
    check("vec3", &["S"], "! NoNumber 0 vec3");
    check("vec3", &["void"], "! Void(0)");
    check("vec3", &["float", "sampler2D"], "! SamplerArgument(1)");
    check("mat3", &["mat2"], "mat3");
    check("mat3", &["mat2", "float"], "! MatrixWithOthers");
    check("float[]", &["float", "float"], "float[2]");
    check("float[2]", &["float"], "! Count float[2]");
    check("float[2]", &["float", "int"], "! Part 1 float");
    check("S", &["float", "vec3"], "S");
    check("S", &["float", "vec2"], "! Part 1 vec3");
    check("S", &["float"], "! Count S");
    check("sampler2D", &["float"], "! NotConstructible sampler2D");
    check("vec3", &["?"], "vec3");
}
