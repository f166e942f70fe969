//! Connects the buffers of a folder of passes that nothing says how to connect.

use crate::{Input, InputKind, Project, SamplerSettings};
use shaderlint_semantic::Pass;

impl Project {
    /// If no channel reads the only buffer of passes in files, it is put on the first channel that
    /// the Image reads, and on that of the buffer itself: so it is in most exports. A note says so.
    /// Several buffers that no pass reads are named.
    pub(super) fn guess_buffers(&mut self) {
        let is_of_files = self.passes.iter().all(|pass| pass.file.is_some());
        let mut inputs = self.passes.iter().flat_map(|pass| &pass.inputs);
        let is_read = inputs.any(|input| input.kind == InputKind::Buffer);
        if !is_of_files || self.is_connected || is_read {
            return;
        }
        let buffers = self.passes.iter().filter(|pass| pass.kind == Pass::Buffer);
        let ids: Vec<(&'static str, String)> = buffers
            .filter_map(|pass| Some((pass.slug(), pass.output.clone()?.0)))
            .collect();
        if ids.len() > 1 {
            let unread: Vec<_> = ids.iter().map(|(name, _)| format!("`{name}`")).collect();
            let unread = unread.join(", ");
            let how = "connect buffers with `--channel image.0=buffer_a`, or in `channels.toml`";
            self.notes.push(format!("no pass reads {unread}; {how}"));
            return;
        }
        let Some((name, id)) = ids.into_iter().next() else {
            return;
        };
        let mut guesses = Vec::new();
        for pass in &mut self.passes {
            let slug = pass.slug();
            let is_reader = matches!(pass.kind, Pass::Image | Pass::Buffer);
            let free = pass
                .inputs
                .iter_mut()
                .filter(|i| is_reader && !i.is_given && i.kind == InputKind::Texture);
            if let Some(input) = free.min_by_key(|input| input.channel) {
                guesses.push(format!("{slug}.{} = {name}", input.channel));
                *input = Input {
                    id: id.clone(),
                    uniform: input.uniform.clone(),
                    sampler: SamplerSettings::usual(InputKind::Buffer),
                    ..Input::empty(input.channel, InputKind::Buffer)
                };
            }
        }
        if !guesses.is_empty() {
            self.notes
                .push(format!("{} (the only buffer)", guesses.join(", ")));
        }
    }
}
