"""Rays of Blender's camera after the exported script has run.

usage: blender_rays.py SCENE.py WIDTH HEIGHT SPHERES.json
"""
import json
import sys

import bpy
import numpy as np
from spheres import seen, show

bpy.ops.wm.read_factory_settings(use_empty=True)
exec(open(sys.argv[1]).read())
bpy.context.view_layer.update()
scene = bpy.context.scene
W, H = int(sys.argv[2]), int(sys.argv[3])
assert (scene.render.resolution_x, scene.render.resolution_y) == (W, H)
spheres = json.load(open(sys.argv[4]))
meshes = [thing for thing in bpy.data.objects if thing.type == "MESH"]
assert len(meshes) == len(spheres)
camera = scene.camera
frame = np.array([list(corner) for corner in camera.data.view_frame(scene=scene)])
low, high = frame.min(0), frame.max(0)
i, j = np.mgrid[0:H, 0:W].astype(float)
x = low[0] + (high[0] - low[0]) * (j + 0.5) / W
y = high[1] - (high[1] - low[1]) * (i + 0.5) / H
directions = np.stack([x, y, np.full_like(x, frame[0, 2])], -1)
matrix = np.array(camera.matrix_world)
show(seen(matrix[:3, 3], directions @ matrix[:3, :3].T, spheres))
