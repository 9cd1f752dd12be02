// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/mechanism.hpp"

#include <algorithm>
#include <sstream>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/sources/run_table.hpp"
#include "tandem/sources/stepper.hpp"

namespace tandem {
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

}  // namespace

std::unique_ptr<Subsystem> make_mechanism(const SourceFile& file, Parameters& p,
                                          const mbs::ElementKinds& kinds, const LookAtMechanism& look,
                                          const mbs::TellOfLimit& tell) {
  const text::Document document = file.document();
  take_run_table(document, p);
  mbs::Description description = file.text ? mbs::read_mechanism(file.path.string(), *file.text, kinds)
                                           : mbs::read_mechanism(file.path, kinds);
  if (look) look(document, description, p);
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "mechanism '" + description.name +
                    "' has no own step; give the parameter step, a number above 0 "
                    "[s], or step in the table [run] of its file");
  const double step = p.number("step", 0.0);
  mbs::SubsystemSettings settings{step, take_stepper(p), dump(p)};
  if (tell)
    settings.tell = [tell, name = description.name](const std::string& text) {
      tell("mechanism '" + name + "': " + text);
    };
  return mbs::make_subsystem(std::move(description), settings);
}

}  // namespace tandem
