// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tandem::split_pendulum {
namespace {

constexpr double gravity = 9.81, upper_mass = 1.0, upper_length = 1.0, node_step = 2.5e-4;

const char* const plane = "dimension = 2\ngravity = [0, -9.81]\n";

const char* const upper_points =
    "[points]\nO = { at = [0, 0], fixed = true }\nA = { at = [1, 0] }\n"
    "[rods.upper]\npoints = [\"O\", \"A\"]\nmass = 1\n";

std::string force(const std::string& name, int axis, const std::string& magnitude, double gain) {
  return fmt::format("[forces.{}]\npoint = \"A\"\ndirection = {}\nmagnitude = {}\ngain = {}\n", name,
                     axis == 0 ? "[1, 0]" : "[0, 1]", magnitude, gain);
}

std::string carried(double mass) {
  std::string text = fmt::format("[masses.carried]\npoint = \"A\"\nmass = {}\n", mass);
  for (int axis = 0; axis < 2; ++axis) {
    const std::string name = axis == 0 ? "ax" : "ay";
    text += fmt::format("[inputs.{}]\nunit = \"m/s^2\"\n", name) +
            force("carried_" + name, axis, '"' + name + '"', mass);
  }
  return text + force("weight", 1, fmt::format("{}", gravity), mass);
}

using Angles = std::array<double, 4>;

Angles rates(const Rods& rods, const Angles& y) {
  const double m = rods.lower_mass, lower_length = rods.lower_length,
               c = 0.5 * m * upper_length * lower_length, cosine = c * std::cos(y[0] - y[1]),
               sine = c * std::sin(y[0] - y[1]), first = (upper_mass / 3.0 + m) * upper_length * upper_length,
               second = m * lower_length * lower_length / 3.0,
               f = -sine * y[3] * y[3] - (0.5 * upper_mass + m) * gravity * upper_length * std::sin(y[0]),
               g = sine * y[2] * y[2] - 0.5 * m * gravity * lower_length * std::sin(y[1]),
               determinant = first * second - cosine * cosine;
  return {y[2], y[3], (f * second - g * cosine) / determinant, (first * g - cosine * f) / determinant};
}

Angles moved(Angles y, double by, const Angles& rate) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += by * rate[i];
  return y;
}

}  // namespace

std::string upper_text(const Rods& rods) {
  std::string text = std::string(plane) + upper_points;
  for (int axis = 0; axis < 2; ++axis) {
    const std::string name = axis == 0 ? "Fx" : "Fy";
    text += fmt::format("[inputs.{}]\nunit = \"N\"\n", name) + force(name, axis, '"' + name + '"', 1.0);
  }
  if (rods.carried_mass != 0.0) text += carried(rods.carried_mass);
  return text + "[outputs]\nx = { position = \"A.x\" }\ny = { position = \"A.y\" }\n";
}

std::string lower_text(const Rods& rods) {
  return plane +
         fmt::format(
             "[points]\nA = {{ at = [1, 0] }}\nB = {{ at = [{}, 0] }}\n"
             "[rods.lower]\npoints = [\"A\", \"B\"]\nmass = {}\n",
             upper_length + rods.lower_length, rods.lower_mass) +
         "[inputs]\nx = { unit = \"m\", value = 1 }\ny = { unit = \"m\", value = 0 }\n"
         "[drives]\nx = { coordinate = \"A.x\", motion = \"x\" }\ny = { coordinate = \"A.y\", motion = \"y\" "
         "}\n"
         "[outputs]\nRx = { reaction = \"x\" }\nRy = { reaction = \"y\" }\n"
         "ax = { acceleration = \"A.x\" }\nay = { acceleration = \"A.y\" }\n";
}

std::string monolithic_text(const Rods& rods) {
  return std::string(plane) + upper_points +
         fmt::format("[rods.lower]\npoints = [\"A\", \"B\"]\nmass = {}\n[points.B]\nat = [{}, 0]\n",
                     rods.lower_mass, upper_length + rods.lower_length) +
         "[outputs]\nx = { position = \"A.x\" }\ny = { position = \"A.y\" }\n";
}

Truth::Truth(const Rods& rods, double t_stop)
    : nodes_{{std::numbers::pi / 2, std::numbers::pi / 2, 0.0, 0.0}} {
  const double h = node_step;
  for (double t = 0.0; t < t_stop + h; t += h) {
    const Angles& y = nodes_.back();
    const Angles k1 = rates(rods, y), k2 = rates(rods, moved(y, h / 2, k1)),
                 k3 = rates(rods, moved(y, h / 2, k2)), k4 = rates(rods, moved(y, h, k3));
    nodes_.push_back(moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4));
  }
}

Eigen::Vector2d Truth::elbow(double t) const {
  const auto k = std::min(static_cast<std::size_t>(t / node_step), nodes_.size() - 2);
  const Angles &left = nodes_[k], &right = nodes_[k + 1];
  const double x = t / node_step - static_cast<double>(k), z = 1.0 - x;
  const double a = z * z * (1.0 + 2.0 * x) * left[0] + x * x * (1.0 + 2.0 * z) * right[0] +
                   node_step * x * z * (z * left[2] - x * right[2]);
  return {upper_length * std::sin(a), -upper_length * std::cos(a)};
}

}  // namespace tandem::split_pendulum
