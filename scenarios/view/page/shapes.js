// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

const upright = new THREE.Vector3(0, 1, 0);
const unitCylinder = new THREE.CylinderBufferGeometry(1, 1, 1, 20);
const unitBall = new THREE.SphereBufferGeometry(1, 24, 16);

/** Puts an object that is drawn along y, of length 1 about its middle, between two places. */
function lay(object, from, to, thickness) {
  const way = lay.way.subVectors(to, from);
  const length = way.length();
  object.visible = length > 0; // false for NaN too
  if (!object.visible) return;
  object.position.addVectors(from, to).multiplyScalar(0.5);
  object.quaternion.setFromUnitVectors(upright, way.divideScalar(length));
  object.scale.set(thickness, length, thickness);
}
lay.way = new THREE.Vector3();

class Rod {
  constructor(ends, radius, material) {
    Object.assign(this, { ends, radius, object: new THREE.Mesh(unitCylinder, material) });
    this.object.castShadow = true;
  }

  update() { lay(this.object, this.ends[0], this.ends[1], this.radius); }
}

class Ball {
  constructor(at, radius, material) {
    Object.assign(this, { at, object: new THREE.Mesh(unitBall, material) });
    this.object.scale.setScalar(radius);
    this.object.castShadow = true;
  }

  update() { this.object.position.copy(this.at); }
}

/** A cone below a point that does not move. */
class Support {
  constructor(at, up, radius, material) {
    this.object = new THREE.Mesh(new THREE.ConeBufferGeometry(2.4 * radius, 4.2 * radius, 24), material);
    this.object.quaternion.setFromUnitVectors(upright, up);
    this.object.position.copy(at).addScaledVector(up, -2.1 * radius);
    this.object.castShadow = true;
  }

  update() {}
}

/** From y = -1/2 to 1/2: straight at the ends, eight turns between. */
class Coil extends THREE.Curve {
  getPoint(u) {
    const turning = Math.min(1, Math.max(0, (u - 0.12) / 0.76));
    const radius = Math.min(1, 12 * turning, 12 * (1 - turning));
    const angle = 16 * Math.PI * turning;
    return new THREE.Vector3(radius * Math.cos(angle), u - 0.5, radius * Math.sin(angle));
  }
}

/** `length`: about how long it is, in which its wire is round. */
class Spring {
  constructor(ends, length, radius, material) {
    const geometry = new THREE.TubeBufferGeometry(new SizedCoil(radius, length), 240, 0.22 * radius, 8);
    Object.assign(this, { ends, length, object: new THREE.Mesh(geometry, material) });
    this.object.castShadow = true;
  }

  update() {
    lay(this.object, this.ends[0], this.ends[1], 1);
    this.object.scale.y /= this.length;
  }
}

class SizedCoil extends Coil {
  constructor(radius, length) {
    super();
    Object.assign(this, { radius, length });
  }

  getPoint(u) { return super.getPoint(u).multiply(new THREE.Vector3(this.radius, this.length, this.radius)); }
}

/** A tube that keeps its length, and a rod that slides in it. */
class Damper {
  constructor(ends, length, radius, material) {
    this.object = new THREE.Group();
    this.tube = new THREE.Mesh(unitCylinder, material);
    this.rod = new THREE.Mesh(unitCylinder, material);
    this.object.add(this.tube, this.rod);
    Object.assign(this, { ends, radius, length: 0.55 * length, mouth: new THREE.Vector3() });
  }

  update() {
    const [from, to] = this.ends;
    this.mouth.subVectors(to, from).setLength(this.length).add(from);
    lay(this.tube, from, this.mouth, this.radius);
    lay(this.rod, from, to, 0.4 * this.radius);
  }
}

/** About z; spokes from x. */
class Wheel {
  constructor(wheel, materials) {
    Object.assign(this, wheel);
    const tube = Math.min(0.2 * this.radius, 0.5 * this.width);
    const tyre = new THREE.Mesh(new THREE.TorusBufferGeometry(this.radius - tube, tube, 16, 64), materials.tyre);
    tyre.scale.z = 0.5 * this.width / tube;
    tyre.castShadow = true;
    this.object = new THREE.Group();
    this.object.add(tyre);
    this.object.matrixAutoUpdate = false;
    for (let k = 0; k < 5; ++k) this.addSpoke(k * 2 * Math.PI / 5, tube, k === 0 ? materials.mark : materials.hub);
  }

  addSpoke(angle, thickness, material) {
    const spoke = new THREE.Mesh(unitCylinder, material);
    const end = new THREE.Vector3(Math.cos(angle), Math.sin(angle), 0).multiplyScalar(this.radius - thickness);
    lay(spoke, new THREE.Vector3(), end, 0.28 * thickness);
    this.object.add(spoke);
  }

  update(t) {
    const z = this.axis(Wheel.z).normalize();
    const x = this.spoke(Wheel.x, t);
    x.addScaledVector(z, -x.dot(z)).normalize();
    this.object.matrix.makeBasis(x, Wheel.y.crossVectors(z, x), z).setPosition(this.centre);
    if (this.turn) this.object.matrix.multiply(Wheel.turned.makeRotationZ(this.turn(t)));
  }
}
Object.assign(Wheel, {
  x: new THREE.Vector3(), y: new THREE.Vector3(), z: new THREE.Vector3(), turned: new THREE.Matrix4(),
});

/** The faces and edges of the convex hull of points as drawn, by their indices. */
function hull(points) {
  const flat = flatHull(points);
  if (flat) return flat;
  const number = new Map(points.map((point, k) => [point, k]));
  const faces = [];
  const edges = [];
  for (const face of new THREE.ConvexHull().setFromPoints(points).faces) {
    const sides = [face.edge, face.edge.next, face.edge.next.next];
    faces.push(sides.map((side) => number.get(side.head().point)));
    for (const side of sides) {
      const pair = [number.get(side.tail().point), number.get(side.head().point)];
      if (pair[0] < pair[1] && face.normal.dot(side.twin.face.normal) < 0.98) edges.push(pair);
    }
  }
  return { faces, edges };
}

/** Of points in a plane: the polygon around them; null for others. */
function flatHull(points) {
  const far = (measure) => points.reduce((best, p) => (measure(p) > measure(best) ? p : best));
  const origin = points[0];
  const way = (p) => new THREE.Vector3().subVectors(p, origin);
  const x = way(far((p) => way(p).length())).normalize();
  const off = (p) => way(p).addScaledVector(x, -way(p).dot(x));
  const y = off(far((p) => off(p).length())).normalize();
  const normal = new THREE.Vector3().crossVectors(x, y);
  const size = Math.max(...points.map((p) => way(p).length()));
  if (points.some((p) => Math.abs(way(p).dot(normal)) > 1e-6 * size)) return null;
  const loop = around(points.map((p, k) => ({ k, x: way(p).dot(x), y: way(p).dot(y) })));
  return {
    faces: loop.slice(2).map((k, i) => [loop[0], loop[i + 1], k]),
    edges: loop.map((k, i) => [k, loop[(i + 1) % loop.length]]),
  };
}

/** The convex hull in the plane by A. M. Andrew's monotone chain (1979), counterclockwise. */
function around(points) {
  const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
  const chain = (list) => list.reduce((kept, p) => {
    const right = (a, b) => (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) <= 0;
    while (kept.length > 1 && right(kept[kept.length - 2], kept[kept.length - 1])) kept.pop();
    return [...kept, p];
  }, []);
  return [...chain(sorted).slice(0, -1), ...chain(sorted.reverse()).slice(0, -1)].map((p) => p.k);
}

/** A body by its corners: translucent faces between them. Its edges are rods. */
class Plate {
  constructor(corners, faces, material) {
    const geometry = new THREE.BufferGeometry();
    this.corners = faces.flat().map((corner) => corners[corner]); // three for each face, so that it has a normal of its own
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * this.corners.length), 3));
    this.object = new THREE.Mesh(geometry, material);
    this.object.frustumCulled = false; // its geometry moves
    this.object.castShadow = true;
  }

  update() {
    const { geometry } = this.object;
    this.corners.forEach((corner, k) => geometry.attributes.position.setXYZ(k, corner.x, corner.y, corner.z));
    geometry.attributes.position.needsUpdate = true;
    geometry.computeVertexNormals();
  }
}
