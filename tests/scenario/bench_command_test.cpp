// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// `tandem bench` and the charts of benchmarks.
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string charts = TANDEM_SOURCE_DIR "/tests/bench/charts.toml";

TEST(BenchCommand, WritesATableThatTheChartsDraw) {
  const Scratch folder;
  const Said said = tandem(folder, {"--quiet", "bench", "dense", "--output", "b"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(read_text(folder.path() / "b/dense.csv").starts_with("library,operation,N,ns,mflops\n"));
  EXPECT_TRUE(contains(said.out, "Eigen"));
  const Said chart = tandem(folder, {"chart", charts, "--chart", "dense", "--results", "b"});
  EXPECT_EQ(chart.status, 0) << chart.err;
  EXPECT_TRUE(contains(read_text(folder.path() / "b/dense.gp"), "ns: the least of 10"));
}

TEST(BenchCommand, RefusesANameThatIsNotThere) {
  const Scratch folder;
  const Said said = tandem(folder, {"bench", "dens"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "did you mean 'dense'?")) << said.err;
  EXPECT_EQ(tandem(folder, {"bench"}).status, 2);
}

TEST(BenchCommand, SaysHowToBuildItWhereItIsNot) {
  const Scratch folder;
  fs::copy_file(TANDEM_COMMAND, folder.path() / "tandem");
  const Said said = tandem(folder, {"bench", "dense"}, (folder.path() / "tandem").string());
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "--target tandem_bench")) << said.err;
}

}  // namespace
}  // namespace tandem
