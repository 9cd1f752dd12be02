// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tandem/mbs/mechanism/body_mass.hpp"
#include "view/place.hpp"

namespace tandem::view {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

/// A vector alone, or two points.
Json edge(const mbs::Edge& e) { return e.from < 0 ? Json{e.to} : Json{e.to, e.from}; }

Json ends(const mbs::Edge& e) { return {e.from, e.to}; }

Json entities(const mbs::Description& in) {
  Json list = Json::array();
  for (const mbs::Entity& e : in.entities)
    list.push_back({{"name", e.name},
                    {"point", e.kind == mbs::Entity::Kind::point},
                    {"fixed", e.fixed},
                    {"at", numbers(e.at)}});
  return list;
}

std::vector<int> points_of(const mbs::Description& in, const mbs::Body& body) {
  std::vector<int> points;
  for (const int e : body.entities)
    if (mbs::is_point(in, e)) points.push_back(e);
  return points;
}

/// In the plane a body of one point is a disc of its inertia, m r^2 / 2, about its centre if that is the
/// point.
Json disc(const mbs::Description& in, const mbs::Body& body, int point) {
  const auto vector = std::find_if(body.entities.begin(), body.entities.end(), [&](int e) {
    return in.entities[static_cast<std::size_t>(e)].kind == mbs::Entity::Kind::vector;
  });
  const double radius = std::sqrt(2.0 * body.inertia(2, 2) / body.mass);
  Json wheel{{"centre", place_on(in, mbs::defining_entities(in, body), body.centre)},
             {"radius", radius},
             {"width", 0.2 * radius}};
  if (body.centre == in.entities[static_cast<std::size_t>(point)].at) wheel["centre"] = point;
  if (vector != body.entities.end()) wheel["spoke"] = {*vector};
  return wheel;
}

bool is_wheel(const ViewTable& view, int point) {
  return std::any_of(view.wheels.begin(), view.wheels.end(),
                     [&](const ViewTable::Wheel& w) { return w.centre == point; });
}

/// Bodies of one point that are a wheel of the table are drawn as that alone.
void add_body(const mbs::Description& in, const ViewTable& view, const mbs::Body& body, Json& to) {
  const std::vector<int> points = points_of(in, body);
  if (points.size() == 2) {
    to["rods"].push_back({{"name", body.name}, {"ends", points}});
  } else if (points.size() > 2) {
    to["plates"].push_back({{"name", body.name}, {"corners", points}});
  } else if (points.size() == 1 && !is_wheel(view, points[0])) {
    if (in.dimension == 2) return to["wheels"].push_back(disc(in, body, points[0]));
    Json corners = Json::array();
    for (const Eigen::Vector3d& corner : block(body))
      corners.push_back(place_on(in, mbs::defining_entities(in, body), corner));
    to["plates"].push_back({{"name", body.name}, {"corners", corners}});
  }
}

/// The place of a carrier that is drawn there.
Json carried(const mbs::Description& in, const mbs::Carrier& carrier, const Eigen::Vector3d& at) {
  using Kind = mbs::Carrier::Kind;
  switch (carrier.kind) {
    case Kind::body:
      return place_on(in, mbs::defining_entities(in, in.bodies[static_cast<std::size_t>(carrier.index)]), at);
    case Kind::point:
      return carrier.index;
    case Kind::combination:
      return place_on(in, carrier.entities, at);
    default:
      return place_on(in, std::vector<int>(), at);
  }
}

Json ends(const mbs::Description& in, const mbs::Ends& e) {
  return {carried(in, e.carriers[0], e.places[0]), carried(in, e.carriers[1], e.places[1])};
}

void add_links(const mbs::Description& in, Json& to) {
  for (const mbs::ScalarProduct& p : in.products)
    if (std::strcmp(p.kind, "distance") == 0 && p.a.from >= 0 && p.a == p.b)
      to["links"].push_back({{"name", p.name}, {"ends", ends(p.a)}});
  for (const mbs::Link& link : in.links)
    to["links"].push_back({{"name", link.name}, {"ends", ends(in, link.ends)}});
}

/// Those between two points, and those on a length.
void add_springs(const mbs::Description& in, Json& to) {
  for (const mbs::Spring& spring : in.springs) {
    Json between = spring.relative < 0 ? ends(spring.points) : Json();
    if (spring.relative >= 0) {
      const mbs::Relative& r = in.relatives[static_cast<std::size_t>(spring.relative)];
      if (r.kind != mbs::Relative::Kind::length) continue;
      between = r.a.to >= 0 ? ends(r.a) : ends(in, r.ends);
    }
    to["springs"].push_back({{"name", spring.name}, {"ends", between}, {"damper", spring.stiffness.empty()}});
  }
}

/// Lines of the ground that a joint slides along.
void add_rails(const mbs::Description& in, Json& to) {
  using Kind = mbs::Joint::Kind;
  for (const mbs::Joint& joint : in.joints) {
    const bool slides =
        joint.kind == Kind::point_on_line || joint.kind == Kind::prismatic || joint.kind == Kind::cylindrical;
    const bool grounded =
        joint.second.kind == mbs::Carrier::Kind::ground ||
        (joint.kind != Kind::point_on_line && joint.first.kind == mbs::Carrier::Kind::ground);
    if (slides && grounded)
      to["rails"].push_back({{"at", numbers(joint.at)}, {"along", numbers(joint.axes[0].normalized())}});
  }
}

void add_wheels(const ViewTable& view, Json& to) {
  for (const ViewTable::Wheel& wheel : view.wheels) {
    Json one{{"centre", wheel.centre}, {"radius", wheel.radius}, {"width", wheel.width}};
    if (wheel.axis.to >= 0) one["axis"] = edge(wheel.axis);
    if (wheel.spoke.to >= 0) one["spoke"] = edge(wheel.spoke);
    if (!wheel.angle.empty()) one["angle"] = wheel.angle;
    to["wheels"].push_back(one);
  }
}

}  // namespace

Json drawing(const mbs::Description& in, const ViewTable& view) {
  Json to{{"name", in.name}, {"dimension", in.dimension}, {"up", nullptr}, {"entities", entities(in)}};
  if (in.gravity.norm() > 0.0) to["up"] = numbers(-in.gravity.normalized());
  for (const char* part : {"rods", "links", "plates", "masses", "springs", "wheels", "rails"})
    to[part] = Json::array();
  for (const mbs::Body& body : in.bodies) add_body(in, view, body, to);
  for (const mbs::PointMass& mass : in.masses) to["masses"].push_back(mass.point);
  add_links(in, to);
  add_springs(in, to);
  add_rails(in, to);
  add_wheels(view, to);
  if (view.ground) to["ground"] = *view.ground;
  if (view.follow >= 0) to["follow"] = view.follow;
  to["trace"] = view.trace;
  return to;
}

}  // namespace tandem::view
