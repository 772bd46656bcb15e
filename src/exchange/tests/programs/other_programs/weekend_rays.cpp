// The exported lines with a camera that does what the book's initialize() and get_ray() do.
#include <cstdlib>
#include <memory>
#include "spheres.hpp"
using std::make_shared;

struct vec3 {
    double e[3];
    vec3(double x = 0, double y = 0, double z = 0) : e{x, y, z} {}
};
using point3 = vec3;
using color = vec3;
static vec3 operator+(vec3 a, vec3 b) { return {a.e[0] + b.e[0], a.e[1] + b.e[1], a.e[2] + b.e[2]}; }
static vec3 operator*(double s, vec3 a) { return {s * a.e[0], s * a.e[1], s * a.e[2]}; }
static vec3 operator-(vec3 a, vec3 b) { return a + -1.0 * b; }
static double length(vec3 a) { return std::sqrt(a.e[0] * a.e[0] + a.e[1] * a.e[1] + a.e[2] * a.e[2]); }
static vec3 unit_vector(vec3 a) { return (1 / length(a)) * a; }
static vec3 cross(vec3 a, vec3 b) {
    return {a.e[1] * b.e[2] - a.e[2] * b.e[1], a.e[2] * b.e[0] - a.e[0] * b.e[2], a.e[0] * b.e[1] - a.e[1] * b.e[0]};
}
struct lambertian { lambertian(color) {} };
struct sphere { Ball ball; sphere(point3 c, double r, std::shared_ptr<lambertian>) : ball{c.e[0], c.e[1], c.e[2], r} {} };
struct hittable_list {
    std::vector<Ball> balls;
    void add(std::shared_ptr<sphere> s) { balls.push_back(s->ball); }
};

struct camera {
    double aspect_ratio = 1;
    int image_width = 100, image_height = 0;
    double vfov = 90;
    point3 lookfrom = {0, 0, 0}, lookat = {0, 0, -1};
    vec3 vup = {0, 1, 0};
    double defocus_angle = 0, focus_dist = 10;
    vec3 center, pixel00, delta_u, delta_v;

    void initialize() {
        image_height = int(image_width / aspect_ratio);
        image_height = image_height < 1 ? 1 : image_height;
        center = lookfrom;
        double h = std::tan(vfov * 3.1415926535897932385 / 180 / 2);
        double viewport_height = 2 * h * focus_dist;
        double viewport_width = viewport_height * (double(image_width) / image_height);
        vec3 w = unit_vector(lookfrom - lookat), u = unit_vector(cross(vup, w)), v = cross(w, u);
        vec3 viewport_u = viewport_width * u, viewport_v = -viewport_height * v;
        delta_u = (1.0 / image_width) * viewport_u;
        delta_v = (1.0 / image_height) * viewport_v;
        vec3 upper_left = center - focus_dist * w - 0.5 * viewport_u - 0.5 * viewport_v;
        pixel00 = upper_left + 0.5 * (delta_u + delta_v);
    }
};

int main() {
#include "main.cc"
    cam.initialize();
    for (int row = 0; row < cam.image_height; row++) {
        for (int column = 0; column < cam.image_width; column++) {
            vec3 d = cam.pixel00 + double(column) * cam.delta_u + double(row) * cam.delta_v - cam.center;
            std::printf("%d ", first(world.balls, cam.center.e, d.e));
        }
        std::printf("\n");
    }
}
