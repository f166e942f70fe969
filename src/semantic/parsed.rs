//! A parsed shader as used by the checker and by `explain`.

use super::builtins::{Builtins, Stage};
use super::dialect::Dialect;
use super::host::EntryPoint;
use super::program::{ExprInfo, Resolution, VariableId, struct_name};
use super::types::{Struct, Type, type_name};
use super::typing::Types;
use shaderlint_syntax::ast::*;
use shaderlint_syntax::{ExactPlace, Feature, GlContext, Name, Names, Token, Tokens, Version};
use shaderlint_text::{Role, Sources, Span};
use std::ops::Deref;

/// A shader before semantic analysis.
#[derive(Clone, Copy)]
pub struct ParsedView<'a> {
    pub sources: &'a Sources,
    pub tokens: &'a Tokens,
    pub names: &'a Names,
    pub tree: &'a Tree,
    pub version: Version,
    pub stage: Stage,
    pub dialect: Dialect,
    pub context: GlContext,
    pub builtins: Builtins,
}

impl<'a> ParsedView<'a> {
    /// Whether the version of the language supports a feature.
    pub fn has(&self, feature: Feature) -> bool {
        self.version.has(feature)
    }

    pub fn text(&self, name: Name) -> &'a str {
        self.names.text(name)
    }

    pub fn token(&self, id: TokenId) -> Token {
        let tokens = &self.tokens.tokens;
        let token = tokens.get(id as usize).or(tokens.last());
        token.copied().unwrap_or(Token::END)
    }

    pub fn token_span(&self, id: TokenId) -> Span {
        self.span(Extent::token(id))
    }

    /// Source span of code: in a macro's definition, if its body supplied all of it.
    pub fn span(&self, extent: Extent) -> Span {
        self.tokens.place(self.sources, extent.first, extent.last)
    }

    pub fn expr_span(&self, id: ExprId) -> Span {
        self.span(self.tree.expr(id).extent)
    }

    pub fn expr_text(&self, id: ExprId) -> &'a str {
        self.sources.text(self.expr_span(id))
    }

    /// Whether all tokens of a node are in the source text, outside any macro call.
    pub fn is_direct(&self, extent: Extent) -> bool {
        self.tokens.are_direct(extent.first, extent.last)
    }

    /// The outermost span that supplies a node and nothing else, which may be a macro call, an argument of one,
    /// or a part of a macro's body.
    pub fn exact_place(&self, extent: Extent) -> Option<ExactPlace> {
        match self.is_direct(extent) {
            true => Some(ExactPlace {
                span: self.span(extent),
                in_body: false,
                has_params: false,
            }),
            false => self
                .tokens
                .exact_place(self.sources, extent.first, extent.last),
        }
    }

    /// Whether a token is in a host's prelude.
    pub fn is_prelude(&self, token: TokenId) -> bool {
        let span = self.token_span(token);
        self.sources
            .file_at(span.start)
            .is_some_and(|f| f.role == Role::Prelude)
    }

    /// Whether the host declares the shader's outputs and forwards the result to them.
    pub fn is_called_by_host(&self) -> bool {
        let entry = self.dialect.host().entry;
        entry.is_none_or(EntryPoint::is_called_by_host)
    }

    /// The token of a number literal, looking through parentheses and signs.
    pub fn literal_token(&self, id: ExprId) -> Option<Token> {
        self.literal(id).map(|token| self.token(token))
    }

    /// The same, by its number.
    pub fn literal(&self, id: ExprId) -> Option<TokenId> {
        let mut at = id;
        loop {
            match self.tree.expr(at).kind {
                ExprKind::Paren(inner) | ExprKind::Unary(UnaryOp::Minus | UnaryOp::Plus, inner) => {
                    at = inner
                }
                ExprKind::Int(_) | ExprKind::Uint(_) | ExprKind::Float(_) => {
                    return Some(self.tree.expr(at).extent.first);
                }
                _ => return None,
            }
        }
    }

    /// Where a name is declared at global scope after a token.
    pub fn declared_later(&self, name: Name, token: TokenId) -> Option<Span> {
        let tree = self.tree;
        tree.items.iter().find_map(|item| {
            let ident = match *item {
                Item::Function(id) => tree.function(id)?.ident,
                Item::Decl(id) => match tree.decl(id)?.kind {
                    DeclKind::Variables { declarators, .. } => {
                        tree.declarators(declarators)
                            .iter()
                            .find(|d| d.ident.name == name)?
                            .ident
                    }
                    _ => return None,
                },
            };
            (ident.name == name && ident.token > token).then(|| self.token_span(ident.token))
        })
    }
}

/// A shader with the types of its expressions, as far as it has been checked.
pub trait Typed<'a>: Deref<Target = ParsedView<'a>> {
    /// Types and values of expressions, by [`ExprId`].
    fn exprs(&self) -> &[ExprInfo];

    /// The structs and blocks declared so far.
    fn structs(&self) -> &[Struct];

    fn info(&self, id: ExprId) -> ExprInfo {
        let info = self.exprs().get(id.0 as usize);
        info.copied().unwrap_or(ExprInfo::ERROR)
    }

    fn ty(&self, id: ExprId) -> Type {
        self.info(id).ty
    }

    fn name_of(&self, ty: Type) -> String {
        type_name(ty, |id| struct_name(self.structs(), self.names, id))
    }

    /// Type information of this shader.
    fn types(&self) -> Types<'_> {
        Types {
            structs: self.structs(),
            version: self.version,
        }
    }

    /// The variable that an expression refers to, ignoring parentheses.
    fn variable_of(&self, id: ExprId) -> Option<VariableId> {
        match self.info(self.tree.unparen(id)).resolution {
            Resolution::Variable(id) => Some(id),
            _ => None,
        }
    }

    /// An expression and its subexpressions in reverse order; operands are stored directly before
    /// it.
    fn subtree(&self, id: ExprId) -> impl Iterator<Item = (ExprId, &ExprInfo, &'a Expr)> {
        let tree = self.tree;
        let extent = tree.expr(id).extent;
        let before = (0..=id.0).rev().map(ExprId);
        let before = before.map_while(move |e| {
            let info = self.exprs().get(e.0 as usize)?;
            Some((e, info, tree.exprs.get(e.0 as usize)?))
        });
        before
            .take_while(move |(_, _, e)| e.extent.first >= extent.first)
            .filter(move |(_, _, e)| e.extent.last <= extent.last)
    }
}

/// Whether an integer literal without its suffix is decimal, so that its digits have the same value as
/// a float.
pub fn is_decimal(digits: &str) -> bool {
    let is_octal = digits.len() > 1 && digits.starts_with('0');
    !digits.is_empty() && !is_octal && digits.bytes().all(|b| b.is_ascii_digit())
}

/// `mySample` for `sample`: a name for what a shader declares where the language has `sample`.
pub fn own_name(word: &str) -> String {
    let mut chars = word.chars();
    let first = chars.next().map(|c| c.to_ascii_uppercase());
    first.into_iter().fold("my".to_string(), |mut name, c| {
        name.push(c);
        name
    }) + chars.as_str()
}
