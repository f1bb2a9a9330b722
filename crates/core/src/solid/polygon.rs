//! A polygon as a tree of its sides, each of which is named once.
//!
//! Dobkin, Guibas, Hershberger & Snoeyink 1993, "An efficient algorithm for finding the CSG representation of a simple
//! polygon": a chain of sides, its ends drawn out to infinity, is split at a corner that stands out;
//! what is inside both halves is meant where the corner juts out, what is inside either where it is hollow.

use super::tree::Tree;

/// The tree of the polygon with these corners, counterclockwise; `leaf` gives that of one side.
pub(super) fn tree(corners: &[[f64; 2]], leaf: &impl Fn(usize) -> Tree) -> Tree {
    let count = corners.len();
    let extreme = |better: fn(f64, f64) -> bool| {
        (1..count).fold(0, |best, index| {
            if better(corners[index][1], corners[best][1]) {
                index
            } else {
                best
            }
        })
    };
    let (low, high) = (extreme(|a, b| a < b), extreme(|a, b| a > b));
    let sides = |from: usize, to: usize| -> Vec<usize> {
        let steps = (to + count - from) % count;
        (0..steps).map(|step| (from + step) % count).collect()
    };
    Tree::All(vec![
        chain(corners, &sides(low, high), leaf),
        chain(corners, &sides(high, low), leaf),
    ])
}

fn chain(corners: &[[f64; 2]], sides: &[usize], leaf: &impl Fn(usize) -> Tree) -> Tree {
    let [first, .., last] = sides else {
        return leaf(sides[0]);
    };
    let count = corners.len();
    let way = |side: usize| {
        let (start, end) = (corners[side], corners[(side + 1) % count]);
        let way = [end[0] - start[0], end[1] - start[1]];
        let length = way[0].hypot(way[1]);
        [way[0] / length, way[1] / length]
    };
    let (begin, end) = (way(*first), way(*last));
    // Both ends of the chain recede in this direction, so that the farthest corner along it stands out.
    let mut out = [begin[0] - end[0], begin[1] - end[1]];
    if out[0].hypot(out[1]) < 1.0e-9 {
        out = [-begin[1], begin[0]];
    }
    let height = |place: usize| {
        let corner = corners[sides[place]];
        corner[0] * out[0] + corner[1] * out[1]
    };
    // The corner between the sides at `place − 1` and `place`.
    let split = (1..sides.len())
        .max_by(|&a, &b| height(a).total_cmp(&height(b)))
        .expect("a chain of two sides has a corner between them");
    let (before, after) = (way(sides[split - 1]), way(sides[split]));
    let juts_out = before[0] * after[1] - before[1] * after[0] > 0.0;
    let halves = vec![
        chain(corners, &sides[..split], leaf),
        chain(corners, &sides[split..], leaf),
    ];
    if juts_out {
        Tree::All(halves)
    } else {
        Tree::Any(halves)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a point is inside, by the number of sides to its right.
    fn is_inside(corners: &[[f64; 2]], point: [f64; 2]) -> bool {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).fold(false, |inside, (a, b)| {
            let crosses = (a[1] > point[1]) != (b[1] > point[1])
                && point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            inside != crosses
        })
    }

    fn assert_tree_tells_inside_from_outside(corners: &[[f64; 2]]) {
        let tree = tree(corners, &Tree::Face);
        for index in 1..4000 {
            let fraction = |ratio: f64| (0.5 + ratio * f64::from(index)).fract() * 6.0 - 3.0;
            let point = [fraction(0.754_877_666), fraction(0.569_840_290)];
            let outside: Vec<f64> = (0..corners.len())
                .map(|side| {
                    let (a, b) = (corners[side], corners[(side + 1) % corners.len()]);
                    (b[1] - a[1]) * (point[0] - a[0]) - (b[0] - a[0]) * (point[1] - a[1])
                })
                .collect();
            assert_eq!(
                tree.value(&outside) < 0.0,
                is_inside(corners, point),
                "{corners:?} at {point:?}"
            );
        }
    }

    #[test]
    fn the_tree_of_a_polygon_tells_inside_from_outside() {
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let hopper = [
            [0.4, -0.5],
            [0.9, 0.35],
            [0.9, 0.9],
            [0.8, 0.9],
            [0.8, 0.4],
            [0.3, -0.5],
        ];
        let comb = [
            [-2.0, -2.0],
            [2.0, -2.0],
            [2.0, 2.0],
            [1.5, 2.0],
            [1.5, -1.0],
            [1.0, -1.0],
            [1.0, 1.5],
            [0.0, 2.5],
            [0.0, -1.5],
            [-1.0, 0.0],
            [-1.2, 2.0],
        ];
        let spiral = [
            [-2.0, -2.0],
            [2.0, -2.0],
            [2.0, 2.0],
            [-1.0, 2.0],
            [-1.0, -1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [0.0, 0.5],
            [0.5, 0.5],
            [0.5, -0.5],
            [-0.5, -0.5],
            [-0.5, 1.5],
            [1.5, 1.5],
            [1.5, -1.5],
            [-2.0, -1.5],
        ];
        for corners in [&square[..], &hopper, &comb, &spiral] {
            assert_tree_tells_inside_from_outside(corners);
        }
    }
}
