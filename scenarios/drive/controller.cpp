// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// controller.py in C++20, as a shared library: the speed controller of the drive, which samples.
//   at t_start + k T:   i_ref = kp e + s,   then   s becomes s + ki T e,   e = set - w
#include "tandem/c_table.hpp"
#include "tandem/sampled.hpp"

namespace {

constexpr tandem_parameter parameters[] = {{"kp", "A s/rad", nullptr, "proportional gain"},
                                           {"ki", "A/rad", nullptr, "integral gain"},
                                           {"set", "rad/s", nullptr, "speed that is wanted"},
                                           {"T", "s", nullptr, "period"}};

class Controller {
 public:
  explicit Controller(const tandem::ParameterValues& p)
      : kp_(p.number("kp")), ki_(p.number("ki")), set_(p.number("set")), period_(p.number("T")) {}

  tandem::SubsystemInfo info() const {
    return {"controller", {{"w", "rad/s"}}, {{"i_ref", "A"}}, {{0, 0}}, {.serializes_state = true}};
  }
  double own_step() const { return period_; }

  void start(double, std::span<const double>) { s_ = 0.0; }
  void outputs(double* i_ref) const { *i_ref = s_; }
  void outputs(double* i_ref, std::span<const double> w) const { *i_ref = kp_ * (set_ - w[0]) + s_; }
  void step(const tandem::OwnStep& own, std::span<const tandem::Signal> w) {
    s_ += ki_ * period_ * (set_ - w[0].value(own.begin));
  }

  void write(tandem::ByteWriter& to) const { to.put(s_); }
  void read(tandem::ByteReader& from) { s_ = from.take<double>(); }

 private:
  double kp_, ki_, set_, period_;
  double s_ = 0.0;
};

std::unique_ptr<tandem::Subsystem> make(const tandem::ParameterValues& p) {
  return std::make_unique<tandem::Sampled<Controller>>(Controller(p));
}

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make, parameters>(); }
