//! Qualifiers: order, combinations and precision (GLSL ES 3.00 sections 4.3 to 4.7).

use crate::checker::*;

/// An error in qualifiers or precisions.
#[derive(Clone, Copy, Debug)]
pub enum QualifierError {
    /// A qualifier that is not allowed on a local variable.
    Local,
    /// A qualifier that is only allowed at global scope.
    NotGlobal,
    /// `in` or `out` in a version without them.
    Later,
    /// `inout` on anything but a parameter.
    NoParameter,
    /// `attribute` in a fragment shader.
    NoAttribute,
    /// Qualifiers that exclude each other.
    Together,
    /// Two qualifiers of the same kind.
    Twice,
    /// `invariant` and `layout` in one declaration.
    InvariantLayout,
    /// Qualifiers in the wrong order.
    Order,
    /// A qualifier that is not allowed on this parameter.
    Parameter,
    /// A qualifier that is not allowed on a return type.
    Returned,
    /// An interpolation qualifier without `in` or `out`.
    Alone(StorageRequest),
    /// `invariant` on anything but an output.
    Invariant,
    /// The same, on a variable that was declared before.
    InvariantVariable(Name),
    /// A qualifier other than `invariant` on a variable that was declared before.
    Afterwards,
    /// A redeclaration of a name that is not declared.
    Undeclared(Name),
    /// A declaration that lacks a type or a name.
    Incomplete(Name),
    /// A precision on a type that has none.
    NoPrecision(Type),
    /// A type without the precision that it needs.
    MissingPrecision(Type),
    /// A default precision for a type that cannot have one.
    DefaultPrecision,
}

/// Which types have a default precision in each open scope.
pub(in crate::checker) struct Precisions {
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

/// The storage that qualifiers request, before it is known what they qualify.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[rustfmt::skip]
pub enum StorageRequest {
    None, Const, In, Out, Inout, Uniform, Attribute, Varying, Centroid, Flat, Smooth,
    FlatIn, FlatOut, SmoothIn, SmoothOut, CentroidIn, CentroidOut,
}

impl StorageRequest {
    /// Whether this is an input of the stage.
    pub fn is_input(self) -> bool {
        matches!(
            self,
            StorageRequest::In
                | StorageRequest::FlatIn
                | StorageRequest::SmoothIn
                | StorageRequest::CentroidIn
        )
    }

    /// Whether this is an output of the stage.
    pub fn is_output(self) -> bool {
        matches!(
            self,
            StorageRequest::Out
                | StorageRequest::FlatOut
                | StorageRequest::SmoothOut
                | StorageRequest::CentroidOut
        )
    }

    /// The qualifiers as they are written in GLSL.
    pub fn name(self) -> &'static str {
        match self {
            StorageRequest::None => "",
            StorageRequest::Const => "const",
            StorageRequest::In => "in",
            StorageRequest::Out => "out",
            StorageRequest::Inout => "inout",
            StorageRequest::Uniform => "uniform",
            StorageRequest::Attribute => "attribute",
            StorageRequest::Varying => "varying",
            StorageRequest::Centroid => "centroid",
            StorageRequest::Flat => "flat",
            StorageRequest::Smooth => "smooth",
            StorageRequest::FlatIn => "flat in",
            StorageRequest::FlatOut => "flat out",
            StorageRequest::SmoothIn => "smooth in",
            StorageRequest::SmoothOut => "smooth out",
            StorageRequest::CentroidIn => "centroid in",
            StorageRequest::CentroidOut => "centroid out",
        }
    }
}

/// The entries of a `layout(...)`.
#[derive(Clone, Copy, Default, Debug)]
pub(in crate::checker) struct LayoutQualifier {
    pub location: Option<i32>,
    /// Number of `location` entries.
    pub locations: u32,
    /// Whether `row_major` or `column_major` is given.
    pub matrix: bool,
    /// Whether `std140`, `shared` or `packed` is given.
    pub block: bool,
    /// The number of views, of `OVR_multiview2`.
    pub views: Option<i32>,
    /// How `gl_FragDepth` is changed, of `EXT_conservative_depth`.
    pub depth: Option<Ident>,
    /// Tokens of the entries.
    pub extent: Option<Extent>,
}

impl LayoutQualifier {
    pub fn is_empty(&self) -> bool {
        self.location.is_none() && !self.matrix && !self.block && self.views.is_none()
    }
}

/// The qualifiers of a declaration, combined.
#[derive(Clone, Copy, Debug)]
pub(in crate::checker) struct Qualified {
    pub storage: StorageRequest,
    pub invariant: bool,
    /// Whether a precision was given.
    pub precision: bool,
    pub layout: LayoutQualifier,
    /// The qualifiers' tokens, if there are any.
    pub extent: Option<Extent>,
}

/// Groups of qualifiers, in the order that section 4.7 requires.
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
    pub(in crate::checker) fn qualifiers(&mut self, list: List) -> Qualified {
        let tree = self.tree;
        let all = tree.qualifiers(list);
        let mut result = Qualified {
            storage: StorageRequest::None,
            invariant: false,
            precision: false,
            layout: LayoutQualifier::default(),
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
                        let at = result.extent.unwrap_or(qualifier.extent);
                        self.reject(at, QualifierError::Together);
                        return result;
                    }
                },
            }
        }
        result
    }

    /// Reports a qualifier that this scope, stage or version does not allow.
    fn check_place(&mut self, qualifier: &Qualifier) {
        use QualifierKind as Q;
        let local = !self.at_global_scope();
        let problem = match qualifier.kind {
            Q::In | Q::Out | Q::Inout | Q::Uniform | Q::Attribute | Q::Varying if local => {
                QualifierError::Local
            }
            Q::Centroid | Q::Flat | Q::Smooth if local => QualifierError::Local,
            Q::Layout(_) | Q::Invariant if local => QualifierError::NotGlobal,
            Q::In | Q::Out | Q::Inout if !self.has(Feature::InOut) => QualifierError::Later,
            Q::Inout => QualifierError::NoParameter,
            Q::Attribute if self.stage == Stage::Fragment => QualifierError::NoAttribute,
            _ => return,
        };
        self.reject(qualifier.extent, problem);
    }

    /// Checks that each qualifier occurs once, and in the order of section 4.7.
    pub(super) fn check_sequence(&mut self, all: &[Qualifier]) -> bool {
        match sequence(all) {
            Ok(()) => true,
            Err((at, problem)) => {
                self.reject(at, problem);
                false
            }
        }
    }

    /// Adds a qualifier to the storage so far; `None` if they exclude each other.
    fn join(&self, storage: StorageRequest, kind: QualifierKind) -> Option<StorageRequest> {
        use QualifierKind as Q;
        use StorageRequest as W;
        let vertex = self.stage == Stage::Vertex;
        let has_in_out = self.has(Feature::InOut);
        // `attribute` and `varying` have already been reported in a version without them.
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

    /// The direction of a parameter, and whether it has a precision.
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
                self.reject(qualifier.extent, QualifierError::Parameter);
                break;
            }
        }
        let direction = match (direction, is_const) {
            (None | Some(Direction::In), true) => Direction::ConstIn,
            (found, _) => found.unwrap_or(Direction::In),
        };
        (direction, precision)
    }

    /// Checks that a type that needs a precision has one, explicitly or by default.
    pub(super) fn check_precision(&mut self, ty: Type, given: bool, extent: Extent) {
        let base = ty.base;
        let takes = match base {
            Base::Numeric { scalar, .. } => scalar != Scalar::Bool,
            Base::Sampler(_) | Base::Error => true,
            _ => false,
        };
        if given && !takes {
            return self.reject(extent, QualifierError::NoPrecision(ty));
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
        let key = Type {
            base: key,
            array: 0,
        };
        self.reject(extent, QualifierError::MissingPrecision(key));
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
            return self.reject(spec.extent, QualifierError::DefaultPrecision);
        }
        self.precisions.set(base);
    }

    /// `invariant gl_Position;`
    pub(super) fn requalify(&mut self, qualifiers: List, ident: Ident) {
        let qualified = self.qualifiers(qualifiers);
        // `uniform S;` for a struct declares nothing, as `S;` does.
        if let Some(Binding::Struct(id)) = self.scopes.get(ident.name)
            && !qualified.invariant
        {
            let ty = Type::structure(id);
            let extent = Extent::token(ident.token);
            self.check_type_of_variables(&qualified, ty, extent);
            return self.check_variable_layout(&qualified, extent);
        }
        let at = Extent::token(ident.token);
        if !qualified.invariant {
            // `uniform Foo;`: a declaration without a type or without a name.
            return self.reject(at, QualifierError::Incomplete(ident.name));
        }
        if qualified.storage != StorageRequest::None || qualified.precision {
            self.reject(at, QualifierError::Afterwards);
        }
        let Some(id) = self.find_variable(ident.name) else {
            return self.reject(at, QualifierError::Undeclared(ident.name));
        };
        let Some(variable) = self.variables.get(id.0 as usize) else {
            return;
        };
        let may_input = variable.storage == Storage::Input
            && self.stage == Stage::Fragment
            && self.has(Feature::InvariantInputs)
            && self.text(ident.name) != "gl_FrontFacing";
        if variable.storage != Storage::Output && !may_input {
            self.reject(at, QualifierError::InvariantVariable(ident.name));
        }
    }
}

/// Checks that each qualifier occurs once, and in the order of section 4.7.
fn sequence(all: &[Qualifier]) -> Result<(), (Extent, QualifierError)> {
    let mut highest = Rank::Invariant;
    let mut seen_invariant = false;
    for (i, qualifier) in all.iter().enumerate() {
        let this = rank(qualifier.kind);
        let before = all.get(..i).unwrap_or(&[]);
        let repeats = before.iter().any(|b| {
            let same = std::mem::discriminant(&b.kind) == std::mem::discriminant(&qualifier.kind);
            same || (this != Rank::Storage && rank(b.kind) == this)
        });
        let clash = this == Rank::Layout && seen_invariant;
        seen_invariant |= this == Rank::Invariant;
        // A layout may come before or after the interpolation.
        let late = match this {
            Rank::Layout => highest > Rank::Layout,
            Rank::Interpolation => highest > Rank::Layout,
            _ => highest > this,
        };
        let problem = if repeats {
            QualifierError::Twice
        } else if clash {
            QualifierError::InvariantLayout
        } else if late {
            QualifierError::Order
        } else {
            highest = highest.max(this);
            continue;
        };
        return Err((qualifier.extent, problem));
    }
    Ok(())
}
