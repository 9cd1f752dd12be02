// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What is prepared of the sparse algebra, beside the expression that says the same in Eigen.
#include <fmt/format.h>

#include <Eigen/SparseCore>
#include <numeric>

#include "bench/bench.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/permutation.hpp"
#include "tandem/mbs/sparse/products.hpp"
#include "tandem/mbs/sparse/rank_update.hpp"

namespace tandem::bench {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Eigen::VectorXd;

Sparse to_eigen(const mbs::Pattern& pattern, const std::vector<double>& values) {
  return Eigen::Map<const Sparse>(pattern.rows(), pattern.columns(), pattern.size(), pattern.starts().data(),
                                  pattern.indices().data(), values.data());
}

mbs::Pattern pattern_of(const Sparse& a) {
  std::vector<std::pair<int, int>> entries;
  for (int c = 0; c < a.outerSize(); ++c)
    for (Sparse::InnerIterator it(a, c); it; ++it) entries.emplace_back(static_cast<int>(it.row()), c);
  return {static_cast<int>(a.rows()), static_cast<int>(a.cols()), std::move(entries)};
}

std::vector<double> on_pattern(const mbs::Matrix& a, const mbs::Pattern& whole) {
  std::vector<double> values(static_cast<std::size_t>(whole.size()));
  const auto at = mbs::positions(a.pattern, whole);
  for (std::size_t k = 0; k < at.size(); ++k)
    if (at[k] >= 0) values[at[k]] = a.values[k];
  return values;
}

/// The matrices of the linkage in its first position, here and as Eigen's, there Phi_q itself.
struct SparseCase {
  explicit SparseCase(int loops)
      : linkage(mbs::read_mechanism("four_bar", four_bar::text(loops))),
        mass{linkage.structure().mass},
        jacobian{linkage.structure().jacobian,
                 std::vector<double>(static_cast<std::size_t>(linkage.structure().jacobian_values()))} {
    const mbs::State s = linkage.described_state();
    VectorXd phi(linkage.structure().constraints);
    linkage.constraints(s.q.data(), phi.data(), jacobian.values.data());
    jacobian.values.pop_back();
    jacobian_eigen = to_eigen(jacobian.pattern, jacobian.values).transpose();
    mass_eigen = to_eigen(mass.pattern, mass.values);
    update_eigen = jacobian_eigen.transpose() * jacobian_eigen;
    update = {pattern_of(update_eigen),
              {update_eigen.valuePtr(), update_eigen.valuePtr() + update_eigen.nonZeros()}};
  }
  mbs::Mechanism linkage;
  mbs::Matrix mass, jacobian, update;  ///< M, Phi_q^T, Phi_q^T Phi_q
  Sparse mass_eigen, jacobian_eigen, update_eigen;
};

/// Both times of an operation [s].
struct Pair {
  std::string operation;
  std::function<void()> ours, eigens;
};

/// alpha Phi_q^T Phi_q where a tangent has it: in both triangles for LU, in the lower one for Cholesky. With
/// the mass it is the tangent of the linkage.
std::vector<Pair> rank_updates(const SparseCase& c) {
  std::vector<Pair> pairs;
  const Sparse& j = c.jacobian_eigen;  // Phi_q
  const mbs::Pattern whole = mbs::unite(c.mass.pattern, c.update.pattern);
  for (const bool lower : {true, false}) {
    const mbs::Pattern pattern = lower ? whole.lower() : whole;
    const auto prepared = std::make_shared<mbs::RankUpdate>(c.jacobian.pattern, pattern.entries());
    const auto mass = std::make_shared<std::vector<double>>(on_pattern(c.mass, pattern)),
               zero = std::make_shared<std::vector<double>>(mass->size()),
               result = std::make_shared<std::vector<double>>(mass->size());
    const auto ours = [=, &c](const std::vector<double>& base) {
      prepared->run(c.jacobian.values.data(), 1e3, base.data(), result->data());
      benchmark::DoNotOptimize(result->data());
    };
    const auto eigens = std::make_shared<Sparse>();
    const std::string part = lower ? " (lower triangle)" : " (both triangles)";
    pairs.push_back(
        {"rank-k update" + part, [=] { ours(*zero); }, [=, &j] { *eigens = 1e3 * (j.transpose() * j); }});
    pairs.push_back({"mass and rank-k update" + part, [=] { ours(*mass); },
                     [=, &j, &c] { *eigens = c.mass_eigen + 1e3 * (j.transpose() * j); }});
  }
  return pairs;
}

Pair sum(const SparseCase& c) {
  const mbs::Pattern pattern = mbs::unite(c.mass.pattern, c.update.pattern);
  const auto a = std::make_shared<std::vector<double>>(on_pattern(c.mass, pattern)),
             b = std::make_shared<std::vector<double>>(on_pattern(c.update, pattern)),
             result = std::make_shared<std::vector<double>>(a->size());
  const auto eigens = std::make_shared<Sparse>();
  return {"sum",
          [=] {
            mbs::add_scaled(a->size(), a->data(), 1e3, b->data(), result->data());
            benchmark::DoNotOptimize(result->data());
          },
          [=, &c] { *eigens = c.mass_eigen + 1e3 * c.update_eigen; }};
}

/// The entries, at hand constraint by constraint, to where they belong.
Pair jacobian(const SparseCase& c) {
  const auto entries = std::make_shared<std::vector<std::pair<int, int>>>(c.jacobian.pattern.entries());
  const auto to = std::make_shared<std::vector<int>>(entries->size());
  std::iota(to->begin(), to->end(), 0);
  const auto result = std::make_shared<std::vector<double>>(entries->size());
  const auto eigens = std::make_shared<Sparse>(c.jacobian_eigen);
  const double* const values = c.jacobian.values.data();
  return {"Jacobian",
          [=] {
            mbs::scatter(*to, values, result->data());
            benchmark::DoNotOptimize(result->data());
          },
          [=] {
            for (std::size_t k = 0; k < entries->size(); ++k)
              eigens->coeffRef((*entries)[k].second, (*entries)[k].first) = values[k];
          }};
}

std::vector<Pair> products(const SparseCase& c) {
  const auto x = std::make_shared<VectorXd>(VectorXd::LinSpaced(c.mass.pattern.columns(), -1.0, 2.0)),
             lambda =
                 std::make_shared<VectorXd>(VectorXd::LinSpaced(c.jacobian.pattern.columns(), -1.0, 2.0)),
             of_mass = std::make_shared<VectorXd>(*x), of_phi = std::make_shared<VectorXd>(*lambda);
  const auto rows = std::make_shared<mbs::Rows>(c.jacobian.pattern);
  return {{"product M a",
           [=, &c] {
             mbs::multiply_symmetric(c.mass, x->data(), of_mass->data());
             benchmark::DoNotOptimize(of_mass->data());
           },
           [=, &c] { *of_mass = c.mass_eigen * *x; }},
          {"product Phi_q v",
           [=, &c] {
             mbs::multiply_transposed(c.jacobian.pattern, c.jacobian.values.data(), x->data(),
                                      of_phi->data());
             benchmark::DoNotOptimize(of_phi->data());
           },
           [=, &c] { *of_phi = c.jacobian_eigen * *x; }},
          {"product Phi_q^T lambda",
           [=, &c] {
             rows->multiply(c.jacobian.values.data(), lambda->data(), of_mass->data());
             benchmark::DoNotOptimize(of_mass->data());
           },
           [=, &c] { *of_mass = c.jacobian_eigen.transpose() * *lambda; }}};
}

Pair permutation(const SparseCase& c) {
  std::vector<int> order(static_cast<std::size_t>(c.update.pattern.columns()));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<int>(order.size() - 1 - k);
  const auto prepared = std::make_shared<mbs::Permuted>(mbs::permuted(c.update.pattern, order));
  const auto result = std::make_shared<std::vector<double>>(prepared->from.size());
  const auto eigens = std::make_shared<Sparse>();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> p(static_cast<int>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) p.indices()[order[k]] = static_cast<int>(k);
  return {"permutation P A P^T",
          [=, &c] {
            mbs::gather(prepared->from, c.update.values.data(), result->data());
            benchmark::DoNotOptimize(result->data());
          },
          [=, &c] { *eigens = c.update_eigen.twistedBy(p); }};
}

Timing pair_timing(const std::string& name, const std::function<void()>& run) {
  return {name, [run](benchmark::State& state) {
            for ([[maybe_unused]] auto _ : state) run();
          }};
}

void add_rows(Table& table, int loops) {
  const SparseCase c(loops);
  std::vector<Pair> pairs = rank_updates(c);
  pairs.push_back(sum(c));
  pairs.push_back(jacobian(c));
  for (Pair& pair : products(c)) pairs.push_back(std::move(pair));
  pairs.push_back(permutation(c));
  std::vector<Timing> timings;
  for (const Pair& pair : pairs) {
    timings.push_back(pair_timing(pair.operation + "/ours", pair.ours));
    timings.push_back(pair_timing(pair.operation + "/eigen", pair.eigens));
  }
  auto seconds = measure(timings, 40, 0.002);
  for (const Pair& pair : pairs) {
    const double ours = seconds[pair.operation + "/ours"], eigens = seconds[pair.operation + "/eigen"];
    table.add({pair.operation, std::to_string(loops), std::to_string(c.mass.pattern.columns()),
               fmt::format("{:.1f}", 1e9 * ours), fmt::format("{:.1f}", 1e9 * eigens),
               fmt::format("{:.1f}", eigens / ours)});
  }
}

}  // namespace

Table sparse_algebra() {
  Table table({"operation", "loops", "variables", "prepared_ns", "eigen_ns", "ratio"});
  for (const int loops : {5, 40, 500}) add_rows(table, loops);
  return table;
}

}  // namespace tandem::bench
