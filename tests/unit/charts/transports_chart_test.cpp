// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/transports_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

Picture transports_chart_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "transport,wait,signals,samples,median_us,p99_us,raw_median_us,ratio\n";
  return transports_chart(read_transport_times(folder.write("transports.csv", header + rows)), {"c"});
}

TEST(TransportsChart, HasALineForEachTransportAndWaitAndAPanelForEachCountOfSamples) {
  const std::string script =
      transports_chart_of(
          "lib,none,1,1,0.1,0.2,0.01,10\nlib,none,4,1,0.2,0.3,0.1,2\ntcp,block,4,1,20,40,19,1.05\n"
          "tcp,block,4,100,30,50,29,1.03\n")
          .script();
  for (const char* part : {"<< END\n0.1 2\n19 1\nEND\n", "<< END\n0.2 2\n20 1\nEND\n", "<< END\n50 1\nEND\n",
                           "('lib' 2, 'tcp, block' 1)", "1 sample back", "100 samples back"})
    EXPECT_NE(script.find(part), std::string::npos) << part << " in\n" << script;
}

TEST(TransportsChart, RefusesATableWithoutSuchRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"transports.csv", "4 signals"},
                            [] { transports_chart_of("lib,none,1,1,0.1,0.2,0.01,10\n"); }));
}

}  // namespace
}  // namespace tandem::charts
