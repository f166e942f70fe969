//! Layers by what they make public: short texts in, answers out.

mod bound;
mod causes;
mod dialects;
mod editor;
mod entries;
mod evaluation;
mod exec;
mod formatter;
mod inactive;
mod kinds;
mod linking;
mod playback;
mod refactoring;
mod scripts;
mod sections;
mod std140;
mod versions;
