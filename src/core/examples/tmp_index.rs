use pinhole_core::*;
use std::time::Instant;
fn main() {
    let n: usize = std::env::args().nth(1).unwrap().parse::<f64>().unwrap() as usize;
    let kind = std::env::args().nth(2).unwrap_or("one".into());
    let mut s = 1u64;
    let mut next = || {
        s ^= s << 13;
        s ^= s >> 7;
        s ^= s << 17;
        (s >> 11) as f64 / (1u64 << 53) as f64
    };
    let spheres: Vec<Sphere> = (0..n)
        .map(|_| {
            let c = DVec3::new(next(), next(), next()) * 200.0;
            let r =
                if kind == "log" { 10f64.powf(-3.0 + 6.0 * next()) } else { 0.3 + 0.2 * next() };
            Sphere { center: c, radius: r }
        })
        .collect();
    let rss = || {
        let t = std::fs::read_to_string("/proc/self/status").unwrap();
        t.lines()
            .filter(|l| l.starts_with("VmRSS") || l.starts_with("VmHWM"))
            .map(|l| l.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap())
            .collect::<Vec<_>>()
    };
    let p = DVec3::splat(100.0);
    let mut times = vec![];
    for _ in 0..5 {
        let scene = Scene::new(spheres.clone(), vec![]).unwrap();
        let t = Instant::now();
        std::hint::black_box(scene.spheres_around(p).len());
        times.push(t.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    println!("threads {} build ms {times:.1?}", rayon::current_num_threads());
    let t = Instant::now();
    let mut scene = Scene::new(spheres, vec![]).unwrap();
    println!("Scene::new {:.2} ms", t.elapsed().as_secs_f64() * 1e3);
    let before = rss();
    scene.spheres_around(p);
    let after = rss();
    println!(
        "bytes a sphere {:.1} (rss {before:?} {after:?} kB)",
        (after[1].max(after[0]) - 0.0 - before[1]) * 1024.0 / n as f64
    );
    let t = Instant::now();
    let mut c = 0;
    for i in 0..1000 {
        c += scene.spheres_around(p + DVec3::splat(i as f64 * 0.01)).len();
    }
    println!("around us {:.2} ({c})", t.elapsed().as_secs_f64() * 1e3);
    let t = Instant::now();
    for i in 0..10000u64 {
        let k = (i * 7919) % n as u64;
        let o = scene.spheres()[k as usize];
        scene.replace_sphere(k as u32, Sphere { center: o.center + DVec3::X * 0.1, ..o }).unwrap();
    }
    println!("replace us {:.3}", t.elapsed().as_secs_f64() * 1e2);
    for _ in 0..4 {
        let t = Instant::now();
        let shared = scene.clone();
        let o = scene.spheres()[5];
        scene.replace_sphere(5, Sphere { center: o.center + DVec3::X * 0.1, ..o }).unwrap();
        println!("replace while shared ms {:.2}", t.elapsed().as_secs_f64() * 1e3);
        let t = Instant::now();
        drop(shared);
        println!("drop of the shared ms {:.2}", t.elapsed().as_secs_f64() * 1e3);
    }
}
