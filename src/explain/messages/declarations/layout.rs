//! Messages for [`LayoutError`].

use crate::messages::*;

impl Explain for LayoutError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use LayoutError as E;
        let report = |message: &str| c.error(error::INVALID_LAYOUT, at, message);
        match self {
            E::NotInWebgl(word) => report(&format!(
                "WebGL does not support block layout `{}`; use `std140`",
                c.text(word)
            )),
            E::NoNumber => report("`location` needs a number: `location = 0`"),
            E::Unknown(word) => {
                let message = format!("unknown layout qualifier `{}`", c.text(word));
                report(&message).fix(c.without_layout(at))
            }
            E::UnknownNumber(word) => {
                let word = c.text(word);
                let d = report(&format!("unknown layout qualifier `{word} = ...`"));
                let near = Some("location").filter(|known| known.starts_with(word));
                let renamed = near.map(|known| {
                    let edits = vec![Edit::replace(c.token_span(at.first), known)];
                    Fix::suggestion(format!("use `{known}`"), edits)
                });
                let d = d.fix(renamed.or_else(|| c.without_layout(at)));
                match word {
                    "binding" | "offset" => {
                        d.note("it was added in GLSL ES 3.10, which WebGL2 does not support")
                    }
                    _ => d,
                }
            }
            E::Negative => report("`location` cannot be negative"),
            E::OfBlock => report("this layout qualifier is only allowed on interface blocks"),
            E::NoLocationHere => report("`location` is not allowed here").note(
                "only vertex shader inputs and fragment shader outputs have one (section 4.3.8)",
            )
            .fix(c.without_layout(at)),
            E::Twice => report("`location` is specified twice"),
            E::OutOfRange(location) => report(&format!("location {location} is out of range"))
                .note("a vertex shader has 16 input locations, 0 to 15"),
            E::Shared => report("`location` can only apply to a single variable"),
            E::Views(most) => report("the number of views differs, or is too large")
                .note(format!("Chromium has at most {most} views, WebGL at least 2")),
            E::OfNothing => report("expected a declaration after these qualifiers"),
            E::NotUniform => report("a default layout can only be set for `uniform`"),
        }
    }
}

impl ExplainContext<'_> {
    /// Removes the `layout(...)` that these tokens are in, if it has no other entry.
    fn without_layout(&self, at: Extent) -> Option<Fix> {
        let is_it = |q: &&Qualifier| q.extent.first <= at.first && at.last <= q.extent.last;
        let qualifier = self.tree.qualifier_lists.iter().find(is_it)?;
        let QualifierKind::Layout(entries) = qualifier.kind else {
            return None;
        };
        if !self.is_direct(qualifier.extent) {
            return None;
        }
        let entries = self.tree.layout(entries);
        if entries.len() > 1 {
            return self.without_entry(entries, at);
        }
        let next = self.token(qualifier.extent.last + 1).span.start;
        let span = self.span(qualifier.extent);
        let edit = Edit::delete(Span::new(span.start, next.max(span.end)));
        Some(Fix::safe("remove the `layout(...)`", vec![edit]))
    }

    /// Removes one of several entries and a comma.
    fn without_entry(&self, entries: &[LayoutEntry], at: Extent) -> Option<Fix> {
        let start = |entry: &LayoutEntry| self.token_span(entry.ident.token).start;
        let index = entries.iter().position(|e| e.ident.token == at.first)?;
        let entry = entries.get(index)?;
        let span = match (index.checked_sub(1), entries.get(index + 1)) {
            (_, Some(next)) => Span::new(start(entry), start(next)),
            (before, None) => {
                let before = entries.get(before?)?;
                let value = before.value.as_ref().map(|value| value.token);
                let end = self.token_span(value.unwrap_or(before.ident.token)).end;
                Span::new(end, self.span(at).end)
            }
        };
        let title = format!("remove `{}`", self.sources.text(self.span(at)));
        Some(Fix::safe(title, vec![Edit::delete(span)]))
    }
}
