// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "checks.hpp"
#include "number_text.hpp"

namespace tandem::checks {
namespace {

constexpr int instants = 100;

/// One sampled instance, driven instant by instant; each clock is checked. Its inputs are sines.
class Sampler {
 public:
  explicit Sampler(const Subject& of) : subsystem(of.open()) {
    const SubsystemInfo& info = subsystem->info();
    u_.assign(static_cast<std::size_t>(info.input_size()), 0.0);
    std::vector<double> row(static_cast<std::size_t>(info.row_size()));
    Samples first(row.data(), info.row_size(), 1);
    const std::vector<double> unknown(u_.size(), std::numeric_limits<double>::quiet_NaN());
    clock = subsystem->initialize(of.settings.t_start, of.settings.t_start + 1e6, unknown, first);
    require(
        first.size() == 1 && std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); }),
        "it does not give one finite sample at the start, where no input is known");
    require(clock.time == of.settings.t_start && clock.next_time >= clock.time,
            "its first instant is " + number_text(clock.next_time) + " s; allowed is the start, " +
                number_text(of.settings.t_start) + " s, or later");
    y.resize(static_cast<std::size_t>(info.output_size()));
  }

  void outputs(double shift = 0.0) { sample(SamplePart::outputs, shift); }
  void go_on(SamplePart part, double shift = 0.0) {
    const double t = clock.next_time, earliest = t + subsystem->info().sampling.period * (1.0 - 1e-9);
    clock = sample(part, shift);
    require(clock.time == t, "at its instant " + number_text(t) + " s it says that it stands at " +
                                 number_text(clock.time) + " s");
    require(clock.next_time >= earliest,
            "after " + number_text(t) + " s it gives " + number_text(clock.next_time) +
                " s as its next instant; allowed is a period of " +
                number_text(subsystem->info().sampling.period) + " s later, or more");
    if (part == SamplePart::both) rows.push_back(y);
  }

  std::unique_ptr<Subsystem> subsystem;
  Clock clock{};
  std::vector<double> y;
  Rows rows;

 private:
  Clock sample(SamplePart part, double shift) {
    for (std::size_t k = 0; k < u_.size(); ++k)
      u_[k] = std::sin(clock.next_time + static_cast<double>(k)) + shift;
    return subsystem->sample(clock.next_time, part, u_, y);
  }
  std::vector<double> u_;
};

bool is_sampled(const Subject& of) {
  const auto subsystem = of.open();
  return subsystem && subsystem->info().abilities.sampled;
}

Rows at_instants(const Subject& of) {
  Sampler it(of);
  for (int k = 0; k < instants; ++k) it.go_on(SamplePart::both);
  return it.rows;
}

void be_deterministic(const Subject& of) {
  if (is_sampled(of)) require_same(at_instants(of), at_instants(of), "in another instance");
}

void give_outputs_again(const Subject& of) {
  if (!is_sampled(of)) return;
  const Rows expected = at_instants(of);
  Sampler it(of);
  for (int k = 0; k < instants; ++k) {
    it.outputs(0.5);
    it.outputs();
    it.rows.push_back(it.y);
    it.go_on(SamplePart::states);
  }
  require_same(it.rows, expected, "with outputs that were asked for before with other inputs");
}

void declare_feedthrough(const Subject& of) {
  if (!is_sampled(of)) return;
  Sampler it(of);
  const SubsystemInfo& info = it.subsystem->info();
  for (int k = 0; k < 10; ++k) {
    it.outputs();
    const std::vector<double> before = it.y;
    it.outputs(0.5);
    for (int o = 0; o < info.output_size(); ++o) {
      const bool declared = std::any_of(info.feedthrough.begin(), info.feedthrough.end(),
                                        [o](const Feedthrough& f) { return f.output == o; });
      require(declared || before[static_cast<std::size_t>(o)] == it.y[static_cast<std::size_t>(o)],
              "output " + scalar_at(info.outputs, o).name() +
                  " follows an input at once, but no feedthrough says so");
    }
    it.go_on(SamplePart::both);
  }
}

void come_back(const Subject& of) {
  if (!is_sampled(of)) return;
  Sampler it(of);
  if (!it.subsystem->info().abilities.saves_state) return;
  for (int k = 0; k < 7; ++k) it.go_on(SamplePart::both);
  const StateId saved = it.subsystem->save_state();
  it.rows.clear();
  for (int k = 0; k < 7; ++k) it.go_on(SamplePart::both);
  const Rows expected = std::exchange(it.rows, {});
  it.clock = it.subsystem->restore_state(saved);
  for (int k = 0; k < 7; ++k) it.go_on(SamplePart::both);
  require_same(it.rows, expected, "after a state was restored");
}

}  // namespace

const std::vector<Check> samples = {
    {"two sampled instances give the same bits", be_deterministic},
    {"outputs of a sampled one may be asked for again", give_outputs_again},
    {"what a sampled one gives at once is declared", declare_feedthrough},
    {"a sampled one goes on from a saved state with the same bits", come_back}};

}  // namespace tandem::checks
