"""Which sphere each ray meets first: the rays of a picture, and spheres as [x, y, z, r]."""
import numpy as np


def seen(origin, directions, spheres):
    best = np.full(directions.shape[:2], np.inf)
    which = np.full(directions.shape[:2], -1)
    a = (directions * directions).sum(-1)
    for k, (x, y, z, r) in enumerate(spheres):
        oc = np.asarray(origin) - (x, y, z)
        b = directions @ oc
        d = b * b - a * (oc @ oc - r * r)
        with np.errstate(invalid="ignore"):
            t = (-b - np.sqrt(d)) / a
        hit = (d >= 0) & (t > 0) & (t < best)
        best[hit], which[hit] = t[hit], k
    return which


def show(which):
    for row in which:
        print(*row)
