// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "probe.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "tandem/error.hpp"

namespace tandem::identification {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

Probe::Probe(Subsystem& subsystem, const Wanted& wanted)
    : subsystem_(subsystem), wanted_(wanted), courses_(courses()) {
  const Abilities& can = subsystem.info().abilities;
  if (!can.restarts) refuse("can't start again");
  if (is_sampled())
    instants(2, nullptr);
  else
    start(1, nullptr);
}

void Probe::refuse(const std::string& what) const {
  throw Error(ErrorCode::not_supported, fmt::format("subsystem '{}' {}, so no linear model of it is found",
                                                    subsystem_.info().name, what));
}

Samples Probe::start(std::int64_t rows, const Change* change) {
  const std::int64_t size = subsystem_.info().row_size();
  memory_.assign(static_cast<std::size_t>(rows * size), 0.0);
  Samples y(memory_.data(), size, rows);
  std::vector<double> u0 = wanted_.inputs;
  if (change && change->place == all_places) u0[static_cast<std::size_t>(change->input)] += change->size;
  const Clock clock = subsystem_.initialize(wanted_.start, std::numeric_limits<double>::max(), u0, y);
  step_ = clock.next_time - clock.time;
  return y;
}

/// In one call, with the change all the way.
void Probe::advance(double until, const Change* change, Samples& y) {
  std::vector<Segment> pieces;
  for (const double value : wanted_.inputs) pieces.push_back({never, wanted_.start, {value}});
  if (change && change->place == throughout)
    pieces[static_cast<std::size_t>(change->input)].c[0] += change->size;
  if (change && change->place < all_places) {
    Segment& s = pieces[static_cast<std::size_t>(change->input)];
    for (int k = 0; k < all_places; ++k)
      s.c[k] += change->size * courses_(k, change->place) / std::pow(step_, k);
  }
  std::vector<Signal> u;
  for (const Segment& s : pieces) u.emplace_back(&s, 1, all_places - 1);
  if (subsystem_.advance(until, false, u, y).stop != Stop::limit)
    refuse(fmt::format("stops before {} s, at an event or its end", until));
}

Eigen::VectorXd Probe::wanted_of(std::span<const double> row) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(wanted_.values.size()));
  for (Eigen::Index k = 0; k < values.size(); ++k)
    values[k] = row[static_cast<std::size_t>(wanted_.values[static_cast<std::size_t>(k)])];
  return values;
}

/// What it gives at each; a change of its inputs is one at the first.
Eigen::MatrixXd Probe::instants(std::int64_t count, const Change* change) {
  constexpr double rounding = 1e-9;
  const Samples first = start(1, change);
  if (!change) before_ = wanted_of(first.values(0));
  std::vector<double> u = wanted_.inputs, row(static_cast<std::size_t>(subsystem_.info().output_size()));
  Eigen::MatrixXd values(static_cast<Eigen::Index>(wanted_.values.size()), count);
  double t = wanted_.start + step_;  // start() found how far away the first one is
  offset_ = step_;
  for (Eigen::Index k = 0; k < count; ++k) {
    const bool is_changed = change && (change->place == throughout || (change->place == 0 && k == 0));
    if (change)
      u[static_cast<std::size_t>(change->input)] =
          wanted_.inputs[static_cast<std::size_t>(change->input)] + (is_changed ? change->size : 0.0);
    const double next = subsystem_.sample(t, SamplePart::both, u, row).next_time;
    if (k > 0 && std::abs(next - t - step_) > rounding * step_)
      refuse("acts at instants that are not equally far apart");
    step_ = next - t, t = next;
    values.col(k) = wanted_of(row);
  }
  if (!values.allFinite()) refuse("gives values that are not finite");
  return values;
}

Eigen::Index Probe::states() {
  start(1, nullptr);
  const auto names = subsystem_.states();
  return names ? static_cast<Eigen::Index>(names->size()) : -1;
}

OneStep Probe::one_step(const Change* change, const Eigen::VectorXd& by) {
  Samples y = start(3, change);
  const auto size = static_cast<std::size_t>(by.size());
  OneStep all{by, wanted_of(y.values(0)), by, {}};
  subsystem_.get_states({all.x0.data(), size});
  if (!by.isZero(0.0)) subsystem_.set_states({(all.x0 += by).data(), size});
  advance(wanted_.start + 1.25 * step_, change, y);
  if (y.size() != 2) refuse("takes own steps that vary");
  subsystem_.get_states({all.x1.data(), size});
  all.y1 = wanted_of(y.values(1));
  return all;
}

Eigen::MatrixXd Probe::run(std::int64_t steps, const Change* change) {
  if (is_sampled()) return instants(steps + 1, change);
  Samples y = start(steps + 3, change);
  advance(wanted_.start + 1.25 * step_, change, y);
  advance(wanted_.start + (static_cast<double>(steps) + 0.25) * step_, nullptr, y);
  if (y.size() != steps + 1) refuse("takes own steps that vary");
  Eigen::MatrixXd values(static_cast<Eigen::Index>(wanted_.values.size()), steps + 1);
  for (Eigen::Index k = 0; k <= steps; ++k) values.col(k) = wanted_of(y.values(k));
  if (!values.allFinite()) refuse("gives values that are not finite");
  return values;
}

}  // namespace tandem::identification
