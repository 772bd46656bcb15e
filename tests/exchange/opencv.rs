//! OpenCV's K, R and t as people write them: understood to the end of each statement, or refused.

use std::fs;
use std::path::Path;

use pinhole::exchange::{Text, recognised_file};
use pinhole_core::{Camera, DVec3, ImageSize};

use super::programs::{output, python, python_with, script};
use super::read;

const K: &str = "K = np.array([[500, 0, 320], [0, 500, 240], [0, 0, 1.0]])\n";
const POSE: &str = "R = np.eye(3)\nt = np.array([0, 0, 5.0])\n";
const TURNED: &str = "R = [[0.8, 0, -0.6], [0, 1, 0], [0.6, 0, 0.8]]\n";

/// The same camera in the plainest words.
fn plain(k: &str, r: &str, t: &str) -> String {
    format!("K = [{k}]\nR = [{r}]\nt = [{t}]\n")
}

const PLAIN_K: &str = "500, 0, 320, 0, 500, 240, 0, 0, 1";
const ONE: &str = "1, 0, 0, 0, 1, 0, 0, 0, 1";

#[track_caller]
fn assert_same(text: &str, plain: &str) {
    let file = Text { path: Path::new("camera.py"), text };
    assert_eq!(recognised_file(&file).map(|format| format.name).unwrap(), "opencv", "{text}");
    let [one, other] = [text, plain].map(|text| {
        read("opencv", text).unwrap_or_else(|error| {
            panic!("{error} in\n{text}");
        })
    });
    let [a, b] = [&one, &other].map(|taken| taken.camera.resolve().unwrap());
    assert_eq!(one.camera.image, other.camera.image, "{text}");
    let size = b.eye().length().max(1.0);
    assert!((a.eye() - b.eye()).length() < 1e-9 * size, "{} {} for {text}", a.eye(), b.eye());
    let (a, b) = (a.basis(), b.basis());
    for (a, b) in [(a.u, b.u), (a.v, b.v), (a.w, b.w)] {
        assert!((a - b).length() < 1e-9, "{a} {b} for {text}");
    }
    let [a, b] = [one, other].map(|taken| taken.camera.viewport);
    assert!((a.width - b.width).abs() < 1e-9 && (a.height - b.height).abs() < 1e-9, "{text}");
}

/// Valid Python, which comes to what Python makes of it.
fn snippets() -> Vec<String> {
    let turned = TURNED.replace("R = [[", "R = np.array([[").replace("]]", "]])");
    let own = [
        "K = np.eye(3)\nK[0, 0] = 500\nK[1, 1] = 500; K[0, 2] = 320\nK[1][2] = 240\n",
        "K = np.diag([500, 500, 1])\nK[:2, 2] = [320, 240.0]\n",
        "fx, fy, cx, cy = 525.0, 525.0, 319.5, 239.5\nK = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])\n",
        "K = np.array([[1000, 0, 640], [0, 1000, 360], [0, 0, 2.0]]) / 2\n",
        "K: np.ndarray = np.array([[500, 0, 320], [0, 500, 240], [0, 0, 1.0]])\n",
        "camera_matrix = np.array([[800, 0, 320], [0, 800, 240], [0, 0, 1]], dtype=\"double\")\n",
        "W, H = 640, 480\nf = 0.5 * W / np.tan(np.radians(60) / 2)\n\
         K = np.array([\n    [f, 0, W / 2 -0.5],\n    [0, f, H / 2 -0.5],\n    [0, 0, 1]])\n",
        "K = np.float32([[1000, 0, 640], [0, 1000, 480], [0, 0, 1]])\nK[:2] *= 0.5\n",
        "K = np.array([[1e3, 1e-14, 319.5], [0, 1e3, 239.5], [0, 0, 1]])\n",
    ];
    let mut all: Vec<String> = own.iter().map(|k| format!("{k}{POSE}")).collect();
    for pose in [
        "R = np.array([[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]]).T\nt = np.array([0, 0, 5.0])\n",
        "rvec = np.deg2rad([0, 45, 0])\ntvec = np.array([0, 0, 5.0])\nR, _ = cv2.Rodrigues(rvec)\n",
        "rvec = np.array([0, 45, 0]) * np.pi / 180\ntvec = np.array([0, 0, 5.0])\n",
        "R = np.diag([1, -1, -1])\nt = np.array([0, 0, 5000.0]) / 1000\n",
        "R = cv2.Rodrigues(np.array([0.1, -0.4, 0.2]))[0]\nt = np.array([[0.5], [-0.25], [5.0]])\n",
        "c2w = np.array([[0.8,0,0.6,1],[0,1,0,2],[-0.6,0,0.8,3],[0,0,0,1]])\n\
         w2c = np.linalg.inv(c2w)\nR = w2c[:3,:3]\nt = w2c[:3, 3]\n",
        "R = np.array([[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]]).transpose()\nC = np.array([1, 2, 3.0])\n\
         t = -R @ C\nrvec, _ = cv2.Rodrigues(R)\n",
        "rotation_vector = np.array([[0.1],[0.2],[0.3]])\ntranslation_vector = np.zeros((3, 1))\n",
        "R = np.array([[1,0,0],[0,1,0],[0,0,1.]])\nt = np.array([1,2,3.])\n\
         Rt = np.hstack([R, t.reshape(3,1)])\nP = K @ Rt\n",
        "Rt = np.vstack((np.column_stack((np.eye(3), [1, 2, 3])), [0, 0, 0, 1]))\n",
        "a = np.radians(30)\nR = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])\n\
         flip = np.diag([1, -1, -1])\nR = flip @ R\nt = np.array([0, 0, 5])\nt = 2 * t\nt[0] = -1\n",
        "rvecs = [np.array([0.1, 0, 0])]\ntvecs = [np.array([0, 0, 5.0])]\n\
         R, t = cv2.Rodrigues(rvecs[0])[0], tvecs[0]\n",
        "R = (np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]])\n     .T)\nt = np.array([0, 0, 5.0])[:, None]\n\
         t[2] += 1; t[-1] -= .5\n",
        "R = np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]])\nt = np.array([1, 2, 3])\nR, t = R.T, -R.T @ t\n\
         u = t.copy()\nu[0] = 4\nu = t\nu = 5\nfx = K[0, 0]\nfx *= 2\n",
        "w, h = 640, 480\nheight, width = 480, 640\nR = np.eye(3)\nt = np.zeros(3)\nt += [0, 0, 4]\n",
    ] {
        all.push(format!("{K}{pose}"));
    }
    all.push(format!("{K}{turned}t = np.zeros((3, 1))\ndist_coeffs = np.zeros((4, 1))\n"));
    all
}

#[test]
fn python_s_statements_come_to_what_they_come_to_in_python() {
    for text in snippets() {
        assert!(read("opencv", &text).is_ok(), "{}\n{text}", read("opencv", &text).unwrap_err());
    }
    if !python_with("opencv", "cv2") {
        return;
    }
    for text in snippets() {
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(file.path(), &text).unwrap();
        let mut run = python();
        let theirs = output(run.arg(script("opencv_snippet.py")).arg(file.path()));
        assert_same(&text, &theirs);
    }
}

#[test]
fn a_value_is_understood_to_its_end() {
    let five = plain(PLAIN_K, ONE, "0, 0, 5");
    assert_same(
        &format!("{K}R = np.diag([1, 1, 1])\nt = np.array([0, 0, 5000.0]) / 1000\n"),
        &five,
    );
    let elements = "K = np.eye(3)\nK[0, 0] = K[1, 1] = 500\n";
    let message = read("opencv", &format!("{elements}{POSE}")).unwrap_err().to_string();
    assert_eq!(
        message,
        "in:1:5: K is np.eye(3): it must be 3 × 3 numbers, and K[1, 1] = 500 is not understood here"
    );
    let right = "it must be three numbers, and";
    for (t, said) in [
        ("np.array([0, 0, 5000.0]) // 1000", "// 1000 is not understood here"),
        ("load('t.npy')", "load('t.npy') is not understood here"),
        (
            "np.array([0, 0, 5.5], dtype=int)",
            "np.array([0, 0, 5.5], dtype=int) is not understood here",
        ),
        ("a if far else b", "a is not understood here"),
        ("[0, 0, 5] ** 2", "** 2 is not understood here"),
        ("-R.T @ C", "C is not understood here"),
        (
            "np.array([0, 0, 1e308]) * 1e308",
            "np.array([0, 0, 1e308]) * 1e308 is not understood here",
        ),
    ] {
        let text = format!("{K}R = np.eye(3)\nt = {t}\n");
        assert_eq!(
            read("opencv", &text).unwrap_err().to_string(),
            format!("in:3:5: t is {t}: {right} {said}")
        );
    }
}

#[test]
fn what_may_hold_or_not_is_refused() {
    let right = "it must be three numbers, and";
    let pose = "R = np.eye(3)\nt = np.array([0, 0, 5.0])\n";
    let changed = |line: usize| {
        format!(
            "in:3:5: t is np.array([0, 0, 5.0]): {right} line {line} changes it in a way not understood here"
        )
    };
    for (after, line) in [
        ("t.fill(3)\n", 4),
        ("np.negative(t, out=t)\n", 4),
        ("u = t\nu[0] = 9\n", 5),
        ("u = t[:2]\nu *= 2\n", 5),
        ("if far:\n    t[2] = 9\n", 5),
        ("if far: t = [0, 0, 9]\n", 4),
        ("for t in range(3):\n    pass\n", 4),
        ("t **= 2\nt[0] = f(3)\n", 5),
        ("cv2.solvePnP(points, seen, K, None, rvec, t, True)\n", 4),
    ] {
        let text = format!("{K}{pose}{after}");
        let error = read("opencv", &text).unwrap_err().to_string();
        if after.contains("f(3)") {
            assert!(error.contains("f(3) is not understood"), "{error}");
        } else {
            assert_eq!(error, changed(line), "{after}");
        }
    }
    let twice = format!("{K}R = np.eye(3)\nif far:\n    t = [0, 0, 9]\nelse:\n    t = [0, 0, 1]\n");
    assert_eq!(
        read("opencv", &twice).unwrap_err().to_string(),
        format!(
            "in:6:9: t is [0, 0, 1]: {right} it is given in lines 4 and 6, and only one of them may hold"
        )
    );
    let two = "[{\"K\": [[500, 0, 320], [0, 500, 240], [0, 0, 1]]}, {\"K\": [[9, 0, 4], [0, 9, 4], [0, 0, 1]]}]";
    assert!(read("opencv", two).unwrap_err().problem.contains("only one of them may hold"));
    let other = format!("{K}R = np.eye(3)\nrvec = [0, 1, 0]\nt = [0, 0, 1]\n");
    assert_eq!(
        read("opencv", &other).unwrap_err().to_string(),
        "in:3:8: rvec is [0, 1, 0]: R is another rotation: only one of them may be given"
    );
    let angles = format!("{K}R = [0, 45, 0]\nt = [0, 0, 1]\n");
    assert_eq!(
        read("opencv", &angles).unwrap_err().to_string(),
        "in:2:5: R is [0, 45, 0]: it must be 3 × 3 numbers"
    );
    let degrees = read("opencv", &format!("{K}rvec = [0, 45, 0]\nt = [0, 0, 1]\n")).unwrap();
    assert!(degrees.notes.iter().any(|note| note.starts_with("rvec turns by more than")));
}

#[test]
fn c_plus_plus_printed_arrays_and_dictionaries() {
    let five = plain(PLAIN_K, ONE, "0, 0, 5");
    for text in [
        "cv::Mat K = (cv::Mat_<double>(3,3) << 500, 0, 320, 0, 500, 240, 0, 0, 1); // K\n\
         cv::Mat rvec = (cv::Mat_<double>(3,1) << 0.0, 0.0, 0.0);\n\
         cv::Mat tvec = (cv::Mat_<double>(3,1) << 0, 0, 5);\n\
         cv::projectPoints(pts, rvec, tvec, K, cv::noArray(), out);\n",
        "cv::Matx33d K(500, 0, 320,\n    0, 500, 240,\n    0, 0, 1);\ncv::Vec3d rvec(0, 0, 0), zero;\n\
         cv::Vec3d t = cv::Vec3d(0, 0, 5);\n",
        "const double fx = 500, fy = 500.0f;\nint main() {\n  cv::Mat K = cv::Mat::eye(3, 3, CV_64F);\n  \
         K.at<double>(0, 0) = fx; K.at<double>(1, 1) = fy;\n  K.at<double>(0, 2) = 320;\n  \
         K.at<double>(1, 2) = (double)480 / 2;\n  cv::Mat rvec = cv::Mat::zeros(3, 1, CV_64F), R;\n  \
         cv::Rodrigues(rvec, R);\n  cv::Mat t = (cv::Mat_<double>(1, 3) << 0, 0, 5);\n}\n",
        "double K[3][3] = {{500, 0, 320}, {0, 500, 240}, {0, 0, 1}}; // cv::Mat\n\
         double R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};\nfloat t[3] = {0.f, 0.f, 5.f};\n",
        "K = [[500.   0. 320.]\n [  0. 500. 240.]\n [  0.   0.   1.]]\nR = [[1. 0. 0.]\n [0. 1. 0.]\n [0. 0. 1.]]\n\
         t = [ 0. -0.  5.]\n",
        "K:\n[[500.   0. 320.]\n [  0. 500. 240.]\n [  0.   0.   1.]]\nrvec:\n [[0.]\n [0.]\n [0.]]\ntvec: [[0. 0. 5.]]\n",
        "K = [500 0 320; 0 500 240; 0 0 1];\nR = eye(3);\nt = [0; 0; 5];\n",
        "camera = {'K': [[500, 0, 320], [0, 500, 240], [0, 0, 1]], 'R': np.eye(3), 't': (0, 0, 5)}\n",
        "camera = Camera(K=np.array([[500, 0, 320], [0, 500, 240], [0, 0, 1]]), R=np.eye(3), t=[0, 0, 5])\n",
        "self.K = np.array([[500, 0, 320], [0, 500, 240], [0, 0, 1]])\nself.R = np.eye(3)\nself.t = [0, 0, 5]\n",
        "{\"camera_matrix\": {\"type_id\": \"opencv-matrix\", \"rows\": 3, \"cols\": 3, \"data\": [500, 0, \
         320, 0, 500, 240, 0, 0, 1]},\n\"rvec\": [0, 0, 0], \"tvec\": [0, 0, 5]}",
        "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nrvec: [0, 0, 0]\n\
         tvec: [0, 0, 5]\n",
    ] {
        assert_same(text, &five);
    }
    let changed = "cv::Matx33d K(500, 0, 320, 0, 500, 240, 0, 0, 1);\nK(0, 2) = centre(3);\n\
                   cv::Vec3d rvec(0, 0, 0), t(0, 0, 5);\n";
    let error = read("opencv", changed).unwrap_err().to_string();
    assert!(error.ends_with("centre(3) is not understood here"), "{error}");
}

#[test]
fn the_size_may_be_missing_but_is_not_made_of_nothing() {
    for size in ["h, w = img.shape[:2]\n", "w = h = 5.5\n", "h = 1.6  # above the ground\n", ""] {
        let taken = read("opencv", &format!("{size}{K}{POSE}")).unwrap();
        assert_eq!(taken.camera.image, ImageSize::new(640, 480).unwrap(), "{size}");
        assert!(taken.notes[0].starts_with("the image's size is not given: 640 × 480"), "{size}");
    }
    let given = read("opencv", &format!("w, h = 800, 600\n{K}{POSE}")).unwrap();
    assert_eq!(given.camera.image, ImageSize::new(800, 600).unwrap());
    for k in ["np.eye(3)", "np.array([[1.2, 0, 0.5], [0, 1.6, 0.5], [0, 0, 1]])"] {
        let error = read("opencv", &format!("K = {k}\n{POSE}")).unwrap_err().to_string();
        assert!(error.starts_with("in: width is missing: K's principal point is (0"), "{error}");
    }
    let given = read("opencv", &format!("K = np.eye(3)\nwidth = 40\nheight = 30\n{POSE}")).unwrap();
    assert!(given.notes[0].starts_with("the principal point is -19.5 pixels right"));
}

/// Brackets in brackets, names of names, and names that are changed again and again.
#[test]
fn hostile_values_end() {
    let many = 100_000;
    let chain: String = (1..5000).map(|k| format!("a{k} = a{} + a{}\n", k - 1, k - 1)).collect();
    let doubled: String =
        (1..40).map(|k| format!("a{k} = np.hstack([a{}, a{}])\n", k - 1, k - 1)).collect();
    for text in [
        format!("K = {}{}\n", "[".repeat(many), "]".repeat(many)),
        format!("K = {}1{}\n", "(".repeat(many), ")".repeat(many)),
        format!("K = {}1\n", "(float)".repeat(many)),
        format!("K = {}1\n", "-".repeat(many)),
        format!("K = [{}]\n", "1, ".repeat(many)),
        "K = K\n".repeat(many),
        "K = ".repeat(many),
        format!("K = np.eye(3)\n{}", "K[0, 0] = 3\n".repeat(many)),
        "if a:\n  K = 3\n".repeat(many),
        format!("a0 = 1\n{chain}K = a4999\n"),
        format!("a0 = [1, 2]\n{doubled}K = a39\n"),
        "K, ".repeat(many),
        "K: ".repeat(many),
        "Rodrigues(a, K)\n".repeat(many),
    ] {
        let error = read("opencv", &format!("{text}\n{POSE}"));
        assert!(error.is_err(), "{}", &text[..40]);
    }
}

#[test]
fn a_mirrored_world_is_turned_over() {
    let text = format!("{K}R = np.diag([1, 1, -1])\nt = np.array([0, 0, 5.0])\n");
    let taken = read("opencv", &text).unwrap();
    assert!(taken.notes.iter().any(|note| note.starts_with("its world is left-handed")));
    let Camera { eye, .. } = taken.camera;
    assert_eq!(eye, DVec3::new(0.0, 0.0, -5.0));
}
