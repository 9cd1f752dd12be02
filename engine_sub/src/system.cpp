// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/system.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "loop_solver.hpp"
#include "tandem/error.hpp"

namespace tandem::engine {
namespace {

/// A signal within so many tolerances of its loop counts as zero, which keeps its sign: the sign of an error
/// would decide otherwise, in a saturation say that a loop holds at its limit. To SUNDIALS it counts as zero
/// within twice as many, so that where SUNDIALS has found a change one is seen, though a loop is solved anew
/// there.
constexpr double within_errors = 10.0;

}  // namespace

double InputSource::begin_course(double) { return std::numeric_limits<double>::infinity(); }

System::System(const Program& program, InputSource* inputs)
    : program_(program), inputs_(inputs), image_(program.image), inputs_now_(program.inputs.size()) {
  for (const Loop& loop : program.loops) loops_.push_back(std::make_unique<LoopSolver>(program, loop));
}

System::~System() = default;

void System::react(const tandem_reaction* reaction) {
  reaction_ = reaction;
  reacting_ = reaction ? reaction->states : 0;
  if (reacting_ > program_.room())
    throw Error(ErrorCode::not_supported,
                "its inputs react by " + std::to_string(reacting_) + " states; allowed are up to " +
                    std::to_string(program_.room()) + ", six for each input or output");
  if (reaction) std::copy_n(reaction->begin, reacting_, image_.data() + program_.states);
  outputs_now_.resize(program_.outputs.size());
}

void System::read_reaction_rates(double* dz) {
  for (int k = 0; k < reaction_->terms; ++k) {
    const int output = reaction_->term[k].from - reacting_;
    if (output < 0) continue;
    const auto number = static_cast<std::size_t>(output);
    outputs_now_[number] = image_[static_cast<std::size_t>(program_.outputs[number])];
  }
  tandem_reaction_rates(reaction_, image_[static_cast<std::size_t>(program_.time)],
                        image_.data() + program_.states, outputs_now_.data(), dz);
}

/// To the bit.
bool System::inputs_change(double t) {
  inputs_->at(t, inputs_now_.data());
  const double* const before = image_.data() + program_.time + 1;
  return !std::equal(inputs_now_.begin(), inputs_now_.end(), before, [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  });
}

void System::run_with_loops(int first, int last) {
  for (const auto& solver : loops_) {
    const Loop& loop = solver->loop();
    if (loop.first < first || loop.first >= last) continue;
    program_.run(image_.data(), first, loop.first);
    solver->solve(image_.data());
    first = loop.last;
  }
  program_.run(image_.data(), first, last);
}

/// So many times what the tolerance of its loop leaves; 0 for one that follows from none.
double System::band(const Crossing& crossing, double times) const {
  if (crossing.loop < 0) return 0.0;
  const Loop& loop = program_.loops[static_cast<std::size_t>(crossing.loop)];
  double size = 1.0;
  for (const int cut : loop.cuts) size = std::max(size, std::abs(image_[static_cast<std::size_t>(cut)]));
  return times * loop.settings.tolerance * size;
}

double System::watched(int crossing) const {
  return image_[static_cast<std::size_t>(program_.crossings[static_cast<std::size_t>(crossing)].signal)];
}

double System::rate_error() const {
  double largest = 0.0;
  for (const Loop& loop : program_.loops) largest = std::max(largest, loop.settings.tolerance);
  return largest;
}

double System::watched_sign(int crossing) const {
  const Crossing& c = program_.crossings[static_cast<std::size_t>(crossing)];
  const double value = watched(crossing);
  if (std::abs(value) > band(c, 2.0 * within_errors)) return value;
  return smallest_sign * image_[static_cast<std::size_t>(c.sign)];
}

int System::changed(int first) const {
  for (auto k = static_cast<std::size_t>(first); k < program_.crossings.size(); ++k) {
    const Crossing& c = program_.crossings[k];
    const double value = image_[static_cast<std::size_t>(c.signal)];
    if (value * image_[static_cast<std::size_t>(c.sign)] < 0.0 && std::abs(value) > band(c, within_errors))
      return static_cast<int>(k);
  }
  return -1;
}

}  // namespace tandem::engine
