//! The pen of presenter mode: what was drawn over the views. Pure.

/// What the pen has drawn, while it is in use.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pen {
    /// Lines through these points, as shares of the drawn-on area's width and height.
    pub lines: Vec<Vec<[f32; 2]>>,
}

impl Pen {
    /// Begins a line.
    pub fn press(&mut self, at: [f32; 2]) {
        self.lines.push(vec![at]);
    }

    /// Draws the last line on to this point.
    pub fn draw_to(&mut self, to: [f32; 2]) {
        if let Some(line) = self.lines.last_mut().filter(|line| line.last() != Some(&to)) {
            line.push(to);
        }
    }
}
