//! All integration tests, in one executable: it is linked once, and its tests share the machine.

mod cli;
mod corpus;
mod debugging;
mod differential;
mod embed;
mod formatting;
mod gallery;
mod hostile;
mod media;
mod naga;
mod offers;
mod opening;
mod other_languages;
mod pages;
mod port;
mod properties;
mod recorded;
mod renaming;
mod repair;
mod scratch;
mod tidy;
mod tracing;
mod usage;
mod verdicts;
mod words;
mod written_hosts;
