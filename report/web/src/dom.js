// Elements with text set as text, never as markup: names in a payload may hold anything.
export function el(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

export const byId = (id) => document.getElementById(id);

export const rootFontPx = () => parseFloat(getComputedStyle(document.documentElement).fontSize);

// For what is drawn in pixels: act when the size is another than now.
export function onResize(element, act) {
  let width = element.clientWidth;
  let height = element.clientHeight;
  new ResizeObserver(() => {
    if (element.clientWidth === width && element.clientHeight === height) return;
    width = element.clientWidth;
    height = element.clientHeight;
    if (width > 0 && height > 0) act();
  }).observe(element);
}
