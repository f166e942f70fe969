//! Whole shaders of no known dialect: whatever a page, an engine or a tutorial declares.

use super::complete::completions_of;
use super::{Clues, DialectFacts, Plan};

pub(super) static FACTS: DialectFacts = DialectFacts {
    name: "webgl",
    title: "a whole shader",
    feeds: &[],
    textures: &[],
    varyings: &[],
    declares: false,
    signs: |_| Vec::new(),
    plan: Some(plan),
};

fn plan(clues: &Clues) -> Plan {
    Plan::picture(completions_of(clues))
}
