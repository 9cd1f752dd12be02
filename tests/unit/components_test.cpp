// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/components.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tandem {
namespace {

using Edges = std::vector<std::pair<int, int>>;

/// By pair of nodes whether there is a way (Floyd and Warshall).
std::vector<std::vector<char>> ways(std::size_t nodes, const Edges& edges) {
  std::vector<std::vector<char>> way(nodes, std::vector<char>(nodes));
  for (std::size_t i = 0; i < nodes; ++i) way[i][i] = 1;
  for (const auto& [from, to] : edges) way[static_cast<std::size_t>(from)][static_cast<std::size_t>(to)] = 1;
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j) way[i][j] |= static_cast<char>(way[i][k] & way[k][j]);
  return way;
}

TEST(Components, AreThoseThatReachEachOther) {
  std::mt19937_64 random(1972);
  for (int round = 0; round < 500; ++round) {
    const std::size_t nodes = 1 + random() % 12, count = random() % 25;
    Edges edges;
    for (std::size_t k = 0; k < count; ++k)
      edges.emplace_back(static_cast<int>(random() % nodes), static_cast<int>(random() % nodes));
    const auto of = strongly_connected(static_cast<int>(nodes), edges);
    const auto way = ways(nodes, edges);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j)
        EXPECT_EQ(of[i] == of[j], way[i][j] != 0 && way[j][i] != 0) << round << ": " << i << " and " << j;
  }
}

TEST(Components, OfALongChainNeedNoDeepStack) {
  constexpr int length = 1'000'000;
  Edges chain;
  for (int k = 1; k < length; ++k) chain.emplace_back(k - 1, k);
  chain.emplace_back(length - 1, length / 2);
  const auto of = strongly_connected(length, chain);
  EXPECT_EQ(of[length - 1], of[length / 2]);
  EXPECT_NE(of[length / 2 - 1], of[length / 2]);
}

}  // namespace
}  // namespace tandem
