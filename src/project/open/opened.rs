//! An opened project: passes, and what files beside them say.

use super::channels::{GivenOrder, channel_file, orders_of};
use crate::access::FileAccess;
use crate::include::gathered::GatheredText;
use crate::{
    ChannelOrder, ChannelSource, MissingInclude, Project, ProjectPass, ShaderError, SiblingTexts,
};
use shaderlint_host::Preset;
use shaderlint_text::path::slashed;
use std::path::{Path, PathBuf};

/// An opened project, before its channels are resolved.
pub struct OpenedProject {
    /// The project. Its notes say what was guessed.
    pub project: Project,
    /// The shader that it was made from; `None` for exports and for passes in several files.
    pub single: Option<SingleShader>,
    /// The other files that it was read from.
    pub read: Vec<PathBuf>,
    /// The file or folder whose file of orders applies; `None` for passes named one by one.
    pub place: Option<PathBuf>,
    /// What files beside it say about its channels.
    pub orders: Vec<GivenOrder>,
}

impl OpenedProject {
    /// A project that was not read from files.
    pub fn of(project: Project) -> OpenedProject {
        OpenedProject {
            project,
            single: None,
            read: Vec::new(),
            place: None,
            orders: Vec::new(),
        }
    }

    /// Adds the orders in the file for a place.
    pub(super) fn placed(
        mut self,
        place: &Path,
        access: FileAccess,
    ) -> Result<OpenedProject, String> {
        let file = channel_file(place, access.files);
        if access.files.entry(&file).is_some() {
            self.orders = orders_of(&file, access.files)?;
            self.project.is_connected = true;
            self.read.push(file);
        }
        self.place = Some(place.to_path_buf());
        Ok(self)
    }

    /// Adds what is known from gathering a text.
    pub(super) fn gathered(&mut self, text: &GatheredText) {
        self.read.extend(text.read.iter().cloned());
        let is_file = |missing: &&MissingInclude| missing.path.contains(['.', '/']);
        for missing in text.missing.iter().filter(is_file) {
            let note = missing.to_string();
            if !self.project.notes.contains(&note) {
                self.project.notes.push(note);
            }
        }
    }

    /// What of a place was opened, in words: the passes with their files, and the other files that
    /// were read. Guesses are in the notes of the project.
    pub fn evidence(&self) -> Vec<String> {
        let passes = self.project.passes.iter();
        let of_file = |pass: &ProjectPass| {
            let file = pass.file.as_ref().map(|file| format!(" ({file})"));
            format!("{}{}", pass.slug(), file.unwrap_or_default())
        };
        let of_files: Vec<&str> = passes.clone().filter_map(|p| p.file.as_deref()).collect();
        let mut read: Vec<String> = self.read.iter().map(slashed).collect();
        read.sort();
        read.dedup();
        read.retain(|path| !of_files.contains(&path.as_str()));
        let several = (passes.len() > 1).then(|| passes.map(of_file).collect::<Vec<_>>());
        let lines = [("passes", several), ("also read", Some(read))].into_iter();
        let evidence = lines.filter_map(|(what, all)| {
            let all = all.filter(|all| !all.is_empty())?;
            Some(format!("{what}: {}", all.join(", ")))
        });
        evidence.collect()
    }

    /// Adds the orders of the user, which take precedence over those of files. A single shader that
    /// reads itself becomes a buffer.
    ///
    /// # Errors
    /// If one is not an order, or not of such a shader.
    pub fn order(&mut self, channels: &[String]) -> Result<(), String> {
        for text in channels {
            let by = "--channel".to_string();
            let order = ChannelOrder::read(text).map_err(|e| format!("{by}: {e}"))?;
            self.orders.push(GivenOrder { by, order });
        }
        let reads_itself = |given: &GivenOrder| given.order.source == ChannelSource::Itself;
        let own: Vec<GivenOrder> = self.orders.extract_if(.., |o| reads_itself(o)).collect();
        let Some(first) = own.first() else {
            return Ok(());
        };
        let single = self.single.as_ref().filter(|_| self.project.host.is_none());
        let Some(single) = single else {
            let how = "only a single shader reads itself; name the pass: `buffer_a.0=buffer_a`";
            return Err(format!("{}: {how}", first.by));
        };
        let mut text = single.text.text.to_string();
        for GivenOrder { by, order } in &own {
            let Some(number) = order.channel.number() else {
                return Err(format!(
                    "{by}: expected a channel from 0 to 3 before `=self`"
                ));
            };
            text.push_str(&format!("\n#iChannel{number} \"self\""));
        }
        let drafted = single.draft(&text).map_err(|e| e.to_string())?;
        // The comment that makes it a buffer is not the user's.
        self.project = Project {
            notes: std::mem::take(&mut self.project.notes),
            recognised: None,
            ..drafted
        };
        Ok(())
    }
}

/// A shader that was opened alone.
pub struct SingleShader {
    /// Its text with what it includes.
    pub text: GatheredText,
    pub(super) title: String,
    pub(super) host: Option<&'static Preset>,
    /// The hosts of the program around it; empty if its text shows its host.
    pub(super) around: Vec<&'static Preset>,
    pub(super) siblings: SiblingTexts,
}

impl SingleShader {
    /// The project of another version of the text.
    ///
    /// # Errors
    /// If the text shows that it cannot be ported.
    pub fn draft(&self, text: &str) -> Result<Project, ShaderError> {
        let own = &*self.text.text;
        let is_similar = text.starts_with(own) || text.lines().count() == own.lines().count();
        let mut text = GatheredText::of(text);
        if is_similar {
            text.pieces.clone_from(&self.text.pieces);
        }
        Project::draft_with_siblings(
            &self.title,
            &text,
            (self.host, &|| self.around.clone()),
            &self.siblings,
        )
    }
}
