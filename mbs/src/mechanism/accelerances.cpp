// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "accelerances.hpp"

#include "tandem/mbs/mechanism/push.hpp"

namespace tandem::mbs {

using Eigen::VectorXd;

Accelerances::Accelerances(const Mechanism& mechanism, const std::vector<Output>& outputs)
    : mechanism_(mechanism), solver_(mechanism) {
  for (const Output& o : outputs) {
    places_.push_back(all_.size());
    if (o.kind == Output::Kind::accelerance)
      all_.push_back({mechanism.numbering().of(o.coordinate), o.input});
  }
  for (auto* one : {&values_, &rates_, &after_}) one->resize(all_.size());
}

void Accelerances::find(const State& s) {
  if (!all_.empty()) find(s.q, values_);
}

/// Over a millionth of the mechanism's unit on either side: of parts as large errors by curvature of 1e-12, by rounding of
/// 1e-9.
void Accelerances::find_rates(const State& s) {
  const double speed = all_.empty() ? 0.0 : s.v.lpNorm<Eigen::Infinity>();
  std::fill(rates_.begin(), rates_.end(), 0.0);
  if (!(speed > 0.0)) return;
  const double by = 1e-6 * mechanism_.structure().unit() / speed;
  find(s.q + by * s.v, after_), find(s.q - by * s.v, rates_);
  for (std::size_t k = 0; k < all_.size(); ++k) rates_[k] = (after_[k] - rates_[k]) / (2.0 * by);
}

void Accelerances::find(const VectorXd& q, std::vector<double>& to) {
  solver_.stand_at(q);
  for (std::size_t k = 0; k < all_.size(); ++k)
    to[k] = all_[k].coordinate < mechanism_.structure().variables
                ? solver_.of(push_of(mechanism_, all_[k].input, q))[all_[k].coordinate]
                : 0.0;
}

}  // namespace tandem::mbs
