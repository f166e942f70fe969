//! Members of uniform blocks that are used with or without the instance name by mistake.

use crate::messages::*;

const NO_INSTANCE: &str =
    "the block has no instance name, so its members are global names (section 4.3.7)";
const INSTANCE: &str =
    "members of a block with an instance name are accessed through it (section 4.3.7)";

/// Maximum number of members of a block that are renamed.
const MAX_MEMBERS: usize = 30;
/// Maximum number of accesses to members that are corrected.
const MAX_ACCESSES: usize = 1_000;

impl ExplainContext<'_> {
    /// Adds the correct access to an error about a name that a block declares, or that is used in
    /// place of a block.
    pub(crate) fn advise_block(
        &self,
        d: Diagnostic,
        name: Name,
        token: TokenId,
    ) -> Option<Diagnostic> {
        if let Some((members, instance)) = self.instance_with(name) {
            let to = format!("{}.{}", self.text(instance), self.text(name));
            // The other members are used in the same way.
            let is_unknown = |n: &Name| *n == name || self.is_declared_once(*n);
            let names = self.member_names(members).filter(is_unknown);
            let access = |n: Name| format!("{}.{}", self.text(instance), self.text(n));
            let mut edits: Vec<Edit> = names
                .take(MAX_MEMBERS)
                .flat_map(|n| self.rename_all(n, &access(n)))
                .collect();
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
            let title = format!("use `{}`", self.text(member_name));
            let fix = Fix::suggestion(title, self.without_object(name));
            return Some(d.note(NO_INSTANCE).fix(fix));
        }
        let (_, instance) = self.instance_with(member_name)?;
        let to = self.text(instance);
        let edit = Edit::replace(self.token_span(token), to);
        let title = format!("use `{to}`");
        Some(d.note(INSTANCE).fix(Fix::suggestion(title, vec![edit])))
    }

    /// Edits that remove `name.` before members of blocks without an instance name.
    fn without_object(&self, name: Name) -> Vec<Edit> {
        let all = &self.tokens.tokens;
        let accesses = all.windows(3).filter_map(|w| match w {
            [object, dot, member]
                if (object.kind, object.value) == (TokenKind::Identifier, name.0)
                    && (dot.kind, member.kind) == (TokenKind::Dot, TokenKind::Identifier)
                    && object.is_direct()
                    && member.is_direct() =>
            {
                Some((object.span.start, member.span.start, Name(member.value)))
            }
            _ => None,
        });
        let accesses = accesses.take(MAX_ACCESSES);
        let members = accesses.filter(|(_, _, member)| self.is_global_member(*member));
        members
            .map(|(start, end, _)| Edit::delete(Span::new(start, end)))
            .collect()
    }

    /// Whether no variable and no other member has the name of a member.
    fn is_declared_once(&self, name: Name) -> bool {
        let all = &self.tree.declarator_lists;
        let has_name = |d: &&Declarator| d.ident.name == name;
        self.affords(all.len())
            && self.scopes().get(name).is_none()
            && all.iter().filter(has_name).count() == 1
    }

    /// Whether a block without an instance name declares this member.
    fn is_global_member(&self, name: Name) -> bool {
        self.blocks()
            .any(|(members, instance)| instance.is_none() && self.declares(members, name))
    }

    /// The members and the instance name of the block that declares this member.
    fn instance_with(&self, name: Name) -> Option<(StructId, Name)> {
        let mut blocks = self.blocks();
        blocks.find_map(|(members, instance)| {
            let instance = instance.filter(|i| i.arrays.len == 0)?;
            self.declares(members, name)
                .then_some((members, instance.ident.name))
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
        self.member_names(members).any(|n| n == name)
    }

    fn member_names(&self, members: StructId) -> impl Iterator<Item = Name> {
        let fields = self
            .tree
            .structure(members)
            .map_or(&[][..], |s| self.tree.fields(s.fields));
        fields
            .iter()
            .flat_map(|f| self.tree.declarators(f.declarators))
            .map(|d| d.ident.name)
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
    fn block_members_are_accessed_through_the_instance_name() {
        check("", "cam.view[0]", "view[0]");
        check("", "Camera.tint", "tint");
        check(" cam", "Camera.tint * 2.0", "cam.tint * 2.0");
        check(" cam", "camera.tint * 2.0", "cam.tint * 2.0");
        check(" cam", "tint + tint", "cam.tint + cam.tint");
        check("", "cam.view * cam.tint", "view * tint");
        check(" cam", "view * tint", "cam.view * cam.tint");
    }
}
