//! Messages for [`OutputError`].

use crate::messages::*;

impl Explain for OutputError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use OutputError as E;
        let report = |message: &str| c.error(error::OUTPUT_LOCATION, at, message);
        match self {
            E::Outside(name, count) => {
                let name = c.text(name);
                report(&format!(
                    "output `{name}` exceeds the {count} available locations"
                ))
            }
            E::Shared(name, other, location) => {
                let (name, first) = (c.text(name), c.text(other.name));
                report(&format!(
                    "outputs `{name}` and `{first}` share location {location}"
                ))
                .label(c.token_span(other.token), "other output")
                .fix(c.free_location(at))
            }
            E::NextToHostOutputs(name) => {
                let name = c.text(name);
                report(&format!(
                    "output `{name}` conflicts with ShaderToy's own output"
                ))
                .note("a ShaderToy pass has one output, the first parameter of its entry function")
            }
            E::NoLocation(name) => {
                let name = c.text(name);
                let d = report(&format!("output `{name}` has no location"))
                    .note("each of several fragment outputs needs a location (section 4.3.8.2)");
                match c.locations_of_all() {
                    Some(fix) => d.fix(fix),
                    None => d.help(format!("use `layout(location = 0) out vec4 {name};`")),
                }
            }
            E::ColorAndData(other) => {
                report("`gl_FragColor` and `gl_FragData` cannot both be used")
                    .label(c.token_span(other), "other use")
            }
        }
    }
}

/// Number of locations for outputs.
const LOCATIONS: u32 = 8;
/// Maximum number of outputs that are given locations: with more, some cannot have one.
const MAX_OUTPUTS: usize = 2 * LOCATIONS as usize;

/// An output declaration.
struct OutputDecl {
    extent: Extent,
    /// The storage qualifier.
    out: Extent,
    /// The number of its location and the token.
    location: Option<LayoutValue>,
    /// Number of locations.
    size: u32,
}

impl ExplainContext<'_> {
    /// The declarations of outputs, each with its location.
    fn output_decls(&self) -> Vec<OutputDecl> {
        let outputs = self.tree.decls.iter().filter_map(|d| {
            let DeclKind::Variables {
                qualifiers,
                declarators,
                ..
            } = d.kind
            else {
                return None;
            };
            let qualifiers = self.tree.qualifiers(qualifiers);
            let out = qualifiers
                .iter()
                .find(|q| q.kind == QualifierKind::Out)?
                .extent;
            let entries = qualifiers.iter().find_map(|q| match q.kind {
                QualifierKind::Layout(list) => Some(self.tree.layout(list)),
                _ => None,
            });
            let is_location = |e: &&LayoutEntry| self.text(e.ident.name) == "location";
            let location = entries.unwrap_or(&[]).iter().find(is_location);
            let name = self.tree.declarators(declarators).first()?.ident.name;
            let variable = self.variables.iter().find(|v| v.name == name);
            Some(OutputDecl {
                extent: d.extent,
                out,
                location: location.and_then(|e| e.value),
                size: variable.map_or(1, |v| v.ty.array.max(1)),
            })
        });
        outputs.take(MAX_OUTPUTS).collect()
    }

    /// Gives the output at these tokens the first free location.
    fn free_location(&self, at: Extent) -> Option<Fix> {
        let all = self.output_decls();
        let own = all
            .iter()
            .find(|o| o.extent.first <= at.first && at.first <= o.extent.last)?;
        let value = own.location?;
        let others = || all.iter().filter(|o| o.extent != own.extent);
        let is_free = |first: &u32| {
            others().all(|o| {
                let other = o.location.map_or(0, |l| l.value.max(0) as u32);
                first + own.size <= other || other + o.size <= *first
            })
        };
        let free = (0..=LOCATIONS.checked_sub(own.size)?).find(is_free)?;
        let token = self.token(value.token);
        let edit = Edit::replace(token.span, free.to_string());
        token
            .is_direct()
            .then(|| Fix::suggestion(format!("use the free location {free}"), vec![edit]))
    }

    /// Gives every output without a location the next free one.
    fn locations_of_all(&self) -> Option<Fix> {
        let all = self.output_decls();
        let taken = all
            .iter()
            .filter_map(|o| Some((o.location?.value.max(0) as u32, o.size)));
        let mut taken: Vec<(u32, u32)> = taken.collect();
        let mut edits = Vec::new();
        for output in all.iter().filter(|o| o.location.is_none()) {
            let is_free = |first: &u32| {
                let apart =
                    |(at, size): &(u32, u32)| first + output.size <= *at || at + size <= *first;
                taken.iter().all(apart)
            };
            let free = (0..=LOCATIONS.checked_sub(output.size)?).find(is_free)?;
            if !self.is_direct(output.out) {
                return None;
            }
            taken.push((free, output.size));
            let start = self.span(output.out).start;
            edits.push(Edit::insert(start, format!("layout(location = {free}) ")));
        }
        Some(Fix::suggestion(
            "add `layout(location = ...)` to the outputs",
            edits,
        ))
    }
}
