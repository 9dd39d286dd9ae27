//! The two axes.

/// One of the two axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
}

impl Axis {
    /// Both, in order.
    pub const BOTH: [Axis; 2] = [Axis::X, Axis::Y];

    /// From the name in signals and scenarios: `x` or `0`, `y` or `1`.
    pub fn from_name(name: &str) -> Option<Axis> {
        match name {
            "x" | "0" => Some(Axis::X),
            "y" | "1" => Some(Axis::Y),
            _ => None,
        }
    }
}

/// One of something for each axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Pair<T> {
    /// Of the X axis.
    pub x: T,
    /// Of the Y axis.
    pub y: T,
}

impl<T> Pair<T> {
    /// Of `axis`.
    pub fn of(&self, axis: Axis) -> &T {
        match axis {
            Axis::X => &self.x,
            Axis::Y => &self.y,
        }
    }

    /// Of `axis`, to be changed.
    pub fn of_mut(&mut self, axis: Axis) -> &mut T {
        match axis {
            Axis::X => &mut self.x,
            Axis::Y => &mut self.y,
        }
    }

    /// Both, each made into something else.
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Pair<U> {
        Pair {
            x: f(self.x),
            y: f(self.y),
        }
    }
}

impl<T: Copy> Pair<T> {
    /// The same for both.
    pub const fn same(value: T) -> Pair<T> {
        Pair { x: value, y: value }
    }
}
