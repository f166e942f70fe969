//! The linter as people set it up and use it, each time in a folder of its own: configuration,
//! suppressions, fixes, baselines, and every output format read by a parser.

mod baselines;
mod commands;
mod config;
mod fixes;
mod formatting;
mod hosts;
mod includes;
mod kinds;
mod links;
mod outputs;
mod parts;
mod readme;
mod run;
mod saying;
mod scratch;
mod suppressions;
mod testing;
mod trials;
mod unknown;
