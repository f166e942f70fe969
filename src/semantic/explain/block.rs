//! Members of uniform blocks that are used with or without the instance name by mistake.

use super::*;

const NO_INSTANCE: &str =
    "the block has no instance name, so its members are global names (section 4.3.7)";
const INSTANCE: &str =
    "members of a block with an instance name are accessed through it (section 4.3.7)";

impl ExplainContext<'_> {
    /// Adds the correct access to an error about a name that a block declares, or that is used in
    /// place of a block.
    pub(crate) fn advise_block(
        &self,
        d: Diagnostic,
        name: Name,
        token: TokenId,
    ) -> Option<Diagnostic> {
        if let Some(instance) = self.instance_with(name) {
            let to = format!("{}.{}", self.text(instance), self.text(name));
            let mut edits = self.rename_all(name, &to);
            // The declarations of members keep their names.
            let decls: Vec<Span> = self
                .tree
                .structs
                .iter()
                .map(|s| self.span(s.extent))
                .collect();
            edits.retain(|e| !decls.iter().any(|d| d.contains(e.span)));
            let fix = Fix::suggestion(format!("use `{to}`"), edits);
            return Some(
                d.note(INSTANCE)
                    .fix(Some(fix).filter(|f| !f.edits.is_empty())),
            );
        }
        let dot = self.token(token + 1);
        let member = self.token(token + 2);
        let is_access = (dot.kind, member.kind) == (TokenKind::Dot, TokenKind::Identifier);
        if !is_access || !self.token(token).is_direct() || !member.is_direct() {
            return None;
        }
        let member_name = Name(member.value);
        if self.is_global_member(member_name) {
            let gap = Span::new(self.token_span(token).start, member.span.start);
            let title = format!("use `{}`", self.text(member_name));
            return Some(
                d.note(NO_INSTANCE)
                    .fix(Fix::suggestion(title, vec![Edit::delete(gap)])),
            );
        }
        let instance = self.instance_with(member_name)?;
        let to = self.text(instance);
        let edit = Edit::replace(self.token_span(token), to);
        let title = format!("use `{to}`");
        Some(d.note(INSTANCE).fix(Fix::suggestion(title, vec![edit])))
    }

    /// Whether a block without an instance name declares this member.
    fn is_global_member(&self, name: Name) -> bool {
        self.blocks()
            .any(|(members, instance)| instance.is_none() && self.declares(members, name))
    }

    /// The instance name of the block that declares this member.
    fn instance_with(&self, name: Name) -> Option<Name> {
        let mut blocks = self.blocks();
        blocks.find_map(|(members, instance)| {
            let instance = instance.filter(|i| i.arrays.len == 0)?;
            self.declares(members, name).then_some(instance.ident.name)
        })
    }

    fn blocks(&self) -> impl Iterator<Item = (StructId, Option<Declarator>)> {
        self.tree.decls.iter().filter_map(|d| match d.kind {
            DeclKind::Block {
                members, instance, ..
            } => Some((members, instance)),
            _ => None,
        })
    }

    fn declares(&self, members: StructId, name: Name) -> bool {
        let fields = self
            .tree
            .structure(members)
            .map_or(&[][..], |s| self.tree.fields(s.fields));
        let mut names = fields
            .iter()
            .flat_map(|f| self.tree.declarators(f.declarators));
        names.any(|d| d.ident.name == name)
    }
}

#[cfg(test)]
mod tests {
    use crate::analyze_fragment;
    use shaderlint_text::apply_edits;

    /// Checks the text after the fix of the first error, in a shader with this block.
    fn check(block: &str, code: &str, expected: &str) {
        let text = |code: &str| {
            format!(
                "#version 300 es\nprecision highp float;\nuniform Camera {{ mat4 view; vec4 tint; }}{block};\n\
                 out vec4 color;\nvoid main() {{ color = {code}; }}\n"
            )
        };
        let found = analyze_fragment(&text(code)).diagnostics;
        let fix = found.first().and_then(|d| d.fix.as_ref()).unwrap();
        let fixed = apply_edits(&text(code), 0, &fix.edits).unwrap();
        assert_eq!(fixed, text(expected));
    }

    #[test]
    fn members_are_accessed_as_the_block_declares_them() {
        check("", "cam.view[0]", "view[0]");
        check("", "Camera.tint", "tint");
        check(" cam", "Camera.tint * 2.0", "cam.tint * 2.0");
        check(" cam", "camera.tint * 2.0", "cam.tint * 2.0");
        check(" cam", "tint + tint", "cam.tint + cam.tint");
    }
}
