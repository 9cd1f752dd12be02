// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A PI controller that samples, in C++20, as a shared library: tandem/sampled.hpp does the instants and saved
// states.
//   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
// Input y [m]; output u [N], which holds. Parameters, each of them needed: kp [N/m], ki [N/(m s)], r [m], T
// [s], the offset of the first instant [s], and the latency [s], by which u changes later than the instant.
#include "tandem/c_table.hpp"
#include "tandem/sampled.hpp"
#include "tandem/transports/parameters.hpp"

namespace {

class Pi {
 public:
  explicit Pi(tandem::Parameters& p)
      : kp_(needed(p, "kp")),
        ki_(needed(p, "ki")),
        r_(needed(p, "r")),
        period_(needed(p, "T")),
        offset_(needed(p, "offset")),
        latency_(needed(p, "latency")) {}

  tandem::SubsystemInfo info() const {
    return {"pi", {{"y", "m"}}, {{"u", "N"}}, {{0, 0}}, {.serializes_state = true}};
  }
  double own_step() const { return period_; }
  double offset() const { return offset_; }
  double latency() const { return latency_; }

  void start(double, std::span<const double>) { s_ = 0.0; }
  void outputs(double* u) const { *u = s_; }  // before the first instant
  void outputs(double* u, std::span<const double> y) const { *u = kp_ * (r_ - y[0]) + s_; }
  void step(const tandem::OwnStep& own, std::span<const tandem::Signal> y) {
    s_ += ki_ * period_ * (r_ - y[0].value(own.begin));
  }

  void write(tandem::ByteWriter& to) const { to.put(s_); }
  void read(tandem::ByteReader& from) { s_ = from.take<double>(); }

 private:
  static double needed(tandem::Parameters& p, const char* name) {
    if (!p.has(name))
      throw tandem::Error(tandem::ErrorCode::invalid_argument,
                          std::string("pi: the parameter '") + name + "' is needed");
    return p.number(name, 0.0);
  }

  double kp_, ki_, r_, period_, offset_, latency_;
  double s_ = 0.0;
};

std::unique_ptr<tandem::Subsystem> make(const std::string& text) {
  tandem::Parameters parameters;
  if (!text.empty()) parameters.read(text, "pi");
  auto subsystem = std::make_unique<tandem::Sampled<Pi>>(Pi(parameters));
  parameters.refuse_unused("pi");
  return subsystem;
}

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make>(); }
