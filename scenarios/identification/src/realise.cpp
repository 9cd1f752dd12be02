// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "realise.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <complex>

#include "tandem/identification/identify.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Each response of size 1, and each value of the same size in all of them together.
struct Scaled {
  Responses responses;
  VectorXd of_values, of_responses;  ///< what each was multiplied with
};

Scaled scaled(Responses all) {
  Scaled result{std::move(all), VectorXd::Zero(0), VectorXd(0)};
  auto& list = result.responses;
  VectorXd squares = VectorXd::Zero(list.front().rows());
  for (MatrixXd& one : list) squares += one.rowwise().squaredNorm() / one.squaredNorm();
  result.of_values = squares.unaryExpr([](double s) { return s > 0.0 ? 1.0 / std::sqrt(s) : 0.0; });
  result.of_responses.resize(static_cast<Index>(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) {
    list[k] = result.of_values.asDiagonal() * list[k];
    list[k] *= result.of_responses[static_cast<Index>(k)] = 1.0 / list[k].norm();
  }
  return result;
}

/// Block (i, l) holds what all responses are at the place i s + l s + offset, from 0.
MatrixXd hankel(const Responses& all, Index blocks, Index stride, Index offset) {
  const Index values = all.front().rows(), count = static_cast<Index>(all.size());
  MatrixXd h(blocks * values, blocks * count);
  for (Index i = 0; i < blocks; ++i)
    for (Index l = 0; l < blocks; ++l)
      for (Index k = 0; k < count; ++k)
        h.block(i * values, l * count + k, values, 1) =
            all[static_cast<std::size_t>(k)].col((i + l) * stride + offset);
  return h;
}

/// All responses step by step, for comparison.
class Together {
 public:
  Together(const Responses& all, const MatrixXd& besides)
      : count_(static_cast<Index>(all.size())), steps_(all.front().cols()) {
    constexpr double rounding = 1e-10;
    const Index values = all.front().rows();
    at_.resize(values, count_ * steps_), size_.resize(values, count_);
    for (Index k = 0; k < count_; ++k) {
      const MatrixXd& one = all[static_cast<std::size_t>(k)];
      size_.col(k) = one.cwiseAbs().rowwise().maxCoeff().cwiseMax(rounding * one.cwiseAbs().maxCoeff());
      if (besides.size() > 0) size_.col(k) = size_.col(k).cwiseMax(besides.col(k).cwiseAbs());
      for (Index step = 0; step < steps_; ++step) at_.col(step * count_ + k) = one.col(step);
    }
  }

  double residual(const Realisation& of) const {
    MatrixXd x = of.x1, next = x, y = size_;
    Eigen::ArrayXXd most = Eigen::ArrayXXd::Zero(size_.rows(), count_);
    for (Index step = 0; step < steps_; ++step) {
      y.noalias() = of.c.lazyProduct(x);
      y -= at_.middleCols(step * count_, count_);
      most = most.max(y.array().abs());
      next.noalias() = of.a.lazyProduct(x);
      x.swap(next);
    }
    const double worst = (most / size_.array()).maxCoeff();
    return x.allFinite() && std::isfinite(worst) ? worst : 1e300;
  }

 private:
  Index count_, steps_;
  MatrixXd at_, size_;  ///< a step's columns after those of the one before
};

class Realiser {
 public:
  explicit Realiser(const Responses& all) : all_(all), together_(all, {}) {
    const Index length = all.front().cols();
    constexpr Index most_blocks = 24;
    const Index blocks = std::min(most_blocks, length / 2),
                stride = std::max<Index>(1, (length - 2) / (2 * blocks - 2));
    const MatrixXd here = hankel(all, blocks, stride, 0);
    later_ = hankel(all, blocks, stride, 1);
    const Eigen::BDCSVD<MatrixXd> svd(here, Eigen::ComputeThinU | Eigen::ComputeThinV);
    u_ = svd.matrixU(), v_ = svd.matrixV(), s_ = svd.singularValues();
  }

  /// Beyond it nothing but rounding is left, or what is allowed.
  Index most() const {
    constexpr double rounding = 1e-15;
    const Index known = (s_.array() > rounding * s_[0]).count();
    return std::min<Index>(known, most_states);
  }

  Realisation of_order(Index n) const {
    const VectorXd root = s_.head(n).cwiseSqrt(), inverse = root.cwiseInverse();
    const MatrixXd u = u_.leftCols(n), v = v_.leftCols(n);
    Realisation r;
    r.a = inverse.asDiagonal() * (u.transpose() * later_ * v) * inverse.asDiagonal();
    r.c = u.topRows(all_.front().rows()) * root.asDiagonal();
    r.x1 = root.asDiagonal() * v.topRows(static_cast<Index>(all_.size())).transpose();
    r.residual = together_.residual(r);
    return r;
  }

 private:
  const Responses& all_;
  const Together together_;
  MatrixXd later_, u_, v_;
  VectorXd s_;
};

constexpr double worse = 1.5;    ///< times the least residual is nearly as good
constexpr double enough = 1e-8;  ///< for what models are used for

/// Two more states, of a mode say, made nothing better.
bool is_settled(const std::vector<Realisation>& found) {
  if (found.size() < 3) return false;
  const Realisation& best = *(found.end() - 3);
  const auto is_no_better = [&](const Realisation& one) { return worse * one.residual >= best.residual; };
  return best.residual <= enough && std::all_of(found.end() - 2, found.end(), is_no_better) &&
         can_be_cut(best.a);
}

/// The smallest order that is nearly as good as the best. If a step of it can't be cut, states that only follow rounding may
/// be to blame: then one of those that can, where it is good enough for what models are used for.
const Realisation& chosen(const std::vector<Realisation>& found) {
  constexpr double exact = 1e-11;
  const auto less = [](const auto& a, const auto& b) { return a.residual < b.residual; };
  const double least = std::min_element(found.begin(), found.end(), less)->residual;
  const auto best = std::find_if(found.begin(), found.end(), [&](const auto& one) {
    return one.residual <= std::max(exact, worse * least);
  });
  if (can_be_cut(best->a)) return *best;
  const auto other = std::find_if(found.begin(), found.end(), [&](const auto& one) {
    return one.residual <= enough && can_be_cut(one.a);
  });
  return other == found.end() ? *best : *other;
}

}  // namespace

double residual(const Realisation& of, const Responses& responses, const MatrixXd& besides) {
  return Together(responses, besides).residual(of);
}

bool can_be_cut(const Eigen::MatrixXd& a) {
  const auto values = Eigen::VectorXcd(a.eigenvalues());
  return std::none_of(values.begin(), values.end(), [](const std::complex<double>& value) {
    constexpr double nothing = 1e-8;
    return std::abs(value) < nothing ||
           (value.real() < 0.0 && std::abs(value.imag()) < nothing * std::abs(value));
  });
}

Realisation realise(const Responses& responses) {
  constexpr double exact = 1e-11;
  const Scaled all = scaled(responses);
  const Realiser realiser(all.responses);
  std::vector<Realisation> found;
  for (Index n = 1; n <= realiser.most(); ++n) {
    found.push_back(realiser.of_order(n));
    if (found.back().residual <= exact || is_settled(found)) break;
  }
  Realisation best = chosen(found);
  best.c = all.of_values.unaryExpr([](double f) { return f > 0.0 ? 1.0 / f : 0.0; }).asDiagonal() * best.c;
  best.x1 = best.x1 * all.of_responses.cwiseInverse().asDiagonal();
  return best;
}

}  // namespace tandem::identification
