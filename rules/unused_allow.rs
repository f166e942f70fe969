//! `// shaderlint: allow(...)` comments without a finding to suppress.

// Reports the comments that `suppress` of the lint layer found to be unused.
rule! { unused_allow, Tidy, Warning, Recommended, Allows }
