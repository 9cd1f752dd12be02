// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** The columns of a point or vector, or where it stands for good. */
class Entity {
  constructor(json, instance, result) {
    Object.assign(this, json);
    this.value = new THREE.Vector3(...json.at);
    this.drawn = this.value.clone();
    this.columns = json.fixed ? [] : ['x', 'y', 'z'].map((axis) => result.column(`${instance}.${json.name}.${axis}`));
  }

  update(t) {
    this.columns.forEach((column, k) => { if (column) this.value.setComponent(k, column.at(t)); });
  }
}

/** A mechanism of one result as it stands at a time: its points, without a picture of them. */
class Mechanism {
  constructor(json, result) {
    Object.assign(this, json);
    this.result = result;
    this.points = json.entities.map((entity) => new Entity(entity, json.instance, result));
    this.combined = [];
    this.moving = this.points.find((entity) => entity.columns.length > 0);
    this.upward = new THREE.Vector3(...(json.up ?? (json.dimension === 2 ? [0, 1, 0] : [0, 0, 1])));
    this.anchors = this.drawnPlaces();
  }

  /** The value of a place, kept up to date. */
  place(json) {
    if (typeof json === 'number') return this.points[json].value;
    const place = { terms: json.terms, constant: new THREE.Vector3(...(json.constant ?? [0, 0, 0])), value: new THREE.Vector3() };
    this.combined.push(place);
    return place.value;
  }

  combine({ terms, constant, value }) {
    value.copy(constant);
    for (const [entity, along, across] of terms) {
      const e = this.points[entity].value;
      value.addScaledVector(e, along);
      if (across !== 0) value.add(Mechanism.turned.set(-across * e.y, across * e.x, 0));
    }
  }

  /** A function that puts an edge into a vector: a vector of the mechanism, or from a point to a point. */
  edge([to, from]) {
    return (value) => {
      value.copy(this.points[to].value);
      return from === undefined ? value : value.sub(this.points[from].value);
    };
  }

  /** Every point that something is drawn at. */
  drawnPlaces() {
    const ends = [...this.rods, ...this.links, ...this.springs].flatMap((part) => part.ends);
    const corners = this.plates.flatMap((plate) => plate.corners);
    const all = [...ends, ...corners, ...this.masses, ...this.wheels.map((wheel) => wheel.centre)];
    const seen = [...new Set(all.filter((place) => typeof place === 'number'))];
    return [...seen, ...all.filter((place) => typeof place !== 'number')].map((place) => this.place(place));
  }

  /** Whether its result knows where it is. */
  update(t) {
    this.points.forEach((point) => point.update(t));
    this.combined.forEach((place) => this.combine(place));
    return !this.moving || Number.isFinite(this.moving.value.x);
  }

  /** As in the file, whatever the time. */
  asDrawn() {
    this.points.forEach((point) => point.value.copy(point.drawn));
    this.combined.forEach((place) => this.combine(place));
  }

  drawnLength(ends) {
    const [a, b] = ends.map((end) => this.place(end));
    this.asDrawn();
    return a.distanceTo(b);
  }

  /** What a view follows: the point that the file names, or the middle of all. */
  middle(to) {
    if (this.follow !== undefined) return to.copy(this.points[this.follow].value);
    return this.anchors.reduce((sum, at) => sum.add(at), to.set(0, 0, 0)).divideScalar(Math.max(1, this.anchors.length));
  }
}
Mechanism.turned = new THREE.Vector3();

/** The picture of a mechanism. `look`: colour (null: a hue for each body), ghost, thickness [m], reach [m]. */
class Drawing {
  constructor(mechanism, look) {
    Object.assign(this, { mechanism, look, object: new THREE.Group(), parts: [], bodies: look.firstBody });
    this.colours = sceneColours();
    mechanism.plates.forEach((plate) => this.addPlate(plate));
    mechanism.rods.forEach((rod) => this.addRod(rod, look.thickness, this.body()));
    mechanism.links.forEach((link) => this.addRod(link, 0.55 * look.thickness, this.material(this.colours.link)));
    mechanism.springs.forEach((spring) => this.addSpring(spring));
    mechanism.wheels.forEach((wheel) => this.addWheel(wheel));
    mechanism.rails.forEach((rail) => this.addRail(rail));
    this.addPoints();
    this.parts.forEach((part) => this.object.add(part.object));
  }

  material(colour, opacity = 1) {
    const seen = this.look.ghost ? 0.45 * opacity : opacity;
    return new THREE.MeshLambertMaterial({ // the one whose program is made fastest
      color: this.look.colour ?? colour, side: THREE.DoubleSide, transparent: seen < 1, opacity: seen, depthWrite: seen === 1,
    });
  }

  body(opacity) { return this.material(bodyColour(this.bodies++), opacity); }

  addRod(rod, radius, material) {
    this.parts.push(new Rod(rod.ends.map((end) => this.mechanism.place(end)), radius, material));
  }

  addPlate(plate) {
    const corners = plate.corners.map((corner) => this.mechanism.place(corner));
    this.mechanism.asDrawn();
    const { faces, edges } = hull(corners.map((corner) => corner.clone()));
    const colour = this.bodies;
    this.parts.push(new Plate(corners, faces, this.body(0.3)));
    this.bodies = colour;
    const line = this.body();
    const radius = corners.length > 4 ? 0.35 * this.look.thickness : 0.7 * this.look.thickness;
    edges.forEach(([a, b]) => this.parts.push(new Rod([corners[a], corners[b]], radius, line)));
  }

  addSpring(spring) {
    const ends = spring.ends.map((end) => this.mechanism.place(end));
    const length = this.mechanism.drawnLength(spring.ends) || 20 * this.look.thickness;
    const radius = Math.min(2.2 * this.look.thickness, 0.16 * length);
    const Shape = spring.damper ? Damper : Spring;
    this.parts.push(new Shape(ends, length, radius, this.material(this.colours.spring)));
  }

  addWheel(wheel) {
    const m = this.mechanism;
    const angle = wheel.angle && m.result.column(`${m.instance}.${wheel.angle}`);
    const forwards = new THREE.Vector3();
    const axis = wheel.axis ? m.edge(wheel.axis) : (value) => value.set(0, 0, 1);
    const across = (value) => value.crossVectors(axis(forwards), m.upward).normalize();
    const materials = { tyre: this.material(this.colours.tyre), hub: this.material(this.colours.link), mark: this.body() };
    this.parts.push(new Wheel({
      ...wheel, axis, centre: m.place(wheel.centre), spoke: wheel.spoke ? m.edge(wheel.spoke) : across,
      turn: angle && ((t) => angle.at(t) || 0),
    }, materials));
  }

  addRail(rail) {
    const at = new THREE.Vector3(...rail.at);
    const along = new THREE.Vector3(...rail.along).multiplyScalar(this.look.reach);
    const ends = [at.clone().sub(along), at.clone().add(along)];
    this.parts.push(new Rod(ends, 0.3 * this.look.thickness, this.material(this.colours.fixed, 0.6)));
  }

  /** Balls where something joins, cones below those that are fixed. */
  addPoints() {
    const m = this.mechanism;
    const joined = new Set([...m.rods, ...m.links, ...m.springs].flatMap((part) => part.ends));
    m.plates.filter((plate) => plate.corners.length < 5).forEach((plate) => plate.corners.forEach((c) => joined.add(c)));
    const ball = this.material(this.colours.joint);
    for (const place of [...joined, ...m.masses]) {
      const radius = (m.masses.includes(place) ? 2.4 : 1.45) * this.look.thickness;
      this.parts.push(new Ball(m.place(place), radius, m.masses.includes(place) ? this.body() : ball));
      const entity = m.points[place];
      if (entity?.fixed)
        this.parts.push(new Support(entity.value, m.upward, this.look.thickness, this.material(this.colours.fixed)));
    }
  }

  update(t) {
    this.object.visible = this.mechanism.update(t);
    if (this.object.visible) this.parts.forEach((part) => part.update(t));
  }
}
