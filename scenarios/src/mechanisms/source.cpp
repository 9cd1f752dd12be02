// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "mechanisms/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sources/run_table.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "tandem/text/section.hpp"

namespace tandem::mechanisms {
namespace {

[[noreturn]] void refuse(const std::string& name, double value, const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument,
              fmt::format("parameter '{}' is {}; allowed is {}", name, value, allowed));
}

/// A count.
int whole(Parameters& p, const std::string& name, int otherwise, int most = 1000000000) {
  const double value = p.number(name, otherwise);
  if (value == std::floor(value) && value >= 1.0 && value <= most) return static_cast<int>(value);
  refuse(name, value, fmt::format("a whole number from 1 to {}", most));
}

/// Among the settings 0 stands for the default.
double penalty(Parameters& p, double otherwise) {
  const bool given = p.has("penalty");
  const double value = p.number("penalty", otherwise);
  if (given && !(value > 0.0)) refuse("penalty", value, "a number above 0, or to leave it out");
  return value;
}

void take(Parameters& p, mbs::Index3Settings& s) {
  s.penalty = penalty(p, s.penalty);
  s.beta = p.number("beta", s.beta);
  s.tolerance = p.number("tolerance", s.tolerance);
  s.most_iterations = whole(p, "most_iterations", s.most_iterations);
  s.multiplier_iterations = whole(p, "multiplier_iterations", s.multiplier_iterations);
  s.projections = whole(p, "projections", s.projections);
  s.carry_multipliers = p.flag("carry_multipliers", s.carry_multipliers);
  s.solver = p.text("solver", s.solver);
  s.threads = whole(p, "threads", s.threads, 256);
}

template <class Stabilized>
void take_stabilized(Parameters& p, Stabilized& s) {
  s.penalty = penalty(p, s.penalty);
  s.xi = p.number("xi", s.xi);
  s.omega = p.number("omega", s.omega);
  s.solver = p.text("solver", s.solver);
}

void take_integrator(Parameters& p, mbs::StepperSettings& s) {
  if (s.integrator == "newmark") {
    s.newmark.beta = p.number("beta", s.newmark.beta);
    s.newmark.tolerance = p.number("tolerance", s.newmark.tolerance);
    s.newmark.most_iterations = whole(p, "most_iterations", s.newmark.most_iterations);
  }
  if (s.integrator == "generalized_alpha") {
    auto& alpha = s.generalized_alpha;
    alpha.spectral_radius = p.number("spectral_radius", alpha.spectral_radius);
    alpha.tolerance = p.number("tolerance", alpha.tolerance);
    alpha.most_iterations = whole(p, "most_iterations", alpha.most_iterations);
  }
}

mbs::StepperSettings stepper(Parameters& p) {
  mbs::StepperSettings s;
  s.formulation = p.text("formulation", s.formulation);
  s.integrator = p.text("integrator", s.integrator);
  if (s.formulation == "index3") {
    take(p, s.index3);
    return s;
  }
  if (s.formulation == "penalty") take_stabilized(p, s.penalty);
  if (s.formulation == "index1") {
    take_stabilized(p, s.index1);
    s.index1.multiplier_iterations = whole(p, "multiplier_iterations", s.index1.multiplier_iterations);
    s.index1.carry_multipliers = p.flag("carry_multipliers", s.index1.carry_multipliers);
  }
  take_integrator(p, s);
  return s;
}

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

/// An output for each coordinate of a point that has none of that name.
void animate(mbs::Description& d) {
  constexpr const char* axes[] = {"x", "y", "z"};
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e)
    for (int axis = 0; axis < d.dimension; ++axis) {
      const std::string name = d.entities[static_cast<std::size_t>(e)].name + "." + axes[axis];
      const bool there = std::any_of(d.outputs.begin(), d.outputs.end(),
                                     [&](const mbs::Output& o) { return o.name == name; });
      if (!there && d.entities[static_cast<std::size_t>(e)].kind == mbs::Entity::Kind::point)
        d.outputs.push_back({name, mbs::Output::Kind::position, {e, axis}});
    }
}

std::unique_ptr<Subsystem> make(const std::filesystem::path& file, Parameters& p) {
  const text::Document document(file);
  take_run_table(document, p);
  mbs::Description description = mbs::read_mechanism(file);
  if (p.flag("animate", false)) animate(description);
  if (!p.has("step"))
    throw Error(ErrorCode::invalid_argument,
                "mechanism '" + description.name +
                    "' has no own step; give the parameter step, a number above 0 "
                    "[s], or step in the table [run] of its file");
  const double step = p.number("step", 0.0);
  return mbs::make_subsystem(std::move(description), {step, stepper(p), dump(p)});
}

}  // namespace

void add_sources(Builtins& builtins) { builtins.files["mechanism"] = make; }

}  // namespace tandem::mechanisms
