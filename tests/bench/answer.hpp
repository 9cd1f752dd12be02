// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem::bench {

/// Of one advance: signals of degree 3 in, rows of as many outputs back.
struct Shape {
  int signals, samples;
};

/// Bytes of that advance on the wire.
struct Sizes {
  std::size_t request, reply;
};
Sizes sizes_of(const Shape& shape);

/// A subsystem that does nothing but answer: its own steps are 1 / samples s, its outputs 1. In this process,
/// and behind the table of functions that a shared library gives.
std::unique_ptr<Subsystem> answer(const Shape& shape);
std::unique_ptr<Subsystem> answer_by_table(const Shape& shape);

/// Advances a subsystem of that shape by 1 s, over and over.
class Asking {
 public:
  Asking(Subsystem& subsystem, const Shape& shape);
  void once();

 private:
  Subsystem& subsystem_;
  Shape shape_;
  std::vector<double> rows_;
  std::vector<Segment> segments_;
  std::vector<Signal> signals_;
  double time_ = 0.0;
};

}  // namespace tandem::bench
