// The view of the target with its choices: what colours stand for, where from, which aspect they are of.
import { directionsOf, nearestStored, receiverText, transmitterText } from './aspect.js';
import { drawColourKey } from './colour-bar.js';
import { el } from './dom.js';
import { facetColours } from './facet-colours.js';
import { countText } from './sigma.js';
import { TargetView } from './target-view.js';

// A press that moves farther, or lasts longer, turns the target.
const clickPx = 5;
const clickMs = 600;

export class TargetPanel {
  constructor(data, aspect, ranking, selection, parts) {
    Object.assign(this, { data, aspect, ranking, selection, parts });
    this.stored = nearestStored(data, aspect.row);
  }

  get state() {
    return {
      colouring: this.parts.colouring.value,
      floorDb: this.floorDb,
      webgl: Boolean(this.view?.renderer),
      colouredRow: this.stored < 0 ? -1 : this.data.shown.stored_rows[this.stored],
    };
  }

  get floorDb() {
    return Number(this.parts.floor.value);
  }

  start(readFacets) {
    try {
      this.facets = readFacets();
    } catch (error) {
      return this.refuse(`The facets cannot be read: ${error.message}`);
    }
    this.selection.partOfFacet = this.facets.part;
    this.view = new TargetView(this.parts.canvas, this.parts.soft, this.parts.overlay, this.facets);
    this.limitFloor();
    this.addButtons();
    this.followPointer();
    for (const choice of [this.parts.colouring, this.parts.floor])
      choice.addEventListener('change', () => this.paint());
    this.aspect.follow(() => this.onAspect());
    this.selection.follow(() => this.view?.select(this.selection.part));
    this.onAspect();
    this.paint();
    this.view.draw();
  }

  refuse(message) {
    this.view = null;
    this.parts.message.textContent = message;
    this.parts.message.hidden = false;
    for (const part of ['canvas', 'soft', 'overlay']) this.parts[part].style.display = 'none';
    this.parts.controls.hidden = true;
    this.parts.frame.classList.add('without-view');
  }

  // The first picture waits for neither WebGL nor creases.
  async finish() {
    if (!this.view) return;
    try {
      this.facets.readAll();
    } catch (error) {
      return this.refuse(`The facets cannot be read: ${error.message}`);
    }
    const sayWithout = () => {
      this.withoutWebGl = true;
      this.say();
    };
    if (await this.view.useWebGl(sayWithout)) this.view.addCreases();
    else sayWithout();
  }

  // What is below the floor of the stored levels cannot be told apart.
  limitFloor() {
    const { floor } = this.parts;
    for (const option of floor.options) option.disabled = Number(option.value) < this.data.shown.floor_db;
    const lowest = [...floor.options].filter((option) => !option.disabled).pop();
    if (floor.selectedOptions[0].disabled && lowest) floor.value = lowest.value;
  }

  addButtons() {
    const { rows } = this.data;
    const lookFrom = (who) => () =>
      this.view.lookFrom(rows[`${who}_azimuth_deg`][this.aspect.row], rows[`${who}_elevation_deg`][this.aspect.row]);
    const button = (label, act) => el('button', { type: 'button', onclick: act }, label);
    const looks = this.aspect.monostatic
      ? [button('Look from the sensor', lookFrom('transmitter'))]
      : [
          button('Look from the transmitter', lookFrom('transmitter')),
          button('Look from the receiver', lookFrom('receiver')),
        ];
    this.parts.buttons.replaceChildren(
      ...looks,
      button('Reset view', () => this.view.reset()),
    );
  }

  followPointer() {
    const { canvas } = this.parts;
    let down = null;
    canvas.addEventListener(
      'pointerdown',
      (event) => (down = { x: event.clientX, y: event.clientY, at: event.timeStamp }),
    );
    canvas.addEventListener('pointerup', (event) => {
      if (!down || event.timeStamp - down.at > clickMs) return;
      if (Math.hypot(event.clientX - down.x, event.clientY - down.y) > clickPx) return;
      const box = canvas.getBoundingClientRect();
      this.pick(event.clientX - box.left, event.clientY - box.top);
    });
  }

  pick(x, y) {
    if (!this.view) return null;
    const facet = this.view.facetAt(x, y);
    this.selection.setFacet(facet);
    if (facet < 0) return null;
    const part = this.facets.part[facet];
    return { facet, part, name: this.data.parts[part].name, sigma_m2: this.data.part_sigma_m2[this.aspect.row][part] };
  }

  onAspect() {
    if (!this.view) return;
    const { rows } = this.data;
    const { transmitter, receiver } = directionsOf(rows, this.aspect.row);
    this.view.setSensors(
      this.aspect.monostatic
        ? [{ direction: transmitter, label: 'sensor' }]
        : [
            { direction: transmitter, label: 'transmitter' },
            { direction: receiver, label: 'receiver' },
          ],
    );
    const stored = nearestStored(this.data, this.aspect.row);
    if (stored !== this.stored && this.showsReturn) {
      this.stored = stored;
      this.paint();
    }
    this.stored = stored;
    this.say();
  }

  get showsReturn() {
    return this.parts.colouring.value === 'contribution' || this.parts.colouring.value === 'seen';
  }

  paint() {
    if (!this.view) return;
    const choice = { colouring: this.parts.colouring.value, stored: this.stored, floorDb: this.floorDb };
    const { front, back } = this.view.colours;
    facetColours(this.data, this.facets, this.ranking, choice, this.facets.material, front);
    if (choice.colouring === 'material')
      facetColours(this.data, this.facets, this.ranking, choice, this.facets.back, back);
    else back.set(front);
    this.view.paint();
    this.parts.floorLabel.hidden = choice.colouring !== 'contribution';
    drawColourKey(this.parts.key, this.data, this.ranking, choice);
    this.say();
  }

  say() {
    const { data, stored } = this;
    const row = stored < 0 ? -1 : data.shown.stored_rows[stored];
    const said = [];
    if (this.showsReturn && row < 0) said.push('No facet colours are stored in this report.');
    else if (this.showsReturn && row !== this.aspect.row)
      said.push(`Facet colours: ${this.storedText(row)}, the nearest that is stored.`);
    if (data.shown.facets < data.target.facets) {
      said.push(
        `Drawn with ${countText(data.shown.facets)} facets, each for a group of the target's ${countText(data.target.facets)}.`,
      );
    }
    if (this.withoutWebGl) said.push('The target is drawn without WebGL 2, and more plainly: without its edges.');
    this.parts.note.textContent = said.join(' ');
    this.parts.canvas.setAttribute(
      'aria-label',
      `The target in 3-D, coloured by ${this.parts.colouring.selectedOptions[0].text}. ` +
        'Arrow keys turn it, with Shift they move it, plus and minus zoom, 0 resets.',
    );
  }

  storedText(row) {
    const { rows } = this.data;
    const transmitter = transmitterText(rows, row);
    return this.aspect.monostatic ? transmitter : `transmitter ${transmitter}, receiver ${receiverText(rows, row)}`;
  }
}
