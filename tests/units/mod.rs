//! Layers by what they make public: short texts in, answers out.

mod editor;
mod formatter;
mod linking;
