//! Answers requests.

use super::files::{MemoryFiles, options_of};
use super::requests::{CheckParams, FixRequest, FormatParams, ModuleRequest, TextInput};
use super::result::RequestResult;
use super::server::InstantServer;
use serde_json::{Value, json};
use shaderlint_commands::{Recognition, explain, print, rule_list, rule_page};
use shaderlint_detect::kind::Claim;
use shaderlint_engine::{Options, fix_text, format};
use shaderlint_host::host_named;
use shaderlint_lint::Allow;
use shaderlint_report::{Format, Reporter};
use shaderlint_text::{Content, LineIndex, apply_edits};
use std::collections::{BTreeSet, HashSet};
use std::io;
use std::sync::Arc;

/// What an instance keeps between requests.
#[derive(Default)]
pub struct Instance {
    server: InstantServer,
    #[cfg(feature = "port")]
    debugger: super::debug::ModuleDebugger,
}

impl Instance {
    /// Answers a request in JSON with `{"result": ...}` or `{"error": "message"}` in JSON.
    pub fn answer(&mut self, request: &[u8]) -> Vec<u8> {
        let answer = match self.result(request) {
            Ok(result) => json!({ "result": result }),
            Err(error) => json!({ "error": error }),
        };
        answer.to_string().into_bytes()
    }

    fn result(&mut self, request: &[u8]) -> RequestResult {
        let request = serde_json::from_slice(request).map_err(|e| format!("bad request: {e}"))?;
        match request {
            ModuleRequest::Check(request) => check(request),
            ModuleRequest::Fix(request) => fix(request),
            ModuleRequest::Format(request) => formatted(&request),
            #[cfg(feature = "port")]
            ModuleRequest::Run(request) => super::run::run(&request),
            ModuleRequest::Explain { name } => explain(&[name]).map(Value::from),
            ModuleRequest::Rules => Ok(rule_list()),
            ModuleRequest::Lsp(message) => self.server.message(message),
            ModuleRequest::RunChanged => self.server.run_changed(),
            #[cfg(feature = "port")]
            ModuleRequest::Debug(message) => Ok(self.debugger.message(&message)),
            #[cfg(feature = "port")]
            ModuleRequest::DebugIdle => Ok(self.debugger.idle()),
            #[cfg(feature = "port")]
            ModuleRequest::Port(request) => super::port::port(&request),
            #[cfg(feature = "port")]
            ModuleRequest::PlayerData(shader) => super::port::player_data(&shader),
            #[cfg(feature = "port")]
            ModuleRequest::PlayerPage => Ok(shaderlint_port::receiving_page().into()),
        }
    }
}

/// The options of a check, and the files that it may read.
fn settings(input: &TextInput, format: Format) -> Result<(Options, Arc<MemoryFiles>), String> {
    let host = input.request.host.as_deref().map(host_named).transpose()?;
    let selection = input.request.selection(host, format);
    let files = Arc::new(MemoryFiles::new(&input.files));
    let mut options = options_of(&files, &input.name, selection)?;
    options.checked = Arc::new(BTreeSet::from([input.name.clone()]));
    Ok((options, files))
}

/// `check`: the output in the requested format, and the number of findings by severity.
fn check(CheckParams { input, format }: CheckParams) -> RequestResult {
    let (options, files) = settings(&input, format)?;
    let content = Content::utf8(&input.text);
    let mut output = Vec::new();
    let mut reporter = reporter(format, &mut output);
    let recognition = reporter
        .shows_readings()
        .then_some(match input.request.host {
            Some(_) => Recognition::Never,
            None => Recognition::WhereComposed,
        });
    let given = (&*input.name, &content);
    let checked = shaderlint_commands::check(given, (&options, &*files), &[], recognition);
    if let Some(unread) = &checked.report.unread {
        return Err(format!("{}: skipped: {unread}", input.name));
    }
    let settings = Some(&*options.settings);
    let checked = (&*input.name, checked);
    let printed = print(
        &mut reporter,
        checked,
        settings,
        &mut HashSet::new(),
        |_| {},
    );
    let summary = printed.and_then(|()| reporter.finish());
    let summary = summary.map_err(|e| e.to_string())?;
    Ok(json!({
        "output": String::from_utf8_lossy(&output),
        "errors": summary.errors,
        "warnings": summary.warnings,
        "infos": summary.infos,
    }))
}

/// The reporter as the command line sets it up.
fn reporter<W: io::Write>(format: Format, out: W) -> Reporter<W> {
    let reporter = Reporter::new(format, out, false);
    reporter.with_pages(rule_page).summing_up(false)
}

/// `fix`: the fixed text, and the number of fixed findings.
fn fix(request: FixRequest) -> RequestResult {
    let FixRequest { input, is_unsafe } = request;
    let (options, files) = settings(&input, Format::Json)?;
    let allow = match is_unsafe {
        true => Allow::Unsafe,
        false => Allow::Safe,
    };
    let fixed = fix_text(&input.name, &input.text, &options, &*files, allow);
    Ok(json!({ "text": fixed.text, "fixed": fixed.applied.len() }))
}

/// `format`: the formatted text, and the parts that were left as they are.
fn formatted(request: &FormatParams) -> RequestResult {
    let FormatParams {
        name,
        text,
        request,
    } = request;
    let formatted = format(name, text, Claim::None, request.choice());
    let formatted = formatted.map_err(|decision| format!("{name}: skipped: {decision}"))?;
    let new = apply_edits(text, 0, &formatted.edits);
    let new = new.map_err(|_| format!("{name}: internal error: edits overlap"))?;
    let lines = LineIndex::new(text);
    let left = formatted.left.iter().map(|why| {
        let place = lines.position(text, why.span.start);
        json!({ "line": place.line, "column": place.column, "message": why.message })
    });
    Ok(json!({ "text": new, "unformatted": left.collect::<Vec<_>>() }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ask(method: &str, params: Value) -> Value {
        let request = json!({ "method": method, "params": params }).to_string();
        serde_json::from_slice(&Instance::default().answer(request.as_bytes())).unwrap()
    }

    const SHADER: &str =
        "void mainImage(out vec4 c, in vec2 p) {\nc = vec4(p.x * 2, 0, 0, 1);\n}\n";

    #[test]
    fn texts_are_checked_fixed_and_formatted() {
        let input = json!({ "name": "a.glsl", "text": SHADER, "format": "short" });
        let checked = ask("check", input.clone());
        let output = checked["result"]["output"].as_str().unwrap();
        assert!(
            output.starts_with("a.glsl:2:16: error[int-float-mix]"),
            "{output}"
        );
        assert_eq!(checked["result"]["errors"], 1);
        let fixed = ask("fix", json!({ "name": "a.glsl", "text": SHADER }));
        assert_eq!(fixed["result"]["text"], SHADER.replace("* 2,", "* 2.0,"));
        let formatted = ask(
            "format",
            json!({ "name": "a.glsl", "text": SHADER, "indent": 2 }),
        );
        let text = formatted["result"]["text"].as_str().unwrap();
        assert!(text.contains("{\n  c = vec4"), "{text}");
    }

    #[test]
    fn invalid_requests_get_a_message() {
        let of = |answer: Value| answer["error"].as_str().unwrap().to_string();
        assert!(of(ask("chekc", json!({}))).starts_with("bad request: unknown variant `chekc`"));
        assert!(of(ask("explain", json!({ "name": "sqrt-nagative" }))).contains("sqrt-negative"));
        let unknown = json!({ "name": "a.glsl", "text": "", "select": ["nope"] });
        assert_eq!(
            of(ask("check", unknown)),
            "unknown rule or group `nope`; did you mean `look`?"
        );
        assert_eq!(
            of(ask("check", json!({ "name": "a.txt", "text": "hello" }))),
            "a.txt: skipped: neither the extension nor the content indicates GLSL"
        );
    }
}
