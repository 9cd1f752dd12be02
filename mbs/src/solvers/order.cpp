// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "order.hpp"

#include <amd.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/cuthill_mckee_ordering.hpp>
#include <new>
#include <numeric>

namespace tandem::mbs::solvers {
namespace {

std::vector<int> cuthill_mckee(const Pattern& pattern) {
  using Graph = boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS,
                                      boost::property<boost::vertex_color_t, boost::default_color_type>>;
  Graph graph(static_cast<std::size_t>(pattern.columns()));
  for (const auto& [row, column] : pattern.entries())
    if (row != column)
      boost::add_edge(static_cast<std::size_t>(row), static_cast<std::size_t>(column), graph);
  std::vector<std::size_t> order(static_cast<std::size_t>(pattern.columns()));
  boost::cuthill_mckee_ordering(graph, order.rbegin());
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  return place;
}

}  // namespace

std::vector<int> narrow_order(const Pattern& pattern) {
  std::vector<int> own(static_cast<std::size_t>(pattern.columns()));
  std::iota(own.begin(), own.end(), 0);
  const auto other = cuthill_mckee(pattern);
  return band_width(pattern, own) <= band_width(pattern, other) ? own : other;
}

int band_width(const Pattern& pattern, const std::vector<int>& place) {
  int most = 0;
  for (const auto& [row, column] : pattern.entries())
    most = std::max(most, std::abs(place[row] - place[column]));
  return most;
}

std::vector<int> minimum_degree_order(const Pattern& pattern) {
  std::vector<int> order(static_cast<std::size_t>(pattern.columns()));
  if (amd_order(pattern.columns(), pattern.starts().data(), pattern.indices().data(), order.data(), nullptr,
                nullptr) < AMD_OK)
    throw std::bad_alloc();
  return order;
}

}  // namespace tandem::mbs::solvers
