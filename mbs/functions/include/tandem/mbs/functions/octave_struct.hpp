// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tandem/error.hpp"
#include "tandem/mbs/functions/functions.hpp"

namespace tandem::mbs {

/// What Octave is told before anything else, commands as text: the function
///   [message, values] = tandem_evaluate (f, arguments...)
/// which gives the values of f as a full real matrix, or as a message why not.
extern const char* const octave_functions;

/// The functions of a struct in Octave, wherever that Octave is. The struct has the fields:
/// - `variables`: names, a cell array of n texts;
/// - `units`: of each (may be absent: "m");
/// - `q`, `v`: where it starts, n x 1 each;
/// - `mass`, `constraints`, ...: a function handle for each Term.
///
/// Arguments are () for mass, (t, q) for constraints, jacobian and constraint_rates, (t, q, v) for the
/// others. Throws Error with the name of the model, the field and the time for a field that is absent or not
/// known, and for a value of another shape.
class OctaveStruct : public Functions {
 public:
  const FunctionsInfo& info() const override { return info_; }
  void evaluate(Term term, double t, const double* q, const double* v, std::span<double> values) override;

 protected:
  explicit OctaveStruct(const std::string& name) { info_.name = name; }
  /// Comes last in the making of who is derived from it.
  void take_info();
  [[noreturn]] void refuse(const std::string& what, ErrorCode code = ErrorCode::invalid_argument) const;

  struct Values {
    int rows = 0, columns = 0;
    std::vector<double> numbers;  ///< by columns
  };
  virtual std::vector<std::string> fields() = 0;
  virtual std::vector<std::string> texts(const std::string& field) = 0;
  virtual void constant(const std::string& field, Values& values) = 0;
  /// `what` is for sentences; of the arguments those that the term has not are null.
  virtual void call(Term term, const std::string& what, double t, const double* q, const double* v,
                    Values& values) = 0;

 private:
  void take_fields();
  void take_variables();
  void take_start(const std::string& field, Eigen::VectorXd& vector);
  void check(const std::string& what, Shape allowed) const;

  FunctionsInfo info_;
  bool has_units_ = false;
  Values values_;
};

}  // namespace tandem::mbs
