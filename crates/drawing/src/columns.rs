//! Shapes by columns of equal width, so that those beside a place are found without looking at all of them.

/// Numbers of shapes by the columns that they reach into.
pub(crate) struct Columns {
    columns: Vec<Vec<usize>>,
    left: f64,
    width: f64,
}

impl Columns {
    /// Takes the extent of each shape along x. Makes as many columns as there are shapes, so that short ones lie in one
    /// or two columns each.
    pub(crate) fn new(extents: impl Iterator<Item = [f64; 2]>) -> Self {
        let extents: Vec<[f64; 2]> = extents.collect();
        let left = extents.iter().map(|[from, _]| *from).fold(f64::INFINITY, f64::min);
        let right = extents.iter().map(|[_, to]| *to).fold(f64::NEG_INFINITY, f64::max);
        let count = extents.len().max(1);
        let width = ((right - left) / count as f64).max(f64::MIN_POSITIVE);
        let mut all = Self { columns: vec![Vec::new(); count], left, width };
        for (number, [from, to]) in extents.into_iter().enumerate() {
            all.range(from, to).for_each(|column| all.columns[column].push(number));
        }
        all
    }

    fn range(&self, from: f64, to: f64) -> std::ops::RangeInclusive<usize> {
        let column = |x: f64| (((x - self.left) / self.width).max(0.0) as usize).min(self.columns.len() - 1);
        column(from)..=column(to)
    }

    /// Returns the shapes in the columns between two places, in increasing order within each column. A shape that
    /// reaches into several of them is returned several times.
    pub(crate) fn near(&self, from: f64, to: f64) -> impl Iterator<Item = usize> + '_ {
        self.columns[self.range(from, to)].iter().flatten().copied()
    }
}
