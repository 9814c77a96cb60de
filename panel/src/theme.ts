// The theme of the page, light or dark: that of the system, or the one that a person has chosen.

const KEY = 'openr-panel-theme';
export type Theme = 'auto' | 'light' | 'dark';

function stored(): Theme {
  try {
    const theme = localStorage.getItem(KEY);
    return theme === 'light' || theme === 'dark' ? theme : 'auto';
  } catch {
    return 'auto';
  }
}

const darkQuery = window.matchMedia('(prefers-color-scheme: dark)');
let theme: Theme = stored();
const listeners: (() => void)[] = [];

export function isDark(): boolean {
  return theme === 'dark' || (theme === 'auto' && darkQuery.matches);
}

function apply(): void {
  document.documentElement.dataset['theme'] = isDark() ? 'dark' : 'light';
  for (const listener of listeners) listener();
}

export function onTheme(listener: () => void): void {
  listeners.push(listener);
}

export function switchTheme(): void {
  theme = isDark() ? 'light' : 'dark';
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // Ignores the error: the choice then lasts only until the page is closed.
  }
  apply();
}

export function startTheme(): void {
  darkQuery.addEventListener('change', apply);
  apply();
}

// Returns the value of a colour in the style sheet.
export function colourOf(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
