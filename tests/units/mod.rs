//! Layers by what they make public: short texts in, answers out.

mod causes;
mod editor;
mod formatter;
mod linking;
mod scripts;
mod versions;
