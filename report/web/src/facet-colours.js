// The colour of every shown facet, packed as the mesh takes it: red, green, blue, and whether it is shaded.
import { materialPalette, rgbOf, unseenColour, viridis } from './colour.js';

export const colourings = {
  contribution: 'return per area',
  seen: 'seen fraction',
  part: 'part',
  material: 'material',
};

const shaded = 255;
export const packed = ([red, green, blue], shade) => (red | (green << 8) | (blue << 16) | (shade << 24)) >>> 0;

export function levelDb(shown, level) {
  return level <= 1 ? shown.floor_db : shown.floor_db + (level - 1) * shown.step_db;
}

function contributionTable(shown, floorDb) {
  const table = new Uint32Array(256);
  table[0] = packed(rgbOf(unseenColour), shaded);
  for (let level = 1; level < 256; ++level) table[level] = packed(viridis(1 - levelDb(shown, level) / floorDb), 0);
  return table;
}

function seenTable() {
  const table = new Uint32Array(256);
  table[0] = packed(rgbOf(unseenColour), shaded);
  for (let seen = 1; seen < 256; ++seen) table[seen] = packed(viridis(seen / 255), 0);
  return table;
}

export const materialColour = (material) => materialPalette[material % materialPalette.length];

// One colour a facet. stored: index into stored_rows, or -1. material: of the side that is coloured, one a facet.
export function facetColours(data, facets, ranking, { colouring, stored, floorDb }, material, out) {
  if (colouring === 'part' || colouring === 'material') {
    const names = colouring === 'part' ? ranking.colours : data.materials.map((_, k) => materialColour(k));
    const table = names.map((name) => packed(rgbOf(name), shaded));
    const group = colouring === 'part' ? facets.part : material;
    for (let f = 0; f < out.length; ++f) out[f] = table[group[f]];
    return;
  }
  if (stored < 0) {
    out.fill(packed(rgbOf(unseenColour), shaded));
    return;
  }
  const table = colouring === 'seen' ? seenTable() : contributionTable(data.shown, floorDb);
  const value = colouring === 'seen' ? facets.seen(stored) : facets.level(stored);
  for (let f = 0; f < out.length; ++f) out[f] = table[value[f]];
}
