//! Messages for [`RecordError`].

use crate::messages::*;

fn rule_of(record: RecordKind) -> ErrorKind {
    match record {
        RecordKind::Struct => error::INVALID_STRUCT,
        RecordKind::Block => error::INTERFACE_BLOCK,
    }
}

impl Explain for RecordError {
    fn explain(self, c: &ExplainContext, at: Extent) -> Diagnostic {
        use RecordError as E;
        let of_struct = |message: &str| c.error(error::INVALID_STRUCT, at, message);
        let of_block = |message| c.error(error::INTERFACE_BLOCK, at, message);
        match self {
            E::Empty(record) => c.error(
                rule_of(record),
                at,
                match record {
                    RecordKind::Struct => "a struct needs at least one member",
                    RecordKind::Block => "an interface block needs at least one member",
                },
            ),
            E::Inside => of_struct("a struct cannot be declared inside another struct")
                .note("embedded struct definitions are not supported (section 4.1.8)")
                .help("declare it before this struct and use its name here"),
            E::VoidMember => c.error(error::VOID_VALUE, at, "a member cannot have type `void`"),
            E::MemberTwice(name, before) => {
                of_struct(&format!("member `{}` is declared twice", c.text(name)))
                    .label(c.token_span(before), "first declared here")
            }
            E::MemberQualifier(record) => {
                let word = c.sources.text(c.span(at));
                c.error(rule_of(record), at, format!("a member cannot be `{word}`"))
            }
            E::SamplerInBlock => of_block("a sampler cannot be a member of an interface block")
                .help("declare it outside the block as a `uniform`"),
            E::BlockLater => {
                let message = "interface blocks require GLSL ES 3.00";
                c.error(error::NEEDS_WEBGL2, at, message)
            }
            E::BlockStorage => of_block("an interface block must be `uniform` in GLSL ES 3.00"),
            E::BlockInvariant => of_block("an interface block cannot be `invariant`"),
            E::BlockLocation => of_block("an interface block cannot have a location"),
            E::BlocksUnsized => of_block("an array of interface blocks needs a size"),
            E::BlockAlone => of_block("an interface block cannot be a statement")
                .help("access one of its members: `block.member`"),
        }
    }
}
