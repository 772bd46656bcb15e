//! What the window reads, against broken texts: lessons, pastes, typed arithmetic, the remembered state.

use std::path::Path;

use pinhole::features::translator::state::pasted;
use pinhole::model::expression::evaluate;
use pinhole::model::lessons::{builtin, parse};
use pinhole::model::store::{Remembered, Store};
use pinhole_core::Camera;

use crate::mutants::{Reader, fuzz};

const READERS: [Reader; 4] = [
    ("lesson", |bytes| {
        let text = String::from_utf8_lossy(bytes);
        let error = parse(&text, Path::new("in"), None).err();
        error.map(|error| error.to_string()).into_iter().collect()
    }),
    ("paste", |bytes| {
        let (camera, said) = pasted(&String::from_utf8_lossy(bytes), &Camera::CANONICAL);
        assert!(camera.is_none_or(|camera| camera.eye.is_finite()));
        said.notes
    }),
    ("expression", |bytes| {
        let text = String::from_utf8_lossy(bytes);
        let said = text.lines().map(|line| evaluate(line.rsplit('=').next().unwrap_or(line)));
        said.filter_map(Result::err).collect()
    }),
    ("state", |bytes| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state.json");
        std::fs::write(&path, bytes).unwrap();
        let before = Store::at(&path).load();
        let state = Remembered { renderer: "another".to_owned(), ..before.clone() };
        assert_eq!(Store::at(&path).save(&before, &state), Ok(()));
        assert_eq!(Store::at(&path).load().renderer, state.renderer);
        Vec::new()
    }),
];

#[test]
fn no_text_makes_the_window_panic_stall_or_chatter() {
    let mut samples: Vec<Vec<u8>> = builtin::FILES.iter().map(|(_, text)| (*text).into()).collect();
    let cameras = [
        "glm::lookAt(glm::vec3(4, 3, 3), glm::vec3(0), glm::vec3(0, 1, 0));\n\
         glm::perspective(glm::radians(45.0f), 4.0f / 3.0f, 0.1f, 100.0f);\n",
        "gluPerspective(60, 1.5, 0.1, 9);\ngluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\n",
        "a = sqrt(2)/2\nb = -(1 + 2*pi)^2 / tan(0.5)\nc = 1e-300\n",
    ];
    samples.extend(cameras.map(|text| text.as_bytes().to_vec()));
    samples.push(serde_json::to_vec_pretty(&Remembered::default()).unwrap());
    fuzz(&samples, &READERS);
}
