// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <set>

#include "checks.hpp"
#include "number_text.hpp"

namespace tandem::checks {
namespace {

void check_ports(const std::vector<Port>& ports, const std::string& what, int most_derivatives) {
  std::set<std::string> names;
  for (const Port& port : ports) {
    const std::string who = what + " '" + port.name + "'";
    require(!port.name.empty(), what + " without a name; allowed is a name");
    require(names.insert(port.name).second, who + " is there twice; allowed is a name of its own");
    require(port.size >= 1, who + " has the size " + std::to_string(port.size) + "; allowed is 1 or more");
    require(port.derivatives >= 0 && port.derivatives <= most_derivatives,
            who + " has " + std::to_string(port.derivatives) + " derivatives; allowed is 0 to " +
                std::to_string(most_derivatives));
  }
}

void make_sense(const Subject& of) {
  const auto subsystem = of.open();
  require(subsystem != nullptr, "there is no subsystem; allowed is one");
  const SubsystemInfo& info = subsystem->info();
  require(!info.name.empty(), "its name is empty; allowed is a name");
  check_ports(info.inputs, "input", 0);
  check_ports(info.outputs, "output", 3);
  for (const Feedthrough& f : info.feedthrough)
    require(f.output >= 0 && f.output < info.output_size() && f.input >= 0 && f.input < info.input_size(),
            "its feedthrough names output " + std::to_string(f.output) + " and input " +
                std::to_string(f.input) + "; allowed is below " + std::to_string(info.output_size()) +
                " and " + std::to_string(info.input_size()));
}

void stay(const Subject& of) {
  Instance it(of);
  const SubsystemInfo before = it.subsystem->info();
  it.advance(it.ahead(2.5));
  const SubsystemInfo& after = it.subsystem->info();
  require(after.name == before.name && after.row_size() == before.row_size() &&
              after.input_size() == before.input_size() &&
              after.feedthrough.size() == before.feedthrough.size(),
          "its name, ports or feedthrough are other ones after an advance; allowed is the same for ever");
}

void begin_with_one_sample(const Subject& of) {
  const Instance it(of);
  require(it.rows.size() == 1,
          "initialize appended " + std::to_string(it.rows.size()) + " samples; allowed is 1");
  require(it.rows[0][0] == of.settings.t_start, "its first sample is at t = " + number_text(it.rows[0][0]) +
                                                    " s; allowed is t_start, " +
                                                    number_text(of.settings.t_start));
  for (std::size_t k = 0; k < it.rows[0].size(); ++k)
    require(std::isfinite(it.rows[0][k]), "column " + std::to_string(k) + " of its first sample is " +
                                              number_text(it.rows[0][k]) + "; allowed is a finite number");
}

void stand_unknown_inputs(const Subject& of) {
  Instance it(of);
  const SubsystemInfo& info = it.subsystem->info();
  it.initialize(std::vector<double>(static_cast<std::size_t>(info.input_size()),
                                    std::numeric_limits<double>::quiet_NaN()));
  for (int k = 0; k < info.output_size(); ++k) {
    bool is_fed = false;
    for (const Feedthrough& f : info.feedthrough) is_fed = is_fed || f.output == k;
    const double value = it.rows[0][static_cast<std::size_t>(Samples::header + k)];
    require(is_fed || std::isfinite(value),
            "output " + scalar_at(info.outputs, k).name() +
                ", which its feedthrough says follows no input at once, is " + number_text(value) +
                " where the inputs are not known at the start; allowed is a finite number");
  }
}

void start_again_before(const Subject& of) {
  Instance it(of);
  const double end = it.ahead(7.5);
  it.initialize();
  it.initialize();
  it.advance(end);
  require_same(it.rows, in_one_call(of, end), "after initialize has been called three times");
}

void start_again_after(const Subject& of) {
  Instance it(of);
  if (!it.can().restarts) throw LeftOut("it does not say that it restarts");
  const double end = it.ahead(7.5);
  it.advance(end);
  it.initialize();
  it.advance(end);
  require_same(it.rows, in_one_call(of, end), "after an advance and initialize");
}

void be_dropped(const Subject& of) { require(of.open() != nullptr, "there is no subsystem; allowed is one"); }

}  // namespace

const std::vector<Check> starts = {
    {"its ports make sense", make_sense},
    {"its info is constant", stay},
    {"the start is one sample at t_start", begin_with_one_sample},
    {"what no unknown input feeds through to is finite at the start", stand_unknown_inputs},
    {"starting again before the first advance gives the same bits", start_again_before},
    {"starting again after an advance gives the same bits", start_again_after},
    {"an instance may be dropped before it is started", be_dropped}};

}  // namespace tandem::checks
