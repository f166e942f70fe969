//! Values as GLSL, and their parts.

use shaderlint_semantic::{Base, Program, Scalar, Type};

/// Maximum number of scalars in the text of a value.
const SHOWN: usize = 16;
/// Maximum number of scalars of a value that is read.
pub const MOST: usize = 1 << 14;

/// A value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DebugValue {
    pub ty: Type,
    /// The scalars as bits, at most [`MOST`].
    pub bits: Vec<u32>,
}

/// A part of a value.
pub struct ValuePart {
    /// The name of the member, `[0]` or `x`.
    pub name: String,
    /// What is appended to the expression of the whole.
    pub suffix: String,
    pub value: DebugValue,
}

impl DebugValue {
    /// The value as GLSL source text, shortened if it is long.
    pub fn text(&self, program: &Program) -> String {
        let mut left = SHOWN;
        self.write(program, &mut left)
    }

    fn write(&self, program: &Program, left: &mut usize) -> String {
        if let (true, Some(scalar)) = (self.ty.is_scalar(), self.ty.scalar_kind()) {
            *left = left.saturating_sub(1);
            return self
                .bits
                .first()
                .map_or(String::new(), |bits| scalar.literal(*bits));
        }
        let mut words = Vec::new();
        for part in self.scalars_or_parts(program) {
            if *left == 0 {
                words.push("...".to_string());
                break;
            }
            words.push(part.value.write(program, left));
        }
        format!("{}({})", program.type_name(self.ty), words.join(", "))
    }

    /// The parts that the text lists: the scalars of a matrix, not its columns.
    fn scalars_or_parts(&self, program: &Program) -> Vec<ValuePart> {
        let parts = self.parts(program);
        if self.ty.is_array() || !self.ty.is_matrix() {
            return parts;
        }
        parts
            .iter()
            .flat_map(|column| column.value.parts(program))
            .collect()
    }

    /// The elements, members, columns or components.
    pub fn parts(&self, program: &Program) -> Vec<ValuePart> {
        let ty = self.ty;
        if ty.is_array() {
            let elements =
                (0..ty.array).map(|at| (format!("[{at}]"), format!("[{at}]"), ty.element()));
            return self.split(program, elements);
        }
        if let Some(known) = program.struct_of(ty) {
            let members = known.fields.iter().map(|field| {
                let name = program.names.text(field.name);
                (name.to_string(), format!(".{name}"), field.ty)
            });
            return self.split(program, members);
        }
        let Some((scalar, columns, rows)) = ty.numeric() else {
            return Vec::new();
        };
        if columns > 1 {
            let column = Type::vector(scalar, rows);
            let all = (0..columns).map(|at| (format!("[{at}]"), format!("[{at}]"), column));
            return self.split(program, all);
        }
        if rows > 1 {
            let names = ["x", "y", "z", "w"].into_iter().take(usize::from(rows));
            let all =
                names.map(|name| (name.to_string(), format!(".{name}"), Type::scalar(scalar)));
            return self.split(program, all);
        }
        Vec::new()
    }

    fn split(
        &self,
        program: &Program,
        parts: impl Iterator<Item = (String, String, Type)>,
    ) -> Vec<ValuePart> {
        let mut rest = self.bits.as_slice();
        let mut all = Vec::new();
        for (name, suffix, ty) in parts {
            let count = scalars_of(program, ty).min(rest.len());
            let (own, after) = rest.split_at(count);
            rest = after;
            if own.is_empty() {
                break;
            }
            let bits = own.to_vec();
            all.push(ValuePart {
                name,
                suffix,
                value: DebugValue { ty, bits },
            });
        }
        all
    }

    /// The colour of three or four numbers between 0 and 1, as in a style sheet.
    pub fn color(&self) -> Option<String> {
        let (scalar, columns, rows) = self.ty.numeric()?;
        let is_vector = !self.ty.is_array() && columns == 1 && rows >= 3;
        if scalar != Scalar::Float || !is_vector {
            return None;
        }
        let numbers = self.bits.iter().take(3).map(|bits| f32::from_bits(*bits));
        let bytes: Option<String> = numbers
            .map(|n| {
                (0.0..=1.0)
                    .contains(&n)
                    .then(|| format!("{:02x}", (n * 255.0).round() as u8))
            })
            .collect();
        Some(format!("#{}", bytes?))
    }

    /// Whether a condition with this value holds.
    pub fn is_true(&self) -> bool {
        self.bits.first().is_some_and(|bits| *bits != 0)
    }
}

/// The number of scalars of a type.
pub fn scalars_of(program: &Program, ty: Type) -> usize {
    let one = match program.struct_of(ty) {
        Some(known) => known
            .fields
            .iter()
            .map(|field| scalars_of(program, field.ty))
            .sum(),
        None => ty.element().components() as usize,
    };
    one * ty.array.max(1) as usize
}

/// Whether values of a type have no parts.
pub const fn is_simple(ty: Type) -> bool {
    ty.is_scalar() || matches!(ty.base, Base::Sampler(_))
}
