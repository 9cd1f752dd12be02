// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Derivatives of outputs that an FMU gives by a function.
#include <gtest/gtest.h>

#include "changed_fmu.hpp"
#include "fmus.hpp"
#include "refusal.hpp"

namespace tandem::test {
namespace {

/// The FMU with a description without variables of derivatives, for Co-Simulation alone, and with a function for them.
std::string without_rates(const Scratch& scratch, const std::string& fmu, const std::string& folder) {
  const fmi::Archive whole(TANDEM_FMUS "/" + fmu + ".fmu");
  std::string text = whole.text("modelDescription.xml", 1U << 20);
  const auto cut = [&](const std::string& from, const std::string& to) {
    const auto begin = text.find(from), end = text.find(to, begin) + to.size();
    text.erase(begin, end - begin);
  };
  cut("<ModelExchange", "/>");
  if (folder == "linux64")
    cut(" derivative=", "2\""), cut("<Derivatives>", "</Derivatives>");
  else
    cut(" derivative=", "1\""), cut("<ContinuousStateDerivative", "/>");
  text.insert(text.find("<CoSimulation ") + 14, "maxOutputDerivativeOrder=\"1\" ");
  const std::string library = "binaries/" + folder + "/" + fmu + ".so";
  return "fmu:" + write_zip(scratch.path() / (fmu + ".fmu"),
                            {{"modelDescription.xml", text}, {library, whole.text(library, 1U << 24)}})
                      .string();
}

/// x' = -x beside 0.9^n.
TEST(FmuDerivedOutputs, AreInEachRow) {
  for (const auto& [fmu, folder] : {std::pair{"decay", "linux64"}, {"decay3", "x86_64-linux"}}) {
    const Scratch scratch;
    const std::string uri = without_rates(scratch, fmu, folder);
    EXPECT_EQ(open(uri, fmu_sources())->info().derivatives(), 0);
    const auto derived = open(uri + "?derivatives=1", fmu_sources());
    const FmuRun run(*derived, 1.0);
    ASSERT_EQ(run.rows.size(), 11U) << fmu;
    for (const auto& row : run.rows) EXPECT_EQ(row.at(3), -row.at(2)) << fmu;
    EXPECT_EQ(run.rows, FmuRun(*open_fmu(std::string(fmu) + "?type=cs"), 1.0).rows) << fmu;
  }
}

/// F has none, though the FMU has some.
TEST(FmuDerivedOutputs, OneThatIsRefusedIsNamed) {
  for (const std::string fmu : {"mass", "mass3"})
    EXPECT_TRUE(refuses(ErrorCode::numerical, {"output 'F'", "OutputDerivatives", "allowed is derivatives=0"},
                        [&] {
                          FmuRun(*open_fmu(fmu + "?type=cs&derivatives=1"), 1.0, {0.0, 0.0});
                        }))
        << fmu;
}

TEST(FmuDerivedOutputs, AreRefusedWhereThereAreNone) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'derivatives' is 1", "maxOutputDerivativeOrder"},
                      [] { open_fmu("decay?derivatives=1"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'derivatives' is 2", "allowed are 0 and 1"},
                      [] { open_fmu("mass?type=cs&derivatives=2"); }));
}

}  // namespace
}  // namespace tandem::test
