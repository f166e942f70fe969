//! Which types fit at the place of a completion.

use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::{Program, Scalar, Type};
use shaderlint_syntax::Name;
use shaderlint_syntax::ast::*;

/// How well a candidate fits at the place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Fit {
    /// It would be an error.
    No,
    /// A component, member or element of it fits.
    Part,
    /// The expected type or the type of the candidate is unknown.
    Unknown,
    /// It has an expected type.
    Yes,
}

/// What follows the name at the place.
enum NameSuffix {
    Nothing,
    /// Arguments of these types.
    Call(Vec<Type>),
    /// A member with this name.
    Member(String),
    /// An index.
    Index,
}

/// What the code around the place expects of a value.
pub(super) struct Expected {
    suffix: NameSuffix,
    /// The types that the place accepts; `None` if they are unknown.
    types: Option<Vec<Type>>,
    /// Whether the value is not used, as in the statement `f(x);`.
    is_statement: bool,
    /// Whether a value is assigned at the place.
    is_written: bool,
}

impl Expected {
    /// What the code around the name `hole` expects.
    pub fn of(program: &Program, hole: Option<Name>) -> Expected {
        let mut expected = Expected {
            suffix: NameSuffix::Nothing,
            types: None,
            is_statement: false,
            is_written: false,
        };
        let tree = &program.tree;
        let is_hole = |expr: &Expr| match expr.kind {
            ExprKind::Name(name) | ExprKind::Call(name, _) => Some(name) == hole,
            _ => false,
        };
        let Some(at) = tree.exprs.iter().position(is_hole) else {
            return expected;
        };
        let mut value = ExprId(at as u32);
        if let ExprKind::Call(_, args) = tree.expr(value).kind {
            let types = tree.args(args).iter().map(|arg| program.ty(*arg));
            expected.suffix = NameSuffix::Call(types.collect());
        }
        while let Some(parent) = parent(tree, value) {
            let suffix = match tree.expr(parent).kind {
                ExprKind::Member(_, name) => NameSuffix::Member(program.names.text(name).into()),
                ExprKind::Index(object, _) if object == value => NameSuffix::Index,
                _ => break,
            };
            // The type of a member says nothing about the type of its object.
            if !matches!(expected.suffix, NameSuffix::Nothing) {
                return expected;
            }
            expected.suffix = suffix;
            value = parent;
        }
        expected.is_written = parent(tree, value).is_some_and(|parent| {
            matches!(tree.expr(parent).kind, ExprKind::Assign(_, left, _) if left == value)
        });
        expected.is_statement = tree
            .stmts
            .iter()
            .any(|s| matches!(s.kind, StmtKind::Expr(e) if e == value));
        if !matches!(expected.suffix, NameSuffix::Member(_) | NameSuffix::Index) {
            expected.types = accepted(program, value);
        }
        expected
    }

    /// Whether a variable of this type fits.
    pub fn variable(&self, program: &Program, ty: Type, is_writable: bool) -> Fit {
        match self.suffix {
            _ if self.is_written && !is_writable => Fit::No,
            NameSuffix::Call(_) => Fit::No,
            _ => self.value(program, ty),
        }
    }

    /// Whether a call of a function fits, which has these parameters and this type.
    pub fn call(&self, program: &Program, params: &[Type], returns: Type) -> Fit {
        if self.is_written {
            return Fit::No;
        }
        if let NameSuffix::Call(args) = &self.suffix
            && (args.len() != params.len() || !all_match(args, params))
        {
            return Fit::No;
        }
        match self.is_statement {
            true if returns.is_void() => Fit::Yes,
            true => Fit::Part,
            false if returns.is_void() => Fit::No,
            false => self.value(program, returns).min(self.call_before_suffix()),
        }
    }

    /// Whether the constructor of a built-in type fits.
    pub fn constructor(&self, program: &Program, ty: Type) -> Fit {
        if self.is_written || ty.is_void() || ty.is_sampler() {
            return Fit::No;
        }
        match &self.suffix {
            NameSuffix::Call(args) => self.value(program, ty).min(constructed(ty, args)),
            _ => self.value(program, ty),
        }
    }

    /// A member or an index of a call is less usual than of a variable.
    fn call_before_suffix(&self) -> Fit {
        match self.suffix {
            NameSuffix::Member(_) | NameSuffix::Index => Fit::Part,
            NameSuffix::Nothing | NameSuffix::Call(_) => Fit::Yes,
        }
    }

    /// Whether arguments follow.
    pub fn is_call(&self) -> bool {
        matches!(self.suffix, NameSuffix::Call(_))
    }

    fn value(&self, program: &Program, ty: Type) -> Fit {
        if ty.is_error() {
            return Fit::Unknown;
        }
        match &self.suffix {
            NameSuffix::Member(name) if has_member(program, ty, name) => return Fit::Yes,
            NameSuffix::Member(_) => return Fit::No,
            NameSuffix::Index if ty.is_array() || ty.is_vector() || ty.is_matrix() => {
                return Fit::Yes;
            }
            NameSuffix::Index => return Fit::No,
            NameSuffix::Nothing | NameSuffix::Call(_) => {}
        }
        let Some(types) = &self.types else {
            return Fit::Unknown;
        };
        if types.contains(&ty) {
            return Fit::Yes;
        }
        let fits = |part: Type| types.contains(&part);
        let has_part = if ty.is_array() {
            fits(ty.element())
        } else if let Some(record) = program.struct_of(ty) {
            record.fields.iter().any(|field| fits(field.ty))
        } else {
            let scalar = ty.scalar_kind().filter(|_| !ty.is_scalar());
            let below = 1..=ty.components().min(4) as u8;
            scalar.is_some_and(|s| below.into_iter().any(|n| fits(Type::vector(s, n))))
        };
        match has_part {
            true => Fit::Part,
            false => Fit::No,
        }
    }
}

/// Whether arguments match parameters, as far as their types are known.
fn all_match(args: &[Type], params: &[Type]) -> bool {
    let mut pairs = args.iter().zip(params);
    pairs.all(|(arg, param)| arg.is_error() || arg == param)
}

/// Whether a constructor is usual for arguments of these types (section 5.4).
fn constructed(ty: Type, args: &[Type]) -> Fit {
    if args.iter().any(|arg| arg.is_error()) {
        return Fit::Yes;
    }
    let count: u32 = args.iter().map(|arg| arg.components()).sum();
    match args {
        // A conversion, or the same in all components.
        [arg] if ty.is_scalar() && (!arg.is_scalar() || *arg == ty) => Fit::Part,
        [arg] if arg.is_scalar() => Fit::Yes,
        [arg] if *arg == ty => Fit::Part,
        _ if count == ty.components() => Fit::Yes,
        [_] => Fit::Part,
        _ => Fit::No,
    }
}

fn has_member(program: &Program, ty: Type, name: &str) -> bool {
    if let Some(record) = program.struct_of(ty).filter(|_| !ty.is_array()) {
        let mut fields = record.fields.iter();
        return fields.any(|field| program.names.text(field.name) == name);
    }
    let count = ty.components() as usize;
    let is_of = |letters: &str| {
        name.chars()
            .all(|c| letters.find(c).is_some_and(|i| i < count))
    };
    match ty.is_array() {
        true => name == "length",
        false => ty.is_vector() && LETTERS.iter().any(|letters| is_of(letters)),
    }
}

/// The letters of vector components (section 5.5).
pub(super) const LETTERS: [&str; 3] = ["xyzw", "rgba", "stpq"];

/// The expression of which this one is an operand.
fn parent(tree: &Tree, child: ExprId) -> Option<ExprId> {
    let later = tree.exprs.iter().zip(0..).skip(child.0 as usize + 1);
    let mut around = later.filter(|(expr, _)| match expr.kind {
        ExprKind::Paren(a)
        | ExprKind::Unary(_, a)
        | ExprKind::Postfix(_, a)
        | ExprKind::Member(a, _) => a == child,
        ExprKind::Binary(_, a, b)
        | ExprKind::Assign(_, a, b)
        | ExprKind::Comma(a, b)
        | ExprKind::Index(a, b) => a == child || b == child,
        ExprKind::Ternary(a, b, c) => a == child || b == child || c == child,
        ExprKind::Call(_, args) | ExprKind::Construct(_, args) | ExprKind::Method(_, _, args) => {
            tree.args(args).contains(&child)
        }
        _ => false,
    });
    around.next().map(|(_, id)| ExprId(id))
}

/// A known type.
fn known(ty: Type) -> Option<Type> {
    (!ty.is_error() && !ty.is_void()).then_some(ty)
}

/// The types that the code around an expression accepts.
fn accepted(program: &Program, child: ExprId) -> Option<Vec<Type>> {
    let tree = &program.tree;
    let Some(at) = parent(tree, child) else {
        return accepted_by_statement(program, child);
    };
    let one = |ty: Type| known(ty).map(|ty| vec![ty]);
    let all_of = |scalar: Scalar| (1..=4).map(|n| Type::vector(scalar, n)).collect();
    match tree.expr(at).kind {
        ExprKind::Paren(_) => accepted(program, at),
        ExprKind::Unary(UnaryOp::Not, _) => Some(vec![Type::BOOL]),
        ExprKind::Unary(UnaryOp::BitNot, _) => Some(vec![Type::INT, Type::UINT]),
        ExprKind::Unary(..) => accepted(program, at),
        ExprKind::Postfix(..) => {
            Some([all_of(Scalar::Float), vec![Type::INT, Type::UINT]].concat())
        }
        ExprKind::Binary(op, a, b) => {
            let other = program.ty(if a == child { b } else { a });
            accepted_by_operator(op, other, || accepted(program, at))
        }
        ExprKind::Assign(None, a, b) => one(program.ty(if a == child { b } else { a })),
        ExprKind::Assign(Some(op), a, b) => {
            let other = known(program.ty(if a == child { b } else { a }))?;
            accepted_by_operator(op, other, || one(other))
        }
        ExprKind::Ternary(condition, ..) if condition == child => Some(vec![Type::BOOL]),
        ExprKind::Ternary(_, a, b) => {
            let other = program.ty(if a == child { b } else { a });
            one(other).or_else(|| accepted(program, at))
        }
        ExprKind::Comma(_, last) if last == child => accepted(program, at),
        ExprKind::Index(..) => Some(vec![Type::INT, Type::UINT]),
        ExprKind::Call(name, args) => accepted_by_call(program, name, tree.args(args), child),
        ExprKind::Construct(_, args) => {
            let others = tree.args(args).iter().filter(|arg| **arg != child);
            let used = others.map(|arg| program.ty(*arg).components()).sum();
            accepted_by_constructor(program.ty(at), used)
        }
        _ => None,
    }
}

/// The types that an operator accepts besides an operand of this type.
fn accepted_by_operator(
    op: BinaryOp,
    other: Type,
    result: impl Fn() -> Option<Vec<Type>>,
) -> Option<Vec<Type>> {
    match op {
        BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => return Some(vec![Type::BOOL]),
        BinaryOp::ShiftLeft | BinaryOp::ShiftRight | BinaryOp::Rem => {
            let scalar = other.scalar_kind().filter(|s| s.is_integer());
            return Some(scalar.map_or(vec![Type::INT, Type::UINT], |s| vec![Type::scalar(s)]));
        }
        BinaryOp::Less
        | BinaryOp::Greater
        | BinaryOp::LessEqual
        | BinaryOp::GreaterEqual
        | BinaryOp::Equal
        | BinaryOp::NotEqual => return known(other).map(|ty| vec![ty]),
        _ => {}
    }
    let Some((scalar, _, rows)) = known(other).and_then(Type::numeric) else {
        // A scalar may be an operand of a larger result.
        let mut types = result()?;
        let scalars: Vec<Type> = types
            .iter()
            .filter_map(|ty| ty.scalar_kind().map(Type::scalar))
            .collect();
        types.extend(scalars);
        return Some(types);
    };
    let mut types = vec![other, Type::scalar(scalar)];
    if other.is_scalar() {
        match result() {
            Some(wanted) => types.extend(wanted),
            None => types.extend((2..=4).map(|n| Type::vector(scalar, n))),
        }
    } else if op == BinaryOp::Mul && scalar == Scalar::Float {
        types.extend([Type::vector(scalar, rows), Type::matrix(rows, rows)]);
    }
    Some(types)
}

/// The types of an argument, of all overloads that match the other arguments.
fn accepted_by_call(
    program: &Program,
    name: Name,
    args: &[ExprId],
    child: ExprId,
) -> Option<Vec<Type>> {
    let at = args.iter().position(|arg| *arg == child)?;
    let types: Vec<Type> = args.iter().map(|arg| program.ty(*arg)).collect();
    let text = program.names.text(name);
    let mut found = Vec::new();
    let mut add = |params: &[Type]| {
        if let Some(param) = params.get(at)
            && params.len() >= args.len()
            && types
                .iter()
                .zip(params)
                .enumerate()
                .all(|(i, (arg, param))| i == at || arg.is_error() || arg == param)
        {
            found.push(*param);
        }
    };
    let functions = program.functions.iter().filter(|f| f.name == name);
    for function in functions {
        let params: Vec<Type> = function.params.iter().map(|p| p.ty).collect();
        add(&params);
    }
    let structs = program.structs.iter().filter(|s| s.name == Some(name));
    for record in structs {
        let params: Vec<Type> = record.fields.iter().map(|f| f.ty).collect();
        add(&params);
    }
    let builtins = Builtins::of(program.version, program.stage);
    if let Some(id) = builtins.function(text) {
        let (_, overloads) = builtins.overloads_of(id);
        overloads.iter().for_each(|overload| add(overload.params()));
    }
    (!found.is_empty()).then_some(found)
}

/// The types of the arguments of a constructor, whose other arguments have this many components.
fn accepted_by_constructor(ty: Type, used: u32) -> Option<Vec<Type>> {
    if ty.is_array() {
        return known(ty.element()).map(|ty| vec![ty]);
    }
    let (scalar, ..) = known(ty)?.numeric()?;
    if ty.is_scalar() {
        // A conversion.
        let all = [Scalar::Float, Scalar::Int, Scalar::Uint, Scalar::Bool];
        return Some(
            all.into_iter()
                .map(Type::scalar)
                .filter(|from| *from != ty)
                .collect(),
        );
    }
    let most = ty.components().saturating_sub(used).clamp(1, 4) as u8;
    Some((1..=most).map(|n| Type::vector(scalar, n)).collect())
}

/// The types that a statement or declaration accepts as its expression.
fn accepted_by_statement(program: &Program, child: ExprId) -> Option<Vec<Type>> {
    let tree = &program.tree;
    let mut declared = tree.declarator_lists.iter().zip(&program.declared);
    if let Some((_, variable)) = declared.find(|(d, _)| d.init == Some(child)) {
        let variable = variable.and_then(|id| program.variable(id))?;
        return known(variable.ty).map(|ty| vec![ty]);
    }
    let is_of = |s: &&Stmt| match s.kind {
        StmtKind::Expr(e) | StmtKind::Return(Some(e)) => e == child,
        StmtKind::If { condition, .. } | StmtKind::Do { condition, .. } => condition == child,
        StmtKind::Switch { selector, .. } => selector == child,
        _ => false,
    };
    let (stmt, id) = tree.stmts.iter().zip(0..).find(|(s, _)| is_of(s))?;
    match stmt.kind {
        StmtKind::If { .. } | StmtKind::Do { .. } => Some(vec![Type::BOOL]),
        StmtKind::Switch { .. } => Some(vec![Type::INT, Type::UINT]),
        StmtKind::Return(_) => {
            let mut all = program.functions.iter();
            let returns = all.find_map(|f| {
                let defined = tree.function(f.definition?)?;
                defined.extent.contains(stmt.extent).then_some(f.returns)
            });
            returns.and_then(known).map(|ty| vec![ty])
        }
        StmtKind::Expr(_) if is_condition(tree, StmtId(id)) => Some(vec![Type::BOOL]),
        _ => None,
    }
}

/// Whether a statement is the condition of a loop.
fn is_condition(tree: &Tree, stmt: StmtId) -> bool {
    tree.stmts.iter().any(|s| match s.kind {
        StmtKind::For { condition, .. } => condition == Some(stmt),
        StmtKind::While { condition, .. } => condition == stmt,
        _ => false,
    })
}
