//! The text of a pass for a host: the template of the host around the code of the user.

use super::plain::{PlainShader, interface};
use super::renamed::{NewNames, RenamedText, unused, words};
use super::supplied::Supplied;
use super::used::{UsedInput, UsedValue};
use shaderlint_host::{HostVersion, Preset, Template, declared_in};
use shaderlint_semantic::builtins::Builtins;
use shaderlint_semantic::{Program, Stage};
use shaderlint_syntax::{Version, WordClass, classify};
use shaderlint_text::{FileId, SourceFile};
use std::collections::BTreeSet;

/// The name that stands for the user's `mainImage` in templates.
const IMAGE: &str = "port_image";

/// A uniform that the text declares.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct DeclaredUniform {
    pub(super) name: String,
    pub(super) ty: String,
    /// What its value is.
    pub(super) about: String,
}

/// A shader for a host.
pub(super) struct HostText {
    pub(super) text: String,
    /// The uniforms that it declares, in order.
    pub(super) uniforms: Vec<DeclaredUniform>,
    /// The texts of the user, with their offsets.
    pieces: Vec<(usize, FileId, RenamedText)>,
}

impl HostText {
    /// The text of the user, and the offset in it, for an offset in the shader.
    pub(super) fn place(&self, offset: usize) -> Option<(FileId, usize)> {
        let mut pieces = self.pieces.iter().rev();
        let (start, file, renamed) = pieces.find(|(start, ..)| *start <= offset)?;
        let inside = offset - start;
        (inside <= renamed.text.len()).then(|| (*file, renamed.old_offset(inside)))
    }
}

impl HostText {
    /// Everything before the code of the pass: what the host requires, and common code.
    pub(super) fn common(&self) -> &str {
        let start = self.pieces.last().map_or(0, |(start, ..)| *start);
        self.text.get(..start).unwrap_or("")
    }
}

/// The parts of a shader for a host, before they are joined.
pub(super) struct HostWriter<'a> {
    host: &'a Preset,
    template: &'a Template,
    files: &'a [(FileId, &'a SourceFile)],
    /// The names that the shader or the host declares, apart from those of the user.
    reserved: BTreeSet<String>,
    /// All words that occur.
    taken: BTreeSet<String>,
    names: NewNames,
    uniforms: Vec<DeclaredUniform>,
    /// Declarations after those of uniforms.
    globals: String,
    assignments: Vec<String>,
    has_screen: bool,
    /// Text after the code of the user.
    after: String,
    /// The function that draws the image.
    image: String,
    /// Whether the code declares an interface, which is removed.
    is_complete: bool,
}

impl<'a> HostWriter<'a> {
    pub(super) fn new(
        host: &'a Preset,
        template: &'a Template,
        files: &'a [(FileId, &'a SourceFile)],
    ) -> HostWriter<'a> {
        let mut writer = HostWriter {
            host,
            template,
            files,
            reserved: BTreeSet::new(),
            taken: BTreeSet::new(),
            names: NewNames::new(),
            uniforms: Vec::new(),
            globals: String::new(),
            assignments: Vec::new(),
            has_screen: false,
            after: String::new(),
            image: "mainImage".to_string(),
            is_complete: false,
        };
        let own = files.iter().map(|(_, file)| &*file.text);
        let parts = [&template.head, &template.screen, &template.tail];
        for text in own
            .chain(parts.map(String::as_str))
            .chain([host.prelude.as_str()])
        {
            let words = words(text).into_iter().map(|(_, word)| word.to_string());
            writer.taken.extend(words);
        }
        let declared = host.prelude.lines().filter_map(declared_in);
        let lines = parts.into_iter().flat_map(|part| part.lines());
        let outer = lines.filter(|line| !line.starts_with([' ', '#', '}']));
        let all = declared.chain(outer.filter_map(declared_in));
        // Hosts without a built-in function may define it.
        let built_in = Builtins::of(Version::Es300, Stage::Fragment);
        let is_free = |name: &&str| {
            classify(name, Version::Es300) == WordClass::Plain && built_in.function(name).is_none()
        };
        let all = all.filter(is_free).map(str::to_string);
        writer.reserved.extend(all);
        writer
    }

    /// Makes the code of a complete shader one with a `mainImage`.
    pub(super) fn convert(&mut self, shader: &PlainShader) {
        for (old, new) in &shader.names {
            self.rename(old, new.clone());
        }
        if self.host.version != HostVersion::Es100 {
            self.rename("texture2D", "texture".to_string());
        }
        self.globals.push_str(&shader.globals);
        self.after = format!("\n{}", shader.image);
        self.taken.insert(shader.image_name.clone());
        self.image = shader.image_name.clone();
        self.is_complete = true;
    }

    /// Adds the inputs of the pass, with what supplies them.
    pub(super) fn supply(&mut self, inputs: &[(UsedInput, Supplied)]) {
        self.has_screen = inputs.iter().any(|(_, s)| {
            matches!(s, Supplied::Sampler(_)) || *s == Supplied::Uniform("sampler2D")
        });
        self.declare_of_host(inputs);
        for (input, supplied) in inputs {
            if let Supplied::Uniform(ty) = supplied {
                let about = match &input.value {
                    UsedValue::Known(feed) => feed.description(),
                    _ => "an image",
                };
                self.declare(&input.name, ty, about);
            }
        }
        for (input, supplied) in inputs {
            match supplied {
                Supplied::Same => {}
                Supplied::Sampler(name) => self.rename(&input.name, name.clone()),
                Supplied::Global(value) => self.global(input, value.clone()),
                Supplied::Uniform(ty) if *ty == input.ty => {}
                Supplied::Uniform(_) => {
                    let value = format!("{}({})", input.ty, input.name);
                    self.global(input, Some(value));
                }
            }
        }
        let kept = |(input, supplied): &(UsedInput, Supplied)| match supplied {
            Supplied::Same => Some(input.name.clone()),
            Supplied::Sampler(name) if *name == input.name => Some(name.clone()),
            Supplied::Uniform(ty) if *ty == input.ty => Some(input.name.clone()),
            _ => None,
        };
        let kept: BTreeSet<String> = inputs.iter().filter_map(kept).collect();
        self.avoid_reserved(&kept);
    }

    /// Declares the names of the host that the shader has to declare itself and that it uses.
    fn declare_of_host(&mut self, inputs: &[(UsedInput, Supplied)]) {
        let mut used = BTreeSet::new();
        let screen = match self.has_screen {
            true => self.template.screen.as_str(),
            false => "",
        };
        for text in [&self.template.head, screen, &self.template.tail] {
            used.extend(words(text).into_iter().map(|(_, word)| word.to_string()));
        }
        for (_, supplied) in inputs {
            match supplied {
                Supplied::Global(Some(value)) => {
                    used.extend(words(value).into_iter().map(|(_, w)| w.to_string()));
                }
                Supplied::Sampler(name) => {
                    used.insert(name.clone());
                }
                _ => {}
            }
        }
        let names = &self.host.meanings;
        for row in names
            .varyings
            .iter()
            .filter(|r| !r.is_declared && used.contains(&r.name))
        {
            let qualifier = match self.host.version {
                HostVersion::Es100 => "varying",
                _ => "in",
            };
            self.globals
                .push_str(&format!("{qualifier} {} {};\n", row.ty, row.name));
            self.reserved.insert(row.name.clone());
        }
        for row in names
            .feeds
            .iter()
            .filter(|r| !r.is_declared && used.contains(&r.name))
        {
            if let Some(ty) = row.types.first() {
                self.declare(&row.name, ty, row.feed.description());
            }
        }
        for row in names
            .textures
            .iter()
            .filter(|r| !r.is_declared && used.contains(&r.name))
        {
            self.declare(&row.name, "sampler2D", row.texture.description());
        }
    }

    fn declare(&mut self, name: &str, ty: &str, about: &str) {
        if self.uniforms.iter().any(|u| u.name == name) {
            return;
        }
        self.reserved.insert(name.to_string());
        self.taken.insert(name.to_string());
        // What further components would be.
        let about = match about.split_once(", then ") {
            Some((first, _)) if ty == "vec2" => first,
            _ => about,
        };
        self.uniforms.push(DeclaredUniform {
            name: name.to_string(),
            ty: ty.to_string(),
            about: about.to_string(),
        });
    }

    fn rename(&mut self, old: &str, new: String) {
        if old != new {
            self.taken.insert(new.clone());
            self.names.insert(old.to_string(), new);
        }
    }

    /// Supplies an input as a global variable, which `main` sets.
    fn global(&mut self, input: &UsedInput, value: Option<String>) {
        let mut name = input.name.clone();
        if self.reserved.contains(&name) {
            name = unused(&name, &self.taken);
            self.rename(&input.name, name.clone());
        }
        let (ty, size) = match input.ty.split_once('[') {
            Some((ty, size)) => (ty, format!("[{size}")),
            None => (input.ty.as_str(), String::new()),
        };
        self.globals.push_str(&format!("{ty} {name}{size};\n"));
        if let Some(value) = value {
            self.assignments.push(format!("{name} = {value};\n"));
        }
    }

    /// Renames the names of the user that the shader or the host declares, too.
    fn avoid_reserved(&mut self, kept: &BTreeSet<String>) {
        if !self.assignments.is_empty() && !self.template.tail.contains(IMAGE) {
            self.reserved.insert("mainImage".to_string());
        }
        let texts = self.files.iter().map(|(_, file)| &*file.text);
        let after = self.after.clone();
        for text in texts.chain([after.as_str()]).collect::<Vec<&str>>() {
            for (_, word) in words(text) {
                let is_taken = self.reserved.contains(word) && !kept.contains(word);
                if is_taken && !self.names.contains_key(word) {
                    let new = unused(word, &self.taken);
                    self.rename(word, new);
                }
            }
        }
    }

    /// Joins the parts; `credits` are lines without comment markers.
    pub(super) fn write(self, program: &Program, credits: &[String]) -> HostText {
        let mut text = self.head(credits);
        let mut pieces = Vec::new();
        for (id, file) in self.files {
            let removed = match self.is_complete {
                true => interface(&file.text),
                false => Vec::new(),
            };
            let renamed = RenamedText::of(&file.text, &self.names, &removed);
            let start = text.len();
            text.push_str(&renamed.text);
            if !text.ends_with('\n') {
                text.push('\n');
            }
            pieces.push((start, *id, renamed));
        }
        // Its `mainImage` gets another name like one of the user.
        text.push_str(&RenamedText::of(&self.after, &self.names, &[]).text);
        let tail = self.tail();
        text.push_str(&undefined(program, &tail, &self.names));
        text.push_str(&tail);
        HostText {
            text,
            uniforms: self.uniforms,
            pieces,
        }
    }

    fn head(&self, credits: &[String]) -> String {
        let credits: String = credits.iter().map(|line| format!("// {line}\n")).collect();
        let head = &self.template.head;
        let mut text = match head.split_once('\n') {
            Some((version, rest)) if version.starts_with("#version") => {
                format!("{version}\n{credits}{rest}")
            }
            _ => format!("{credits}{head}"),
        };
        for uniform in &self.uniforms {
            text.push_str(&format!("uniform {} {};\n", uniform.ty, uniform.name));
        }
        text.push_str(&self.globals);
        let is_named = |(_, file): &(FileId, &SourceFile)| file.text.contains(PERFORMANCE);
        if self.files.iter().any(is_named) {
            text.push_str(&format!("#define {PERFORMANCE} 1\n"));
        }
        if self.has_screen {
            text.push_str(&self.template.screen);
        }
        if !text.is_empty() {
            text.push('\n');
        }
        text
    }

    fn tail(&self) -> String {
        let mut tail = self.template.tail.as_str();
        if tail.is_empty() && !self.assignments.is_empty() {
            tail = CALL;
        }
        let mut text = String::new();
        for line in tail.split_inclusive('\n') {
            if line.contains(IMAGE) {
                let indent = line.len() - line.trim_start().len();
                for assignment in &self.assignments {
                    text.push_str(line.get(..indent).unwrap_or(""));
                    text.push_str(assignment);
                }
            }
            text.push_str(line);
        }
        let image = self.names.get(&self.image).unwrap_or(&self.image);
        match text.is_empty() {
            true => text,
            false => format!("\n{}", text.replace(IMAGE, image)),
        }
    }
}

/// A macro of ShaderToy's player.
const PERFORMANCE: &str = "HW_PERFORMANCE";

/// The end of a shader for a host that calls `mainImage`, if something has to be set before.
const CALL: &str = "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n    \
    port_image(fragColor, fragCoord);\n}\n";

/// Ends the macros of the user whose names occur in a text.
fn undefined(program: &Program, text: &str, names: &NewNames) -> String {
    let macros = program.tokens.macros.iter();
    let macros = macros.filter(|m| !m.predefined && program.is_user(m.name_span));
    let own: BTreeSet<&str> = macros
        .map(|m| program.names.text(m.name))
        .map(|name| names.get(name).map_or(name, |new| new))
        .collect();
    let used: BTreeSet<&str> = words(text).into_iter().map(|(_, word)| word).collect();
    own.intersection(&used)
        .map(|name| format!("#undef {name}\n"))
        .collect()
}
