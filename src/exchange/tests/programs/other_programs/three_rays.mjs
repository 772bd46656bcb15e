// What three.js's own Raycaster has at each pixel's centre; of glTF, after Khronos's validator. usage: three_rays.mjs NODE_MODULES FILE WIDTH HEIGHT
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const [modules, file, width, height] = process.argv.slice(2);
const THREE = await import(pathToFileURL(`${modules}/three/build/three.module.js`).href);
const W = Number(width), H = Number(height);
const text = readFileSync(file, 'utf8');

let scene;
if (file.endsWith('.gltf')) {
  const validator = createRequire(import.meta.url)(`${modules}/gltf-validator`);
  const report = await validator.validateString(text);
  if (report.issues.numErrors + report.issues.numWarnings > 0) {
    console.error(JSON.stringify(report.issues, null, 1));
    process.exit(1);
  }
  // What GLTFLoader makes of nodes and cameras; the loader itself needs a browser.
  const gltf = JSON.parse(text);
  scene = new THREE.Scene();
  for (const node of gltf.nodes) {
    const lens = node.camera !== undefined ? gltf.cameras[node.camera].perspective : null;
    const object = lens
      ? new THREE.PerspectiveCamera(THREE.MathUtils.radToDeg(lens.yfov), lens.aspectRatio, lens.znear, lens.zfar)
      : new THREE.Mesh(new THREE.SphereGeometry(1));
    const matrix = new THREE.Matrix4();
    if (node.matrix) {
      matrix.fromArray(node.matrix);
    } else {
      const vector = (v, or) => new THREE.Vector3(...(v ?? or));
      matrix.compose(
        vector(node.translation, [0, 0, 0]),
        new THREE.Quaternion(...(node.rotation ?? [0, 0, 0, 1])),
        vector(node.scale, [1, 1, 1]),
      );
    }
    object.applyMatrix4(matrix);
    scene.add(object);
  }
} else {
  scene = new THREE.ObjectLoader().parse(JSON.parse(text));
}
scene.updateMatrixWorld(true);
let camera;
const spheres = [];
scene.traverse((object) => {
  if (object.isPerspectiveCamera) camera = object;
  if (object.isMesh) {
    const radius = object.geometry.parameters.radius;
    spheres.push(new THREE.Sphere(new THREE.Vector3(), radius).applyMatrix4(object.matrixWorld));
  }
});
camera.updateProjectionMatrix();
camera.updateMatrixWorld(true);
const caster = new THREE.Raycaster();
const point = new THREE.Vector3();
for (let i = 0; i < H; i++) {
  const row = [];
  for (let j = 0; j < W; j++) {
    // Device coordinates: -1 to 1, y up.
    caster.setFromCamera(new THREE.Vector2((2 * j + 1) / W - 1, 1 - (2 * i + 1) / H), camera);
    let best = Infinity, which = -1;
    spheres.forEach((sphere, k) => {
      if (caster.ray.intersectSphere(sphere, point)) {
        const distance = point.distanceTo(caster.ray.origin);
        if (distance < best) [best, which] = [distance, k];
      }
    });
    row.push(which);
  }
  console.log(row.join(' '));
}
