// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "metrics/two_mass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "two_mass/mode_fit.hpp"
#include "two_mass/model.hpp"

namespace tandem::two_mass {
namespace {

constexpr double fitted_cycles = 10.0;
constexpr double least_amplitude = 0.01;  // of C11, below which a phase has no meaning
constexpr double largest_residual =
    0.5;  // of the amplitude (fitted or C11), beyond which the fit has no meaning

int subsystem(const Topology& topology, const std::string& name) {
  std::vector<std::string> names;
  for (int i = 0; i < topology.size(); ++i) {
    if (topology.name(i) == name && topology.info(i).output_size() >= 2) return i;
    names.push_back(topology.name(i));
  }
  throw Error(ErrorCode::invalid_argument, unknown("subsystem", name, names));
}

class ExchangeEnergy final : public study::CodedMetric {
 public:
  ExchangeEnergy(const Topology& topology, const Settings& settings, const TimeSpan& span)
      : model_(settings),
        scale_(settings.frequency_ratio / (span.stop - span.start)),
        fast_(subsystem(topology, "fast")),
        slow_(subsystem(topology, "slow")),
        start_(model_.energy(model_.exact(span.start))) {}

  bool samples(int subsystem, const History& history, std::int64_t /*first*/, std::int64_t last) override {
    const auto y = history.values(last);
    if (subsystem == fast_) now_.x1 = y[0], now_.v1 = y[1];
    if (subsystem == slow_) now_.x2 = y[0], now_.v2 = y[1];
    return true;
  }
  void between_rounds() override {
    const double error = (model_.energy(now_) - start_) / start_;
    squares_ += error * error;
    ++rounds_;
  }
  std::optional<double> value(std::string& /*note*/, const text::TimeTable* /*reference*/) const override {
    if (rounds_ == 0) return {};
    return scale_ * std::sqrt(squares_ / static_cast<double>(rounds_));
  }

 private:
  Model model_;
  double scale_;
  int fast_, slow_;
  double start_, squares_ = 0.0;
  std::int64_t rounds_ = 0;
  Motion now_{};
};

enum class Of { amplitude, phase };

class FastMode final : public study::CodedMetric {
 public:
  /// name: the subsystem whose first output is x1.
  FastMode(const Topology& topology, const std::string& name, const Settings& settings, const TimeSpan& span,
           Of of)
      : model_(settings),
        of_(of),
        fast_(subsystem(topology, name)),
        from_(span.stop - fitted_cycles),
        enough_(from_ >= span.start),
        tolerance_(span.start),
        fit_(model_.omega1, model_.omega2, span.stop - 0.5 * fitted_cycles) {}

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t row = first; row <= last && subsystem == fast_; ++row)
      if (enough_ && !tolerance_.before(history.time(row), from_))
        fit_.add(history.time(row), history.values(row)[0]);
    return true;
  }

  std::optional<double> value(std::string& note, const text::TimeTable* reference) const override {
    if (!enough_)
      return note = "no fit of the fast mode: the run has fewer than ten fast cycles", std::nullopt;
    const ModeFit::Mode mode = fit_.solve();
    const double size = reference ? amplitude_of(*reference) : std::abs(model_.c11);
    if (mode.residual > largest_residual * std::max(mode.amplitude, size))
      return note = "no fit of the fast mode: the rest of x1 is above half of its amplitude", std::nullopt;
    if (of_ == Of::amplitude) return mode.amplitude / size - 1.0;
    if (mode.amplitude < least_amplitude * size)
      return note = "no phase: the fast mode is damped below 1 % of its amplitude", std::nullopt;
    const double lead = mode.phase - model_.phase1 - (model_.c11 < 0.0 ? std::numbers::pi : 0.0);
    return std::remainder(lead, 2.0 * std::numbers::pi);
  }

 private:
  /// Of the fast mode in the same time.
  double amplitude_of(const text::TimeTable& reference) const {
    ModeFit fit(model_.omega1, model_.omega2, from_ + 0.5 * fitted_cycles);
    for (std::size_t k = 0; k < reference.times.size(); ++k)
      if (!tolerance_.before(reference.times[k], from_)) fit.add(reference.times[k], reference.columns[0][k]);
    return fit.solve().amplitude;
  }

  Model model_;
  Of of_;
  int fast_;
  double from_;
  bool enough_;
  TimeTolerance tolerance_;
  ModeFit fit_;
};

std::function<std::unique_ptr<study::CodedMetric>(const Coordinator&, const TimeSpan&, Parameters&)>
fast_mode(Of of) {
  return [of](const Coordinator& run, const TimeSpan& span, Parameters& p) {
    const std::string name = p.text("subsystem", "fast");
    p.text("output", "");  // of a reference
    return std::make_unique<FastMode>(run.topology(), name, Settings::from(p), span, of);
  };
}

}  // namespace

void add_metrics(study::CodedMetrics& to) {
  to["two_mass.exchange_energy_error"] = [](const Coordinator& run, const TimeSpan& span, Parameters& p) {
    return std::make_unique<ExchangeEnergy>(run.topology(), Settings::from(p), span);
  };
  to["two_mass.amplitude_error"] = fast_mode(Of::amplitude);
  to["two_mass.phase_error"] = fast_mode(Of::phase);
}

}  // namespace tandem::two_mass
