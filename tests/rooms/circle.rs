//! Circular imports between files.

use std::collections::{BTreeMap, BTreeSet};

/// Repeatedly removes the nodes without targets. The rest is the circles and the nodes that lead into them.
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
