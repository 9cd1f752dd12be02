// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/relation.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

using enum Relation::Waits;

/// One that integrates itself reads two sampled ones, and they it; names[k]: the number of the k-th of the
/// three.
std::vector<Relation> of_three(const std::vector<int>& names) {
  std::vector<Member> members(3);
  for (const std::size_t k : {1, 2}) members[static_cast<std::size_t>(names[k])].sampled = true;
  std::vector<Read> reads;
  for (const std::size_t k : {1, 2}) {
    reads.push_back({names[0], names[k]});
    reads.push_back({names[k], names[0]});
  }
  return relations(names, reads, members, true);
}

/// Where each waits for another the first relation decides: it may not depend on how members are numbered.
TEST(Relations, AreInTheOrderThatIsGivenWhateverTheNumbers) {
  const std::vector<int> names = {0, 2, 1};
  auto expected = of_three({0, 1, 2});
  for (Relation& r : expected) {
    r.first = names[static_cast<std::size_t>(r.first)];
    r.second = names[static_cast<std::size_t>(r.second)];
  }
  EXPECT_EQ(of_three(names), expected);
}

/// A sampled one that acts each second, at 5 s next, reads another 0.8 s late: at 4.2 s, and from 5.2 s on
/// again.
TEST(Relations, WhoIsReadLateWaitsBeforeAStepThatMayHaveToEndEarlier) {
  const Relation r{0, 1, Relation::Kind::nearest, 0.8, true, 1.0};
  const Member sampled{.time = 4.0, .next = 5.0, .sampled = true};
  const auto waits = [&](double time, double next) {
    return r.waits(sampled, {.time = time, .next = next, .lands = true}, TimeTolerance());
  };
  EXPECT_EQ(waits(3.9, 4.2), first) << "it can come nearer";
  EXPECT_EQ(waits(4.2, 4.7), none);
  EXPECT_EQ(waits(4.7, 5.2), none);
  EXPECT_EQ(waits(4.7, 5.3), second) << "it may be read at 5.2 s";
}

}  // namespace
}  // namespace tandem
