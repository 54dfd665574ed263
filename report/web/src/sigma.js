// Numbers as the page writes them: sigma [m^2], dBsm, angles.
export const dbsm = (sigma) => (sigma > 0 ? 10 * Math.log10(sigma) : -Infinity);

const withMinus = (text) => text.replace(/^-/, '\u2212');

export const sigmaText = (sigma) => (sigma === 0 ? '0' : sigma.toPrecision(6));

export const boundText = (bound) => (bound === 0 ? '0' : String(Number(bound.toPrecision(2))));

export const dbText = (decibels, digits = 2) =>
  decibels === -Infinity ? '\u2212\u221e' : withMinus(decibels.toFixed(digits).replace(/^-(0(?:\.0*)?)$/, '$1'));

export const shareText = (part, total) => (total > 0 ? `${((100 * part) / total).toFixed(2)} %` : '0 %');

export const plain = (value) => withMinus(String(Number(value.toPrecision(6))));

export const angleText = (degrees) => `${plain(degrees)}°`;

export const countText = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ',');

export const lengthText = (metres) => `${plain(Number(metres.toPrecision(4)))} m`;

export function wavelengthText(metres) {
  return `${Number((metres * 1e6).toPrecision(6))} µm`;
}
