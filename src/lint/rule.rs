//! Definition of rules, groups and checks.

use super::context::Context;
use super::option::RuleOption;
use shaderlint_diagnostic::Severity;
use shaderlint_semantic::{BuiltinId, FunctionRef, VariableId};
use shaderlint_syntax::Macro;
use shaderlint_syntax::ast::{
    BinaryOp, Declarator, ExprId, ExprKind, Extent, List, StmtId, TokenId, TypeId,
};

/// Category of a rule.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Group {
    /// WebGL2 and the page that hosts the shader.
    Webgl2,
    /// Undefined or unintended values.
    Numeric,
    /// Differences between GPUs, drivers and back ends.
    Portability,
    /// Cost per pixel.
    Budget,
    /// The image.
    Look,
    /// Clean code.
    Tidy,
    /// Findings of a sample run.
    Runtime,
}

impl Group {
    /// All groups, in the order of listings.
    pub const ALL: [Group; 7] = [
        Group::Webgl2,
        Group::Numeric,
        Group::Portability,
        Group::Budget,
        Group::Look,
        Group::Tidy,
        Group::Runtime,
    ];

    /// The name in `--select` and the configuration.
    pub const fn name(self) -> &'static str {
        match self {
            Group::Webgl2 => "webgl2",
            Group::Numeric => "numeric",
            Group::Portability => "portability",
            Group::Budget => "budget",
            Group::Look => "look",
            Group::Tidy => "tidy",
            Group::Runtime => "runtime",
        }
    }
}

/// A set of rules that a configuration can choose.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "cli", derive(serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "cli", serde(rename_all = "lowercase"))]
pub enum RulePreset {
    /// The default: useful for nearly every author.
    Recommended,
    /// Also clean code, and what differs between GPUs.
    Strict,
    /// Also all rules about the cost per pixel.
    Performance,
    /// Every rule.
    All,
}

impl RulePreset {
    /// All presets, in the order of listings.
    pub const ALL: [RulePreset; 4] = [
        RulePreset::Recommended,
        RulePreset::Strict,
        RulePreset::Performance,
        RulePreset::All,
    ];

    /// The name in the configuration and in `--select`.
    pub const fn name(self) -> &'static str {
        match self {
            RulePreset::Recommended => "recommended",
            RulePreset::Strict => "strict",
            RulePreset::Performance => "performance",
            RulePreset::All => "all",
        }
    }

    /// Whether a rule belongs to it.
    pub fn includes(self, rule: &Rule) -> bool {
        self == RulePreset::All || rule.preset == RulePreset::Recommended || rule.preset == self
    }
}

/// A binary expression, as passed to rules.
#[derive(Clone, Copy, Debug)]
pub struct BinaryExpr {
    /// The expression.
    pub id: ExprId,
    /// The operator.
    pub op: BinaryOp,
    /// The left operand.
    pub left: ExprId,
    /// The right operand.
    pub right: ExprId,
}

/// A call of a built-in function, as passed to rules.
#[derive(Clone, Copy, Debug)]
pub struct Builtin<'a> {
    /// The call.
    pub id: ExprId,
    /// The function.
    pub function: BuiltinId,
    /// The arguments, in order.
    pub args: &'a [ExprId],
}

/// One variable of a declaration in the user's text, as passed to rules.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredVariable<'a> {
    /// The variable.
    pub variable: VariableId,
    /// All declarators of the declaration.
    pub declarators: &'a [Declarator],
    /// Index of the variable in `declarators`.
    pub index: usize,
    /// Qualifiers of the declaration, in [`Tree::qualifiers`](shaderlint_syntax::ast::Tree::qualifiers).
    pub qualifiers: List,
    /// Type of the declaration, without array sizes after a name.
    pub ty: TypeId,
    /// Tokens of the whole declaration.
    pub extent: Extent,
    /// The declaration statement, if it is inside a function.
    pub stmt: Option<StmtId>,
}

impl<'a> DeclaredVariable<'a> {
    /// The name, with its array size and initializer.
    pub fn declarator(&self) -> Option<&'a Declarator> {
        self.declarators.get(self.index)
    }
}

/// A name that the user's text declares, outside any macro call.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredName<'a> {
    /// The first declaration of the name.
    pub token: TokenId,
    /// The name.
    pub text: &'a str,
    /// The declared entity.
    pub what: Named,
}

/// The kind of a declared entity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Named {
    /// A variable or parameter.
    Variable(VariableId),
    /// A function.
    Function(FunctionRef),
    /// A struct.
    Struct,
}

/// Kinds of expressions that rules can check.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// `l op r`
    Binary,
    /// `l = r` and `l op= r`
    Assign,
    /// A call of any function, and the constructor of a struct.
    Call,
    /// Any other constructor: `vec3(1.0)`.
    Construct,
    /// `object[index]`
    Index,
    /// `condition ? a : b`
    Ternary,
    /// `a, b`
    Comma,
    /// A literal with a point or an exponent: `1.0`, `2e-3`.
    FloatLiteral,
}

impl Shape {
    pub(super) const COUNT: usize = 8;

    /// The shape of an expression; `None` for kinds that rules cannot check.
    pub(super) const fn of(kind: &ExprKind) -> Option<Shape> {
        match kind {
            ExprKind::Binary(..) => Some(Shape::Binary),
            ExprKind::Assign(..) => Some(Shape::Assign),
            ExprKind::Call(..) => Some(Shape::Call),
            ExprKind::Construct(..) => Some(Shape::Construct),
            ExprKind::Index(..) => Some(Shape::Index),
            ExprKind::Ternary(..) => Some(Shape::Ternary),
            ExprKind::Comma(..) => Some(Shape::Comma),
            ExprKind::Float(_) => Some(Shape::FloatLiteral),
            _ => None,
        }
    }
}

/// What a rule is called for. One walk over the tree serves all rules and visits only the user's text, not
/// the code that a host adds.
#[derive(Clone, Copy)]
pub enum Check {
    /// The whole shader, once.
    Program(fn(&mut Context)),
    /// Every `l op r`.
    Binary(fn(&mut Context, &BinaryExpr)),
    /// Every call of a built-in function.
    Builtin(fn(&mut Context, &Builtin)),
    /// Every expression of these shapes.
    Expr(&'static [Shape], fn(&mut Context, ExprId)),
    /// Every statement.
    Stmt(fn(&mut Context, StmtId)),
    /// Every function with a body.
    Function(fn(&mut Context, FunctionRef)),
    /// Every variable of a declaration, parameters left out.
    Declaration(fn(&mut Context, &DeclaredVariable)),
    /// Every name that is declared.
    Name(fn(&mut Context, &DeclaredName)),
    /// Every macro.
    Macro(fn(&mut Context, &Macro)),
    /// The whole shader, once, after all other checks: for rules that use the sample run.
    Run(fn(&mut Context)),
    /// Suppression comments, which are checked after all findings are known.
    Allows,
    /// The script around shaders, which is checked where they are linked.
    Page,
}

/// Aliases of rules, accepted wherever a user names a rule: alias, name. Findings have the name.
pub const ALIASES: &[(&str, &str)] = &[
    ("gpu-dependent-image", "gpu-dependent-picture"),
    ("gray-image", "gray-picture"),
    ("redundant-bool", "needless-bool"),
    ("single-iteration-loop", "single-turn-loop"),
    ("static-image", "static-picture"),
];

/// The name of a rule whose name or alias is given; any other word as it is.
pub fn rule_name(word: &str) -> &str {
    let alias = ALIASES.iter().find(|(alias, _)| *alias == word);
    alias.map_or(word, |(_, name)| name)
}

/// The name of a rule whose module has this name, which is of the same length: with `-` for `_`.
pub const fn kebab<const N: usize>(name: &str) -> [u8; N] {
    let mut kebab = [b'-'; N];
    let (mut from, mut to) = (name.as_bytes(), kebab.as_mut_slice());
    while let ([byte, rest @ ..], [place, after @ ..]) = (from, to) {
        if *byte != b'_' {
            *place = *byte;
        }
        (from, to) = (rest, after);
    }
    kebab
}

impl Rule {
    /// Its alias, if it has one.
    pub fn alias(&self) -> Option<&'static str> {
        let alias = ALIASES.iter().find(|(_, name)| *name == self.name);
        alias.map(|(alias, _)| *alias)
    }

    /// Whether it is on by default.
    pub fn is_default(&self) -> bool {
        RulePreset::Recommended.includes(self)
    }

    /// Whether it checks suppression comments.
    pub fn is_of_allows(&self) -> bool {
        self.checks.iter().any(|c| matches!(c, Check::Allows))
    }
}

/// A lint rule: `NAME.rs` in `rules/` defines it, `NAME.md` is its page.
pub struct Rule {
    /// Name in kebab case, which reads well after "allow".
    pub name: &'static str,
    /// Category of the rule.
    pub group: Group,
    /// Default severity of its findings.
    pub severity: Severity,
    /// The smallest set of rules that it belongs to.
    pub preset: RulePreset,
    /// Options that the configuration may change.
    pub options: &'static [RuleOption],
    /// Text of its page, in Markdown.
    pub page: &'static str,
    /// What it is called for, and the functions to call.
    pub checks: &'static [Check],
}
