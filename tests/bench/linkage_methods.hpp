// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "four_bar/course.hpp"
#include "simbody/linkage.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::bench {

struct LinkageMotion {
  const char* name;
  four_bar::Start start;
  double end;  ///< [s]
};

/// A way to run the linkage, more and more accurately.
struct LinkageMethod {
  std::string code, name;
  std::vector<double> settings;  ///< from coarse to fine: accuracies, or steps [s]
  /// With a setting; Simbody gives up after so many seconds of processor time.
  std::function<four_bar::Course(double setting, double patience)> run;
};

/// Those of Simbody and of tandem, for one motion of a linkage. Models are made here once, steppers and
/// integrators for each run, out of its measured time.
class LinkageMethods {
 public:
  LinkageMethods(const LinkageMotion& motion, int loops);
  LinkageMethods(const LinkageMethods&) = delete;
  LinkageMethods& operator=(const LinkageMethods&) = delete;

  const std::vector<LinkageMethod>& all() const { return all_; }

 private:
  /// Names are the constraint that closes the linkage and the integrator, and what is appended: "held", the
  /// constraints to 1e-10 m instead of a tenth of the accuracy; "fixed", steps of one length.
  void add_by_accuracy(const std::string& name, const simbody::Linkage& linkage);
  void add_by_steps(const std::string& name, const simbody::Linkage& linkage);
  void add_tandem(const std::string& name, const mbs::StepperSettings& settings);

  double end_;
  simbody::Linkage rod_, point_on_line_;
  mbs::Mechanism mechanism_;
  std::vector<LinkageMethod> all_;
};

}  // namespace tandem::bench
