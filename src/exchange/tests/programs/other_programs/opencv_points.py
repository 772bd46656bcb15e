"""Where OpenCV sees points: usage: opencv_points.py CAMERA.json POINTS.json"""
import json
import sys

import cv2
import numpy as np

camera, points = (json.load(open(path)) for path in sys.argv[1:])
K, R, t, dist = (np.array(camera[name], float) for name in ("K", "R", "t", "distortion"))
rvec, _ = cv2.Rodrigues(R)
seen, _ = cv2.projectPoints(np.array(points, float), rvec, t, K, dist)
for x, y in seen.reshape(-1, 2):
    print(x, y)
