// What drawings are made of besides meshes: discs for points, arrows, labels. Sizes are in sphere radii.
'use strict';

/// Points drawn as round discs that face the camera, unlit, in the colours of the attribute `color`, and a little nearer
/// to the camera than they are, so that the surface on which they lie does not swallow them.
/// @param diameter  sphere radii, whatever the scale of the object
function discMaterial(diameter) {
  return new THREE.ShaderMaterial({
    uniforms: {diameter: {value: diameter}, viewHeight: kViewHeight},
    vertexShader: `
      attribute vec3 color;
      uniform float diameter, viewHeight;
      varying vec3 discColor;
      void main() {
        discColor = color;
        vec4 position = modelViewMatrix * vec4(position, 1.0);
        gl_Position = projectionMatrix * (position * vec4(vec3(1.0 - 0.03 / length(position.xyz)), 1.0));
        gl_PointSize = max(2.0, diameter * projectionMatrix[1][1] * 0.5 * viewHeight / -position.z);
      }`,
    fragmentShader: `
      varying vec3 discColor;
      void main() {
        if (length(gl_PointCoord - 0.5) > 0.5) discard;
        gl_FragColor = vec4(discColor, 1.0);
      }`,
  });
}

/// Height of a view in pixels of the drawing buffer, shared by all disc materials.
const kViewHeight = {value: 1};

/// A shaft with a head along +y, of length 1; `point` lays it out.
class Arrow extends THREE.Group {
  constructor(color, thickness = 0.01) {
    super();
    const material = new THREE.MeshBasicMaterial({color});
    this.thickness = thickness;
    this.shaft = new THREE.Mesh(new THREE.CylinderBufferGeometry(1, 1, 1, 8), material);
    this.head = new THREE.Mesh(new THREE.ConeBufferGeometry(1, 1, 12), material);
    this.add(this.shaft, this.head);
  }

  /// From one point to another (THREE.Vector3); hidden when they are one.
  point(from, to) {
    const way = to.clone().sub(from), length = way.length();
    this.visible = length > 1e-6;
    if (!this.visible) return;
    const headLength = Math.min(7 * this.thickness, 0.6 * length), shaftLength = length - headLength;
    this.shaft.scale.set(this.thickness, shaftLength, this.thickness);
    this.shaft.position.y = shaftLength / 2;
    this.head.scale.set(3 * this.thickness, headLength, 3 * this.thickness);
    this.head.position.y = length - headLength / 2;
    this.position.copy(from);
    this.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), way.normalize());
  }
}

/// A word that faces the camera, in front of everything, with a halo in the colour of the paper. Its scale is set for each
/// view, so that it is as large in all.
function labelSprite(text, color, paper) {
  const size = 48, font = `600 ${size}px system-ui, sans-serif`;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 12;
  canvas.height = size + 16;
  context.font = font;
  context.textBaseline = 'middle';
  context.strokeStyle = paper;
  context.lineWidth = 8;
  context.lineJoin = 'round';
  context.strokeText(text, 6, canvas.height / 2);
  context.fillStyle = color;
  context.fillText(text, 6, canvas.height / 2);
  const texture = new THREE.CanvasTexture(canvas);
  texture.minFilter = THREE.LinearFilter;  // the canvas is no power of two wide
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({map: texture, depthTest: false, sizeAttenuation: false}));
  sprite.renderOrder = 10;
  return sprite;
}

/// A group for each name.
function groups(...names) {
  return Object.fromEntries(names.map((name) => [name, new THREE.Group()]));
}

/// Frees what the graphics card holds of an object and its children.
function disposeDeep(object) {
  object.traverse(({geometry, material}) => {
    if (geometry) geometry.dispose();
    if (material) {
      if (material.map) material.map.dispose();
      material.dispose();
    }
  });
}
