// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "linearized.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"

namespace tandem::fmi {
namespace {

class Derivatives {
 public:
  explicit Derivatives(Instance& fmu)
      : fmu_(fmu), d_(fmu.fmu().description), ports_(fmu.fmu().ports), inputs_(ports_.info.input_size()) {
    for (const Unknown& rate : d_.derivatives) states_.push_back(d_.at(rate.variable).derivative_of);
    for (const Unknown& rate : d_.derivatives) add_unknown(rate.variable);
    for (const Seat& seat : ports_.row)
      if (seat.place < ports_.info.output_size()) add_unknown(seat.variable);
    column_.resize(static_cast<std::size_t>(d_.state_size() + ports_.info.output_size()));
  }

  bool are_known() const {
    const auto is_real = [this](const Seat& seat) { return d_.at(seat.variable).type == Type::float64; };
    return d_.model_exchange->gives_derivatives && ports_.discrete.empty() &&
           std::all_of(ports_.continuous.begin(), ports_.continuous.end(), is_real) &&
           std::all_of(ports_.row.begin(), ports_.row.end(), is_real);
  }

  Linearized all() {
    const auto n = static_cast<std::size_t>(d_.state_size()), m = static_cast<std::size_t>(inputs_),
               outputs = column_.size() - n;
    Linearized found{std::vector<double>(n * n), std::vector<double>(n * m), std::vector<double>(outputs * n),
                     std::vector<double>(outputs * m)};
    std::size_t k = 0;
    for (const int state : states_)
      for (int of = 0; of < d_.at(state).size; ++of) take(state, of, found.a, found.c, n, k++);
    for (const Seat& seat : ports_.continuous)
      for (int of = 0; of < seat.size; ++of)
        take(seat.variable, of, found.b, found.d, m, static_cast<std::size_t>(seat.place + of));
    return found;
  }

 private:
  void add_unknown(int variable) { unknowns_.push_back(d_.at(variable).reference); }

  /// Along one scalar of a variable, into column k of two matrices of so many columns.
  void take(int variable, int of, std::vector<double>& rates, std::vector<double>& outputs,
            std::size_t columns, std::size_t k) {
    const Variable& known = d_.at(variable);
    seed_.assign(static_cast<std::size_t>(known.size), 0.0);
    seed_[static_cast<std::size_t>(of)] = 1.0;
    fmu_.derive(unknowns_, {&known.reference, 1}, seed_, column_);
    if (!std::all_of(column_.begin(), column_.end(), [](double x) { return std::isfinite(x); }))
      throw Error(ErrorCode::numerical, "the FMU '" + d_.name + "' gives a directional derivative by '" +
                                            known.name + "' that is not finite");
    const auto n = static_cast<std::size_t>(d_.state_size());
    for (std::size_t row = 0; row < column_.size(); ++row)
      (row < n ? rates[row * columns + k] : outputs[(row - n) * columns + k]) = column_[row];
  }

  Instance& fmu_;
  const Description& d_;
  const Ports& ports_;
  int inputs_;
  std::vector<int> states_;
  std::vector<std::uint32_t> unknowns_;
  std::vector<double> seed_, column_;
};

}  // namespace

std::optional<Linearized> linearized(Instance& fmu) {
  Derivatives derivatives(fmu);
  if (!derivatives.are_known()) return {};
  return derivatives.all();
}

}  // namespace tandem::fmi
