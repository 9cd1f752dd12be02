// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "keys.hpp"
#include "tandem/text/series.hpp"

namespace tandem::mbs {
namespace {

using text::KeyList;

void keys_of_inputs(KeyList& to) {
  using enum text::Key::Type;
  to.named("inputs", "What forces, drives and elements follow: ports, or functions of time.",
           "An input. It has at most one of `value`, `polynomial`, `sine`, `file` and `times`. Data of a "
           "drive are a "
           "spline.")
      .need("unit", text, "Its unit.", {.allowed = "like \"N\"; \"1\" for a ratio"})
      .may("value", number, "What the port has until something else is given.")
      .may("polynomial", numbers, "Coefficients of a polynomial of time, from the constant upwards.");
  text::keys_of_series(to);
  to.table("inputs.NAME.sine", "mean + amplitude sin(2 pi frequency t + phase).")
      .need("amplitude", number, "In the unit of the input.")
      .need("frequency", positive, "Its frequency.", {.unit = "Hz"})
      .may("phase", number, "Its phase.", {.unit = "rad", .otherwise = "0.0"})
      .may("mean", number, "In the unit of the input.", {.otherwise = "0.0"});
}

}  // namespace

void keys_of_forces(KeyList& to) {
  using enum text::Key::Type;
  keys_of_inputs(to);
  to.named("springs", "Springs and dampers, on two points or on a coordinate.",
           "A spring. It has `points` or `coordinate`.")
      .may("points", texts, "Its ends.", {.allowed = "two points"})
      .may("coordinate", text, "The angle or length that it acts on.")
      .may("stiffness", numbers, "The force that pulls it back: by x, or by x, x^2, x^3, ..")
      .may("damping", numbers, "By the rate of x, or by its powers.")
      .may("free", number, "The value without force; without it as drawn.", {.unit = "m or rad"})
      .named("forces", "Forces by a number or by an input.",
             "A force. It has one of `point`, `between` and `coordinate`.")
      .may("point", text, "The point that it acts on, which is not fixed.")
      .may("direction", vector, "Of `point`: the direction that it acts in; its length is a factor.")
      .may("between", texts, "Two points that it drives apart.", {.allowed = "two points"})
      .may("coordinate", text, "The angle or length that it acts on.")
      .need("magnitude", name, "A number, or the name of an input, in N or N m.")
      .may("gain", number, "The force is the magnitude times this; the input may then have any unit.");
}

}  // namespace tandem::mbs
