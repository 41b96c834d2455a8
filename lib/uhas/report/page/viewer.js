// The views: a cell for each hand, one canvas and one camera for all, drawn only when something has changed.
'use strict';

const kFieldOfView = 32;  // degrees, vertical
const kFullHeight = 450;  // pixels of a view below which labels are smaller
const kMostNamed = 4;     // joints named in a view; the table has them all

/// Directions to look from, in the sphere frame, with the middle finger up.
const kStandpoints = {
  oblique: {label: 'Oblique', from: [0.1, 0.45, 1]},
  palm: {label: 'Palm', from: [0, 0, 1]},
  back: {label: 'Back', from: [0, 0, -1]},
  side: {label: 'Side', from: [0, -1, 0]},
  tips: {label: 'Tips', from: [1, 0, 0.001]},
};

class Viewer {
  /// @param container  an empty element that the cells fill
  /// Throws Error when the browser gives no WebGL.
  constructor(container, session) {
    const canvas = element('canvas', {'aria-hidden': 'true'});
    const context = canvas.getContext('webgl', {antialias: true, alpha: false});
    if (!context) throw new Error('this browser gives the page no WebGL, so the hands cannot be drawn');
    this.session = session;
    this.renderer = new THREE.WebGLRenderer({canvas, context, antialias: true});
    this.renderer.setScissorTest(true);
    this.camera = new THREE.PerspectiveCamera(kFieldOfView, 1, 0.05, 60);
    this.camera.up.set(1, 0, 0);
    this.headlight = new THREE.DirectionalLight('#ffffff', 0.65);
    this.views = session.hands.map((hand) => this.#makeView(hand));
    this.cells = element('div', {class: 'cells', tabindex: 0, role: 'group',
      'aria-label': 'Three-dimensional views. Drag to turn, wheel to zoom, right drag or arrow keys to move'},
    ...this.views.map(({cell}) => cell));
    container.append(canvas, this.cells);
    container.style.setProperty('--columns', Math.ceil(Math.sqrt(this.views.length)));
    this.controls = new THREE.OrbitControls(this.camera, this.cells);
    this.controls.addEventListener('change', () => this.requestDraw());
    canvas.addEventListener('webglcontextrestored', () => this.requestDraw());
    new ResizeObserver(() => this.requestDraw()).observe(container);
    session.onChange(() => this.#update());
  }

  #makeView(hand) {
    const scene = new THREE.Scene();
    const view = {hand, scene, drawn: new HandScene(hand), sphere: new SphereScene(hand, this.session.phi),
      status: element('p', {class: 'status'})};
    const side = hand.summary.handedness === 'none' ? 'neither left nor right' : `${hand.summary.handedness} hand`;
    view.cell = element('figure', {class: 'cell'},
      element('figcaption', {}, element('strong', {}, hand.name),
        ` ${side}, sphere radius ${fixed(hand.data.radius * 1000, 1)} mm`),
      view.status);
    scene.add(new THREE.HemisphereLight('#ffffff', '#8a8f98', 0.55), view.drawn.root, view.sphere.root);
    view.layers = {...view.drawn.layers, ...view.sphere.layers};
    view.layers.skeleton.visible = hand.meshes.length === 0;
    return view;
  }

  /// Shows or hides a layer (a key of HandScene.layers or SphereScene.layers) in all views.
  setLayer(name, visible) {
    this.views.forEach(({layers}) => { layers[name].visible = visible; });
    this.requestDraw();
  }

  /// Colours as CSS texts: mesh, ink, paper.
  setTheme(theme) {
    this.renderer.setClearColor(theme.paper);
    this.views.forEach(({drawn, sphere}) => { drawn.setTheme(theme); sphere.setTheme(theme); });
    this.requestDraw();
  }

  /// Puts the camera to a standpoint from which the open and the wrapped hands are whole.
  lookFrom(name) {
    const points = this.views.flatMap(({drawn, hand}) => ['q_open', 'q_sphere'].flatMap((pose) => {
      drawn.pose(hand.poses[pose]);
      return drawn.corners();
    }));
    this.#update();
    for (let i = 0; i < 6; ++i) points.push(new THREE.Vector3().setComponent(i % 3, i < 3 ? kAxisLength + 0.2 : -1.05));

    // the middle of what is seen, and the distance at which all of it is
    const from = new THREE.Vector3(...kStandpoints[name].from).normalize();
    const right = new THREE.Vector3().crossVectors(this.camera.up, from).normalize();
    const up = new THREE.Vector3().crossVectors(from, right);
    const target = new THREE.Vector3();
    for (const axis of [right, up]) {
      const along = points.map((point) => point.dot(axis));
      target.addScaledVector(axis, (Math.min(...along) + Math.max(...along)) / 2);
    }
    this.#fitAspect();
    const tangent = 0.92 * Math.tan(kFieldOfView / 2 / kDegrees);  // leaves a margin
    const distance = Math.max(...points.map((point) => {
      const p = point.clone().sub(target);
      return p.dot(from) + Math.max(Math.abs(p.dot(up)), Math.abs(p.dot(right)) / this.camera.aspect) / tangent;
    }));
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(from, distance);
    this.controls.update();
    this.requestDraw();
  }

  #update() {
    this.session.states.forEach(({action, q, residualRms, atLimit, closed}, i) => {
      const {drawn, sphere, hand, status} = this.views[i];
      drawn.pose(q);
      sphere.deform(action);
      const named = (label, flags) => {
        const names = hand.jointNames.filter((_, j) => flags[j]);
        return names.length && `${label}: ${names.length > kMostNamed ? `${names.length} joints` : names.join(', ')}`;
      };
      status.textContent = [!Number.isNaN(residualRms) && `residual ${fixed(residualRms, 3)} radii`,
        named('at limit', atLimit), named('closed', closed)].filter(Boolean).join(' · ');
    });
    this.requestDraw();
  }

  requestDraw() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = null;
      this.#draw();
    });
  }

  #fitAspect() {
    const {width, height} = this.views[0].cell.getBoundingClientRect();
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  /// Makes the drawing buffer as large as what it fills; a buffer is allocated anew only when that has changed.
  #fitBuffer({width, height}) {
    const size = [width, height, window.devicePixelRatio].join();
    if (size === this.size) return;
    this.size = size;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
  }

  #draw() {
    const whole = this.cells.getBoundingClientRect();
    if (whole.width === 0 || whole.height === 0) return;
    this.#fitBuffer(whole);
    this.#fitAspect();
    for (const {scene, cell, sphere} of this.views) {
      const {left, bottom, width, height} = cell.getBoundingClientRect();
      const place = [left - whole.left, whole.bottom - bottom, width, height];
      this.renderer.setViewport(...place);
      this.renderer.setScissor(...place);
      kViewHeight.value = height * window.devicePixelRatio;
      const pixel = 2 * Math.tan(kFieldOfView / 2 / kDegrees) / height;
      sphere.scaleLabels(pixel * clamp(height / kFullHeight, 0.75, 1));
      this.headlight.position.copy(this.camera.position);
      this.headlight.target.position.copy(this.controls.target);
      scene.add(this.headlight, this.headlight.target);  // one light for all scenes: it moves to the one being drawn
      this.renderer.render(scene, this.camera);
    }
  }
}
