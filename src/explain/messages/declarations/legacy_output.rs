//! `gl_FragColor` and `gl_FragData`, which GLSL ES 3.00 replaces by declared outputs.

use crate::messages::*;
use shaderlint_semantic::interface::location;
use std::collections::BTreeMap;

/// Most outputs of a fragment shader.
const MAX_OUTPUTS: u32 = 8;

/// A declared output and its first location.
struct DeclaredOutput {
    name: Name,
    ty: Type,
    location: Option<u32>,
}

/// A use of `gl_FragColor` or `gl_FragData[n]`, and the location that it writes to.
struct OutputUse {
    span: Span,
    location: u32,
}

impl ExplainContext<'_> {
    pub(in crate::messages) fn legacy_output(&self, name: Name, token: TokenId) -> Diagnostic {
        let text = self.text(name);
        let message = match text {
            "gl_FragColor" | "gl_FragData" => format!("`{text}` was removed in GLSL ES 3.00"),
            _ => format!("`{text}` is not declared, and GLSL ES 3.00 has no `gl_FragColor`"),
        };
        let d = self.error_at(error::LEGACY_GLSL, token, message);
        if self.is_called_by_host() {
            return match self.host_output(name) {
                Some(fix) => d.fix(fix),
                None => d.help("assign to the first parameter of `mainImage` instead"),
            };
        }
        let d = d.note("a WebGL2 fragment shader must declare its outputs");
        let outputs = self.declared_outputs();
        let uses = self.output_uses(name, text == "gl_FragData");
        let fix = uses.and_then(|uses| self.name_outputs(&outputs, &uses));
        match fix {
            Some(fix) => d.fix(fix),
            None if outputs.is_empty() => {
                let free = self.names.unused("fragColor");
                d.help(format!(
                    "add `out vec4 {free};` at the top and assign to it"
                ))
            }
            None => d.help("assign to the declared output of the same location"),
        }
    }

    /// Replaces the output by the first parameter of the entry function, if all uses are in it.
    fn host_output(&self, name: Name) -> Option<Fix> {
        let entry = self.dialect.host().entry?;
        let mut functions = self.tree.functions.iter().filter(|f| f.body.is_some());
        let function = functions.find(|f| self.text(f.ident.name) == entry.name)?;
        let color = self.text(self.tree.params(function.params).first()?.ident?.name);
        let inside = self.span(function.extent);
        let uses = self.output_uses(name, false)?;
        let edits = uses.iter().map(|used| {
            inside
                .contains(used.span)
                .then(|| Edit::replace(used.span, color))
        });
        Some(Fix::safe(
            format!("assign to `{color}`"),
            edits.collect::<Option<_>>()?,
        ))
    }

    /// The fragment outputs that the shader declares.
    fn declared_outputs(&self) -> Vec<DeclaredOutput> {
        let tree = self.tree;
        let is_output = |v: &&Variable| v.storage == Storage::Output && v.token.is_some();
        let lines = tree.items.iter().filter_map(|item| match *item {
            Item::Decl(id) => tree.decl(id),
            Item::Function(_) => None,
        });
        let mut locations = BTreeMap::new();
        for line in lines {
            if let DeclKind::Variables {
                qualifiers,
                declarators,
                ..
            } = line.kind
                && let Some(at) = location(tree, tree.qualifiers(qualifiers))
            {
                let all = tree.declarators(declarators).iter();
                locations.extend(all.map(|d| (d.ident.token, at)));
            }
        }
        let outputs = self.variables.iter().filter(is_output);
        let outputs = outputs.map(|output| DeclaredOutput {
            name: output.name,
            ty: output.ty,
            location: output
                .token
                .and_then(|t| u32::try_from(*locations.get(&t)?).ok()),
        });
        outputs.collect()
    }

    /// The uses of a built-in output; `None` if one is in a macro, or its index is not a literal.
    fn output_uses(&self, name: Name, is_indexed: bool) -> Option<Vec<OutputUse>> {
        let tokens = &self.tokens.tokens;
        if !self.affords(tokens.len()) {
            return None;
        }
        let mut uses = Vec::new();
        for (i, token) in tokens.iter().enumerate() {
            if token.kind != TokenKind::Identifier || token.value != name.0 {
                continue;
            }
            let rest = tokens.get(i..i + 4).filter(|_| is_indexed);
            let is_direct = |all: &[Token]| all.iter().all(Token::is_direct);
            let (span, location) = match rest {
                Some(all @ [_, open, index, close])
                    if open.kind == TokenKind::LeftBracket
                        && index.kind == TokenKind::Int
                        && close.kind == TokenKind::RightBracket
                        && is_direct(all) =>
                {
                    (token.span.to(close.span), index.value)
                }
                None if !is_indexed && token.is_direct() => (token.span, 0),
                _ => return None,
            };
            uses.push(OutputUse { span, location });
        }
        Some(uses).filter(|uses| !uses.is_empty())
    }

    /// Replaces built-in outputs by the declared ones of the same location, and declares those that
    /// are missing.
    fn name_outputs(&self, outputs: &[DeclaredOutput], uses: &[OutputUse]) -> Option<Fix> {
        let mut names = BTreeMap::new();
        for used in uses {
            let location = used.location;
            if location >= MAX_OUTPUTS {
                return None;
            }
            names
                .entry(location)
                .or_insert(self.output_at(outputs, location)?);
        }
        let is_missing = |name: &Option<String>| name.is_none();
        let count = outputs.len() + names.values().filter(|name| is_missing(name)).count();
        let mut lines = String::new();
        for (&location, name) in names.iter_mut().filter(|(_, name)| is_missing(name)) {
            let free = match location {
                0 => self.names.unused("fragColor"),
                _ => self.names.unused(&format!("fragColor{location}")),
            };
            let layout = match (count, location) {
                (1, 0) => String::new(),
                _ => format!("layout(location = {location}) "),
            };
            lines.push_str(&format!("{layout}out vec4 {free};\n"));
            *name = Some(free);
        }
        // Several outputs all need a location.
        if count > 1 && outputs.iter().any(|output| output.location.is_none()) {
            return None;
        }
        let edit = |used: &OutputUse| {
            let name = names.get(&used.location)?.clone()?;
            Some(Edit::replace(used.span, name))
        };
        let mut edits: Vec<Edit> = uses.iter().filter_map(edit).collect();
        let all: Vec<String> = names.values().flatten().map(|n| format!("`{n}`")).collect();
        let title = match (lines.lines().next(), lines.lines().count()) {
            (None, _) if all.len() == 1 => format!("use the output {}", all.join("")),
            (None, _) => format!("use the outputs {}", all.join(", ")),
            (Some(line), 1) => format!("add `{line}` and assign to it"),
            (_, count) => format!("declare {count} outputs and assign to them"),
        };
        if !lines.is_empty() {
            edits.push(Edit::insert(self.first_declaration()?, lines));
        }
        Some(Fix::safe(title, edits))
    }

    /// How the output at a location is written; `Some(None)` if none is declared, `None` if it is not
    /// a `vec4`.
    fn output_at(&self, outputs: &[DeclaredOutput], location: u32) -> Option<Option<String>> {
        let found = outputs.iter().find_map(|output| {
            let first = output.location.unwrap_or(0);
            let index = location.checked_sub(first)?;
            (index < output.ty.array.max(1)).then_some((output, index))
        });
        let Some((output, index)) = found else {
            return Some(None);
        };
        let name = self.text(output.name);
        let is_color = output.ty.element() == Type::vector(Scalar::Float, 4);
        is_color.then(|| match output.ty.array {
            0 => Some(name.to_string()),
            _ => Some(format!("{name}[{index}]")),
        })
    }
}
