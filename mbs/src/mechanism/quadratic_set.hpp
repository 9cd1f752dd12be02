// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "constraint_set.hpp"
#include "form.hpp"

namespace tandem::mbs {

/// Model::off() of an equation.
using OffOf = std::function<Off(const double* q, double phi)>;

/// An equation of second degree in the coordinates, less an input:
///   constant + sum c q_i + sum c q_i q_j - u(t) = 0.
/// Every condition of natural coordinates is one, but for angles.
struct Quadratic {
  struct Linear {
    double c;
    int i;
  };
  struct Product {
    double c;
    int i, j;
  };
  std::string name;
  double constant = 0.0;
  std::vector<Linear> linear = {};
  std::vector<Product> products = {};
  int input = -1;
  double size = 0.0;  ///< as Structure::constraint_sizes; 0: nothing tells it
  std::string unit = "m", where = {};
  OffOf off = {};  ///< none: Phi itself is how far it is off

  void add(const Form& f, double factor);
  /// factor * a * b.
  void add_product(const Form& a, const Form& b, double factor);
  /// factor * the scalar product of two points or directions.
  void add_product(const Forms& a, const Forms& b, double factor);
};

class QuadraticSet final : public ConstraintSet {
 public:
  /// inputs: where the mechanism keeps them, in the order of the description; must outlive the set.
  explicit QuadraticSet(const std::vector<InputValue>& inputs) : inputs_(inputs) {}
  void add(const Quadratic& equation);

  int size() const override { return static_cast<int>(equations_.size()); }
  std::vector<int> coordinates(int equation) const override;
  void values(const double* q, double* phi, double* jacobian) const override;
  void rates(double* phi_t) const override;
  void accelerations(const double* q, const double* v, double* gamma) const override;
  Off off(int equation, const double* q, double phi) const override;

 private:
  struct Slope {
    double h;
    int j;
  };
  struct Entry {  ///< derivative by q_i: c + sum h q_j
    double c;
    int i, slopes_end;  ///< the second: into slopes_
  };
  struct Equation {
    double constant;
    int input, entries_end;  ///< the last: into entries_
  };
  const std::vector<InputValue>& inputs_;
  std::vector<Equation> equations_;
  std::vector<OffOf> offs_;  ///< by equation
  std::vector<Entry> entries_;
  std::vector<Slope> slopes_;
};

}  // namespace tandem::mbs
