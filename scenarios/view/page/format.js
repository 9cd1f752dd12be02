// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** Four digits that count, powers of ten beyond 1e-4 and 1e5. */
function formatted(value, unit) {
  if (!Number.isFinite(value)) return 'no value';
  const size = Math.abs(value);
  const text = size !== 0 && (size < 1e-4 || size >= 1e5)
    ? value.toExponential(3)
    : String(Number(value.toPrecision(4)));
  return unit && unit !== '1' ? `${text} ${unit}` : text;
}

/** As many decimals as the span needs: 1/1000 of it is seen. */
function formattedTime(t, span) {
  const decimals = Math.max(0, Math.min(9, 3 - Math.floor(Math.log10(span))));
  return `${t.toFixed(decimals)} s`;
}

/** The largest of 1, 2, 5 times a power of ten up to a number. */
function roundDown(x) {
  const power = 10 ** Math.floor(Math.log10(x) + 1e-9);
  return [5, 2, 1].find((digit) => digit * power <= x * (1 + 1e-9)) * power;
}

/** The least of 1, 2, 5 times a power of ten from a number on. */
function roundUp(x) {
  return 1 / roundDown(1 / x);
}

/** Round numbers of an axis, about `apart` pixels from each other, with as many decimals as they differ in. */
function ticks(low, high, pixels, apart, unit = '') {
  const step = roundUp((high - low) * apart / pixels);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const label = (v) => {
    const size = Math.max(Math.abs(low), Math.abs(high));
    if (v === 0) return '0';
    return size >= 1e5 || size < 1e-3 ? String(Number(v.toExponential(3))) : v.toFixed(Math.min(9, decimals));
  };
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.min(pixels, Math.floor((high - low) / step) + 2); // pixels: a span of mere rounding has none
  const all = Array.from({ length: count || 0 }, (_, k) => (first + k) * step || 0).filter((v) => v <= high + 1e-9 * step);
  return all.map((v) => ({ v, label: unit ? `${label(v)} ${unit}` : label(v) }));
}

/** "pitch [rad]": a quantity with its unit. */
function titled(name, unit) {
  return unit && unit !== '1' ? `${name} [${unit}]` : name;
}

/** An element with properties, and children. */
function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}
