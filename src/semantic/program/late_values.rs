//! Initial values of global variables that are not constant: GLSL ES 1.00 accepts some, GLSL ES 3.00
//! does not.

use super::Program;
use shaderlint_syntax::TokenKind;
use shaderlint_syntax::ast::{
    DeclKind, Declarator, ExprId, Extent, FunctionDecl, Item, Qualifier, QualifierKind, TokenId,
};
use shaderlint_text::{Edit, Span};

fn span_of(program: &Program, token: TokenId) -> Option<Span> {
    let token = program.token(token)?;
    token.is_direct().then_some(token.span)
}

/// Moves the initial values that `is_late` selects to the start of `main`, in order of declaration. No
/// edits if it selects none; `None` if one cannot be moved.
pub fn late_values(
    program: &Program,
    main: &FunctionDecl,
    is_late: impl Fn(ExprId) -> bool,
) -> Option<Vec<Edit>> {
    let open = span_of(program, program.tree.stmt(main.body?).extent.first)?;
    let mut edits = Vec::new();
    let mut values = String::new();
    for (qualifiers, declarator) in globals(program) {
        if !declarator.init.is_some_and(&is_late) {
            continue;
        }
        let value = late_value(program, main, declarator)?;
        let end = program.span(declarator.extent).end;
        edits.push(Edit::delete(Span::new(value.from, end)));
        let constant = qualifiers.iter().find(|q| q.kind == QualifierKind::Const);
        if let Some(q) = constant {
            let word = span_of(program, q.extent.first)?;
            let next = span_of(program, q.extent.first + 1)?;
            let removed = Edit::delete(Span::new(word.start, next.start));
            if !edits.contains(&removed) {
                edits.push(removed);
            }
        }
        values.push_str(&value.statement);
    }
    if !values.is_empty() {
        edits.push(Edit::insert(open.end, values));
    }
    Some(edits)
}

/// The global variables, with the qualifiers of their declarations.
pub fn globals(program: &Program) -> impl Iterator<Item = (&[Qualifier], &Declarator)> {
    let tree = &program.tree;
    tree.items
        .iter()
        .filter_map(|item| match item {
            Item::Decl(id) => tree.decl(*id),
            Item::Function(_) => None,
        })
        .filter_map(|decl| match decl.kind {
            DeclKind::Variables {
                qualifiers,
                declarators,
                ..
            } => Some((tree.qualifiers(qualifiers), tree.declarators(declarators))),
            _ => None,
        })
        .flat_map(|(qualifiers, all)| all.iter().map(move |d| (qualifiers, d)))
}

/// Whether code uses a macro that is defined more than once, so that it may mean something else in `main`.
fn is_redefined(program: &Program, code: Extent) -> bool {
    let all = &program.tokens;
    let own = (code.first..=code.last).filter_map(|i| all.tokens.get(i as usize));
    let mut names: Vec<_> = own
        .flat_map(|token| {
            let first = all.expansions.get(token.expansion as usize);
            std::iter::successors(first, |e| all.expansions.get(e.parent as usize))
        })
        .filter_map(|e| Some(all.macros.get(e.definition.0 as usize)?.name))
        .collect();
    names.sort_unstable();
    names.dedup();
    let is_used = |name| names.binary_search(&name).is_ok();
    let mut defined: Vec<_> = all
        .macros
        .iter()
        .map(|m| m.name)
        .filter(|n| is_used(*n))
        .collect();
    let count = defined.len();
    defined.sort_unstable();
    defined.dedup();
    defined.len() < count
}

struct LateValue {
    /// Start of the part with the value: after the name and its array sizes.
    from: u32,
    statement: String,
}

/// Assigns the initial value of a variable later; `None` if a parameter of the entry function hides
/// a name in it, or if the value determines an array size.
fn late_value(program: &Program, main: &FunctionDecl, of: &Declarator) -> Option<LateValue> {
    let tree = &program.tree;
    // The value may come from macros, but not what surrounds it: they would supply only a part of it.
    let init = program.tree.expr(of.init?).extent;
    span_of(program, of.extent.first)?;
    span_of(program, init.first.checked_sub(1)?).and(span_of(program, of.extent.last + 1))?;
    if is_redefined(program, init) {
        return None;
    }
    let sizes = tree.arrays(of.arrays);
    if sizes.iter().any(|s| s.size.is_none()) {
        return None;
    }
    let hides: Vec<u32> = tree
        .params(main.params)
        .iter()
        .filter_map(|p| p.ident)
        .map(|i| i.name.0)
        .collect();
    let tokens = &program.tokens.tokens;
    let own = (of.extent.first..=of.extent.last).filter_map(|i| tokens.get(i as usize));
    for token in own {
        if token.kind == TokenKind::Identifier && hides.contains(&token.value) {
            return None;
        }
    }
    let last = sizes.last().map_or(of.ident.token, |s| s.extent.last);
    let from = span_of(program, last)?.end;
    let name = program.names.text(of.ident.name);
    let value = program.expr_text(of.init?);
    Some(LateValue {
        from,
        statement: format!("\n    {name} = {value};"),
    })
}
