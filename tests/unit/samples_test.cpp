// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/samples.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tandem {
namespace {

TEST(Samples, ARowIsTimeJumpAndValues) {
  std::vector<double> memory(8, -1.0);
  Samples y(memory.data(), 4, 2);
  double* row = y.append(0.5);
  row[0] = 1.0;
  row[1] = 2.0;
  row = y.append(0.75, true);
  row[0] = 3.0;
  row[1] = 4.0;
  EXPECT_EQ(memory, (std::vector<double>{0.5, 0.0, 1.0, 2.0, 0.75, 1.0, 3.0, 4.0}));
  EXPECT_EQ(y.time(1), 0.75);
  EXPECT_FALSE(y.jump(0));
  EXPECT_TRUE(y.jump(1));
  EXPECT_EQ(std::vector<double>(y.values(1).begin(), y.values(1).end()), (std::vector<double>{3.0, 4.0}));
}

TEST(Samples, IsFullAtItsCapacity) {
  std::vector<double> memory(6);
  Samples y(memory.data(), 3, 2);
  EXPECT_EQ(y.size(), 0);
  y.append(0.0);
  EXPECT_FALSE(y.full());
  y.append(1.0);
  EXPECT_TRUE(y.full());
  EXPECT_TRUE(Samples().full()) << "without memory there is no room";
}

TEST(Samples, AppendsAfterRowsThatAreThere) {
  std::vector<double> memory = {0.0, 0.0, 7.0, 0.0, 0.0, 0.0};
  Samples y(memory.data(), 3, 2, 1);
  y.append(1.0)[0] = 8.0;
  EXPECT_EQ(memory, (std::vector<double>{0.0, 0.0, 7.0, 1.0, 0.0, 8.0}));
  EXPECT_EQ(y.values(0)[0], 7.0);
}

TEST(Samples, TheCViewShowsTheSameRows) {
  std::vector<double> memory(6);
  Samples y(memory.data(), 3, 2);
  y.append(1.0);
  const tandem_samples rows = y.c_view();
  EXPECT_EQ(rows.rows, memory.data());
  EXPECT_EQ(rows.stride, 3);
  EXPECT_EQ(rows.capacity, 2);
  EXPECT_EQ(rows.size, 1);
  memory[3] = 2.0;
  y.set_size(2);
  EXPECT_EQ(y.time(1), 2.0);
  EXPECT_TRUE(y.full());
}

}  // namespace
}  // namespace tandem
