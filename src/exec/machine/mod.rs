//! Runs register code.
