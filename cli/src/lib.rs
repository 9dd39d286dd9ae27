//! What the runner shares with the browser: the measured programs of `motionbench speed`.
