//! Declarations, types and functions (GLSL ES 3.00 sections 4 and 6.1).

use super::token_repair::FaultScope;
use super::{Parsed, Parser, Reported, append, since};
use crate::ast::*;
use crate::names::{Name, TypeWord, Version};
use crate::token::TokenKind;
use shaderlint_diagnostic::{Diagnostic, Fix, Subject, error};
use shaderlint_text::{Edit, Span};

/// Longest remainder of a parameter list that is scanned, in tokens.
const MAX_PARAMS: usize = 60;

impl Parser<'_> {
    /// Parses all items up to the end of the shader.
    pub(super) fn translation_unit(&mut self) {
        while !self.is(TokenKind::End) {
            self.item_or_error();
        }
    }

    /// Parses one item at global scope; on errors, skips to the next one.
    pub(super) fn item_or_error(&mut self) {
        let start = self.checkpoint();
        loop {
            let item = self.item_as_it_is();
            let reported = self.diagnostics.get(start.diagnostics).cloned();
            let from = self.first_to_read(start, &[self.item_before]);
            if !self.repair_token(from.at, FaultScope::Global, reported) {
                self.tree.items.extend(item);
                self.item_before = Some(start);
                return;
            }
            self.go_back(from);
            if from.at != start.at {
                self.item_before = None;
                return;
            }
        }
    }

    fn item_as_it_is(&mut self) -> Option<Item> {
        let first = self.id();
        let mark = self.tree.exprs.len();
        match self.item() {
            Ok(item) => item,
            Err(Reported) => {
                self.depth = 0;
                self.tree.exprs.truncate(mark);
                self.skip_item(first);
                self.lose_names(first);
                None
            }
        }
    }

    fn item(&mut self) -> Parsed<Option<Item>> {
        match self.peek() {
            TokenKind::Semicolon => {
                self.stray_semicolon();
                return Ok(None);
            }
            TokenKind::RightBrace => {
                let d = self.error_here(error::UNCLOSED_DELIMITER, "unmatched `}`");
                self.report(d.about(Subject::Brace));
                self.advance();
                return Ok(None);
            }
            TokenKind::Bad => {
                self.advance();
                return Ok(None);
            }
            _ => {}
        }
        if !self.at_global_declaration() {
            return Err(self.code_outside_function());
        }
        if self.is(TokenKind::Precision) {
            return Ok(Some(Item::Decl(self.precision()?)));
        }
        let first = self.id();
        let qualifiers = self.qualifiers()?;
        if let Some(decl) = self.qualified_name_or_block(first, qualifiers)? {
            return Ok(Some(Item::Decl(decl)));
        }
        let ty = self.type_spec()?;
        if self.names_a_function() {
            return self.function(first, qualifiers, ty).map(Some);
        }
        Ok(Some(Item::Decl(self.variables(first, qualifiers, ty)?)))
    }

    /// Whether a name and `(` follow.
    fn names_a_function(&self) -> bool {
        !matches!(
            self.kind(0),
            TokenKind::Semicolon | TokenKind::Comma | TokenKind::Equal
        ) && self.kind(1) == TokenKind::LeftParen
    }

    /// Parses a declaration inside a function.
    pub(super) fn declaration(&mut self) -> Parsed<DeclId> {
        if self.is(TokenKind::Precision) {
            return self.precision();
        }
        let first = self.id();
        let qualifiers = self.qualifiers()?;
        if let Some(decl) = self.qualified_name_or_block(first, qualifiers)? {
            return Ok(decl);
        }
        let ty = self.type_spec()?;
        if self.names_a_function() {
            return match self.function(first, qualifiers, ty)? {
                Item::Decl(decl) => Ok(decl),
                Item::Function(_) => Err(Reported),
            };
        }
        self.variables(first, qualifiers, ty)
    }

    /// Parses `bool go = ...` as the condition of a loop.
    pub(super) fn condition_declaration(&mut self) -> Parsed<DeclId> {
        let first = self.id();
        let qualifiers = self.qualifiers()?;
        let ty = self.type_spec()?;
        let declarator = self.declarator(ty)?;
        let declarators = append(&mut self.tree.declarator_lists, [declarator]);
        Ok(self.push_decl(
            DeclKind::Variables {
                qualifiers,
                ty,
                declarators,
            },
            first,
        ))
    }

    fn push_decl(&mut self, kind: DeclKind, first: TokenId) -> DeclId {
        let extent = self.extent_from(first);
        self.tree.decls.push(Declaration { kind, extent });
        DeclId(self.tree.decls.len() as u32 - 1)
    }

    fn precision(&mut self) -> Parsed<DeclId> {
        let first = self.advance();
        let precision = match self.peek() {
            TokenKind::Lowp => QualifierKind::Lowp,
            TokenKind::Mediump => QualifierKind::Mediump,
            TokenKind::Highp => QualifierKind::Highp,
            _ => return Err(self.unexpected("`lowp`, `mediump` or `highp`")),
        };
        self.advance();
        let ty = self.type_spec()?;
        self.semicolon()?;
        Ok(self.push_decl(DeclKind::Precision { precision, ty }, first))
    }

    /// Parses `invariant a;`, `layout(std140) uniform;` or `uniform Block { ... };`, if present.
    fn qualified_name_or_block(
        &mut self,
        first: TokenId,
        qualifiers: List,
    ) -> Parsed<Option<DeclId>> {
        if qualifiers.len == 0 {
            return Ok(None);
        }
        let kind = match (self.kind(0), self.kind(1)) {
            (TokenKind::Semicolon, _) => DeclKind::Qualifiers {
                qualifiers,
                ident: None,
            },
            (TokenKind::Identifier, TokenKind::Semicolon) => {
                let ident = self.ident("a name")?;
                DeclKind::Qualifiers {
                    qualifiers,
                    ident: Some(ident),
                }
            }
            (TokenKind::Identifier | TokenKind::Reserved, TokenKind::LeftBrace) => {
                self.interface_block(qualifiers)?
            }
            _ => return Ok(None),
        };
        self.semicolon()?;
        Ok(Some(self.push_decl(kind, first)))
    }

    fn interface_block(&mut self, qualifiers: List) -> Parsed<DeclKind> {
        let first = self.id();
        let name = self.ident("a block name")?;
        let members = self.members(Some(name), first)?.ok_or(Reported)?;
        let instance = if self.is(TokenKind::Semicolon) {
            None
        } else {
            let first = self.id();
            let ident = self.ident("a name or `;`")?;
            let arrays = self.array_sizes()?;
            Some(Declarator {
                ident,
                arrays,
                init: None,
                extent: self.extent_from(first),
            })
        };
        Ok(DeclKind::Block {
            qualifiers,
            members,
            instance,
        })
    }

    /// Parses `{ type a; ... }`; `None` if a member cannot be parsed.
    fn members(&mut self, name: Option<Ident>, first: TokenId) -> Parsed<Option<StructId>> {
        let open = self.id();
        self.expect(TokenKind::LeftBrace, "`{`")?;
        let mut fields = Vec::new();
        let mut is_file = true;
        while !self.is(TokenKind::RightBrace) {
            if self.is(TokenKind::End) || self.at_function() {
                self.missing_brace(open);
                break;
            }
            match self.field() {
                Ok(field) => fields.push(field),
                Err(Reported) => {
                    is_file = false;
                    self.skip_field();
                }
            }
        }
        if !is_file {
            self.lose_names(open + 1);
        }
        self.eat(TokenKind::RightBrace);
        if !is_file {
            return Ok(None);
        }
        if let (Some(structs), Some(name)) = (&mut self.structs, name) {
            structs.insert(name.name);
        }
        let fields = append(&mut self.tree.field_lists, fields);
        let extent = self.extent_from(first);
        self.tree.structs.push(StructDecl {
            name,
            fields,
            extent,
        });
        Ok(Some(StructId(self.tree.structs.len() as u32 - 1)))
    }

    fn field(&mut self) -> Parsed<FieldDecl> {
        let first = self.id();
        let qualifiers = self.qualifiers()?;
        let ty = self.type_spec()?;
        let mut declarators = Vec::new();
        loop {
            let first = self.id();
            let ident = self.ident("a member name")?;
            let arrays = self.array_sizes()?;
            if self.is(TokenKind::Equal) {
                let d =
                    self.error_here(error::FOREIGN_SYNTAX, "a member cannot have an initializer");
                self.report(d.note("members are set by the constructor or by assignment"));
                return Err(Reported);
            }
            let extent = self.extent_from(first);
            declarators.push(Declarator {
                ident,
                arrays,
                init: None,
                extent,
            });
            if self.eat(TokenKind::Comma).is_none() {
                break;
            }
        }
        self.semicolon()?;
        let declarators = append(&mut self.tree.declarator_lists, declarators);
        Ok(FieldDecl {
            qualifiers,
            ty,
            declarators,
            extent: self.extent_from(first),
        })
    }

    fn variables(&mut self, first: TokenId, qualifiers: List, ty: TypeId) -> Parsed<DeclId> {
        let start = self.tree.declarator_lists.len();
        let mut is_file = true;
        if !self.is(TokenKind::Semicolon) {
            if !self.is(TokenKind::Comma) {
                let declarator = self.declarator(ty)?;
                self.tree.declarator_lists.push(declarator);
            }
            while self.eat(TokenKind::Comma).is_some() {
                let Ok(declarator) = self.declarator(ty) else {
                    is_file = false;
                    break;
                };
                self.tree.declarator_lists.push(declarator);
            }
        }
        // The names count as declared even if the rest cannot be parsed.
        if !is_file || self.semicolon().is_err() {
            self.forget_initializer(start);
            let from = self.id();
            self.skip_statement(first);
            self.lose_names(from);
        }
        let declarators = since(&self.tree.declarator_lists, start);
        Ok(self.push_decl(
            DeclKind::Variables {
                qualifiers,
                ty,
                declarators,
            },
            first,
        ))
    }

    /// Marks the initializer of the last declarator from `start` on as unknown.
    fn forget_initializer(&mut self, start: usize) {
        let own = self.tree.declarator_lists.get(start..);
        let Some(last) = own.and_then(<[_]>::last).filter(|d| d.init.is_some()) else {
            return;
        };
        let unknown = self.error_expr(last.extent.first);
        if let Some(last) = self.tree.declarator_lists.last_mut() {
            last.init = Some(unknown);
        }
    }

    fn declarator(&mut self, ty: TypeId) -> Parsed<Declarator> {
        let first = self.id();
        self.refuse_pointer();
        let ident = self.ident("a name")?;
        let arrays = self.array_sizes()?;
        let mut init = None;
        if self.eat(TokenKind::Equal).is_some() {
            let start = self.id();
            let is_array = arrays.len > 0;
            init = Some(if self.is(TokenKind::LeftBrace) {
                self.initializer_list(ty, is_array)
            } else {
                match self.root_assignment() {
                    Ok(init) => init,
                    Err(Reported) => {
                        self.skip_initializer(start);
                        self.error_expr(start)
                    }
                }
            });
        }
        Ok(Declarator {
            ident,
            arrays,
            init,
            extent: self.extent_from(first),
        })
    }

    /// Reports `*` or `&` before a declared name: C pointers and C++ references.
    fn refuse_pointer(&mut self) {
        if !matches!(self.peek(), TokenKind::Star | TokenKind::And) {
            return;
        }
        let what = if self.is(TokenKind::Star) {
            "pointers"
        } else {
            "references"
        };
        let d = self.error_here(error::FOREIGN_SYNTAX, format!("GLSL has no {what}"));
        self.report(d.help("declare the parameter `out` or `inout` to write to it"));
        self.advance();
    }

    /// Parses `[2]`, `[]` or `[2][3]`; the last form is reported later.
    pub(super) fn array_sizes(&mut self) -> Parsed<List> {
        if !self.is(TokenKind::LeftBracket) {
            return Ok(List::default());
        }
        let mut sizes = Vec::new();
        while self.is(TokenKind::LeftBracket) {
            let open = self.advance();
            let size = if self.is(TokenKind::RightBracket) {
                None
            } else {
                Some(self.root_expression()?)
            };
            self.reject_comma(size);
            self.close(TokenKind::RightBracket, open)?;
            sizes.push(ArraySize {
                size,
                extent: self.extent_from(open),
            });
        }
        Ok(append(&mut self.tree.array_lists, sizes))
    }

    /// Reports `float a[1, 2]`, which the grammar of GLSL ES 1.00 excludes; the checker rejects it in 3.00.
    fn reject_comma(&mut self, size: Option<ExprId>) {
        let kind = size.map(|size| self.tree.expr(size).kind);
        if let Some(ExprKind::Comma(left, _)) = kind
            && self.version == Version::Es100
        {
            let comma = self.token(self.tree.expr(left).extent.last as usize + 1);
            let message = "expected `]`, found `,`";
            let d = Diagnostic::error(error::SYNTAX_ERROR, comma.span, message);
            self.report_at(d, &comma);
        }
    }

    /// Parses a type with the array sizes after it.
    pub(super) fn type_spec(&mut self) -> Parsed<TypeId> {
        let first = self.id();
        let token = self.next();
        let base = match token.kind {
            TokenKind::Type => {
                self.advance();
                TypeWord::ALL
                    .get(token.value as usize)
                    .map_or(TypeBase::Error, |&w| TypeBase::Word(w))
            }
            TokenKind::Void => {
                self.advance();
                TypeBase::Void
            }
            TokenKind::Identifier => {
                self.advance();
                self.has_unknown_types |= self.is_unknown_type(Name(token.value));
                TypeBase::Name(Name(token.value))
            }
            TokenKind::Struct => self.structure()?,
            TokenKind::Reserved => self.reserved_type(),
            _ => return Err(self.unexpected("a type")),
        };
        let arrays = self.array_sizes()?;
        let extent = self.extent_from(first);
        self.tree.types.push(TypeSpec {
            base,
            arrays,
            extent,
        });
        Ok(TypeId(self.tree.types.len() as u32 - 1))
    }

    fn structure(&mut self) -> Parsed<TypeBase> {
        let first = self.advance();
        let name = if self.is(TokenKind::LeftBrace) {
            None
        } else {
            Some(self.ident("a name or `{`")?)
        };
        self.enter()?;
        let members = self.members(name, first);
        self.leave();
        Ok(match members? {
            Some(id) => TypeBase::Struct(id),
            None => {
                self.tree.lost.extend(name.map(|n| n.name));
                TypeBase::Error
            }
        })
    }

    /// Parses the qualifiers before a type.
    pub(super) fn qualifiers(&mut self) -> Parsed<List> {
        let start = self.tree.qualifier_lists.len();
        loop {
            use QualifierKind as Q;
            let first = self.id();
            let kind = match self.peek() {
                TokenKind::Const => Q::Const,
                TokenKind::In => Q::In,
                TokenKind::Out => Q::Out,
                TokenKind::Inout => Q::Inout,
                TokenKind::Centroid => Q::Centroid,
                TokenKind::Uniform => Q::Uniform,
                TokenKind::Attribute => Q::Attribute,
                TokenKind::Varying => Q::Varying,
                TokenKind::Flat => Q::Flat,
                TokenKind::Smooth => Q::Smooth,
                TokenKind::Invariant => Q::Invariant,
                TokenKind::Lowp => Q::Lowp,
                TokenKind::Mediump => Q::Mediump,
                TokenKind::Highp => Q::Highp,
                TokenKind::Layout => Q::Layout(self.layout()?),
                TokenKind::Reserved => match self.reserved_qualifier() {
                    Some(Some(kind)) => kind,
                    Some(None) => continue,
                    None => break,
                },
                _ => break,
            };
            if !matches!(kind, Q::Layout(_)) {
                self.advance();
            }
            let extent = self.extent_from(first);
            self.tree.qualifier_lists.push(Qualifier { kind, extent });
        }
        Ok(since(&self.tree.qualifier_lists, start))
    }

    /// Parses `layout(std140, location = 1)`.
    fn layout(&mut self) -> Parsed<List> {
        self.advance();
        let open = self.id();
        self.expect(TokenKind::LeftParen, "`(` after `layout`")?;
        let mut entries = Vec::new();
        loop {
            let ident = self.ident("a layout qualifier")?;
            let mut value = None;
            if self.eat(TokenKind::Equal).is_some() {
                let token = self.next();
                if !matches!(token.kind, TokenKind::Int | TokenKind::Uint) {
                    return Err(self.unexpected("a number"));
                }
                value = Some(LayoutValue {
                    value: token.value as i32,
                    token: self.advance(),
                });
            }
            entries.push(LayoutEntry { ident, value });
            if self.eat(TokenKind::Comma).is_none() {
                break;
            }
        }
        self.close(TokenKind::RightParen, open)?;
        Ok(append(&mut self.tree.layout_lists, entries))
    }

    /// Parses a function or prototype after its qualifiers and return type.
    fn function(&mut self, first: TokenId, qualifiers: List, ty: TypeId) -> Parsed<Item> {
        let ident = self.ident("a function name")?;
        let open = self.advance();
        let params = self.params(open)?;
        let header = self.extent_from(first);
        let mut function = FunctionDecl {
            qualifiers,
            ty,
            ident,
            params,
            body: None,
            header,
            extent: header,
        };
        if self.is(TokenKind::LeftBrace) {
            self.function_open = self.id();
            function.body = Some(self.block()?);
            function.extent = self.extent_from(first);
            return Ok(Item::Function(self.push_function(function)));
        }
        if !self.is(TokenKind::Semicolon) {
            return Err(self.no_body());
        }
        self.advance();
        function.extent = self.extent_from(first);
        let id = self.push_function(function);
        Ok(Item::Decl(self.push_decl(DeclKind::Prototype(id), first)))
    }

    fn push_function(&mut self, function: FunctionDecl) -> FunctionId {
        self.tree.functions.push(function);
        FunctionId(self.tree.functions.len() as u32 - 1)
    }

    fn params(&mut self, open: TokenId) -> Parsed<List> {
        let mut params = Vec::new();
        if !self.is(TokenKind::RightParen) {
            loop {
                params.push(self.param()?);
                if self.eat(TokenKind::Comma).is_none() {
                    break;
                }
            }
        }
        self.close(TokenKind::RightParen, open)?;
        Ok(append(&mut self.tree.param_lists, params))
    }

    fn param(&mut self) -> Parsed<Param> {
        let first = self.id();
        let qualifiers = self.qualifiers()?;
        let ty = self.type_spec()?;
        self.refuse_pointer();
        let unnamed = matches!(
            self.peek(),
            TokenKind::Comma | TokenKind::RightParen | TokenKind::LeftBracket
        );
        if unnamed && self.lacks_type(ty) {
            self.at = self.tree.ty(ty).extent.first as usize;
            return Err(self.unexpected("a parameter type"));
        }
        let ident = if unnamed {
            None
        } else {
            Some(self.ident("a parameter name")?)
        };
        let arrays = if ident.is_some() {
            self.array_sizes()?
        } else {
            List::default()
        };
        let extent = self.extent_from(first);
        if self.is(TokenKind::Equal) {
            self.default_argument()?;
        }
        Ok(Param {
            qualifiers,
            ty,
            ident,
            arrays,
            extent,
        })
    }

    /// Whether the type of an unnamed parameter is really the parameter's name, because no such
    /// type is declared.
    fn lacks_type(&self, ty: TypeId) -> bool {
        let TypeBase::Name(name) = self.tree.ty(ty).base else {
            return false;
        };
        let is_apart = matches!(self.peek(), TokenKind::Comma | TokenKind::RightParen);
        is_apart && self.is_unknown_type(name) && self.is_in_head()
    }

    /// Whether no struct of this name has been parsed so far.
    pub(super) fn is_unknown_type(&self, name: Name) -> bool {
        let structs = self.structs.as_ref();
        structs.is_some_and(|structs| !structs.contains(&name))
    }

    /// Whether the current parameter list ends before a `{`.
    fn is_in_head(&self) -> bool {
        let ends = |&at: &usize| {
            use TokenKind as T;
            matches!(
                self.token(at).kind,
                T::RightParen | T::Semicolon | T::LeftBrace | T::RightBrace
            )
        };
        let end = (self.at..self.at + MAX_PARAMS).find(ends);
        end.is_some_and(|at| {
            self.token(at).kind == TokenKind::RightParen
                && self.token(at + 1).kind == TokenKind::LeftBrace
        })
    }

    /// `= value` after a parameter, a default argument of C++: reports and skips it.
    fn default_argument(&mut self) -> Parsed<()> {
        let first = self.advance();
        let before = first.checked_sub(1);
        let before = before.map_or(0, |t| self.token(t as usize).span.end);
        let mark = self.tree.exprs.len();
        let value = self.root_assignment();
        self.tree.exprs.truncate(mark);
        value?;
        let span = self.span(self.extent_from(first));
        let d = Diagnostic::error(error::FOREIGN_SYNTAX, span, "GLSL has no default arguments")
            .note("a call must pass every argument")
            .help("add an overload with fewer parameters")
            .fix(Fix::suggestion(
                "remove the default value",
                vec![Edit::delete(Span::new(before, span.end))],
            ));
        let token = self.token(first as usize);
        self.report_at(d, &token);
        Ok(())
    }

    /// A function inside a function, which GLSL does not have: reports and skips it.
    pub(super) fn nested_function(&mut self) -> StmtId {
        let first = self.id();
        let mark = self.tree.exprs.len();
        while !self.is(TokenKind::LeftBrace) && !self.is(TokenKind::End) {
            let token = self.next();
            if token.kind == TokenKind::Identifier && self.kind(1) == TokenKind::LeftParen {
                self.tree.lost.push(Name(token.value));
            }
            self.advance();
        }
        let span = self.span(self.extent_from(first));
        self.skip_braces();
        self.tree.exprs.truncate(mark);
        let d = Diagnostic::error(
            error::LOCAL_FUNCTION,
            span,
            "a function cannot be defined inside another function",
        )
        .note("a `}` may be missing before it");
        let token = self.token(first as usize);
        self.report_at(d, &token);
        self.push_stmt(StmtKind::Error, first)
    }

    /// `;` at global scope, usually after the `}` of a function.
    fn stray_semicolon(&mut self) {
        let span = self.next().span;
        let after_brace = self.at > 0 && self.token(self.at - 1).kind == TokenKind::RightBrace;
        let message = if after_brace {
            "unexpected `;` after the function body"
        } else {
            "unexpected `;` outside a function"
        };
        let d = Diagnostic::error(error::STRAY_SEMICOLON, span, message)
            .note("GLSL ES has no empty declarations at global scope, unlike C and desktop GLSL")
            .fix(Fix::safe(
                "remove `;`",
                vec![Edit::delete(Span::new(span.start, span.end))],
            ));
        self.report(d);
        self.advance();
    }
}
