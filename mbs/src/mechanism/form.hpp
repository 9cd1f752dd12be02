// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tandem/mbs/mechanism/numbering.hpp"

namespace tandem::mbs {

/// A linear function of the coordinates: a constant, and coefficients by coordinate.
struct Form {
  double constant = 0.0;
  std::vector<std::pair<int, double>> terms = {};

  void add(const Form& other, double factor);
};

/// A point or a direction, a form for each axis.
using Forms = std::vector<Form>;

Forms forms_of(const Description& in, const Numbering& at, int entity);
Forms forms_of(const Description& in, const Numbering& at, const Edge& edge);

/// Points and directions that move with a carrier, by its points and vectors, as linear forms: exact for a
/// rigid body, as its points are constant combinations of those that define it.
class Frame {
 public:
  Frame(const Description& in, const Numbering& at, const Carrier& carrier, std::string where);

  /// Of a place of the drawing. Throws Error if the carrier's points and vectors don't reach it.
  Forms point(const Eigen::Vector3d& at) const;
  Forms direction(const Eigen::Vector3d& along) const;

 private:
  Forms forms(const Eigen::Vector3d& at, bool is_point) const;
  Forms turned_pair(const Eigen::Vector3d& at, bool is_point) const;
  std::string name() const;

  const Description& in_;
  const Numbering& at_;
  Carrier carrier_;
  std::string where_;
  std::vector<int> entities_;
};

}  // namespace tandem::mbs
