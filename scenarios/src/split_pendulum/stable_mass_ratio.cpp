// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "split_pendulum/coupling.hpp"
#include "split_pendulum/experiment.hpp"

namespace tandem::split_pendulum {
namespace {

constexpr double step = 1e-3, last_time = 1.0, amplitude = 0.2, square_frequency = 40.0;
constexpr double least = 1e-3, most = 10.0, precision = 1.01;

/// Ends the run where x leaves its exact motion by half its amplitude.
class Leaving final : public Observer {
 public:
  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override {
    for (std::int64_t k = first; k <= last && subsystem == 0; ++k) {
      const double exact = 1.0 + amplitude * std::cos(std::sqrt(square_frequency) * history.time(k));
      left_ = left_ || std::abs(history.values(k)[0] - exact) > 0.5 * amplitude;
    }
    return !left_;
  }
  bool left() const { return left_; }

 private:
  bool left_ = false;
};

bool stable(const Scheme& s, double mass) {
  const std::string taker = fmt::format(
      "dimension = 2\n[points]\nO = {{ at = [0, 0], fixed = true }}\nA = {{ at = [{}, 0] }}\n"
      "[masses]\nM = {{ point = \"A\", mass = 1 }}\n[inputs]\nF = {{ unit = \"N\" }}\n"
      "[springs]\ns = {{ points = [\"O\", \"A\"], stiffness = {}, free = 1 }}\n"
      "[forces]\nf = {{ point = \"A\", direction = [1, 0], magnitude = \"F\" }}\n"
      "[outputs]\nx = {{ position = \"A.x\" }}\n",
      1.0 + amplitude, square_frequency * (1.0 + mass));
  const std::string giver = fmt::format(
      "dimension = 2\n[points]\nA = {{ at = [{0}, 0] }}\n[masses]\nm = {{ point = \"A\", mass = {1} }}\n"
      "[inputs]\nx = {{ unit = \"m\", value = {0} }}\n[drives]\nx = {{ coordinate = \"A.x\", motion = \"x\" "
      "}}\n"
      "[outputs]\nR = {{ reaction = \"x\" }}\n",
      1.0 + amplitude, mass);
  const double small = step / s.ratio;
  const bool giver_fast = s.fast == "lower";
  const Coupling pair{
      {{"taker", taker, giver_fast ? step : small}, {"giver", giver, giver_fast ? small : step}},
      {{"taker.x", "giver.x", Reconstruction::parse(s.to_lower)},
       {.from = "giver.R",
        .to = "taker.F",
        .how = Reconstruction::parse(s.to_upper),
        .gain = -1.0,
        .lag = s.lag}},
      s.formulation,
      s.schedule,
      last_time};
  Leaving leaving;
  return run(pair, leaving).empty() && !leaving.left();
}

}  // namespace

double stable_mass_ratio(const Scheme& scheme) {
  if (!stable(scheme, least)) return 0.0;
  if (stable(scheme, most)) return std::numeric_limits<double>::infinity();
  double low = least, high = most;
  while (high > precision * low) {
    const double middle = std::sqrt(low * high);
    (stable(scheme, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace tandem::split_pendulum
