// The target in 3-D, seen in parallel projection as a far sensor sees it.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  ColorManagement,
  LinearSRGBColorSpace,
  LineBasicMaterial,
  LineSegments,
  OrthographicCamera,
  Raycaster,
  Scene,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { direction } from './aspect.js';
import { creaseLines } from './creases.js';
import { onResize } from './dom.js';
import { FacetMesh } from './facet-mesh.js';
import { SoftPicture } from './soft-picture.js';
import { drawOverlay } from './view-overlay.js';

// Colours are painted as given: they must match the colour bar.
ColorManagement.enabled = false;

const margin = 1.25;
const filled = 0.74;
const startAzimuth = 35;
const startElevation = 25;

export class TargetView {
  // canvas: for WebGL, and for pointer and keys; below it soft, which shows until WebGL draws.
  constructor(canvas, soft, overlay, facets) {
    this.canvas = canvas;
    this.overlay = overlay;
    this.sensors = [];
    this.scene = new Scene();
    this.soft = new SoftPicture(soft, facets);
    this.camera = new OrthographicCamera();
    this.camera.up.set(0, 0, 1);
    this.facets = facets;
    this.colours = { front: new Uint32Array(facets.count), back: new Uint32Array(facets.count) };
    this.selected = -1;
    this.waiting = true; // for the first draw()
    this.box = new Box3().setFromArray(facets.positions);
    this.centre = this.box.getCenter(new Vector3());
    this.radius = 0.5 * this.box.getSize(new Vector3()).length() || 1;
    this.camera.near = 0;
    this.camera.far = 20 * this.radius;
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.minZoom = 0.2;
    this.controls.maxZoom = 200;
    this.controls.addEventListener('change', () => this.redrawSoon());
    this.setSize();
    onResize(this.canvas.parentElement, () => {
      this.setSize();
      this.draw();
    });
    window.addEventListener('beforeprint', () => this.draw());
    this.canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  // For WebGL and for picking; the first picture needs it not.
  makeMesh() {
    if (this.mesh) return;
    this.mesh = new FacetMesh(this.facets);
    this.mesh.paint(this.colours);
    this.mesh.select(this.selected);
    this.scene.add(this.mesh.facets, this.mesh.through);
  }

  // From now on WebGL draws, where it can and until it is lost; says whether. onLost: called then.
  async useWebGl(onLost) {
    const renderer = await this.webGlRenderer().catch(() => null);
    if (!renderer) return false;
    this.renderer = renderer;
    this.setSize();
    this.draw();
    this.soft.canvas.style.display = 'none';
    this.soft.setSize(1, 1);
    this.canvas.addEventListener('webglcontextlost', () => {
      this.renderer = null;
      this.canvas.style.opacity = 0;
      this.soft.canvas.style.display = '';
      this.setSize();
      this.draw();
      onLost();
    });
    return true;
  }

  // Null where there is no WebGL 2, or it cannot draw the mesh.
  async webGlRenderer() {
    const context = this.canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!context) return null;
    this.makeMesh();
    const renderer = new WebGLRenderer({ canvas: this.canvas, context });
    renderer.outputColorSpace = LinearSRGBColorSpace;
    renderer.debug.checkShaderErrors = false;
    renderer.setClearColor(0xffffff, 1);
    renderer.compile(this.mesh.facets, this.camera, this.scene);
    await new Promise((resolve) => setTimeout(resolve));
    const links = ({ program }) => context.getProgramParameter(program, context.LINK_STATUS);
    return renderer.info.programs.every(links) ? renderer : null;
  }

  addCreases() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(creaseLines(this.facets), 3));
    this.scene.add(
      new LineSegments(geometry, new LineBasicMaterial({ color: 0x000000, opacity: 0.6, transparent: true })),
    );
    this.redrawSoon();
  }

  // The colours are in this.colours.
  paint() {
    this.mesh?.paint(this.colours);
    this.redrawSoon();
  }

  select(part) {
    this.selected = part;
    this.mesh?.select(part);
    this.redrawSoon();
  }

  // [{direction: [x, y, z], label}], drawn as arrows.
  setSensors(sensors) {
    this.sensors = sensors;
    this.redrawSoon();
  }

  reset() {
    this.camera.zoom = 1;
    this.controls.target.copy(this.centre);
    this.lookFrom(startAzimuth, startElevation);
    this.fit();
  }

  corners() {
    const { min, max } = this.box;
    return [0, 1, 2, 3, 4, 5, 6, 7].map(
      (k) => new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z),
    );
  }

  // The target as large as leaves room for arrows and axes.
  fit() {
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    const places = this.corners().map((corner) => corner.project(this.camera));
    const widest = Math.max(...places.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]));
    this.camera.zoom = Math.min(filled / (widest || 1), this.controls.maxZoom);
  }

  // How far the target reaches from its centre in a direction, by its box.
  reach(toward) {
    return Math.max(...this.corners().map((corner) => corner.sub(this.centre).dot(toward)));
  }

  lookFrom(azimuthDeg, elevationDeg) {
    // From straight above, the azimuth says which way is up.
    const elevation = Math.min(Math.max(elevationDeg, -89.99), 89.99);
    const away = new Vector3(...direction(azimuthDeg, elevation)).multiplyScalar(10 * this.radius);
    this.camera.position.copy(this.controls.target).add(away);
    this.controls.update();
    this.redrawSoon();
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (turn && event.shiftKey) this.pan(turn);
    else if (turn) this.turn(turn);
    else if (event.key === '+' || event.key === '=') this.zoom(1.25);
    else if (event.key === '-') this.zoom(0.8);
    else if (event.key === '0') this.reset();
    else return;
    event.preventDefault();
  }

  turn([right, up]) {
    const away = this.camera.position.clone().sub(this.controls.target).normalize();
    const azimuth = (Math.atan2(away.y, away.x) * 180) / Math.PI;
    this.lookFrom(azimuth + 5 * right, (Math.asin(away.z) * 180) / Math.PI + 5 * up);
  }

  pan([right, up]) {
    const step = (0.1 * this.radius) / this.camera.zoom;
    const move = new Vector3(-right * step, -up * step, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(move);
    this.controls.target.add(move);
    this.redrawSoon();
  }

  zoom(factor) {
    this.camera.zoom = Math.min(Math.max(this.camera.zoom * factor, this.controls.minZoom), this.controls.maxZoom);
    this.redrawSoon();
  }

  setSize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    const isFirst = this.width === undefined;
    this.width = width;
    this.height = height;
    const ratio = Math.min(window.devicePixelRatio, 2);
    this.ratio = ratio;
    if (this.renderer) {
      this.mesh.uniforms.pixel.value = ratio;
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
    } else this.soft.setSize(Math.floor(ratio * width), Math.floor(ratio * height));
    const half = margin * this.radius;
    const across = half * Math.max(width / height, 1);
    const up = half * Math.max(height / width, 1);
    Object.assign(this.camera, { left: -across, right: across, top: up, bottom: -up });
    if (isFirst) this.reset();
  }

  redrawSoon() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.draw());
  }

  draw() {
    this.waiting = false;
    if (this.width === undefined) return; // hidden as yet
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    if (this.renderer) this.renderer.render(this.scene, this.camera);
    else this.soft.draw(this.camera, this.colours, this.selected, this.ratio);
    drawOverlay(this);
  }

  // Pixels of the page from the top left of the view, for a point of the body.
  project(point) {
    const place = point.clone().project(this.camera);
    return [0.5 * (1 + place.x) * this.width, 0.5 * (1 - place.y) * this.height];
  }

  // The facet at a place (CSS pixels from the top left of the view); -1 where there is none.
  facetAt(x, y) {
    this.makeMesh();
    const ray = new Raycaster();
    this.camera.updateMatrixWorld();
    ray.setFromCamera(new Vector2((2 * x) / this.width - 1, 1 - (2 * y) / this.height), this.camera);
    return ray.intersectObject(this.mesh.facets)[0]?.faceIndex ?? -1;
  }
}
