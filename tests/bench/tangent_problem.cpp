// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/tangent_problem.hpp"

#include <algorithm>
#include <map>
#include <random>

#include "four_bar/linkage.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

using mbs::MatrixKind;
using mbs::Pattern;
using Values = std::map<std::pair<int, int>, double>;  ///< by column and row

constexpr double alpha = 40.0;  ///< beta h^2 alpha of the formulation at h = 1.25 ms and 1e8
constexpr double skew = 0.1, drift = 1e-3;
constexpr int sets = 4, natural_entries = 6;

/// M of the linkage, denser: small symmetric numbers, and on the diagonal their sum.
void add_artificial(Values& a, int n, const TangentRequest& request, std::mt19937& random) {
  const int entries = request.entries;
  std::uniform_int_distribution<int> row(0, n - 1),
      distance(1, request.placement == Placement::near ? entries : n - 1);
  std::uniform_real_distribution<double> value(-1e-2, 1e-2);
  const auto target = static_cast<std::size_t>(n) * std::min(entries, n);
  for (int tries = 0; a.size() < target && tries < 20 * n * entries; ++tries) {
    const int i = row(random), j = i + distance(random);
    if (j >= n || !a.try_emplace({i, j}, 0.0).second) continue;
    const double v = value(random);
    a[{i, j}] = a[{j, i}] = v;
    a[{i, i}] += std::abs(v);
    a[{j, j}] += std::abs(v);
  }
}

void add_products(Values& a, const mbs::Matrix& jacobian) {
  const Pattern& p = jacobian.pattern;
  for (int c = 0; c < p.columns(); ++c)
    for (int i = p.starts()[c]; i < p.starts()[c + 1]; ++i)
      for (int j = p.starts()[c]; j < p.starts()[c + 1]; ++j)
        a[{p.indices()[j], p.indices()[i]}] += alpha * jacobian.values[i] * jacobian.values[j];
}

/// The constraints below and beside M, with zeros on their diagonal.
void add_borders(Values& a, const mbs::Matrix& jacobian, int n) {
  const auto entries = jacobian.pattern.entries();
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto [variable, constraint] = entries[k];
    a[{variable, n + constraint}] = a[{n + constraint, variable}] = jacobian.values[k];
    a[{n + constraint, n + constraint}] = 0.0;
  }
}

void add_skew_part(Values& a, std::mt19937& random) {
  std::uniform_real_distribution<double> part(-skew, skew);
  for (auto& [place, value] : a)
    if (place.first < place.second) {
      const double v = part(random) * value;
      value += v;
      a[{place.second, place.first}] -= v;
    }
}

/// All values by factors near 1, alike on both sides of the diagonal.
std::vector<double> drifted(const Values& a, std::mt19937& random) {
  std::uniform_real_distribution<double> factor(1.0 - drift, 1.0 + drift);
  std::vector<double> scale, values;
  for (const auto& [place, value] : a) {
    const auto larger = static_cast<std::size_t>(std::max(place.first, place.second));
    while (scale.size() <= larger) scale.push_back(factor(random));
    values.push_back(value * scale[place.first] * scale[place.second]);
  }
  return values;
}

}  // namespace

TangentProblem tangent_problem(const TangentRequest& request) {
  const MatrixKind kind = request.kind;
  const int loops = std::max(1, (request.variables - 2) / (kind == MatrixKind::symmetric ? 4 : 2));
  const mbs::Mechanism linkage(mbs::read_mechanism("four_bar", four_bar::text(loops)));
  const mbs::Structure& s = linkage.structure();
  mbs::Matrix jacobian{s.jacobian, std::vector<double>(static_cast<std::size_t>(s.jacobian_values()))};
  std::vector<double> phi(static_cast<std::size_t>(s.constraints));
  linkage.constraints(linkage.described_state().q.data(), phi.data(), jacobian.values.data());

  std::mt19937 random(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same problem each time
  Values a;
  const auto mass = s.mass.pattern.entries();
  for (std::size_t k = 0; k < mass.size(); ++k) a[{mass[k].second, mass[k].first}] = s.mass.values[k];
  if (kind != MatrixKind::symmetric) add_products(a, jacobian);
  if (request.entries > natural_entries) add_artificial(a, s.variables, request, random);
  if (kind == MatrixKind::symmetric) add_borders(a, jacobian, s.variables);
  if (kind == MatrixKind::unsymmetric) add_skew_part(a, random);

  TangentProblem problem;
  std::vector<std::pair<int, int>> places;
  for (const auto& [place, value] : a) places.emplace_back(place.second, place.first);
  const int size = places.back().second + 1;
  problem.pattern = Pattern(size, size, std::move(places));
  for (int k = 0; k < sets; ++k) problem.values.push_back(drifted(a, random));
  return problem;
}

}  // namespace tandem::bench
