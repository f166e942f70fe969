//! Qualifiers: order, combinations and precision (GLSL ES 3.00 sections 4.3 to 4.7).

use super::*;
use crate::diagnostic::Fix;
use crate::text::Edit;

/// Which types have a default precision in each open scope.
pub(super) struct Precisions {
    /// One bit for `float`, one for each sampler; innermost scope last.
    levels: Vec<u32>,
}

impl Precisions {
    pub fn new(stage: Stage) -> Precisions {
        let float = (stage == Stage::Vertex) as u32;
        Precisions {
            levels: vec![float],
        }
    }

    pub fn push(&mut self) {
        let level = self.levels.last().copied().unwrap_or(0);
        self.levels.push(level);
    }

    pub fn pop(&mut self) {
        if self.levels.len() > 1 {
            self.levels.pop();
        }
    }

    fn bit(base: Base) -> Option<u32> {
        match base {
            Base::Numeric {
                scalar: Scalar::Float,
                ..
            } => Some(1),
            Base::Sampler(sampler) if !sampler.has_default_precision() => Some(2 << sampler as u32),
            _ => None,
        }
    }

    fn set(&mut self, base: Base) {
        if let (Some(bit), Some(level)) = (Precisions::bit(base), self.levels.last_mut()) {
            *level |= bit;
        }
    }

    /// Whether a type has a default precision here, or needs none.
    fn has(&self, base: Base) -> bool {
        let level = self.levels.last().copied().unwrap_or(0);
        Precisions::bit(base).is_none_or(|bit| level & bit != 0)
    }
}

/// The storage that qualifiers ask for, before it is known what they qualify.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[rustfmt::skip]
pub(in crate::semantic) enum Wanted {
    None, Const, In, Out, Inout, Uniform, Attribute, Varying, Centroid, Flat, Smooth,
    FlatIn, FlatOut, SmoothIn, SmoothOut, CentroidIn, CentroidOut,
}

impl Wanted {
    /// Whether it is an input of the stage.
    pub fn is_input(self) -> bool {
        matches!(
            self,
            Wanted::In | Wanted::FlatIn | Wanted::SmoothIn | Wanted::CentroidIn
        )
    }

    /// Whether it is an output of the stage.
    pub fn is_output(self) -> bool {
        matches!(
            self,
            Wanted::Out | Wanted::FlatOut | Wanted::SmoothOut | Wanted::CentroidOut
        )
    }

    /// The qualifier in words.
    pub fn name(self) -> &'static str {
        match self {
            Wanted::None => "",
            Wanted::Const => "const",
            Wanted::In => "in",
            Wanted::Out => "out",
            Wanted::Inout => "inout",
            Wanted::Uniform => "uniform",
            Wanted::Attribute => "attribute",
            Wanted::Varying => "varying",
            Wanted::Centroid => "centroid",
            Wanted::Flat => "flat",
            Wanted::Smooth => "smooth",
            Wanted::FlatIn => "flat in",
            Wanted::FlatOut => "flat out",
            Wanted::SmoothIn => "smooth in",
            Wanted::SmoothOut => "smooth out",
            Wanted::CentroidIn => "centroid in",
            Wanted::CentroidOut => "centroid out",
        }
    }
}

/// What the qualifiers of a declaration say.
#[derive(Clone, Copy, Debug)]
pub(super) struct Qualified {
    pub storage: Wanted,
    pub invariant: bool,
    /// Whether a precision was given.
    pub precision: bool,
    pub layout: layout::Layout,
    /// The qualifiers' tokens, if there are any.
    pub extent: Option<Extent>,
}

/// The four groups whose order section 4.7 fixes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    Invariant,
    Interpolation,
    Layout,
    Storage,
    Precision,
}

fn rank(kind: QualifierKind) -> Rank {
    use QualifierKind as Q;
    match kind {
        Q::Invariant => Rank::Invariant,
        Q::Flat | Q::Smooth => Rank::Interpolation,
        Q::Layout(_) => Rank::Layout,
        Q::Lowp | Q::Mediump | Q::Highp => Rank::Precision,
        _ => Rank::Storage,
    }
}

impl Checker<'_> {
    /// Reads the qualifiers of a variable, function or block.
    pub(super) fn qualifiers(&mut self, list: List) -> Qualified {
        let tree = self.tree;
        let all = tree.qualifiers(list);
        let mut result = Qualified {
            storage: Wanted::None,
            invariant: false,
            precision: false,
            layout: layout::Layout::default(),
            extent: all
                .first()
                .zip(all.last())
                .map(|(a, b)| a.extent.to(b.extent)),
        };
        if all.is_empty() {
            return result;
        }
        for qualifier in all {
            self.check_place(qualifier);
        }
        if !self.check_sequence(all) {
            return result;
        }
        for qualifier in all {
            match qualifier.kind {
                QualifierKind::Invariant => result.invariant = true,
                QualifierKind::Layout(entries) => self.read_layout(entries, &mut result.layout),
                QualifierKind::Lowp | QualifierKind::Mediump | QualifierKind::Highp => {
                    result.precision = true;
                }
                kind => match self.join(result.storage, kind) {
                    Some(storage) => result.storage = storage,
                    None => {
                        let message = "these qualifiers cannot stand together";
                        let d = self.error(
                            error::INVALID_QUALIFIER,
                            result.extent.unwrap_or(qualifier.extent),
                            message,
                        );
                        self.report(d);
                        return result;
                    }
                },
            }
        }
        result
    }

    /// Qualifiers that only global scope, one stage or one version allows.
    fn check_place(&mut self, qualifier: &Qualifier) {
        use QualifierKind as Q;
        let word = self
            .sources
            .text(self.span(Extent::token(qualifier.extent.first)));
        let local = !self.at_global_scope();
        let message = match qualifier.kind {
            Q::In | Q::Out | Q::Inout | Q::Uniform | Q::Attribute | Q::Varying if local => {
                format!("a local variable cannot be `{word}`")
            }
            Q::Centroid | Q::Flat | Q::Smooth if local => {
                format!("a local variable cannot be `{word}`")
            }
            Q::Layout(_) | Q::Invariant if local => {
                format!("`{word}` can only stand at global scope")
            }
            Q::In | Q::Out | Q::Inout if !self.has(Feature::InOut) => {
                let d = self.error(
                    error::NEEDS_WEBGL2,
                    qualifier.extent,
                    format!("`{word}` needs `#version 300 es` here"),
                );
                let d = d.help("in GLSL ES 1.00 write `attribute` or `varying`");
                return self.report(d);
            }
            Q::Inout => "`inout` is for parameters".to_string(),
            Q::Attribute if self.stage == Stage::Fragment => {
                "`attribute` is for vertex shaders".to_string()
            }
            _ => return,
        };
        let d = self.error(error::INVALID_QUALIFIER, qualifier.extent, message);
        self.report(d);
    }

    /// Each qualifier once, and in the order of section 4.7.
    pub(super) fn check_sequence(&mut self, all: &[Qualifier]) -> bool {
        let mut highest = Rank::Invariant;
        let mut seen_invariant = false;
        for (i, qualifier) in all.iter().enumerate() {
            let this = rank(qualifier.kind);
            let before = all.get(..i).unwrap_or(&[]);
            let repeats = before.iter().any(|b| {
                let same =
                    std::mem::discriminant(&b.kind) == std::mem::discriminant(&qualifier.kind);
                same || (this != Rank::Storage && rank(b.kind) == this)
            });
            let clash = this == Rank::Layout && seen_invariant;
            seen_invariant |= this == Rank::Invariant;
            // A layout may stand before or behind the interpolation.
            let late = match this {
                Rank::Layout => highest > Rank::Layout,
                Rank::Interpolation => highest > Rank::Layout,
                _ => highest > this,
            };
            let message = if repeats {
                "this kind of qualifier stands twice"
            } else if clash {
                "`invariant` and `layout` cannot stand in one declaration"
            } else if late {
                "the qualifiers stand in the wrong order"
            } else {
                highest = highest.max(this);
                continue;
            };
            let d = self
                .error(error::INVALID_QUALIFIER, qualifier.extent, message)
                .note("the order is: invariant, flat or smooth, layout, storage, precision (section 4.7)");
            self.report(d);
            return false;
        }
        true
    }

    /// Adds one qualifier to the storage so far, if they go together.
    fn join(&self, storage: Wanted, kind: QualifierKind) -> Option<Wanted> {
        use QualifierKind as Q;
        use Wanted as W;
        let vertex = self.stage == Stage::Vertex;
        let has_in_out = self.has(Feature::InOut);
        // `attribute` and `varying` were reported where the version has them not.
        let kind = match kind {
            Q::Attribute if has_in_out => Q::In,
            Q::Varying if has_in_out && vertex => Q::Out,
            Q::Varying if has_in_out => Q::In,
            kind => kind,
        };
        Some(match (storage, kind) {
            (W::None, Q::Const) => W::Const,
            (W::None, Q::In) => W::In,
            (W::None, Q::Out) => W::Out,
            (W::None, Q::Inout) => W::Inout,
            (W::None, Q::Uniform) => W::Uniform,
            (W::None, Q::Attribute) => W::Attribute,
            (W::None, Q::Varying) => W::Varying,
            (W::None, Q::Centroid) => W::Centroid,
            (W::None, Q::Flat) => W::Flat,
            (W::None, Q::Smooth) => W::Smooth,
            (W::Flat, Q::Centroid) => W::Flat,
            (W::Smooth, Q::Centroid) => W::Centroid,
            (W::Flat, Q::In) if !vertex => W::FlatIn,
            (W::Flat, Q::Out) if vertex => W::FlatOut,
            (W::Smooth, Q::In) if !vertex => W::SmoothIn,
            (W::Smooth, Q::Out) if vertex => W::SmoothOut,
            (W::Centroid, Q::In) if !vertex => W::CentroidIn,
            (W::Centroid, Q::Out) if vertex => W::CentroidOut,
            _ => return None,
        })
    }

    /// The direction that the qualifiers of a parameter give.
    pub(super) fn param_qualifiers(&mut self, list: List) -> (Direction, bool) {
        use QualifierKind as Q;
        let tree = self.tree;
        let all = tree.qualifiers(list);
        if !self.check_sequence(all) {
            return (Direction::In, false);
        }
        let mut direction = None;
        let mut is_const = false;
        let mut precision = false;
        for qualifier in all {
            let ok = match qualifier.kind {
                Q::Lowp | Q::Mediump | Q::Highp => {
                    precision = true;
                    true
                }
                Q::Const => {
                    let first = direction.is_none();
                    is_const = true;
                    first
                }
                Q::In => direction.replace(Direction::In).is_none(),
                Q::Out => direction.replace(Direction::Out).is_none() && !is_const,
                Q::Inout => direction.replace(Direction::Inout).is_none() && !is_const,
                _ => false,
            };
            if !ok {
                let word = self.sources.text(self.span(qualifier.extent));
                let message = format!("a parameter cannot be `{word}` here");
                let d = self
                    .error(error::INVALID_PARAMETER, qualifier.extent, message)
                    .note("a parameter is `in`, `const in`, `out` or `inout` (section 4.6)");
                self.report(d);
                break;
            }
        }
        let direction = match (direction, is_const) {
            (None | Some(Direction::In), true) => Direction::ConstIn,
            (found, _) => found.unwrap_or(Direction::In),
        };
        (direction, precision)
    }

    /// Asks that a type which needs a precision has one, given or by default.
    pub(super) fn check_precision(&mut self, ty: Type, given: bool, extent: Extent) {
        let base = ty.base;
        let takes = match base {
            Base::Numeric { scalar, .. } => scalar != Scalar::Bool,
            Base::Sampler(_) | Base::Error => true,
            _ => false,
        };
        if given && !takes {
            let name = self.name_of(ty);
            let message = format!("`{name}` has no precision");
            let d = self.error(error::INVALID_QUALIFIER, extent, message);
            return self.report(d);
        }
        if given || self.precisions.has(base) {
            return;
        }
        let key = match base {
            Base::Numeric { .. } => Type::FLOAT.base,
            base => base,
        };
        if self.missing_precision.contains(&key) || self.is_prelude(extent.first) {
            return;
        }
        self.missing_precision.push(key);
        let name = self.name_of(Type {
            base: key,
            array: 0,
        });
        let line = match key {
            Base::Sampler(_) => format!("precision lowp {name};"),
            _ => format!("precision highp {name};"),
        };
        let message = format!("`{name}` has no precision here");
        let why = match key {
            Base::Sampler(_) => {
                "only `sampler2D` and `samplerCube` have a default precision (section 4.5.4)"
            }
            _ => "a fragment shader has no default precision for `float` (section 4.5.4)",
        };
        let d = self
            .error(error::MISSING_PRECISION, extent, message)
            .note(why);
        let d = match self.line_behind_version(extent.first) {
            Some(at) => d.fix(Fix::safe(
                format!("add `{line}`"),
                vec![Edit::insert(at, format!("{line}\n"))],
            )),
            None => d.help(format!("add `{line}` at the top")),
        };
        self.report(d);
    }

    /// Address of the line behind `#version` and the `#extension`s of the file that a token stands
    /// in: the place for declarations that come first.
    pub(super) fn line_behind_version(&self, token: TokenId) -> Option<u32> {
        let code = self.sources.code_at(self.token_span(token).start)?;
        if code.role == Role::Prelude {
            return None;
        }
        let whole = Span::new(code.base, code.base + code.text.len() as u32);
        let inside = |span: &Span| whole.contains(*span);
        let directives = self
            .tokens
            .version_span
            .iter()
            .chain(self.tokens.extensions.iter().map(|e| &e.span));
        let end = directives.filter(|s| inside(s)).map(|s| s.end).max();
        let Some(end) = end else {
            return Some(code.base);
        };
        let rest = code.text.get((end - code.base) as usize..)?;
        let newline = rest.find(['\n', '\r'])?;
        let width = if rest.get(newline..)?.starts_with("\r\n") {
            2
        } else {
            1
        };
        Some(end + newline as u32 + width)
    }

    /// `precision highp float;`
    pub(super) fn precision_statement(&mut self, ty: TypeId) {
        let tree = self.tree;
        let spec = tree.ty(ty);
        let base = match spec.base {
            TypeBase::Word(word) => Type::of_word(word).base,
            TypeBase::Error => return,
            _ => Base::Void,
        };
        let allowed = match base {
            Base::Numeric {
                scalar,
                columns: 1,
                rows: 1,
            } => {
                matches!(scalar, Scalar::Float | Scalar::Int)
            }
            Base::Sampler(_) => true,
            _ => false,
        };
        if !allowed || spec.arrays.len > 0 {
            let name = self.sources.text(self.span(spec.extent));
            let message = format!("a default precision cannot be set for `{name}`");
            let d = self
                .error(error::INVALID_QUALIFIER, spec.extent, message)
                .note("it can be set for `float`, `int` and samplers; vectors follow `float` (section 4.5.4)");
            return self.report(d);
        }
        self.precisions.set(base);
    }
}
