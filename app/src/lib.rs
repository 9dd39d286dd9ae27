//! The page, and the worker that owns the bench.
