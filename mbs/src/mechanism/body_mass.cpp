// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/body_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../dense.hpp"
#include "refuse.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

[[noreturn]] void refuse_body(const Body& body, const std::string& what) {
  mbs::refuse(body.where, fmt::format("body '{}' {}", body.name, what));
}

/// Integral of x x^T dm about the centre. In the plane only the polar moment counts: it is shared out evenly.
MatrixXd second_moments(const Description& in, const Body& body) {
  if (in.dimension == 2) return 0.5 * body.inertia(2, 2) * MatrixXd::Identity(2, 2);
  return 0.5 * body.inertia.trace() * MatrixXd::Identity(3, 3) - body.inertia;
}

void check_mass(const Description& in, const Body& body) {
  if (!(body.mass > 0.0))
    refuse_body(body, fmt::format("has a mass of {} kg; allowed is above 0", body.mass));
  const VectorXd second = dense::symmetric_eigenvalues(second_moments(in, body));
  if (second[0] >= -1e-9 * std::abs(second.sum())) return;
  const VectorXd principal = in.dimension == 2 ? VectorXd(VectorXd::Constant(1, body.inertia(2, 2)))
                                               : dense::symmetric_eigenvalues(body.inertia);
  refuse_body(
      body,
      fmt::format("has an inertia tensor that no body has, with principal moments of {:.6g} kg m^2; allowed "
                  "is none below 0 and none above the sum of the others",
                  fmt::join(principal.data(), principal.data() + principal.size(), ", ")));
}

/// Integral of (1, x)(1, x)^T dm in the body's coordinates.
MatrixXd pseudo_inertia(const Description& in, const Body& body, const BodyCoordinates& at) {
  const int d = in.dimension;
  const VectorXd centre = at.point(body.centre);
  MatrixXd j = body.mass * centre * centre.transpose();
  j.bottomRightCorner(d, d) += second_moments(in, body) / at.size() / at.size();
  return j;
}

/// M = C x identity with J = B C B^T, B the entities in homogeneous coordinates.
void spanned(const Description& in, const Body& body, BodyMass& to) {
  const BodyCoordinates at(in, body);
  const auto d = static_cast<Eigen::Index>(in.dimension), k = static_cast<Eigen::Index>(to.entities.size());
  MatrixXd basis(d + 1, k);
  VectorXd factor(k);
  for (int e = 0; e < k; ++e) basis.col(e) = at.of(to.entities[e]), factor[e] = at.factor(to.entities[e]);
  const MatrixXd j = pseudo_inertia(in, body, at);
  const dense::Qr qr(basis);
  MatrixXd half = dense::solve(qr, j), c = dense::solve(qr, MatrixXd(half.transpose()));
  if (!((dense::reduced(c, basis.transpose()) - j).norm() <= at.rounding() * j.norm()))
    refuse_body(body,
                "has inertia off the line or plane of its points and vectors; give it one more of them");
  half = factor.cwiseInverse().asDiagonal() * half;
  c = (factor.cwiseInverse().asDiagonal() * c * factor.cwiseInverse().asDiagonal()).eval();
  to.mass.setZero(d * k, d * k);
  to.weight.setZero(d * k, d);
  for (int r = 0; r < k; ++r) {
    to.weight.block(d * r, 0, d, d) = half(r, 0) * MatrixXd::Identity(d, d);
    for (int s = 0; s < k; ++s) to.mass.block(d * r, d * s, d, d) = c(r, s) * MatrixXd::Identity(d, d);
  }
}

/// A point i and an edge u in the plane: r = r_i + w u with a complex w, so blocks are [re -im; im re]. With
/// a second point j in place of u: u = r_j - r_i.
void planar_pair(const Description& in, const Body& body, BodyMass& to) {
  const bool points = is_point(in, to.entities[1]);
  const Eigen::Vector2d i = in.entities[to.entities[0]].at.head(2),
                        u = drawn(in, {to.entities[1], points ? to.entities[0] : -1}).head(2),
                        across(-u[1], u[0]), centre = body.centre.head(2) - i;
  const double square = u.squaredNorm(), m = body.mass, re = m * centre.dot(u) / square,
               im = m * centre.dot(across) / square,
               polar = (body.inertia(2, 2) + m * centre.squaredNorm()) / square;
  Eigen::Matrix2d turn;
  turn << 0.0, -1.0, 1.0, 0.0;
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), cross = re * one + im * turn;
  to.mass.resize(4, 4);
  to.mass << m * one, cross, cross.transpose(), polar * one;
  to.weight.resize(4, 2);
  to.weight << m * one, cross.transpose();
  if (!points) return;
  Eigen::Matrix4d split = Eigen::Matrix4d::Identity();
  split.bottomLeftCorner(2, 2) = -one;
  to.mass = (split.transpose() * to.mass * split).eval();
  to.weight = (split.transpose() * to.weight).eval();
}

}  // namespace

BodyCoordinates::BodyCoordinates(const Description& in, const Body& body) : in_(in) {
  const auto first =
      std::find_if(body.entities.begin(), body.entities.end(), [&](int e) { return is_point(in, e); });
  if (first == body.entities.end()) refuse_body(body, "has no point");
  origin_ = in.entities[*first].at;
  double size = 0.0;
  for (const int e : body.entities)
    if (is_point(in, e)) size = std::max(size, (in.entities[e].at - origin_).stableNorm());
  measure(size > 0.0 ? size
                     : std::max((body.centre - origin_).stableNorm(),
                                std::sqrt(std::abs(second_moments(in, body).trace()) / body.mass)));
  if (!can_be_squared(size_))
    refuse_body(body, fmt::format("has a size of {} m; allowed is 1e-100 to 1e100 m", size_));
}

BodyCoordinates::BodyCoordinates(const Description& in, int point) : in_(in), origin_(in.entities[point].at) {
  measure(origin_.stableNorm());
}

void BodyCoordinates::measure(double size) {
  size_ = size > 0.0 ? size : 1.0;
  rounding_ = 1e-9 + 64.0 * std::numeric_limits<double>::epsilon() * origin_.stableNorm() / size_;
}

VectorXd BodyCoordinates::point(const Eigen::Vector3d& at) const {
  VectorXd h(in_.dimension + 1);
  h << 1.0, ((at - origin_) / size_).head(in_.dimension);
  return h;
}

VectorXd BodyCoordinates::direction(const Eigen::Vector3d& along) const {
  VectorXd h(in_.dimension + 1);
  h << 0.0, along.stableNormalized().head(in_.dimension);
  return h;
}

VectorXd BodyCoordinates::of(int entity) const {
  const Eigen::Vector3d& at = in_.entities[entity].at;
  return is_point(in_, entity) ? point(at) : direction(at);
}

double BodyCoordinates::factor(int entity) const {
  return is_point(in_, entity) ? 1.0 : in_.entities[entity].at.stableNorm() / size_;
}

std::vector<int> defining_entities(const Description& in, const Body& body) {
  std::vector<int> chosen, candidates = body.basis.empty() ? body.entities : body.basis;
  std::stable_partition(candidates.begin(), candidates.end(), [&](int e) { return is_point(in, e); });
  const BodyCoordinates at(in, body);
  MatrixXd basis(in.dimension + 1, 0);
  for (const int entity : candidates) {
    MatrixXd more(in.dimension + 1, basis.cols() + 1);
    more << basis, at.of(entity);
    dense::Qr qr(more);
    qr.setThreshold(at.rounding());
    if (qr.rank() < more.cols()) continue;
    basis = more;
    chosen.push_back(entity);
  }
  if (!body.basis.empty() && chosen.size() != body.basis.size())
    refuse_body(body,
                "has a basis of which one depends on the others; allowed are independent points and vectors");
  return chosen;
}

BodyMass body_mass(const Description& in, const Body& body) {
  check_mass(in, body);
  BodyMass result;
  result.entities = defining_entities(in, body);
  const bool two_points = in.dimension == 2 && result.entities.size() == 2;
  if (result.entities.size() < 2) refuse_body(body, "has no two points apart from each other");
  two_points ? planar_pair(in, body, result) : spanned(in, body, result);
  return result;
}

std::vector<ScalarProduct> rigid_conditions(const Description& in, const Body& body) {
  const auto defining = defining_entities(in, body);
  std::vector<Edge> edges;
  for (std::size_t k = 1; k < defining.size(); ++k)
    edges.push_back({defining[k], is_point(in, defining[k]) ? defining[0] : -1});
  const auto fixed = [&](const Edge& e) {
    return in.entities[e.to].fixed && (e.from < 0 || in.entities[e.from].fixed);
  };
  std::vector<ScalarProduct> conditions;
  for (auto a = edges.begin(); a != edges.end(); ++a)
    for (auto b = a; b != edges.end(); ++b)
      if (!fixed(*a) || !fixed(*b))
        conditions.push_back(
            {fmt::format("{}: {} . {}", body.name, in.entities[a->to].name, in.entities[b->to].name), *a, *b,
             drawn(in, *a).dot(drawn(in, *b)), body.where, "body"});
  return conditions;
}

}  // namespace tandem::mbs
