//! The image of a controller's digital inputs or outputs.

/// Up to 32 two-state lines, numbered from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DigitalImage(pub u32);

impl DigitalImage {
    /// Whether line `number` is on; one beyond 31 never is.
    pub fn get(self, number: u8) -> bool {
        self.0 & bit(number) != 0
    }

    /// Switches line `number`; one beyond 31 is ignored.
    pub fn set(&mut self, number: u8, on: bool) {
        if on {
            self.0 |= bit(number);
        } else {
            self.0 &= !bit(number);
        }
    }

    /// Lines 0 to 7, line 0 in bit 0.
    pub fn low_byte(self) -> u8 {
        self.0.to_le_bytes()[0]
    }

    /// Switches lines 0 to 7 together.
    pub fn set_low_byte(&mut self, byte: u8) {
        self.0 = self.0 & !0xFF | u32::from(byte);
    }
}

fn bit(number: u8) -> u32 {
    1u32.checked_shl(u32::from(number)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_bytes_are_one_image() {
        let mut image = DigitalImage::default();
        image.set(9, true);
        image.set(0, true);
        image.set_low_byte(0b1000_0010);
        assert_eq!(
            (image.get(0), image.get(1), image.get(7), image.get(9)),
            (false, true, true, true)
        );
        image.set(1, false);
        assert_eq!(image.low_byte(), 0x80);
        image.set(40, true);
        assert!(!image.get(40));
    }
}
