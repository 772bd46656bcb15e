const eye = [20.0, 4.0, 10.0];
const U = [0.5812381937190964, 0.0, -0.813733471206735]; // right
const V = [-0.12463786013791102, 0.9882001768077231, -0.08902704295565073]; // up in the image
const W = [0.8041315601208577, 0.1531679162134967, 0.5743796858006127]; // backwards
const [width, height, distance] = [1.0, 1.0, 1.0]; // of the viewport
const [columns, rows] = [400, 400]; // of the image

// Origin and direction of the view ray of row i and column j, from 0, row 0 on top.
function ray(i, j) {
  const u = width * ((j + 0.5) / columns - 0.5);
  const v = height * (0.5 - (i + 0.5) / rows);
  const direction = [0, 1, 2].map((k) => u * U[k] + v * V[k] - distance * W[k]);
  return [eye, direction];
}

console.log(ray(0, 0));
