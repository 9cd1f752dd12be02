// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "taylor_model.hpp"

#include <algorithm>
#include <utility>

namespace tandem {
namespace {

/// Of the model's unit: errors of second derivatives by rounding and by curvature are alike then, some 1e-8.
constexpr double small_part = 1e-4;
constexpr int refinements = 3;  // each takes the change of the mass within a slow step to its square

}  // namespace

TaylorModel::TaylorModel(std::shared_ptr<SlowModel> of, double slow_step)
    : of_(std::move(of)),
      n_(of_->coordinates().size()),
      p_(static_cast<std::size_t>(of_->links())),
      own_(2 * n_, n_),
      pushed_(n_, n_ * p_),
      node_(2 * n_),
      off_(2 * n_),
      columns_(n_ * p_),
      pushes_(n_ * p_),
      one_(n_),
      other_(n_),
      wanted_(n_) {
  for (const double unit : of_->units()) steps_.push_back(small_part * unit);
  for (std::size_t k = 0; k < n_; ++k) steps_.push_back(steps_[k] / slow_step);
}

void TaylorModel::expand(double t, std::span<const double> q, std::span<const double> u) {
  of_->stand_at(t);
  std::copy(q.begin(), q.end(), node_.begin());
  std::copy(u.begin(), u.end(), node_.begin() + static_cast<std::ptrdiff_t>(n_));
  own_.expand(node_, steps_, [&](std::span<const double> x, std::span<double> a) {
    of_->accelerations(x.first(n_), x.subspan(n_), a);
  });
  pushed_.expand(std::span(node_).first(n_), std::span(steps_).first(n_),
                 [&](std::span<const double> x, std::span<double> columns) {
                   of_->pushes(x, pushes_);
                   for (std::size_t k = 0; k < p_; ++k)
                     of_->answer(x, std::span(pushes_).subspan(k * n_, n_), columns.subspan(k * n_, n_));
                 });
}

void TaylorModel::accelerations(std::span<const double> z, std::span<const double> v,
                                std::span<const double> forces, std::span<double> a) const {
  for (std::size_t i = 0; i < n_; ++i) off_[i] = z[i] - node_[i], off_[n_ + i] = v[i] - node_[n_ + i];
  own_.values(off_, a);
  pushed_.values(std::span(off_).first(n_), columns_);
  for (std::size_t k = 0, e = 0; k < p_; ++k)
    for (std::size_t i = 0; i < n_; ++i, ++e) a[i] += columns_[e] * forces[k];
}

void TaylorModel::answer(std::span<const double> q, std::span<const double> forces, std::span<double> a) {
  of_->answer(q, forces, a), of_->answer(std::span(node_).first(n_), forces, other_);
  for (std::size_t i = 0; i < n_; ++i) a[i] = 0.5 * (a[i] + other_[i]);
}

void TaylorModel::forces_for(std::span<const double> q, std::span<const double> a, std::span<double> forces) {
  std::fill(forces.begin(), forces.end(), 0.0), std::fill(one_.begin(), one_.end(), 0.0);
  for (int k = 0; k <= refinements; ++k) {
    for (std::size_t i = 0; i < n_; ++i) wanted_[i] = a[i] - one_[i];
    of_->inertia(q, wanted_, one_);
    for (std::size_t i = 0; i < n_; ++i) forces[i] += one_[i];
    answer(q, forces, one_);
  }
}

}  // namespace tandem
