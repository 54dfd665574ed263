// Debian's chromium without a window, with WebGL drawn by the processor. CHROMIUM=/path: another one.
import { chromium } from 'playwright-core';

const quiet = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
const noGl = ['--disable-gpu', '--disable-3d-apis', '--disable-software-rasterizer'];
const softwareGl = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export function launch({ webGl = true } = {}) {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, args: [...quiet, ...(webGl ? softwareGl : noGl)] });
}
