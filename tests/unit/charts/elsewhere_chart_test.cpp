// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/elsewhere_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

Picture elsewhere_chart_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "loops,elsewhere,transport,seconds,ratio,same_bits\n";
  return elsewhere_chart(read_elsewhere_times(folder.write("engine_linkage.csv", header + rows)), {"c"});
}

TEST(ElsewhereChart, HasALineForEachTransportAndAPanelForEachCountOfLoops) {
  const std::string script =
      elsewhere_chart_of(
          "5,none,in_process,0.2,1,yes\n5,none,monolithic,0.03,0.15,\n5,engine,tcp,0.7,3.5,yes\n"
          "5,linkage,tcp,0.8,4,yes\n10,none,in_process,0.3,1,yes\n10,engine,tcp,0.9,3,yes\n")
          .script();
  for (const char* part : {"<< END\n0.2 3\n0.03 2\nEND\n", "<< END\n0.7 1\nEND\n", "<< END\n0.8 1\nEND\n",
                           "('in_process' 3, 'monolithic' 2, 'tcp' 1)", "'5 loops'", "'10 loops'"})
    EXPECT_NE(script.find(part), std::string::npos) << part << " in\n" << script;
}

TEST(ElsewhereChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"engine_linkage.csv", "no rows"},
                            [] { elsewhere_chart_of(""); }));
}

}  // namespace
}  // namespace tandem::charts
