// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "check.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "groups.hpp"
#include "refuse.hpp"

namespace tandem::mbs {
namespace {

bool acts(const Spring& s) {
  const auto any = [](const std::vector<double>& c) {
    return std::any_of(c.begin(), c.end(), [](double k) { return k != 0.0; });
  };
  return any(s.stiffness) || any(s.damping);
}

bool acts(const Description& in, const Force& f) {
  const Input& input = in.inputs[static_cast<std::size_t>(f.input)];
  return f.gain != 0.0 && !(input.function && input.value == 0.0);  // the latter: a number for a magnitude
}

/// Which points hang together: sets that are joined (union-find), the ground the last of them. Two points are
/// joined by what depends on where one stands from the other, and holds, drives or loads them so. Products
/// and angles leave the way between their edges free.
class Islands {
 public:
  explicit Islands(const Description& in) : in_(in), groups_(ground() + 1) {
    for (int e = 0; e < ground(); ++e)
      if (in.entities[e].fixed) join(e, ground());
    join_bodies();
    join_constraints();
    join_loads();
  }
  int ground() const { return static_cast<int>(in_.entities.size()); }
  int find(int e) { return groups_.find(e); }
  int of(const Body& body) const {
    return *std::find_if(body.entities.begin(), body.entities.end(), [&](int e) { return is_point(in_, e); });
  }

 private:
  void join(int a, int b) {
    const auto is_place = [&](int e) { return e == ground() || is_point(in_, e); };
    if (is_place(a) && is_place(b)) groups_.join(a, b);
  }
  void join(const Edge& edge) { join(edge.to, edge.from); }
  void join(const Edge& a, const Edge& b) { join(a), join(b); }
  void join_relative(int r) {
    if (r < 0) return;
    const Relative& relative = in_.relatives[r];
    if (relative.a.to >= 0) return join(relative.a, relative.b);
    if (relative.kind == Relative::Kind::length)
      join(of(relative.ends.carriers[0]), of(relative.ends.carriers[1]));
  }
  int of(const Carrier& c) const {
    if (c.kind == Carrier::Kind::ground) return ground();
    if (c.kind == Carrier::Kind::combination) return c.entities[0];
    return c.kind == Carrier::Kind::body ? of(in_.bodies[c.index]) : c.index;
  }
  void join_bodies() {
    for (const Body& body : in_.bodies)
      for (const int e : body.entities) join(of(body), e);
  }
  void join_constraints() {
    for (const ScalarProduct& p : in_.products) join(p.a, p.b);
    for (const FixedAngle& a : in_.fixed_angles) join(a.a, a.b);
    for (const Joint& j : in_.joints) join(of(j.first), of(j.second));
    for (const Link& l : in_.links) join(of(l.ends.carriers[0]), of(l.ends.carriers[1]));
    for (const Relation& r : in_.relations)
      for (const auto& p : r.products) join(p.a, p.b);
    for (const Slide& s : in_.slides) join(s.point, of(s.carrier));
    for (const Drive& d : in_.drives) {
      join(d.coordinate.entity, ground());
      join_relative(d.coordinate.relative);
    }
  }
  void join_loads() {
    for (const Spring& s : in_.springs)
      if (acts(s)) s.relative < 0 ? join(s.points) : join_relative(s.relative);
    for (const Force& f : in_.forces) {
      if (!acts(in_, f)) continue;
      if (f.kind == Force::Kind::line) join(f.points);
      if (f.kind == Force::Kind::relative) join_relative(f.index);
    }
  }

  const Description& in_;
  Groups groups_;
};

void check_masses(const Description& in) {
  std::vector<bool> owned(in.entities.size());
  for (const Body& body : in.bodies)
    for (const int e : body.entities) owned[e] = true;
  for (const PointMass& m : in.masses) {
    if (m.mass > 0.0) owned[m.point] = true;
    if (!(m.mass >= 0.0))
      refuse(m.where, fmt::format("mass '{}' is {} kg; allowed is 0 or more", m.name, m.mass));
  }
  for (std::size_t e = 0; e < owned.size(); ++e)
    if (!owned[e] && !in.entities[e].fixed && !in.entities[e].massless)
      refuse(
          in.entities[e].where,
          fmt::format("{} '{}' belongs to no body and has no mass; allowed is a point of a body, one with a "
                      "mass, a fixed one, or massless = true",
                      is_point(in, static_cast<int>(e)) ? "point" : "vector", in.entities[e].name));
}

void check_points(const Description& in) {
  for (const Body& b : in.bodies)
    if (std::none_of(b.entities.begin(), b.entities.end(), [&](int e) { return is_point(in, e); }))
      refuse(b.where, "body '" + b.name + "' has no point; allowed is one or more");
}

/// A body or a mass that something is to hold.
struct Carried {
  std::string name;
  int point;
  bool free;
  const std::string& where;
};

std::vector<Carried> carried(const Description& in, const Islands& islands) {
  std::vector<Carried> all;
  for (const Body& b : in.bodies) all.push_back({"body '" + b.name + "'", islands.of(b), b.free, b.where});
  for (const PointMass& m : in.masses) all.push_back({"mass '" + m.name + "'", m.point, m.free, m.where});
  return all;
}

/// One island may float as a whole; of several each hangs on the ground or is free.
void check_islands(const Description& in) {
  Islands islands(in);
  const auto all = carried(in, islands);
  std::set<int> held = {islands.find(islands.ground())};
  const bool floating = std::none_of(all.begin(), all.end(),
                                     [&](const Carried& c) { return held.count(islands.find(c.point)); });
  for (const Carried& c : all)
    if (c.free || (floating && &c == &all[0])) held.insert(islands.find(c.point));
  for (const Carried& c : all)
    if (!held.count(islands.find(c.point)))
      refuse(c.where,
             fmt::format("{} is connected to nothing that is fixed{}; allowed is a shared point, a joint, "
                         "a distance, a spring or force between two points, a drive, or free = true",
                         c.name, floating ? ", nor to " + all[0].name : ""));
}

void check_drives(const Description& in) {
  for (auto d = in.drives.begin(); d != in.drives.end(); ++d)
    for (auto before = in.drives.begin(); before != d; ++before)
      if (before->coordinate == d->coordinate)
        refuse(d->where, "drive '" + d->name + "' moves what drive '" + before->name +
                             "' moves already; allowed is one drive of a coordinate");
}

void check_relatives(const Description& in) {
  for (const Relative& r : in.relatives) {
    if (r.a.to < 0) {
      continue;
    }
    if (r.kind == Relative::Kind::angle && r.a == r.b)
      refuse(r.where, "angle '" + r.name + "' lies between an edge and itself; allowed are two edges");
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
  const auto free = [](const Relative& r) { return r.kind == Relative::Kind::free; };
  if (std::ranges::all_of(in.entities, fixed) && std::ranges::none_of(in.relatives, free))
    refuse(in.entities.empty() ? "" : in.entities.back().where,
           "every point and vector is fixed; allowed is a mechanism with one that moves");
}

}  // namespace

void check(const Description& in) {
  check_moving(in);
  check_points(in);
  check_masses(in);
  check_islands(in);
  check_relatives(in);
  check_drives(in);
}

}  // namespace tandem::mbs
