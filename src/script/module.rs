//! Modules: imports and exports.

use crate::evaluator::{Evaluator, ExternalScript};
use crate::value::{KnownText, ObjectId, ScriptPlace, ScriptValue};
use crate::world::{ObjectKind, ScopeId, Source};
use oxc_ast::ast as js;
use oxc_parser::{ParseOptions, Parser};
use oxc_span::{GetSpan, SourceType};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

/// Maximum number of files.
const MAX_FILES: usize = 40;

impl<'a> Evaluator<'a, '_> {
    /// Evaluates a module and returns the object of its exports. `None` if it cannot be parsed.
    pub fn module(&mut self, path: PathBuf, text: Arc<str>) -> Option<ObjectId> {
        if let Some((_, exports)) = self.modules.iter().find(|(known, _)| *known == path) {
            return Some(*exports);
        }
        if self.modules.len() >= MAX_FILES {
            self.world.is_cut = true;
            return None;
        }
        let program = self.parse(&path, &text)?;
        let external = self.loader.scripts(&path, &text);
        let number = self.world.files.len();
        self.world.files.push((path.clone(), text));
        let file = std::mem::replace(&mut self.file, number);
        let exports = self.plain(ScriptPlace {
            file: number,
            ..ScriptPlace::default()
        });
        self.modules.push((path, exports));
        let scope = self.scope(None);
        let module = ScriptValue::Object(exports);
        self.declare(scope, EXPORTS, module.clone());
        self.declare(scope, "exports", module.clone());
        let object = self.plain(ScriptPlace::default());
        self.define(object, "exports", module, ScriptPlace::default());
        self.declare(scope, "module", ScriptValue::Object(object));
        for statement in &program.body {
            if let js::Statement::ImportDeclaration(it) = statement {
                self.import_declaration(scope, it);
            }
        }
        let frames = std::mem::take(&mut self.frames);
        // A page is read with its own scripts as one.
        let own = program
            .body
            .first()
            .map_or(0, |first| first.span().start as usize);
        let (before, after): (Vec<_>, Vec<_>) = external.iter().partition(|s| s.at < own);
        before
            .iter()
            .for_each(|script| self.external_script(scope, script));
        self.statements(scope, &program.body);
        after
            .iter()
            .for_each(|script| self.external_script(scope, script));
        self.frames = frames;
        self.file = file;
        // `module.exports = ...`
        let replaced = self.world.property(object, "exports")?.value.clone();
        if replaced.object() != Some(exports) {
            self.define(exports, "default", replaced.clone(), ScriptPlace::default());
            self.copy_properties(exports, &replaced);
        }
        Some(exports)
    }

    fn parse(&self, path: &Path, text: &str) -> Option<&'a js::Program<'a>> {
        let code = self.loader.script(path, text)?;
        let code: &'a str = self.allocator.alloc_str(&code);
        let types = [
            SourceType::tsx(),
            SourceType::ts(),
            SourceType::script().with_jsx(true),
        ];
        let options = ParseOptions {
            preserve_parens: false,
            ..ParseOptions::default()
        };
        let program = types.into_iter().find_map(|source_type| {
            let parser = Parser::new(self.allocator, code, source_type).with_options(options);
            let parsed = parser.parse();
            (!parsed.panicked).then_some(parsed.program)
        })?;
        Some(self.allocator.alloc(program))
    }

    /// Evaluates a script that a page names, in the scope of the page.
    fn external_script(&mut self, scope: ScopeId, script: &ExternalScript) {
        if script.is_module {
            self.import(&script.path, ScriptPlace::default());
            return;
        }
        let page = self
            .world
            .files
            .get(self.file)
            .map(|(path, _)| path.clone());
        let found = page.and_then(|page| self.loader.load(&script.path, &page));
        let Some((path, text)) = found.filter(|_| self.world.files.len() < MAX_FILES) else {
            return;
        };
        if let Some(program) = self.parse(&path, &text) {
            let number = self.world.files.len();
            self.world.files.push((path, text));
            self.own_files.push(number);
            let file = std::mem::replace(&mut self.file, number);
            self.statements(scope, &program.body);
            self.file = file;
        }
    }

    fn import_declaration(&mut self, scope: ScopeId, it: &'a js::ImportDeclaration<'a>) {
        let place = self.place(it.source.span);
        let module = self.import(&it.source.value, place);
        for specifier in it.specifiers.iter().flatten() {
            let local = specifier.local();
            let (name, is_all) = match specifier {
                js::ImportDeclarationSpecifier::ImportSpecifier(it) => {
                    (it.imported.name().to_string(), false)
                }
                js::ImportDeclarationSpecifier::ImportDefaultSpecifier(_) => {
                    ("default".to_string(), false)
                }
                js::ImportDeclarationSpecifier::ImportNamespaceSpecifier(_) => {
                    (String::new(), true)
                }
            };
            let value = match is_all {
                true => module.clone(),
                false => self.exported(&module, &name, self.place(local.span)),
            };
            self.declare(scope, local.name.as_str(), value);
        }
    }

    /// An export of a module.
    fn exported(&mut self, module: &ScriptValue, name: &str, place: ScriptPlace) -> ScriptValue {
        let object = module.object().and_then(|id| self.world.object(id));
        let package = match object.map(|o| &o.kind) {
            Some(ObjectKind::Foreign(Source::Package(package, _))) => package.clone(),
            _ => {
                let has = self.world.get(module, name).cloned();
                return match has {
                    Some(value) => value,
                    // The module may be evaluated later, or export what is not followed.
                    None => self.unknown(place),
                };
            }
        };
        ScriptValue::Object(self.add(
            ObjectKind::Foreign(Source::Package(package, name.into())),
            place,
        ))
    }

    /// The module that a path means: the object of its exports.
    pub fn import(&mut self, path: &str, place: ScriptPlace) -> ScriptValue {
        let from = self
            .world
            .files
            .get(self.file)
            .map(|(path, _)| path.clone());
        let found = from.and_then(|from| self.loader.load(path, &from));
        let package = Source::Package(path.into(), "*".into());
        let Some((file, text)) = found else {
            return ScriptValue::Object(self.add(ObjectKind::Foreign(package), place));
        };
        if let Some(exports) = self.module(file.clone(), text.clone()) {
            return ScriptValue::Object(exports);
        }
        if self.loader.script(&file, &text).is_some() {
            return self.unknown(place);
        }
        let number = match self
            .world
            .files
            .iter()
            .position(|(known, _)| *known == file)
        {
            Some(number) => number,
            None => {
                self.world.files.push((file, text.clone()));
                self.world.files.len() - 1
            }
        };
        let written = ScriptPlace {
            file: number,
            start: 0,
            end: text.len() as u32,
        };
        let exports = self.plain(written);
        let value = ScriptValue::Text(Rc::new(KnownText::written(&text, written)));
        self.define(exports, "default", value, written);
        ScriptValue::Object(exports)
    }

    /// `import(path)`
    pub fn import_expression(
        &mut self,
        scope: ScopeId,
        it: &'a js::ImportExpression<'a>,
    ) -> ScriptValue {
        let place = self.place(it.span);
        match self.expression(scope, &it.source).text() {
            Some(path) => self.import(path, place),
            None => self.unknown(place),
        }
    }

    /// Statements that export.
    pub fn module_item(&mut self, scope: ScopeId, statement: &'a js::Statement<'a>) {
        let exports = self.name(scope, EXPORTS, ScriptPlace::default());
        let Some(exports) = exports.object() else {
            return;
        };
        match statement {
            js::Statement::ExportDeclaration(it) => self.export_declaration(scope, exports, it),
            js::Statement::ExportDefaultDeclaration(it) => {
                let place = self.place(it.span);
                let value = match &it.declaration {
                    js::ExportDefaultDeclarationKind::FunctionDeclaration(it) => match &it.id {
                        Some(name) => self.name(scope, name.name.as_str(), place),
                        None => self.function(scope, it),
                    },
                    js::ExportDefaultDeclarationKind::ClassDeclaration(it) => {
                        let value = self.class(scope, it);
                        if let Some(name) = &it.id {
                            self.declare(scope, name.name.as_str(), value.clone());
                        }
                        value
                    }
                    other => match other.as_expression() {
                        Some(expression) => self.expression(scope, expression),
                        None => return,
                    },
                };
                self.define(exports, "default", value, place);
            }
            js::Statement::ExportNamedDeclaration(it) => {
                for specifier in &it.specifiers {
                    let place = self.place(specifier.local.span());
                    let value = self.name(scope, &specifier.local.name(), place);
                    self.define(exports, &specifier.exported.name(), value, place);
                }
            }
            js::Statement::ExportFromDeclaration(it) => {
                let place = self.place(it.source.span);
                let module = self.import(&it.source.value, place);
                for specifier in &it.specifiers {
                    let value = self.exported(&module, &specifier.local.name(), place);
                    self.define(exports, &specifier.exported.name(), value, place);
                }
            }
            js::Statement::ExportAllDeclaration(it) => {
                let place = self.place(it.source.span);
                let module = self.import(&it.source.value, place);
                match &it.exported {
                    Some(name) => self.define(exports, &name.name(), module, place),
                    None => self.copy_properties(exports, &module),
                }
            }
            _ => {}
        }
    }

    fn export_declaration(
        &mut self,
        scope: ScopeId,
        exports: ObjectId,
        it: &'a js::ExportDeclaration<'a>,
    ) {
        let place = self.place(it.span);
        match &it.declaration {
            js::Declaration::VariableDeclaration(variables) => {
                self.variables(scope, variables);
                for variable in &variables.declarations {
                    for name in variable.id.get_binding_identifiers() {
                        let value = self.name(scope, name.name.as_str(), place);
                        self.define(exports, name.name.as_str(), value, self.place(name.span));
                    }
                }
            }
            js::Declaration::FunctionDeclaration(function) => {
                if let Some(name) = &function.id {
                    let value = self.name(scope, name.name.as_str(), place);
                    self.define(exports, name.name.as_str(), value, place);
                }
            }
            js::Declaration::ClassDeclaration(class) => {
                let value = self.class(scope, class);
                if let Some(name) = &class.id {
                    self.declare(scope, name.name.as_str(), value.clone());
                    self.define(exports, name.name.as_str(), value, place);
                }
            }
            _ => {}
        }
    }
}

/// The name of the object of a module's exports, which no script can declare.
const EXPORTS: &str = "%exports";
