// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** Lines where a coordinate is a multiple of the cell, one pixel wide, fading out with the distance from the middle. */
const gridVertices = `
  varying vec3 place;
  void main() {
    place = (modelMatrix * vec4(position, 1.0)).xyz;
    gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
  }`;
const gridFragments = `
  varying vec3 place;
  uniform vec3 across, along, middle, colour;
  uniform float cell, fade;
  float line(float x) {
    float wide = fwidth(x);
    float near = abs(fract(x - 0.5) - 0.5) / max(wide, 1e-6);
    return (1.0 - min(near, 1.0)) * clamp(1.5 - 2.0 * wide, 0.0, 1.0);
  }
  void main() {
    vec2 at = vec2(dot(place, across), dot(place, along)) / cell;
    float thin = max(line(at.x), line(at.y)), thick = max(line(at.x / 5.0), line(at.y / 5.0));
    float far = clamp(1.0 - distance(place, middle) / fade, 0.0, 1.0);
    gl_FragColor = vec4(colour, far * max(0.45 * thin, 0.9 * thick));
  }`;

/** A grid on the ground, with shadows; behind a mechanism in the plane the paper that it is drawn on. */
class Ground {
  constructor(scene) {
    this.scene = scene;
    this.normal = scene.flat ? new THREE.Vector3(0, 0, 1) : scene.up;
    this.height = scene.flat ? 0 : this.lowest();
    this.object = new THREE.Group();
    this.grid = this.plane(this.gridMaterial(), -1);
    this.object.add(this.grid);
    if (!scene.flat) this.addShadows();
    this.object.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.normal);
    if (scene.flat && this.given() !== undefined) this.addLine();
  }

  given() { return this.scene.mechanisms.find((mechanism) => mechanism.ground !== undefined)?.ground; }

  /** What the file says, or a little below all that ever is. */
  lowest() {
    const { whole, up, thickness } = this.scene;
    const corners = [whole.min, whole.max].map((corner) => corner.dot(up));
    return this.given() ?? Math.min(...corners) - 6 * thickness;
  }

  plane(material, order) {
    const mesh = new THREE.Mesh(new THREE.PlaneBufferGeometry(2, 2), material);
    mesh.renderOrder = order;
    mesh.frustumCulled = false;
    return mesh;
  }

  gridMaterial() {
    const across = new THREE.Vector3(1, 0, 0).applyQuaternion(new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.normal));
    const values = { across, along: new THREE.Vector3().crossVectors(this.normal, across), middle: new THREE.Vector3(), colour: new THREE.Color(sceneColours().ground), cell: 1, fade: 1 };
    return new THREE.ShaderMaterial({
      vertexShader: gridVertices, fragmentShader: gridFragments, depthWrite: false,
      // Not `transparent`, which would put it after the mechanism that stands on it.
      blending: THREE.CustomBlending, blendSrcAlpha: THREE.OneFactor, blendDstAlpha: THREE.OneMinusSrcAlphaFactor,
      depthTest: false, side: THREE.DoubleSide, extensions: { derivatives: true },
      uniforms: Object.fromEntries(Object.entries(values).map(([name, value]) => [name, { value }])),
    });
  }

  addShadows() {
    this.shadows = this.plane(new THREE.ShadowMaterial({ opacity: sceneColours().shadow }), -2);
    this.shadows.material.depthWrite = false;
    this.shadows.receiveShadow = true;
    this.object.add(this.shadows);
  }

  /** The ground of a mechanism in the plane. */
  addLine() {
    const far = 200 * this.scene.size;
    const height = this.given();
    const middle = this.scene.whole.getCenter(new THREE.Vector3()).x;
    const ends = [new THREE.Vector3(middle - far, height, 0), new THREE.Vector3(middle + far, height, 0)];
    const line = new Rod(ends, 0.4 * this.scene.thickness, new THREE.MeshBasicMaterial({ color: sceneColours().fixed }));
    line.update();
    this.scene.scene.add(line.object);
  }

  /** Around what is looked at, with cells as fine as the distance allows. */
  update(target, distance) {
    const off = target.dot(this.normal) - this.height;
    this.object.position.copy(target).addScaledVector(this.normal, -off);
    const values = this.grid.material.uniforms;
    values.cell.value = roundDown(distance / 12);
    values.fade.value = 2.2 * Math.max(distance, 0.6 * this.scene.reach);
    values.middle.value.copy(this.object.position);
    this.object.scale.setScalar(values.fade.value);
    this.cell = values.cell.value;
  }
}
