// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "mechanisms/motion.hpp"

namespace tandem::mechanisms {

/// A number or vector as a function of one coordinate s: its value and its first two derivatives by s,
/// carried along exactly by the rules of differentiation.
template <class T>
struct Jet {
  T value, first, second;
};
using Number = Jet<Real>;
using PlanePath = Jet<Vector2>;
using SpacePath = Jet<Vector3>;

inline Number coordinate(Real s) { return {s, 1, 0}; }

template <class T>
Jet<T> fixed(const T& value) {
  return {value, value * 0, value * 0};
}

inline SpacePath vector(const Number& x, const Number& y, const Number& z) {
  return {{x.value, y.value, z.value}, {x.first, y.first, z.first}, {x.second, y.second, z.second}};
}

template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
  return {a.value + b.value, a.first + b.first, a.second + b.second};
}

template <class T>
Jet<T> operator*(Real factor, const Jet<T>& a) {
  return {factor * a.value, factor * a.first, factor * a.second};
}

template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
  return a + Real{-1} * b;
}

template <class T>
Jet<T> operator*(const Number& a, const Jet<T>& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2 * a.first * b.first + a.value * b.second};
}

template <class T>
Number dot(const Jet<T>& a, const Jet<T>& b) {
  return {a.value.dot(b.value), a.first.dot(b.value) + a.value.dot(b.first),
          a.second.dot(b.value) + 2 * a.first.dot(b.first) + a.value.dot(b.second)};
}

inline SpacePath cross(const SpacePath& a, const SpacePath& b) {
  return {a.value.cross(b.value), a.first.cross(b.value) + a.value.cross(b.first),
          a.second.cross(b.value) + 2 * a.first.cross(b.first) + a.value.cross(b.second)};
}

/// f(x) from f, f' and f'' there.
inline Number composed(const Number& x, Real f, Real slope, Real curvature) {
  return {f, slope * x.first, slope * x.second + curvature * x.first * x.first};
}

inline Number sin(const Number& x) {
  const Real s = std::sin(x.value);
  return composed(x, s, std::cos(x.value), -s);
}

inline Number cos(const Number& x) {
  const Real c = std::cos(x.value);
  return composed(x, c, -std::sin(x.value), -c);
}

inline Number sqrt(const Number& x) {
  const Real root = std::sqrt(x.value);
  return composed(x, root, 1 / (2 * root), -1 / (4 * root * x.value));
}

inline Number inverse(const Number& x) {
  const Real inverse = 1 / x.value;
  return composed(x, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
}

}  // namespace tandem::mechanisms
