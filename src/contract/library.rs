//! What libraries call things: the table in `libraries.txt`.

use shaderlint_script::{Call, ObjectId, ObjectKind, Source, Value, World};
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
    /// Uniforms and attributes that the library sets; a trailing `*` matches any suffix.
    pub gives: Vec<String>,
    /// A uniform without which it does nothing.
    pub requires: Option<String>,
    /// The function that sets uniforms: `setUniform(name, value)`, or with an object of values.
    pub setter: String,
    /// Where the shaders are stored by their names, with the ends of these.
    pub store: String,
    /// The path of the list of names.
    pub listed: Vec<String>,
    /// Whether only listed uniforms can be set.
    pub is_limited: bool,
}

impl Maker {
    /// The lines that the library puts before a shader: three.js sets default precisions.
    pub fn before(&self) -> &'static str {
        match self.library.as_str() {
            "three" if self.name != "RawShaderMaterial" && self.name != "rawShaderMaterial" => {
                "precision highp float;\nprecision highp int;\n"
            }
            _ => "",
        }
    }

    /// Whether the library sets a name.
    pub fn gives(&self, name: &str) -> bool {
        self.gives.iter().any(|given| matches(given, name))
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

/// The names that three.js declares or sets in all its materials.
pub fn given_by_three(name: &str) -> bool {
    makers()
        .iter()
        .find(|m| m.library == "three")
        .is_some_and(|m| m.gives(name))
}

/// All makers.
pub fn makers() -> &'static [Maker] {
    static MAKERS: OnceLock<Vec<Maker>> = OnceLock::new();
    MAKERS.get_or_init(|| read(include_str!("libraries.txt")))
}

fn read(table: &str) -> Vec<Maker> {
    let mut gives: Vec<String> = Vec::new();
    let mut found = Vec::new();
    for line in table.lines().map(str::trim) {
        let mut words = line.split_whitespace();
        let (Some(library), false) = (words.next(), line.starts_with('#')) else {
            continue;
        };
        // The names that the makers after it set.
        if library == "gives" {
            gives = words.map(str::to_string).collect();
            continue;
        }
        let mut maker = Maker {
            library: library.to_string(),
            name: words.next().unwrap_or("").to_string(),
            stages: Default::default(),
            uniforms: Vec::new(),
            attributes: Vec::new(),
            defines: Vec::new(),
            boxing: Boxing::Plain,
            copies: false,
            gives: gives.clone(),
            requires: None,
            setter: String::new(),
            store: String::new(),
            listed: Vec::new(),
            is_limited: false,
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
                "bare" => maker.gives.clear(),
                "setter" => maker.setter = value.to_string(),
                "store" => maker.store = value.to_string(),
                "listed" => maker.listed = path(),
                "limited" => maker.is_limited = true,
                _ => {}
            }
        }
        found.push(maker);
    }
    found
}

/// The library and the name of a value that comes from outside of the program.
pub struct Origin<'w> {
    /// The path of the package, or the global name of the library.
    pub library: &'w str,
    /// The name of its export.
    pub name: &'w str,
}

impl<'w> Origin<'w> {
    /// Where a function comes from.
    pub fn of(world: &'w World, callee: Option<ObjectId>) -> Option<Origin<'w>> {
        let id = callee?;
        if let Some((library, name)) = world.export_of(id) {
            return Some(Origin { library, name });
        }
        match &world.object(id)?.kind {
            ObjectKind::Foreign(Source::Member(object, name)) => {
                match &world.object(*object)?.kind {
                    ObjectKind::Foreign(Source::Global(library)) => Some(Origin { library, name }),
                    _ => None,
                }
            }
            ObjectKind::Foreign(Source::Global(name)) => Some(Origin { library: "", name }),
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
pub fn maker_of(world: &World, call: &Call) -> Option<&'static Maker> {
    // The elements of a renderer of React.
    let is_element = call.is_new && call.callee.is_none();
    let origin = Origin::of(world, call.callee);
    let mut all = makers().iter().filter(|maker| match maker.name.as_str() {
        name if is_element => *name == *call.name && name.starts_with(|c: char| c.is_lowercase()),
        "(call)" => made_by(world, call.callee).is_some_and(|o| o.is_of(&maker.library)),
        name => {
            let own = origin.as_ref().is_some_and(|o| {
                o.is_of(&maker.library) && (*name == *call.name || *name == *o.name)
            });
            let is_method = name
                .strip_prefix('.')
                .is_some_and(|method| *method == *call.name);
            own || is_method && !call.is_new
        }
    });
    all.find(|maker| {
        let stages = maker.stages.iter().filter(|path| !path.is_empty());
        let mut found = stages.map(|path| at(world, call, path));
        found.any(|value| matches!(value, Some(Value::Text(_))))
    })
}

/// The library whose export was called to make a value: `regl` in `const regl = createREGL()`.
fn made_by<'w>(world: &'w World, callee: Option<ObjectId>) -> Option<Origin<'w>> {
    let call = world.call_of(callee?)?;
    Origin::of(world, call.callee)
}

/// The value at a path in the arguments of a call.
pub fn at(world: &World, call: &Call, path: &[String]) -> Option<Value> {
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
