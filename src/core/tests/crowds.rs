//! Every pixel of crowds of spheres is right: the object that its ray hits first, and its `t`.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking and tells what it has looked at"
)]

mod common;
mod support;

use pinhole_core::*;
use support::crowds;
use support::every_pixel::{check, every_pixel_is_right};

#[test]
fn crowds_are_right() {
    let mut failed = Vec::new();
    for crowd in crowds::all() {
        let start = std::time::Instant::now();
        let frame = crowd.trace();
        match check(&crowd.scene, &crowd.camera, &frame) {
            Ok(checked) => {
                println!("{:<30} {:>5} ms {checked:?}", crowd.name, start.elapsed().as_millis());
                if checked.objects < crowd.objects {
                    failed.push(crowd.name);
                }
            }
            Err(faults) => {
                println!("{}: {} FAULTS", crowd.name, faults.len());
                for (_, fault) in faults.iter().take(5) {
                    println!("    {fault}");
                }
                failed.push(crowd.name);
            }
        }
    }
    assert!(failed.is_empty(), "{failed:?}");
}
