// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/linkage_run.hpp"

#include <chrono>
#include <cmath>

#include "bench/generic_index3.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/mbs/formulations/index3.hpp"

namespace tandem::bench {
namespace {

constexpr double penalty_factor = 1e8;

std::unique_ptr<mbs::Stepper> stepper(const LinkageCase& c, mbs::Mechanism& linkage) {
  if (c.solver == "generic") return std::make_unique<GenericIndex3>(linkage, penalty_factor, c.tolerance);
  mbs::Index3Settings settings;
  settings.penalty = penalty_factor;
  settings.tolerance = c.tolerance;
  settings.solver = c.solver;
  return std::make_unique<mbs::Index3>(linkage, settings);
}

}  // namespace

LinkageRun::LinkageRun(const LinkageCase& c, mbs::Mechanism& linkage)
    : loops_(c.loops), h_(c.step), linkage_(linkage), stepper_(stepper(c, linkage)) {
  begin();
}

void LinkageRun::begin() {
  s_ = linkage_.described_state();
  stepper_->start(s_);
  done_ = iterations_ = 0;
}

double LinkageRun::steps(long count) {
  const auto began = std::chrono::steady_clock::now();
  for (long k = 0; k < count; ++k, ++done_)
    iterations_ += stepper_->step(s_, h_, static_cast<double>(done_ + 1) * h_);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

double LinkageRun::x_error() const {
  return std::abs(s_.q[linkage_.coordinate(0)] - std::sin(four_bar::exact(loops_, s_.time).angle));
}

double LinkageRun::drift() const {
  const mbs::State start = linkage_.described_state();
  const double change =
      linkage_.energy(s_.q.data(), s_.v.data()) - linkage_.energy(start.q.data(), start.v.data());
  return std::abs(change) / linkage_.potential(start.q.data());
}

}  // namespace tandem::bench
