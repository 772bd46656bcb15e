//! Every reader of files against broken ones.

use std::path::Path;

use pinhole_core::{Camera, ImageSize};
use pinhole_exchange::csv::{rays, spheres};
use pinhole_exchange::format::Input;
use pinhole_exchange::format::{ExportScene, Include};
use pinhole_exchange::images::png;
use pinhole_exchange::programs::{FORMATS, Importer};
use pinhole_exchange::{FileError, answers, scene_file, scenes};

use crate::common::mutants::{Reader, fuzz};

const READERS: [Reader; 5] = [
    ("scene", |bytes| with_text(bytes, scene)),
    ("importers", |bytes| with_text(bytes, every_importer)),
    ("spheres", |bytes| told(spheres(Path::new("in"), bytes).err())),
    ("rays", |bytes| told(rays(Path::new("in"), bytes).err())),
    ("answers", |bytes| {
        let image = ImageSize::new(40, 30).unwrap();
        told(answers::parse(Path::new("in"), bytes, image, 0).err())
    }),
];

fn told(errors: impl IntoIterator<Item = FileError>) -> Vec<String> {
    errors.into_iter().map(|error| error.to_string()).collect()
}

fn with_text(bytes: &[u8], read: fn(&str) -> Vec<String>) -> Vec<String> {
    std::str::from_utf8(bytes).map_or_else(|_| Vec::new(), read)
}

fn scene(text: &str) -> Vec<String> {
    // The folder has no files, so that no CSV is found.
    match scene_file::parse(text, Path::new("in"), Path::new("no-such-folder")) {
        Err(error) => told([error]),
        Ok(document) => {
            let again = scene_file::to_text(&document, Some(text));
            let read = scene_file::parse(&again, Path::new("in"), Path::new("no-such-folder"));
            assert_eq!(read.unwrap(), document, "saved and read again");
            Vec::new()
        }
    }
}

fn every_importer(text: &str) -> Vec<String> {
    let input = Input { path: Path::new("in"), text };
    let mut messages = Vec::new();
    let detected = Importer::of(text);
    for importer in [Importer::Gltf, Importer::Literal].into_iter().chain(detected) {
        match importer.read(&input, &Camera::CANONICAL) {
            Ok(taken) => {
                assert!(taken.camera.resolve().is_ok(), "{}", importer.label());
                messages.extend(taken.notes);
            }
            Err(error) => messages.push(error.to_string()),
        }
    }
    messages
}

/// What people write.
fn samples() -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = Vec::new();
    for builtin in scenes::BuiltinScene::all() {
        all.push(builtin.text.into());
        let document = builtin.load().unwrap();
        let Ok(subject) = ExportScene::new(&document, Include::Objects) else { continue };
        let written = FORMATS.iter().filter_map(|format| format.write(&subject).ok());
        all.extend(written.map(|written| written.text.text.into_bytes()));
    }
    let texts = [
        "glm::mat4 view = glm::lookAt(glm::vec3(4, 3, 3), // eye\n  glm::vec3(0, 0, 0), glm::vec3(0, 1, 0));\n",
        "gluLookAt(0, 0, 5, 0, 1, 0, 0, 1, 0);\n",
        "K = [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]]\nR = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]])\n\
         t = [0, 0, 5]\n",
        "c2w = [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]\n",
        "1 2 3 0 0 0 0 1 0 45\n",
        "x,y,z,r,color,name\n0,0,-5,1,#e69f00,\"a, b\"\n1,0,-6,0.5,,\n",
        "ox,oy,oz,dx,dy,dz\n0,0,0,0,0,-1\n1,2,3,4,5,6\n",
        "ux,uy,uz,vx,vy,vz,wx,wy,wz\n1,0,0,0,1,0,0,0,1\n",
        "row,column,ox,oy,oz,dx,dy,dz\n0,1,0,0,0,0,0,-1\n",
        "row,column,t,x,y,z,object\n0,1,4,0,0,-4,0\n2,3,,,,,\n",
    ];
    all.extend(texts.map(|text| text.as_bytes().to_vec()));
    let mut picture = Vec::new();
    png::encode(&mut picture, [40, 30], &[[1, 2, 3, 255]; 1200], false).unwrap();
    all.push(picture);
    all
}

#[test]
fn no_text_makes_a_reader_panic_stall_or_chatter() {
    fuzz(&samples(), &READERS);
}
