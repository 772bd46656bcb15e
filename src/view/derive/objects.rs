//! The scene that is made from the document's objects. It is kept between frames and changed in place when
//! an object is edited.

use std::sync::Arc;

use pinhole_core::{Object, Rgb, Scene, SceneError};
use pinhole_exchange::document::{CsvSpheres, Document, Item};
use pinhole_figure::Scheme;
use pinhole_figure::observer::{hidden, traced_scene};

/// The scene and its objects' colours, from the last document whose objects were all valid.
#[derive(Clone, Debug)]
pub(super) struct GoodWorld {
    pub(super) scene: Arc<Scene>,
    pub(super) colors: Arc<Vec<Rgb>>,
    /// Generation number of the shapes; it increases whenever a shape changes.
    pub(super) generation: u64,
    /// Generation number of the colours; it increases whenever a colour changes.
    pub(super) palette: u64,
}

/// Indices of the spheres that would hide the camera from the observer, in ascending order.
pub(super) type Enclosing = Arc<Vec<u32>>;

/// The scene of the last document whose objects were all valid.
///
/// If one sphere of a million is dragged, only that sphere is replaced. This requires that no view still
/// holds a reference to the scene at the next [`Objects::update`]; otherwise all spheres are copied.
#[derive(Debug, Default)]
pub(super) struct Objects {
    good: Option<GoodWorld>,
    /// The spheres from the CSV file in the last valid document.
    csv: Option<CsvSpheres>,
    /// The colour scheme for which `GoodWorld::colors` was computed.
    scheme: Scheme,
    /// The indices of the spheres that are hidden from the observer, and the scene without them that is
    /// traced for it.
    observed: Option<(Enclosing, Arc<Scene>)>,
}

/// Maximum number of changed objects that are replaced one by one. If more objects have changed, the scene
/// is rebuilt.
const FEW: usize = 64;

impl Objects {
    /// Returns the objects of the last document whose objects were all valid; `None` if there was no
    /// such document yet.
    pub(super) fn good(&self) -> Option<&GoodWorld> {
        self.good.as_ref()
    }

    /// Updates the scene from the document. Unless objects were added or removed, the cost is
    /// proportional to the number of objects that are not from the CSV file.
    ///
    /// # Errors
    /// Returns an error for the first invalid object; the last valid scene is then kept unchanged.
    pub(super) fn update(&mut self, document: &Document, scheme: Scheme) -> Result<(), SceneError> {
        check(document)?;
        let is_same_scheme = std::mem::replace(&mut self.scheme, scheme) == scheme;
        let changed = self.good.as_ref().and_then(|good| self.changed(good, document));
        match (&mut self.good, changed) {
            (Some(good), Some(changed)) => {
                if !changed.is_empty() {
                    // The observer's scene shares its spheres with this one unless it leaves some out. It
                    // is dropped so that the shared spheres can be changed in place.
                    self.observed.take_if(|(hidden, _)| hidden.is_empty());
                    replace(good, self.observed.as_mut(), &changed)?;
                }
                if is_same_scheme {
                    recolor(good, document, scheme);
                } else {
                    good.colors = Arc::new(colors(document, scheme));
                    good.palette += 1;
                }
            }
            _ => self.make(document)?,
        }
        self.csv.clone_from(&document.csv_spheres);
        Ok(())
    }

    /// Returns the last valid scene as it is traced for the observer: without planes, and without the
    /// spheres that would hide the camera; see [`traced_scene`].
    pub(super) fn observed(&mut self, enclosing: &Enclosing) -> Option<Arc<Scene>> {
        let scene = &self.good.as_ref()?.scene;
        match &self.observed {
            Some((known, _)) if known == enclosing => (),
            _ => {
                let observed = Arc::new(traced_scene(scene, enclosing));
                self.observed = Some((Arc::clone(enclosing), observed));
            }
        }
        self.observed.as_ref().map(|(_, observed)| Arc::clone(observed))
    }

    /// Returns the objects whose shape changed, or `None` if the scene must be rebuilt.
    fn changed(&self, good: &GoodWorld, document: &Document) -> Option<Vec<(u32, Object)>> {
        let GoodWorld { scene, .. } = good;
        let is_same_kind = scene.spheres().len() == document.sphere_count()
            && scene.planes().len() == document.planes.len()
            && self.csv == document.csv_spheres;
        if !is_same_kind {
            return None;
        }
        let spheres = different(&document.spheres, scene.spheres(), 0, Object::Sphere);
        let first = document.sphere_count() as u32;
        let planes = different(&document.planes, scene.planes(), first, Object::Plane);
        let changed: Vec<(u32, Object)> = spheres.chain(planes).take(FEW + 1).collect();
        (changed.len() <= FEW).then_some(changed)
    }

    fn make(&mut self, document: &Document) -> Result<(), SceneError> {
        let scene = Arc::new(document.scene()?);
        let colors = colors(document, self.scheme);
        let next = |number: fn(&GoodWorld) -> u64| self.good.as_ref().map_or(0, number) + 1;
        let (generation, palette) = (next(|good| good.generation), next(|good| good.palette));
        self.good = Some(GoodWorld { scene, colors: Arc::new(colors), generation, palette });
        self.observed = None;
        Ok(())
    }
}

/// Returns the colours of all objects.
fn colors(document: &Document, scheme: Scheme) -> Vec<Rgb> {
    let all = 0..document.object_count() as u32;
    all.map(|index| scheme.object(index, document.color_of(index))).collect()
}

/// Checks the objects that can be edited. The spheres of the CSV file were checked when they were read.
fn check(document: &Document) -> Result<(), SceneError> {
    for (index, item) in document.spheres.iter().enumerate() {
        Object::Sphere(item.shape).check_at(index)?;
    }
    for (index, item) in (document.sphere_count()..).zip(document.planes.iter()) {
        Object::Plane(item.shape).check_at(index)?;
    }
    Ok(())
}

/// Returns the items whose shape differs from the known shape at the same index, with their indices.
fn different<'a, S: Copy + PartialEq>(
    items: &'a [Item<S>],
    known: &'a [S],
    first: u32,
    object: fn(S) -> Object,
) -> impl Iterator<Item = (u32, Object)> + 'a {
    let all = (first..).zip(items.iter().zip(known));
    all.filter(|(_, (item, known))| item.shape != **known)
        .map(move |(index, (item, _))| (index, object(item.shape)))
}

/// Replaces the shapes of some objects by new ones, which are valid, in the scene and in the observer's
/// scene.
fn replace(
    good: &mut GoodWorld,
    observed: Option<&mut (Enclosing, Arc<Scene>)>,
    changed: &[(u32, Object)],
) -> Result<(), SceneError> {
    let scene = Arc::make_mut(&mut good.scene);
    for &(index, object) in changed {
        scene.replace(index, object)?;
    }
    good.generation += 1;
    let Some((enclosing, observed)) = observed else { return Ok(()) };
    let observed = Arc::make_mut(observed);
    for &(index, object) in changed {
        if let Object::Sphere(sphere) = object {
            // Spheres around the camera are hidden from the observer.
            let is_around = enclosing.binary_search(&index).is_ok();
            let sphere = if is_around { hidden(&sphere) } else { sphere };
            observed.replace(index, Object::Sphere(sphere))?;
        }
    }
    Ok(())
}

/// Updates the colours of the objects that can be edited.
fn recolor(good: &mut GoodWorld, document: &Document, scheme: Scheme) {
    let planes = document.sphere_count()..document.object_count();
    let mut is_changed = false;
    for index in (0..document.spheres.len()).chain(planes) {
        let color = scheme.object(index as u32, document.color_of(index as u32));
        if good.colors[index] != color {
            Arc::make_mut(&mut good.colors)[index] = color;
            is_changed = true;
        }
    }
    good.palette += u64::from(is_changed);
}
