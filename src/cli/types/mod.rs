//! `shaderlint types` and `shaderlint reflect`.

mod args;

pub use args::{ReflectArgs, TypesArgs};

use super::command::{CLEAN, FAILED, FINDINGS, complain};
use super::config::{absolute, configs};
use super::disk::Disk;
use super::global::{Talk, given};
use super::input::{InputFile, collect, read};
use super::output::{Overwrite, replace, write};
use super::parallel::in_order;
use super::usage::absent;
use super::watch::{Stamp, wait};
use crate::commands::{
    FileReflection, ReflectedShader, ReflectionList, declaration, helpers, module, reflect,
    type_style,
};
use crate::detect::kind::is_shader;
use crate::diagnostic::count;
use crate::engine::config::Configs;
use crate::text::path::{relative, slashed, tidy};
use args::asked;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// How a generated file begins. Others are never overwritten.
const MARK: &str = "// Written by `shaderlint types`";

/// Prints what shaders declare, and returns the exit code.
pub fn print_reflection(args: &ReflectArgs) -> io::Result<u8> {
    let (shaders, code) = shaders_of(&args.paths, args.stdin_filename.as_deref(), |_| true)?;
    let shaders: Vec<ReflectedShader> = shaders.into_iter().flat_map(|(_, all)| all).collect();
    let mut text = serde_json::to_vec_pretty(&ReflectionList::new(&shaders))?;
    text.push(b'\n');
    io::stdout().lock().write_all(&text)?;
    Ok(code)
}

/// Writes declarations, and returns the exit code.
pub fn run(args: &TypesArgs) -> io::Result<u8> {
    if !args.watch {
        return generate(args);
    }
    if let Some(message) = absent(&args.paths) {
        complain(&message);
        return Ok(FAILED);
    }
    loop {
        let stamp = take_stamp(args);
        generate(args)?;
        complain("waiting for changes");
        wait(stamp, || take_stamp(args));
    }
}

/// The state of all shaders; generated files do not count.
fn take_stamp(args: &TypesArgs) -> Stamp {
    let configs = configs(asked(&args.paths));
    let inputs = collect(&args.paths, None, &configs).inputs;
    let own = inputs.into_iter().filter(|i| is_shader(&i.name));
    Stamp::of(own.filter_map(|i| i.path))
}

/// Writes or compares declarations once.
fn generate(args: &TypesArgs) -> io::Result<u8> {
    let is_input = |name: &str| is_shader(name);
    let (files, mut code) = shaders_of(&args.paths, args.stdin_filename.as_deref(), is_input)?;
    let mut writer = DeclarationWriter {
        args,
        changed: 0,
        unchanged: 0,
        code: CLEAN,
    };
    let style = type_style(args.uniforms.types());
    let mut listed = Vec::new();
    for (input, shaders) in &files {
        let [shader] = shaders.as_slice() else {
            if shaders.len() > 1 {
                let all = count(shaders.len(), "shader");
                complain(&format!(
                    "{}: skipped: {all} in one file, which an import cannot name",
                    input.name
                ));
            }
            continue;
        };
        if args.module.is_some() {
            listed.push((input, &shader.declares));
            continue;
        }
        let name = input.name.rsplit('/').next().unwrap_or(&input.name);
        let text = declaration(name, &shader.declares, &style);
        let target = input.path.as_ref().map(|path| {
            let mut path = path.clone().into_os_string();
            path.push(".d.ts");
            PathBuf::from(path)
        });
        writer.put(target.as_deref(), &text)?;
    }
    if let Some(path) = &args.module {
        let folder = absolute(path.parent().unwrap_or(Path::new("")));
        let keys = listed.iter().map(|(input, shader)| {
            let file = input.path.as_deref().unwrap_or(Path::new(&input.name));
            let path = relative(&folder, &absolute(file)).unwrap_or_else(|| input.name.clone());
            let is_above = path.starts_with('.');
            (if is_above { path } else { format!("./{path}") }, *shader)
        });
        let keys: Vec<_> = keys.collect();
        let all = keys.iter().map(|(key, shader)| (key.as_str(), *shader));
        writer.put(Some(path), &module(all, &style))?;
    }
    if let Some(path) = &args.helpers {
        writer.put(Some(path), &helpers(&style))?;
    }
    writer.sum_up(files.is_empty() && code == CLEAN);
    code = code.max(writer.code);
    Ok(code)
}

/// Inputs with their shaders.
type InputShaders = Vec<(InputFile, Vec<ReflectedShader>)>;

/// The inputs that `is_input` takes with their shaders, and the exit code so far.
fn shaders_of(
    paths: &[PathBuf],
    stdin_name: Option<&str>,
    is_input: impl Fn(&str) -> bool,
) -> io::Result<(InputShaders, u8)> {
    let configs = configs(asked(paths));
    if let Some(message) = configs.problem() {
        complain(&message);
        return Ok((Vec::new(), FAILED));
    }
    let collected = collect(paths, stdin_name, &configs);
    collected.problems.iter().for_each(|p| complain(p));
    let mut code = match collected.problems.is_empty() {
        true => CLEAN,
        false => FAILED,
    };
    let is_taken = |input: &InputFile| input.is_explicit || is_input(&input.name);
    let inputs: Vec<InputFile> = collected.inputs.into_iter().filter(is_taken).collect();
    let disk = Disk::new();
    let work = |at: usize| {
        inputs
            .get(at)
            .map(|input| (input, shaders(input, &configs, &disk)))
    };
    let mut found = Vec::new();
    in_order(inputs.len(), &work, &mut |done| {
        let Some((input, outcome)) = done else {
            return Ok(());
        };
        match outcome {
            Ok(file) => {
                if file.broken > 0 {
                    complain(&format!(
                        "{}: {} with errors; `shaderlint {}` lists them",
                        input.name,
                        count(file.broken, "shader"),
                        input.name
                    ));
                    code = code.max(FINDINGS);
                }
                found.push((input.clone(), file.shaders));
            }
            Err(message) if input.is_explicit => {
                complain(&format!("{}: {message}", input.name));
                code = FAILED;
            }
            Err(_) => {}
        }
        Ok(())
    })?;
    Ok((found, code))
}

/// The shaders of an input.
fn shaders(input: &InputFile, configs: &Configs, disk: &Disk) -> Result<FileReflection, String> {
    let options = configs.options(Path::new(&input.name));
    let options = options.map_err(|e| e.to_string())?;
    let text = read(input)?.text;
    reflect((&input.name, &text), &options, disk)
}

/// Writes generated files, or compares them.
struct DeclarationWriter<'a> {
    args: &'a TypesArgs,
    changed: usize,
    unchanged: usize,
    code: u8,
}

impl DeclarationWriter<'_> {
    /// Writes a generated file unless it is up to date; without a path, prints it.
    fn put(&mut self, path: Option<&Path>, text: &str) -> io::Result<()> {
        let Some(path) = path.filter(|_| !self.args.stdout) else {
            return io::stdout().lock().write_all(text.as_bytes());
        };
        let old = fs::read_to_string(path).ok();
        if old.as_deref() == Some(text) {
            self.unchanged += 1;
            return Ok(());
        }
        let name = slashed(tidy(path));
        if old.is_none() && path.exists() || old.as_ref().is_some_and(|old| !old.starts_with(MARK))
        {
            complain(&format!(
                "{name}: not written: the file is not one that `shaderlint types` wrote"
            ));
            self.code = FAILED;
            return Ok(());
        }
        if self.args.check {
            let state = if old.is_some() {
                "not up to date"
            } else {
                "missing"
            };
            writeln!(io::stdout(), "{name}: {state}")?;
            self.code = self.code.max(FINDINGS);
            self.changed += 1;
            return Ok(());
        }
        let written = match old {
            Some(old) => replace(path, old.as_bytes(), text.as_bytes()),
            None => write(path, text.as_bytes(), Overwrite::Never),
        };
        match written {
            Ok(()) => self.changed += 1,
            Err(error) => {
                complain(&format!("{name}: cannot write the file: {error}"));
                self.code = FAILED;
            }
        }
        Ok(())
    }

    fn sum_up(&self, is_empty: bool) {
        if given().talk() < Talk::Normal || self.args.stdout {
            return;
        }
        let files = |number| count(number, "file");
        let would = match self.args.check {
            true => "not up to date",
            false => "written",
        };
        match (self.changed, self.unchanged) {
            (0, 0) if is_empty => complain("warning: no shaders found in the given paths"),
            (0, 0) => {}
            (0, n) => complain(&format!("{} up to date", files(n))),
            (n, 0) => complain(&format!("{} {would}", files(n))),
            (n, m) => complain(&format!("{} {would}, {m} up to date", files(n))),
        }
    }
}
