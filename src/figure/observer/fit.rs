//! Finds observers from which everything important is in sight.

use pinhole_core::{Camera, DVec3, Orientation, Scene, extent_of_fov};

use crate::observer::subject::{Bound, Drawn, Subject, balls_of, frustum_corners, given_at};
use crate::observer::view_size::{Area, ViewSize, tame_aspect};
use crate::observer::{DISTANCES, FOV, Observer};

/// Margins at the picture's border that are kept free, as fractions of half the picture: in general, around what the figure
/// is directed to, and around what is drawn, which has its own room.
const MARGIN: f64 = 0.1;
const MARGIN_DIRECTED: f64 = 0.06;
const MARGIN_AT_LABELS: f64 = 0.02;

/// Candidate directions of the observer, in degrees: angles to the side of the line straight behind the
/// camera, and angles above that line.
const TO_THE_SIDE: [f64; 7] = [56.0, 48.0, 40.0, 32.0, 25.0, 18.0, 12.0];
const ABOVE: [f64; 4] = [22.0, 19.0, 14.0, 9.0];

/// Size of the camera in the picture, as a fraction of the picture's shorter side, beyond which an
/// observer's score no longer rises with the size.
const LARGE_ENOUGH: f64 = 0.15;

/// Height in the picture, as a fraction of half of it, above which the sky must be seen over a sphere that is
/// out of scale, such as a planet on which the camera stands.
const HORIZON: f64 = 0.75;

/// Angle between the arrows of view and up in the picture, in radians, below which they seem to have one direction.
const CONFUSED: f64 = 0.45;

/// Number of iterations when an observer is fitted. The arrows have a fixed size on the screen, so their
/// size in the world depends on the observer and is measured again in each iteration.
const ROUNDS: usize = 6;

/// Ratio of width to height of the view for which lesson files specify their observers.
pub const ORDINARY_ASPECT: f64 = 1.25;

/// Minimum ratio of the new to the old distance from the camera's eye when an observer is fitted to a view
/// of another size.
const NEAREST_REFIT: f64 = 0.45;

/// Maximum distance from the camera's eye at which an observer is kept when the view's size changes, as a
/// multiple of the fitted observer's distance.
const FARTHEST_KEPT: f64 = 1.2;

/// The extents of what the figure is directed to, as fractions of the view's shorter side: up to which it is no more than
/// a point, which it needs at least, from which on the observer stays where it is, and which are sought.
const FILLS_NOTHING: f64 = 0.05;
const FILLS_LEAST: f64 = 0.4;
const FILLS_ENOUGH: f64 = 0.5;
const FILLS_WELL: f64 = 0.62;

/// Minimum ratio of the new to the old depth of the camera's eye when the observer is directed to arrows.
const NEAREST_SHARE: f64 = 0.05;

/// The angles by which the observer turns to the side, in degrees, if it needs another direction; and how much more must
/// be seen from its first direction, and from a turned one, in all and for each degree.
const BESIDE: [f64; 6] = [25.0, -25.0, 50.0, -50.0, 75.0, -75.0];
const OTHERWISE: f64 = 0.05;
const TURNED: f64 = 0.25;
const TURNED_BY_DEGREE: f64 = 0.002;

impl Observer {
    /// Returns an observer behind the camera's shoulder that sees the eye, the viewport, at, what is drawn, and
    /// all spheres that are not out of scale. It stands as far to the side as it can without the
    /// camera becoming too small in the picture.
    ///
    /// Perspective makes this possible: an observer close behind a small camera also sees the distant
    /// objects that the camera looks at. They appear small, as in a sketch on a whiteboard.
    pub fn frame_all(drawn: &Drawn<'_>, size: ViewSize) -> Observer {
        let subject = Subject::new(drawn);
        let behind = match (subject.back.x, subject.back.z) {
            (x, z) if x.hypot(z) > 1e-6 => x.atan2(z),
            // The camera looks straight up or down, so the direction behind it is right x up.
            _ => (-subject.right.z).atan2(subject.right.x),
        };
        let mut best: Option<(f64, Observer)> = None;
        // The observer on the right side is preferred: from there, the camera looks to the right in the
        // picture.
        for side in [1.0, -1.0] {
            for (beside, above) in TO_THE_SIDE.iter().flat_map(|b| ABOVE.map(|a| (b, a))) {
                let azimuth = behind + side * beside.to_radians();
                let from = Observer::new(DVec3::ZERO, azimuth, above.to_radians(), 1.0);
                let observer = subject.fit(&from, size);
                let score = subject.score(&observer, size.aspect()) + 0.1 * side;
                if best.is_none_or(|(most, _)| score > most) {
                    best = Some((score, observer));
                }
            }
        }
        best.map_or_else(|| Observer::new(DVec3::ZERO, 0.9, 0.4, 10.0), |(_, observer)| observer)
    }

    /// Returns the observer in the same direction that has everything in sight in a view of this size.
    pub fn refitted(&self, drawn: &Drawn<'_>, size: ViewSize) -> Observer {
        Subject::new(drawn).fit(self, size)
    }

    /// Returns an observer in the same direction for a view of this size. It sees the whole camera, what is drawn,
    /// with its labels, and every ball that this observer sees in a view of ordinary shape. Returns this observer
    /// unchanged in two cases: if all of that already fills the view, or if it is so near that the eye or the viewport
    /// is meant to be out of sight.
    pub fn framing_the_same(&self, drawn: &Drawn<'_>, size: ViewSize) -> Observer {
        if self.distance_for(drawn.camera, ORDINARY_ASPECT) > self.distance {
            return *self;
        }
        let mut subject = Subject::new(drawn);
        // Spheres that contain the eye are drawn cut away.
        let eye = subject.around.eye;
        subject.balls.extend(balls_of(drawn.scene).filter(|ball| ball.contains(eye)));
        subject.balls.retain(|ball| self.sees(ball, ORDINARY_ASPECT, 0.0));
        let depth = |observer: &Observer| observer.depth_of(eye);
        let mut fitted = subject.fit(self, size);
        let nearest = NEAREST_REFIT * depth(self);
        fitted.distance += (nearest - depth(&fitted)).max(0.0);
        let fills = depth(self) <= FARTHEST_KEPT * depth(&fitted);
        let shown = subject.shown_to(self, size);
        let is_whole = subject.balls.iter().all(|ball| self.sees_in(ball, size, 0.0))
            && shown.iter().all(|ball| self.sees_in(ball, size, MARGIN_AT_LABELS));
        if fills && is_whole { *self } else { fitted.in_range() }
    }

    /// Returns an observer for which what is drawn fills the view. Returns `now` if it does so there, so that it does not
    /// move for little. The next best direction is that of `now`, then this one's; if what is drawn is seen along its
    /// length from both, from beside it.
    pub fn directed(&self, now: &Observer, drawn: &Drawn<'_>, size: ViewSize) -> Observer {
        let mut subject = Subject::new(drawn);
        subject.balls.retain(|ball| ball.radius > 0.0);
        if subject.places.is_empty() || subject.fill(now, size) >= FILLS_ENOUGH {
            return *now;
        }
        let turned = |beside: &f64| {
            let mut direction = *self;
            direction.orbit(beside.to_radians(), 0.0);
            (direction, TURNED + TURNED_BY_DEGREE * beside.abs())
        };
        let mut best = (FILLS_NOTHING, *now);
        for (direction, worse) in
            [(*now, 0.0), (*self, OTHERWISE)].into_iter().chain(BESIDE.iter().map(turned))
        {
            let observer = subject.fit_close(&direction, size);
            let fill = subject.fill(&observer, size);
            if fill >= FILLS_WELL && best.0 < FILLS_LEAST {
                return observer;
            }
            if fill - worse > best.0 {
                best = (fill - worse, observer);
            }
        }
        best.1
    }

    /// Returns true if all that is drawn is within a view of this size.
    pub fn has_in_view(&self, drawn: &Drawn<'_>, size: ViewSize) -> bool {
        let shown = Subject::new(drawn).shown_to(self, size);
        shown.iter().all(|ball| self.sees(&Bound::point(ball.center), size.aspect(), 0.0))
    }

    /// Returns the depth of a point in front of the observer.
    pub(super) fn depth_of(&self, point: DVec3) -> f64 {
        self.distance + (self.target - point).dot(self.back())
    }

    /// Returns true if a view of this size shows the camera's eye and, if the camera is given by at, that
    /// point too.
    pub fn sees_eye_and_at(&self, camera: &Camera, size: ViewSize) -> bool {
        let mut points = [camera.eye].into_iter().chain(given_at(camera));
        points.all(|point| self.sees(&Bound::point(point), size.aspect(), 0.0))
    }

    /// Returns the observer in the same direction that sees the eye, the arrows and the viewport as large
    /// as possible.
    pub fn framing_camera(&self, drawn: &Drawn<'_>, size: ViewSize) -> Observer {
        let orientation = match drawn.camera.orientation {
            // The point at need not be in the picture, so it is replaced by a direction.
            Orientation::At { up, .. } => Orientation::View { view: drawn.camera.view(), up },
            given => given,
        };
        let camera = &Camera { orientation, ..*drawn.camera };
        self.refitted(&Drawn { camera, scene: &Scene::default(), ..drawn.clone() }, size)
    }

    /// Returns the observer moved straight back until it sees the eyes and viewports of all cameras in
    /// `others`. Returns it unchanged if it already sees them, or if it does not even see those of
    /// `camera`.
    pub fn following(&self, camera: &Camera, others: &[Camera], aspect: f64) -> Observer {
        let needed = |camera: &Camera| self.distance_for(camera, tame_aspect(aspect));
        if needed(camera) > self.distance {
            return *self;
        }
        let distance = others.iter().map(needed).fold(self.distance, f64::max);
        Observer { distance, ..*self }.in_range()
    }

    /// Returns the smallest distance from the target at which the observer sees a camera's eye and
    /// viewport, with a small margin.
    fn distance_for(&self, camera: &Camera, aspect: f64) -> f64 {
        let corners =
            camera.resolve().map_or(Vec::new(), |resolved| frustum_corners(&resolved, 1.0).into());
        let balls = corners.into_iter().chain([camera.eye]).map(Bound::point);
        let distances = balls.map(|ball| self.distance_for_ball(&ball, aspect, 0.5 * MARGIN));
        distances.filter(|distance| distance.is_finite()).fold(0.0, f64::max)
    }

    /// Returns true if the whole ball is in sight.
    fn sees(&self, ball: &Bound, aspect: f64, margin: f64) -> bool {
        self.distance_for_ball(ball, aspect, margin) <= self.distance
    }

    /// Returns true if a view of this size shows the whole ball, and nothing covers it.
    fn sees_in(&self, ball: &Bound, size: ViewSize, margin: f64) -> bool {
        self.sees(ball, size.aspect(), margin) && !size.covers(self.box_of(ball, size))
    }

    /// Returns the rectangle around a ball that is in front of the observer, in a view of this size.
    fn box_of(&self, ball: &Bound, size: ViewSize) -> Area {
        let (back, (right, up)) = (self.back(), self.right_and_up());
        let q = ball.center - self.target;
        let per_point = size.world_per_point((self.distance - q.dot(back)).max(1e-12));
        let (x, y) = (q.dot(right) / per_point, -q.dot(up) / per_point);
        let (x, y, half) = (0.5 * size.width + x, 0.5 * size.height + y, ball.radius / per_point);
        [x - half, y - half, x + half, y + half]
    }

    /// Returns the smallest distance from the target at which the observer sees a ball. In coordinates with
    /// the target as the origin and z towards the observer, it sees a point (x, y, z) from the distance
    /// `z + |x| / k` on, where k is the tangent of half the horizontal field of view without the margin;
    /// and similarly for y.
    fn distance_for_ball(&self, ball: &Bound, aspect: f64, margin: f64) -> f64 {
        let (back, (right, up)) = (self.back(), self.right_and_up());
        let slope = 0.5 * extent_of_fov(FOV, 1.0) * (1.0 - margin);
        let q = ball.center - self.target();
        let reach = |axis: DVec3| q.dot(axis).abs() + ball.radius;
        q.dot(back) + (reach(right) / (slope * aspect)).max(reach(up) / slope)
    }
}

impl Subject {
    /// Returns the extent of all that is drawn, as a fraction of the view's shorter side; 0 if some of it is out of sight or
    /// covered, or if a ball hides the camera.
    fn fill(&self, observer: &Observer, size: ViewSize) -> f64 {
        let shown = self.shown_to(observer, size);
        let stand = observer.target() + observer.distance() * observer.back();
        let is_hidden = self.balls.iter().any(|ball| lies_between(ball, self.around.eye, stand));
        if is_hidden || !shown.iter().all(|ball| observer.sees_in(ball, size, MARGIN_AT_LABELS)) {
            return 0.0;
        }
        let points = shown.iter().map(|ball| observer.box_of(&Bound::point(ball.center), size));
        let [left, top, right, bottom] = points
            .reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])])
            .unwrap_or_default();
        (right - left).max(bottom - top) / size.width.min(size.height)
    }

    /// Returns the nearest observer in this direction that sees all that is drawn, but no nearer than where arrows are as
    /// long as they are drawn.
    fn fit_close(&self, direction: &Observer, size: ViewSize) -> Observer {
        let eye = self.around.eye;
        let depth = direction.depth_of(eye).max(DISTANCES.0);
        let nearest = 1.0 / (size.arrow_points().1 * size.world_per_point(1.0));
        let nearest = nearest.clamp(NEAREST_SHARE * depth, depth);
        let there = Observer { target: eye, distance: nearest, ..*direction };
        let balls = self.shown_to(&there, size);
        let has_arrow = self.places.iter().any(|(place, _)| place.along != DVec3::ZERO);
        let fixed = Subject { balls, places: Vec::new(), around: self.around.clone(), ..*self };
        let mut fitted = fixed.fit(direction, size);
        let too_near = fitted.depth_of(eye) / nearest;
        if has_arrow && 0.0 < too_near && too_near < 1.0 {
            // The eye keeps its place in the picture, beside what covers a part of it.
            fitted.target = eye + (fitted.target - eye) / too_near;
            fitted.distance /= too_near;
        }
        self.moved_inside(fitted.in_range(), size)
    }

    /// Returns the observer moved sideways by as much as something is beyond a border of the view.
    fn moved_inside(&self, mut observer: Observer, size: ViewSize) -> Observer {
        let shown = self.shown_to(&observer, size);
        let [mut right, mut down] = [0.0_f64; 2];
        let margin = 0.5 * MARGIN_AT_LABELS;
        for [x0, y0, x1, y1] in shown.iter().map(|ball| observer.box_of(ball, size)) {
            right = right.max(margin * size.width - x0).min((1.0 - margin) * size.width - x1);
            down = down.max(margin * size.height - y0).min((1.0 - margin) * size.height - y1);
        }
        observer.pan(1.02 * right / size.height, 1.02 * down / size.height);
        observer
    }

    /// Returns the nearest observer in this direction that sees all balls and all that is drawn where nothing covers
    /// them.
    fn fit(&self, direction: &Observer, size: ViewSize) -> Observer {
        let whole = self.fit_in(direction, size, size.whole());
        let shown = self.shown_to(&whole, size);
        let is_covered = |ball: &Bound| size.covers(whole.box_of(ball, size));
        if !self.balls.iter().chain(&shown).any(is_covered) {
            return whole;
        }
        let free = size.free_areas().map(|area| self.fit_in(direction, size, area));
        let depth = |observer: &Observer| observer.depth_of(self.around.eye);
        free.min_by(|a, b| depth(a).total_cmp(&depth(b))).unwrap_or(whole)
    }

    /// Returns the nearest observer in this direction that sees all balls and all that is drawn in a part of the view.
    fn fit_in(&self, direction: &Observer, size: ViewSize, area: Area) -> Observer {
        let mut observer = self.fit_around(direction, size, area, &[]);
        for _ in 0..ROUNDS {
            observer = self.fit_around(direction, size, area, &self.shown_to(&observer, size));
        }
        observer
    }

    /// Returns the nearest observer in this direction that sees all balls, those of what is `shown`
    /// too, in a part of the view.
    ///
    /// Let x point to the observer's right and z towards the observer, let (ex, ez) be the observer's
    /// position, and let k and l be the slopes of the rays at the part's right and left border, without
    /// the margin. A ball with centre (x, z) and radius r is to the left of the right border if
    /// `x - ex <= k (ez - z) - r'`, where `r' = r sqrt(1 + k^2)`, and similarly for the left border. With
    /// the maxima over all balls `A = max(x + k z + r')` and `B = max(-x + l z + r')`, the nearest position
    /// is `ez = (A + B) / (k + l)`. From there on, ex is between `A - k ez` and `l ez - B`. The same is done
    /// for y.
    fn fit_around(
        &self,
        direction: &Observer,
        size: ViewSize,
        [left, top, right_end, bottom]: Area,
        shown: &[Bound],
    ) -> Observer {
        let back = direction.back();
        let (right, up) = direction.right_and_up();
        let slope = 0.5 * extent_of_fov(FOV, 1.0);
        // Slopes of the rays through two borders, which are fractions of the view's width or height.
        let slopes = |low: f64, high: f64, half: f64| {
            let margin = if size.is_directed { MARGIN_DIRECTED } else { MARGIN };
            let margin = 0.5 * margin * (high - low);
            [2.0 * (high - margin) - 1.0, 1.0 - 2.0 * (low + margin)].map(|share| half * share)
        };
        let (w, h) = (size.width, size.height);
        let across = slopes(left / w, right_end / w, slope * size.aspect());
        let upwards = slopes(1.0 - bottom / h, 1.0 - top / h, slope);
        let most = |axis: DVec3, k: f64| {
            let widen = (1.0 + k * k).sqrt();
            let balls = self.balls.iter().chain(shown);
            balls
                .filter(|ball| ball.center.is_finite() && ball.radius.is_finite())
                .map(|ball| {
                    let q = ball.center - self.around.eye;
                    q.dot(axis) + k * q.dot(back) + ball.radius * widen
                })
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let reach = |axis: DVec3, [k, l]: [f64; 2]| [most(axis, k), most(-axis, l)];
        let (x, y) = (reach(right, across), reach(up, upwards));
        let depth = |[a, b]: [f64; 2], [k, l]: [f64; 2]| (a + b) / (k + l);
        let z = depth(x, across).max(depth(y, upwards));
        let middle = |[a, b]: [f64; 2], [k, l]: [f64; 2]| 0.5 * ((a - k * z) + (l * z - b));
        let stand =
            self.around.eye + middle(x, across) * right + middle(y, upwards) * up + z * back;
        let distance = (stand - self.around.middle).dot(back).max(0.5 * self.around.near_size);
        let target = stand - distance * back;
        Observer { target, distance, ..*direction }.in_range()
    }

    /// Returns the score of an observer. It is higher if the camera is large enough in the picture, if its
    /// view direction is seen from the side, if the picture on its viewport and the planes are seen from
    /// the front, if no ball hides the camera, and if the horizon of a planet is in sight.
    fn score(&self, observer: &Observer, aspect: f64) -> f64 {
        let back = observer.back();
        let stand = observer.target() + observer.distance() * back;
        let to_eye = stand - self.around.eye;
        let depth = to_eye.dot(back).max(1e-12);
        let size = self.around.near_size / (aspect.min(1.0) * extent_of_fov(FOV, depth));
        let along = back.dot(self.back);
        let sideways = (1.0 - along * along).max(0.0).sqrt();
        // The camera's picture on its viewport is hard to read if it is foreshortened to less than half its
        // width.
        let from_front = along.clamp(-0.5, 0.62);
        let hidden = self.balls.iter().any(|ball| lies_between(ball, self.around.eye, stand));
        let facing: f64 = self.around.walls.iter().map(|hit| hit.normal.dot(back).max(0.0)).sum();
        let facing = facing / self.around.walls.len().max(1) as f64;
        // View and up must not seem to have one direction.
        let seen = self.given.map(|vector| vector - vector.dot(back) * back);
        let [apart, seems_apart] = [self.given, seen].map(|[view, up]| view.angle_between(up));
        let is_confused = seems_apart < CONFUSED && apart > 2.0 * CONFUSED;
        (size / LARGE_ENOUGH).min(1.0) + 1.2 * sideways + from_front + 0.2 * facing
            - if hidden { 0.6 } else { 0.0 }
            - if is_confused { 0.6 } else { 0.0 }
            - if self.loses_horizon(observer) { 1.0 } else { 0.0 }
    }

    /// Returns true if a sphere that is out of scale fills the picture up to [`HORIZON`].
    fn loses_horizon(&self, observer: &Observer) -> bool {
        let (back, (_, up)) = (observer.back(), observer.right_and_up());
        let stand = observer.target() + observer.distance() * back;
        let upwards = HORIZON * 0.5 * extent_of_fov(FOV, 1.0) * up - back;
        self.around.planets.iter().any(|ball| {
            let from_center = stand - ball.center;
            let outside = from_center.length_squared() - ball.radius * ball.radius;
            let b = from_center.dot(upwards);
            outside > 0.0 && b < 0.0 && b * b > upwards.length_squared() * outside
        })
    }
}

fn lies_between(ball: &Bound, a: DVec3, b: DVec3) -> bool {
    let along = b - a;
    let share = ((ball.center - a).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
    ball.radius > 0.0 && (a + share * along).distance(ball.center) < ball.radius
}
