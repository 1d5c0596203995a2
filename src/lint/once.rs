//! A flag for remarks that are made once, until they are allowed again.

/// Whether a remark was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Once(bool);

impl Once {
    /// Whether the remark must be made now. Later calls return false.
    pub fn first(&mut self) -> bool {
        !std::mem::replace(&mut self.0, true)
    }

    /// Suppresses the remark.
    pub fn leave_out(&mut self) {
        self.0 = true;
    }

    /// Allows the remark again.
    pub fn forget(&mut self) {
        self.0 = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_remark_is_made_once_until_it_is_forgotten() {
        let mut once = Once::default();
        assert!(once.first() && !once.first());
        once.forget();
        assert!(once.first());
        let mut left_out = Once::default();
        left_out.leave_out();
        assert!(!left_out.first());
    }
}
