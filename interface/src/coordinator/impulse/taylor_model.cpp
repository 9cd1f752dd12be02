// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "taylor_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "tandem/error.hpp"

namespace tandem {
namespace {

/// Of the model's unit: errors of second derivatives by rounding and by curvature are alike then, some 1e-8.
constexpr double small_part = 1e-4;
constexpr int most_refinements =
    100;  // each leaves half of the part by which the mass changes in a slow step
constexpr double small_rest = 1e-12;

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
      rates_(n_),
      changed_(n_),
      pushes_(n_ * p_),
      one_(n_),
      other_(n_),
      wanted_(n_) {
  for (const double unit : of_->units()) steps_.push_back(small_part * unit);
  for (std::size_t k = 0; k < n_; ++k) steps_.push_back(steps_[k] / slow_step);
}

void TaylorModel::see_inputs(double t) {
  const std::span<const double> node(node_);
  of_->stand_at(t);
  of_->accelerations(node.first(n_), node.subspan(n_), changed_);
  for (std::size_t i = 0; i < n_; ++i) changed_[i] -= own_.value(i);
}

void TaylorModel::expand(double t, std::span<const double> q, std::span<const double> u) {
  of_->stand_at(t);
  for (std::size_t i = 0; i < n_; ++i) rates_[i] = first_ ? 0.0 : changed_[i] / (t - time_);
  first_ = false, time_ = t;
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
  ByteWriter to;
  of_->write(to);
  stands_.assign(to.bytes().begin(), to.bytes().end());
}

/// Other surrogates, and the same one in another state, may have used the equations since.
void TaylorModel::recall() {
  ByteReader from(stands_, "the equations of a slow side");
  of_->read(from);
}

void TaylorModel::accelerations(std::span<const double> z, std::span<const double> v,
                                std::span<const double> forces, double s, std::span<double> a) const {
  for (std::size_t i = 0; i < n_; ++i) off_[i] = z[i] - node_[i], off_[n_ + i] = v[i] - node_[n_ + i];
  own_.values(off_, a);
  pushed_.values(std::span(off_).first(n_), columns_);
  for (std::size_t i = 0; i < n_; ++i) a[i] += rates_[i] * s;
  for (std::size_t k = 0, e = 0; k < p_; ++k)
    for (std::size_t i = 0; i < n_; ++i, ++e) a[i] += columns_[e] * forces[k];
}

void TaylorModel::answer(std::span<const double> q, std::span<const double> forces, std::span<double> a) {
  recall();
  mean_answer(q, forces, a);
}

void TaylorModel::mean_answer(std::span<const double> q, std::span<const double> forces,
                              std::span<double> a) {
  of_->answer(q, forces, a), of_->answer(std::span(node_).first(n_), forces, other_);
  for (std::size_t i = 0; i < n_; ++i) a[i] = 0.5 * (a[i] + other_[i]);
}

void TaylorModel::forces_for(std::span<const double> q, std::span<const double> a, std::span<double> forces) {
  const auto size = [](std::span<const double> x) {
    return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
  };
  recall();
  std::fill(forces.begin(), forces.end(), 0.0), std::fill(one_.begin(), one_.end(), 0.0);
  for (int k = 0;; ++k) {
    for (std::size_t i = 0; i < n_; ++i) wanted_[i] = a[i] - one_[i];
    if (size(wanted_) <= small_rest * size(a)) return;
    if (k == most_refinements) break;
    of_->inertia(q, wanted_, one_);
    for (std::size_t i = 0; i < n_; ++i) forces[i] += one_[i];
    mean_answer(q, forces, one_);
  }
  throw Error(ErrorCode::numerical,
              "impulse coupling: the slow side's mass changes so much within its step that no force on its "
              "coordinates is found; allowed are shorter steps of it");
}

void TaylorModel::write(ByteWriter& to) const {
  to.put_doubles(node_), to.put_doubles(rates_), to.put(time_), to.put(std::uint8_t{first_});
  own_.write(to), pushed_.write(to);
  to.put(static_cast<std::uint64_t>(stands_.size()));
  for (const std::byte one : stands_) to.put(static_cast<std::uint8_t>(one));
}

void TaylorModel::read(ByteReader& from) {
  for (std::vector<double>* all : {&node_, &rates_})
    for (double& one : *all) one = from.take<double>();
  time_ = from.take<double>(), first_ = from.take<std::uint8_t>() != 0;
  own_.read(from), pushed_.read(from);
  from.take<std::uint64_t>();  // that of the same slow side, always
  for (std::byte& one : stands_) one = static_cast<std::byte>(from.take<std::uint8_t>());
}

}  // namespace tandem
