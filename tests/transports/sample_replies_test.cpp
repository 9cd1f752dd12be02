// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Replies to samples that no sound subsystem gives: refused, in C++ and in C.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "by_hand.hpp"
#include "masters.hpp"

namespace tandem::test {
namespace {

/// What is said of a start and of a sample at 0.25 s of a sampled subsystem; "" if all is believed.
class SampleReplyChecks : public testing::TestWithParam<Master> {
 protected:
  static SubsystemInfo pi() {
    SubsystemInfo info{"pi", {{"w", "1"}}, {{"u", "1", 2}}, {}, {.sampled = true}, {0.5, 0.0}};
    info.outputs[0].held = true;
    return info;
  }
  static ByHand::Answer start(const Clock& clock) {
    return {wire::Type::samples, [clock](wire::Writer& w) {
              double row[4];
              Samples y(row, 4, 1);
              std::fill_n(y.append(0.0), 2, 0.0);
              wire::put_samples(w, clock, y);
            }};
  }
  std::string said_of_sample(const Clock& clock, std::vector<double> u, const Clock& first,
                             SamplePart part = SamplePart::both) {
    auto answers = opening_answers(pi());
    answers.push_back(start(first));
    answers.push_back({wire::Type::sample, [clock, u](wire::Writer& w) { wire::put_sampled(w, clock, u); }});
    const ByHand server(std::move(answers));
    double row[4], w = 0.0, outputs[2];
    Samples y(row, 4, 1);
    try {
      const auto far = GetParam().open(server.address());
      far->initialize(0.0, 1.0, {&w, 1}, y);
      far->sample(0.25, part, {&w, 1}, outputs);
      return {};
    } catch (const Error& error) {
      return after_address(error.what(), server.address());
    }
  }
};

TEST_P(SampleReplyChecks, WhatIsSoundIsBelieved) {
  const Clock at_once = {0.0, 0.0, Stop::limit}, later = {0.0, 0.25, Stop::limit};
  const Clock next = {0.25, 0.75, Stop::limit}, unmoved = {0.0, 0.25, Stop::limit};
  EXPECT_EQ(said_of_sample(next, {1.0, 2.0}, later), "");
  EXPECT_EQ(said_of_sample(next, {1.0, 2.0}, at_once), "") << "its first instant is the start";
  EXPECT_EQ(said_of_sample(unmoved, {1.0, 2.0}, later, SamplePart::outputs), "");
  EXPECT_EQ(said_of_sample(next, {}, later, SamplePart::states), "");
}

TEST_P(SampleReplyChecks, WhatIsNotIsRefused) {
  const Clock first = {0.0, 0.25, Stop::limit}, next = {0.25, 0.75, Stop::limit};
  const std::string where = "sample at t = 0.25 s: ";
  EXPECT_EQ(said_of_sample(next, {1.0, std::nan("")}, first),
            where + "the reply gives u[1] not finite at t = 0.25 s");
  EXPECT_EQ(said_of_sample({0.5, 0.75, Stop::limit}, {1.0, 2.0}, first),
            where + "the reply says that it stands at t = 0.5 s; allowed is that of the sample, 0.25 s");
  EXPECT_EQ(said_of_sample({0.25, 0.25, Stop::limit}, {1.0, 2.0}, first),
            where + "the reply gives 0.25 s as the end of the next own step, which is not later than 0.25 s");
  EXPECT_NE(said_of_sample(next, {1.0}, first).find("the message 'sample'"), std::string::npos);
  EXPECT_NE(said_of_sample(next, {1.0, 2.0}, first, SamplePart::states).find("the message 'sample'"),
            std::string::npos);
  EXPECT_EQ(said_of_sample(next, {1.0, 2.0}, {0.0, -0.25, Stop::limit}),
            "initialize at t = 0 s: the reply gives -0.25 s as the end of the next own step, which is not "
            "later than 0 s");
}

INSTANTIATE_TEST_SUITE_P(Masters, SampleReplyChecks, masters, master_name);

}  // namespace
}  // namespace tandem::test
