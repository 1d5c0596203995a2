//! Circles among files that import each other.

use std::collections::{BTreeMap, BTreeSet};

/// What is left of a graph once all that leads into no circle is taken away: the circles,
/// and what leads into them.
pub fn leading_into_circles<Node: Ord + Clone>(
    mut graph: BTreeMap<Node, BTreeSet<Node>>,
) -> BTreeMap<Node, BTreeSet<Node>> {
    loop {
        let left: BTreeSet<Node> = graph.keys().cloned().collect();
        graph.values_mut().for_each(|targets| targets.retain(|target| left.contains(target)));
        graph.retain(|_, targets| !targets.is_empty());
        if graph.len() == left.len() {
            return graph;
        }
    }
}
