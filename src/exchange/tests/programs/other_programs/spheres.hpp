// Which sphere a ray meets first; spheres as lines x y z r.
#pragma once
#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

struct Ball { double x, y, z, r; };

inline std::vector<Ball> read_balls(const char* path) {
    std::ifstream in(path);
    std::vector<Ball> balls;
    for (Ball b; in >> b.x >> b.y >> b.z >> b.r;) balls.push_back(b);
    return balls;
}

inline int first(const std::vector<Ball>& balls, const double p[3], const double d[3]) {
    double best = INFINITY;
    int which = -1;
    for (size_t k = 0; k < balls.size(); k++) {
        double o[3] = {p[0] - balls[k].x, p[1] - balls[k].y, p[2] - balls[k].z};
        double a = 0, b = 0, c = -balls[k].r * balls[k].r;
        for (int n = 0; n < 3; n++) { a += d[n] * d[n]; b += d[n] * o[n]; c += o[n] * o[n]; }
        double t = (-b - std::sqrt(b * b - a * c)) / a;
        if (t > 0 && t < best) { best = t; which = int(k); }
    }
    return which;
}
