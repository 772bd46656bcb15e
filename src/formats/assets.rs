//! Files of the folder `assets`, as a part of the program.

/// A list of the files `assets/FOLDER/NAME.toml`, each as a struct with `name` and `text`.
macro_rules! embedded {
    ($file:ident, $folder:literal, [$($name:literal),* $(,)?]) => {
        &[$($file {
            name: $name,
            text: include_str!(concat!(
                env!("CARGO_MANIFEST_DIR"), "/assets/", $folder, "/", $name, ".toml"
            )),
        }),*]
    };
}

pub(crate) use embedded;
