// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "check.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "refuse.hpp"

namespace tandem::mbs {
namespace {

/// Which points and vectors hang together: sets that are joined (union-find), the ground the last of them.
class Islands {
 public:
  explicit Islands(const Description& in) : in_(in), parent_(in.entities.size() + 1) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (int e = 0; e < ground(); ++e)
      if (in.entities[e].fixed) join(e, ground());
  }
  int ground() const { return static_cast<int>(parent_.size()) - 1; }
  int find(int e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }
  void join(int a, int b) {
    if (a >= 0 && b >= 0) parent_[find(a)] = find(b);
  }
  void join(const Edge& a, const Edge& b) {
    join(a.to, a.from);
    join(a.to, b.to);
    join(b.to, b.from);
  }
  void join_all() {
    for (const Body& body : in_.bodies)
      for (const int e : body.entities) join(body.entities[0], e);
    for (const ScalarProduct& p : in_.products) join(p.a, p.b);
    for (const FixedAngle& a : in_.fixed_angles) join(a.a, a.b);
    for (const Joint& j : in_.joints) join(of(j.first), of(j.second));
    for (const Relative& r : in_.relatives) join(r.a, r.b);
    for (const Spring& s : in_.springs)
      if (s.relative < 0) join(s.points, s.points);
    for (const Force& f : in_.forces)
      if (f.kind == Force::Kind::line) join(f.points, f.points);
  }

 private:
  int of(const Carrier& c) const {
    if (c.kind == Carrier::Kind::ground) return ground();
    return c.kind == Carrier::Kind::body ? in_.bodies[c.index].entities[0] : c.index;
  }
  const Description& in_;
  std::vector<int> parent_;
};

void check_masses(const Description& in) {
  std::vector<bool> owned(in.entities.size());
  for (const Body& body : in.bodies)
    for (const int e : body.entities) owned[e] = true;
  for (const PointMass& m : in.masses) {
    owned[m.point] = true;
    if (!(m.mass > 0.0))
      refuse(m.where, fmt::format("mass '{}' is {} kg; allowed is above 0", m.name, m.mass));
  }
  for (std::size_t e = 0; e < owned.size(); ++e)
    if (!owned[e] && !in.entities[e].fixed)
      refuse(
          in.entities[e].where,
          fmt::format("{} '{}' belongs to no body and has no mass; allowed is a point of a body, one with a "
                      "mass, or a fixed one",
                      in.entities[e].kind == Entity::Kind::point ? "point" : "vector", in.entities[e].name));
}

/// One island may float as a whole; of several each hangs on the ground or is free.
void check_islands(const Description& in) {
  Islands islands(in);
  islands.join_all();
  const auto grounded = [&](const Body& b) {
    return islands.find(b.entities[0]) == islands.find(islands.ground());
  };
  const bool floating = std::none_of(in.bodies.begin(), in.bodies.end(), grounded);
  for (const Body& body : in.bodies)
    if (!body.free && !grounded(body) &&
        !(floating && islands.find(body.entities[0]) == islands.find(in.bodies[0].entities[0])))
      refuse(body.where,
             fmt::format("body '{}' is connected to nothing that is fixed{}; allowed is a shared point, a "
                         "joint, a distance, a spring, or free = true",
                         body.name, floating ? ", nor to body '" + in.bodies[0].name + "'" : ""));
}

void check_relatives(const Description& in) {
  for (const Relative& r : in.relatives) {
    const auto across = [&](const Edge& e) {
      const Eigen::Vector3d way = drawn(in, e);
      return r.axis < 0 ? way : Eigen::Vector3d(way.cross(in.entities[r.axis].at));
    };
    if (!(across(r.a).norm() > 0.0) || (r.kind == Relative::Kind::angle && !(across(r.b).norm() > 0.0)))
      refuse(r.where, fmt::format("{} '{}' is not defined as drawn: an edge has no length{}",
                                  r.kind == Relative::Kind::angle ? "angle" : "length", r.name,
                                  r.axis < 0 ? "" : " across the axis"));
  }
}

/// Without a variable there is nothing to assemble.
void check_moving(const Description& in) {
  const auto fixed = [](const Entity& e) { return e.fixed; };
  if (std::all_of(in.entities.begin(), in.entities.end(), fixed))
    refuse(in.entities.empty() ? "" : in.entities.back().where,
           "every point and vector is fixed; allowed is a mechanism with one that moves");
}

}  // namespace

void check(const Description& in) {
  check_moving(in);
  check_masses(in);
  check_islands(in);
  check_relatives(in);
}

}  // namespace tandem::mbs
