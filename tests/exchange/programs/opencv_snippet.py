"""What a snippet comes to in Python: usage: opencv_snippet.py SNIPPET.py; prints K, R and t as JSON."""
import json
import sys

import cv2
import numpy as np

names = {"np": np, "cv2": cv2}
exec(open(sys.argv[1]).read(), names)
if "Rt" in names:
    R, t = names["Rt"][:3, :3], names["Rt"][:3, 3]
elif "R" in names:
    R, t = names["R"], None
else:
    R, t = cv2.Rodrigues(np.array(names.get("rvec", names.get("rotation_vector")), float))[0], None
if t is None:
    t = next(names[name] for name in ("t", "tvec", "translation_vector") if name in names)
K = names["K"] if "K" in names else names["camera_matrix"]
print(json.dumps({"K": np.array(K).tolist(), "R": R.tolist(), "t": np.ravel(t).tolist()}))
