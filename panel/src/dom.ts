// Helper functions that make elements of the page. Text from the run is inserted as text and never
// as HTML.

type Child = Node | string | null;
export type Attributes = Record<string, string | number | boolean | undefined>;

function setAttributes(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    element.setAttribute(name, value === true ? '' : String(value));
  }
}

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  setAttributes(element, attributes);
  for (const child of children) if (child !== null) element.append(child);
  return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  setAttributes(element, attributes);
  for (const child of children) if (child !== null) element.append(child);
  return element;
}

export function button(
  label: string,
  onClick: (event: MouseEvent) => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const element = el('button', { type: 'button', ...attributes }, label);
  element.addEventListener('click', onClick);
  return element;
}

// Sets the text of `element` only if it differs, because most values stay the same from event to
// event.
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

// Sets or removes a class of `element`, if that changes anything.
export function setClass(element: Element, name: string, isSet: boolean): void {
  if (element.classList.contains(name) !== isSet) element.classList.toggle(name, isSet);
}

export function setDisabled(
  element: HTMLButtonElement | HTMLInputElement | HTMLSelectElement,
  isDisabled: boolean,
): void {
  if (element.disabled !== isDisabled) element.disabled = isDisabled;
}

export function isVisible(element: HTMLElement): boolean {
  return element.isConnected && element.offsetParent !== null && !document.hidden;
}

// Offers the user to save `text` as a file.
export function saveFile(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = el('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
