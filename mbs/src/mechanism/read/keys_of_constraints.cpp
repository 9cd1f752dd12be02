// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "keys.hpp"

namespace tandem::mbs {
namespace {

using text::KeyList;

const char* const carriers = "each a body, a point, \"ground\", or an array of points and vectors";

void keys_of_joint(KeyList& to, const char* kind, const char* sentence, const char* axis) {
  using enum text::Key::Type;
  to.kind(kind, sentence);
  if (axis) to.may("axis", vector, axis);
}

void keys_of_joints(KeyList& to) {
  using enum text::Key::Type;
  to.named("joints", "Joints of bodies that share no point.", "A joint, which moves with both bodies.")
      .need("kind", word, "What it is.",
            {.words = {"revolute", "prismatic", "cylindrical", "spherical", "universal", "point_on_line",
                       "point_on_plane"}})
      .need("between", texts, "The two that it joins.",
            {.allowed = "two, each a body, a point, or \"ground\""})
      .need("at", vector, "Its place as drawn.", {.unit = "m"});
  keys_of_joint(to, "revolute", "They turn about an axis; in the plane about a point.",
                "The axis as drawn, which it has in space.");
  keys_of_joint(to, "prismatic", "They slide along an axis without turning.", "The axis as drawn.");
  keys_of_joint(to, "cylindrical", "They slide along an axis and turn about it.", "The axis as drawn.");
  keys_of_joint(to, "spherical", "A point of both.", nullptr);
  keys_of_joint(to, "universal", "A point of both, and two axes that stay at a right angle.",
                "The first one's axis as drawn.");
  to.need("second_axis", vector, "The second one's axis as drawn.");
  keys_of_joint(to, "point_on_line", "A point of the first stays on a line of the second.",
                "The line's direction as drawn.");
  keys_of_joint(to, "point_on_plane", "A point of the first stays on a plane of the second.",
                "The plane's normal as drawn.");
}

void keys_of_relative_coordinates(KeyList& to) {
  using enum text::Key::Type;
  to.named("angles", "Coordinates that are angles from an edge to another.", "An angle.")
      .need("from", edge, "The edge that it begins at.", {.allowed = "a vector or two points"})
      .need("to", edge, "The edge that it ends at.", {.allowed = "a vector or two points"})
      .may("axis", text, "A vector that it turns about, which it has in space.")
      .named("lengths", "Coordinates that are distances.", "A length. It has `points` or `between`.")
      .may("points", texts, "Its ends.", {.allowed = "two points"})
      .may("between", edges, "What its ends belong to.", {.allowed = carriers})
      .may("ends", matrix, "With `between`: the two places as drawn.", {.unit = "m"})
      .named("coordinates", "Coordinates without an equation, for others to use.", "A coordinate.")
      .need("unit", word, "What it is.", {.words = {"rad", "m"}})
      .may("at", number, "Its value as drawn.", {.otherwise = "0.0"})
      .may("inertia", positive, "That of itself, [kg m^2] or [kg].");
}

}  // namespace

void keys_of_constraints(KeyList& to) {
  using enum text::Key::Type;
  to.named("distances", "Distances that are kept.", "A distance. It has `points` or `between`.")
      .may("points", texts, "Its ends.", {.allowed = "two points"})
      .may("length", positive, "Of `points`; without it as drawn.", {.unit = "m"})
      .may("between", edges, "What its ends belong to.", {.allowed = carriers})
      .may("ends", matrix, "With `between`: the two places as drawn.", {.unit = "m"})
      .named("products", "Scalar products of edges that are kept.", "A product.")
      .need("edges", edges, "The two.", {.allowed = "each a vector or two points"})
      .may("value", number, "Without it as drawn.", {.unit = "m^2"})
      .named("fixed_angles", "Angles of edges that are kept as drawn.", "An angle.")
      .need("edges", edges, "The two.", {.allowed = "each a vector or two points"});
  keys_of_joints(to);
  keys_of_relative_coordinates(to);
  to.named("relations", "Sums of coordinates that are kept.", "A relation.")
      .need("terms", factors, "`{ COORDINATE = FACTOR }`.")
      .may("value", number, "What the sum is; without it as drawn.")
      .table("relations.NAME.products[]", "Scalar products in the sum.")
      .need("edges", edges, "The two.", {.allowed = "each a vector or two points"})
      .may("factor", number, "Of the product in the sum.", {.otherwise = "1.0"})
      .named("slides", "Points that move along a direction of a body, by a coordinate.", "A slide.")
      .need("point", text, "The point.")
      .need("on", text, "The body, a point, or \"ground\".")
      .need("along", vector, "The direction as drawn.")
      .need("coordinate", text, "How far.", {.allowed = "an angle, a length or one of [coordinates]"})
      .named("drives", "Coordinates that follow inputs.", "A drive.")
      .need("coordinate", text, "What it moves.", {.allowed = "\"P.x\", or an angle or length"})
      .need("motion", text, "The input that it follows.");
}

}  // namespace tandem::mbs
