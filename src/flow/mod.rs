//! What a shader does, asked of its middle form: each analysis is a short file, made once when it is
//! asked for and never changed.
