// Over the target: arrows toward transmitter and receiver, and the axes of the body.
import { Vector3 } from 'three';
import { axisColours, ink, transmitterColour } from './colour.js';
import { rootFontPx, svg } from './dom.js';

export function drawOverlay(view) {
  const unit = rootFontPx();
  const arrows = view.sensors.map(({ direction }) => arrowAlong(view, direction));
  // By the axes and arrows; then by names, too.
  const taken = [
    { left: 0, right: 9 * unit, top: view.height - 6.5 * unit, bottom: view.height },
    ...arrows.flatMap((arrow) => (arrow.endOn ? [] : boxesAlong(arrow.from, arrow.to, 0.3 * unit))),
  ];
  view.overlay.setAttribute('viewBox', `0 0 ${view.width} ${view.height}`);
  view.overlay.replaceChildren(
    ...view.sensors.map((sensor, k) => sensorArrow(view, sensor, arrows[k], k, unit, taken)),
    axesTriad(view, unit),
  );
}

function inView(view, vector) {
  return new Vector3(...vector).transformDirection(view.camera.matrixWorldInverse);
}

// Ends of its arrow [pixel of the page]. Along the line of sight an arrow is a point.
function arrowAlong(view, direction) {
  const reach = view.reach(new Vector3(...direction));
  const at = (distance) => view.project(new Vector3(...direction).multiplyScalar(distance).add(view.centre));
  const toward = inView(view, direction);
  return {
    toward,
    endOn: Math.hypot(toward.x, toward.y) < 0.1,
    from: at(reach + 0.02 * view.radius),
    to: at(reach + 0.27 * view.radius),
  };
}

function boxesAlong([x0, y0], [x1, y1], half) {
  return [0, 0.2, 0.4, 0.6, 0.8, 1].map((share) => {
    const [x, y] = [x0 + share * (x1 - x0), y0 + share * (y1 - y0)];
    return { left: x - half, right: x + half, top: y - half, bottom: y + half };
  });
}

// taken: boxes that names keep off, to which this one's is added.
function sensorArrow(view, { label }, { toward, endOn, from, to }, k, unit, taken) {
  const colour = label === 'transmitter' ? transmitterColour : ink;
  // The usual signs for out of and into the page, in the corner.
  if (endOn) {
    taken.push({ left: 0, right: view.width, top: 0, bottom: (2 + 1.5 * k) * unit });
    return endOnArrow(k, toward.z > 0, label, colour, unit);
  }
  const group = svg('g', {});
  const dashes = toward.z < -0.1 ? `${0.4 * unit} ${0.25 * unit}` : null;
  for (const casing of [true, false]) {
    const stroke = { stroke: casing ? '#fff' : colour, 'stroke-width': (casing ? 0.4 : 0.15) * unit, fill: 'none' };
    group.append(svg('path', { d: shaft(from, to), ...stroke, 'stroke-dasharray': casing ? null : dashes }));
    group.append(svg('path', { d: head(from, to, 0.7 * unit), ...stroke, 'stroke-linejoin': 'round' }));
  }
  const [x, y] = placeOfName(view, from, to, 0.55 * unit * label.length, unit, taken);
  group.append(text(x, y, label, colour, 'start'));
  return group;
}

// Left end and base line of a name of an arrow: beyond its head, in the frame, and as far up or down from there as
// keeps it off what is taken.
function placeOfName(view, from, to, wide, unit, taken) {
  const along = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const [right, down] = [(to[0] - from[0]) / along, (to[1] - from[1]) / along];
  const before = right > 0.5 ? 0 : right < -0.5 ? wide : wide / 2;
  const [highest, lowest] = [unit, view.height - 0.4 * unit];
  const left = Math.max(Math.min(to[0] + 0.5 * unit * right - before, view.width - 4 - wide), 4);
  const best = Math.min(Math.max(to[1] + 0.35 * unit + unit * down, highest), lowest);
  const boxAt = (y) => ({ left, right: left + wide, top: y - 0.8 * unit, bottom: y + 0.3 * unit });
  const isFree = (y) => y >= highest && y <= lowest && !taken.some((box) => overlap(box, boxAt(y)));
  const heights = Array.from({ length: 21 }, (_, k) => best + 0.6 * unit * Math.ceil(k / 2) * (k % 2 ? 1 : -1));
  const y = heights.find(isFree) ?? best;
  taken.push(boxAt(y));
  return [left, y];
}

const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

function endOnArrow(k, towardViewer, label, colour, unit) {
  const radius = 0.5 * unit;
  const [x, y] = [1.2 * unit, (1.2 + 1.5 * k) * unit];
  const circle = { cx: x, cy: y, r: radius, fill: '#fff', stroke: colour, 'stroke-width': 2 };
  const d = 0.7 * radius;
  const sign = towardViewer
    ? svg('circle', { cx: x, cy: y, r: 0.25 * radius, fill: colour })
    : svg('path', {
        d: `M${x - d},${y - d}L${x + d},${y + d}M${x - d},${y + d}L${x + d},${y - d}`,
        stroke: colour,
        'stroke-width': 2,
      });
  return svg(
    'g',
    {},
    svg('circle', circle),
    sign,
    text(
      x + 1.6 * radius,
      y + 0.3 * unit,
      `${label}, ${towardViewer ? 'where you look from' : 'on the far side'}`,
      colour,
      'start',
    ),
  );
}

function axesTriad(view, unit) {
  const origin = [6.5 * unit, view.height - 3.4 * unit];
  const axes = [
    ['x', [1, 0, 0], 'x forward'],
    ['y', [0, 1, 0], 'y'],
    ['z', [0, 0, 1], 'z'],
  ];
  const drawn = axes.map(([name, axis, label]) => ({ name, label, seen: inView(view, axis) }));
  drawn.sort((a, b) => a.seen.z - b.seen.z);
  const group = svg('g', {});
  for (const { name, label, seen } of drawn) {
    const length = 2 * unit;
    const to = [origin[0] + length * seen.x, origin[1] - length * seen.y];
    const stroke = { stroke: axisColours[name], 'stroke-width': 0.13 * unit, fill: 'none', 'stroke-linejoin': 'round' };
    group.append(svg('path', { d: shaft(origin, to), ...stroke }));
    if (Math.hypot(seen.x, seen.y) > 0.2) group.append(svg('path', { d: head(origin, to, 0.5 * unit), ...stroke }));
    const anchor = seen.x < -0.2 ? 'end' : seen.x > 0.2 ? 'start' : 'middle';
    const x = to[0] + 0.3 * unit * Math.sign(seen.x) * (anchor === 'middle' ? 0 : 1);
    group.append(text(x, to[1] + 0.3 * unit - 0.7 * unit * seen.y, label, axisColours[name], anchor));
  }
  return group;
}

const shaft = ([x0, y0], [x1, y1]) => `M${x0},${y0}L${x1},${y1}`;

function head([x0, y0], [x1, y1], size) {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  const barb = (turn) => `${x1 - size * Math.cos(angle + turn)},${y1 - size * Math.sin(angle + turn)}`;
  return `M${barb(0.45)}L${x1},${y1}L${barb(-0.45)}`;
}

function text(x, y, label, colour, anchor) {
  const node = svg('text', { x, y, fill: colour, 'text-anchor': anchor, class: 'label' });
  node.textContent = label;
  return node;
}
