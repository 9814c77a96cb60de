// Formats numbers and times for the page.

export const UNKNOWN = 'unknown';

const MINUS = '\u2212';

function withMinus(text: string): string {
  return text.startsWith('-') ? MINUS + text.slice(1) : text;
}

export function fixed(value: number | null | undefined, digits: number): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return UNKNOWN;
  const text = value.toFixed(digits);
  return withMinus(Number(text) === 0 ? text.replace('-', '') : text);
}

export function degrees(value: number | null | undefined): string {
  const text = fixed(value, 1);
  return text === UNKNOWN ? text : `${text}°`;
}

// Formats a virtual time: 75.25 is "1:15.250".
export function clockTime(seconds: number): string {
  if (!Number.isFinite(seconds)) return '0:00.000';
  const ms = Math.round(Math.abs(seconds) * 1000);
  const minutes = Math.floor(ms / 60000);
  const rest = ((ms % 60000) / 1000).toFixed(3).padStart(6, '0');
  return `${seconds < 0 ? MINUS : ''}${minutes}:${rest}`;
}

export function rateText(perSecond: number): string {
  if (!(perSecond > 0)) return '0/s';
  return perSecond < 10 ? `${perSecond.toFixed(1)}/s` : `${Math.round(perSecond)}/s`;
}

export function costText(us: number): string {
  if (!(us > 0)) return '0 µs';
  if (us >= 1000) return `${(us / 1000).toFixed(us >= 10000 ? 0 : 1)} ms`;
  return us < 10 ? `${us.toFixed(1)} µs` : `${Math.round(us)} µs`;
}

export function sizeText(bytes: number): string {
  if (bytes < 1024) return `${bytes} B`;
  return bytes < 1024 * 1024 ? `${(bytes / 1024).toFixed(1)} KiB` : `${(bytes / 1048576).toFixed(1)} MiB`;
}

interface Quantity {
  scale: number;
  symbol: string;
  digits: number;
  min: number;
  max: number;
}

// Units of sensors. The run sends values in OPEN-R units, such as 10^-6 N; the page shows SI units.
const quantities: Record<string, Quantity> = {
  switch: { scale: 1, symbol: '', digits: 0, min: 0, max: 1 },
  force: { scale: 1e-6, symbol: 'N', digits: 3, min: 0, max: 1 },
  length: { scale: 1e-6, symbol: 'm', digits: 3, min: 0, max: 1 },
  temperature: { scale: 1e-6, symbol: '°C', digits: 1, min: 0, max: 60 },
  acceleration: { scale: 1e-6, symbol: 'm/s²', digits: 2, min: -20, max: 20 },
};

export function quantityOf(unit: string): Quantity {
  return quantities[unit] ?? { scale: 1, symbol: unit, digits: 0, min: 0, max: 1023 };
}

export function sensorText(value: number | null | undefined, unit: string): string {
  if (value === null || value === undefined) return UNKNOWN;
  if (unit === 'switch') return value !== 0 ? 'pressed' : 'released';
  const quantity = quantityOf(unit);
  return `${fixed(value * quantity.scale, quantity.digits)} ${quantity.symbol}`.trim();
}
