// DogFigure: the parts, lights and ears of one robot as three.js objects.
import * as THREE from 'three';
import type { Pose, RobotData, RobotPose, ShapeData } from '../protocol';
import { makeMesh, placeAt } from './shapes';

interface Led {
  index: number;
  mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshStandardMaterial>;
  glow: THREE.Color;
  glowB: THREE.Color;
}

interface Ear {
  index: number;
  pivot: THREE.Group;
  axis: THREE.Vector3;
}

export class DogFigure {
  readonly group = new THREE.Group();
  readonly meshes: THREE.Object3D[] = [];
  private readonly links: THREE.Group[] = [];
  private readonly leds: Led[] = [];
  private readonly ears: Ear[] = [];
  private trunk: Pose = [0, 0, 0.15, 1, 0, 0, 0];

  constructor(robot: RobotData) {
    robot.links.forEach((link, i) => {
      const group = new THREE.Group();
      group.visible = false;
      for (const shape of link.shapes ?? []) this.addShape(group, shape, link.name);
      this.links[i] = group;
      this.group.add(group);
    });
  }

  get trunkPose(): Pose {
    return this.trunk;
  }

  apply(pose: RobotPose): void {
    this.links.forEach((group, i) => {
      const at = pose.links?.[i];
      group.visible = at !== undefined;
      if (at !== undefined) placeAt(group, at);
    });
    if (pose.links?.[0] !== undefined) this.trunk = pose.links[0];
    for (const led of this.leds) {
      led.mesh.material.emissive.copy(pose.mode_b === true ? led.glowB : led.glow);
      led.mesh.material.emissiveIntensity = 1.6 * (pose.leds?.[led.index] ?? 0);
    }
    for (const ear of this.ears)
      ear.pivot.quaternion.setFromAxisAngle(ear.axis, pose.ears?.[ear.index] ?? 0);
  }

  private addShape(group: THREE.Group, shape: ShapeData, link: string): void {
    const mesh = makeMesh(shape);
    mesh.userData = { link, touch: shape.touch ?? null };
    this.meshes.push(mesh);
    placeAt(mesh, shape.pose);
    if (shape.led !== undefined) {
      const glow = new THREE.Color(shape.glow ?? '#ffffff');
      const glowB = shape.glow_b === undefined ? glow : new THREE.Color(shape.glow_b);
      this.leds.push({ index: shape.led, mesh, glow, glowB });
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
}
