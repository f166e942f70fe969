//! Reads the arguments of both programs, and answers wrong ones with the right ones.

use super::command::FAILED;
use crate::text::path::slashed;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};
use clap::parser::ValueSource::CommandLine;
use clap::{Arg, ArgMatches, Command, Parser};
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use strsim::damerau_levenshtein;

/// The arguments of a program. The first word is its name.
///
/// # Errors
/// The exit code, after the help or a message has been printed.
pub fn read<P: Parser>(words: impl Iterator<Item = OsString>) -> Result<P, u8> {
    let mut root = P::command();
    root.build();
    let words: Vec<OsString> = words.skip(1).collect();
    let words = [vec![root.get_name().into()], words].concat();
    let read = root.try_get_matches_from_mut(&words);
    let words: Vec<String> = words.iter().map(slashed).collect();
    let message = match &read {
        Ok(matches) => misplaced(&root, matches),
        Err(error) => mistaken(&root, &words, error),
    };
    if let Some(message) = message {
        eprintln!("{}: {message}", root.get_name());
        return Err(FAILED);
    }
    let read = read.and_then(|matches| P::from_arg_matches(&matches));
    read.map_err(|error| {
        let _ = error.print();
        error.exit_code() as u8
    })
}

/// Why nothing is read from a path, and what may be meant.
pub fn missing(path: &Path) -> String {
    if slashed(path).contains("://") {
        return "addresses are not read; save a JSON export of ShaderToy, or each tab as a file: \
                `image.glsl`, `buffer_a.glsl`, `common.glsl`"
            .to_string();
    }
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    let beside = std::fs::read_dir(folder.unwrap_or(Path::new(".")));
    let beside = beside.into_iter().flatten().flatten();
    let names = beside.map(|entry| slashed(path.with_file_name(entry.file_name())));
    let near = nearest(&slashed(path), names.map(|n| (n.clone(), n)));
    let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
    format!("no such file or folder{near}")
}

/// A message about the first of some inputs that does not exist.
pub fn absent(paths: &[PathBuf]) -> Option<String> {
    let is_absent = |path: &&PathBuf| path.as_os_str() != "-" && !path.exists();
    let path = paths.iter().find(is_absent)?;
    Some(format!("{}: {}", slashed(path), missing(path)))
}

/// What a word may be a misspelling of. `known` has names, and what to write for each.
fn nearest(word: &str, known: impl Iterator<Item = (String, String)>) -> Option<String> {
    let near = known.map(|(name, right)| (damerau_levenshtein(word, &name), right));
    let near = near.filter(|(distance, _)| *distance <= 2 && 2 * distance < word.len());
    near.min_by_key(|near| near.0).map(|(_, right)| right)
}

/// What is wrong with arguments that exist: an option in front of a command, a file to write among those
/// to read, a word that is no file.
fn misplaced(root: &Command, matches: &ArgMatches) -> Option<String> {
    let source = |arg: &Arg| matches.value_source(arg.get_id().as_str());
    let mut args = root.get_arguments();
    let mut given = args.by_ref().filter(|arg| source(arg) == Some(CommandLine));
    if let Some(name) = matches.subcommand_name() {
        let own = given.find(|arg| !arg.is_global_set())?;
        let message = format!("`{own}` is no option of all commands; pass it after `{name}`");
        return Some(message);
    }
    let paths = given.find(|arg| arg.is_positional())?.get_id().as_str();
    let paths: Vec<&Path> = matches.get_raw(paths)?.map(Path::new).collect();
    let (first, last) = (*paths.first()?, *paths.last()?);
    if paths.len() > 1 && is_output(root, last) && !matches.contains_id("output") {
        return question(last.to_str()?, &format!("-o {}", last.display()));
    }
    let word = first.to_str()?;
    let is_word = !word.contains(['.', '/', '\\', ':']) && !first.exists();
    let known = is_word.then(|| known(root, root, Some(word)))?;
    let near = nearest(word, known.into_iter());
    let question = near.and_then(|near| question(word, &near));
    question.or_else(|| no_command(root, word).filter(|_| paths.len() > 1))
}

/// A word before files that is neither a command nor a file.
fn no_command(root: &Command, word: &str) -> Option<String> {
    let commands = root.get_subcommands().filter(|own| !own.is_hide_set());
    let names: Vec<String> = commands
        .map(|own| format!("`{}`", own.get_name()))
        .collect();
    let names = names.join(", ");
    Some(format!(
        "`{word}` is neither a command nor a file; commands: {names}"
    ))
}

/// What is right instead of an argument that clap does not expect.
fn mistaken(root: &Command, words: &[String], error: &Error) -> Option<String> {
    let wrong = match (error.kind(), error.get(ContextKind::InvalidArg)?) {
        (ErrorKind::UnknownArgument, ContextValue::String(wrong)) => wrong,
        _ => return None,
    };
    let used = words.iter().find_map(|word| root.find_subcommand(word));
    let command = used.unwrap_or(root);
    if is_output(command, Path::new(wrong)) {
        return question(wrong, &format!("-o {wrong}"));
    }
    let known = known(root, command, None);
    let mut after = words.iter().skip_while(|word| *word != wrong).skip(1);
    let value = after.next().and_then(|next| {
        let is_value = |right: &str| right.starts_with("--") && right.contains(' ');
        let mut known = known.iter();
        known.find(|(name, right)| name == next && is_value(right))
    });
    let value = value.map(|(_, right)| right.clone());
    let name = sorted(wrong.trim_start_matches('-'));
    question(wrong, &value.or_else(|| nearest(&name, known.into_iter()))?)
}

fn question(wrong: &str, right: &str) -> Option<String> {
    let message = format!("unexpected argument `{wrong}`; did you mean `{right}`?");
    Some(message)
}

/// Whether a path can only be that of a file to write.
fn is_output(command: &Command, path: &Path) -> bool {
    let mut args = command.get_arguments();
    args.any(|arg| arg.get_id() == "output") && path.extension().is_some() && !path.exists()
}

/// The words of an option in a fixed order.
fn sorted(name: &str) -> String {
    let words: BTreeSet<&str> = name.split('-').collect();
    Vec::from_iter(words).join("-")
}

/// What can be written, by its name: options of a command and of others, their values, commands and
/// programs. A `word` without dashes also stands for the command whose description has it.
fn known(root: &Command, command: &Command, word: Option<&str>) -> Vec<(String, String)> {
    let mut known = Vec::from(["lint", "port"].map(|n| (n.to_string(), format!("shader{n}"))));
    for owner in [command, root].into_iter().chain(root.get_subcommands()) {
        let start = owner.get_bin_name().unwrap_or(root.get_name());
        let about = owner.get_about().map_or(String::new(), ToString::to_string);
        let mut about = about.split(' ').map(str::to_lowercase);
        let meant = word.filter(|word| word.len() > 3 && about.any(|own| own.starts_with(word)));
        known.push((meant.unwrap_or(owner.get_name()).into(), start.into()));
        let is_own = std::ptr::eq(owner, command);
        for arg in owner.get_arguments() {
            let Some(long) = arg.get_long() else { continue };
            let option = if is_own {
                format!("--{long}")
            } else {
                format!("{start} --{long}")
            };
            if arg.get_action().takes_values() {
                let values = arg.get_possible_values().into_iter();
                let values = values.map(|value| value.get_name().to_string());
                known.extend(values.map(|v| (v.clone(), format!("{option} {v}"))));
                if word.is_some() {
                    continue;
                }
            }
            known.extend(arg.get_short().map(|short| (short.into(), option.clone())));
            known.push((sorted(long), option));
        }
    }
    known
}
