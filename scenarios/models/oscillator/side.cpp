// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "oscillator/side.hpp"

#include <array>
#include <unsupported/Eigen/MatrixFunctions>

#include "oscillator/both_sides.hpp"
#include "tandem/error.hpp"

namespace tandem::oscillator {
namespace {

using Coefficients = std::array<double, TANDEM_MAX_COEFFICIENTS>;

/// The segment in which a signal goes on from t.
const Segment& at(const Signal& u, double t) {
  const auto segments = u.segments();
  std::size_t k = 0;
  while (k + 1 < segments.size() && !TimeTolerance().before(t, segments[k].end)) ++k;
  return segments[k];
}

/// Where a signal's segment at t ends, the last one never.
double end_at(const Signal& u, double t, double end) {
  const Segment& s = at(u, t);
  return &s == &u.segments().back() ? end : std::min(s.end, end);
}

/// Adds gain times the polynomial, in powers of time - t.
void add(const Segment& s, double t, double gain, Coefficients& to) {
  Coefficients c;
  std::copy(std::begin(s.c), std::end(s.c), c.begin());
  for (std::size_t k = 0; k + 1 < c.size(); ++k)  // Horner's scheme of the shift
    for (std::size_t i = c.size() - 1; i-- > k;) c[i] += (t - s.origin) * c[i + 1];
  for (std::size_t k = 0; k < c.size(); ++k) to[k] += gain * c[k];
}

}  // namespace

Settings Settings::from(Parameters& p, bool force) {
  Settings s;
  const std::string input = p.text("input", force ? "force" : "displacement");
  if (input != "force" && input != "displacement")
    throw Error(ErrorCode::invalid_argument,
                "oscillator: input is '" + input + "'; allowed are force and displacement");
  s.force = input == "force";
  s.mass = positive(p, "mass", s.mass), s.step = positive(p, "step", s.step);
  s.stiffness = p.number("stiffness", s.stiffness), s.damping = p.number("damping", s.damping);
  s.coupling_stiffness = p.number("coupling_stiffness", s.coupling_stiffness);
  s.coupling_damping = p.number("coupling_damping", s.coupling_damping);
  s.x = p.number("x", s.x), s.v = p.number("v", s.v);
  return s;
}

Words Settings::words() {
  return words_by(Setter::client, {"input", "mass", "stiffness", "damping", "coupling_stiffness",
                                   "coupling_damping", "x", "v", "step"});
}

Side::Side(const Settings& s)
    : settings_(s),
      stiffness_(s.stiffness + (s.force ? 0.0 : s.coupling_stiffness)),
      damping_(s.damping + (s.force ? 0.0 : s.coupling_damping)),
      gains_(s.force ? std::vector{1.0} : std::vector{s.coupling_stiffness, s.coupling_damping}) {}

SubsystemInfo Side::info() const {
  SubsystemInfo info{
      "oscillator", {{"F", ""}}, {{"x", "m", 1, 2}, {"v", "m/s", 1, 1}}, {}, {.serializes_state = true}};
  if (!settings_.force) info.inputs = {{"x_other", "m"}, {"v_other", "m/s"}};
  return info;
}

double Side::acceleration(double push) const {
  return (push - damping_ * v_ - stiffness_ * x_) / settings_.mass;
}

void Side::start(double, std::span<const double> u0) {
  x_ = settings_.x, v_ = settings_.v;
  double push = 0.0;
  for (std::size_t i = 0; i < gains_.size(); ++i) push += gains_[i] * u0[i];
  a_ = acceleration(push);
}

const Side::Matrix& Side::over(double length) {
  if (length == length_) return matrix_;
  Matrix a = Matrix::Zero();
  a(0, 1) = 1.0;
  a(1, 0) = -stiffness_ / settings_.mass, a(1, 1) = -damping_ / settings_.mass,
       a(1, 2) = 1.0 / settings_.mass;
  for (int k = 2; k + 1 < size; ++k) a(k, k + 1) = 1.0;
  length_ = length;
  return matrix_ = (a * length).exp();
}

void Side::step(const OwnStep& s, std::span<const Signal> u) {
  for (double t = s.begin; t < s.end;) {
    double end = s.end;
    Coefficients p{};
    for (std::size_t i = 0; i < u.size(); ++i) {
      end = end_at(u[i], t, end);
      add(at(u[i], t), t, gains_[i], p);
    }
    Eigen::Matrix<double, size, 1> z;
    z[0] = x_, z[1] = v_;
    double factorial = 1.0;
    for (std::size_t k = 0; k < p.size(); ++k) {
      z[static_cast<Eigen::Index>(2 + k)] = factorial * p[k];
      factorial *= static_cast<double>(k + 1);
    }
    z = over(t == s.begin && end == s.end ? s.length : end - t) * z;
    x_ = z[0], v_ = z[1], a_ = acceleration(z[2]);
    t = end;
  }
}

void Side::outputs(double* y) const {
  const double row[] = {x_, v_, v_, a_, a_, 0.0};
  std::copy(std::begin(row), std::end(row), y);
}

void Side::write(ByteWriter& to) const { to.put_doubles(std::array{x_, v_, a_}); }

void Side::read(ByteReader& from) {
  x_ = from.take<double>();
  v_ = from.take<double>();
  a_ = from.take<double>();
}

void add_builtins(Builtins& builtins) {
  for (const bool force : {true, false})
    builtins.models[force ? "oscillator.side1" : "oscillator.side2"] = {
        Settings::words(), [force](const Address&, Parameters& p) -> std::unique_ptr<Subsystem> {
          return std::make_unique<FixedStep<Side>>(Side(Settings::from(p, force)));
        }};
  builtins.models["oscillator.exact"] = {BothSides::words(),
                                         [](const Address&, Parameters& p) -> std::unique_ptr<Subsystem> {
                                           return std::make_unique<FixedStep<BothSides>>(BothSides::from(p));
                                         }};
}

}  // namespace tandem::oscillator
