//! `explain`, `rules`, `completions`, `man`, `schema`.

use super::super::config::schema;
use super::super::{CLEAN, FAILED};
use super::args::{Args, Command};
use super::complain;
use crate::diagnostic::{ERRORS, error_page};
use crate::lint::Page;
use crate::rules::RULES;
use clap::CommandFactory;
use std::io::{self, Write};

/// Runs a command and gives the exit code.
pub fn run(command: &Command) -> io::Result<u8> {
    // Collected first, so that the libraries which print need not deal with closed pipes.
    let mut text = Vec::new();
    match command {
        Command::Explain { name } => return explain(name),
        Command::Rules => text.extend_from_slice(rules().as_bytes()),
        Command::Completions { shell } => {
            clap_complete::generate(*shell, &mut Args::command(), "shaderlint", &mut text);
        }
        Command::Man => clap_mangen::Man::new(Args::command()).render(&mut text)?,
        Command::Schema => text.extend_from_slice(schema(RULES).as_bytes()),
    }
    io::stdout().lock().write_all(&text)?;
    Ok(CLEAN)
}

/// Prints a page and gives the exit code.
pub fn explain(name: &str) -> io::Result<u8> {
    let Some(page) = page(name) else {
        complain(&unknown(name));
        return Ok(FAILED);
    };
    io::stdout().lock().write_all(page.as_bytes())?;
    Ok(CLEAN)
}

/// The page of a rule or a compile error.
pub fn page(name: &str) -> Option<&'static str> {
    let rule = RULES.iter().find(|r| r.name == name);
    rule.map(|r| r.page).or_else(|| error_page(name))
}

fn unknown(name: &str) -> String {
    let names = RULES.iter().map(|r| r.name).chain(ERRORS.iter().copied());
    let distances = names.map(|n| (strsim::damerau_levenshtein(n, name), n));
    let near = distances.filter(|(d, _)| *d <= 3).min();
    let near = near.map_or(String::new(), |(_, n)| format!("; did you mean `{n}`?"));
    format!("there is no rule or compile error `{name}`{near}")
}

/// A table of all rules: name, group, level, summary.
fn rules() -> String {
    let width = RULES.iter().map(|r| r.name.len()).max().unwrap_or(0);
    let mut sorted = RULES.to_vec();
    sorted.sort_by_key(|r| (r.group, r.name));
    let mut text = String::new();
    for rule in sorted {
        let level = if rule.default {
            rule.severity.name()
        } else {
            "off"
        };
        let summary = Page::new(rule.page).summary;
        let (name, group) = (rule.name, rule.group.name());
        text.push_str(&format!(
            "{name:width$}  {group:11}  {level:7}  {summary}\n"
        ));
    }
    text
}
