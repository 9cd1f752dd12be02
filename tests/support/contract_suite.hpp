// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What every Subsystem has to do: the checks of tandem/check.hpp, which `tandem check` runs too, one test for
// each. To put one to the test, in one source file of a test program:
//   INSTANTIATE_TEST_SUITE_P(Mine, SubsystemContract, testing::Values(ContractCase{"mine", [] { return
//   make(); }}), contract_name);
#include <gtest/gtest.h>

#include <string>

#include "tandem/check.hpp"
#include "word.hpp"

namespace tandem::test {

struct ContractCase {
  std::string name;
  Opener make;
  double t_start = 0.0;
};
inline std::string contract_name(const testing::TestParamInfo<ContractCase>& p) { return word(p.param.name); }
inline void PrintTo(const ContractCase& c, std::ostream* out) { *out << c.name; }

class SubsystemContract : public testing::TestWithParam<ContractCase> {
 protected:
  static void passes(const std::string& check) {
    for (const Finding& finding : tandem::check(check, GetParam().make, {GetParam().t_start, {}})) {
      if (finding.kind == Finding::Kind::left_out) GTEST_SKIP() << finding.sentence;
      ADD_FAILURE() << finding.sentence;
    }
  }
};

TEST_P(SubsystemContract, ItsPortsMakeSense) { passes("its ports make sense"); }

TEST_P(SubsystemContract, ItsInfoIsConstant) { passes("its info is constant"); }

TEST_P(SubsystemContract, TheStartIsOneSampleAtTStart) { passes("the start is one sample at t_start"); }

TEST_P(SubsystemContract, WhatNoUnknownInputFeedsThroughToIsFiniteAtTheStart) {
  passes("what no unknown input feeds through to is finite at the start");
}

TEST_P(SubsystemContract, StartingAgainBeforeTheFirstAdvanceGivesTheSameBits) {
  passes("starting again before the first advance gives the same bits");
}

TEST_P(SubsystemContract, StartingAgainAfterAnAdvanceGivesTheSameBits) {
  passes("starting again after an advance gives the same bits");
}

TEST_P(SubsystemContract, AnInstanceMayBeDroppedBeforeItIsStarted) {
  passes("an instance may be dropped before it is started");
}

TEST_P(SubsystemContract, AdvanceTakesAllTheStepsThatFitAndNoOther) {
  passes("advance takes all the steps that fit and no other");
}

TEST_P(SubsystemContract, AStepThatDoesNotFitIsNotTaken) { passes("a step that does not fit is not taken"); }

TEST_P(SubsystemContract, EachStepGivesOneSampleAndOneByOneTheyAreTheSame) {
  passes("each step gives one sample, and one by one they are the same");
}

TEST_P(SubsystemContract, TimesRise) { passes("times rise"); }

TEST_P(SubsystemContract, ItReturnsEarlyWithoutRoomAndGoesOnWithTheSameBits) {
  passes("it returns early without room and goes on with the same bits");
}

TEST_P(SubsystemContract, ItLandsExactlyAndKeepsItsGrid) { passes("it lands exactly and keeps its grid"); }

TEST_P(SubsystemContract, LandingReturnsEarlyWithoutRoomToo) {
  passes("landing returns early without room, too");
}

TEST_P(SubsystemContract, ARestoredStateGoesOnWithTheSameBits) {
  passes("a restored state goes on with the same bits");
}

TEST_P(SubsystemContract, AStateThatIsReleasedOrWasNeverSavedIsRefused) {
  passes("a state that is released or was never saved is refused");
}

TEST_P(SubsystemContract, AStateGoesAsBytesToAnotherInstanceAndGoesOnWithTheSameBits) {
  passes("a state goes as bytes to another instance and goes on with the same bits");
}

TEST_P(SubsystemContract, BytesThatAreNoStateAreRefused) { passes("bytes that are no state are refused"); }

TEST_P(SubsystemContract, InstancesAreIndependent) { passes("instances are independent"); }

}  // namespace tandem::test
