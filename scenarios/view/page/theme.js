// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

const dark = matchMedia('(prefers-color-scheme: dark)');

/** A colour of style.css as it is now. */
function styleColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Bodies of a single result, told apart by hue and lightness. */
const palettes = {
  light: ['#3b6fb6', '#e08a1e', '#4f9d5b', '#c8504f', '#7c5fae', '#3e9a9f', '#a9762f', '#b8578f'],
  dark: ['#6fa3e8', '#f2a950', '#79c386', '#ef7f7d', '#a88be0', '#66c6c9', '#d3a560', '#e28cbd'],
};

function bodyColour(number) {
  const palette = dark.matches ? palettes.dark : palettes.light;
  return palette[number % palette.length];
}

/** What the scene is lit and drawn in. */
function sceneColours() {
  return dark.matches
    ? { ground: '#3a4350', link: '#aab4c2', joint: '#e6eaf0', fixed: '#8b97a8', spring: '#c3cad4', tyre: '#39424e', shadow: 0.5 }
    : { ground: '#d3d8df', link: '#6d7888', joint: '#39424e', fixed: '#4a5563', spring: '#69748a', tyre: '#333b46', shadow: 0.16 };
}
