//! OpenGL programs: which call is the camera's, and what is not read.

use pinhole_core::DVec3;

use super::read;

const LENS: &str = "gluPerspective(45.0, 4.0 / 3.0, 0.1, 100.0);\n";
const LOOK: &str = "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\n";

#[track_caller]
fn assert_refused(text: &str, message: &str) {
    let error = read("opengl", text).unwrap_err().to_string();
    assert!(error.contains(message), "{error}: {text}");
}

fn eye(text: &str) -> DVec3 {
    read("opengl", text).unwrap().camera.eye
}

#[test]
fn of_several_calls_the_camera_s_is_taken() {
    let look = |name: &str, x: u8| {
        format!(
            "glm::mat4 {name} = glm::lookAt(glm::vec3({x}, 3, 3), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0));\n"
        )
    };
    let lens = |name: &str, degrees: u8| {
        format!(
            "glm::mat4 {name} = glm::perspective(glm::radians({degrees}.0f), 1.5f, 0.1f, 100.0f);\n"
        )
    };
    let text =
        [lens("proj", 60), look("view", 4), lens("shadowProj", 90), look("lightView", 9)].concat();
    let taken = read("opengl", &text).unwrap();
    assert_eq!(taken.camera.eye.x, 4.0);
    assert!((taken.camera.viewport.vertical_fov().to_degrees() - 60.0).abs() < 1e-12);
    let told = [
        "2 calls of lookAt: that of view is taken",
        "2 calls of perspective: that of proj is taken",
    ];
    assert_eq!(taken.notes[..2], told);
    let unnamed = [lens("proj", 60), look("a", 4), look("b", 9)].concat();
    assert_refused(&unnamed, "one of 2 different calls: leave in that of the camera");
    assert_refused(
        &format!("{LENS}{LOOK}{}", LOOK.replace('5', "9")),
        "in:3:11: gluLookAt is 0, 0, 9",
    );
    assert_eq!(eye(&format!("{LENS}{LOOK}{LOOK}")).z, 5.0);
}

#[test]
fn what_is_not_run_is_not_read() {
    let old = LOOK.replace('5', "9");
    assert_eq!(eye(&format!("{LENS}{LOOK}#if 0\n{old}#endif\n")).z, 5.0);
    assert_eq!(eye(&format!("{LENS}#if 0\n{old}#else\n{LOOK}#endif\n")).z, 5.0);
    assert_eq!(eye(&format!("{LENS}#if 1\n{LOOK}#if X\n#endif\n#else\n{old}#endif\n")).z, 5.0);
    let python = format!("{LENS}{LOOK}# {old}").replace(';', "");
    assert_eq!(eye(&python).z, 5.0);
    assert_eq!(eye(&format!("from OpenGL.GLU import *\n{python}")).z, 5.0);
    assert_eq!(eye(&format!("def f():\n  pass\n{LENS}{LOOK}# {old}")).z, 5.0);
}

#[test]
fn an_aspect_that_is_no_number_is_told() {
    let text = format!("{}{LOOK}", LENS.replace("4.0 / 3.0", "(GLfloat) w/(GLfloat) h"));
    let taken = read("opengl", &text).unwrap();
    assert_eq!(
        taken.notes[0],
        "aspect is (GLfloat) w/(GLfloat) h, which is no number: 400 / 400 taken"
    );
    assert_eq!(taken.camera.viewport.width, taken.camera.viewport.height);
    let sized = read("opengl", &format!("glViewport(0, 0, 800, 400);\n{text}")).unwrap();
    let ratio = sized.camera.viewport.width / sized.camera.viewport.height;
    assert!((ratio - 2.0).abs() < 1e-15, "{ratio}");
    // C divides whole numbers without a fraction, Python does not.
    let whole = format!("{}{LOOK}", LENS.replace("4.0 / 3.0", "800/600"));
    assert_refused(
        &whole,
        "in:1:22: aspect is 800/600: C divides whole numbers without a fraction",
    );
    assert!(read("opengl", &whole.replace(';', "")).is_ok());
}

#[test]
fn degrees_where_glm_counts_in_radians_are_told() {
    let text = "glm::mat4 P = glm::perspective(45.0f, 4.0f / 3.0f, 0.1f, 100.0f);\n\
                glm::mat4 V = glm::lookAt(glm::vec3(4,3,3), glm::vec3(0,0,0), glm::vec3(0,1,0));";
    assert_refused(
        text,
        "in:1:32: fovy is 45.0f: GLM counts in radians, and 45 radians are 2578 degrees: write glm::radians(45.0f)",
    );
}

#[test]
fn what_moves_the_world_before_the_camera_is_refused() {
    assert_refused(
        &format!("{LENS}glTranslatef(0, 0, -6);\n{LOOK}"),
        "glTranslate stands before it",
    );
    assert_eq!(
        eye(&format!(
            "{LENS}glTranslatef(0, 0, -6);\nglLoadIdentity();\n{LOOK}glRotatef(1, 0, 0, 1);\n"
        ))
        .z,
        5.0
    );
    let glm = "auto P = glm::perspective(1.0f, 1.5f, 0.1f, 100.0f);\n\
               view = glm::lookAt(glm::vec3(4,3,3), glm::vec3(0,0,0), glm::vec3(0,1,0));\n";
    assert_refused(
        &format!("{glm}view = glm::rotate(view, 1.0f, glm::vec3(0,1,0));\n"),
        "the camera's matrix is changed after lookAt",
    );
}

#[test]
fn glmatrix_and_sums_of_points_are_read() {
    let text = "const view = mat4.create();\nmat4.perspective(proj, 45 * Math.PI / 180, 640 / 480, 0.1, 100.0);\n\
                mat4.lookAt(view, [0, 2, 5], [0, 0, 0], [0, 1, 0]);\n";
    assert_eq!(eye(text), DVec3::new(0.0, 2.0, 5.0));
    let text = "glm::vec3 pos = glm::vec3(1.0f, 0.0f, 3.0f);\nglm::vec3 front = glm::vec3(0.0f, 0.0f, -1.0f);\n\
                auto p = glm::perspective(1.0f, 1.5f, 0.1f, 100.0f);\n\
                auto view = glm::lookAt(pos, pos + front, glm::vec3(0, 1, 0));\n";
    assert_eq!(read("opengl", text).unwrap().camera.view(), DVec3::NEG_Z);
}

const GLM_LENS: &str = "glm::mat4 proj = glm::perspective(1.0f, 1.5f, 0.1f, 100.0f);\n";
const GLM_LOOK: &str = "glm::lookAt(glm::vec3(4,3,3), glm::vec3(0,0,0), glm::vec3(0,1,0))";

#[test]
fn a_look_at_that_is_a_part_of_something_else_is_refused() {
    for (statement, message) in [
        ("view = X * glm::rotate(glm::mat4(1), 0.3f, axis);", "it is multiplied: the camera's"),
        ("view = X * roll;", "it is multiplied"),
        ("view = roll * X;", "it is multiplied"),
        ("view = glm::perspective(1.0f, 1.5f, 0.1f, 100.0f) * roll * X;", "it is multiplied"),
        ("view = glm::rotate(X, 0.4f, axis);", "it is an argument of glm::rotate: the camera's"),
        ("glm::mat4 view = glm::inverse(X);", "it is an argument of glm::inverse"),
        ("return glm::inverse(X);", "it is an argument of glm::inverse"),
        ("view = X.inverse();", "it is changed at once"),
        ("view = X;\nview = glm::inverse(view);", "the camera's matrix is changed after lookAt"),
    ] {
        let text = format!("{GLM_LENS}{}\n", statement.replace('X', GLM_LOOK));
        assert_refused(&text, message);
    }
    let invert = "mat4.perspective(proj, 1, 1.5, 0.1, 100);\nlet v = mat4.create();\n\
                  mat4.invert(v, mat4.lookAt(v, [4, 3, 3], [0, 0, 0], [0, 1, 0]));\n";
    assert_refused(invert, "it is an argument of mat4.invert");
    for statement in [
        "view = X;",
        "glm::mat4 view(X);",
        "vp = glm::perspective(1.0f, 1.5f, 0.1f, 100.0f) * X;",
        "mvp = projection * X * model;",
        "shader.setMat4(\"view\", X);",
        "glUniformMatrix4fv(at, 1, GL_FALSE, glm::value_ptr(X));",
        "glUniformMatrix4fv(at, 1, GL_FALSE, glm::value_ptr(proj * X));",
    ] {
        let text = format!("{GLM_LENS}{}\n", statement.replace('X', GLM_LOOK));
        assert_eq!(eye(&text), DVec3::new(4.0, 3.0, 3.0), "{statement}");
    }
}

#[test]
fn a_light_s_look_at_is_never_the_camera_s() {
    let text = format!("{GLM_LENS}glm::mat4 lightView = {GLM_LOOK};\nview = c.GetViewMatrix();\n");
    assert_refused(
        &text,
        "this is of a light, not of the camera: the camera's lookAt must be given by numbers",
    );
}

#[test]
fn what_moves_the_lens_is_refused() {
    let projection = "glMatrixMode(GL_PROJECTION);\nglLoadIdentity();\n";
    let view = "glMatrixMode(GL_MODELVIEW);\nglLoadIdentity();\n";
    let mirror = "glScalef(-1, 1, 1);\n";
    assert_refused(
        &format!("{projection}{mirror}{LENS}{view}{LOOK}"),
        "in:4:16: gluPerspective is 45.0, 4.0 / 3.0, 0.1, 100.0: glScale stands before it",
    );
    assert_refused(
        &format!("{projection}{LENS}{mirror}{view}{LOOK}"),
        "glScale stands behind it in the same matrix",
    );
    assert_eq!(eye(&format!("{projection}{LENS}{view}{LOOK}{mirror}")).z, 5.0);
    assert_eq!(eye(&format!("{mirror}{projection}{LENS}{view}{LOOK}")).z, 5.0);
}
