// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A PI controller that samples, in C++20, as a shared library: tandem/sampled.hpp does the instants and saved
// states.
//   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
// Input y [m]; output u [N], which holds.
#include "tandem/c_table.hpp"
#include "tandem/sampled.hpp"

namespace {

constexpr tandem_parameter parameters[] = {
    {"kp", "N/m", nullptr, "proportional gain"},
    {"ki", "N/(m s)", nullptr, "integral gain"},
    {"r", "m", nullptr, "what y is to be"},
    {"T", "s", nullptr, "period"},
    {"offset", "s", nullptr, "of the first instant"},
    {"latency", "s", nullptr, "by which u changes later than the instant"}};

class Pi {
 public:
  explicit Pi(const tandem::ParameterValues& p)
      : kp_(p.number("kp")),
        ki_(p.number("ki")),
        r_(p.number("r")),
        period_(p.number("T")),
        offset_(p.number("offset")),
        latency_(p.number("latency")) {}

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
  double kp_, ki_, r_, period_, offset_, latency_;
  double s_ = 0.0;
};

std::unique_ptr<tandem::Subsystem> make(const tandem::ParameterValues& p) {
  return std::make_unique<tandem::Sampled<Pi>>(Pi(p));
}

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make, parameters>(); }
