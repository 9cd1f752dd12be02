// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Impulse coupling with a sampled member beside the fast side.
#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"
#include "tandem/charts/csv_table.hpp"

namespace tandem::test {
namespace {

const char* const fast_mass = R"toml(
name = "fast"
[parameters]
m1 = { value = 1, unit = "kg" }
k1 = { value = 1, unit = "N/m" }
[inputs]
x2 = { unit = "m" }
u = { unit = "N" }
[outputs]
x1 = { unit = "m" }
v1 = { unit = "m/s" }
F = { unit = "N" }
[blocks]
gap = { kind = "sum", inputs = ["x1", "x2"], gains = [1, -1] }
F = { kind = "gain", input = "gap", gain = 1 }
a1 = { kind = "sum", inputs = ["F", "x1", "u"], gains = ["$(-1/m1)", "$(-k1/m1)", "$(1/m1)"] }
v1 = { kind = "integrator", input = "a1", initial = 0 }
x1 = { kind = "integrator", input = "v1", initial = 11 }
[run]
step = 0.01
)toml";

const char* const brake = R"toml(
name = "brake"
[inputs]
v = { unit = "m/s" }
[blocks]
seen = { kind = "sample", input = "v", period = 0.07, initial = "v" }
u = { kind = "gain", input = "seen", gain = -0.0002 }
[outputs]
u = { unit = "N", from = "u" }
)toml";

const char* const braked = R"toml(
name = "s"
[constants]
w1 = 6.283185307179586
ratio = 60.0
per_cycle = 100
[subsystems.fast]
source = "diagram:fast.toml"
parameters = { m1 = "$(1.01/(w1^2*(1-1/ratio^2)))", k1 = "$(1.01/(ratio^2-1))" }
[subsystems.slow]
source = "builtin:two_mass.slow_force"
parameters = { frequency_ratio = "$ratio", steps_per_cycle = "$per_cycle" }
[subsystems.brake]
source = "diagram:brake.toml"
[[connections]]
from = "fast.F"
to = "slow.F"
reconstruction = "lagrange3"
[[connections]]
from = "slow.x2"
to = "fast.x2"
reconstruction = "hermite"
[[connections]]
from = "fast.v1"
to = "brake.v"
reconstruction = "hermite"
[[connections]]
from = "brake.u"
to = "fast.u"
[[links]]
effort = "fast.F"
displacement = "slow.x2"
[coordination]
coupling = "impulse"
[span]
stop = 60.0
)toml";

class ImpulseBesideSamples : public testing::Test {
 protected:
  ImpulseBesideSamples() {
    folder_.write("fast.toml", fast_mass), folder_.write("brake.toml", brake),
        folder_.write("s.toml", braked);
  }
  /// The fast mass at every 0.01 s.
  std::vector<double> x1(const std::vector<std::string>& settings) {
    std::vector<std::string> words = {"run", "s.toml", "--output", "o", "--set", "record.every=0.01"};
    for (const std::string& one : settings) words.insert(words.end(), {"--set", one});
    const Said said = tandem(folder_, words);
    EXPECT_EQ(said.status, 0) << said.err;
    const auto table = charts::CsvTable::read(folder_.path() / "o/results.csv", {"time", "fast.x1"});
    std::vector<double> all;
    for (std::size_t k = 0; k < table.size(); ++k)
      if (k == 0 || table[k].number("time") > table[k - 1].number("time"))  // the force may jump there
        all.push_back(table[k].number("fast.x1"));
    return all;
  }
  Scratch folder_;
};

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most / 11.0;  // where it starts
}

/// A brake that samples every 0.07 s takes a fifth of the fast motion within 60 cycles. Beside samples with slow steps of
/// 2.5 ms, which are right to 2e-5 of the peak.
TEST_F(ImpulseBesideSamples, ABrakeThatSamplesTheFastSideIsFollowed) {
  const auto right = x1(
      {"coordination.coupling=signals", "coordination.schedule=fastest-first", "constants.per_cycle=24000"});
  EXPECT_LT(apart(x1({}), right), 0.0025);
  EXPECT_GT(apart(x1({"connections[brake.v].gain=0"}), right), 0.01) << "the brake tells";
}

}  // namespace
}  // namespace tandem::test
