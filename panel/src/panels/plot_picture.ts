// PlotPicture: the chosen series as an SVG picture, with one lane for each unit. The saved file is
// the same picture.
import { svg } from '../dom';
import { fixed } from '../format';
import { pathOf, rangeAround, ticks, type History, type Series } from './plot_data';

export interface PlotColours {
  background: string;
  text: string;
  muted: string;
  line: string;
  series: string[];
}

export interface PlotRequest {
  series: Series[];
  robot: number;
  from: number;
  to: number;
  width: number;
  height: number;
  cursor: number | null; // the moment of the past that the page shows; null: the present
  colours: PlotColours;
}

const LEFT = 46;
const RIGHT = 10;
const TOP = 6;
const BOTTOM = 18;
const GAP = 8;
const LEGEND = 15; // height of a row with the names of lines, above each lane
const CHARACTER = 6;
const FONT = 'ui-sans-serif, system-ui, sans-serif';

// Returns the number of a colour. The commanded and the measured line of a joint have the same
// colour, and differ by their dashes.
export function colourIndex(all: Series[], series: Series): number {
  const key = (each: Series) => each.id.split(':').slice(0, 2).join(':');
  const keys = [...new Set(all.map(key))];
  return keys.indexOf(key(series));
}

function text(x: number, y: number, content: string, colour: string, more: Record<string, string> = {}): SVGTextElement {
  return svg('text', { x: x.toFixed(1), y: y.toFixed(1), fill: colour, 'font-size': 10.5, 'font-family': FONT, ...more }, content);
}

function digitsFor(step: number): number {
  return step >= 1 ? 0 : Math.min(4, Math.ceil(-Math.log10(step) - 1e-9));
}

interface Lane {
  unit: string;
  series: Series[];
  top: number;
  height: number;
}

interface Name {
  text: string;
  x: number;
  row: number;
}

// Places the names of lines side by side, in as many rows as necessary.
function placeNames(names: string[], width: number): Name[] {
  let x = LEFT;
  let row = 0;
  return names.map((name) => {
    const length = 34 + name.length * CHARACTER;
    if (x > LEFT && x + length > width) {
      x = LEFT;
      ++row;
    }
    const placed = { text: name, x, row };
    x += length;
    return placed;
  });
}

function drawLane(
  parent: SVGElement,
  history: History,
  plot: PlotRequest,
  lane: Lane,
  x: (t: number) => number,
): void {
  const { colours } = plot;
  const lines = lane.series.map((each) => history.points(each, plot.robot, plot.from, plot.to));
  const unit = lane.unit === '0/1' ? '' : lane.unit;
  const names = placeNames(
    lane.series.map((each, i) => {
      const points = lines[i] ?? [];
      return `${each.label} ${fixed(points[points.length - 1]?.[1] ?? null, 2)} ${unit}`.trim();
    }),
    plot.width,
  );
  const top = lane.top + LEGEND * ((names[names.length - 1]?.row ?? 0) + 1) + 2;
  const height = Math.max(10, lane.top + lane.height - top);
  const values = lines.flatMap((points) => points.flatMap(([, value]) => (value === null ? [] : [value])));
  const { min, max } = rangeAround(values, lane.unit);
  const y = (value: number) => top + height * (1 - (value - min) / (max - min));
  drawMarks(parent, plot, lane.unit === '0/1' ? [0, 1] : ticks(min, max, Math.max(2, Math.floor(height / 30))), y);
  lines.forEach((points, i) => {
    const series = lane.series[i] as Series;
    const name = names[i] as Name;
    const colour = colours.series[colourIndex(plot.series, series) % colours.series.length] as string;
    const style = { fill: 'none', stroke: colour, 'stroke-width': 1.5, 'stroke-dasharray': series.isDashed ? '4 3' : undefined };
    const middle = lane.top + name.row * LEGEND + 8;
    parent.append(
      svg('path', { d: pathOf(points, x, y), ...style, 'stroke-linejoin': 'round' }),
      svg('path', { d: `M${name.x},${middle}h16`, ...style }),
      text(name.x + 20, middle + 3.5, name.text, colours.text, { 'data-series': series.id }),
    );
  });
}

function drawMarks(parent: SVGElement, plot: PlotRequest, marks: number[], y: (value: number) => number): void {
  const step = (marks[1] ?? 1) - (marks[0] ?? 0) || 1;
  for (const mark of marks) {
    parent.append(
      svg('path', { d: `M${LEFT},${y(mark).toFixed(1)}H${plot.width - RIGHT}`, stroke: plot.colours.line, 'stroke-width': 1 }),
      text(LEFT - 6, y(mark) + 3.5, fixed(mark, digitsFor(step)), plot.colours.muted, { 'text-anchor': 'end' }),
    );
  }
}

export function drawPlot(history: History, plot: PlotRequest): SVGSVGElement {
  const { width, height, colours, from, to } = plot;
  const picture = svg('svg', {
    xmlns: 'http://www.w3.org/2000/svg',
    viewBox: `0 0 ${width} ${height}`,
    width,
    height,
    role: 'img',
    'aria-label': `Plot of ${plot.series.map((each) => each.label).join(', ')}`,
  });
  picture.append(svg('rect', { width, height, fill: colours.background }));
  const x = (t: number) => LEFT + ((t - from) / Math.max(1e-9, to - from)) * (width - LEFT - RIGHT);
  for (const t of ticks(from, to, Math.max(2, Math.floor(width / 90)))) {
    picture.append(
      svg('path', { d: `M${x(t).toFixed(1)},${TOP}V${height - BOTTOM}`, stroke: colours.line, 'stroke-width': 1 }),
      text(x(t), height - 4, `${fixed(t, to - from < 5 ? 1 : 0)} s`, colours.muted, { 'text-anchor': 'middle' }),
    );
  }
  const units = [...new Set(plot.series.map((each) => each.unit))];
  const laneHeight = (height - TOP - BOTTOM - GAP * (units.length - 1)) / Math.max(1, units.length);
  units.forEach((unit, i) => {
    const series = plot.series.filter((each) => each.unit === unit);
    drawLane(picture, history, plot, { unit, series, top: TOP + i * (laneHeight + GAP), height: laneHeight }, x);
  });
  if (plot.cursor !== null && plot.cursor >= from && plot.cursor <= to) {
    picture.append(
      svg('path', { d: `M${x(plot.cursor).toFixed(1)},${TOP}V${height - BOTTOM}`, stroke: colours.text, 'stroke-width': 1.5 }),
    );
  }
  return picture;
}
