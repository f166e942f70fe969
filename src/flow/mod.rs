//! What a shader does, asked of its middle form: each analysis is a short file, made once when it is
//! asked for and never changed.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::string_slice
    )
)]
