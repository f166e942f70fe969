//! What built-in functions compute, eight lanes at a time.
