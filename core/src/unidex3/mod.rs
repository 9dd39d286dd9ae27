//! The Aerotech Unidex IIIa: a two-axis indexer that is programmed in RS-274.

pub mod indexer;
