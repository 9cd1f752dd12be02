// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/body_mass.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>

#include "refuse.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

[[noreturn]] void refuse(const Body& body, const std::string& what) {
  mbs::refuse(body.where, fmt::format("body '{}' {}", body.name, what));
}

bool is_point(const Description& in, int entity) { return in.entities[entity].kind == Entity::Kind::point; }

/// Integral of (1, x)(1, x)^T dm. In the plane only the polar moment counts: it is shared out evenly.
MatrixXd pseudo_inertia(const Description& in, const Body& body) {
  const int d = in.dimension;
  if (!(body.mass > 0.0)) refuse(body, fmt::format("has a mass of {} kg; allowed is above 0", body.mass));
  MatrixXd second = d == 3 ? MatrixXd(0.5 * body.inertia.trace() * MatrixXd::Identity(3, 3) - body.inertia)
                           : MatrixXd(0.5 * body.inertia(2, 2) * MatrixXd::Identity(2, 2));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(second);
  if (const double least = solver.eigenvalues()[0]; least < -1e-9 * std::abs(second.trace()))
    refuse(body, fmt::format("has an inertia tensor that no body has: a second moment is {} kg m^2", least));
  const VectorXd centre = body.centre.head(d);
  MatrixXd j(d + 1, d + 1);
  j(0, 0) = body.mass;
  j.block(1, 0, d, 1) = body.mass * centre;
  j.block(0, 1, 1, d) = body.mass * centre.transpose();
  j.block(1, 1, d, d) = second + body.mass * centre * centre.transpose();
  return j;
}

MatrixXd basis_of(const Description& in, const std::vector<int>& entities) {
  MatrixXd basis(in.dimension + 1, static_cast<Eigen::Index>(entities.size()));
  for (std::size_t k = 0; k < entities.size(); ++k)
    basis.col(static_cast<Eigen::Index>(k)) = homogeneous(in, entities[k]);
  return basis;
}

/// M = C x identity with J = B C B^T, B the entities in homogeneous coordinates.
void spanned(const Description& in, const Body& body, const MatrixXd& j, BodyMass& to) {
  const MatrixXd basis = basis_of(in, to.entities);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(basis);
  const MatrixXd half = qr.solve(j), c = qr.solve(half.transpose());
  const double off = (basis * c * basis.transpose() - j).norm();
  if (off > 1e-9 * j.norm())
    refuse(body, "has inertia off the line or plane of its points and vectors; give it one more of them");
  const int d = in.dimension, k = static_cast<int>(to.entities.size());
  to.mass.setZero(d * k, d * k);
  to.weight.setZero(d * k, d);
  for (int r = 0; r < k; ++r) {
    to.weight.block(d * r, 0, d, d) = half(r, 0) * MatrixXd::Identity(d, d);
    for (int s = 0; s < k; ++s) to.mass.block(d * r, d * s, d, d) = c(r, s) * MatrixXd::Identity(d, d);
  }
}

/// A point i and an edge u in the plane: r = r_i + w u with a complex w, so blocks are [re -im; im re]. With
/// a second point j in place of u: u = r_j - r_i.
void planar_pair(const Description& in, const Body& body, const MatrixXd& j, BodyMass& to) {
  const bool points = is_point(in, to.entities[1]);
  const Eigen::Vector2d i = in.entities[to.entities[0]].at.head(2),
                        u = drawn(in, {to.entities[1], points ? to.entities[0] : -1}).head(2),
                        across(-u[1], u[0]), centre = body.centre.head(2) - i;
  const double square = u.squaredNorm(), m = body.mass, re = m * centre.dot(u) / square,
               im = m * centre.dot(across) / square,
               moment = j(1, 1) + j(2, 2) - m * body.centre.head(2).squaredNorm(),
               polar = (moment + m * centre.squaredNorm()) / square;
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

VectorXd homogeneous(const Description& in, int entity) {
  const Entity& e = in.entities[entity];
  VectorXd h(in.dimension + 1);
  h[0] = e.kind == Entity::Kind::point ? 1.0 : 0.0;
  h.tail(in.dimension) = e.at.head(in.dimension);
  return h;
}

std::vector<int> defining_entities(const Description& in, const Body& body) {
  std::vector<int> chosen, candidates = body.entities;
  std::stable_partition(candidates.begin(), candidates.end(), [&](int e) { return is_point(in, e); });
  MatrixXd basis(in.dimension + 1, 0);
  for (const int entity : candidates) {
    MatrixXd more(in.dimension + 1, basis.cols() + 1);
    more << basis, homogeneous(in, entity);
    Eigen::ColPivHouseholderQR<MatrixXd> qr(more);
    qr.setThreshold(1e-9);
    if (qr.rank() < more.cols()) continue;
    basis = more;
    chosen.push_back(entity);
  }
  return chosen;
}

BodyMass body_mass(const Description& in, const Body& body) {
  const MatrixXd j = pseudo_inertia(in, body);
  BodyMass result;
  result.entities = defining_entities(in, body);
  const bool two_points = in.dimension == 2 && result.entities.size() == 2;
  if (result.entities.size() < 2) refuse(body, "has no two points apart from each other");
  two_points ? planar_pair(in, body, j, result) : spanned(in, body, j, result);
  return result;
}

std::vector<ScalarProduct> rigid_conditions(const Description& in, const Body& body) {
  const auto defining = defining_entities(in, body);
  if (defining.empty() || !is_point(in, defining[0])) refuse(body, "has no point");
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
