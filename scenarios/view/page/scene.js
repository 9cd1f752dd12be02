// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** Where mechanisms are over time, the box around it, and half the diagonal of the largest box at one instant. */
function measure(mechanisms, clock) {
  const whole = new THREE.Box3();
  const places = [];
  const middle = new THREE.Vector3();
  let size = 0;
  for (let k = 0; k <= 200; ++k) {
    const now = new THREE.Box3();
    for (const mechanism of mechanisms)
      if (mechanism.update(clock.start + clock.span * k / 200)) mechanism.anchors.forEach((at) => now.expandByPoint(at));
    if (now.isEmpty()) continue;
    size = Math.max(size, 0.5 * now.getSize(middle).length());
    whole.union(now);
    mechanisms.forEach((mechanism) => mechanism.anchors.forEach((at) => places.push(at.clone())));
  }
  const wheel = Math.max(0, ...mechanisms.flatMap((mechanism) => mechanism.wheels.map((w) => w.radius)));
  return { whole: whole.expandByScalar(wheel), places: places.filter((at) => Number.isFinite(at.x)), wheel, size: size + wheel || 1 };
}

/** Mechanisms in three dimensions. Drawn when something has changed. */
class Scene {
  constructor(holder, results, clock) {
    Object.assign(this, { holder, results, clock, drawings: [], paths: [], traced: new Set(), waiting: false });
    this.mechanisms = results.flatMap((result) => result.mechanisms.map((json) => new Mechanism(json, result)));
    this.flat = this.mechanisms.every((mechanism) => mechanism.dimension === 2);
    this.up = (this.mechanisms.find((mechanism) => mechanism.up) ?? this.mechanisms[0]).upward;
    Object.assign(this, measure(this.mechanisms, clock));
    this.thickness = Math.min(0.017 * this.size, 0.04 * this.usualLength());
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = !this.flat;
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    holder.append(this.renderer.domElement);
    this.makeCamera();
    this.makeFollowing();
    this.build();
    new ResizeObserver(() => this.resize()).observe(holder);
    this.resize();
    this.look('begin');
    clock.listen(() => this.request());
  }

  /** The middle one of the lengths of bars as drawn, by which their thickness is chosen. */
  usualLength() {
    const lengths = this.mechanisms.flatMap((mechanism) => mechanism.rods.map((rod) => mechanism.drawnLength(rod.ends)));
    return lengths.sort((a, b) => a - b)[lengths.length >> 1] ?? Infinity;
  }

  makeCamera() {
    this.camera = new THREE.PerspectiveCamera(30, 1);
    this.camera.up.copy(this.up);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enableKeys = false; // arrows are the player's
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener('change', () => this.request());
  }

  /** The view follows what travels farther than it is large. */
  makeFollowing() {
    const travels = this.whole.getSize(new THREE.Vector3()).length() > 8 * this.size;
    this.following = travels || this.mechanisms.some((mechanism) => mechanism.follow !== undefined);
    this.leader = this.mechanisms.find((mechanism) => mechanism.follow !== undefined) ?? this.mechanisms[0];
    this.followed = new THREE.Vector3();
  }

  /** All that depends on the theme. */
  build() {
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xffffff, dark.matches ? 0x8a8f99 : 0xb9bec8, 0.78));
    this.addLight();
    this.drawings = [];
    let bodies = 0;
    for (const mechanism of this.mechanisms) {
      const reference = mechanism.result.role === 'reference';
      const look = { colour: this.colourOf(mechanism.result), ghost: reference, thickness: this.thickness * (reference ? 1.25 : 1), reach: 3 * this.size, firstBody: bodies };
      const drawing = new Drawing(mechanism, look);
      bodies = drawing.bodies;
      this.drawings.push(drawing);
      this.scene.add(drawing.object);
    }
    this.ground = new Ground(this);
    this.scene.add(this.ground.object);
    this.trace(this.traced);
  }

  /** With two results each has one colour, else each body. */
  colourOf(result) {
    return this.results.length > 1 ? styleColour(result.role) : null;
  }

  addLight() {
    this.light = new THREE.DirectionalLight(0xffffff, 0.55);
    const r = 2.5 * Math.min(this.reach, 4 * this.size);
    Object.assign(this.light.shadow.camera, { left: -r, right: r, top: r, bottom: -r, near: 0.1 * r, far: 8 * r });
    this.light.shadow.mapSize.set(2048, 2048);
    this.light.shadow.radius = 3;
    this.light.castShadow = !this.flat;
    this.scene.add(this.light, this.light.target);
  }

  /** Half the diagonal of all that is ever seen at once. */
  get reach() {
    return this.following ? this.size : 0.5 * this.whole.getSize(new THREE.Vector3()).length();
  }

  /** Draws the paths of points, "NUMBER NAME" with the number of the mechanism. */
  trace(chosen) {
    this.paths.forEach((path) => this.scene.remove(path));
    this.traced = chosen;
    this.paths = [];
    this.mechanisms.forEach((mechanism, number) => mechanism.points.forEach((point) => {
      if (!chosen.has(`${number} ${point.name}`) || point.columns.length === 0) return;
      const colour = this.colourOf(mechanism.result) ?? styleColour('accent');
      this.paths.push(new THREE.Line(pathOf(point), new THREE.LineBasicMaterial({ color: colour })));
    }));
    this.paths.forEach((path) => this.scene.add(path));
    this.request();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.holder;
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.request();
  }

  /** Directions from which it is looked at: in the plane from z, else the front is towards the larger horizontal. */
  direction(name) {
    const axes = this.up.z > 0.7 ? { front: [1, 0, 0], side: [0, -1, 0] } : { front: [0, 0, 1], side: [1, 0, 0] };
    const front = new THREE.Vector3(...axes.front);
    const side = new THREE.Vector3(...axes.side);
    if (name === 'front' || (name === 'begin' && this.flat)) return front;
    if (name === 'side') return side;
    if (name === 'top') return this.up.clone().addScaledVector(front, 1e-4);
    return front.multiplyScalar(0.75).add(side).addScaledVector(this.up, 0.6);
  }

  /** Turns the view to a direction, or with 'fit' leaves it, and shows everything. */
  look(name) {
    const way = name === 'fit'
      ? new THREE.Vector3().subVectors(this.camera.position, this.controls.target)
      : this.direction(name);
    this.place(this.clock.time);
    if (this.following) this.controls.target.copy(this.followed);
    else this.whole.getCenter(this.controls.target);
    this.camera.position.copy(this.controls.target).add(way.normalize());
    this.camera.lookAt(this.controls.target);
    this.camera.updateMatrixWorld();
    const distance = 1.1 * (this.following ? 3 * this.size : this.distanceForAll());
    this.camera.position.copy(this.controls.target).addScaledVector(way, distance);
    this.controls.update();
    this.request();
  }

  /** From where all places are in sight: |x| <= (d - z) tan(angle / 2) for each, seen from the camera. */
  distanceForAll() {
    const tall = Math.tan(0.5 * THREE.Math.degToRad(this.camera.fov));
    const inverse = new THREE.Matrix4().extractRotation(this.camera.matrixWorld).transpose();
    const seen = new THREE.Vector3();
    const margin = this.wheel + 3 * this.thickness;
    let distance = this.thickness;
    for (const place of this.places) {
      seen.subVectors(place, this.controls.target).applyMatrix4(inverse);
      distance = Math.max(distance, seen.z + (Math.abs(seen.x) + margin) / (tall * this.camera.aspect), seen.z + (Math.abs(seen.y) + margin) / tall);
    }
    return distance;
  }

  /** Turns the view by angles [rad] about the vertical and up. */
  orbit(sideways, upwards) {
    const turn = new THREE.Quaternion().setFromUnitVectors(this.up, upright);
    const way = this.camera.position.clone().sub(this.controls.target).applyQuaternion(turn);
    const s = new THREE.Spherical().setFromVector3(way);
    s.theta += sideways;
    s.phi -= upwards;
    way.setFromSpherical(s.makeSafe()).applyQuaternion(turn.inverse());
    this.camera.position.copy(this.controls.target).add(way);
    this.controls.update();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.request();
  }

  setFollowing(following) {
    this.following = following;
    this.look('fit');
  }

  request() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.draw());
  }

  /** Puts everything where it is at a time; a view that follows moves along. */
  place(t) {
    this.drawings.forEach((drawing) => drawing.update(t));
    const before = this.followed.clone();
    this.leader.middle(this.followed);
    if (!Number.isFinite(this.followed.x)) this.followed.copy(before);
    if (!this.following) return;
    const way = before.subVectors(this.followed, before);
    this.camera.position.add(way);
    this.controls.target.add(way);
  }

  draw() {
    this.waiting = false;
    this.place(this.clock.time);
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = 0.02 * distance;
    this.camera.far = 40 * distance + 10 * this.reach;
    this.camera.updateProjectionMatrix();
    this.light.target.position.copy(this.controls.target);
    this.light.position.copy(this.controls.target).addScaledVector(this.up, 8 * this.reach)
      .addScaledVector(this.direction('side'), 3 * this.reach).addScaledVector(this.direction('front'), 4 * this.reach);
    this.ground.update(this.controls.target, distance);
    this.renderer.render(this.scene, this.camera);
    this.ondraw?.();
  }
}

/** The path of a point, of up to 5000 places. */
function pathOf(point) {
  const rows = point.columns[0].values.length;
  const skip = Math.max(1, Math.floor(rows / 5000));
  const places = [];
  for (let row = 0; row < rows; row += skip)
    places.push(new THREE.Vector3(...point.columns.map((column) => column?.values[row] ?? 0)));
  return new THREE.BufferGeometry().setFromPoints(places.filter((place) => Number.isFinite(place.x)));
}
