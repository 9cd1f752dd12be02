// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that react (tandem/reaction.h) in a request to advance.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "refusal.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::test {
namespace {

constexpr wire::Scalars two_by_three{2, 3, true};

/// Of any numbers: both inputs react.
struct AnyReaction {
  explicit AnyReaction(unsigned seed) : random(seed) {
    for (double& one : begin) one = number();
    for (int k = 0; k < 9; ++k) terms.push_back({index(5), index(8), number(), number()});
    for (int k = 0; k < 3; ++k) courses.push_back({index(5), 0, {number(), number(), number(), number()}});
    for (std::size_t k = 0; k < 2; ++k) {
      answers[k] = {&reaction, index(5), number()};
      signals.push_back(Signal(&segment, 1, 1).with(&answers[k]));
    }
    reaction = {5, 9, 3, number(), terms.data(), courses.data(), begin.data()};
  }
  double number() { return std::normal_distribution<double>()(random); }
  std::int32_t index(int count) { return std::uniform_int_distribution<std::int32_t>(0, count - 1)(random); }
  std::vector<std::byte> bytes() const {
    wire::Writer frame;
    wire::put_advance(frame, {1.5, true, 7}, signals, true);
    return {frame.bytes().begin(), frame.bytes().end()};
  }

  std::mt19937 random;
  std::vector<double> begin = std::vector<double>(5);
  std::vector<tandem_reaction_term> terms;
  std::vector<tandem_reaction_course> courses;
  tandem_reactive_input answers[2] = {};
  Reaction reaction{};
  Segment segment{2.0, 0.0, {1.0, 2.0}};
  std::vector<Signal> signals;
};

void expect_same_rates(const Reaction& a, const Reaction& b) {
  const double z[] = {0.3, -1.0, 2.0, 0.7, 5.0}, y[] = {1.0, -3.0, 0.1};
  double of_a[5], of_b[5];
  tandem_reaction_rates(&a, 0.77, z, y, of_a), tandem_reaction_rates(&b, 0.77, z, y, of_b);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(of_a[k], of_b[k]);
}

TEST(WireReaction, ComesAsItWasSent) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const AnyReaction sent(seed);
    wire::Advance got;
    wire::read_advance(sent.bytes(), two_by_three, got);
    ASSERT_EQ(got.reaction.view.states, 5);
    EXPECT_EQ(got.reaction.begin, sent.begin);
    expect_same_rates(got.reaction.view, sent.reaction);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(got.signals[k].value(0.4, got.reaction.view.begin),
                sent.signals[k].value(0.4, sent.begin.data()));
  }
}

/// And a request with none, after one with one.
TEST(WireReaction, IsLeftOutWhereNoInputReacts) {
  wire::Advance got;
  wire::read_advance(AnyReaction(1).bytes(), two_by_three, got);
  const Segment segment{2.0, 0.0, {1.0}};
  const std::vector<Signal> plain(2, Signal(&segment, 1, 0));
  wire::Writer frame;
  wire::put_advance(frame, {1.5, true, 7}, plain, true);
  wire::read_advance(frame.bytes(), two_by_three, got);
  EXPECT_EQ(got.reaction.view.states, 0);
  EXPECT_EQ(reaction_of(got.signals), nullptr);
}

TEST(WireReaction, ThatIsCutAnywhereOrGoesOnIsRefused) {
  std::vector<std::byte> bytes = AnyReaction(3).bytes();
  const auto reading = [](std::span<const std::byte> payload) {
    return [payload] {
      wire::Advance got;
      wire::read_advance(payload, two_by_three, got);
    };
  };
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"the message"}, reading(std::span(bytes).first(size))))
        << size;
  bytes.push_back(std::byte{0});
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"1 bytes more"}, reading(bytes)));
}

TEST(WireReaction, OfNumbersThatMakeNoSenseIsRefused) {
  const auto refused = [](const std::function<void(AnyReaction&)>& spoil, const char* word) {
    AnyReaction sent(5);
    spoil(sent);
    return refuses(ErrorCode::invalid_argument, {word}, [&] {
      wire::Advance got;
      wire::read_advance(sent.bytes(), two_by_three, got);
    });
  };
  EXPECT_TRUE(refused([](auto& s) { s.terms[4].to = 5; }, "by the state 5; allowed are 0 to 4"));
  EXPECT_TRUE(refused([](auto& s) { s.terms[4].to = -1; }, "by the state -1"));
  EXPECT_TRUE(refused([](auto& s) { s.terms[4].from = 8; }, "state or output 8; allowed are 0 to 7"));
  EXPECT_TRUE(refused([](auto& s) { s.courses[1].to = 7; }, "by the state 7"));
  EXPECT_TRUE(refused([](auto& s) { s.answers[1].state = 5; }, "by the state 5"));
  EXPECT_TRUE(refused([](auto& s) { s.answers[1].gain = NAN; }, "not finite"));
  EXPECT_TRUE(refused([](auto& s) { s.courses[1].c[3] = INFINITY; }, "not finite"));
  EXPECT_TRUE(refused([](auto& s) { s.begin[2] = NAN; }, "not finite"));
  EXPECT_TRUE(refused([](auto& s) { s.reaction.origin = NAN; }, "not finite"));
  EXPECT_TRUE(
      refused([](auto& s) { s.begin.resize(13), s.reaction.states = 13, s.reaction.begin = s.begin.data(); },
              "13 states; allowed are up to 12"));
}

}  // namespace
}  // namespace tandem::test
