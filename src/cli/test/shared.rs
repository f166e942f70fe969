//! What all files of a run share.

use super::super::disk::Disk;
use super::args::TestArgs;
use super::textures::Textures;
use crate::engine::config::Configs;
use std::collections::BTreeSet;
use std::sync::Arc;

/// What all files of a run share.
pub struct TestRun<'a> {
    pub args: &'a TestArgs,
    pub configs: &'a Configs,
    /// The names of all inputs.
    pub checked: Arc<BTreeSet<String>>,
    pub disk: Disk,
    pub textures: Textures,
    /// Number of threads that draw one image.
    pub threads: usize,
}
