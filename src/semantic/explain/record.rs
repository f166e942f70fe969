//! What is wrong with structs and interface blocks.

use super::*;

impl Record {
    fn rule(self) -> ErrorKind {
        match self {
            Record::Struct => error::INVALID_STRUCT,
            Record::Block => error::INTERFACE_BLOCK,
        }
    }
}

impl Explain for RecordError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use RecordError as E;
        let of_struct = |message: &str| c.error(error::INVALID_STRUCT, at, message);
        let of_block = |message| c.error(error::INTERFACE_BLOCK, at, message);
        match self {
            E::Empty(record) => c.error(
                record.rule(),
                at,
                "this has no members; it needs at least one",
            ),
            E::Inside => of_struct("a struct cannot be declared inside another")
                .note("declare it before, and use its name here (section 4.1.8)"),
            E::VoidMember => c.error(error::VOID_VALUE, at, "a member cannot be `void`"),
            E::MemberTwice(name, before) => {
                of_struct(&format!("member `{}` is declared twice", c.text(name)))
                    .label(c.token_span(before), "first declared here")
            }
            E::MemberQualifier(record) => {
                let word = c.sources.text(c.span(at));
                c.error(record.rule(), at, format!("a member cannot be `{word}`"))
            }
            E::SamplerInBlock => of_block("a sampler cannot stand in a block")
                .help("declare it outside, as a `uniform` of its own"),
            E::BlockLater => c.error(error::NEEDS_WEBGL2, at, "blocks come with GLSL ES 3.00"),
            E::BlockStorage => of_block("a block must be `uniform` in GLSL ES 3.00"),
            E::BlockInvariant => of_block("a block cannot be `invariant`"),
            E::BlockLocation => of_block("a block has no location"),
            E::BlocksUnsized => of_block("an array of blocks needs a size"),
            E::BlockAlone => of_block("a block cannot stand alone as a statement")
                .help("name one of its members: `block.member`"),
        }
    }
}
