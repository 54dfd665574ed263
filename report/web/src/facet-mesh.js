// The shown facets as one mesh: flat colours, hatching over the highlighted part, and that part's outline through
// whatever stands before it.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  GLSL3,
  GreaterDepth,
  Mesh,
  ShaderMaterial,
} from 'three';
import { highlight } from './colour.js';

const vertexShader = `
in vec4 colour;
in vec4 backColour;
in float part;
uniform float selected;
uniform bool onlySelected;
out vec4 vColour;
out vec4 vBackColour;
out vec3 vView;
out float vSelected;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vSelected = abs(part - selected) < 0.5 ? 1.0 : 0.0;
  vColour = colour;
  vBackColour = backColour;
  vView = view.xyz;
  gl_Position = onlySelected && vSelected < 0.5 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * view;
}`;

const facetShader = `
in vec4 vColour;
in vec4 vBackColour;
in vec3 vView;
in float vSelected;
uniform vec3 mark;
uniform float pixel;
out vec4 colourOut;
void main() {
  vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
  vec4 colour = gl_FrontFacing ? vColour : vBackColour;
  vec3 rgb = colour.rgb * mix(1.0, 0.8 + 0.2 * abs(normal.z), colour.a);
  float along = mod(gl_FragCoord.x + gl_FragCoord.y, 8.0 * pixel);
  if (vSelected > 0.5 && along < 2.0 * pixel) rgb = mark;
  colourOut = vec4(rgb, 1.0);
}`;

const throughShader = `
uniform vec3 mark;
uniform float pixel;
in vec4 vColour;
in vec3 vView;
in float vSelected;
out vec4 colourOut;
void main() {
  vec2 place = mod(gl_FragCoord.xy, 6.0 * pixel);
  if (place.x > 2.0 * pixel || place.y > 2.0 * pixel) discard;
  colourOut = vec4(mark, 0.8);
}`;

export class FacetMesh {
  constructor(facets) {
    this.geometry = new BufferGeometry();
    this.uniforms = { selected: { value: -1 }, mark: { value: new Color(highlight) }, pixel: { value: 1 } };
    const material = (fragmentShader, onlySelected, more) =>
      new ShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader,
        side: DoubleSide,
        uniforms: { ...this.uniforms, onlySelected: { value: onlySelected } },
        ...more,
      });
    // Pushed back so that creases, which lie in the facets' planes, are not cut by them.
    this.facets = new Mesh(
      this.geometry,
      material(facetShader, false, {
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 2,
      }),
    );
    this.through = new Mesh(
      this.geometry,
      material(throughShader, true, {
        side: FrontSide,
        depthFunc: GreaterDepth,
        depthWrite: false,
        transparent: true,
      }),
    );
    this.through.visible = false;

    const corners = 3 * facets.count;
    const position = new Float32Array(3 * corners);
    const part = new Float32Array(corners);
    for (let c = 0; c < corners; ++c) {
      const vertex = 3 * facets.triangles[c];
      position[3 * c] = facets.positions[vertex];
      position[3 * c + 1] = facets.positions[vertex + 1];
      position[3 * c + 2] = facets.positions[vertex + 2];
    }
    for (let f = 0; f < facets.count; ++f) part.fill(facets.part[f], 3 * f, 3 * f + 3);
    this.colour = new BufferAttribute(new Uint8Array(4 * corners), 4, true);
    this.backColour = new BufferAttribute(new Uint8Array(4 * corners), 4, true);
    this.geometry.setAttribute('position', new BufferAttribute(position, 3));
    this.geometry.setAttribute('part', new BufferAttribute(part, 1));
    this.geometry.setAttribute('colour', this.colour);
    this.geometry.setAttribute('backColour', this.backColour);
    this.geometry.computeBoundingBox();
    this.geometry.computeBoundingSphere();
  }

  paint({ front, back }) {
    for (const [colours, attribute] of [
      [front, this.colour],
      [back, this.backColour],
    ]) {
      const packed = new Uint32Array(attribute.array.buffer);
      for (let f = 0; f < colours.length; ++f) packed[3 * f] = packed[3 * f + 1] = packed[3 * f + 2] = colours[f];
      attribute.needsUpdate = true;
    }
  }

  select(part) {
    this.uniforms.selected.value = part;
    this.through.visible = part >= 0;
  }
}
