//! The document that the user edits and saves: plain data that can be compared and cloned.

use std::ops::{Deref, DerefMut};
use std::path::PathBuf;
use std::sync::Arc;

use pinhole_core::{Camera, DVec3, Object, Plane, Rgb, Scene, SceneError, Sphere};
use serde::Serialize;

use crate::csv::SphereTable;
use crate::host::Stamp;

/// The contents of a scene file: a camera and the objects of the scene.
///
/// Objects are counted from 0: first the spheres, then the CSV file's spheres, then the planes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// The author's note about the scene: the comment at the beginning of the scene file, without the
    /// `#` signs.
    pub note: String,
    /// The camera.
    pub camera: Camera,
    /// The observer with which the scene opens; `None` for one that is fitted to the scene.
    pub observer: Option<StoredObserver>,
    /// The `[[sphere]]`s.
    pub spheres: SharedList<Item<Sphere>>,
    /// The spheres from the file named in `spheres = "..."`.
    pub csv_spheres: Option<CsvSpheres>,
    /// The `[[plane]]`s.
    pub planes: SharedList<Item<Plane>>,
}

/// The observer of the world view, as scene files and lesson files write it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StoredObserver {
    /// The point at which the observer looks.
    pub target: DVec3,
    /// Angle from +z towards +x, in degrees.
    pub azimuth: f64,
    /// Angle above the target's level, in degrees: -90 to 90.
    pub elevation: f64,
    /// Distance from the target, in world units.
    pub distance: f64,
}

/// A copy-on-write list: clones of a document share it until one of them changes it. This keeps the
/// undo history small, in which each step contains a document.
#[derive(Clone, Debug)]
pub struct SharedList<T>(Arc<Vec<T>>);

impl<T> SharedList<T> {
    /// Returns true if this list and `other` are the same list in memory, not merely equal.
    pub fn is_same(&self, other: &SharedList<T>) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<T> Default for SharedList<T> {
    fn default() -> Self {
        SharedList(Arc::default())
    }
}

impl<T> From<Vec<T>> for SharedList<T> {
    fn from(items: Vec<T>) -> Self {
        SharedList(Arc::new(items))
    }
}

impl<T: PartialEq> PartialEq for SharedList<T> {
    fn eq(&self, other: &Self) -> bool {
        self.is_same(other) || self.0 == other.0
    }
}

impl<T> Deref for SharedList<T> {
    type Target = Vec<T>;

    fn deref(&self) -> &Vec<T> {
        &self.0
    }
}

impl<T: Clone> DerefMut for SharedList<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        Arc::make_mut(&mut self.0)
    }
}

/// An object with its name and colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Item<S> {
    /// The object's name, if any.
    pub name: Option<String>,
    /// The object's own colour; if it is `None`, the object gets a [`default_color`].
    pub color: Option<Rgb>,
    /// The sphere or plane.
    pub shape: S,
}

/// The spheres of a CSV file, which can be very many and cannot be edited. Clones of the document share
/// them.
#[derive(Clone, Debug)]
pub struct CsvSpheres {
    /// The path as it is written in the scene file, relative to that file's folder.
    pub path: String,
    /// The path from which the file was read.
    pub file: PathBuf,
    /// The file's stamp before it was read.
    pub stamp: Option<Stamp>,
    /// The number of spheres.
    pub count: usize,
    /// The spheres; none while they are [away](Document::without_table).
    pub items: Arc<SphereTable>,
}

impl PartialEq for CsvSpheres {
    fn eq(&self, other: &Self) -> bool {
        if (&self.path, self.count) != (&other.path, other.count) {
            return false;
        }
        if [self, other].iter().any(|csv| csv.items.spheres.len() != csv.count) {
            // One state of a file has the same spheres.
            return self.stamp.is_some()
                && (&self.stamp, &self.file) == (&other.stamp, &other.file);
        }
        // Comparing a million spheres takes time.
        Arc::ptr_eq(&self.items, &other.items) || self.items == other.items
    }
}

impl<S> Item<S> {
    /// Creates an object without a name or a colour.
    pub fn plain(shape: S) -> Self {
        Item { name: None, color: None, shape }
    }
}

/// The default colours: Okabe and Ito's palette, whose colours colour-blind viewers can distinguish
/// (*Color Universal Design*, 2008), without black and without the yellow, which is hardly visible on a
/// projector.
const PALETTE: [Rgb; 6] = [
    [0xe6, 0x9f, 0x00],
    [0x56, 0xb4, 0xe9],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x72, 0xb2],
];

/// The colour of the walls in the built-in scenes and in questions, a grey that leaves the eye to the rest.
pub const WALL_COLOR: Rgb = [0x9a, 0x9a, 0x92];

/// Returns the default colour of the sphere or plane with this index among the objects of its kind.
pub fn default_color(index: usize) -> Rgb {
    PALETTE[index % PALETTE.len()]
}

impl Document {
    /// Returns the number of spheres, including those of the CSV file. This is also the index of the
    /// first plane.
    pub fn sphere_count(&self) -> usize {
        self.spheres.len() + self.csv_spheres.as_ref().map_or(0, |csv| csv.count)
    }

    /// Returns the document without the spheres of its CSV file, which can be many. It equals the document with
    /// them; [`scene_file::with_table`](crate::scene_file::with_table) fetches them back.
    pub fn without_table(mut self) -> Document {
        self.csv_spheres.iter_mut().for_each(|csv| csv.items = Arc::default());
        self
    }

    /// Returns the number of objects.
    pub fn object_count(&self) -> usize {
        self.sphere_count() + self.planes.len()
    }

    /// Returns the object with this index if it can be edited. Returns `None` if there is no such
    /// object, and for a sphere of the CSV file.
    pub fn object(&self, index: usize) -> Option<Object> {
        match index.checked_sub(self.sphere_count()) {
            None => Some(Object::Sphere(self.spheres.get(index)?.shape)),
            Some(plane) => Some(Object::Plane(self.planes.get(plane)?.shape)),
        }
    }

    /// Replaces the object with this index by one of the same kind. Does nothing if
    /// [`Document::object`] returns `None`.
    pub fn set_object(&mut self, index: usize, object: Object) {
        let plane = index.checked_sub(self.sphere_count());
        match object {
            Object::Sphere(sphere) => {
                self.spheres.get_mut(index).into_iter().for_each(|item| item.shape = sphere);
            }
            Object::Plane(shape) => {
                let item = plane.and_then(|plane| self.planes.get_mut(plane));
                item.into_iter().for_each(|item| item.shape = shape);
            }
        }
    }

    /// Returns the kind of the object with this index: `sphere` or `plane`.
    pub fn kind_of(&self, index: usize) -> &'static str {
        if index < self.sphere_count() { "sphere" } else { "plane" }
    }

    /// Returns the title of the object with this index, for lists and readouts: `sphere 0`, `sphere 1
    /// “ball”`, `plane 2`.
    pub fn title_of(&self, index: usize) -> String {
        let kind = self.kind_of(index);
        match self.name_of(index as u32) {
            Some(name) => format!("{kind} {index} “{name}”"),
            None => format!("{kind} {index}"),
        }
    }

    /// Returns the name of the object with this index, for headings and labels; `sphere 0` if it has none.
    pub fn label_of(&self, index: usize) -> String {
        self.name_of(index as u32).map_or_else(|| self.title_of(index), str::to_owned)
    }

    /// Checks the objects, and returns them as a [`Scene`], without names and colours.
    ///
    /// # Errors
    /// Returns an error for the first invalid object.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        let csv = self.csv_spheres.as_ref().map(|csv| Arc::clone(&csv.items.spheres));
        let mut spheres = csv.unwrap_or_default();
        if !self.spheres.is_empty() {
            let own = self.spheres.iter().map(|item| item.shape);
            spheres = Arc::new(own.chain(spheres.iter().copied()).collect());
        }
        Scene::of_shared(spheres, self.planes.iter().map(|item| item.shape).collect())
    }

    /// Returns the name of the object with this index; `None` if the object has no name.
    pub fn name_of(&self, index: u32) -> Option<&str> {
        self.look_of(index).0
    }

    /// Returns the colour of the object with this index.
    pub fn color_of(&self, index: u32) -> Rgb {
        // Planes are counted separately, so that they keep their colours when a sphere is added.
        let k = index as usize;
        let k = k.checked_sub(self.sphere_count()).unwrap_or(k);
        self.look_of(index).1.unwrap_or_else(|| default_color(k))
    }

    fn look_of(&self, index: u32) -> (Option<&str>, Option<Rgb>) {
        fn look<S>(item: &Item<S>) -> (Option<&str>, Option<Rgb>) {
            (item.name.as_deref(), item.color)
        }
        let (index, own) = (index as usize, self.spheres.len());
        match (index.checked_sub(self.sphere_count()), &self.csv_spheres) {
            (Some(plane), _) => self.planes.get(plane).map_or((None, None), look),
            (None, Some(csv)) if index >= own => csv.items.look(index - own),
            _ => look(&self.spheres[index]),
        }
    }
}
