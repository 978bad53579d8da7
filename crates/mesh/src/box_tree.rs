//! A tree of boxes that finds the points or segments near a point.

use crate::DVec3;
use crate::axis_box::AxisBox;

/// Largest number of items in a box that is not halved further.
pub(crate) const RUN: usize = 4;

/// Boxes of numbered items in a binary tree. Box 1 contains all items; the halves of box k are the boxes 2 k and
/// 2 k + 1.
#[derive(Clone, Debug)]
pub struct BoxTree {
    items: Vec<u32>,
    boxes: Vec<AxisBox>,
}

/// A box of a binary tree: its number, and the range `from..to` of its items.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub(crate) node: usize,
    pub(crate) from: usize,
    pub(crate) to: usize,
}

impl Run {
    /// The box of all items of a tree.
    pub(crate) fn whole(count: usize) -> Self {
        Self { node: 1, from: 0, to: count }
    }

    pub(crate) fn halves(self) -> [Self; 2] {
        let middle = usize::midpoint(self.from, self.to);
        [
            Self { node: 2 * self.node, from: self.from, to: middle },
            Self { node: 2 * self.node + 1, from: middle, to: self.to },
        ]
    }
}

impl BoxTree {
    /// Builds the tree over the boxes of items. The number of an item is its place in the list. O(n log n).
    pub fn new(boxes: &[AxisBox]) -> Self {
        let count = boxes.len();
        let mut tree =
            Self { items: (0..count as u32).collect(), boxes: vec![AxisBox::EMPTY; 4 * count.div_ceil(RUN) + 2] };
        tree.enclose(boxes, Run::whole(count));
        tree
    }

    fn enclose(&mut self, boxes: &[AxisBox], run: Run) {
        let own = &mut self.items[run.from..run.to];
        let whole = own.iter().fold(AxisBox::EMPTY, |whole, &k| whole.with(&boxes[k as usize]));
        self.boxes[run.node] = whole;
        if own.len() <= RUN {
            return;
        }
        let extent = (whole.high - whole.low).to_array();
        let axis = (0..3).fold(0, |longest, k| if extent[k] > extent[longest] { k } else { longest });
        let centre = |k: u32| boxes[k as usize].centre()[axis];
        let middle = own.len() / 2;
        own.select_nth_unstable_by(middle, |&a, &b| centre(a).total_cmp(&centre(b)).then(a.cmp(&b)));
        run.halves().into_iter().for_each(|half| self.enclose(boxes, half));
    }

    /// Visits the items whose boxes are at most `within` away from a point, near boxes first. `visit` returns the
    /// distance with which the search goes on.
    pub fn visit(&self, point: DVec3, within: f64, visit: &mut dyn FnMut(u32) -> f64) {
        let mut within = within;
        self.search(Run::whole(self.items.len()), point, &mut within, visit);
    }

    fn search(&self, run: Run, point: DVec3, within: &mut f64, visit: &mut dyn FnMut(u32) -> f64) {
        let away = |run: &Run| self.boxes[run.node].distance_squared(point);
        if away(&run) > *within * *within {
            return;
        }
        if run.to - run.from <= RUN {
            for &item in &self.items[run.from..run.to] {
                *within = visit(item);
            }
            return;
        }
        let mut halves = run.halves();
        if away(&halves[1]) < away(&halves[0]) {
            halves.swap(0, 1);
        }
        halves.into_iter().for_each(|half| self.search(half, point, within, visit));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::SplitMix64;

    #[test]
    fn the_items_found_are_those_of_a_search_through_all() {
        let mut random = SplitMix64::new(3);
        let mut point = || DVec3::new(random.unit(), random.unit(), 0.2 * random.unit());
        let points: Vec<DVec3> = (0..500).map(|_| point()).collect();
        let boxes: Vec<AxisBox> = points.iter().map(|&p| AxisBox::around([p])).collect();
        let tree = BoxTree::new(&boxes);
        for _ in 0..100 {
            let at = point();
            let mut found = Vec::new();
            tree.visit(at, 0.15, &mut |k| {
                if points[k as usize].distance(at) <= 0.15 {
                    found.push(k);
                }
                0.15
            });
            found.sort_unstable();
            let all: Vec<u32> = (0..500).filter(|&k| points[k as usize].distance(at) <= 0.15).collect();
            assert_eq!(found, all);
            let mut nearest = f64::INFINITY;
            tree.visit(at, f64::INFINITY, &mut |k| {
                nearest = nearest.min(points[k as usize].distance(at));
                nearest
            });
            assert_eq!(nearest, points.iter().map(|p| p.distance(at)).fold(f64::INFINITY, f64::min));
        }
    }
}
