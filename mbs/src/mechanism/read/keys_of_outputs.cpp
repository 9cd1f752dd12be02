// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "keys.hpp"
#include "tandem/text/limits.hpp"

namespace tandem::mbs {
namespace {

using text::KeyList;

const char* const coordinate = "\"P.x\" of a point or vector, or an angle, length or coordinate";

void keys_of_start(KeyList& to) {
  using enum text::Key::Type;
  to.table("initial", "Where it starts.")
      .may("positions", factors, "Coordinates that are kept.", {.allowed = "by coordinate"})
      .may("velocities", factors, "Their rates.", {.allowed = "by coordinate"})
      .may("equilibrium", flag, "It starts where forces at rest balance.", {.otherwise = "false"});
}

}  // namespace

void keys_of_outputs(KeyList& to) {
  using enum text::Key::Type;
  to.named("outputs", "What is read of it.",
           "An output. It has one of `position`, `velocity`, `acceleration`, `reaction`, `energy`, "
           "`residual`, `elevation`, `heading`, `element` and `accelerance`.")
      .may("position", text, "A coordinate.", {.allowed = coordinate})
      .may("velocity", text, "The rate of a coordinate.", {.allowed = coordinate})
      .may("acceleration", text, "The second rate of a coordinate.", {.allowed = coordinate})
      .may("reaction", text,
           "Of a drive, or of a fixed point or vector along an axis, on the mechanism; with `body` on that.",
           {.allowed = "a drive, or \"P.x\""})
      .may("body", text, "The body that a reaction is on.")
      .may("energy", word, "Its energy; `drift`: since the start.",
           {.unit = "J", .words = {"kinetic", "potential", "total", "drift"}})
      .may("residual", word, "The largest of a kind of the constraints' residuals.",
           {.words = {"position", "velocity", "acceleration"}})
      .may("elevation", edge,
           "Angle of an edge over the plane of the first two axes; in the plane over the first.",
           {.unit = "rad"})
      .may("heading", edge, "Angle of an edge in that plane, from the first axis.", {.unit = "rad"})
      .may("element", text, "An element, of which it is a `quantity`.")
      .may("quantity", text, "Its name.")
      .may("accelerance", text,
           "By how much an input of 1 accelerates a coordinate through its forces at once "
           "(docs/impulse_coupling.md).",
           {.allowed = coordinate})
      .may("input", text, "That input, which only forces follow.")
      .may("gain", number, "The output is the quantity times this.", {.otherwise = "1.0"});
  text::keys_of_limits(to, "at the end of each own step", any,
                       "the name of an output, or { element = .., quantity = .. }");
  keys_of_start(to);
}

}  // namespace tandem::mbs
