//! A textbook ray tracer with a bounding volume hierarchy. The tree is built by the binned surface-area
//! heuristic (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007) with up to
//! four spheres per leaf, and traversed with a stack, near child first.

use glam::Vec3;
use pinhole_core::{ResolvedCamera, Scene};

use super::frames::{Buffers, Rays};
use super::textbook::{self, Ball, Nearest, each_pixel};

/// A scene with its tree.
#[derive(Clone, Debug)]
pub(crate) struct Bvh {
    nodes: Vec<Node>,
    /// The spheres in the order of the leaves.
    balls: Vec<Ball>,
    objects: Vec<u32>,
}

/// A node of the tree: a bounding box with either two children, which are adjacent in the array, or, in
/// a leaf, a range of spheres.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    /// The left child, or the first sphere.
    first: u32,
    /// Number of spheres; 0 for an inner node.
    count: u32,
}

/// A box along the axes.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

const LEAF: usize = 4;
const BINS: usize = 16;

/// Depth of the tree from which nodes are split at the median, whatever the cost, so that a stack of
/// [`STACK`] entries suffices for 2^24 spheres.
const DEEP: usize = 40;
const STACK: usize = 64;

impl Bounds {
    const NONE: Bounds =
        Bounds { low: Vec3::splat(f32::INFINITY), high: Vec3::splat(f32::NEG_INFINITY) };

    fn around(ball: &Ball) -> Bounds {
        Bounds { low: ball.center - ball.radius, high: ball.center + ball.radius }
    }

    fn with(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Half of the surface.
    fn area(&self) -> f32 {
        let size = self.high - self.low;
        size.x * size.y + size.y * size.z + size.z * size.x
    }

    /// Returns the `t >= 0` at which a ray enters the box, or `None` if it misses the box or enters it
    /// no earlier than at the given `t`. `inverse` is the componentwise reciprocal of the direction.
    #[inline]
    fn entry(&self, origin: Vec3, inverse: Vec3, t: f32) -> Option<f32> {
        let (a, b) = ((self.low - origin) * inverse, (self.high - origin) * inverse);
        let enter = a.min(b).max_element().max(0.0);
        let leave = a.max(b).min_element();
        (enter <= leave && enter < t).then_some(enter)
    }
}

impl Bvh {
    /// Builds the tree of a scene.
    pub(crate) fn new(scene: &Scene) -> Bvh {
        let all = textbook::balls(scene);
        let mut objects: Vec<u32> = (0..all.len() as u32).collect();
        let mut nodes = vec![Node { bounds: Bounds::NONE, first: 0, count: 0 }];
        let mut open = vec![(0, 0..objects.len(), 0)];
        while let Some((at, range, depth)) = open.pop() {
            let own = &mut objects[range.clone()];
            let boxes = own.iter().map(|object| Bounds::around(&all[*object as usize]));
            let bounds = boxes.fold(Bounds::NONE, Bounds::with);
            if own.len() <= LEAF {
                let (first, count) = (range.start as u32, own.len() as u32);
                nodes[at] = Node { bounds, first, count };
                continue;
            }
            let middle = range.start + split(own, &all, depth);
            let left = nodes.len();
            nodes[at] = Node { bounds, first: left as u32, count: 0 };
            nodes.extend([Node { bounds: Bounds::NONE, first: 0, count: 0 }; 2]);
            open.push((left, range.start..middle, depth + 1));
            open.push((left + 1, middle..range.end, depth + 1));
        }
        let balls = objects.iter().map(|object| all[*object as usize]).collect();
        Bvh { nodes, balls, objects }
    }

    /// Traces a frame.
    pub(crate) fn trace(&self, camera: &ResolvedCamera, buffers: &mut Buffers) {
        let rays = Rays::new(camera);
        each_pixel(buffers, |row, column| self.nearest_ball(rays.eye, rays.direction(row, column)));
    }

    fn nearest_ball(&self, origin: Vec3, direction: Vec3) -> Nearest {
        let inverse = direction.recip();
        let mut nearest = Nearest::NONE;
        let mut stack = [(0u32, 0.0f32); STACK];
        let mut height = usize::from(!self.balls.is_empty());
        while height > 0 {
            height -= 1;
            let (at, entry) = stack[height];
            if entry >= nearest.t {
                continue;
            }
            let node = &self.nodes[at as usize];
            if node.count > 0 {
                self.ask_leaf(node, origin, direction, &mut nearest);
                continue;
            }
            let entry =
                |child: u32| self.nodes[child as usize].bounds.entry(origin, inverse, nearest.t);
            let children = [node.first, node.first + 1];
            let mut found = children.map(|child| entry(child).map(|entry| (child, entry)));
            if let [Some((_, left)), Some((_, right))] = found
                && left < right
            {
                found.swap(0, 1);
            }
            // The near child is pushed last, so that it is popped first.
            for child in found.into_iter().flatten() {
                stack[height] = child;
                height += 1;
            }
        }
        nearest
    }

    #[inline]
    fn ask_leaf(&self, node: &Node, origin: Vec3, direction: Vec3, nearest: &mut Nearest) {
        for at in node.first as usize..(node.first + node.count) as usize {
            let Some(t) = self.balls[at].first_root(origin, direction) else { continue };
            let object = self.objects[at];
            if t < nearest.t || (t == nearest.t && object < nearest.object) {
                *nearest = Nearest { t, object };
            }
        }
    }
}

/// Partitions the spheres of a node into those of the left child, which come first, and those of the
/// right child. Returns the number of spheres in the left child.
fn split(objects: &mut [u32], balls: &[Ball], depth: usize) -> usize {
    let center = |object: &u32| balls[*object as usize].center;
    let centers = objects.iter().map(center);
    let spread = centers.fold(Bounds::NONE, |bounds, c| bounds.with(Bounds { low: c, high: c }));
    let half = objects.len() / 2;
    let size = spread.high - spread.low;
    let bin_of = |axis: usize, object: &u32| {
        let part = (center(object)[axis] - spread.low[axis]) / size[axis];
        ((part * BINS as f32) as usize).min(BINS - 1)
    };
    let axes = (0..3).filter(|axis| size[*axis] > 0.0 && depth < DEEP);
    let best = axes
        .flat_map(|axis| {
            let mut bins = [(0usize, Bounds::NONE); BINS];
            for object in objects.iter() {
                let bin = &mut bins[bin_of(axis, object)];
                *bin = (bin.0 + 1, bin.1.with(Bounds::around(&balls[*object as usize])));
            }
            cuts(bins).map(move |(cost, cut)| (cost, axis, cut))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, axis, cut)) = best else {
        let longest = size.max_position();
        objects
            .select_nth_unstable_by(half, |a, b| center(a)[longest].total_cmp(&center(b)[longest]));
        return half;
    };
    let mut left = 0;
    for at in 0..objects.len() {
        if bin_of(axis, &objects[at]) < cut {
            objects.swap(at, left);
            left += 1;
        }
    }
    left
}

/// Returns, for each way to split a node between two bins, its cost and the index of the first bin on
/// the right. The cost is half of the bounding box's surface area times the number of spheres, summed
/// over both sides. Splits that leave a side empty are left out.
fn cuts(bins: [(usize, Bounds); BINS]) -> impl Iterator<Item = (f32, usize)> {
    let join = |a: (usize, Bounds), b: &(usize, Bounds)| (a.0 + b.0, a.1.with(b.1));
    let sum = move |bins: &[(usize, Bounds)]| bins.iter().fold((0, Bounds::NONE), join);
    (1..BINS).filter_map(move |cut| {
        let (left, right) = (sum(&bins[..cut]), sum(&bins[cut..]));
        let cost = left.0 as f32 * left.1.area() + right.0 as f32 * right.1.area();
        (left.0 > 0 && right.0 > 0).then_some((cost, cut))
    })
}
