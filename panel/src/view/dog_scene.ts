// DogScene: one robot and its world as a three.js scene.
import * as THREE from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';
import type { Pose, RobotData, RobotPose, ShapeData, WorldData } from '../protocol';

const FLOOR_REACH_M = 2.6;
const SHADOW_REACH_M = 0.42;

export interface Hit {
  link: string;
  touch: string | null;
  point: THREE.Vector3;
}

function placeAt(object: THREE.Object3D, pose: Pose): void {
  object.position.set(pose[0], pose[1], pose[2]);
  object.quaternion.set(pose[4], pose[5], pose[6], pose[3]);
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
      const radius = Math.min(shape.radius, Math.min(x, y, z) / 2);
      geometry = new RoundedBoxGeometry(x, y, z, radius > 0.006 ? 5 : 2, Math.max(radius, 1e-5));
    }
    geometries.set(key, geometry);
  }
  return geometry;
}

function makeMesh(shape: ShapeData): THREE.Mesh<THREE.BufferGeometry, THREE.MeshStandardMaterial> {
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

// Makes the floor: a thin line every `grid` metres, and a stronger line every five of them. The
// lines fade with the distance.
function makeFloor(grid: number): THREE.Mesh<THREE.PlaneGeometry, THREE.ShaderMaterial> {
  const material = new THREE.ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: {
      grid: { value: grid },
      line: { value: new THREE.Color() },
      centre: { value: new THREE.Vector2() },
      reach: { value: FLOOR_REACH_M },
    },
    vertexShader: `varying vec2 at;
      void main() {
        vec4 world = modelMatrix * vec4(position, 1.0);
        at = world.xy;
        gl_Position = projectionMatrix * viewMatrix * world;
      }`,
    fragmentShader: `varying vec2 at;
      uniform float grid; uniform vec3 line; uniform vec2 centre; uniform float reach;
      float lines(float x, float width) {
        float from = abs(fract(x - 0.5) - 0.5), blur = fwidth(x);
        return (1.0 - smoothstep(width, width + 1.2 * blur, from)) * clamp(width / blur * 6.0, 0.25, 1.0);
      }
      void main() {
        vec2 cell = at / grid;
        float thin = max(lines(cell.x, 0.006), lines(cell.y, 0.006));
        float thick = max(lines(cell.x / 5.0, 0.003), lines(cell.y / 5.0, 0.003));
        float fade = 1.0 - smoothstep(0.15 * reach, reach, distance(at, centre));
        gl_FragColor = vec4(line, (0.30 * thin + 0.45 * thick) * fade);
        #include <colorspace_fragment>
      }`,
  });
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(40, 40), material);
  mesh.renderOrder = -1;
  return mesh;
}

// Makes the ground below the lines, for a world whose floor has a colour of its own.
function makeGround(colour: string): THREE.Mesh {
  const mesh = new THREE.Mesh(
    new THREE.PlaneGeometry(40, 40),
    new THREE.MeshStandardMaterial({ color: colour, roughness: 1, metalness: 0 }),
  );
  mesh.position.z = -0.002; // below the lines and the shadows
  mesh.renderOrder = -2;
  return mesh;
}

interface Led {
  index: number;
  mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshStandardMaterial>;
  glow: THREE.Color;
}

interface Ear {
  index: number;
  pivot: THREE.Group;
  axis: THREE.Vector3;
}

export class DogScene {
  readonly scene = new THREE.Scene();
  private readonly links: THREE.Group[] = [];
  private readonly meshes: THREE.Object3D[] = [];
  private readonly leds: Led[] = [];
  private readonly ears: Ear[] = [];
  private readonly floor: THREE.Mesh<THREE.PlaneGeometry, THREE.ShaderMaterial>;
  private readonly shadows: THREE.Mesh;
  private readonly sky = new THREE.HemisphereLight(0xffffff, 0x8a8f98, 1);
  private readonly sun = new THREE.DirectionalLight(0xfff4e4, 2.2);
  private isDark = false;
  private trunk: Pose = [0, 0, 0.15, 1, 0, 0, 0];

  constructor(robot: RobotData, world: WorldData, gridM: number) {
    if (world.floor !== undefined) this.scene.add(makeGround(world.floor));
    for (const shape of world.shapes) {
      const mesh = makeMesh(shape);
      placeAt(mesh, shape.pose);
      this.scene.add(mesh);
    }
    robot.links.forEach((link, i) => {
      const group = new THREE.Group();
      group.visible = false;
      for (const shape of link.shapes ?? []) this.addShape(group, shape, link.name);
      this.links[i] = group;
      this.scene.add(group);
    });
    this.floor = makeFloor(gridM > 0 ? gridM : 0.1);
    this.shadows = new THREE.Mesh(
      new THREE.PlaneGeometry(2.4, 2.4),
      new THREE.ShadowMaterial({ opacity: 0.3 }),
    );
    this.shadows.receiveShadow = true;
    this.shadows.position.z = 0.0004;
    this.scene.add(this.floor, this.shadows, this.sky, this.sun, this.sun.target);
    this.sky.position.set(0, 0, 1);
    this.prepareShadow();
  }

  // Sets the picture that glossy parts mirror; null on computers for which mirroring is too slow.
  setEnvironment(environment: THREE.Texture | null): void {
    const isRich = environment !== null;
    this.scene.environment = environment;
    this.scene.environmentIntensity = 0.5;
    this.scene.environmentRotation.x = Math.PI / 2;
    const size = isRich ? 1024 : 512;
    if (this.sun.shadow.mapSize.x !== size) {
      this.sun.shadow.mapSize.set(size, size);
      this.sun.shadow.map?.dispose();
      this.sun.shadow.map = null;
    }
    this.setLights();
  }

  setColours(line: string, isDark: boolean): void {
    const lines = this.floor.material.uniforms['line'];
    if (lines !== undefined) (lines.value as THREE.Color).set(line);
    this.isDark = isDark;
    this.setLights();
  }

  private setLights(): void {
    const extra = this.scene.environment === null ? 1.3 : 0;
    this.sky.intensity = (this.isDark ? 0.55 : 0.8) + extra;
    this.sun.intensity = this.isDark ? 2.1 : 2.4;
    (this.shadows.material as THREE.ShadowMaterial).opacity = this.isDark ? 0.55 : 0.26;
  }

  get trunkPose(): Pose {
    return this.trunk;
  }

  // Returns the direction in which the dog looks, as an angle about the vertical axis.
  get heading(): number {
    const [, , , w, x, y, z] = this.trunk;
    return Math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
  }

  apply(pose: RobotPose): void {
    this.links.forEach((group, i) => {
      const at = pose.links?.[i];
      group.visible = at !== undefined;
      if (at !== undefined) placeAt(group, at);
    });
    if (pose.links?.[0] !== undefined) this.trunk = pose.links[0];
    for (const led of this.leds) {
      const isOn = (pose.leds?.[led.index] ?? 0) !== 0;
      led.mesh.material.emissive.copy(led.glow);
      led.mesh.material.emissiveIntensity = isOn ? 1.6 : 0;
    }
    for (const ear of this.ears)
      ear.pivot.quaternion.setFromAxisAngle(ear.axis, pose.ears?.[ear.index] ?? 0);
    this.moveLights();
  }

  pick(ray: THREE.Raycaster): Hit | null {
    for (const hit of ray.intersectObjects(this.meshes, false)) {
      const { link, touch } = hit.object.userData as { link: string; touch: string | null };
      return { link, touch, point: hit.point };
    }
    return null;
  }

  dispose(): void {
    this.scene.traverse((object) => {
      if (object instanceof THREE.Mesh) (object.material as THREE.Material).dispose();
    });
    this.sun.shadow.map?.dispose();
  }

  private addShape(group: THREE.Group, shape: ShapeData, link: string): void {
    const mesh = makeMesh(shape);
    mesh.userData = { link, touch: shape.touch ?? null };
    this.meshes.push(mesh);
    placeAt(mesh, shape.pose);
    if (shape.led !== undefined) {
      this.leds.push({ index: shape.led, mesh, glow: new THREE.Color(shape.glow ?? '#ffffff') });
    }
    if (shape.ear === undefined) {
      group.add(mesh);
      return;
    }
    const [x, y, z] = shape.pivot ?? [0, 0, 0];
    const pivot = new THREE.Group();
    pivot.position.set(x, y, z);
    mesh.position.sub(pivot.position);
    pivot.add(mesh);
    group.add(pivot);
    this.ears.push({
      index: shape.ear,
      pivot,
      axis: new THREE.Vector3(...(shape.axis ?? [0, -1, 0])).normalize(),
    });
  }

  private prepareShadow(): void {
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 5;
    this.sun.shadow.normalBias = 0.004;
    this.sun.shadow.bias = -0.0008;
    const camera = this.sun.shadow.camera;
    camera.left = camera.bottom = -SHADOW_REACH_M;
    camera.right = camera.top = SHADOW_REACH_M;
    camera.near = 0.3;
    camera.far = 3;
    this.moveLights();
  }

  // Moves the light that makes shadows with the dog, so that a small shadow map is enough for sharp
  // shadows.
  private moveLights(): void {
    const [x, y] = this.trunk;
    this.sun.target.position.set(x, y, 0.08);
    this.sun.position.set(x + 0.22, y - 0.5, 1.4);
    this.shadows.position.x = x;
    this.shadows.position.y = y;
    const centre = this.floor.material.uniforms['centre'];
    if (centre !== undefined) (centre.value as THREE.Vector2).set(x, y);
  }
}
