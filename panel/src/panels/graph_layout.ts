// Computes the places of objects and connections in the picture of the object graph.
import dagre from '@dagrejs/dagre';
import type { GraphConnection, GraphObject } from '../protocol';

export interface Placed {
  x: number; // coordinate of the upper left corner
  y: number;
  width: number;
  height: number;
}

export interface Route {
  points: { x: number; y: number }[];
  label: { x: number; y: number };
}

export interface GraphLayout {
  width: number;
  height: number;
  nodes: Map<string, Placed>;
  routes: Map<string, Route>;
}

export const NODE_WIDTH = 172;
const NODE_HEIGHT = 66;
// Objects without connections are drawn small, in rows below the others.
export const LONE_HEIGHT = 40;
const LONE_GAP = 12;
const PORT_GAP = 14;
const LABEL_HEIGHT = 14;
const CHARACTER_WIDTH = 6.4;

// Returns the name of a service without object and type: "Mover" for
// "RCServer.Mover.MoverCommand.S".
export function serviceName(service: string): string {
  return service.split('.')[1] ?? service;
}

// Returns a text that is equal for two graphs if they have the same objects and connections.
export function shapeOf(objects: GraphObject[], connections: GraphConnection[]): string {
  return JSON.stringify([objects.map((each) => each.name), connections.map((each) => each.id)]);
}

interface Port {
  node: string;
  isAfter: boolean; // whether the port is on the side of the node towards later ranks
  route: Route;
  isEnd: boolean;
}

export function layOut(
  objects: GraphObject[],
  connections: GraphConnection[],
  direction: 'LR' | 'TB',
): GraphLayout {
  const graph = new dagre.graphlib.Graph({ multigraph: true });
  graph.setGraph({ rankdir: direction, nodesep: 14, ranksep: direction === 'LR' ? 14 : 60, edgesep: 4 });
  graph.setDefaultEdgeLabel(() => ({}));
  const ends = connections.flatMap((each) => [each.from, each.to]);
  for (const name of new Set(ends)) {
    // Makes the node large enough for its ports. They share two sides of the node, and each needs
    // room.
    const ports = ends.filter((each) => each === name).length;
    const room = (ports + 1) * PORT_GAP;
    const isFlat = direction === 'LR';
    graph.setNode(name, {
      width: isFlat ? NODE_WIDTH : Math.max(NODE_WIDTH, room * 1.2),
      height: isFlat ? Math.max(NODE_HEIGHT, room * 0.8) : NODE_HEIGHT,
    });
  }
  for (const each of connections) {
    const width = labelWidth(each);
    graph.setEdge(each.from, each.to, { width, height: LABEL_HEIGHT, labelpos: 'c' }, each.id);
  }
  dagre.layout(graph);
  const layout: GraphLayout = { width: 0, height: 0, nodes: new Map(), routes: new Map() };
  for (const name of graph.nodes()) {
    const { x, y, width, height } = graph.node(name);
    layout.nodes.set(name, { x: x - width / 2, y: y - height / 2, width, height });
  }
  for (const edge of graph.edges()) {
    const { points, x, y } = graph.edge(edge) as { points: Route['points']; x: number; y: number };
    if (edge.name !== undefined) layout.routes.set(edge.name, { points, label: { x, y } });
  }
  spreadPorts(layout, connections, direction === 'LR');
  makeRoomForLabels(layout, connections);
  layout.width = Math.max(layout.width, graph.graph().width ?? 0);
  layout.height = connections.length > 0 ? (graph.graph().height ?? 0) : 0;
  addLoneObjects(layout, objects);
  return layout;
}

// Places the ends of the lines at a node side by side, in the order of the places to which the
// lines lead.
function spreadPorts(layout: GraphLayout, connections: GraphConnection[], isFlat: boolean): void {
  const sides = new Map<string, Port[]>();
  const add = (port: Port) => {
    const key = `${port.node}/${port.isAfter}`;
    sides.set(key, [...(sides.get(key) ?? []), port]);
  };
  for (const each of connections) {
    const [from, to] = [layout.nodes.get(each.from), layout.nodes.get(each.to)];
    const route = layout.routes.get(each.id);
    if (from === undefined || to === undefined || route === undefined || each.from === each.to) continue;
    const isForward = isFlat ? from.x < to.x : from.y < to.y;
    add({ node: each.from, isAfter: isForward, route, isEnd: false });
    add({ node: each.to, isAfter: !isForward, route, isEnd: true });
  }
  for (const ports of sides.values()) {
    const next = (port: Port) => port.route.points[port.isEnd ? port.route.points.length - 2 : 1] ?? port.route.label;
    ports.sort((a, b) => (isFlat ? next(a).y - next(b).y : next(a).x - next(b).x));
    ports.forEach((port, i) => {
      const node = layout.nodes.get(port.node) as Placed;
      const share = (i + 1) / (ports.length + 1);
      const at = isFlat
        ? { x: node.x + (port.isAfter ? node.width : 0), y: node.y + share * node.height }
        : { x: node.x + share * node.width, y: node.y + (port.isAfter ? node.height : 0) };
      port.route.points[port.isEnd ? port.route.points.length - 1 : 0] = at;
    });
  }
}

function labelWidth(connection: GraphConnection): number {
  return (serviceName(connection.subject).length + 6) * CHARACTER_WIDTH;
}

// Makes room for labels that reach over an edge of the picture: moves them in at the left, and
// makes the picture wider at the right.
function makeRoomForLabels(layout: GraphLayout, connections: GraphConnection[]): void {
  for (const each of connections) {
    const label = layout.routes.get(each.id)?.label;
    if (label === undefined) continue;
    label.x = Math.max(label.x, labelWidth(each) / 2);
    layout.width = Math.max(layout.width, label.x + labelWidth(each) / 2);
  }
}

function addLoneObjects(layout: GraphLayout, objects: GraphObject[]): void {
  const lone = objects.filter((each) => !layout.nodes.has(each.name));
  layout.width = Math.max(layout.width, NODE_WIDTH);
  const perRow = Math.max(1, Math.floor((layout.width + LONE_GAP) / (NODE_WIDTH + LONE_GAP)));
  const top = layout.height + (layout.height > 0 && lone.length > 0 ? LONE_GAP * 1.5 : 0);
  lone.forEach((each, i) => {
    layout.nodes.set(each.name, {
      x: (i % perRow) * (NODE_WIDTH + LONE_GAP),
      y: top + Math.floor(i / perRow) * (LONE_HEIGHT + LONE_GAP),
      width: NODE_WIDTH,
      height: LONE_HEIGHT,
    });
  });
  const rows = Math.ceil(lone.length / perRow);
  layout.height = top + Math.max(0, rows * (LONE_HEIGHT + LONE_GAP) - LONE_GAP);
}

// Returns a smooth line through `points`: straight to the middle of each section, and rounded at
// each corner.
export function curveThrough(points: { x: number; y: number }[]): string {
  const at = (p: { x: number; y: number }) => `${p.x.toFixed(1)},${p.y.toFixed(1)}`;
  const first = points[0];
  const last = points[points.length - 1];
  if (first === undefined || last === undefined) return '';
  let path = `M${at(first)}`;
  for (let i = 1; i + 1 < points.length; ++i) {
    const corner = points[i] as { x: number; y: number };
    const next = points[i + 1] as { x: number; y: number };
    const isLast = i + 2 === points.length;
    const end = isLast ? next : { x: (corner.x + next.x) / 2, y: (corner.y + next.y) / 2 };
    path += `Q${at(corner)} ${at(end)}`;
  }
  return points.length === 2 ? `${path}L${at(last)}` : path;
}
