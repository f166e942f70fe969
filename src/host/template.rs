//! The text around the code of a shader that is written for a host.
//!
//! `#pragma code` is where the code is inserted, after declarations of the names that it needs. The
//! name `port_image` stands for its `mainImage`. What follows `#pragma screen` is only written if the
//! shader reads the screen. What follows `#pragma host` is not written: it is what the host adds to
//! a shader, for hosts whose image is not that of the shader alone.

/// The text around the code of a shader.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Template {
    /// The text before the code.
    pub head: String,
    /// The text after that, if the shader reads the screen.
    pub screen: String,
    /// The text after the code.
    pub tail: String,
    /// What the host adds after that.
    pub host: String,
}

impl Template {
    /// Parses the lines of a template.
    ///
    /// # Errors
    /// If the code is inserted nowhere.
    pub(super) fn of(lines: &str) -> Result<Template, String> {
        let mut template = Template::default();
        let mut part = &mut template.head;
        let mut has_code = false;
        for line in lines.split_inclusive('\n') {
            match line.trim() {
                "#pragma screen" => part = &mut template.screen,
                "#pragma code" => {
                    has_code = true;
                    part = &mut template.tail;
                }
                "#pragma host" => part = &mut template.host,
                _ => part.push_str(line),
            }
        }
        match has_code {
            true => Ok(template),
            false => Err("expected `#pragma code` in the template".to_string()),
        }
    }
}
