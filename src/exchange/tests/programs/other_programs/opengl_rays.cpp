// The exported lines with GLM behind gluLookAt and gluPerspective; rays by glm::unProject.
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include "spheres.hpp"

static glm::dmat4 projection(1), view(1);
static glm::dvec4 port;
enum { GL_PROJECTION, GL_MODELVIEW };
static void glMatrixMode(int) {}
static void glLoadIdentity() {}
static void glViewport(int x, int y, int w, int h) { port = glm::dvec4(x, y, w, h); }
static void gluPerspective(double fovy, double aspect, double near, double far) {
    projection = glm::perspective(glm::radians(fovy), aspect, near, far);
}
static void gluLookAt(double a, double b, double c, double d, double e, double f, double g, double h, double i) {
    view = glm::lookAt(glm::dvec3(a, b, c), glm::dvec3(d, e, f), glm::dvec3(g, h, i));
}

int main(int, char** arguments) {
#include "camera.c"
    auto balls = read_balls(arguments[1]);
    glm::dvec3 eye(glm::inverse(view)[3]);
    for (int i = 0; i < port[3]; i++) {
        for (int j = 0; j < port[2]; j++) {
            // Window coordinates: from the lower left corner, y up.
            glm::dvec3 window(j + 0.5, port[3] - i - 0.5, 0);
            glm::dvec3 d = glm::unProject(window, view, projection, port) - eye;
            std::printf("%d ", first(balls, &eye[0], &d[0]));
        }
        std::printf("\n");
    }
}
