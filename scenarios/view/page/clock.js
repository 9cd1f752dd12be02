// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
'use strict';

/** The time that is shown. Listeners are told when it, the speed or playing changes. */
class Clock {
  constructor(start, stop) {
    this.start = start;
    this.stop = stop;
    this.time = start;
    this.playing = false;
    this.repeat = false;
    this.speed = Clock.firstSpeed(stop - start);
    this.listeners = [];
  }

  /** As fast as it happens if that takes 2 to 60 s, else so that it takes about 10 s. */
  static firstSpeed(span) {
    return span >= 2 && span <= 60 ? 1 : roundDown(Math.max(span, 1e-9) / 10);
  }

  get span() { return this.stop - this.start; }

  listen(listener) {
    this.listeners.push(listener);
    listener(this);
  }

  tell() { this.listeners.forEach((listener) => listener(this)); }

  set(time) {
    this.time = Math.min(this.stop, Math.max(this.start, time));
    this.tell();
  }

  play(playing = !this.playing) {
    if (playing && this.time >= this.stop) this.time = this.start;
    this.playing = playing;
    this.before = undefined;
    if (playing) requestAnimationFrame((now) => this.tick(now));
    this.tell();
  }

  /** One frame; times of frames are in milliseconds. */
  tick(now) {
    if (!this.playing) return;
    const passed = this.before === undefined ? 0 : Math.min(0.25, (now - this.before) / 1000);
    this.before = now;
    const time = this.time + passed * this.speed;
    if (time < this.stop) this.time = time;
    else if (this.repeat) this.time = this.start;
    else [this.time, this.playing] = [this.stop, false];
    this.tell();
    requestAnimationFrame((later) => this.tick(later));
  }

  setSpeed(speed) {
    this.speed = speed;
    this.tell();
  }
}
