// The panel of sensors: for each sensor the value, the unit, a bar over its range and a line of the
// last seconds; and the camera.
import { el, setClass, setText, svg } from '../dom';
import { fixed, quantityOf, sensorText } from '../format';
import { Ring } from '../ring';
import type { SensorData } from '../protocol';
import type { Session } from '../session';
import { makeCamera } from './camera';

const SPARK_SAMPLES = 60;
const SPARK_WIDTH = 72;
const SPARK_HEIGHT = 16;

interface Range {
  min: number;
  max: number;
}

// Returns the range of a sensor, in the unit that the page shows.
export function rangeOf(sensor: SensorData): Range {
  const quantity = quantityOf(sensor.unit);
  if (sensor.unit === 'temperature') return { min: quantity.min, max: quantity.max };
  const min = sensor.min === undefined ? quantity.min : sensor.min * quantity.scale;
  const max = sensor.max === undefined ? quantity.max : sensor.max * quantity.scale;
  return max > min ? { min, max } : { min: quantity.min, max: quantity.max };
}

export function sparkPath(values: (number | null)[], { min, max }: Range): string {
  let path = '';
  let isPen = false;
  values.forEach((value, i) => {
    if (value === null) {
      isPen = false;
      return;
    }
    const share = Math.min(1, Math.max(0, (value - min) / (max - min)));
    const x = (i / (SPARK_SAMPLES - 1)) * SPARK_WIDTH;
    const y = SPARK_HEIGHT - 1 - share * (SPARK_HEIGHT - 2);
    path += `${isPen ? 'L' : 'M'}${x.toFixed(1)},${y.toFixed(1)}`;
    isPen = true;
  });
  return path;
}

class SensorRow {
  readonly element: HTMLElement;
  private readonly value = el('span', { class: 'value' });
  private readonly bar = el('span', { class: 'level', 'aria-hidden': true }, el('i'));
  private readonly line = svg('path', {});
  private readonly past = new Ring<number | null>(SPARK_SAMPLES);
  private readonly range: Range;

  constructor(private readonly sensor: SensorData) {
    this.range = rangeOf(sensor);
    const picture = svg(
      'svg',
      { class: 'spark', viewBox: `0 0 ${SPARK_WIDTH} ${SPARK_HEIGHT}`, 'aria-hidden': true },
      this.line,
    );
    const title = sensor.long_name || sensor.name;
    this.element = el(
      'div',
      { class: 'sensor', role: 'listitem', 'data-sensor': sensor.name, title: `${title}\n${sensor.locator}` },
      el('span', { class: 'name' }, (sensor.name || title).replace(/_/g, ' ')),
      picture as unknown as HTMLElement,
      this.bar,
      this.value,
    );
    const { min, max } = this.range;
    this.bar.style.setProperty('--zero', String(Math.min(1, Math.max(0, -min / (max - min)))));
  }

  add(raw: number | null | undefined): void {
    this.past.push(this.inUnit(raw));
  }

  private inUnit(raw: number | null | undefined): number | null {
    return raw === null || raw === undefined ? null : raw * quantityOf(this.sensor.unit).scale;
  }

  show(raw: number | null | undefined): void {
    const value = this.inUnit(raw);
    setText(this.value, sensorText(raw, this.sensor.unit));
    setClass(this.element, 'unknown', value === null);
    setClass(this.element, 'on', this.sensor.unit === 'switch' && value !== null && value !== 0);
    const { min, max } = this.range;
    const share = value === null ? 0 : Math.min(1, Math.max(0, (value - min) / (max - min)));
    this.bar.style.setProperty('--at', share.toFixed(4));
    this.line.setAttribute('d', sparkPath(this.past.toArray(), this.range));
  }
}

export function makeSensors(session: Session): HTMLElement {
  const list = el('div', { class: 'sensor-list', role: 'list' });
  const battery = el('span', { class: 'value' });
  const celsius = el('span', { class: 'value' });
  const level = el('span', { class: 'level' }, el('i'));
  const power = el(
    'div',
    { class: 'sensor-list' },
    el('div', { class: 'sensor' }, el('span', { class: 'name' }, 'battery'), el('span', { class: 'spark' }), level, battery),
    el('div', { class: 'sensor' }, el('span', { class: 'name' }, 'battery temp.'), el('span', { class: 'spark' }), el('span'), celsius),
  );
  const element = el('div', { class: 'sensors' }, list, power, makeCamera(session));
  let rows: SensorRow[] = [];
  const build = () => {
    const sensors = session.scene?.robots[session.robot]?.sensors ?? [];
    rows = sensors.map((each) => new SensorRow(each));
    list.replaceChildren(...rows.map((each) => each.element));
  };
  session.on('scene', build);
  session.on('robot', build);
  const show = (isNew: boolean) => {
    const robot = session.values?.robots[session.robot];
    if (robot === undefined) return;
    const isShown = element.offsetParent !== null;
    rows.forEach((row, i) => {
      if (isNew) row.add(robot.sensors?.[i]);
      if (isShown) row.show(robot.sensors?.[i]);
    });
    const percent = robot.battery?.percent;
    setText(battery, percent === undefined ? 'unknown' : `${percent} %${robot.battery?.charging ? ' charging' : ''}`);
    setText(celsius, robot.battery?.celsius === undefined ? 'unknown' : `${fixed(robot.battery.celsius, 1)} °C`);
    level.style.setProperty('--at', String((percent ?? 0) / 100));
  };
  session.on('values', () => show(true));
  window.addEventListener('panel-shown', () => show(false));
  return element;
}
