//! Sorting with little code: one merge sort for all types, a fifth of the size of the standard library's.
//!
//! In: a list and a key or comparison. Out: the list, sorted stably. For lists that are sorted rarely; for
//! frequent sorting the standard library is faster.

use std::cmp::Ordering;

/// Sorts a list by a key.
pub fn by_key<T, K: Ord>(list: &mut [T], key: impl Fn(&T) -> K) {
    by(list, |one, other| key(one).cmp(&key(other)));
}

/// Sorts a list by a comparison function.
pub fn by<T>(list: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if list.is_sorted_by(|one, other| compare(one, other).is_le()) {
        return;
    }
    let mut order = sorted(list.len(), &|one, other| compare(&list[one], &list[other]));
    // Apply the permutation cycle by cycle: move each element to its place until the cycle closes.
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

/// Collects items into a map or a set, one after the other. `collect` sorts them first, which takes 3 kB of
/// code for each type.
pub fn gathered<All: Default + Extend<T>, T>(items: impl IntoIterator<Item = T>) -> All {
    let mut all = All::default();
    all.extend(items);
    all
}

/// The sorted indices of a list, by a comparison of two indices. Merges the runs that are already in order,
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
            // Few distinct keys, to test that equal elements keep their order.
            let list: Vec<(u32, usize)> =
                (0..next() as usize % 40).map(|at| (next() % (1 + round % 50), at)).collect();
            let (mut own, mut expected) = (list.clone(), list);
            by_key(&mut own, |one| one.0);
            expected.sort_by_key(|one| one.0);
            assert_eq!(own, expected);
        }
    }
}
