//! Transformations of a program that must preserve every bit of its output. They are built from the
//! syntax tree, at random positions.

use crate::mutate::Random;
use shaderlint::engine::inputs::{Moment, Scene};
use shaderlint::engine::{Analysis, Options, analyze};
use shaderlint::exec::{CompileOptions, sample};
use shaderlint::project::NoFiles;
use shaderlint::semantic::{Dialect, Program};
use shaderlint::syntax::ast::{
    DeclKind, Declarator, ExprKind, Extent, FunctionDecl, QualifierKind, Stmt, StmtKind,
};
use shaderlint::text::{Edit, Role, Span, apply_edits};

/// A transformation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Change {
    /// Copies a statement into a branch that is never taken, which no compiler can prove.
    DeadBranch,
    /// Wraps a statement in a loop of one iteration.
    OneIteration,
    /// Wraps a statement in braces.
    Block,
    /// Renames a variable or function.
    Rename,
    /// Passes a value through an identity function.
    Outline,
    /// Calls a function through a forwarding function.
    Forward,
    /// Swaps two independent adjacent statements.
    Swap,
}

/// All transformations.
pub const CHANGES: [Change; 7] = [
    Change::DeadBranch,
    Change::OneIteration,
    Change::Block,
    Change::Rename,
    Change::Outline,
    Change::Forward,
    Change::Swap,
];

/// A complete fragment shader without errors.
pub fn checked(text: &str) -> Option<Analysis> {
    let report = analyze("a.glsl", text, &Options::default(), &NoFiles);
    let analysis = report.analyses.into_iter().next();
    analysis.filter(|a| !a.has_errors)
}

/// The program after a transformation at one of the possible positions.
pub fn changed(program: &Program, change: Change, random: &mut Random) -> Option<String> {
    let mut files = program.sources.files().iter();
    let file = files.find(|f| f.role == Role::User)?;
    let user = User {
        program,
        file: file.span(),
    };
    let places: Vec<Vec<Edit>> = match change {
        Change::DeadBranch => user.each(|s| Some(user.dead_branch(s))),
        Change::OneIteration => user.each(|s| user.one_iteration(s)),
        Change::Block => user.each(|s| user.around(s, "{ ", " }")),
        Change::Rename => user.renames(),
        Change::Outline => user.outlines(),
        Change::Forward => user.forwards(),
        Change::Swap => user.swaps(),
    };
    let edits = places.get(random.below(places.len()))?;
    apply_edits(&file.text, file.base, edits).ok()
}

/// The source text of the user.
struct User<'p> {
    program: &'p Program,
    file: Span,
}

/// Keywords that refer to the enclosing loop.
const LOOSE: [&str; 2] = ["break", "continue"];

impl<'p> User<'p> {
    fn span(&self, extent: Extent) -> Option<Span> {
        let span = self.program.span(extent);
        let is_plain = self.program.is_direct(extent) && self.file.contains(span);
        is_plain.then_some(span)
    }

    fn text(&self, span: Span) -> &'p str {
        self.program.sources.text(span)
    }

    /// A condition that is always false, which no compiler can prove.
    fn never(&self) -> &'static str {
        match self.program.dialect {
            Dialect::ShaderToy(_) => "iFrame < -1",
            _ => "seeds.w > 100",
        }
    }

    /// The statements of each block.
    fn blocks(&self) -> Vec<Vec<&'p Stmt>> {
        let tree = &self.program.tree;
        let lists = tree.stmts.iter().filter_map(|stmt| match stmt.kind {
            StmtKind::Block(list) if self.span(stmt.extent).is_some() => Some(list),
            _ => None,
        });
        let of = |id| tree.stmt(id);
        lists
            .map(|l| tree.block(l).iter().copied().map(of).collect())
            .collect()
    }

    /// A transformation of each statement that allows it.
    fn each(&self, change: impl Fn(&Stmt) -> Option<Vec<Edit>>) -> Vec<Vec<Edit>> {
        let all = self.blocks().into_iter().flatten();
        let plain = all.filter(|stmt| self.span(stmt.extent).is_some());
        plain.filter_map(change).collect()
    }

    fn around(&self, stmt: &Stmt, before: &str, after: &str) -> Option<Vec<Edit>> {
        let span = self.span(stmt.extent)?;
        let is_declaration = matches!(stmt.kind, StmtKind::Decl(_));
        (!is_declaration).then(|| {
            vec![
                Edit::insert(span.start, before),
                Edit::insert(span.end, after),
            ]
        })
    }

    fn dead_branch(&self, stmt: &Stmt) -> Vec<Edit> {
        let span = self.program.span(stmt.extent);
        let text = format!("if ({}) {{ {} }}\n", self.never(), self.text(span));
        vec![Edit::insert(span.start, text)]
    }

    fn one_iteration(&self, stmt: &Stmt) -> Option<Vec<Edit>> {
        let words = self.words(stmt.extent);
        if words.iter().any(|word| LOOSE.contains(word)) {
            return None;
        }
        let head = format!(
            "for (int once = int({}); once < 1; once++) {{ ",
            self.never()
        );
        self.around(stmt, &head, " }")
    }

    /// The tokens of a syntax node.
    fn words(&self, extent: Extent) -> Vec<&'p str> {
        let all = extent.first..=extent.last;
        let tokens = all.filter_map(|at| self.program.token(at));
        tokens.map(|token| self.text(token.span)).collect()
    }

    /// All uses of each name that the user declares.
    fn renames(&self) -> Vec<Vec<Edit>> {
        let functions = self.functions().into_iter().map(|f| f.ident.name);
        let entries = ["main", "mainImage"].map(|name| self.program.names.get(name));
        let functions = functions.filter(|name| !entries.contains(&Some(*name)));
        let tree = &self.program.tree;
        let params = tree.functions.iter().flat_map(|f| tree.params(f.params));
        let params = params.filter(|p| self.span(p.extent).is_some());
        let params = params.filter_map(|p| Some(p.ident?.name));
        let locals = self.blocks().into_iter().flatten();
        let locals = locals
            .flat_map(|s| self.declarators(s))
            .map(|d| d.ident.name);
        let all = functions.chain(params).chain(locals);
        all.filter_map(|name| self.rename(self.program.names.text(name)))
            .collect()
    }

    fn rename(&self, name: &str) -> Option<Vec<Edit>> {
        let tokens = &self.program.tokens.tokens;
        let mut edits = Vec::new();
        for (at, token) in tokens.iter().enumerate() {
            if self.text(token.span) != name || !self.file.contains(token.span) {
                continue;
            }
            let before = at.checked_sub(1).and_then(|at| tokens.get(at));
            let is_member = before.is_some_and(|t| self.text(t.span) == ".");
            // Macros and members may have the same name.
            if !token.is_direct() || is_member {
                return None;
            }
            edits.push(Edit::replace(token.span, format!("{name}_other")));
        }
        Some(edits)
    }

    /// The variables that a statement declares.
    fn declarators(&self, stmt: &Stmt) -> &'p [Declarator] {
        let StmtKind::Decl(id) = stmt.kind else {
            return &[];
        };
        match self.program.tree.decl(id).map(|decl| decl.kind) {
            Some(DeclKind::Variables { declarators, .. }) => {
                self.program.tree.declarators(declarators)
            }
            _ => &[],
        }
    }

    /// The functions of the user that have a body and no prototype.
    fn functions(&self) -> Vec<&'p FunctionDecl> {
        let all = self.program.tree.functions.iter();
        let own = all.filter(|f| self.span(f.extent).is_some());
        let own: Vec<_> = own.collect();
        let is_declared = |f: &FunctionDecl| {
            let mut others = own.iter();
            others.any(|o| o.body.is_none() && o.ident.name == f.ident.name)
        };
        let defined = own.iter().filter(|f| f.body.is_some() && !is_declared(f));
        defined.copied().collect()
    }

    /// Stored and returned values, each passed through a function.
    fn outlines(&self) -> Vec<Vec<Edit>> {
        let tree = &self.program.tree;
        let Some(first) = self
            .functions()
            .first()
            .map(|f| self.program.span(f.extent))
        else {
            return Vec::new();
        };
        let stored = tree.exprs.iter().filter_map(|expr| match expr.kind {
            ExprKind::Assign(None, _, value) => Some(value),
            _ => None,
        });
        let given = tree.stmts.iter().filter_map(|stmt| match stmt.kind {
            StmtKind::Return(value) => value,
            _ => None,
        });
        let outline = |value| {
            let span = self.span(tree.expr(value).extent)?;
            let ty = self.program.ty(value);
            ty.numeric().filter(|_| !ty.is_array())?;
            let name = self.program.type_name(ty);
            let function = format!("{name} keep({name} x) {{ {name} y = x; return y; }}\n");
            Some(vec![
                Edit::insert(first.start, function),
                Edit::insert(span.start, "keep("),
                Edit::insert(span.end, ")"),
            ])
        };
        stored.chain(given).filter_map(outline).collect()
    }

    fn forwards(&self) -> Vec<Vec<Edit>> {
        let all = self.functions().into_iter();
        all.filter_map(|f| self.forward(f)).collect()
    }

    /// A function under a new name, and a function that forwards to it.
    fn forward(&self, function: &FunctionDecl) -> Option<Vec<Edit>> {
        let tree = &self.program.tree;
        let header = self.text(self.span(function.header)?);
        let name = self.program.names.text(function.ident.name);
        let at = self.program.token(function.ident.token)?.span;
        let names = tree.params(function.params).iter().map(|p| {
            let is_const = |q| matches!(q, QualifierKind::Const);
            let mut qualifiers = tree.qualifiers(p.qualifiers).iter();
            let is_const = qualifiers.any(|q| is_const(q.kind));
            Some(self.program.names.text(p.ident.filter(|_| !is_const)?.name))
        });
        let names = names.collect::<Option<Vec<&str>>>()?.join(", ");
        let gives = match header.starts_with("void") {
            true => "",
            false => "return ",
        };
        let end = self.program.span(function.extent).end;
        let other = format!("\n{header} {{ {gives}{name}_other({names}); }}");
        Some(vec![
            Edit::replace(at, format!("{name}_other")),
            Edit::insert(end, other),
        ])
    }

    fn swaps(&self) -> Vec<Vec<Edit>> {
        let mut found = Vec::new();
        for block in self.blocks() {
            for pair in block.windows(2) {
                if let [first, second] = pair {
                    found.extend(self.swap(first, second));
                }
            }
        }
        found
    }

    fn swap(&self, first: &Stmt, second: &Stmt) -> Option<Vec<Edit>> {
        let (before, after) = (self.span(first.extent)?, self.span(second.extent)?);
        let (written, other) = (self.written(first)?, self.written(second)?);
        let needs = |stmt: &Stmt, name| self.words(stmt.extent).contains(&name);
        if needs(second, written) || needs(first, other) {
            return None;
        }
        Some(vec![
            Edit::replace(before, self.text(after)),
            Edit::replace(after, self.text(before)),
        ])
    }

    /// The variable that a statement writes, if that is its only effect.
    fn written(&self, stmt: &Stmt) -> Option<&'p str> {
        let words = self.words(stmt.extent);
        let calls = words.windows(2).filter(|pair| pair.last() == Some(&"("));
        let mut calls = calls.filter_map(|pair| pair.first());
        // `W` writes nothing.
        let is_own = |name: &&&str| {
            let mut own = self.program.tree.functions.iter();
            **name != "W" && own.any(|f| self.program.names.text(f.ident.name) == **name)
        };
        let is_comparison = |word: &str| ["==", "!=", "<=", ">="].contains(&word);
        let writes = words.iter().enumerate().filter(|(_, word)| {
            word.ends_with('=') && !is_comparison(word) || ["++", "--"].contains(word)
        });
        let writes: Vec<usize> = writes.map(|(at, _)| at).collect();
        let [write] = writes.as_slice() else {
            return None;
        };
        if calls.any(|name| is_own(&name)) {
            return None;
        }
        match (stmt.kind, self.declarators(stmt)) {
            (StmtKind::Decl(_), [one]) => Some(self.program.names.text(one.ident.name)),
            // Its name is the first token, or follows a `++`.
            (StmtKind::Expr(_), _) if !words[..*write].contains(&"(") => {
                let name = words.get(usize::from(*write == 0))?;
                name.starts_with(char::is_alphabetic).then_some(*name)
            }
            _ => None,
        }
    }
}

/// The output bits of a program at some pixels; `None` for a discarded pixel.
pub fn bits(analysis: &Analysis, seeds: [f64; 4], parts: [f64; 4]) -> Result<Bits, String> {
    const SIZE: [u32; 2] = [64, 36];
    const QUADS: [[u32; 2]; 8] = [
        [0, 0],
        [62, 0],
        [10, 6],
        [32, 18],
        [34, 20],
        [50, 10],
        [20, 28],
        [62, 34],
    ];
    let options = CompileOptions::default();
    let scene = Scene::of(
        &analysis.program,
        analysis.host,
        analysis.module(),
        &options,
    );
    let scene = scene.map_err(|refusal| refusal.what)?;
    let mut draw = scene.draw(SIZE, &Moment::at(1.7));
    draw.fuel = 3_000_000;
    draw.set("seeds", &seeds);
    draw.set("parts", &parts);
    let sampled = sample(&draw, &QUADS).map_err(|stop| format!("{stop:?}"))?;
    let outputs = sampled.outputs.into_iter().next().unwrap_or_default();
    let all = outputs.into_iter().zip(sampled.covered);
    Ok(all
        .map(|(bits, is_covered)| is_covered.then_some(bits))
        .collect())
}

/// One entry per pixel.
pub type Bits = Vec<Option<[u32; 4]>>;

/// Checks that each transformation preserves every bit of a program; returns how many were
/// possible.
pub fn keeps_every_bit(text: &str, changes: &[Change], random: &mut Random) -> usize {
    let Some(before) = checked(text) else {
        return 0;
    };
    let seeds = [0; 4].map(|_| random.below(2001) as f64 - 1000.0);
    let seeds = [seeds[0], seeds[1], seeds[2] % 9.0, seeds[3] % 3.0];
    let parts = [0; 4].map(|_| random.below(65) as f64 - 32.0);
    let Ok(bits_before) = bits(&before, seeds, parts) else {
        return 0;
    };
    let mut count = 0;
    for change in changes {
        let Some(text) = changed(&before.program, *change, random) else {
            continue;
        };
        let after =
            checked(&text).unwrap_or_else(|| panic!("{change:?} introduces errors:\n{text}"));
        let bits_after = bits(&after, seeds, parts);
        assert!(
            bits_after.as_ref() == Ok(&bits_before),
            "{change:?} changes the image:\n{text}"
        );
        count += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compute::compute;

    /// Generated programs, with one transformation each.
    #[test]
    fn transformations_preserve_every_bit_of_programs() {
        let mut counts = [0; CHANGES.len()];
        for seed in 1..=350 {
            let at = seed as usize % CHANGES.len();
            let mut random = Random::new(seed);
            let text = compute(seed).text;
            counts[at] += keeps_every_bit(&text, &CHANGES[at..=at], &mut random);
        }
        for (change, count) in CHANGES.iter().zip(counts) {
            assert!(count >= 35, "{change:?} was applied {count} times");
        }
    }

    /// Floats, marching loops and textures, too.
    #[test]
    fn transformations_preserve_every_bit_of_templates() {
        for name in ["raymarching", "terrain", "voxel"] {
            let path = format!(
                "{}/../corpus/templates/{name}.glsl",
                env!("CARGO_MANIFEST_DIR")
            );
            let text = std::fs::read_to_string(path).unwrap();
            let mut random = Random::new(7);
            assert_eq!(
                keeps_every_bit(&text, &CHANGES, &mut random),
                CHANGES.len(),
                "{name}"
            );
        }
    }
}
