// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/dense_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

Picture chart_of(const std::string& rows) {
  const test::Scratch folder;
  return dense_chart(read_dense_times(folder.write("dense.csv", "library,operation,N,ns,mflops\n" + rows)),
                     {"c"});
}

TEST(DenseChart, HasALineForEachLibraryAndOperation) {
  const std::string script =
      chart_of("Eigen,product,4,30,1\nEigen,product,8,204,1\nEigen,cholesky,4,140,1\nBLIS,product,4,1040,1\n")
          .script();
  for (const char* part : {"<< END\n4 30\n8 204\nEND\n", "<< END\n4 140\nEND\n", "<< END\n4 1040\nEND\n",
                           "title 'Eigen'", "title 'BLIS'"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
}

TEST(DenseChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"dense.csv", "no rows"}, [] { chart_of(""); }));
}

}  // namespace
}  // namespace tandem::charts
