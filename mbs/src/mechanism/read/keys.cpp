// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "keys.hpp"

#include "mechanism/elements/own_elements.hpp"
#include "tandem/mbs/mechanism/keys.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::mbs {
namespace {

using text::KeyList;

void keys_of_file(KeyList& to) {
  using enum text::Key::Type;
  to.may("name", text, "Its name; without it the file's.", {.allowed = "without [ ] , \" and blanks"})
      .may("description", text, "A sentence about it.")
      .need("dimension", number, "How many it moves in.", {.allowed = "2 for the plane, 3 for space"})
      .may("gravity", vector, "The acceleration of what falls; without it zero.", {.unit = "m/s^2"});
  text::keys_of_parameters(to);
}

/// Of points and of vectors.
void keys_of_entities(KeyList& to) {
  using enum text::Key::Type;
  to.may("fixed", flag, "It does not move.", {.otherwise = "false"})
      .may("massless", flag, "It belongs to no body; equations hold it.", {.otherwise = "false"});
}

void keys_of_bodies(KeyList& to) {
  using enum text::Key::Type;
  to.named("points", "Points that bodies share: two with one in common are joined there.", "A point.")
      .need("at", vector, "Its place as drawn.", {.unit = "m"})
      .may("velocity", vector, "At the start; without it what constraints and others give.", {.unit = "m/s"});
  keys_of_entities(to);
  to.named("vectors", "Directions that bodies have or share.", "A vector.")
      .need("at", vector, "The vector itself as drawn, which is not zero.")
      .may("velocity", vector, "Its rate at the start.", {.unit = "1/s"});
  keys_of_entities(to);
  to.named("rods", "Bodies that are uniform and thin, between two points.", "A rod.")
      .need("points", texts, "Its ends.", {.allowed = "two points"})
      .need("mass", positive, "Its mass.", {.unit = "kg"})
      .may("free", flag, "It hangs on nothing that is fixed.", {.otherwise = "false"})
      .named("bodies", "Rigid bodies as drawn.", "A body.")
      .need("points", texts, "The points that it has.", {.allowed = "one or more"})
      .may("vectors", texts, "The vectors that it has.")
      .may("basis", texts,
           "Those of its points and vectors that define it; the others follow by linear equations. Without "
           "it as many as are needed.")
      .need("mass", positive, "Its mass.", {.unit = "kg"})
      .need("centre", vector, "Its centre of mass as drawn.", {.unit = "m"})
      .need("inertia", matrix, "About the centre.",
            {.unit = "kg m^2", .allowed = "above 0 in the plane; in space a symmetric tensor, three rows"})
      .may("free", flag, "It hangs on nothing that is fixed.", {.otherwise = "false"})
      .named("masses", "Masses that are added at points.", "A mass.")
      .need("point", text, "The point.")
      .need("mass", number, "The mass.", {.unit = "kg", .allowed = "0 or more"})
      .may("free", flag, "It hangs on nothing that is fixed.", {.otherwise = "false"});
}

void keys_of_elements(KeyList& to, const ElementKinds& kinds) {
  using enum text::Key::Type;
  std::vector<std::string> words;
  for (const auto& [word, kind] : kinds) words.push_back(word);
  to.named("elements", "Force laws with keys of their own.", "An element.")
      .need("kind", word, "What it is.", {.words = words});
  for (const auto& [word, kind] : kinds) {
    to.kind(word, kind.sentence);
    kind.keys(to);
  }
}

void keys_of_view(KeyList& to) {
  using enum text::Key::Type;
  to.table("view", "How `tandem view` draws it.")
      .may("ground", number, "The height of the ground.", {.unit = "m"})
      .may("follow", text, "A point that the view goes with.")
      .may("trace", texts, "Points whose paths are drawn.")
      .may("plots", texts, "Outputs that are plotted.")
      .table("view.wheels[]", "Wheels.")
      .need("centre", text, "The point at its centre.")
      .need("radius", positive, "Its radius.", {.unit = "m"})
      .may("width", positive, "Without it half the radius.", {.unit = "m"})
      .may("axis", edge, "Its axis, which it has in space.", {.allowed = "a vector or two points"})
      .may("spoke", edge, "What turns with it, or", {.allowed = "a vector or two points"})
      .may("angle", text, "the output that is its angle.");
}

}  // namespace

text::Keys mechanism_keys(const ElementKinds& kinds) {
  ElementKinds all = own_elements();
  all.insert(kinds.begin(), kinds.end());
  KeyList list;
  for (const auto part : {keys_of_file, keys_of_bodies, keys_of_constraints, keys_of_forces}) part(list);
  keys_of_elements(list, all);
  keys_of_outputs(list);
  keys_of_runs(list);
  keys_of_view(list);
  return text::Keys(std::move(list).list(), text::Keys::Texts::refer_in_arrays);
}

}  // namespace tandem::mbs
