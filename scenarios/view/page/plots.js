// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** Rows of one column, or of two over the times of both (null: only the other has that time). */
function rowsOf([a, b]) {
  const ta = a.table.times;
  if (!b) return Array.from(ta, (t, k) => [t, a.values[k]]);
  const tb = b.table.times;
  const rows = [];
  for (let i = 0, k = 0; i < ta.length || k < tb.length;) {
    const t = Math.min(ta[i] ?? Infinity, tb[k] ?? Infinity);
    rows.push([t, ta[i] === t ? a.values[i++] : null, tb[k] === t ? b.values[k++] : null]);
  }
  return rows;
}

/** Of the first less the second, at the times of the first that the second covers. */
function differenceOf([a, b]) {
  return Array.from(a.table.times, (t, k) => [t, a.values[k] - b.at(t)]).filter((row) => Number.isFinite(row[1]));
}

/** One quantity over time, of each result, with a cursor at the clock's time. */
class Plot {
  constructor(plots, name) {
    this.plots = plots;
    this.choice = plots.choice(name);
    this.choice.addEventListener('change', () => this.draw());
    this.values = element('span', { className: 'values' });
    const remove = element('button', { type: 'button', textContent: '✕', title: 'Remove this plot' });
    remove.setAttribute('aria-label', 'Remove this plot');
    remove.addEventListener('click', () => plots.remove(this));
    this.body = element('div', { className: 'plot-body' });
    this.body.setAttribute('role', 'img');
    this.cursor = element('div', { className: 'cursor' });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.body);
    this.object = element('article', { className: 'plot' },
      element('div', { className: 'plot-head' }, this.choice, this.values, remove), this.body);
  }

  /** Those of the results that have it, the result first. */
  get columns() {
    return this.plots.results.map((result) => result.column(this.choice.value)).filter((column) => column);
  }

  get differs() { return this.plots.difference && this.columns.length > 1; }

  draw() {
    this.graph?.destroy();
    const columns = this.columns;
    const rows = this.differs ? differenceOf(columns) : rowsOf(columns);
    const labels = this.differs ? ['difference'] : columns.map((column, k) => `${column.name} (${k + 1})`);
    this.range = extent(rows);
    const steps = labels.map((label, k) => [label, { stepPlot: this.differs ? columns.every((c) => c.held) : columns[k].held }]);
    this.graph = new Dygraph(this.body, rows, { ...this.look(columns), labels: ['t', ...labels], series: Object.fromEntries(steps) });
    this.width = this.body.clientWidth;
    this.body.append(this.cursor);
    this.update(this.plots.clock);
  }

  /** Takes it from the page; a size that is observed after that no longer reaches it. */
  remove() {
    this.observer.disconnect();
    this.graph.destroy();
    this.object.remove();
  }

  resize() {
    if (!this.graph || this.body.clientWidth === this.width) return;
    this.width = this.body.clientWidth;
    this.graph.resize();
    this.update(this.plots.clock);
  }

  look(columns) {
    const colours = columns.map((column) => styleColour(this.roleOf(column)));
    return {
      colors: this.differs ? [styleColour('text')] : colours,
      strokeWidth: 1.6, highlightCircleSize: 0, legend: 'never', connectSeparatedPoints: columns.length > 1,
      gridLineColor: styleColour('grid'), axisLineColor: styleColour('edge'), yRangePad: 8,
      dateWindow: this.plots.window,
      axes: {
        x: { ticker: (low, high, pixels) => ticks(low, high, pixels, 80, 's') },
        y: { ticker: (low, high, pixels) => ticks(low, high, pixels, 28), axisLabelWidth: labelWidth(this.range) },
      },
      interactionModel: { // no touch: fingers scroll the page
        willDestroyContextMyself: true,
        mousedown: (event, ...more) => {
          this.pressed = event.clientX;
          Dygraph.defaultInteractionModel.mousedown(event, ...more);
        },
        click: (event) => this.click(event),
        dblclick: () => this.plots.zoom(null),
      },
      zoomCallback: (from, to) => this.plots.zoom([from, to]),
    };
  }

  /** Sets the time, unless it is the end of a drag. */
  click(event) {
    if (Math.abs(event.clientX - this.pressed) > 3) return;
    this.plots.clock.set(this.graph.toDataXCoord(this.graph.eventToDomCoords(event)[0]));
  }

  roleOf(column) {
    return this.plots.results.find((result) => result.columns.includes(column)).role;
  }

  update(clock) {
    const columns = this.columns;
    const unit = columns[0].unit;
    const shown = this.differs
      ? [['', columns[0].at(clock.time) - columns[1].at(clock.time)]]
      : columns.map((column) => [this.roleOf(column), column.at(clock.time)]);
    this.values.replaceChildren(...shown.map(([role, value]) => element('span', { className: role, textContent: formatted(value, unit) })));
    const area = this.graph.getArea();
    const x = this.graph.toDomXCoord(clock.time);
    this.cursor.hidden = x < area.x - 1 || x > area.x + area.w + 1;
    this.cursor.style.transform = `translateX(${x}px)`;
    this.cursor.style.height = `${area.h}px`;
    if (!clock.playing) this.describe(shown, unit, clock);
  }

  /** For those who don't see it. */
  describe(shown, unit, clock) {
    const what = titled(this.choice.value, unit);
    const between = `from ${formatted(this.range[0])} to ${formatted(this.range[1], unit)}`;
    const now = shown.map(([, value]) => formatted(value, unit)).join(' and ');
    this.body.setAttribute('aria-label', `${this.differs ? 'Difference of ' : ''}${what} over time, ${between}; at ${formattedTime(clock.time, clock.span)} ${now}`);
  }
}

/** In which the numbers of an axis fit [px]. */
function labelWidth([low, high]) {
  const letters = Math.max(0, ...ticks(low, high, 120, 28).map(({ label }) => label.length));
  return Math.max(52, 7.2 * letters + 10);
}

function extent(rows) {
  let [low, high] = [Infinity, -Infinity];
  for (const row of rows)
    for (let k = 1; k < row.length; ++k)
      if (row[k] !== null && Number.isFinite(row[k])) [low, high] = [Math.min(low, row[k]), Math.max(high, row[k])];
  return [low, high];
}

/** The plots below the scene, which share the time and the part of it that is seen. */
class Plots {
  constructor(holder, results, clock) {
    Object.assign(this, { holder, results, clock, all: [], difference: false, window: null });
    clock.listen(() => this.all.forEach((plot) => plot.update(clock)));
  }

  /** A list of all columns, by subsystem; positions that only the drawing needs come last. */
  choice(name) {
    const select = element('select', { ariaLabel: 'Quantity' });
    select.setAttribute('aria-label', 'Quantity of this plot');
    const groups = new Map();
    for (const column of this.results.flatMap((result) => result.columns)) {
      const owner = column.name.split('.')[0] + (column.position ? ': positions' : '');
      if (!groups.has(owner)) groups.set(owner, new Map());
      groups.get(owner).set(column.name, column);
    }
    const order = [...groups].sort(([a], [b]) => a.endsWith(': positions') - b.endsWith(': positions'));
    for (const [owner, columns] of order)
      select.append(element('optgroup', { label: owner }, ...[...columns.values()].map((column) =>
        element('option', { value: column.name, textContent: titled(column.name, column.unit) }))));
    select.value = name;
    return select;
  }

  add(name) {
    const plot = new Plot(this, name);
    this.all.push(plot);
    this.holder.append(plot.object);
    plot.draw();
    return plot;
  }

  /** The first quantity that has no plot yet. */
  addAnother() {
    const shown = new Set(this.all.map((plot) => plot.choice.value));
    const names = this.results[0].columns.map((column) => column.name);
    this.add(names.find((name) => !shown.has(name)) ?? names[0]).choice.focus();
  }

  remove(plot) {
    plot.remove();
    this.all = this.all.filter((other) => other !== plot);
  }

  draw() { this.all.forEach((plot) => plot.draw()); }

  /** Shows a part of the time in each plot; null: the whole. */
  zoom(window) {
    this.window = window;
    const range = window ? {} : { valueRange: null };
    this.all.forEach((plot) => {
      plot.graph.updateOptions({ dateWindow: window, ...range });
      plot.update(this.clock);
    });
    this.onzoom?.(window);
  }
}
