// The turned body and the tool on a WebGL canvas, drawn only if something has moved.
//
// In: a canvas with its context, the section, the tip of the tool. Out: pixels. Turned and zoomed by mouse, finger and keyboard. Loaded on
// demand together with three.js. Must not know: where the section comes from.

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  PerspectiveCamera,
  Plane,
  Scene,
  ShaderMaterial,
  ShapeUtils,
  Spherical,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { DrilledHole, SectionPiece } from '../protocol/protocol';
import { boreOf, type Bore } from './solid-holes';
import { outlinesOf, turnedBody, type Corner } from './solid-shape';

/** Direction of the reset view: from the right front, a little above. */
const DEFAULT_VIEW = new Vector3(0.62, 0.62, 1).normalize();
/** Degrees. Narrow, so that parallel edges stay nearly parallel. */
const FIELD_OF_VIEW_DEGREES = 24;
const KEY_TURN = Math.PI / 24;
const KEY_ZOOM = 1.15;
/** Hatch lines across the longer side of a part. */
const HATCH_LINES = 40;
/** The centre line extends beyond the part by this fraction of its length. */
const CENTER_LINE_OVERHANG = 0.08;
/** Brightness of a hole, as a fraction of that of the surface. */
const HOLE_BRIGHTNESS = 0.22;
const HOLE_SEGMENTS = 32;
/** Height of the insert of the tool, as a fraction of the larger of radius and half length of the part. */
const INSERT_SIZE = 0.16;
/** The quarter that is cut away: above the axis and towards the viewer. */
const CLIPPING_PLANES = [new Plane(new Vector3(0, -1, 0)), new Plane(new Vector3(0, 0, -1))];

/** Lines at 45° that stay sharp at any zoom. */
const HATCH = {
  vertexShader: `
    varying vec2 place;
    void main() {
      place = uv;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    uniform vec3 ground;
    uniform vec3 lines;
    uniform float spacing;
    varying vec2 place;
    void main() {
      float across = (place.x - place.y) / spacing;
      float blur = fwidth(across);
      float offset = abs(fract(across) - 0.5);
      float line = 1.0 - smoothstep(blur * 0.2, blur * 1.0, offset);
      // Where lines would run into each other, their mean.
      line = mix(line, 0.2, smoothstep(0.25, 0.6, blur));
      gl_FragColor = vec4(mix(ground, lines, 0.8 * line), 1.0);
      #include <colorspace_fragment>
    }`,
};

export class SolidView {
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(FIELD_OF_VIEW_DEGREES);
  readonly #controls: OrbitControls;
  readonly #body = new Group();
  readonly #surface = new MeshPhongMaterial({
    shininess: 42,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  readonly #hatch = new ShaderMaterial({
    ...HATCH,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    uniforms: { ground: { value: new Color() }, lines: { value: new Color() }, spacing: { value: 1 } },
  });
  readonly #holes = new Group();
  /** An insert with its shank; the tip is at the origin. */
  readonly #tool = new Group();
  readonly #toolSurface = new MeshPhongMaterial({ flatShading: true });
  #tip: Corner | undefined;
  readonly #hole = new MeshBasicMaterial({ clippingPlanes: CLIPPING_PLANES, clipIntersection: true });
  readonly #holeInCut = new MeshBasicMaterial({ side: DoubleSide });
  readonly #edge = new LineBasicMaterial();
  readonly #axis = new LineBasicMaterial();
  readonly #ambientLight = new HemisphereLight(0xffffff, 0x8c8780, 1.6);
  readonly #light = new DirectionalLight(0xffffff, 1.5);
  readonly #darkScheme = matchMedia('(prefers-color-scheme: dark)');
  readonly #sizeObserver: ResizeObserver;
  readonly #onColoursChange = (): void => {
    this.#applyColours();
    this.#scheduleFrame();
  };
  #frame: number | undefined;
  /** The box that the reset view fits: middle, half of the length, and radius; mm. */
  #extents: { readonly middle: number; readonly half: number; readonly radius: number } | undefined;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.#renderer = new WebGLRenderer({ canvas, context, antialias: true });
    this.#renderer.localClippingEnabled = true;
    this.#light.position.set(-0.6, 1, 0.9);
    this.#camera.add(this.#light);
    this.#scene.add(this.#ambientLight, this.#camera, this.#body, this.#holes, this.#tool);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.addEventListener('change', () => this.#scheduleFrame());
    canvas.addEventListener('keydown', (event) => this.#handleKey(event));
    this.#darkScheme.addEventListener('change', this.#onColoursChange);
    this.#sizeObserver = new ResizeObserver(() => this.#resize());
    this.#sizeObserver.observe(canvas);
    this.#applyColours();
    this.#resize();
  }

  set holes(holes: readonly DrilledHole[]) {
    clear(this.#holes);
    for (const bore of holes.map(boreOf))
      this.#holes.add(new Mesh(boreGeometry(bore), this.#hole), new Mesh(boreCutGeometry(bore), this.#holeInCut));
    this.#scheduleFrame();
  }

  /** The tip of the tool, mm; undefined: no tool is shown. */
  set tool(tip: Corner | undefined) {
    this.#tip = tip;
    this.#placeTool();
    this.#scheduleFrame();
  }

  set section(pieces: readonly SectionPiece[]) {
    clear(this.#body);
    const corners = pieces.flatMap(outlinesOf).flat();
    if (corners.length > 0) {
      this.#build(pieces, corners);
      // The view keeps the user's orientation while the part changes.
      if (this.#extents === undefined) {
        this.#extents = extentsOf(corners);
        this.#buildTool(INSERT_SIZE * Math.max(this.#extents.half, this.#extents.radius));
        this.reset();
      }
    }
    this.#scheduleFrame();
  }

  /** Fits the whole part in the first view. */
  reset(): void {
    const extents = this.#extents;
    if (extents === undefined) return;
    const { middle, half, radius } = extents;
    this.#controls.target.set(middle, 0, 0);
    const distance = this.#distanceFor(half * (1 + CENTER_LINE_OVERHANG), radius);
    this.#camera.position.copy(DEFAULT_VIEW).multiplyScalar(distance).add(this.#controls.target);
    const size = Math.hypot(half, radius);
    this.#camera.near = size / 20;
    this.#camera.far = distance + 40 * size;
    this.#controls.minDistance = 0.4 * size;
    this.#controls.maxDistance = 4 * distance;
    this.#camera.updateProjectionMatrix();
    this.#controls.update();
    this.#scheduleFrame();
  }

  /** Frees all resources of the graphics card. */
  dispose(): void {
    if (this.#frame !== undefined) cancelAnimationFrame(this.#frame);
    this.#sizeObserver.disconnect();
    this.#darkScheme.removeEventListener('change', this.#onColoursChange);
    this.#controls.dispose();
    clear(this.#body);
    clear(this.#holes);
    clear(this.#tool);
    const materials = [this.#surface, this.#hatch, this.#hole, this.#holeInCut, this.#edge, this.#axis];
    for (const material of [...materials, this.#toolSurface]) material.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
    this.canvas.remove();
  }

  // ---- the body -----------------------------------------------------------------------------------

  #build(pieces: readonly SectionPiece[], corners: readonly Corner[]): void {
    const { positions, normals, triangles, edges } = turnedBody(pieces);
    const surface = new BufferGeometry();
    surface.setAttribute('position', new BufferAttribute(positions, 3));
    surface.setAttribute('normal', new BufferAttribute(normals, 3));
    surface.setIndex(new BufferAttribute(triangles, 1));
    const lines = new BufferGeometry();
    lines.setAttribute('position', new BufferAttribute(edges, 3));
    const { middle, half, radius } = extentsOf(corners);
    const size = 2 * Math.max(half, radius);
    this.#hatch.uniforms['spacing'] = { value: size / HATCH_LINES };
    this.#body.add(
      new Mesh(surface, this.#surface),
      new Mesh(cutFaces(pieces), this.#hatch),
      new LineSegments(lines, this.#edge),
      this.#centerLine(middle, half * (1 + 2 * CENTER_LINE_OVERHANG), size),
    );
  }

  /** `size`: height of the insert, mm. */
  #buildTool(size: number): void {
    // Four sides, upside down.
    const insert = new ConeGeometry(size / 2, size, 4).rotateX(Math.PI).translate(0, size / 2, 0);
    const shank = new BoxGeometry(size / 2, 2 * size, size / 2).translate(0, 2 * size, 0);
    this.#tool.add(new Mesh(insert, this.#toolSurface), new Mesh(shank, this.#toolSurface));
    this.#placeTool();
  }

  #placeTool(): void {
    const tip = this.#tip;
    this.#tool.visible = tip !== undefined;
    if (tip !== undefined) this.#tool.position.set(tip.z, tip.r, 0);
  }

  /** Long and short dashes in turn, as in drawings; each is a separate line. */
  #centerLine(middle: number, half: number, size: number): LineSegments {
    const [long, short, gap] = [size / 14, size / 70, size / 70];
    const positions: number[] = [];
    for (let at = middle - half, isLong = true; at < middle + half; isLong = !isLong) {
      const end = Math.min(at + (isLong ? long : short), middle + half);
      positions.push(at, 0, 0, end, 0, 0);
      at = end + gap;
    }
    const line = new BufferGeometry();
    line.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
    return new LineSegments(line, this.#axis);
  }

  // ---- the view -----------------------------------------------------------------------------------

  /** Distance at which a body of this half length and radius fills the picture of the reset view. */
  #distanceFor(half: number, radius: number): number {
    const right = new Vector3(0, 1, 0).cross(DEFAULT_VIEW).normalize();
    const up = DEFAULT_VIEW.clone().cross(right);
    const slope = Math.tan((FIELD_OF_VIEW_DEGREES * Math.PI) / 360);
    let distance = 0;
    for (let step = 0; step < 48; step += 1) {
      const angle = (step * Math.PI) / 24;
      for (const z of [-half, half]) {
        const place = new Vector3(z, radius * Math.cos(angle), radius * Math.sin(angle));
        const extent = Math.max(Math.abs(place.dot(right)) / this.#camera.aspect, Math.abs(place.dot(up)));
        distance = Math.max(distance, extent / slope + place.dot(DEFAULT_VIEW));
      }
    }
    return distance * 1.08;
  }

  #handleKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn: Readonly<Record<string, readonly [theta: number, phi: number]>> = {
      ArrowLeft: [-KEY_TURN, 0],
      ArrowRight: [KEY_TURN, 0],
      ArrowUp: [0, -KEY_TURN],
      ArrowDown: [0, KEY_TURN],
    };
    const [theta, phi] = turn[event.key] ?? [0, 0];
    if (theta !== 0 || phi !== 0) this.#moveCamera(theta, phi, 1);
    else if (event.key === '+' || event.key === '=') this.#moveCamera(0, 0, 1 / KEY_ZOOM);
    else if (event.key === '-') this.#moveCamera(0, 0, KEY_ZOOM);
    else if (event.key === 'Home') this.reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Turns the camera about the part by radians, and multiplies its distance by `factor`. */
  #moveCamera(theta: number, phi: number, factor: number): void {
    const { target, minDistance, maxDistance } = this.#controls;
    const place = new Spherical().setFromVector3(this.#camera.position.clone().sub(target));
    place.theta += theta;
    place.phi += phi;
    place.radius = Math.min(Math.max(place.radius * factor, minDistance), maxDistance);
    place.makeSafe();
    this.#camera.position.setFromSpherical(place).add(target);
    this.#controls.update();
    this.#scheduleFrame();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.#scheduleFrame();
  }

  #applyColours(): void {
    const colour = (property: string): Color => new Color(resolvedColour(this.canvas, property));
    this.#scene.background = colour('background');
    this.#surface.color = colour('solid');
    this.#surface.specular = new Color(0x2a2d30);
    for (const material of [this.#hole, this.#holeInCut])
      material.color = colour('solid').multiplyScalar(HOLE_BRIGHTNESS);
    this.#hatch.uniforms['ground'] = { value: colour('part') };
    this.#hatch.uniforms['lines'] = { value: colour('part-edge') };
    this.#toolSurface.color = colour('tool');
    this.#edge.color = colour('ink');
    this.#axis.color = colour('axis');
  }

  /** Draws at most one picture per frame, and none while nothing moves. */
  #scheduleFrame(): void {
    this.#frame ??= requestAnimationFrame(() => {
      this.#frame = undefined;
      this.#renderer.render(this.#scene, this.#camera);
    });
  }
}

function clear(group: Group): void {
  for (const part of group.children) if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
  group.clear();
}

function boreGeometry({ mouth, bottom, radius }: Bore): BufferGeometry {
  const [first, last] = [new Vector3(...mouth), new Vector3(...bottom)];
  const axis = first.clone().sub(last);
  const geometry = new CylinderGeometry(radius, radius, axis.length(), HOLE_SEGMENTS);
  // The axis of a cylinder is Y; `lookAt` turns Z.
  geometry.rotateX(Math.PI / 2);
  geometry.lookAt(axis);
  return geometry.translate(...first.add(last).multiplyScalar(0.5).toArray());
}

/** Where the faces of the cut cross a hole. */
function boreCutGeometry({ cuts }: Bore): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(cuts.flat(2)), 3));
  geometry.setIndex(cuts.flatMap((_, cut) => [0, 1, 2, 0, 2, 3].map((corner) => 4 * cut + corner)));
  return geometry;
}

/** Both faces of the cut, one vertical and one horizontal. Their texture coordinates are section coordinates. */
function cutFaces(pieces: readonly SectionPiece[]): BufferGeometry {
  const positions: number[] = [];
  const section: number[] = [];
  const triangles: number[] = [];
  for (const piece of pieces) {
    const [outline = [], ...holes] = outlinesOf(piece).map((corners) => corners.map(({ z, r }) => new Vector2(z, r)));
    const found = ShapeUtils.triangulateShape(outline, holes);
    for (const face of ['vertical', 'horizontal'] as const) {
      const first = positions.length / 3;
      for (const { x: z, y: r } of [...outline, ...holes.flat()]) {
        if (face === 'vertical') positions.push(z, r, 0);
        else positions.push(z, 0, r);
        section.push(z, r);
      }
      for (const triangle of found) triangles.push(...triangle.map((corner) => first + corner));
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('uv', new BufferAttribute(new Float32Array(section), 2));
  geometry.setIndex(triangles);
  return geometry;
}

function extentsOf(corners: readonly Corner[]): { middle: number; half: number; radius: number } {
  const [low, high, radius] = corners.reduce(
    ([low, high, radius], { z, r }) => [Math.min(low, z), Math.max(high, z), Math.max(radius, r)],
    [Infinity, -Infinity, 0] as [number, number, number],
  );
  return { middle: (low + high) / 2, half: (high - low) / 2, radius };
}

/** A colour of the page as the style sheet resolves it now. */
function resolvedColour(element: HTMLElement, property: string): string {
  const probe = document.createElement('span');
  probe.style.color = `var(--playground-${property})`;
  element.after(probe);
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}
