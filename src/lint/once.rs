//! A flag for remarks that are made once, until they are allowed again.

/// Whether a remark was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Once(bool);

impl Once {
    /// Whether the remark must be made now. Later calls return false.
    pub fn mark_reported(&mut self) -> bool {
        !std::mem::replace(&mut self.0, true)
    }

    /// Suppresses the remark.
    pub fn suppress(&mut self) {
        self.0 = true;
    }

    /// Allows the remark again.
    pub fn reset(&mut self) {
        self.0 = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_remark_is_made_once_until_it_is_forgotten() {
        let mut once = Once::default();
        assert!(once.mark_reported() && !once.mark_reported());
        once.reset();
        assert!(once.mark_reported());
        let mut left_out = Once::default();
        left_out.suppress();
        assert!(!left_out.mark_reported());
    }
}
