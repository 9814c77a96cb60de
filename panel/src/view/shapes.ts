// Shapes of robots and of the world as three.js meshes.
import * as THREE from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Pose, ShapeData } from '../protocol';

export function placeAt(object: THREE.Object3D, pose: Pose): void {
  object.position.set(pose[0], pose[1], pose[2]);
  object.quaternion.set(pose[4], pose[5], pose[6], pose[3]);
}

// The triangles of a RoundedBoxGeometry share no corners.  Here they share them, because a corner
// costs time for each triangle that has its own, above all where the processor draws.
function makeRoundedBox(x: number, y: number, z: number, radius: number): THREE.BufferGeometry {
  const box = new RoundedBoxGeometry(x, y, z, radius > 0.006 ? 5 : 2, Math.max(radius, 1e-5));
  box.deleteAttribute('uv'); // differs between faces, and no material of ours has a texture
  return mergeVertices(box, 1e-6);
}

const geometries = new Map<string, THREE.BufferGeometry>();

function geometryOf(shape: ShapeData): THREE.BufferGeometry {
  if (shape.triangles !== undefined) {
    const surface = new THREE.BufferGeometry();
    surface.setAttribute('position', new THREE.Float32BufferAttribute(shape.triangles, 3));
    surface.computeVertexNormals();
    return surface;
  }
  const key = `${shape.size.join()}/${shape.cylinder ? 'cylinder' : shape.radius}`;
  let geometry = geometries.get(key);
  if (geometry === undefined) {
    const [x, y, z] = shape.size;
    if (shape.cylinder) {
      // A cylinder of three.js lies along y.
      geometry = new THREE.CylinderGeometry(x / 2, x / 2, z, 48).rotateX(Math.PI / 2);
    } else {
      geometry = makeRoundedBox(x, y, z, Math.min(shape.radius, Math.min(x, y, z) / 2));
    }
    geometries.set(key, geometry);
  }
  return geometry;
}

export function makeMesh(shape: ShapeData): THREE.Mesh<THREE.BufferGeometry, THREE.MeshStandardMaterial> {
  const gloss = shape.gloss ?? 0.3;
  const material = new THREE.MeshStandardMaterial({
    color: shape.colour,
    roughness: 0.78 - 0.55 * gloss,
    metalness: 0.04,
    envMapIntensity: 0.45 + 0.5 * gloss,
  });
  const mesh = new THREE.Mesh(geometryOf(shape), material);
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  return mesh;
}
