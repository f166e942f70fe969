//! What a rule goes by and the configuration may change: numbers and switches, each of its type.

use super::settings::Renderer;

/// A value that a rule goes by.
#[derive(Debug)]
pub struct Setting<T> {
    /// Its name in the configuration: words with hyphens.
    pub name: &'static str,
    /// What it is, as a sentence without a full stop.
    pub about: &'static str,
    default: T,
    on_swiftshader: T,
}

impl<T: Copy> Setting<T> {
    /// A setting with one value wherever a shader is drawn.
    pub const fn new(name: &'static str, default: T, about: &'static str) -> Setting<T> {
        Setting {
            name,
            about,
            default,
            on_swiftshader: default,
        }
    }

    /// With another value where a processor draws.
    pub const fn on_swiftshader(self, value: T) -> Setting<T> {
        Setting {
            on_swiftshader: value,
            ..self
        }
    }

    /// What the rule goes by where the configuration says nothing.
    pub const fn usual(&self, target: Renderer) -> T {
        match target {
            Renderer::Gpu => self.default,
            Renderer::SwiftShader => self.on_swiftshader,
        }
    }
}

/// A setting of a rule, by its type.
#[derive(Clone, Copy, Debug)]
pub enum RuleOption {
    /// A whole number, 0 or more.
    Count(&'static Setting<u64>),
    /// A number, 0 or more.
    Number(&'static Setting<f64>),
    /// Yes or no.
    Switch(&'static Setting<bool>),
}

impl RuleOption {
    /// Its name in the configuration.
    pub const fn name(self) -> &'static str {
        match self {
            RuleOption::Count(setting) => setting.name,
            RuleOption::Number(setting) => setting.name,
            RuleOption::Switch(setting) => setting.name,
        }
    }

    /// What it is, as a sentence without a full stop.
    pub const fn about(self) -> &'static str {
        match self {
            RuleOption::Count(setting) => setting.about,
            RuleOption::Number(setting) => setting.about,
            RuleOption::Switch(setting) => setting.about,
        }
    }

    /// Whether a rule goes by another value where a processor draws.
    pub fn depends_on_target(self) -> bool {
        self.usual(Renderer::Gpu) != self.usual(Renderer::SwiftShader)
    }

    /// What the rule goes by where the configuration says nothing.
    pub const fn usual(self, target: Renderer) -> OptionValue {
        match self {
            RuleOption::Count(setting) => OptionValue::Count(setting.usual(target)),
            RuleOption::Number(setting) => OptionValue::Number(setting.usual(target)),
            RuleOption::Switch(setting) => OptionValue::Switch(setting.usual(target)),
        }
    }
}

/// A value of a setting.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum OptionValue {
    /// A whole number.
    Count(u64),
    /// A number.
    Number(f64),
    /// Yes or no.
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

/// A type that a setting may have.
pub trait OptionType: Copy {
    /// The value, if it is of this type.
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
