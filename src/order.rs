//! Putting lists in order, with little code: one merge sort for all of them, a fifth of the library's.
//!
//! In: a list, and what its order is by. Out: the list in that order; what is equal stays as it was. For lists
//! that are sorted seldom: where one is sorted again and again, the library's own is quicker.

use std::cmp::Ordering;

/// Puts a list in the order of a key.
pub fn by_key<T, K: Ord>(list: &mut [T], key: impl Fn(&T) -> K) {
    by(list, |one, other| key(one).cmp(&key(other)));
}

/// Puts a list in the order that a comparison says.
pub fn by<T>(list: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if list.is_sorted_by(|one, other| compare(one, other).is_le()) {
        return;
    }
    let mut order = sorted(list.len(), &|one, other| compare(&list[one], &list[other]));
    // Each circle of places is walked once: what belongs here is brought here, until it is the first.
    for start in 0..order.len() {
        let mut here = start;
        while order[here] as usize != start {
            let next = order[here] as usize;
            list.swap(here, next);
            order[here] = here as u32;
            here = next;
        }
        order[here] = here as u32;
    }
}

/// A map or a set of what comes, one after the other. `collect` sorts it all first, which is 3 kB of code for each type.
pub fn gathered<All: Default + Extend<T>, T>(items: impl IntoIterator<Item = T>) -> All {
    let mut all = All::default();
    all.extend(items);
    all
}

/// The indices of a list in the order that a comparison of two of them says: stretches that are in order are merged,
/// two at a time.
#[inline(never)]
fn sorted(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    let mut merged = Vec::with_capacity(count);
    let mut ends: Vec<usize> =
        (1..=count).filter(|&end| end == count || compare(end - 1, end) == Ordering::Greater).collect();
    while ends.len() > 1 {
        let mut first = 0;
        for pair in ends.chunks(2) {
            let (middle, end) = (pair[0], pair[pair.len() - 1]);
            let (mut one, mut other) = (first, middle);
            while one < middle || other < end {
                let is_one = other == end
                    || one < middle
                        && compare(order[one] as usize, order[other] as usize) != Ordering::Greater;
                let next = if is_one { &mut one } else { &mut other };
                merged.push(order[*next]);
                *next += 1;
            }
            first = end;
        }
        std::mem::swap(&mut order, &mut merged);
        merged.clear();
        ends = ends.chunks(2).map(|pair| pair[pair.len() - 1]).collect();
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_sorted_as_the_library_sorts_it() {
        let mut random = 1_u64;
        let mut next = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 40) as u32
        };
        for round in 0..1_000 {
            // Few keys: what is equal stays in its order.
            let list: Vec<(u32, usize)> =
                (0..next() as usize % 40).map(|at| (next() % (1 + round % 50), at)).collect();
            let (mut own, mut expected) = (list.clone(), list);
            by_key(&mut own, |one| one.0);
            expected.sort_by_key(|one| one.0);
            assert_eq!(own, expected);
        }
    }
}
