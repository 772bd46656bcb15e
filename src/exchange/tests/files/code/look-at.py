import numpy as np

eye = np.array([20.0, 4.0, 10.0])
U = np.array([0.5812381937190964, 0.0, -0.813733471206735])  # right
V = np.array([-0.12463786013791102, 0.9882001768077231, -0.08902704295565073])  # up in the image
W = np.array([0.8041315601208577, 0.1531679162134967, 0.5743796858006127])  # backwards
width, height, distance = 1.0, 1.0, 1.0  # of the viewport
columns, rows = 400, 400  # of the image


def ray(i, j):
    """Origin and direction of the view ray of row i and column j, from 0, row 0 on top."""
    u = width * ((j + 0.5) / columns - 0.5)
    v = height * (0.5 - (i + 0.5) / rows)
    return eye, u * U + v * V - distance * W


if __name__ == "__main__":
    print(ray(0, 0))
