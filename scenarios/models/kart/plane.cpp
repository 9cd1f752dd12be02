// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tandem::kart {
namespace {

enum Variable { x, z, psi, z_front, z_rear, turn_front, turn_rear, slip_front, slip_rear };

}  // namespace

Plane::Plane(const KartData& d, TyreLaw law, Formulas formulas)
    : KartModel({"x", "z", "psi", "z_front", "z_rear", "turn_front", "turn_rear", "slip_front", "slip_rear"},
                {d.mass, d.sprung, d.pitch_inertia, 2.0 * d.front_unsprung, 2.0 * d.rear_unsprung,
                 d.front_spin, d.rear_spin, 1.0, 1.0}),
      data_(d),
      law_(law),
      guide_(formulas == Formulas::complete ? d.sprung_height - d.radius : 0.0) {}

Plane::Contact Plane::contact(Axle axle, const double* q, const double* v) const {
  const KartData& d = data_;
  const bool front = axle == Axle::front;
  const auto [height, turn, slip] =
      front ? std::array{z_front, turn_front, slip_front} : std::array{z_rear, turn_rear, slip_rear};
  const double arm = front ? d.sprung_to_front : -d.sprung_to_rear, tilt = guide_ > 0.0 ? q[psi] : 0.0;
  Contact c{};
  c.up = q[z] - q[height] - arm * q[psi] + 0.5 * guide_ * tilt * tilt;
  c.up_rate = v[z] - v[height] - arm * v[psi] + guide_ * tilt * v[psi];
  c.speed = v[x] - guide_ * v[psi];
  if (guide_ > 0.0) c.speed -= c.up * v[psi] + c.up_rate * tilt + arm * tilt * v[psi];
  const double load = (front ? d.front_load() : d.rear_load()) -
                      2.0 * ((front ? d.front_tyre : d.rear_tyre) * q[height] + d.tyre_damping * v[height]),
               sliding = d.radius * v[turn] - c.speed;
  c.load = std::max(0.0, load);
  c.slip = v[slip] + 0.05 * std::exp(-std::abs(c.speed)) * sliding;
  c.slip_rate = (sliding - std::abs(c.speed) * v[slip]) / d.relaxation;
  c.force = 2.0 * tyre_force(law_, axle, {c.slip, 0.0}, 0.5 * c.load).longitudinal;
  c.resistance = d.rolling * c.load * d.radius * std::tanh(v[turn] * d.radius / 0.1);
  c.spring = -2.0 * ((front ? d.front_stiffness : d.rear_stiffness) * c.up +
                     (front ? d.front_damping : d.rear_damping) * c.up_rate);
  return c;
}

void Plane::forces(const double* q, const double* v, double* force) const {
  const KartData& d = data_;
  const Contact f = contact(Axle::front, q, v), r = contact(Axle::rear, q, v);
  force[z] = f.spring + r.spring;
  force[z_front] = f.load - d.front_load() - f.spring;
  force[z_rear] = r.load - d.rear_load() - r.spring;
  force[turn_front] = -f.force * d.radius - f.resistance;
  force[turn_rear] = torque - r.force * d.radius - r.resistance;
  force[slip_front] = f.slip_rate;
  force[slip_rear] = r.slip_rate;
  force[x] = f.force + r.force - d.drag * v[x] * std::abs(v[x]);
  force[psi] = -d.sprung_to_front * f.spring + d.sprung_to_rear * r.spring - torque;
  guide_ > 0.0 ? complete(f, r, q[psi], force) : add_shift(f.force + r.force, force);
}

/// (r - h_s)(F_x - m_u x'').
void Plane::add_shift(double tyres, double* force) const {
  const double unsprung = data_.mass - data_.sprung;
  force[psi] += (data_.radius - data_.sprung_height) * (tyres - unsprung * force[x] / data_.mass);
}

/// Then solved for the accelerations of x and psi, times the masses that stand in the structure.
void Plane::complete(const Contact& front, const Contact& rear, double tilt, double* force) const {
  const KartData& d = data_;
  const double m = d.mass, along = force[x];
  const auto guide = [&](const Contact& c, double unsprung, int height) {
    const double push = c.force - unsprung * along / m;  // H
    force[psi] -= guide_ * c.force + push * c.up;
    force[z] -= push * tilt;
    force[height] += push * tilt;
  };
  guide(front, 2.0 * d.front_unsprung, z_front);
  guide(rear, 2.0 * d.rear_unsprung, z_rear);
  force[psi] += guide_ * tilt * (d.sprung * d.gravity + front.spring + rear.spring);
  const double coupling = (m - d.sprung) * guide_, turned = d.pitch_inertia + coupling * guide_,
               about = force[psi], determinant = m * turned - coupling * coupling;
  force[x] = m * (turned * along + coupling * about) / determinant;
  force[psi] = d.pitch_inertia * (m * about + coupling * along) / determinant;
}

double Plane::energy(const double* q, const double* v) const {
  const KartData& d = data_;
  const auto& masses = structure().mass.values;
  const Contact f = contact(Axle::front, q, v), r = contact(Axle::rear, q, v);
  const double unsprung = d.mass - d.sprung, wheels = v[x] - guide_ * v[psi];
  double twice = unsprung * (wheels * wheels - v[x] * v[x]) - d.sprung * d.gravity * guide_ * q[psi] * q[psi];
  for (std::size_t i = x; i <= turn_rear; ++i) twice += masses[i] * v[i] * v[i];
  const auto spring = [](double stiffness, double by) { return 2.0 * stiffness * by * by; };
  twice += spring(d.front_stiffness, f.up) + spring(d.rear_stiffness, r.up) +
           spring(d.front_tyre, q[z_front]) + spring(d.rear_tyre, q[z_rear]);
  return 0.5 * twice;
}

SubsystemInfo Plane::info() const {
  return {"kart.plane",
          {{"torque", "N m"}},
          {{"shaft_speed", "rad/s", 1, 1},
           {"pitch", "rad", 1, 2},
           {"speed", "m/s", 1, 1},
           {"front_load", "N"},
           {"rear_load", "N"},
           {"front_slip", "1"},
           {"rear_slip", "1"}},
          {},
          {}};
}

void Plane::outputs(const mbs::State& s, double* y) const {
  const Contact f = contact(Axle::front, s.q.data(), s.v.data()),
                r = contact(Axle::rear, s.q.data(), s.v.data());
  const double turns = guide_ > 0.0 ? 1.0 : 0.0;  // the shaft against the chassis
  const double values[] =
      {s.v[turn_rear] - turns * s.v[psi], s.q[psi], s.v[x], 0.5 * f.load, 0.5 * r.load, f.slip, r.slip},
               rates[] = {s.a[turn_rear] - turns * s.a[psi], s.v[psi], s.a[x], 0.0, 0.0, 0.0, 0.0},
               second[] = {0.0, s.a[psi], 0.0, 0.0, 0.0, 0.0, 0.0};
  for (const auto& row : {values, rates, second}) y = std::copy_n(row, 7, y);
}

std::vector<mbs::Bound> Plane::bounds() const {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double largest = largest_load(law_);
  const std::string beyond = "a tyre's load is beyond its data; what follows goes on in straight lines";
  return {{"signal 'front_load'", "N", 1e-3, none, "the front wheels are off the ground"},
          {"signal 'rear_load'", "N", 1e-3, none, "the rear wheels are off the ground"},
          {"signal 'front_load'", "N", -none, largest, beyond},
          {"signal 'rear_load'", "N", -none, largest, beyond},
          {"signal 'pitch'", "rad", -0.7, 0.7, "the kart turns over, and its formulas are for small angles",
           true}};
}

void Plane::watched(const mbs::State& s, double* values) const {
  const double front = 0.5 * contact(Axle::front, s.q.data(), s.v.data()).load,
               rear = 0.5 * contact(Axle::rear, s.q.data(), s.v.data()).load;
  for (const double value : {front, rear, front, rear, s.q[psi]}) *values++ = value;
}

}  // namespace tandem::kart
