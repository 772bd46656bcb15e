"""Where COLMAP sees points: usage: colmap_points.py FOLDER POINTS.json"""
import json
import sys

import numpy as np
import pycolmap

model = pycolmap.Reconstruction(sys.argv[1])
image = next(iter(model.images.values()))
camera = model.cameras[image.camera_id]
pose = image.cam_from_world
pose = pose() if callable(pose) else pose
for point in json.load(open(sys.argv[2])):
    x, y = np.ravel(camera.img_from_cam(np.ravel(pose * np.array(point))))
    print(x, y)
