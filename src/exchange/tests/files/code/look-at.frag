#version 330 core
out vec4 color;

const vec3 eye = vec3(20.0, 4.0, 10.0);
const vec3 U = vec3(0.5812382, 0.0, -0.81373346); // right
const vec3 V = vec3(-0.12463786, 0.9882002, -0.08902704); // up in the image
const vec3 W = vec3(0.80413157, 0.15316792, 0.5743797); // backwards
const float width = 1.0, height = 1.0; // of the viewport
const float d = 1.0; // its distance; the word itself is a function here
const int columns = 400, rows = 400; // of the image

struct Ray {
    vec3 origin, direction;
};

// The view ray of row i and column j, from 0, row 0 on top.
Ray ray(int i, int j) {
    float u = width * ((float(j) + 0.5) / float(columns) - 0.5);
    float v = height * (0.5 - (float(i) + 0.5) / float(rows));
    return Ray(eye, u * U + v * V - d * W);
}

void main() {
    int i = rows - 1 - int(gl_FragCoord.y); // OpenGL counts rows from below
    int j = int(gl_FragCoord.x);
    color = vec4(0.5 + 0.5 * normalize(ray(i, j).direction), 1.0);
}
