//! A shader as a page that plays it.

use super::buffers::TextBuffer;
use super::snapshot::{Answer, Failure, Snapshot};
use crate::engine::Files;
use crate::port::{PassFile, PassRole, Project, add_stand_ins, html};
use crate::semantic::Pass;
use std::path::Path;

/// The page of a text, with the passes beside it.
pub fn page(snapshot: &Snapshot, buffer: &TextBuffer) -> Answer<String> {
    let mut project = project(snapshot, buffer)?;
    let wrong = |error: crate::port::ShaderError| Failure::refused(error.to_string());
    let composed = project.resolve(&buffer.path).map_err(wrong)?;
    let draws = |kind: Pass| matches!(kind, Pass::Image | Pass::Cubemap | Pass::Sound);
    if !project.passes.iter().any(|pass| draws(pass.kind)) {
        return Err(Failure::refused("there is nothing that draws"));
    }
    add_stand_ins(&mut project);
    let composed = project.renew(composed, &buffer.path).map_err(wrong)?;
    Ok(html(&project, &composed, None))
}

fn project(snapshot: &Snapshot, buffer: &TextBuffer) -> Answer<Project> {
    let name = buffer.path.rsplit('/').next().unwrap_or("shader");
    if name.ends_with(".json") {
        return Project::from_json(&buffer.text).map_err(|e| Failure::refused(e.to_string()));
    }
    let parts = parts(snapshot, buffer);
    let has_image = parts.iter().any(|part| part.role == PassRole::Image);
    if parts.len() > 1 && has_image {
        let title = Path::new(&buffer.path).parent().and_then(|p| p.file_name());
        let title = title.map_or("shader".into(), |t| t.to_string_lossy());
        return Project::from_parts(&title, parts).map_err(|e| Failure::refused(e.to_string()));
    }
    let title = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    Project::from_shader(title, &buffer.text).map_err(|e| Failure::refused(e.to_string()))
}

/// The passes in the folder of a text that is called like one.
fn parts(snapshot: &Snapshot, buffer: &TextBuffer) -> Vec<PassFile> {
    let own = Path::new(&buffer.path);
    let (Some(folder), Some(name)) = (own.parent(), own.file_name()) else {
        return Vec::new();
    };
    if role_of(&name.to_string_lossy()).is_none() {
        return Vec::new();
    }
    let mut names = snapshot.files.names(folder);
    names.sort_unstable();
    let part = names.into_iter().filter_map(|name| {
        let role = role_of(&name)?;
        let code = snapshot.files.load(&folder.join(&name)).ok()?;
        Some(PassFile {
            role,
            file: name,
            code,
        })
    });
    part.collect()
}

/// What a file is for, by its name.
fn role_of(name: &str) -> Option<PassRole> {
    let (stem, ending) = name.rsplit_once('.')?;
    let is_shader = matches!(ending, "glsl" | "frag" | "fs" | "shadertoy");
    PassRole::of_name(stem).filter(|_| is_shader)
}
