// Chooses the aspect: cut, slider, play; and says what was chosen.
import { placeText, receiverText, transmitterText } from './aspect.js';
import { el } from './dom.js';
import { angleText, boundText, dbText, dbsm, sigmaText } from './sigma.js';

const playIntervalMs = 100;

export class AspectBar {
  constructor({ slider, cutSelect, cutLabel, play, result, directions, ends }, data, aspect) {
    Object.assign(this, { slider, cutSelect, play, result, directions, ends, data, aspect });
    data.cuts.forEach((cut, k) => cutSelect.append(el('option', { value: k }, cut.label)));
    cutLabel.hidden = data.cuts.length < 2;
    cutSelect.addEventListener('change', () => aspect.setCut(Number(cutSelect.value)));
    slider.addEventListener('input', () => aspect.setPlace(Number(slider.value)));
    play.addEventListener('click', () => (this.timer ? this.stop() : this.start()));
    aspect.follow((cutChanged) => {
      if (cutChanged) this.drawCut();
      this.draw();
    });
    this.drawCut();
    this.draw();
  }

  drawCut() {
    const { cut, cutIndex } = this.aspect;
    this.cutSelect.value = cutIndex;
    this.slider.max = cut.rows.length - 1;
    this.slider.disabled = cut.rows.length < 2;
    this.play.disabled = cut.rows.length < 2;
    const text = (angle) => (this.data.axis === 'row' ? String(angle) : angleText(angle));
    this.ends[0].textContent = text(cut.angle_deg[0]);
    this.ends[1].textContent = text(cut.angle_deg[cut.angle_deg.length - 1]);
  }

  draw() {
    const { cut, place, row } = this.aspect;
    const { rows } = this.data;
    const sigma = rows.sigma_m2[row];
    this.slider.value = place;
    const value = `${sigmaText(sigma)} m², ${dbText(dbsm(sigma))} dBsm`;
    this.slider.setAttribute('aria-valuetext', `${placeText(this.data, cut.angle_deg[place])}: LRCS ${value}`);
    this.result.replaceChildren(
      el('span', { class: 'where' }, placeText(this.data, cut.angle_deg[place])),
      ' ',
      el('span', { class: 'what', title: `${sigma} m²` }, `LRCS ${sigmaText(sigma)} m² (${dbText(dbsm(sigma))} dBsm)`),
      ' ',
      el('span', { class: 'bound', title: `${rows.bound_m2[row]} m²` }, `± ${boundText(rows.bound_m2[row])} m²`),
    );
    this.directions.textContent = this.aspect.monostatic
      ? `Sensor at ${transmitterText(rows, row)}; monostatic.`
      : `Transmitter at ${transmitterText(rows, row)}; receiver at ${receiverText(rows, row)}.`;
  }

  start() {
    this.play.textContent = 'Stop';
    this.timer = setInterval(() => {
      const { place, cut } = this.aspect;
      this.aspect.setPlace(place + 1 < cut.rows.length ? place + 1 : 0);
    }, playIntervalMs);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = 0;
    this.play.textContent = 'Play';
  }
}
