// DogScene: one robot and its world as a three.js scene.
import * as THREE from 'three';
import type { Pose, RobotData, RobotPose, WorldData } from '../protocol';
import { DogFigure } from './dog_figure';
import { makeMesh, placeAt } from './shapes';

const FLOOR_REACH_M = 2.6;
const SHADOW_REACH_M = 0.42;

export interface Hit {
  link: string;
  touch: string | null;
  point: THREE.Vector3;
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

export class DogScene {
  readonly scene = new THREE.Scene();
  private readonly dog: DogFigure;
  private readonly things: THREE.Object3D[] = [];
  private readonly floor: THREE.Mesh<THREE.PlaneGeometry, THREE.ShaderMaterial>;
  private readonly shadows: THREE.Mesh;
  private readonly sky = new THREE.HemisphereLight(0xffffff, 0x8a8f98, 1);
  private readonly sun = new THREE.DirectionalLight(0xfff4e4, 2.2);
  private isDark = false;

  // `company` are the other robots of the same world.
  constructor(
    robot: RobotData,
    world: WorldData,
    gridM: number,
    private readonly company: DogFigure[] = [],
  ) {
    if (world.floor !== undefined) this.scene.add(makeGround(world.floor));
    for (const shape of world.shapes) {
      const mesh = makeMesh(shape);
      placeAt(mesh, shape.pose);
      if (shape.thing !== undefined) this.things[shape.thing] = mesh;
      this.scene.add(mesh);
    }
    this.dog = new DogFigure(robot);
    this.scene.add(this.dog.group);
    for (const other of company) this.scene.add(other.group);
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
    return this.dog.trunkPose;
  }

  // Returns the direction in which the dog looks, as an angle about the vertical axis.
  get heading(): number {
    const [, , , w, x, y, z] = this.trunkPose;
    return Math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
  }

  // `others` are the poses of the company, in its order.
  apply(pose: RobotPose, others: (RobotPose | undefined)[] = []): void {
    this.dog.apply(pose);
    this.company.forEach((figure, i) => {
      const at = others[i];
      if (at !== undefined) figure.apply(at);
    });
    this.things.forEach((mesh, i) => {
      const at = pose.things?.[i];
      if (at !== undefined) placeAt(mesh, at);
    });
    this.moveLights();
  }

  pick(ray: THREE.Raycaster): Hit | null {
    for (const hit of ray.intersectObjects(this.dog.meshes, false)) {
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
    const [x, y] = this.trunkPose;
    this.sun.target.position.set(x, y, 0.08);
    this.sun.position.set(x + 0.22, y - 0.5, 1.4);
    this.shadows.position.x = x;
    this.shadows.position.y = y;
    const centre = this.floor.material.uniforms['centre'];
    if (centre !== undefined) (centre.value as THREE.Vector2).set(x, y);
  }
}
