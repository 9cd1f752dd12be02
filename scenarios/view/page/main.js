// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** What stands above the scene. */
function showHeading(data, results) {
  document.title = `${data.title} · tandem`;
  byId('title').textContent = data.title;
  byId('description').textContent = data.description;
  byId('legend').append(...results.map((result) => element('li', { className: result.role, textContent: result.label })));
  byId('legend').hidden = results.length < 2;
  byId('difference-label').hidden = results.length < 2;
  byId('made').textContent = `Made by tandem ${data.tandem}`;
  const failed = results.filter((result) => !['', 'ok'].includes(result.status));
  const notes = [...data.notes, ...failed.map((result) => `${result.label} ${result.status}: ${result.message}`)];
  byId('notes').append(...notes.map((note) => element('li', { textContent: note })));
}

/** How each result was made, as a table of words. */
function showDetails(results) {
  for (const result of results) {
    const rows = [['rows', result.tables.map((table) => table.times.length).join(', ')], ...Object.entries(result.details)];
    const text = (value) => (Array.isArray(value) ? value.join('; ') : typeof value === 'object' ? Object.entries(value).map((pair) => pair.join(' ')).join(', ') : String(value));
    byId('details').append(element('h3', { textContent: result.label }), element('table', {}, ...rows.map(([name, value]) =>
      element('tr', {}, element('th', { textContent: name, scope: 'row' }), element('td', { textContent: text(value) })))));
  }
}

function connectDialogs() {
  document.querySelectorAll('[data-opens]').forEach((button) =>
    button.addEventListener('click', () => byId(button.dataset.opens).showModal()));
}

/** The scene, or null where there is no mechanism or no WebGL, which is told. */
function makeScene(results, clock) {
  const mechanisms = results.flatMap((result) => result.mechanisms);
  byId('stage').hidden = mechanisms.length === 0;
  if (mechanisms.length === 0) return null;
  try {
    const scene = new Scene(byId('canvas'), results, clock);
    connectScene(scene);
    describeScene(scene, mechanisms);
    return scene;
  } catch (error) {
    byId('stage').hidden = true;
    byId('notes').append(element('li', { textContent: `The mechanism can't be drawn (${error.message}); the plots are there.` }));
    return null;
  }
}

function describeScene(scene, mechanisms) {
  const parts = mechanisms.map((m) => `${m.instance}: ${m.rods.length + m.plates.length} bodies, ${m.springs.length} springs, ${m.wheels.length} wheels`);
  const canvas = byId('canvas');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `Moving picture of the mechanism. ${parts.join('; ')}. Shift with arrows turns the view, I and O zoom.`);
}

/** The paths that the files ask for. */
function firstPaths(scene) {
  const chosen = scene.mechanisms.flatMap((mechanism, number) => mechanism.trace.map((point) => `${number} ${mechanism.points[point].name}`));
  if (chosen.length === 0) return;
  scene.trace(new Set(chosen));
  byId('trace').value = chosen[0];
}

function begin() {
  const data = JSON.parse(byId('data').textContent);
  const results = data.results.map((json, k) => new Result(json, k === 0 ? 'result' : 'reference'));
  const clock = new Clock(Math.min(...results.map((r) => r.start)), Math.max(...results.map((r) => r.stop)));
  const player = new Player(clock);
  showHeading(data, results);
  showDetails(results);
  connectDialogs();
  const scene = makeScene(results, clock);
  if (scene) firstPaths(scene);
  const plots = new Plots(byId('plots'), results, clock);
  data.plots.forEach((name) => plots.add(name));
  byId('add').addEventListener('click', () => plots.addAnother());
  byId('unzoom').addEventListener('click', () => plots.zoom(null));
  plots.onzoom = (window) => { byId('unzoom').hidden = !window; };
  byId('difference').addEventListener('change', (event) => {
    plots.difference = event.target.checked;
    plots.draw();
  });
  const [longest] = results.flatMap((result) => result.tables).sort((a, b) => b.times.length - a.times.length);
  listenToKeys(keys(player, scene, longest));
  dark.addEventListener('change', () => {
    scene?.build();
    plots.draw();
  });
  window.tandem = { clock, scene, plots, results }; // for tests and the curious
}

begin();
