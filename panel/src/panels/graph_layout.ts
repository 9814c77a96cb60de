// Places of objects and connections in the picture of the object graph.
import dagre from '@dagrejs/dagre';
import type { GraphConnection, GraphObject } from '../protocol';

export interface Placed {
  x: number; // upper left corner
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

export const NODE_WIDTH = 178;
export const NODE_HEIGHT = 66;
const LABEL_HEIGHT = 15;
const CHARACTER_WIDTH = 6.2;

// "RCServer.Mover.MoverCommand.S" is the service "Mover".
export function serviceName(service: string): string {
  return service.split('.')[1] ?? service;
}

// Text that is the same for two graphs with the same objects and connections.
export function shapeOf(objects: GraphObject[], connections: GraphConnection[]): string {
  return JSON.stringify([objects.map((each) => each.name), connections.map((each) => each.id)]);
}

export function layOut(
  objects: GraphObject[],
  connections: GraphConnection[],
  direction: 'LR' | 'TB',
): GraphLayout {
  const graph = new dagre.graphlib.Graph({ multigraph: true });
  graph.setGraph({
    rankdir: direction,
    nodesep: 14,
    ranksep: direction === 'LR' ? 26 : 22,
    edgesep: 8,
    marginx: 8,
    marginy: 8,
  });
  graph.setDefaultEdgeLabel(() => ({}));
  for (const object of objects)
    graph.setNode(object.name, { width: NODE_WIDTH, height: NODE_HEIGHT });
  for (const each of connections) {
    // An object that has gone may still have connections.
    for (const name of [each.from, each.to])
      if (!graph.hasNode(name)) graph.setNode(name, { width: NODE_WIDTH, height: NODE_HEIGHT });
    const label = serviceName(each.subject).length + 8;
    graph.setEdge(
      each.from,
      each.to,
      { width: label * CHARACTER_WIDTH, height: LABEL_HEIGHT, labelpos: 'c' },
      each.id,
    );
  }
  dagre.layout(graph);
  const nodes = new Map<string, Placed>();
  for (const name of graph.nodes()) {
    const { x, y, width, height } = graph.node(name);
    nodes.set(name, { x: x - width / 2, y: y - height / 2, width, height });
  }
  const routes = new Map<string, Route>();
  for (const edge of graph.edges()) {
    const { points, x, y } = graph.edge(edge) as { points: Route['points']; x: number; y: number };
    if (edge.name !== undefined) routes.set(edge.name, { points, label: { x, y } });
  }
  const { width = 0, height = 0 } = graph.graph();
  return { width, height, nodes, routes };
}

// A smooth line through `points`: straight to the middle of each leg, and around each corner.
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
