// Stage: draws the picture of the dogs. Draws only when something has moved, at most once for each
// refresh of the screen.
import * as THREE from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { el } from '../dom';
import type { PoseEvent, Scene } from '../protocol';
import { colourOf, isDark, onTheme } from '../theme';
import { DogFigure } from './dog_figure';
import { DogScene, type Hit } from './dog_scene';
import { metresPerPixel, Orbit, tiles, type ViewName } from './orbit';

const FOV_DEG = 26;

// A computer that needs longer than this for a picture gets pictures of a lower quality.
const SLOW_MS = 45;
const SLOW_PICTURES = 15;

// Qualities of pictures, from the best to the cheapest. `gapMs` is the least time between two
// pictures. It matters where the processor draws, because the processor needs time for other work
// as well.
const QUALITIES = [
  { ratio: 2, isRich: true, gapMs: 0 },
  { ratio: 1, isRich: true, gapMs: 0 },
  { ratio: 1, isRich: false, gapMs: 60 },
  { ratio: 0.7, isRich: false, gapMs: 150 },
] as const;

// Returns whether the processor draws, because the computer has no graphics card. Asks a canvas of
// its own, because the answer decides how the canvas of the page is made.
function isDrawnBySoftware(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) return false;
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = info === null ? '' : String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL));
  gl.getExtension('WEBGL_lose_context')?.loseContext(); // a browser has only a few contexts
  return /swiftshader|llvmpipe|softpipe|software/i.test(name);
}

export interface StageHit extends Hit {
  robot: number;
}

export class Stage {
  readonly canvas = el('canvas', {
    tabindex: 0,
    role: 'img',
    'aria-label':
      'The dog in 3-D. Drag beside it to look around, wheel to zoom; keys: arrows, plus, minus, 0.',
  });
  readonly orbit = new Orbit();
  private readonly renderer: THREE.WebGLRenderer | null;
  private readonly camera = new THREE.PerspectiveCamera(FOV_DEG, 1, 0.02, 60);
  private dogs: DogScene[] = [];
  private isTogether = false; // all robots are in one world
  private pose: PoseEvent | null = null;
  private isDirty = false;
  private isPoseNew = false;
  private quality = 0;
  private environment: THREE.Texture | null = null;
  private slowPictures = 0;
  private lastDraw = 0;
  private readonly calm = window.matchMedia('(prefers-reduced-motion: reduce)');

  constructor() {
    const isBySoftware = isDrawnBySoftware();
    this.renderer = this.makeRenderer(isBySoftware);
    if (isBySoftware) this.quality = 2;
    onTheme(() => this.setColours());
    new ResizeObserver(() => this.touch()).observe(this.canvas);
  }

  // Returns false if the browser has no WebGL.
  get works(): boolean {
    return this.renderer !== null;
  }

  get robotCount(): number {
    return this.dogs.length;
  }

  setScene(scene: Scene): void {
    for (const dog of this.dogs) dog.dispose();
    const robots = scene.robots ?? [];
    this.isTogether = scene.together === true;
    this.dogs = robots.map((robot, i) => {
      const others = this.isTogether ? robots.filter((_, other) => other !== i) : [];
      return new DogScene(
        robot,
        scene.world ?? { shapes: [] },
        scene.grid_m,
        others.map((other) => new DogFigure(other)),
      );
    });
    this.applyQuality();
    this.setColours();
  }

  setPose(pose: PoseEvent): void {
    this.pose = pose;
    this.isPoseNew = true;
    this.touch();
  }

  look(view: ViewName, robot: number): void {
    this.orbit.look(view, this.dogs[robot]?.heading ?? 0);
    this.touch();
  }

  // Requests that a new picture is drawn soon.
  touch(): void {
    if (this.isDirty) return;
    this.isDirty = true;
    const wait = QUALITIES[this.quality]!.gapMs - (performance.now() - this.lastDraw);
    if (wait > 0) window.setTimeout(() => requestAnimationFrame(() => this.draw()), wait);
    else requestAnimationFrame(() => this.draw());
  }

  // Returns the robot and the part of it at a place of the page.
  pick(clientX: number, clientY: number): { robot: number; hit: StageHit | null } {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [clientX - box.left, clientY - box.top];
    const all = tiles(this.dogs.length, box.width, box.height);
    const robot = Math.max(
      0,
      all.findIndex((t) => x >= t.x && x < t.x + t.width && y >= t.y && y < t.y + t.height),
    );
    const tile = all[robot];
    const dog = this.dogs[robot];
    if (tile === undefined || dog === undefined) return { robot: 0, hit: null };
    this.aim(dog, tile.width / tile.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(
      new THREE.Vector2(
        (2 * (x - tile.x)) / tile.width - 1,
        1 - (2 * (y - tile.y)) / tile.height,
      ),
      this.camera,
    );
    const hit = dog.pick(ray);
    return { robot, hit: hit === null ? null : { ...hit, robot } };
  }

  // Returns the width of a pixel in metres at the place of `hit`, and the right and up directions of
  // the picture.
  pixelAt(hit: StageHit): { metres: number; right: THREE.Vector3; up: THREE.Vector3 } {
    const tile = tiles(this.dogs.length, this.canvas.clientWidth, this.canvas.clientHeight)[hit.robot];
    const dog = this.dogs[hit.robot];
    // Aims again, because the last picture was that of the last dog.
    if (tile !== undefined && dog !== undefined) this.aim(dog, tile.width / tile.height);
    const right = new THREE.Vector3();
    const up = new THREE.Vector3();
    const back = new THREE.Vector3();
    this.camera.matrixWorld.extractBasis(right, up, back);
    return { metres: metresPerPixel(this.camera, hit.point, tile?.height ?? 1), right, up };
  }

  trunkOf(robot: number): [number, number, number, number] {
    const pose = this.dogs[robot]?.trunkPose;
    return pose === undefined ? [1, 0, 0, 0] : [pose[3], pose[4], pose[5], pose[6]];
  }

  private makeRenderer(isBySoftware: boolean): THREE.WebGLRenderer | null {
    try {
      const renderer = new THREE.WebGLRenderer({
        canvas: this.canvas,
        antialias: !isBySoftware, // smooth edges take a processor too long
        alpha: true,
        powerPreference: 'high-performance',
      });
      renderer.shadowMap.enabled = true;
      renderer.shadowMap.type = THREE.PCFSoftShadowMap;
      renderer.toneMapping = THREE.ACESFilmicToneMapping;
      renderer.toneMappingExposure = 0.8;
      renderer.setScissorTest(true);
      this.camera.up.set(0, 0, 1);
      return renderer;
    } catch {
      return null;
    }
  }

  private applyQuality(): void {
    const { isRich } = QUALITIES[this.quality]!;
    if (isRich) this.environment ??= this.makeEnvironment();
    for (const dog of this.dogs) dog.setEnvironment(isRich ? this.environment : null);
  }

  private makeEnvironment(): THREE.Texture | null {
    if (this.renderer === null) return null;
    const generator = new THREE.PMREMGenerator(this.renderer);
    const { texture } = generator.fromScene(new RoomEnvironment(), 0.04);
    generator.dispose();
    return texture;
  }

  private setColours(): void {
    for (const dog of this.dogs) dog.setColours(colourOf('grid'), isDark());
    this.touch();
  }

  private aim(dog: DogScene, aspect: number): void {
    const [x, y, z] = dog.trunkPose;
    const share = this.dogs.length > 1 || this.calm.matches ? 1 : 0.12;
    if (this.orbit.follow({ x, y, z }, share)) this.touch();
    const eye = this.orbit.eye();
    const { target } = this.orbit;
    this.camera.aspect = aspect;
    // Makes the angle of view larger for a narrow picture, because it would show too little to the
    // sides.
    this.camera.fov = aspect < 1.1 ? FOV_DEG * Math.min(2, 1.1 / aspect) : FOV_DEG;
    this.camera.position.set(eye.x, eye.y, eye.z);
    this.camera.lookAt(target.x, target.y, target.z);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  private draw(): void {
    this.isDirty = false;
    const renderer = this.renderer;
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (renderer === null || width === 0 || height === 0 || document.hidden) return;
    this.watchSpeed();
    this.fit(renderer, width, height);
    const all = tiles(this.dogs.length, width, height);
    this.dogs.forEach((dog, i) => {
      const tile = all[i];
      const pose = this.pose?.robots?.[i];
      if (tile === undefined) return;
      if (pose !== undefined && this.isPoseNew) {
        const others = this.isTogether ? this.pose?.robots?.filter((_, other) => other !== i) : [];
        dog.apply(pose, others);
      }
      this.aim(dog, tile.width / tile.height);
      const y = height - tile.y - tile.height; // WebGL counts y from below
      renderer.setViewport(tile.x, y, tile.width, tile.height);
      renderer.setScissor(tile.x, y, tile.width, tile.height);
      renderer.render(dog.scene, this.camera);
    });
    this.isPoseNew = false;
  }

  private fit(renderer: THREE.WebGLRenderer, width: number, height: number): void {
    const ratio = Math.min(QUALITIES[this.quality]!.ratio, window.devicePixelRatio);
    const size = renderer.getSize(new THREE.Vector2());
    if (size.x === width && size.y === height && renderer.getPixelRatio() === ratio) return;
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
  }

  private watchSpeed(): void {
    const now = performance.now();
    const took = now - this.lastDraw - QUALITIES[this.quality]!.gapMs;
    this.lastDraw = now;
    // A still picture is drawn rarely, so a very long time does not mean that the browser is slow.
    if (took > 600) return;
    this.slowPictures = took > SLOW_MS ? this.slowPictures + 1 : 0;
    if (this.slowPictures < SLOW_PICTURES || this.quality + 1 >= QUALITIES.length) return;
    this.slowPictures = 0;
    ++this.quality;
    this.applyQuality();
  }
}
