//! The names that must be the same: those of one symbol, and of its declarations in other branches
//! of `#if` and in other files, and in the scripts that use the shader.

use super::scripts::{in_scripts, names_file};
use crate::bound::{BoundName, bound_at};
use crate::document::{Document, FileSpan, Spot, SymbolOrigin};
use crate::index::{NameUse, Occurrence, is_inactive};
use crate::symbol::{Symbol, SymbolKind, role};
use shaderlint_detect::embed::{MentionKind, NameRole};
use shaderlint_project::Files;
use shaderlint_semantic::{Completeness, Program, Resolution};
use shaderlint_syntax::ast::{ExprId, ExprKind};
use shaderlint_text::Span;
use std::collections::{BTreeMap, BTreeSet};

/// The name at an offset, in a reading of the document that compiles it.
pub struct NameHere<'d> {
    /// The position in the reading.
    pub spot: Spot<'d>,
    /// The name.
    pub name: Occurrence,
    /// Its span in the document.
    pub span: Span,
}

impl NameHere<'_> {
    /// The name as written.
    pub fn text(&self) -> &str {
        self.spot.program().sources.text(self.name.span)
    }

    /// What the name refers to.
    pub fn origin(&self) -> SymbolOrigin {
        let reading = self.spot.document;
        reading.origin(self.spot.program(), self.name.symbol)
    }
}

/// The name at an offset. If the code there is not compiled, a branch is read that contains it.
pub fn name_at<'d>(document: &'d Document, offset: u32, files: &dyn Files) -> Option<NameHere<'d>> {
    let own = compiled_name(document, offset);
    let is_compiled = |here: &NameHere| here.name.access != NameUse::Unseen;
    if own.as_ref().is_some_and(is_compiled) || !is_left_out(document, offset) {
        return own;
    }
    let others = document.alternatives(files).iter();
    let mut others = others.filter_map(|other| compiled_name(other, offset));
    others.find(is_compiled).or(own)
}

/// The name at an offset, as the shader there is compiled.
pub fn compiled_name(document: &Document, offset: u32) -> Option<NameHere<'_>> {
    let spot = document.spot(offset)?;
    let name = spot.name()?;
    let span = document.report.in_input(name.span)?;
    Some(NameHere { spot, name, span })
}

/// Whether the code at an offset is in a branch that is not compiled.
fn is_left_out(document: &Document, offset: u32) -> bool {
    let spot = document.spot(offset);
    spot.is_some_and(|spot| is_inactive(spot.program(), Span::at(spot.address)))
}

/// The names that must be the same, in some documents.
#[derive(Default)]
pub struct NameFamily {
    /// What they refer to, in one branch or another.
    pub origins: BTreeSet<SymbolOrigin>,
    /// By place: how the name is used there, and the index of a document that contains it.
    pub places: BTreeMap<FileSpan, (NameUse, usize)>,
    /// Places that may refer to another symbol as well.
    pub uncertain: BTreeSet<FileSpan>,
    /// By place in a script: how it refers to the name, and the index of its document.
    pub mentions: BTreeMap<FileSpan, (MentionKind, usize)>,
}

/// Symbols of a shader that cannot exist at the same time: two globals with the same name, and for
/// functions the same parameters. They are declared in different branches.
type Rivals = (usize, usize, String);

/// The occurrences of one word.
#[derive(Default)]
struct SameWord {
    /// By place, for code that is compiled: what the name refers to.
    compiled: BTreeMap<FileSpan, BTreeSet<SymbolOrigin>>,
    by_origin: BTreeMap<SymbolOrigin, BTreeSet<FileSpan>>,
    /// The same for code that is not compiled in any reading, where it may refer to any of several.
    unseen: BTreeMap<FileSpan, BTreeSet<SymbolOrigin>>,
    /// Use, and the index of a document.
    uses: BTreeMap<FileSpan, (NameUse, usize)>,
    rivals: BTreeMap<Rivals, BTreeSet<SymbolOrigin>>,
    /// Places that need a declaration from elsewhere, with the index of the document.
    open: BTreeMap<FileSpan, usize>,
    /// The symbols that scripts may set by name, with the indices of documents that declare them.
    inputs: BTreeMap<SymbolOrigin, BTreeSet<usize>>,
}

impl SameWord {
    fn of(documents: &[&Document], word: &str, files: &dyn Files) -> SameWord {
        let mut found = SameWord::default();
        for (number, document) in documents.iter().enumerate() {
            let count = document.report.analyses.len();
            for reading in document.readings(word, files) {
                let is_same = reading.report.analyses.len() == count;
                for (shader, (program, index)) in reading.shaders().enumerate() {
                    let key = is_same.then_some((number, shader));
                    let same = |o: &&Occurrence| program.sources.text(o.span) == word;
                    for occurrence in index.all.iter().filter(same) {
                        found.add(reading, program, *occurrence, number, key);
                    }
                    let places = unresolved(program, word).into_iter();
                    let places = places.filter_map(|span| reading.place(span));
                    found.open.extend(places.map(|place| (place, number)));
                }
            }
        }
        found
    }

    fn add(
        &mut self,
        reading: &Document,
        program: &Program,
        occurrence: Occurrence,
        document: usize,
        shader: Option<(usize, usize)>,
    ) {
        let Some(place) = reading.place(occurrence.span) else {
            return;
        };
        let origin = reading.origin(program, occurrence.symbol);
        if occurrence.access == NameUse::Unseen {
            let uses = (NameUse::Unseen, document);
            self.uses.entry(place.clone()).or_insert(uses);
            self.unseen.entry(place).or_default().insert(origin);
            return;
        }
        let uses = self.uses.entry(place.clone());
        let uses = uses.or_insert((occurrence.access, document));
        if uses.0 == NameUse::Unseen {
            *uses = (occurrence.access, document);
        }
        if let (Some((document, shader)), Some(form)) = (shader, form(program, occurrence.symbol)) {
            let rivals = self.rivals.entry((document, shader, form)).or_default();
            rivals.insert(origin.clone());
        }
        if role(program, occurrence.symbol) == NameRole::Input {
            let declared = self.inputs.entry(origin.clone()).or_default();
            declared.insert(document);
        }
        let places = self.by_origin.entry(origin.clone()).or_default();
        places.insert(place.clone());
        self.compiled.entry(place).or_default().insert(origin);
    }

    /// The family of some symbols.
    fn family(&self, origins: BTreeSet<SymbolOrigin>) -> NameFamily {
        let mut family = NameFamily::default();
        let mut next: Vec<SymbolOrigin> = origins.into_iter().collect();
        while let Some(origin) = next.pop() {
            let rivals = self.rivals.values().filter(|all| all.contains(&origin));
            let places = self.by_origin.get(&origin).into_iter().flatten();
            let meant = places.filter_map(|place| self.compiled.get(place));
            next.extend(rivals.chain(meant).flatten().cloned());
            family.origins.insert(origin);
            next.retain(|origin| !family.origins.contains(origin));
        }
        // Where code is compiled in some branch, that decides.
        let unseen = self.unseen.iter();
        let unseen = unseen.filter(|(place, _)| !self.compiled.contains_key(*place));
        for (place, meant) in self.compiled.iter().chain(unseen) {
            let Some(used) = self.uses.get(place) else {
                continue;
            };
            if meant.is_disjoint(&family.origins) {
                continue;
            }
            family.places.insert(place.clone(), *used);
            if !meant.is_subset(&family.origins) {
                family.uncertain.insert(place.clone());
            }
        }
        family
    }
}

/// The uses of a word that no declaration explains.
fn unresolved(program: &Program, word: &str) -> Vec<Span> {
    let Some(name) = program.names.get(word) else {
        return Vec::new();
    };
    let exprs = program.tree.exprs.iter().zip(0..);
    let built_in = program.builtins().function(word);
    let is_it = |kind: &ExprKind| match kind {
        ExprKind::Name(used) => *used == name,
        ExprKind::Call(used, _) => *used == name && built_in.is_none(),
        _ => false,
    };
    let open = exprs.filter(|(expr, id)| {
        is_it(&expr.kind) && program.expr(ExprId(*id)).resolution == Resolution::None
    });
    let spans = open.filter_map(|(expr, _)| {
        let token = program.token(expr.extent.first)?;
        let span = Span::new(token.spelled, token.spelled + word.len() as u32);
        (program.is_user(span) && program.sources.text(span) == word).then_some(span)
    });
    spans.collect()
}

/// What two globals of the same name have in common that cannot exist at the same time.
fn form(program: &Program, symbol: Symbol) -> Option<String> {
    match symbol {
        Symbol::Variable(id) => {
            let is_global = program.variable(id)?.function.is_none();
            is_global.then(String::new)
        }
        Symbol::Function(id) => {
            let function = program.function(id)?;
            let types = function.params.iter().map(|p| program.type_name(p.ty));
            Some(format!("({})", types.collect::<Vec<_>>().join(",")))
        }
        Symbol::Struct(_) => Some("struct".to_string()),
        Symbol::Macro(_) => Some("macro".to_string()),
        Symbol::Field(..) | Symbol::MacroParameter(..) | Symbol::Builtin(_) => None,
    }
}

/// The names that must be the same as one of `document`, which is one of the documents.
pub fn family(documents: &[&Document], here: &NameHere, files: &dyn Files) -> NameFamily {
    let word = here.text();
    let same = SameWord::of(documents, word, files);
    let own = documents.iter().find(|d| d.path == here.spot.document.path);
    // In the same document only, other files are of no interest.
    let own = own.filter(|_| documents.len() > 1);
    let bound = own.map(|own| bound_at(own, here.span.start, files).all);
    let bound = bound.unwrap_or_default();
    let declared = bound.iter().flat_map(|bound| &bound.declared);
    let linked = declared.filter_map(|place| same.compiled.get(place));
    let mut origins: BTreeSet<SymbolOrigin> = linked.flatten().cloned().collect();
    origins.insert(here.origin());
    let mut family = same.family(origins);
    if may_be_used_elsewhere(here) {
        let open = same.open.iter();
        let open = open.filter(|(place, _)| !same.compiled.contains_key(*place));
        let unclear =
            |(place, at): (&FileSpan, &usize)| (place.clone(), (MentionKind::Unclear, *at));
        family.mentions.extend(open.map(unclear));
    }
    let role = role(here.spot.program(), here.name.symbol);
    let scripts = documents.iter().enumerate();
    let scripts = scripts.map(|(i, document)| (i, in_scripts(document, word, role)));
    let scripts: Vec<_> = scripts.filter(|(_, found)| !found.is_empty()).collect();
    // A script that uses two shaders gives both the same name.
    loop {
        let used = scripts.iter().flat_map(|(i, _)| same.set_by(documents, *i));
        let used = used.filter(|all| !all.is_disjoint(&family.origins));
        let all: BTreeSet<SymbolOrigin> = used.flatten().collect();
        if role == NameRole::Inner || all.is_subset(&family.origins) {
            break;
        }
        family = NameFamily {
            mentions: family.mentions,
            ..same.family(family.origins.union(&all).cloned().collect())
        };
    }
    for (i, found) in scripts {
        let Some(document) = documents.get(i) else {
            continue;
        };
        let is_sure = match same.relation(documents, i, role, &family) {
            ScriptRelation::None => continue,
            ScriptRelation::Sure => true,
            ScriptRelation::Possible => false,
        };
        for (span, kind) in found {
            let path = document.path.clone();
            // A property of a script that names no shader is hardly an input of one.
            let kind = match kind {
                MentionKind::Unclear if !is_sure => continue,
                kind if is_sure => kind,
                _ => MentionKind::Unclear,
            };
            family.mentions.insert(FileSpan { path, span }, (kind, i));
        }
    }
    add_bound(documents, &bound, &mut family);
    family
}

/// Adds the places of scripts that are known to name an input, and those that compute names.
fn add_bound(documents: &[&Document], bound: &[BoundName], family: &mut NameFamily) {
    let at = |place: &FileSpan| {
        let found = documents.iter().position(|d| d.path == place.path);
        found.unwrap_or_default()
    };
    for place in bound.iter().flat_map(|bound| &bound.mentions) {
        let new = (MentionKind::Name, at(place));
        let known = family.mentions.entry(place.clone()).or_insert(new);
        if known.0 == MentionKind::Unclear {
            *known = new;
        }
    }
    for place in bound.iter().flat_map(|bound| &bound.computed) {
        let new = (MentionKind::Unclear, at(place));
        family.mentions.insert(place.clone(), new);
    }
}

/// Whether texts that name nothing of this shader may refer to its symbol: the host that completes a
/// fragment may join it with others, at its end or where it includes something.
fn may_be_used_elsewhere(here: &NameHere) -> bool {
    let (analysis, program) = (here.spot.analysis, here.spot.program());
    if analysis.completeness == Completeness::Complete {
        return false;
    }
    match here.name.symbol.kind(program) {
        SymbolKind::Field => false,
        SymbolKind::Local | SymbolKind::Parameter => analysis.user_code().contains("#include"),
        _ => true,
    }
}

/// Whether a script uses the shaders of a family.
enum ScriptRelation {
    None,
    Possible,
    Sure,
}

impl SameWord {
    /// The inputs in the shaders that a script contains or names the files of, if there are some.
    fn set_by(&self, documents: &[&Document], script: usize) -> Option<BTreeSet<SymbolOrigin>> {
        let uses = |other: &usize| uses(documents, script, *other);
        let own = self.inputs.iter().filter(|(_, all)| all.iter().any(uses));
        let own: BTreeSet<SymbolOrigin> = own.map(|(origin, _)| origin.clone()).collect();
        (!own.is_empty()).then_some(own)
    }

    fn relation(
        &self,
        documents: &[&Document],
        script: usize,
        role: NameRole,
        family: &NameFamily,
    ) -> ScriptRelation {
        if role == NameRole::Inner {
            let mut declared = family.places.values().map(|(_, document)| *document);
            return match declared.any(|other| uses(documents, script, other)) {
                true => ScriptRelation::Sure,
                false => ScriptRelation::None,
            };
        }
        let is_own = |origin: &SymbolOrigin| family.origins.contains(origin);
        match self.set_by(documents, script) {
            Some(all) if all.iter().any(is_own) => ScriptRelation::Sure,
            Some(_) => ScriptRelation::None,
            // The script names no shader.
            None if self.inputs.keys().all(is_own) => ScriptRelation::Sure,
            None => ScriptRelation::Possible,
        }
    }
}

/// Whether a script is in the same file as a shader, or one of both names the other's file.
fn uses(documents: &[&Document], script: usize, other: usize) -> bool {
    let (Some(script), Some(other)) = (documents.get(script), documents.get(other)) else {
        return false;
    };
    script.path == other.path || names_file(script, &other.path) || names_file(other, &script.path)
}
