// The facets drawn by the processor, with a depth for every pixel: the first picture, before WebGL can draw one, and
// every picture where there is no WebGL 2. Of what WebGL draws, creases and a part's outline through others are left out.
import { Matrix4 } from 'three';
import { highlight, rgbOf } from './colour.js';
import { packed } from './facet-colours.js';

const mark = packed(rgbOf(highlight), 255);

export class SoftPicture {
  constructor(canvas, facets) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', { willReadFrequently: true });
    this.facets = facets;
    this.place = new Float32Array(facets.positions.length);
    this.corners = new Int32Array(4);
    this.setSize(1, 1);
  }

  setSize(width, height) {
    Object.assign(this.canvas, { width, height });
    this.image = this.context.createImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.depth = new Float32Array(width * height);
  }

  // colours: of fronts and backs, one a facet; selected: the part that is hatched, or -1; ratio: pixels that are one of the page.
  draw(camera, colours, selected, ratio) {
    const { triangles, part, count } = this.facets;
    this.pixels.fill(0xffffffff);
    this.depth.fill(-Infinity);
    this.project(camera);
    for (let f = 0; f < count; ++f) {
      this.corners[0] = this.corners[3] = 3 * triangles[3 * f];
      this.corners[1] = 3 * triangles[3 * f + 1];
      this.corners[2] = 3 * triangles[3 * f + 2];
      this.fill(colours.front[f], colours.back[f], part[f] === selected ? ratio : 0);
    }
    this.context.putImageData(this.image, 0, 0);
  }

  // Vertices to pixels from the top left; depth grows toward the viewer, in pixels, too.
  project(camera) {
    const { place, canvas, facets } = this;
    const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    const view = camera.matrixWorldInverse.elements;
    const [across, up] = [0.5 * canvas.width, 0.5 * canvas.height];
    const scale = across * camera.projectionMatrix.elements[0];
    for (let v = 0; v < place.length; v += 3) {
      const x = facets.positions[v];
      const y = facets.positions[v + 1];
      const z = facets.positions[v + 2];
      place[v] = across * (1 + m[0] * x + m[4] * y + m[8] * z + m[12]);
      place[v + 1] = up * (1 - m[1] * x - m[5] * y - m[9] * z - m[13]);
      place[v + 2] = scale * (view[2] * x + view[6] * y + view[10] * z + view[14]);
    }
  }

  // The pixels whose middles are in the triangle of the corners, row by row.
  fill(front, back, hatch) {
    const { place, corners } = this;
    const [a, b, c] = corners;
    const ux = place[b] - place[a];
    const uy = place[b + 1] - place[a + 1];
    const uz = place[b + 2] - place[a + 2];
    const vx = place[c] - place[a];
    const vy = place[c + 1] - place[a + 1];
    const vz = place[c + 2] - place[a + 2];
    const area = ux * vy - uy * vx;
    if (area === 0) return;
    const right = (uz * vy - vz * uy) / area;
    const down = (vz * ux - uz * vx) / area;
    const painted = shaded(area < 0 ? front : back, 1 / Math.sqrt(1 + right * right + down * down));
    const [top, bottom] = [Math.min(0, uy, vy) + place[a + 1], Math.max(0, uy, vy) + place[a + 1]];
    const last = Math.min(Math.ceil(bottom - 0.5), this.canvas.height);
    for (let row = Math.max(Math.ceil(top - 0.5), 0); row < last; ++row) {
      const depth = place[a + 2] + right * (0.5 - place[a]) + down * (row + 0.5 - place[a + 1]);
      this.fillRow(row, depth, right, painted, hatch);
    }
  }

  fillRow(row, depthAtLeft, right, colour, hatch) {
    const { place, corners, pixels, depth } = this;
    const { width } = this.canvas;
    const y = row + 0.5;
    let low = Infinity;
    let high = -Infinity;
    for (let k = 0; k < 3; ++k) {
      let p = corners[k];
      let q = corners[k + 1];
      if ((place[p + 1] <= y) === (place[q + 1] <= y)) continue;
      // From the upper end, so that facets on both sides of an edge agree.
      if (place[p + 1] > place[q + 1]) [p, q] = [q, p];
      const x = place[p] + ((y - place[p + 1]) * (place[q] - place[p])) / (place[q + 1] - place[p + 1]);
      if (x < low) low = x;
      if (x > high) high = x;
    }
    const last = Math.min(Math.ceil(high - 0.5), width);
    for (let x = Math.max(Math.ceil(low - 0.5), 0); x < last; ++x) {
      const at = row * width + x;
      const here = depthAtLeft + right * x;
      if (here <= depth[at]) continue;
      depth[at] = here;
      pixels[at] = hatch > 0 && (x + this.canvas.height - row) % (8 * hatch) < 2 * hatch ? mark : colour;
    }
  }
}

// As the shader of facet-mesh.js does it; away: cosine of the facet's normal with the line of sight.
function shaded(colour, away) {
  const share = colour >>> 24 > 0 ? 0.8 + 0.2 * away : 1;
  const channel = (shift) => Math.round(((colour >>> shift) & 255) * share) << shift;
  return (0xff000000 | channel(16) | channel(8) | channel(0)) >>> 0;
}
