// What camera three.js makes of code: u, v, w, eye, the tangent of half the vertical field of view, aspect. usage: three_camera.mjs NODE_MODULES FILE NAME
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [modules, file, name] = process.argv.slice(2);
const THREE = await import(pathToFileURL(`${modules}/three/build/three.module.js`).href);
const controls = ['OrbitControls', 'MapControls'];
const from = (name) => import(pathToFileURL(`${modules}/three/examples/jsm/controls/${name}.js`).href);
const made = await Promise.all(controls.map(async (name) => (await from(name))[name]));
const run = new Function('THREE', 'scene', 'renderer', ...controls, `${readFileSync(file, 'utf8')}\nreturn ${name};`);
const camera = run.call({}, THREE, new THREE.Scene(), { setSize() {}, render() {} }, ...made);
camera.updateMatrixWorld();
const e = camera.matrixWorld.elements;
const half = Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2) / camera.zoom;
const parts = [e.slice(0, 3), e.slice(4, 7), e.slice(8, 11), e.slice(12, 15), half, camera.aspect];
console.log(parts.flat().join(' '));
