// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

const byId = (id) => document.getElementById(id);
const playIcon = '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M7 4v16l13-8z"/></svg>';
const pauseIcon = '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M6 4h4.5v16H6zM13.5 4H18v16h-4.5z"/></svg>';

/** Speeds 1, 2, 5 times powers of ten, a thousandth of the first one to a hundred times it. */
function speedsAround(first) {
  const power = Math.floor(Math.log10(first) + 1e-9);
  const all = [];
  for (let k = power - 3; k <= power + 2; ++k) for (const digit of [1, 2, 5]) all.push(Number(`${digit}e${k}`));
  return all;
}

function speedText(speed) {
  return speed >= 0.01 ? `${speed}×` : `1/${Math.round(1 / speed)}`;
}

/** Buttons, slider and keys of the player. */
class Player {
  constructor(clock) {
    this.clock = clock;
    this.speeds = speedsAround(clock.speed);
    byId('speed').append(...this.speeds.map((speed) => element('option', { value: speed, textContent: speedText(speed) })));
    Object.assign(byId('slider'), { min: clock.start, max: clock.stop });
    byId('play').addEventListener('click', () => clock.play());
    byId('back').addEventListener('click', () => this.step(-1));
    byId('on').addEventListener('click', () => this.step(1));
    byId('slider').addEventListener('input', (event) => clock.set(Number(event.target.value)));
    byId('speed').addEventListener('change', (event) => clock.setSpeed(Number(event.target.value)));
    byId('repeat').addEventListener('change', (event) => { clock.repeat = event.target.checked; });
    clock.listen(() => this.show());
  }

  show() {
    const { clock } = this;
    const text = formattedTime(clock.time, clock.span);
    byId('slider').value = clock.time;
    byId('slider').setAttribute('aria-valuetext', text);
    byId('time').textContent = `${text} of ${formattedTime(clock.stop, clock.span)}`;
    byId('speed').value = clock.speed;
    if (clock.playing === this.playing) return;
    this.playing = clock.playing;
    byId('play').innerHTML = clock.playing ? pauseIcon : playIcon;
    byId('play').setAttribute('aria-label', clock.playing ? 'Pause' : 'Play');
    byId('play').setAttribute('aria-pressed', clock.playing);
    say(clock.playing ? 'Playing' : `Paused at ${text}`);
  }

  step(steps) { this.pauseAt(this.clock.time + steps * this.clock.span / 200); }

  pauseAt(time) {
    if (this.clock.playing) this.clock.play(false);
    this.clock.set(time);
    say(formattedTime(this.clock.time, this.clock.span));
  }

  /** To a row of the table that has the most of them. */
  row(steps, table) {
    const { row, share } = table.place(Math.min(table.stop, Math.max(table.start, this.clock.time)));
    const next = Math.max(0, Math.min(table.times.length - 1, row + (steps < 0 && share > 0 ? 0 : steps)));
    this.pauseAt(table.times[next]);
  }

  faster(steps) {
    const at = this.speeds.indexOf(this.clock.speed);
    this.clock.setSpeed(this.speeds[Math.max(0, Math.min(this.speeds.length - 1, at + steps))]);
    say(`Speed ${speedText(this.clock.speed)}`);
  }
}

/** Tells assistive technology. */
function say(text) { byId('said').textContent = text; }

/** What a key does. */
function keys(player, scene, table) {
  const { clock } = player;
  const turn = Math.PI / 24;
  return {
    ' ': () => clock.play(),
    ArrowLeft: () => player.step(-1),
    ArrowRight: () => player.step(1),
    'Shift+ArrowLeft': () => scene?.orbit(-turn, 0),
    'Shift+ArrowRight': () => scene?.orbit(turn, 0),
    'Shift+ArrowUp': () => scene?.orbit(0, turn),
    'Shift+ArrowDown': () => scene?.orbit(0, -turn),
    ',': () => player.row(-1, table),
    '.': () => player.row(1, table),
    Home: () => player.pauseAt(clock.start),
    End: () => player.pauseAt(clock.stop),
    '+': () => player.faster(1),
    '=': () => player.faster(1),
    '-': () => player.faster(-1),
    i: () => scene?.zoom(1 / 1.15),
    o: () => scene?.zoom(1.15),
    f: () => scene?.look('fit'),
  };
}

/** Keys count everywhere but in a list and in an open dialog; on a button the space bar presses it. */
function listenToKeys(actions) {
  document.addEventListener('keydown', (event) => {
    const { target, key } = event;
    if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector('dialog[open]')) return;
    if (target.tagName === 'SELECT' || (key === ' ' && target.matches('button, input[type=checkbox]'))) return;
    const arrow = key.startsWith('Arrow');
    const action = actions[event.shiftKey && arrow ? `Shift+${key}` : key.length === 1 ? key.toLowerCase() : key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

/** Buttons above the scene. */
function connectScene(scene) {
  for (const view of ['fit', 'front', 'side', 'top']) byId(view).addEventListener('click', () => scene.look(view));
  byId('follow').checked = scene.following;
  byId('follow').addEventListener('change', (event) => scene.setFollowing(event.target.checked));
  byId('trace').append(element('option', { value: '', textContent: 'no point' }));
  scene.mechanisms.forEach((mechanism, number) => mechanism.points.forEach((point) => {
    if (!point.point || point.columns.length === 0 || mechanism.result.role === 'reference') return;
    const several = scene.mechanisms.length > scene.results.length;
    byId('trace').append(element('option', { value: `${number} ${point.name}`, textContent: several ? `${mechanism.instance}: ${point.name}` : point.name }));
  }));
  byId('trace').addEventListener('change', (event) => scene.trace(sameInEach(scene, event.target.value)));
  scene.ondraw = () => {
    showAxes(scene);
    byId('scale').textContent = `Grid ${formatted(scene.ground.cell, 'm')}`;
  };
}

/** The point that was chosen, in each result that has its mechanism. */
function sameInEach(scene, choice) {
  if (!choice) return new Set();
  const [number, ...name] = choice.split(' ');
  const { instance } = scene.mechanisms[number];
  return new Set(scene.mechanisms.flatMap((mechanism, k) => (mechanism.instance === instance ? [`${k} ${name.join(' ')}`] : [])));
}

/** The directions of the axes as they are seen. */
function showAxes(scene) {
  const inverse = new THREE.Matrix4().extractRotation(scene.camera.matrixWorld).transpose();
  const axes = [['x', 1, 0, 0], ['y', 0, 1, 0], ['z', 0, 0, 1]].map(([name, ...way]) => {
    const seen = new THREE.Vector3(...way).applyMatrix4(inverse).multiplyScalar(26);
    return { name, x: seen.x, y: -seen.y, depth: seen.z };
  }).sort((a, b) => a.depth - b.depth);
  const colours = { x: '#d5534f', y: '#4f9d5b', z: '#4f86d6' };
  byId('axes').innerHTML = axes.filter((axis) => Math.hypot(axis.x, axis.y) > 3).map((axis) =>
    `<line x2="${axis.x}" y2="${axis.y}" stroke="${colours[axis.name]}" stroke-width="2.5" stroke-linecap="round"/>`
    + `<text x="${1.32 * axis.x}" y="${1.32 * axis.y}" fill="${colours[axis.name]}">${axis.name}</text>`).join('');
}
