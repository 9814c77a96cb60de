// Messages between the page and the run, as docs/inputs.md describes them. Every member may be
// missing, because an older run sends fewer members, and a run that has just begun does not know
// all of them.

export type Pose = [number, number, number, number, number, number, number];
export type Vec3 = [number, number, number];

export interface ShapeData {
  size: Vec3;
  radius: number;
  pose: Pose;
  colour: string;
  gloss?: number;
  cylinder?: boolean;
  triangles?: number[]; // x, y, z of three corners for each triangle, which are drawn and not the box
  led?: number;
  glow?: string;
  glow_b?: string; // in mode B of the face lights of the ERS-7
  ear?: number;
  axis?: Vec3;
  pivot?: Vec3;
  touch?: string;
  thing?: number; // index in RobotPose.things, if the shape is a thing that can move
}

export interface JointData {
  name: string;
  title: string;
  locator: string;
  min_deg: number;
  max_deg: number;
  max_speed: number;
  max_accel: number;
  accel?: number;
}

export interface SensorData {
  name: string;
  long_name: string;
  locator: string;
  unit: string;
  press?: boolean;
  settable?: boolean;
  min?: number;
  max?: number;
}

export interface DeviceData {
  name: string;
  locator: string;
}

export interface RobotData {
  links: { name: string; shapes: ShapeData[] }[];
  joints: JointData[];
  leds: DeviceData[];
  ears: DeviceData[];
  sensors: SensorData[];
}

export interface WorldData {
  shapes: ShapeData[];
  floor?: string; // colour of the floor, if the world file gives one
}

export interface Scene {
  time_s: number;
  model: string;
  body: string;
  grid_m: number;
  world: WorldData;
  together?: boolean; // all robots are in one world
  robots: RobotData[];
}

export interface RobotPose {
  links: Pose[];
  leds: number[]; // brightness, 0 to 1
  mode_b?: boolean; // the face lights of the ERS-7 are in mode B
  ears: number[];
  things?: Pose[]; // poses of the things that can move
}

export interface PoseEvent {
  event: 'pose';
  time_s: number;
  robots: RobotPose[];
}

export interface RobotValues {
  state: string;
  // Virtual time at which a robot that is switched off boots again.
  boots_at_s?: number | null;
  joints: [number | null, number | null][];
  gains: number[];
  sensors: (number | null)[];
  battery?: { percent: number; charging: boolean; celsius?: number };
  motors?: boolean;
  held?: boolean;
  pause_button?: boolean;
}

export interface ValuesEvent {
  event: 'values';
  time_s: number;
  robots: RobotValues[];
}

export interface GraphObject {
  robot: number;
  name: string;
  state: string;
  messages: number;
  per_s: number;
  waiting: number;
  waits_for: string;
  cost_us: number;
  findings: number;
}

export interface GraphConnection {
  id: string;
  robot: number;
  from: string;
  to: string;
  subject: string;
  observer: string;
  ready: boolean | null;
  waiting: number;
  sent: number;
  per_s: number;
}

export interface GraphEvent {
  event: 'graph';
  time_s: number;
  objects: GraphObject[];
  connections: GraphConnection[];
}

export interface Finding {
  severity: string;
  robot: number;
  object: string;
  time_s: number;
  count?: number;
  message?: number; // number of the message that was handled; 0: none
  said?: string; // content of this message in words; '' if it is not known
  text: string;
}

export interface FindingsEvent {
  event: 'findings';
  time_s: number;
  findings: Finding[];
}

export interface LogLine {
  time_s: number;
  text: string;
}

export interface LogEvent {
  event: 'log';
  lines: LogLine[];
}

export interface Rewind {
  possible: boolean;
  why?: string;
  from_s?: number;
  to_s?: number;
  checkpoints?: number;
  memory_mb?: number;
  shows_s?: number | null;
  message?: number | null;
}

export interface Clock {
  time_s: number;
  messages: number;
  paused: boolean;
  rate: number;
  speed: number;
  rewind?: Rewind;
  // For a recording or another run that nobody can change: its length, and the reason why it is
  // over.
  length_s?: number;
  over?: string;
}

export interface UploadEvent {
  event: 'upload';
  id: number;
  sent: number;
  size: number;
}

export interface RunEntry {
  name: string;
  process: number;
  run: string;
  model?: string;
  time_s?: number;
}

export interface Runs {
  runs: RunEntry[];
  own: string;
}

export interface ConnectionMessage {
  number: number;
  time_s: number;
  size: number;
  text: string;
  hex?: string;
}

export interface Motion {
  name: string;
  size: number;
}

export interface PlayAnswer {
  duration_s: number;
  key_frames: number;
  loops: number;
}

export interface RemoteJoint {
  name: string;
  speed: number;
  accel: number;
}

// The answer to the request that connects a second robot.
export interface PairAnswer {
  endpoint: string;
  model: string;
  software: string;
  first_time: boolean;
  joints: RemoteJoint[];
}

export interface PairEvent {
  event: 'pair';
  pair: unknown; // id of the request that has connected the second robot
  robot: number;
  endpoint: string;
  state: 'connected' | 'lost' | 'closed';
  why?: string;
  follow?: string;
  round_trip_ms?: number | null;
  run_round_trip_ms?: number | null;
  lag_ms?: number | null;
  robot_state?: string;
  deg?: number[];
  motion?: string;
  key_frame?: number;
  key_frames?: number;
  refusal?: { simulation: string; robot: string };
}

export type Request = { do: string } & Record<string, unknown>;
export type Answer = Record<string, unknown>;
