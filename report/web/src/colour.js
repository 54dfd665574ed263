// Colours that also colour-blind readers tell apart; viridis has the stops of lrcs' other pictures.
const viridisStops = [
  0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725,
];

export const partPalette = [
  '#332288',
  '#88ccee',
  '#44aa99',
  '#117733',
  '#999933',
  '#ddcc77',
  '#cc6677',
  '#882255',
  '#aa4499',
  '#661100',
];
export const otherPartsColour = '#b3b3b3';
export const materialPalette = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#f0e442', '#595959'];
export const unseenColour = '#d2d2d2';
export const ink = '#212121';
export const curveColour = '#0b559f';
export const highlight = '#e6007e';
export const transmitterColour = '#d55e00';
export const axisColours = { x: '#d55e00', y: '#009e73', z: '#0072b2' };

export function viridis(share) {
  const place = Math.min(Math.max(share, 0), 1) * (viridisStops.length - 1);
  const below = Math.min(Math.floor(place), viridisStops.length - 2);
  const mixed = (shift) => {
    const from = (viridisStops[below] >> shift) & 255;
    const to = (viridisStops[below + 1] >> shift) & 255;
    return Math.round(from + (place - below) * (to - from));
  };
  return [mixed(16), mixed(8), mixed(0)];
}

export function rgbOf(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

export const viridisGradient = (toward) =>
  `linear-gradient(to ${toward}, ${viridisStops.map((stop) => `#${stop.toString(16).padStart(6, '0')}`).join(', ')})`;
