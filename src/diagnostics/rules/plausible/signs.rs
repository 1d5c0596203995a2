//! Lost minus signs: a Z that cuts away from the chuck.

use super::*;

impl Program<'_> {
    /// `Z-8`, `Z18`, `Z-24`: a Z without its minus in a row that goes one way with it.
    pub(super) fn lost_minus_in_row(&self) -> Vec<Diagnostic> {
        let mut told = Vec::new();
        for (before, word, behind) in self.neighbours(b"ZW") {
            let row = &self.rows[word.block];
            let Some(before) = before else { continue };
            if word.address != b'Z'
                || word.negative
                || word.value <= 0.0
                || row.rapid
                || before.address != b'Z'
            {
                continue;
            }
            let meant = -word.value;
            let flagged =
                match behind.filter(|behind| behind.address == b'Z' && !self.rows[behind.block].rapid) {
                    // Between its neighbours with the minus, and the next one lies at −Z.
                    Some(behind) => {
                        let (low, high) = (before.value.min(behind.value), before.value.max(behind.value));
                        behind.negative && low <= meant && meant <= high && word.value > before.value + 0.001
                    }
                    // A contour leads into the work, and so does an arc.
                    None if row.contour && before.value >= 0.0 && !self.rows[before.block].contour => {
                        word.value > before.value + 0.001
                    }
                    None if row.arc && before.value.abs() < 0.001 => true,
                    // The last of a row that went on that way: no retreat goes so far.
                    None => {
                        let near = word.value <= 3.0 * before.value.abs() && word.value * self.unit >= 5.0;
                        before.negative && meant < before.value && near && !self.rows[before.block].rapid
                    }
                };
            if flagged {
                told.push(self.minus(word));
            }
        }
        told
    }

    pub(super) fn minus(&self, word: &Word) -> Diagnostic {
        let written = self.quote(word);
        let meant = format!("Z-{}", written[1..].trim_start_matches([' ', '+']));
        let fix = Fix::write(word.span, meant.clone());
        Diagnostic::new(Message::MinusMissing { word: written, meant }, word.span).with(fix)
    }

    /// The Z at which cuts begin behind a rapid: in front of the work.
    pub(super) fn approach(&self) -> Option<f64> {
        let mut front: Option<f64> = None;
        let mut last = MotionKind::Rapid;
        for index in 0..self.motions.len() {
            let motion = self.motions.get(index);
            if motion.kind == MotionKind::Dwell {
                continue;
            }
            if motion.kind.cuts() && last == MotionKind::Rapid {
                front = Some(front.map_or(motion.from.z, |front| front.max(motion.from.z)));
            }
            last = motion.kind;
        }
        front
    }

    /// A cut that leads away from the chuck, in front of the work: `Z20` for `Z-20`.
    pub(super) fn lost_minus(&self) -> Vec<Diagnostic> {
        let mut told = Vec::new();
        let Some(front) = self.approach() else { return Vec::new() };
        // Which tools cut toward the chuck: one that never does works on the other side.
        let mut inward: BTreeMap<u16, usize> = BTreeMap::new();
        for index in 0..self.motions.len() {
            let motion = self.motions.get(index);
            if motion.kind.cuts() && motion.to.z < motion.from.z && motion.to.z < 0.0 {
                *inward.entry(motion.process.tool.0).or_default() += 1;
            }
        }
        let mut outward: BTreeMap<u16, usize> = BTreeMap::new();
        for row in self.rows.iter().filter(|row| row.role != Role::Other) {
            let Some(word) = self.words_of(row).iter().find(|word| word.address == b'Z') else { continue };
            let Some((from, to)) = row.motions else { continue };
            let place = word.value * self.unit;
            if word.negative || place <= 0.0 || !self.leads_away(from, to, place, front) {
                continue;
            }
            let tool = self.motions.get(from).process.tool.0;
            *outward.entry(tool).or_default() += 1;
            told.push((tool, self.minus(word)));
        }
        let works_outward = |tool: &u16| outward[tool] > 1 && !inward.contains_key(tool);
        told.into_iter().filter(|(tool, _)| !works_outward(tool)).map(|(_, told)| told).collect()
    }

    /// Whether the motions of a block cut toward +Z to `place`, in front of the work, where cuts begin at `front`.
    pub(super) fn leads_away(&self, from: usize, to: usize, place: f64, front: f64) -> bool {
        // A corner takes off a little at the end.
        let reaches = |z: f64| (place - CORNER..=place + 0.001).contains(&z);
        let goes_there = |motion: &Motion| reaches(motion.to.z) && motion.to.z > motion.from.z + 0.001;
        let leaves = |motion: &Motion| {
            motion.cycle.is_some_and(|tag| matches!(tag.step, Step::Retract | Step::Return))
        };
        let mut motions = (from..to).map(|index| self.motions.get(index));
        let first = self.motions.get(from);
        if first.rotary.is_some() || first.virtual_move().is_some() {
            return false;
        }
        if first.cycle.is_some() {
            // The infeed of G94 leads to its Z.
            let infeed = |motion: &Motion| motion.cycle.is_some_and(|tag| tag.step == Step::Infeed);
            let away = |motion: &Motion| {
                goes_there(motion) && !leaves(motion) && (motion.kind.cuts() || infeed(motion))
            };
            return first.from.z >= -0.001 && motions.any(|motion| away(&motion));
        }
        let Some(cut) = motions.find(|motion| motion.kind.cuts() && goes_there(motion)) else { return false };
        let next = (to < self.motions.len()).then(|| self.motions.get(to));
        let goes_on = next.is_some_and(|next| next.kind.cuts());
        // Who leaves at feed goes a little way; who cuts on there cuts air.
        place - cut.from.z.max(front) > if goes_on { 3.0 } else { 10.0 }
    }
}
