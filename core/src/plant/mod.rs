//! What the controllers move: motors with their drives' current loops, loads, friction, encoders and switches.

pub mod axis;
pub mod configure;
pub mod encoder;
pub mod presets;

pub use axis::{AxisParameters, PlantAxis, Span};
pub use encoder::Encoder;
