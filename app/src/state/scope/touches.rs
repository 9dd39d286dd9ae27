//! Fingers, or one mouse, on the picture: moved together they pan, moved apart they zoom.

/// Where the fingers are, by the numbers that the browser gives them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Touches(Vec<(i32, f64)>);

/// What a movement asks for. Places are parts of the picture's width from its left edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moved {
    /// The picture goes to the right by this.
    pub pan: f64,
    /// Then it shows this many times as much time ...
    pub zoom: f64,
    /// ... around this place.
    pub place: f64,
}

/// Fingers nearer to each other than this do not zoom.
const LEAST: f64 = 0.02;

impl Touches {
    /// A finger comes; a third is not counted.
    pub fn down(&mut self, finger: i32, place: f64) {
        self.up(finger);
        if self.0.len() < 2 {
            self.0.push((finger, place));
        }
    }

    /// A finger goes.
    pub fn up(&mut self, finger: i32) {
        self.0.retain(|(other, _)| *other != finger);
    }

    /// A finger moves; `None` if it was not down.
    pub fn moved(&mut self, finger: i32, to: f64) -> Option<Moved> {
        let index = self.0.iter().position(|(other, _)| *other == finger)?;
        let from = std::mem::replace(&mut self.0[index].1, to);
        let Some(&(_, other)) = self.0.get(1 - index) else {
            return Some(Moved {
                pan: from - to,
                zoom: 1.0,
                place: to,
            });
        };
        let (before, after) = ((from - other).abs(), (to - other).abs());
        Some(Moved {
            pan: (from - to) / 2.0,
            zoom: before.max(LEAST) / after.max(LEAST),
            place: (to + other) / 2.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_finger_pans() {
        let mut touches = Touches::default();
        assert_eq!(touches.moved(1, 0.5), None);
        touches.down(1, 0.5);
        assert_eq!(touches.moved(1, 0.25).unwrap().pan, 0.25);
        assert_eq!(touches.moved(1, 0.25).unwrap().pan, 0.0);
        touches.up(1);
        assert_eq!(touches.moved(1, 0.5), None);
    }

    #[test]
    fn two_fingers_apart_zoom_in_between_them() {
        let mut touches = Touches::default();
        touches.down(1, 0.4);
        touches.down(2, 0.6);
        touches.down(3, 0.0);
        let moved = touches.moved(2, 0.8).unwrap();
        assert!((moved.zoom - 0.5).abs() < 1e-9 && (moved.place - 0.6).abs() < 1e-9);
        assert!(touches.moved(2, 0.4).unwrap().zoom.is_finite());
        assert_eq!(touches.moved(3, 0.1), None);
    }
}
