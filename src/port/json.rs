//! Writes a project as a ShaderToy export.
//!
//! Ids are those of exports, inputs are sorted by channel, sampler settings are normalised, and
//! media are embedded. [`Project::from_json`] reads it back.

use super::{Input, Project, ProjectPass};
use serde_json::{Map, Value, json};
use shaderlint_semantic::Pass;

/// The project as JSON.
pub fn json(project: &Project) -> String {
    let info = &project.info;
    let passes: Vec<Value> = project
        .passes
        .iter()
        .enumerate()
        .map(|(i, p)| pass(p, i))
        .collect();
    let value = json!({
        "ver": "0.1",
        "info": {
            "id": info.id,
            "name": info.name,
            "username": info.author,
            "description": info.description,
            "tags": info.tags,
        },
        "renderpass": passes,
    });
    // Serialisation fails only for maps with keys that are not strings, and for failing writers.
    serde_json::to_string_pretty(&value).unwrap_or_default() + "\n"
}

fn pass(pass: &ProjectPass, index: usize) -> Value {
    let kind = match pass.kind {
        Pass::Image => "image",
        Pass::Buffer => "buffer",
        Pass::Cubemap => "cubemap",
        Pass::Sound => "sound",
        Pass::Common => "common",
    };
    let mut inputs: Vec<&Input> = pass.inputs.iter().collect();
    inputs.sort_by_key(|i| i.channel);
    let outputs: Vec<Value> = pass
        .output
        .iter()
        .map(|o| json!({"id": o.0, "channel": 0}))
        .collect();
    json!({
        "inputs": inputs.into_iter().map(input).collect::<Vec<_>>(),
        "outputs": outputs,
        "code": &*pass.code,
        "name": pass.title(index),
        "description": "",
        "type": kind,
    })
}

fn input(input: &Input) -> Value {
    let sampler = &input.sampler;
    let filter = match sampler.filter.as_str() {
        word @ ("linear" | "mipmap") => word,
        _ => "nearest",
    };
    let wrap = if sampler.wrap == "clamp" {
        "clamp"
    } else {
        "repeat"
    };
    let mut map = Map::new();
    map.insert("id".to_string(), json!(input.id));
    map.insert("filepath".to_string(), json!(input.src));
    map.insert("type".to_string(), json!(input.kind.word()));
    map.insert("channel".to_string(), json!(input.channel));
    map.insert(
        "sampler".to_string(),
        json!({"filter": filter, "wrap": wrap, "vflip": sampler.vflip.to_string()}),
    );
    if !input.urls.is_empty() {
        map.insert("name".to_string(), json!(input.name));
        map.insert("data".to_string(), json!(input.urls));
    }
    Value::Object(map)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn written_exports_are_read_back() {
        let text = r#"{"Shader":{"info":{"id":"abcd","name":"n"},"renderpass":[
            {"type":"image","code":"x","outputs":[{"id":37}],"inputs":[
              {"id":257,"ctype":"buffer","channel":1,"sampler":{"filter":"odd","wrap":"clamp"}},
              {"id":1,"ctype":"texture","channel":0,"src":"data:image/png;base64,AA","sampler":{}}]},
            {"type":"buffer","code":"y","name":"Buf A","outputs":[{"id":257}]}]}}"#;
        let project = Project::from_json(text).unwrap();
        let first = json(&project);
        let again = Project::from_json(&first).unwrap();
        assert_eq!(json(&again), first);
        assert_eq!(again.passes[0].inputs[0].urls.len(), 1);
        assert_eq!(again.passes[1].slug(), "buffer_a");
    }
}
