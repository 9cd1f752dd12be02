// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/source.hpp"

#include <algorithm>
#include <sstream>

#include "mechanisms/view_table.hpp"
#include "sources/elements.hpp"
#include "sources/run_table.hpp"
#include "sources/stepper.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/text/section.hpp"

namespace tandem::mechanisms {
namespace {

/// Numbers with commas between them.
std::vector<double> list(const std::string& name, const std::string& text) {
  std::vector<double> all;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) {
    Parameters one;
    one.set(name, word);
    all.push_back(one.number(name, 0.0));
  }
  std::sort(all.begin(), all.end());
  return all;
}

mbs::MatrixDump dump(Parameters& p) {
  mbs::MatrixDump d;
  d.folder = p.text("matrices", "");
  d.times = list("matrices_at", p.text("matrices_at", "-inf"));
  d.format = mbs::matrix_format(p.text("matrices_format", "mtx"));
  return d;
}

/// An output for each coordinate of a point, and of a vector that moves, that has none of that name.
void animate(mbs::Description& d) {
  constexpr const char* axes[] = {"x", "y", "z"};
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e) {
    const mbs::Entity& entity = d.entities[static_cast<std::size_t>(e)];
    if (entity.fixed && entity.kind == mbs::Entity::Kind::vector) continue;
    for (int axis = 0; axis < d.dimension; ++axis) {
      const std::string name = entity.name + "." + axes[axis];
      const bool there = std::any_of(d.outputs.begin(), d.outputs.end(),
                                     [&](const mbs::Output& o) { return o.name == name; });
      if (!there) d.outputs.push_back({name, mbs::Output::Kind::position, {e, axis}});
    }
  }
}

std::unique_ptr<Subsystem> make(const std::filesystem::path& file, Parameters& p) {
  const text::Document document(file);
  take_run_table(document, p);
  mbs::Description description =
      mbs::read_mechanism(file, element_kinds([&p] { return p.text("tyre", ""); }));
  read_view(document, description);  // refuses what is wrong with it
  if (p.flag("animate", false)) animate(description);
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "mechanism '" + description.name +
                    "' has no own step; give the parameter step, a number above 0 "
                    "[s], or step in the table [run] of its file");
  const double step = p.number("step", 0.0);
  return mbs::make_subsystem(std::move(description), {step, take_stepper(p), dump(p)});
}

}  // namespace

void add_sources(Builtins& builtins) { builtins.files["mechanism"] = make; }

}  // namespace tandem::mechanisms
