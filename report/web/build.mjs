// node build.mjs OUT.html: the page as one file, with nothing in it but the marker for the data of a report.
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const marker = '<!-- lrcs:data -->';
const folder = dirname(fileURLToPath(import.meta.url));
const source = (name) => readFileSync(join(folder, 'src', name), 'utf8');

async function bundle(entry) {
  const { outputFiles, metafile } = await build({
    entryPoints: [join(folder, 'src', entry)],
    absWorkingDir: folder,
    bundle: true,
    minify: true,
    write: false,
    target: 'es2020',
    format: entry.endsWith('.js') ? 'iife' : undefined,
    legalComments: 'none',
    charset: 'ascii',
    metafile: true,
    define: { 'process.env.NODE_ENV': '"production"' },
    logLevel: 'warning',
  });
  return { text: outputFiles[0].text.trim(), inputs: Object.keys(metafile.inputs) };
}

// Of every package that the bundle has a piece of.
function licences(inputs) {
  const names = new Set(inputs.map((path) => path.match(/^node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1]).filter(Boolean));
  return [...names]
    .sort()
    .map((name) => {
      const inPackage = (file) => join(folder, 'node_modules', name, file);
      const { version, license } = JSON.parse(readFileSync(inPackage('package.json'), 'utf8'));
      const files = ['LICENSE', 'LICENSE.txt', 'NOTICE'].filter((file) => existsSync(inPackage(file)));
      if (files.length === 0) throw new Error(`${name} comes without a licence text`);
      const texts = files.map((file) => readFileSync(inPackage(file), 'utf8').trim());
      return [`${name} ${version} (${license})`, ...texts].join('\n\n');
    })
    .join('\n\n\n')
    .replace(/-{2,}/g, (dashes) => dashes.replace(/-/g, '='));
}

async function page() {
  const [script, style] = await Promise.all([bundle('main.js'), bundle('style.css')]);
  for (const harmful of ['</script', '<!--', marker]) {
    if (script.text.includes(harmful)) throw new Error(`the script holds ${harmful}, which ends or hides it`);
  }
  const hash = createHash('sha256').update(script.text).digest('base64');
  const policy =
    `default-src 'none'; script-src 'sha256-${hash}'; style-src 'unsafe-inline'; img-src data: blob:; ` +
    "base-uri 'none'; form-action 'none'";
  const put = { '/* policy */': policy, '/* style */': style.text, '/* script */': script.text };
  let html = source('index.html');
  for (const [place, text] of Object.entries(put)) html = html.replace(place, () => text);
  const comment = `<!--\nThis page contains parts of these packages:\n\n${licences(script.inputs)}\n-->\n`;
  html = html.replace(/<\/html>\s*$/, () => `${comment}</html>\n`);
  if (html.split(marker).length !== 2) throw new Error(`the page must hold ${marker} once`);
  return html;
}

if (process.argv.length !== 3) {
  console.error('usage: node build.mjs OUT.html');
  process.exit(2);
}
const html = await page();
mkdirSync(dirname(process.argv[2]), { recursive: true });
writeFileSync(process.argv[2], html);
console.log(`${process.argv[2]}: ${html.length} characters`);
