//! What projects are read from: exports of ShaderToy, a file per pass, a single shader; and the
//! inputs of channels that the user gives or that are missing.

pub(super) mod assumed;
pub(super) mod channel;
pub(super) mod export;
pub(super) mod parts;
pub(super) mod single;
pub(super) mod supply;
