//! Arrays of a few numbers, as NumPy and OpenCV make them.

mod code;
mod functions;
pub(super) mod names;
mod statements;

use pinhole_core::{Basis, DVec3};

use crate::exchange::affine::Affine;

/// Numbers, row after row, and how many there are along each axis; a number alone has no axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Matrix {
    shape: Vec<usize>,
    pub(super) numbers: Vec<f64>,
}

/// No matrix of a camera has more numbers.
pub(super) const MOST: usize = 64;

/// What an index takes of an axis: one of it, or a part of it.
#[derive(Clone, Copy, Debug)]
pub(super) enum Index {
    At(i64),
    Range(Option<i64>, Option<i64>),
    /// None of it, but a new axis of one.
    New,
}

impl Matrix {
    pub(super) fn scalar(number: f64) -> Matrix {
        Matrix { shape: Vec::new(), numbers: vec![number] }
    }

    pub(super) fn vector(numbers: Vec<f64>) -> Matrix {
        Matrix { shape: vec![numbers.len()], numbers }
    }

    /// `None` where these are not so many numbers, or too many.
    pub(super) fn shaped(shape: Vec<usize>, numbers: Vec<f64>) -> Option<Matrix> {
        let count = shape.iter().try_fold(1_usize, |count, n| count.checked_mul(*n))?;
        (count == numbers.len() && count <= MOST && count > 0).then_some(Matrix { shape, numbers })
    }

    /// One after the other along a new axis; all must have one shape.
    pub(super) fn of_list(items: Vec<Matrix>) -> Option<Matrix> {
        let mut shape = items.first()?.shape.clone();
        if items.iter().any(|item| item.shape != shape) {
            return None;
        }
        shape.insert(0, items.len());
        Matrix::shaped(shape, items.into_iter().flat_map(|item| item.numbers).collect())
    }

    pub(super) fn eye(n: usize) -> Option<Matrix> {
        Matrix::diagonal(&vec![1.0; n.min(MOST)])
    }

    pub(super) fn diagonal(numbers: &[f64]) -> Option<Matrix> {
        let n = numbers.len();
        if n * n > MOST {
            return None;
        }
        let at = |k: usize| if k / n == k % n { numbers[k / n] } else { 0.0 };
        Matrix::shaped(vec![n, n], (0..n * n).map(at).collect())
    }

    pub(super) fn is_scalar(&self) -> bool {
        self.shape.is_empty()
    }

    pub(super) fn is_vector(&self) -> bool {
        self.shape.len() == 1
    }

    /// The number, where it is one alone.
    pub(super) fn number(&self) -> Option<f64> {
        match self.numbers[..] {
            [number] => Some(number),
            _ => None,
        }
    }

    /// How many there are along the first axis.
    pub(super) fn length(&self) -> Option<usize> {
        self.shape.first().copied()
    }

    /// As many as this, in another shape; a size of -1 is what is left.
    pub(super) fn reshaped(&self, sizes: &[f64]) -> Option<Matrix> {
        let known: f64 = sizes.iter().filter(|n| **n != -1.0).product();
        let left = self.numbers.len() as f64 / known;
        let size = |n: &f64| match *n {
            -1.0 => whole(left),
            n => whole(n),
        };
        let shape: Option<Vec<usize>> = sizes.iter().map(size).collect();
        Matrix::shaped(shape?, self.numbers.clone())
    }

    pub(super) fn flat(&self) -> Matrix {
        Matrix::vector(self.numbers.clone())
    }

    pub(super) fn each(&self, of: impl Fn(f64) -> f64) -> Matrix {
        Matrix { numbers: self.numbers.iter().map(|x| of(*x)).collect(), ..self.clone() }
    }

    pub(super) fn transposed(&self) -> Option<Matrix> {
        match self.shape[..] {
            [] | [_] => Some(self.clone()),
            [rows, columns] => {
                let numbers = (0..columns)
                    .flat_map(|column| (0..rows).map(move |row| row * columns + column))
                    .map(|at| self.numbers[at])
                    .collect();
                Some(Matrix { shape: vec![columns, rows], numbers })
            }
            _ => None,
        }
    }

    /// Of each number and its partner, or one number and each; of `*` only where one is a number
    /// alone, as it is another product of matrices in NumPy than in C++.
    pub(super) fn combined(&self, sign: char, other: &Matrix) -> Option<Matrix> {
        let of = move |a: f64, b: f64| match sign {
            '+' => a + b,
            '-' => a - b,
            '*' => a * b,
            _ => a / b,
        };
        match (self.number(), other.number(), sign) {
            (_, Some(b), _) if other.is_scalar() => Some(self.each(|a| of(a, b))),
            (Some(a), _, '+' | '-' | '*') if self.is_scalar() => Some(other.each(|b| of(a, b))),
            (_, _, '+' | '-') if self.shape == other.shape => {
                let pairs = self.numbers.iter().zip(&other.numbers);
                let numbers = pairs.map(|(a, b)| of(*a, *b)).collect();
                Some(Matrix { shape: self.shape.clone(), numbers })
            }
            _ => None,
        }
    }

    /// NumPy's `@`.
    pub(super) fn product(&self, other: &Matrix) -> Option<Matrix> {
        let (rows, inner) = match self.shape[..] {
            [n] => (1, n),
            [rows, n] => (rows, n),
            _ => return None,
        };
        let columns = match other.shape[..] {
            [n] if n == inner => 1,
            [n, columns] if n == inner => columns,
            _ => return None,
        };
        let at = |row: usize, column: usize| -> f64 {
            let term =
                |k: usize| self.numbers[row * inner + k] * other.numbers[k * columns + column];
            (0..inner).map(term).sum()
        };
        let numbers = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let numbers = numbers.map(|(row, column)| at(row, column)).collect();
        let mut shape = Vec::new();
        if self.shape.len() == 2 {
            shape.push(rows);
        }
        if other.shape.len() == 2 {
            shape.push(columns);
        }
        Matrix::shaped(shape, numbers)
    }

    pub(super) fn inverse(&self) -> Option<Matrix> {
        let [n, m] = self.shape[..] else { return None };
        let one = (n == m).then(|| Matrix::eye(n))??;
        // Gauss and Jordan, by the largest pivot.
        let row = |m: &Matrix, k: usize| m.numbers[k * n..(k + 1) * n].to_vec();
        let mut rows: Vec<Vec<f64>> =
            (0..n).map(|k| [row(self, k), row(&one, k)].concat()).collect();
        for k in 0..n {
            let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))?;
            rows.swap(k, pivot);
            let by = rows[k][k];
            if by == 0.0 {
                return None;
            }
            rows[k].iter_mut().for_each(|x| *x /= by);
            let own = rows[k].clone();
            for other in (0..n).filter(|other| *other != k) {
                let by = rows[other][k];
                rows[other].iter_mut().zip(&own).for_each(|(x, own)| *x -= by * own);
            }
        }
        let numbers = rows.iter().flat_map(|row| row[n..].to_vec()).collect();
        Matrix::shaped(vec![n, n], numbers)
    }

    /// Beside each other; NumPy's `hstack`.
    pub(super) fn beside(items: &[Matrix]) -> Option<Matrix> {
        if items.iter().all(|item| item.shape.len() == 1) {
            let numbers: Vec<f64> = items.iter().flat_map(|item| item.numbers.clone()).collect();
            return Matrix::shaped(vec![numbers.len()], numbers);
        }
        let turned: Option<Vec<Matrix>> =
            items.iter().map(|item| (item.shape.len() == 2).then(|| item.transposed())?).collect();
        Matrix::below(&turned?)?.transposed()
    }

    /// Below each other; NumPy's `vstack`.
    pub(super) fn below(items: &[Matrix]) -> Option<Matrix> {
        let columns = *items.first()?.shape.last()?;
        let fits = |item: &Matrix| item.shape.len() <= 2 && item.shape.last() == Some(&columns);
        if columns == 0 || !items.iter().all(fits) {
            return None;
        }
        let numbers: Vec<f64> = items.iter().flat_map(|item| item.numbers.clone()).collect();
        Matrix::shaped(vec![numbers.len() / columns, columns], numbers)
    }

    /// A vector as a column.
    pub(super) fn column(&self) -> Option<Matrix> {
        match self.shape.len() {
            1 => Matrix::shaped(vec![self.numbers.len(), 1], self.numbers.clone()),
            _ => Some(self.clone()),
        }
    }

    /// Where in its numbers those of an index are, and their shape.
    fn chosen(&self, index: &[Index]) -> Option<(Vec<usize>, Vec<usize>)> {
        let (mut shape, mut places) = (Vec::new(), vec![0]);
        let mut axes = self.shape.iter();
        let count = index.iter().filter(|index| !matches!(index, Index::New)).count();
        let whole = self.shape.len().checked_sub(count)?;
        let whole = std::iter::repeat_n(&Index::Range(None, None), whole);
        for index in index.iter().chain(whole) {
            if matches!(index, Index::New) {
                shape.push(1);
                continue;
            }
            let n = axes.next()?;
            let size = i64::try_from(*n).ok()?;
            let from_end = |k: i64| if k < 0 { k + size } else { k };
            let (from, to) = match index {
                Index::New => return None,
                Index::At(k) => (from_end(*k), from_end(*k) + 1),
                Index::Range(from, to) => {
                    let [from, to] = [from.unwrap_or(0), to.unwrap_or(size)].map(from_end);
                    shape.push(usize::try_from(to - from).ok()?);
                    (from, to)
                }
            };
            if !(0 <= from && from < to && to <= size) {
                return None;
            }
            let (from, to) = (usize::try_from(from).ok()?, usize::try_from(to).ok()?);
            places = places.iter().flat_map(|at| (from..to).map(move |k| at * n + k)).collect();
        }
        Some((places, shape))
    }

    /// What an index takes.
    pub(super) fn at(&self, index: &[Index]) -> Option<Matrix> {
        let (places, shape) = self.chosen(index)?;
        Matrix::shaped(shape, places.into_iter().map(|at| self.numbers[at]).collect())
    }

    /// With other numbers where an index takes some: one for all, or as many as there are.
    pub(super) fn with(&self, index: &[Index], value: &Matrix) -> Option<Matrix> {
        let (places, shape) = self.chosen(index)?;
        let mut changed = self.clone();
        for (k, at) in places.into_iter().enumerate() {
            changed.numbers[at] = match value.is_scalar() {
                true => value.number()?,
                false if value.shape == shape => value.numbers[k],
                false => return None,
            };
        }
        Some(changed)
    }

    /// OpenCV's `Rodrigues`: the rotation of a vector, or the vector of a rotation.
    pub(super) fn rodrigues(&self) -> Option<Matrix> {
        match self.numbers[..] {
            [x, y, z] => {
                let vector = DVec3::new(x, y, z);
                let turn = Affine::rotation(vector.length().to_degrees(), vector);
                let turn = turn.unwrap_or(Affine::IDENTITY);
                let rows = (0..3).flat_map(|k| [turn.x[k], turn.y[k], turn.z[k]]).collect();
                Matrix::shaped(vec![3, 3], rows)
            }
            [a, b, c, d, e, f, g, h, i] => {
                let columns = [DVec3::new(a, d, g), DVec3::new(b, e, h), DVec3::new(c, f, i)];
                let basis = Basis::by_hand(columns[0], columns[1], columns[2]).ok()?;
                let [w, x, y, z] = basis.quaternion();
                let axis = DVec3::new(x, y, z);
                let angle = 2.0 * axis.length().atan2(w);
                let vector = axis.try_normalize().map_or(DVec3::ZERO, |axis| axis * angle);
                Matrix::shaped(vec![3, 1], vector.to_array().to_vec())
            }
            _ => None,
        }
    }
}

/// A number that counts.
pub(super) fn whole(number: f64) -> Option<usize> {
    (number.fract() == 0.0 && (0.0..=1e6).contains(&number)).then_some(number as usize)
}
