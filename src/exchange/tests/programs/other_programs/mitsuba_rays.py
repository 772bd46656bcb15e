"""What Mitsuba's sensor and scene have at each pixel's centre.

usage: mitsuba_rays.py SCENE.xml WIDTH HEIGHT
"""
import sys

import mitsuba as mi

mi.set_variant("scalar_rgb")
scene = mi.load_file(sys.argv[1])
width, height = int(sys.argv[2]), int(sys.argv[3])
sensor = scene.sensors()[0]
assert list(sensor.film().size()) == [width, height]
shapes = {shape.id(): k for k, shape in enumerate(sorted(scene.shapes(), key=lambda s: s.id()))}
for i in range(height):
    row = []
    for j in range(width):
        place = mi.Point2f((j + 0.5) / width, (i + 0.5) / height)
        ray, _ = sensor.sample_ray(0, 0.5, place, mi.Point2f(0.5))
        hit = scene.ray_intersect(ray)
        row.append(shapes[hit.shape.id()] if hit.is_valid() else -1)
    print(*row)
