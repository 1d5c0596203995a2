//! What you see: the analysis as shapes that carry the block that made them.
