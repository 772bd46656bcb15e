#include <cstdio>
#include <glm/glm.hpp>

const glm::dvec3 eye(20.0, 4.0, 10.0);
const glm::dvec3 U(0.5812381937190964, 0.0, -0.813733471206735); // right
const glm::dvec3 V(-0.12463786013791102, 0.9882001768077231, -0.08902704295565073); // up in the image
const glm::dvec3 W(0.8041315601208577, 0.1531679162134967, 0.5743796858006127); // backwards
const double width = 1.0, height = 1.0, distance = 1.0; // of the viewport
const int columns = 400, rows = 400; // of the image

struct Ray {
    glm::dvec3 origin, direction;
};

// The view ray of row i and column j, from 0, row 0 on top.
Ray ray(int i, int j) {
    double u = width * ((j + 0.5) / columns - 0.5);
    double v = height * (0.5 - (i + 0.5) / rows);
    return {eye, u * U + v * V - distance * W};
}

int main() {
    glm::dvec3 d = ray(0, 0).direction;
    std::printf("%.17g %.17g %.17g\n", d.x, d.y, d.z);
}
