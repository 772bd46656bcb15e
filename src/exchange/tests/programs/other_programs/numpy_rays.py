"""Rays of a camera by the formulas of each form's own documentation.

usage: numpy_rays.py FORM FILE WIDTH HEIGHT SPHERES.json
"""
import json
import re
import sys

import numpy as np
from spheres import seen, show

form, path, width, height, spheres = sys.argv[1:]
W, H = int(width), int(height)
text = open(path).read()
i, j = np.mgrid[0:H, 0:W].astype(float)


def unit(v):
    return v / np.linalg.norm(v)


def opencv():
    given = json.loads(text)
    K, R, t = (np.array(given[name], float) for name in ("K", "R", "t"))
    assert np.linalg.det(R) > 0.999
    # s (x, y, 1) = K (R X + t), pixel centres at whole numbers.
    points = np.stack([j, i, np.ones_like(i)], -1)
    return -R.T @ t, points @ np.linalg.inv(K).T @ R


def pbrt():
    words = re.sub(r"#.*", "", text)
    scale = [float(x) for x in re.search(r"Scale ([^\n]*)", words)[1].split()]
    look = re.search(r"LookAt\s+((?:\S+\s+){9})", words)[1].split()
    eye, at, up = np.array([float(x) for x in look]).reshape(3, 3)

    def parameter(name, otherwise=None):
        found = re.search(r'"(?:float|integer) ' + name + r'" \[ (\S+) \]', words)
        return float(found[1]) if found else otherwise

    assert (parameter("xresolution"), parameter("yresolution")) == (W, H)
    # Transforms, LookAt and CameraTransform of the book: camera from world = Scale * LookAt.
    z = unit(at - eye)
    x = unit(np.cross(unit(up), z))
    y = np.cross(z, x)
    world_from_camera = np.column_stack([x, y, z]) @ np.diag(1 / np.array(scale))
    # PerspectiveCamera: the screen window, and fov of the shorter side.
    frame = parameter("frameaspectratio", W / H)
    sx, sy = (frame, 1) if frame > 1 else (1, 1 / frame)
    tan = np.tan(np.radians(parameter("fov")) / 2)
    px = (2 * (j + 0.5) / W - 1) * sx * tan
    py = (1 - 2 * (i + 0.5) / H) * sy * tan
    return eye, np.stack([px, py, np.ones_like(i)], -1) @ world_from_camera.T


def course():
    plain = re.sub(r"#.*", "", text)
    call = plain[plain.index("(") + 1 :].replace("Vec3", "").replace("(", "").replace(")", "")
    numbers = [float(x) for x in call.split(",")]
    eye, view, up = np.array(numbers[:9]).reshape(3, 3)
    focal, rows, columns = numbers[9:]
    assert (rows, columns) == (H, W)
    w = -unit(view)
    u = unit(np.cross(up, w))
    v = np.cross(w, u)
    # i and j count from 1; the viewport is 1 wide and H / W high.
    pu = ((j + 1) - 0.5) / columns - 0.5
    pv = -(((i + 1) - 0.5) / rows - 0.5) * rows / columns
    return eye, pu[..., None] * u + pv[..., None] * v - focal * w


origin, directions = {"opencv": opencv, "pbrt": pbrt, "course": course}[form]()
show(seen(origin, directions, json.load(open(spheres))))
