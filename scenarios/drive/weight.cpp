// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A load that comes on at one time, as a shared library: a sampled subsystem, whose output holds.
// Output load [N m]: 0, and from t_start + at on what the parameter says.
#include "tandem/c_table.hpp"
#include "tandem/sampled.hpp"

namespace {

constexpr tandem_parameter parameters[] = {{"load", "N m", nullptr, "that comes on"},
                                           {"at", "s", nullptr, "when, from the start on"}};

class Weight {
 public:
  explicit Weight(const tandem::ParameterValues& p) : load_(p.number("load")), at_(p.number("at")) {}

  tandem::SubsystemInfo info() const {
    return {"weight", {}, {{"load", "N m"}}, {}, {.serializes_state = true}};
  }
  double own_step() const { return 1.0; }  // after the first instant nothing changes
  double offset() const { return at_; }

  void start(double, std::span<const double>) { on_ = false; }
  void outputs(double* load) const { *load = on_ ? load_ : 0.0; }
  void outputs(double* load, std::span<const double>) const { *load = load_; }
  void step(const tandem::OwnStep&, std::span<const tandem::Signal>) { on_ = true; }

  void write(tandem::ByteWriter& to) const { to.put(on_); }
  void read(tandem::ByteReader& from) { on_ = from.take<bool>(); }

 private:
  double load_, at_;
  bool on_ = false;
};

std::unique_ptr<tandem::Subsystem> make(const tandem::ParameterValues& p) {
  return std::make_unique<tandem::Sampled<Weight>>(Weight(p));
}

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make, parameters>(); }
