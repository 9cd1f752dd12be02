// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <stdlib.h>  // setenv

#include "changed_fmu.hpp"
#include "fmus.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/fmi/archive.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

TEST(FmuSource, IsReadWithoutARunOfIt) {
  const Scratch scratch;
  const auto look = look_at(changed(scratch, library, "no library") + "?set.k=2", fmu_sources(), {});
  ASSERT_TRUE(look);
  EXPECT_EQ(look->info.outputs.at(0).name, "x");
  EXPECT_EQ(look->info.outputs.at(0).derivatives, 1);
  EXPECT_EQ(look->own_step, 0.1);
  ASSERT_EQ(look->parameters.size(), 1U);
  EXPECT_EQ(look->parameters[0].name, "set.k");
  EXPECT_EQ(look->parameters[0].otherwise, "1");
}

/// A library with its names, whose table of segments lies beyond its end.
std::string not_loadable() {
  std::string bytes = fmi::Archive(TANDEM_FMUS "/decay.fmu").text(library, 1U << 24);
  constexpr std::size_t segments = 32;  // e_phoff of ELF with 64 bits
  return bytes.replace(segments, 4, "\x7f\x7f\x7f\x7f");
}

/// What look_at() sees, and what open() refuses in the same words.
std::string obstacle(const std::string& source) {
  const std::string seen = look_at(source, fmu_sources(), {})->obstacle;
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {seen.substr(std::string("the FMU ").size())},
                      [&] { open(source, fmu_sources()); }));
  return seen;
}

TEST(FmuSource, LooksAtWhatItsLibraryLacks) {
  const Scratch scratch;
  const auto sentence = [](const std::string& source) {
    const auto seen = look_at(source, fmu_sources(), {});
    EXPECT_EQ(seen->obstacle, "");
    return seen->sentences.at(1);
  };
  EXPECT_EQ(sentence(fmu_uri("decay")), "library: " + library);
  EXPECT_EQ(sentence(fmu_uri("mass3?type=me")), "library: binaries/x86_64-linux/mass3.so");
  const std::string none =
      "the FMU has " + library + ", which is no shared library for this processor; allowed is one";
  EXPECT_EQ(obstacle(changed(scratch, library, "a text")), none);
  std::string bytes = fmi::Archive(TANDEM_FMUS "/decay.fmu").text(library, 1U << 24);
  std::string other = bytes;
  other[18] = 40;  // of an ARM processor
  EXPECT_EQ(obstacle(changed(scratch, library, other)), none);
  for (std::size_t at = 0; (at = bytes.find("fmi2DoStep", at)) != std::string::npos; ++at) bytes[at] = 'F';
  bytes += std::string("fmi2DoStep") + '\0';  // words are no functions
  EXPECT_EQ(obstacle(changed(scratch, library, bytes)),
            "the FMU has " + library + ", which lacks the function fmi2DoStep; allowed is one with it");
  for (const std::size_t kept : {64U, 1000U, 9000U})
    EXPECT_TRUE(obstacle(changed(scratch, library, bytes.substr(0, kept))).starts_with("the FMU has "))
        << kept;
  EXPECT_EQ(
      obstacle(changed(scratch, describing,
                       description_with("<CoSimulation ", "<CoSimulation needsExecutionTool=\"true\" "))),
      "the FMU needs the tool that made it (needsExecutionTool); allowed is one that brings all that it "
      "needs");
}

/// x of decay as a state that is taken for an output: without a word of the structure on it it follows no input.
TEST(FmuSource, AStateFollowsNoInputAtOnce) {
  const Scratch scratch;
  std::string text = description_with(
      "<ScalarVariable name=\"k\" valueReference=\"3\" causality=\"parameter\" variability=\"fixed\">",
      "<ScalarVariable name=\"k\" valueReference=\"3\" causality=\"input\">");
  text.replace(text.find("causality=\"output\""), 18, "causality=\"local\"");
  text.replace(text.find("<Outputs>"), text.find("<Derivatives>") - text.find("<Outputs>"), "");
  const std::string source = changed(scratch, describing, text) + "?outputs.x=true";
  EXPECT_TRUE(look_at(source, fmu_sources(), {})->info.feedthrough.empty());
}

TEST(FmuSource, FeedthroughIsThatOfTheModelStructure) {
  const auto info = look_at(fmu_uri("mass"), fmu_sources(), {})->info;
  ASSERT_EQ(info.feedthrough.size(), 1U);
  EXPECT_EQ(info.feedthrough[0].output, 2);
  EXPECT_EQ(info.outputs[0].derivatives, 1);  // its second follows the input at once
  EXPECT_EQ(look_at(fmu_uri("mass?type=me"), fmu_sources(), {})->info.outputs[0].derivatives, 2);
  EXPECT_EQ(look_at(fmu_uri("mass?unit.x=mm"), fmu_sources(), {})->info.outputs[0].unit, "mm");
}

TEST(FmuSource, WhatItHasNotIsRefused) {
  for (const auto& [name, texts] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"decay?set.kk=1", {"'kk' is not there", "did you mean 'k'"}},
           {"decay?set.k=-1", {"'set.k' is -1", "from 0"}},
           {"decay?set.k=fast", {"'set.k'", "'fast'"}},
           {"decay?type=fast", {"'fast'", "cs"}},
           {"ball?type=cs", {"does not offer Co-Simulation"}},
           {"decay?inputs=none", {"'none'", "mean, left, right, middle, derivatives"}},
           {"decay?inputs=derivatives", {"does not take any"}},
           {"mass?inputs=derivatives&order=3", {"'order' is 3", "1 and 2"}},
           {"types", {"no step of its own", "parameter step"}},
           {"decay?step=0", {"'step' is 0"}},
           {"decay?unit.z=m", {"'z' is not there"}},
           {"decay?speed=1", {"'speed' is not there"}},
           {"decay?type=me&inputs=mean", {"'inputs' is not there"}},
           {"decay?state=on", {"'on'", "trust"}}})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, texts, [&] { open_fmu(name); })) << name;
}

TEST(FmuSource, AnFmuThatCannotRunHereIsRefused) {
  const Scratch scratch;
  EXPECT_TRUE(
      refuses(ErrorCode::not_supported, {"binaries/linux64/decay.so", "there are those of win64"}, [&] {
        const fmi::Archive whole(TANDEM_FMUS "/decay.fmu");
        open("fmu:" + write_zip(scratch.path() / "x.fmu", {{describing, whole.text(describing, 1U << 20)},
                                                           {"binaries/win64/decay.dll", "x"}})
                          .string(),
             fmu_sources());
      }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"needsExecutionTool"}, [&] {
    open(changed(scratch, describing,
                 description_with("<CoSimulation ", "<CoSimulation needsExecutionTool=\"true\" ")),
         fmu_sources());
  }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"x.fmu' holds no modelDescription.xml"},
                      [&] { open(changed(scratch, describing, ""), fmu_sources()); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"x.fmu", "is truncated"},
                      [&] { open(changed(scratch, library, not_loadable()), fmu_sources()); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"x.fmu", "makes no instance", "the guid"}, [&] {
    open(changed(scratch, describing, description_with("guid=\"decay-1\"", "guid=\"2\"")), fmu_sources());
  }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"no function 'fmi2SetRealInputDerivatives'"}, [&] {
    std::string bytes = fmi::Archive(TANDEM_FMUS "/decay.fmu").text(library, 1U << 24);
    for (std::size_t at = 0; (at = bytes.find("fmi2SetRealInputD", at)) != std::string::npos; ++at)
      bytes[at] = 'F';
    write_zip(scratch.path() / "x.fmu",
              {{describing, description_with("<CoSimulation ", "<CoSimulation canInterpolateInputs=\"1\" ")},
               {library, bytes}});
    open("fmu:" + (scratch.path() / "x.fmu").string(), fmu_sources());
  }));
}

/// Also after an error.
TEST(FmuSource, LeavesNothingBehind) {
  const Scratch scratch, temporary;
  const std::string bad = changed(scratch, library, not_loadable());
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  {
    const auto fmu = open_fmu("decay");
    EXPECT_FALSE(fs::is_empty(temporary.path()));
    FmuRun(*fmu, 1.0);
    EXPECT_TRUE(refuses(ErrorCode::input_output, {"x.fmu"}, [&] { open(bad, fmu_sources()); }));
  }
  ::unsetenv("TMPDIR");
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

/// Folders of processes that were killed go, and those in use stay.
TEST(FmuSource, RemovesWhatAKilledProcessHasLeft) {
  const Scratch temporary;
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  const auto count = [&] { return std::distance(fs::directory_iterator(temporary.path()), {}); };
  const fs::path left = temporary.path() / "tandem_temporary_left",
                 young = temporary.path() / "tandem_temporary_young";
  fs::create_directories(left / "resources"), fs::create_directories(young);
  fs::last_write_time(left, long_ago);
  {
    const auto one = open_fmu("decay");
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(young));
    for (const auto& entry : fs::directory_iterator(temporary.path()))
      fs::last_write_time(entry.path(), long_ago);
    const auto other = open_fmu("decay");
    EXPECT_EQ(count(), 2);
    EXPECT_EQ(FmuRun(*one, 1.0).rows, FmuRun(*other, 1.0).rows);
  }
  ::unsetenv("TMPDIR");
  EXPECT_EQ(count(), 0);
}

TEST(FmuSource, NumbersOfItsExperimentThatAreNotAboveZeroAreRefusedUnlessTheyAreGiven) {
  const Scratch scratch;
  const std::string none =
      changed(scratch, describing, description_with("stepSize=\"0.1\"", "stepSize=\"0\" tolerance=\"0\""));
  const auto with = [&](const std::string& given) {
    return [&, given] { open(none + given, fmu_sources()); };
  };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"stepSize of DefaultExperiment of the FMU is 0", "parameter step"},
                      with("?tolerance=1")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"tolerance of DefaultExperiment of the FMU is 0"},
                      with("?step=1")));
  EXPECT_NO_THROW(with("?step=1&tolerance=1")());
}

TEST(FmuSource, ThatMayBeThereOnceIsRefusedTwice) {
  const Scratch scratch;
  const std::string once = changed(
      scratch, describing,
      description_with("<CoSimulation ", "<CoSimulation canBeInstantiatedOnlyOncePerProcess=\"true\" "));
  EXPECT_TRUE(look_at(once, fmu_sources(), {})->once_per_process);
  auto one = open(once, fmu_sources());
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"once in a process", "isolate"},
                      [&] { open(once, fmu_sources()); }));
  EXPECT_NO_THROW(FmuRun(*one, 1.0));
  one.reset();
  EXPECT_NO_THROW(open(once, fmu_sources()));
}

/// Instances do not share what they are.
TEST(FmuSource, MayHaveSeveralInstances) {
  const auto slow = open_fmu("decay"), fast = open_fmu("decay?set.k=5");
  EXPECT_GT(FmuRun(*slow, 1.0).rows.back()[2], 10.0 * FmuRun(*fast, 1.0).rows.back()[2]);
}

/// The program has a zlibVersion, too, and it is loaded already.
TEST(FmuSource, HasItsOwnSymbolsBeforeThoseOfTheProgram) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer takes the place of symbols itself";
#endif
  const auto fmu = open_fmu("symbols");
  EXPECT_EQ(FmuRun(*fmu, 1.0).rows.back()[2], 1.0);
}

TEST(FmuSource, AClientSetsNumbersAndNoTexts) {
  const auto open_for = [](const std::string& client) {
    Opening opening;
    opening.parameters.read(client, "the client", Setter::client);
    return open(fmu_uri("types?step=1"), fmu_sources(), std::move(opening));
  };
  EXPECT_NO_THROW(open_for("set.whole_in=3&set.flag_in=true"));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'set.text'", "comes from a client"},
                      [&] { open_for("set.text=x"); }));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'type'", "comes from a client"}, [&] { open_for("type=me"); }));
}

TEST(FmuSource, ItsLogIsToldWhereItIsAskedFor) {
  std::vector<std::string> told;
  const auto tell = [&](const std::string& what) { told.push_back(what); };
  const auto fmu = open(fmu_uri("decay?log=true&inputs=left"), fmu_sources(tell));
  double row[8];
  Samples y(row, fmu->info().row_size(), 1);
  fmu->initialize(0.0, 0.05, {}, y);
  Samples next(row, fmu->info().row_size(), 1);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"fmi2DoStep", "fmi2Error", "beyond the stop time"},
                      [&] { fmu->advance(1.0, false, {}, next); }));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("beyond the stop time"), std::string::npos);
}

}  // namespace
}  // namespace tandem::test
