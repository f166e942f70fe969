//! Writes XML.

use super::place::xml;
use std::fmt::{self, Display};

/// An element. It is shown on lines of its own, indented by the width of the format.
pub struct XmlElement {
    name: &'static str,
    attributes: String,
    text: String,
    children: Vec<XmlElement>,
}

impl XmlElement {
    /// An element without attributes and content.
    pub fn new(name: &'static str) -> XmlElement {
        XmlElement {
            name,
            attributes: String::new(),
            text: String::new(),
            children: Vec::new(),
        }
    }

    /// Adds an attribute.
    pub fn with(mut self, name: &str, value: impl Display) -> XmlElement {
        let value = xml(&value.to_string());
        self.attributes.push_str(&format!(" {name}=\"{value}\""));
        self
    }

    /// Sets the text.
    pub fn text(mut self, text: &str) -> XmlElement {
        self.text = xml(text);
        self
    }

    /// Adds elements.
    pub fn children(mut self, children: impl IntoIterator<Item = XmlElement>) -> XmlElement {
        self.children.extend(children);
        self
    }
}

impl Display for XmlElement {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let indent = f.width().unwrap_or(0);
        let (name, attributes, text) = (self.name, &self.attributes, &self.text);
        write!(f, "{:indent$}<{name}{attributes}", "")?;
        if text.is_empty() && self.children.is_empty() {
            return writeln!(f, "/>");
        }
        if self.children.is_empty() {
            return writeln!(f, ">{text}</{name}>");
        }
        writeln!(f, ">")?;
        let inner = indent + 2;
        let mut children = self.children.iter();
        children.try_for_each(|child| write!(f, "{child:inner$}"))?;
        writeln!(f, "{:indent$}</{name}>", "")
    }
}
