//! Shaders that are run: their values, what is observed, the order of evaluation, and replays.

mod evaluation_order;
mod replay;
mod results;
