//! Configuration and use of the linter, each test in its own folder: configuration, suppressions,
//! fixes, baselines, and every output format, read by a parser.

mod baselines;
mod cache;
mod commands;
mod config;
mod containers;
mod fixes;
mod formatting;
mod hosts;
mod includes;
mod kinds;
mod links;
mod marching;
mod mistakes;
mod outputs;
mod parts;
mod readme;
mod run;
mod sampling;
mod saying;
mod suppressions;
mod test_files;
mod testing;
mod unknown;
mod versions;
