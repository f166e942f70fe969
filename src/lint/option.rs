//! Options of rules: typed values that the configuration may change.

use super::settings::Renderer;

/// A declared option, with its default values.
#[derive(Debug)]
pub struct Setting<T> {
    /// Key in the configuration, in kebab case.
    pub name: &'static str,
    /// Description for pages and the schema: a sentence without a full stop.
    pub about: &'static str,
    default: T,
    on_swiftshader: T,
}

impl<T: Copy> Setting<T> {
    /// An option with the same default for all renderers.
    pub const fn new(name: &'static str, default: T, about: &'static str) -> Setting<T> {
        Setting {
            name,
            about,
            default,
            on_swiftshader: default,
        }
    }

    /// Sets another default for SwiftShader.
    pub const fn on_swiftshader(self, value: T) -> Setting<T> {
        Setting {
            on_swiftshader: value,
            ..self
        }
    }

    /// The default for a renderer.
    pub const fn usual(&self, target: Renderer) -> T {
        match target {
            Renderer::Gpu => self.default,
            Renderer::SwiftShader => self.on_swiftshader,
        }
    }
}

/// An option of a rule, by its type.
#[derive(Clone, Copy, Debug)]
pub enum RuleOption {
    /// An integer, 0 or more.
    Count(&'static Setting<u64>),
    /// A number, 0 or more.
    Number(&'static Setting<f64>),
    /// A boolean.
    Switch(&'static Setting<bool>),
}

impl RuleOption {
    /// Key in the configuration.
    pub const fn name(self) -> &'static str {
        match self {
            RuleOption::Count(setting) => setting.name,
            RuleOption::Number(setting) => setting.name,
            RuleOption::Switch(setting) => setting.name,
        }
    }

    /// Description: a sentence without a full stop.
    pub const fn about(self) -> &'static str {
        match self {
            RuleOption::Count(setting) => setting.about,
            RuleOption::Number(setting) => setting.about,
            RuleOption::Switch(setting) => setting.about,
        }
    }

    /// Whether the default for SwiftShader differs.
    pub fn depends_on_target(self) -> bool {
        self.usual(Renderer::Gpu) != self.usual(Renderer::SwiftShader)
    }

    /// The default for a renderer.
    pub const fn usual(self, target: Renderer) -> OptionValue {
        match self {
            RuleOption::Count(setting) => OptionValue::Count(setting.usual(target)),
            RuleOption::Number(setting) => OptionValue::Number(setting.usual(target)),
            RuleOption::Switch(setting) => OptionValue::Switch(setting.usual(target)),
        }
    }
}

/// A value of an option.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum OptionValue {
    /// An integer.
    Count(u64),
    /// A number.
    Number(f64),
    /// A boolean.
    Switch(bool),
}

impl std::fmt::Display for OptionValue {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            OptionValue::Count(value) => value.fmt(f),
            OptionValue::Number(value) => value.fmt(f),
            OptionValue::Switch(value) => value.fmt(f),
        }
    }
}

/// A type that an option may have.
pub trait OptionType: Copy {
    /// Converts a value; `None` if it is of another type.
    fn of(value: OptionValue) -> Option<Self>;
}

impl OptionType for u64 {
    fn of(value: OptionValue) -> Option<u64> {
        match value {
            OptionValue::Count(value) => Some(value),
            OptionValue::Number(_) | OptionValue::Switch(_) => None,
        }
    }
}

impl OptionType for f64 {
    fn of(value: OptionValue) -> Option<f64> {
        match value {
            OptionValue::Number(value) => Some(value),
            OptionValue::Count(_) | OptionValue::Switch(_) => None,
        }
    }
}

impl OptionType for bool {
    fn of(value: OptionValue) -> Option<bool> {
        match value {
            OptionValue::Switch(value) => Some(value),
            OptionValue::Count(_) | OptionValue::Number(_) => None,
        }
    }
}
