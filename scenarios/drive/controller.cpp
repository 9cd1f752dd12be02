// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// controller.py in C++20, as a shared library: the speed controller of the drive, which samples.
//   at t_start + k T:   i_ref = kp e + s,   then   s becomes s + ki T e,   e = set - w
#include "sampled_library.hpp"
#include "tandem/c_table.hpp"
#include "tandem/sampled.hpp"

namespace {

class Controller {
 public:
  explicit Controller(tandem::Parameters& p)
      : kp_(needed(p, "kp")), ki_(needed(p, "ki")), set_(needed(p, "set")), period_(needed(p, "T")) {}

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

}  // namespace

extern "C" const tandem_subsystem_api* tandem_subsystem() { return tandem::c_table<make<Controller>>(); }
