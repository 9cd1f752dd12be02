// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** Little-endian numbers in base64. */
function numbersIn(text, Type) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return new Type(bytes.buffer);
}

/** A recorded quantity. Its numbers are unpacked when they are first asked for. */
class Column {
  constructor(json, table) {
    this.name = json.name;
    this.unit = json.unit;
    this.position = json.position === true; // only the drawing needs it
    this.held = json.held === true; // constant from row to row
    this.table = table;
    this.json = json;
  }

  get values() {
    this.unpacked ??= this.json.f4 ? numbersIn(this.json.f4, Float32Array) : numbersIn(this.json.f8, Float64Array);
    return this.unpacked;
  }

  /** Linear between rows, or held; NaN beyond them and beside an empty cell. */
  at(t) {
    const { row, share } = this.table.place(t);
    if (row < 0) return NaN;
    return share === 0 || this.held ? this.values[row] : (1 - share) * this.values[row] + share * this.values[row + 1];
  }
}

/** Rows over time; a time may be there twice, which is a jump. */
class Table {
  constructor(json) {
    this.times = numbersIn(json.time, Float64Array);
    this.columns = json.columns.map((column) => new Column(column, this));
    this.found = { t: NaN, row: -1, share: 0 };
  }

  get start() { return this.times[0]; }
  get stop() { return this.times[this.times.length - 1]; }

  /** The last row at or before t, and how far t is on the way to the next. */
  place(t) {
    if (this.found.t !== t) this.found = { t, ...this.search(t) };
    return this.found;
  }

  search(t) {
    const times = this.times;
    if (!(t >= this.start && t <= this.stop)) return { row: -1, share: 0 };
    let low = 0;
    let high = times.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle;
      else high = middle;
    }
    if (low === times.length - 1 || times[low] === t) return { row: low, share: 0 };
    return { row: low, share: (t - times[low]) / (times[low + 1] - times[low]) };
  }
}

/** One result: its tables, and what is drawn of it. */
class Result {
  constructor(json, role) {
    Object.assign(this, json, { role });
    this.tables = json.tables.filter((table) => table.rows > 0).map((table) => new Table(table));
    this.columns = this.tables.flatMap((table) => table.columns);
    this.byName = new Map(this.columns.map((column) => [column.name, column]));
  }

  column(name) { return this.byName.get(name); }
  get start() { return Math.min(...this.tables.map((table) => table.start)); }
  get stop() { return Math.max(...this.tables.map((table) => table.stop)); }
}
