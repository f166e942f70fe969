//! What libraries call things: the table in `libraries.txt`.

use shaderlint_script::{ForeignCall, ObjectId, ObjectKind, ScriptValue, Source, World};
use std::collections::HashSet;
use std::sync::OnceLock;

/// How the values of uniforms are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Boxing {
    /// `{ name: { value } }`
    Boxed,
    /// `{ name: value }`
    Plain,
    /// `{ alias: { name, type, value } }`
    Named,
    /// `{ group: { name: { value, type } } }`
    Grouped,
}

/// A function or class of a library that makes a program of shaders.
#[derive(Debug)]
pub struct Maker {
    /// A word of the names of its packages.
    pub library: String,
    /// Its name; starts with a dot for a method.
    pub name: String,
    /// The paths of the vertex and of the fragment shader in its arguments.
    pub stages: [Vec<String>; 2],
    /// The path of the uniforms.
    pub uniforms: Vec<String>,
    /// The path of the attributes.
    pub attributes: Vec<String>,
    /// The path of the macros.
    pub defines: Vec<String>,
    /// How uniforms are written.
    pub boxing: Boxing,
    /// Whether it copies the uniforms, so that the object that it gets is another.
    pub copies: bool,
    /// Uniforms that the library sets; a trailing `*` matches any suffix.
    gives: Vec<String>,
    /// Attributes that it sets.
    feeds: Vec<String>,
    /// Whether it sets default precisions before a shader.
    pub is_precise: bool,
    /// A uniform without which it does nothing.
    pub requires: Option<String>,
    /// The function that sets uniforms: `setUniform(name, value)`, or with an object of values.
    pub setter: String,
    /// Where the shaders are stored by their names, with the ends of these.
    pub store: String,
    /// The path of the list of names.
    pub listed: Vec<String>,
    /// Whether it is also the global function of its name.
    pub is_global: bool,
    /// Whether only listed uniforms can be set.
    pub is_limited: bool,
    /// Whether it makes a class, whose instances have the uniforms as properties.
    pub is_class: bool,
}

impl Maker {
    /// The lines that the library puts before a shader.
    pub fn before(&self) -> &'static str {
        match self.is_precise {
            true => "precision highp float;\nprecision highp int;\n",
            false => "",
        }
    }

    /// Whether the library sets a uniform.
    pub fn gives(&self, name: &str) -> bool {
        self.gives.iter().any(|given| matches(given, name))
    }

    /// Whether the library feeds an attribute.
    pub fn feeds(&self, name: &str) -> bool {
        self.feeds.iter().any(|given| matches(given, name))
    }

    /// Whether a function of this name sets uniforms.
    pub fn is_setter(&self, name: &str) -> bool {
        !self.setter.is_empty() && matches(&self.setter, name)
    }

    /// Whether the setters name the type: `setVector2`.
    pub fn has_typed_setters(&self) -> bool {
        self.setter == "set*"
    }
}

/// Whether a name is this one, or begins so if that ends with a star.
fn matches(pattern: &str, name: &str) -> bool {
    match pattern.strip_suffix('*') {
        Some(start) => name.starts_with(start),
        None => pattern == name,
    }
}

/// A class for attributes.
#[derive(Debug)]
pub struct GeometryClass {
    /// A word of the names of its packages.
    pub library: String,
    name: String,
    /// What it feeds.
    pub kind: GeometryKind,
}

/// What a class for attributes feeds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GeometryKind {
    /// What is added.
    Empty,
    /// What is added, and others.
    Open,
    /// What shapes have.
    Shape,
    /// What an argument holds.
    Object,
}

/// The table.
#[derive(Debug, Default)]
struct LibraryTable {
    makers: Vec<Maker>,
    geometries: Vec<GeometryClass>,
    /// The attributes that shapes have.
    shapes: Vec<String>,
    /// The properties of instances besides uniforms.
    properties: Vec<String>,
    patched: String,
    /// The names of all makers, without dots.
    names: HashSet<String>,
    signs: Vec<String>,
}

fn table() -> &'static LibraryTable {
    static TABLE: OnceLock<LibraryTable> = OnceLock::new();
    TABLE.get_or_init(|| read(include_str!("libraries.txt")))
}

/// Whether a script may make programs of shaders.
pub fn may_make_programs(script: &str) -> bool {
    table().signs.iter().any(|sign| script.contains(sign))
}

/// Whether a path is a library: `../lib/three.module.js`.
pub fn is_library(path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path);
    let first = name.split(['.', '-']).next().unwrap_or("");
    let word = first.to_ascii_lowercase();
    let all = &table().makers;
    name.contains(".js")
        && all
            .iter()
            .any(|m| m.library == word || m.library == word.trim_end_matches("js"))
}

/// Whether the shaders of materials that are patched declare a name.
pub fn is_given_to_patches(name: &str) -> bool {
    let all = &table().makers;
    let maker = all.iter().find(|m| m.library == table().patched);
    maker.is_some_and(|m| m.gives(name) || m.feeds(name))
}

/// The attributes that shapes have.
pub fn attributes_of_shapes() -> &'static [String] {
    &table().shapes
}

/// Whether instances of a class that a maker makes have a property, which is no uniform: also `position-x` and
/// `onUpdate`.
pub fn is_property(name: &str) -> bool {
    let is_handler = name.starts_with("on") && name.chars().nth(2).is_some_and(char::is_uppercase);
    is_handler || name.contains('-') || table().properties.iter().any(|own| own == name)
}

/// The kind of a class for attributes.
pub fn geometry_kind(origin: &LibraryExport) -> Option<GeometryKind> {
    let mut all = table().geometries.iter();
    let found = all.find(|class| {
        let is_it = match class.name.strip_prefix('*') {
            Some(end) => origin.name.ends_with(end),
            None => origin.name == class.name,
        };
        is_it && origin.is_of(&class.library)
    });
    found.map(|class| class.kind)
}

/// All makers.
pub fn makers() -> &'static [Maker] {
    &table().makers
}

fn read(table: &str) -> LibraryTable {
    let (mut gives, mut feeds) = (Vec::new(), Vec::new());
    let mut found = LibraryTable::default();
    for line in table.lines().map(str::trim) {
        let mut words = line.split_whitespace();
        let (Some(library), false) = (words.next(), line.starts_with('#')) else {
            continue;
        };
        let mut rest = || words.by_ref().map(str::to_string).collect::<Vec<String>>();
        match library {
            // The names that the makers after it set.
            "gives" => gives = rest(),
            "feeds" => feeds = rest(),
            "signs" => found.signs = rest(),
            "shapes" => found.shapes = rest(),
            "properties" => found.properties = rest(),
            "patched" => found.patched = rest().concat(),
            "geometry" => found.geometries.extend(read_geometry(&rest())),
            _ => found
                .makers
                .push(read_maker(library, (&gives, &feeds), words)),
        }
    }
    let names = found
        .makers
        .iter()
        .map(|m| m.name.trim_start_matches('.').to_string());
    found.names = names.collect();
    found
}

fn read_geometry(words: &[String]) -> Option<GeometryClass> {
    let [library, name, kind] = words else {
        return None;
    };
    Some(GeometryClass {
        library: library.clone(),
        name: name.clone(),
        kind: match kind.as_str() {
            "empty" => GeometryKind::Empty,
            "shape" => GeometryKind::Shape,
            "object" => GeometryKind::Object,
            _ => GeometryKind::Open,
        },
    })
}

fn read_maker<'t>(
    library: &str,
    (gives, feeds): (&[String], &[String]),
    mut words: impl Iterator<Item = &'t str>,
) -> Maker {
    let mut maker = Maker {
        library: library.to_string(),
        name: words.next().unwrap_or("").to_string(),
        stages: Default::default(),
        uniforms: Vec::new(),
        attributes: Vec::new(),
        defines: Vec::new(),
        boxing: Boxing::Plain,
        copies: false,
        gives: gives.to_vec(),
        feeds: feeds.to_vec(),
        is_precise: false,
        requires: None,
        setter: String::new(),
        store: String::new(),
        listed: Vec::new(),
        is_limited: false,
        is_class: false,
        is_global: false,
    };
    for word in words {
        let (key, value) = word.split_once('=').unwrap_or((word, ""));
        let path = || value.split('.').map(str::to_string).collect();
        match key {
            "vertex" => maker.stages[0] = path(),
            "fragment" => maker.stages[1] = path(),
            "uniforms" => maker.uniforms = path(),
            "attributes" => maker.attributes = path(),
            "defines" => maker.defines = path(),
            "requires" => maker.requires = Some(value.to_string()),
            "boxed" => maker.boxing = Boxing::Boxed,
            "named" => maker.boxing = Boxing::Named,
            "grouped" => maker.boxing = Boxing::Grouped,
            "copies" => maker.copies = true,
            "precise" => maker.is_precise = true,
            "setter" => maker.setter = value.to_string(),
            "store" => maker.store = value.to_string(),
            "listed" => maker.listed = path(),
            "limited" => maker.is_limited = true,
            "class" => maker.is_class = true,
            "global" => maker.is_global = true,
            _ => {}
        }
    }
    maker
}

/// The library and the name of a value that comes from outside of the program.
pub struct LibraryExport<'w> {
    /// The path of the package, or the global name of the library.
    pub library: &'w str,
    /// The name of its export.
    pub name: &'w str,
}

impl<'w> LibraryExport<'w> {
    /// Where a function comes from.
    pub fn of(world: &'w World, callee: Option<ObjectId>) -> Option<LibraryExport<'w>> {
        let id = callee?;
        if let Some((library, name)) = world.export_of(id) {
            return Some(LibraryExport { library, name });
        }
        match &world.object(id)?.kind {
            ObjectKind::Foreign(Source::Member(object, name)) => {
                match &world.object(*object)?.kind {
                    ObjectKind::Foreign(Source::Global(library)) => {
                        Some(LibraryExport { library, name })
                    }
                    _ => None,
                }
            }
            ObjectKind::Foreign(Source::Global(name)) => Some(LibraryExport { library: "", name }),
            _ => None,
        }
    }

    /// Whether it comes from a library, which a word in the name of a package or of a global object shows.
    pub fn is_of(&self, library: &str) -> bool {
        let mut words = self.library.split(|c: char| !c.is_ascii_alphanumeric());
        words.any(|word| {
            let word = word.to_ascii_lowercase();
            word == library || word.trim_end_matches("js") == library
        })
    }
}

/// The maker that a call calls.
pub fn maker_of(world: &World, call: &ForeignCall) -> Option<&'static Maker> {
    if !table().names.contains(&*call.name) && made_by(world, call.callee).is_none() {
        return None;
    }
    // The elements of a renderer of React.
    let is_element = call.is_new && call.callee.is_none();
    let origin = LibraryExport::of(world, call.callee);
    let mut all = makers().iter().filter(|maker| match maker.name.as_str() {
        name if is_element => *name == *call.name && name.starts_with(|c: char| c.is_lowercase()),
        "(call)" => made_by(world, call.callee).is_some_and(|o| o.is_of(&maker.library)),
        name => {
            let own = origin.as_ref().is_some_and(|o| {
                o.is_of(&maker.library) && (*name == *call.name || *name == *o.name)
            });
            let is_global = maker.is_global
                && origin
                    .as_ref()
                    .is_some_and(|o| o.library.is_empty() && o.name == name);
            let is_method = name
                .strip_prefix('.')
                .is_some_and(|method| *method == *call.name);
            own || is_global || is_method && !call.is_new
        }
    });
    all.find(|maker| {
        let stages = maker.stages.iter().filter(|path| !path.is_empty());
        let mut found = stages.map(|path| at(world, call, path));
        found.any(|value| matches!(value, Some(ScriptValue::Text(_))))
    })
}

/// The library whose export was called to make a value: `regl` in `const regl = createREGL()`.
fn made_by<'w>(world: &'w World, callee: Option<ObjectId>) -> Option<LibraryExport<'w>> {
    let call = world.call_of(callee?)?;
    LibraryExport::of(world, call.callee)
}

/// The value at a path in the arguments of a call.
pub fn at(world: &World, call: &ForeignCall, path: &[String]) -> Option<ScriptValue> {
    let (first, rest) = path.split_first()?;
    let index: usize = first.parse().ok()?;
    let mut value = call.arguments.get(index)?.0.clone();
    for key in rest {
        // What another call got as an argument: `GlProgram.from({ vertex, fragment })`.
        value = match key.strip_prefix('@').map(str::parse::<usize>) {
            Some(Ok(index)) => {
                let inner = world.call_of(value.object()?)?;
                inner.arguments.get(index)?.0.clone()
            }
            _ => match key.parse::<usize>() {
                Ok(index) => world.elements(&value)?.get(index)?.clone(),
                Err(_) => world.get(&value, key)?.clone(),
            },
        };
    }
    Some(value)
}
