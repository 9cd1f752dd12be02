// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The checks of the contract: subsystems with one fault each.
#include "tandem/check.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <thread>

#include "refusal.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem {
namespace {

/// x' = u + v with v held over a step.
class Sum {
 public:
  SubsystemInfo info() const {
    return {"sum", {{"u", "m/s"}, {"v", "m/s"}}, {{"x", "m"}}, {}, {.serializes_state = true}};
  }
  double own_step() const { return 0.01; }
  void start(double, std::span<const double>) { x_ = 0.0; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    x_ += s.length * (u[0].value(s.begin) + u[1].value(s.end));
  }
  void outputs(double* y) const { *y = x_; }
  void write(ByteWriter& to) const { to.put(x_); }
  void read(ByteReader& from) { x_ = from.take<double>(); }

 private:
  double x_ = 0.0;
};

/// What is told of Sum, and what its calls do, may be another thing.
struct Faults {
  std::function<void(SubsystemInfo&)> info = {};
  std::function<Clock(Subsystem&, std::span<const double> u0, Samples& y)> initialize = {};
  std::function<Clock(Subsystem&, double t_limit, bool land, std::span<const Signal> u, Samples& y)> advance =
      {};
  std::function<Clock(Subsystem&, StateId id)> restore = {};
  std::function<std::vector<std::byte>(Subsystem&, StateId id)> serialize = {};
};

class Faulty final : public Subsystem {
 public:
  explicit Faulty(const Faults& faults) : faults_(faults), info_(sound_.info()) {
    if (faults_.info) faults_.info(info_);
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t, double t_stop, std::span<const double> u0, Samples& y) override {
    return faults_.initialize ? faults_.initialize(sound_, u0, y) : sound_.initialize(t, t_stop, u0, y);
  }
  Clock advance(double t, bool land, std::span<const Signal> u, Samples& y) override {
    return faults_.advance ? faults_.advance(sound_, t, land, u, y) : sound_.advance(t, land, u, y);
  }
  StateId save_state() override { return sound_.save_state(); }
  Clock restore_state(StateId id) override {
    return faults_.restore ? faults_.restore(sound_, id) : sound_.restore_state(id);
  }
  void release_state(StateId id) override { sound_.release_state(id); }
  std::vector<std::byte> serialize_state(StateId id) override {
    return faults_.serialize ? faults_.serialize(sound_, id) : sound_.serialize_state(id);
  }
  StateId deserialize_state(std::span<const std::byte> bytes) override {
    return sound_.deserialize_state(bytes);
  }

 private:
  FixedStep<Sum> sound_{Sum()};
  Faults faults_;
  SubsystemInfo info_;
};

/// The sentences found of one check, which must hold these words; empty: what it said instead.
std::string found(const Faults& faults, const std::string& of, const std::vector<std::string>& words) {
  std::string all;
  for (const Finding& finding : check([&] { return std::make_unique<Faulty>(faults); })) {
    all += finding.check + ": " + finding.sentence + "\n";
    if (finding.kind != Finding::Kind::wrong || finding.check != of) continue;
    bool fits = true;
    for (const auto& word : words) fits = fits && finding.sentence.find(word) != std::string::npos;
    if (fits) return "";
  }
  return all.empty() ? "nothing" : all;
}

TEST(Check, FindsNothingWhereNothingIsWrong) {
  EXPECT_TRUE(check([] { return std::make_unique<FixedStep<Sum>>(Sum()); }).empty());
}

TEST(Check, FindsPortsThatMakeNoSense) {
  const std::string of = "its ports make sense";
  EXPECT_EQ(found({.info = [](auto& i) { i.inputs[1].name = "u"; }}, of, {"input 'u' is there twice"}), "");
  EXPECT_EQ(found({.info = [](auto& i) { i.feedthrough = {{0, 2}}; }}, of, {"input 2", "below 1 and 2"}), "");
  EXPECT_EQ(found({.info = [](auto& i) { i.outputs[0].derivatives = 4; }}, of, {"4 derivatives", "0 to 3"}),
            "");
}

TEST(Check, FindsStartsThatAreWrong) {
  const auto late = [](Subsystem& s, std::span<const double> u0, Samples& y) {
    return s.initialize(0.5, 9.0, u0, y);
  };
  EXPECT_EQ(found({.initialize = late}, "the start is one sample at t_start", {"t = 0.5 s", "t_start, 0"}),
            "");
  const auto unknown = [](Subsystem& s, std::span<const double> u0, Samples& y) {
    const Clock clock = s.initialize(0.0, 9.0, u0, y);
    y.set_size(y.size() - 1);
    *y.append(0.0) = u0[0];
    return clock;
  };
  EXPECT_EQ(found({.initialize = unknown}, "what no unknown input feeds through to is finite at the start",
                  {"output x", "nan", "finite"}),
            "");
  const auto twice = [](Subsystem& s, std::span<const double> u0, Samples& y) {
    const Clock clock = s.initialize(0.0, 9.0, u0, y);
    if (!y.full()) *y.append(0.0) = 0.0;
    return Clock{clock.time + 1.0, clock.next_time + 1.0, clock.stop};
  };
  EXPECT_EQ(found({.initialize = twice}, "the start is one sample at t_start", {"clock stands at t = 1 s"}),
            "");
}

using Signals = std::span<const Signal>;

TEST(Check, FindsStepsThatAreWrong) {
  const auto far = [](Subsystem& s, double t, bool land, Signals u, Samples& y) {
    return s.advance(t + 0.01, land, u, y);
  };
  EXPECT_EQ(found({.advance = far}, "advance takes all the steps that fit and no other",
                  {"no step past the limit"}),
            "");
  EXPECT_EQ(
      found({.advance = far}, "a step that does not fit is not taken", {"where half a step was allowed"}),
      "");
  const auto lazy = [](Subsystem& s, double t, bool land, Signals u, Samples& y) {
    return s.advance(t - 0.01, land, u, y);
  };
  EXPECT_EQ(found({.advance = lazy}, "advance takes all the steps that fit and no other", {"1000 calls"}),
            "");
  const auto full = [](Subsystem& s, double t, bool land, Signals u, Samples& y) {
    Clock clock = s.advance(t, land, u, y);
    clock.stop = Stop::limit;
    return clock;
  };
  EXPECT_EQ(found({.advance = full}, "it returns early without room and goes on with the same bits",
                  {"another reason to stop", "samples_full"}),
            "");
  const auto thrown = [](Subsystem&, double, bool, Signals, Samples&) -> Clock {
    throw Error(ErrorCode::numerical, "so");
  };
  EXPECT_EQ(found({.advance = thrown}, "times rise", {"it threw: so"}), "");
  const auto misses = [](Subsystem& s, double t, bool, Signals u, Samples& y) {
    return s.advance(t, false, u, y);
  };
  EXPECT_EQ(found({.advance = misses}, "it lands exactly and keeps its grid", {"1000 calls"}), "");
}

TEST(Check, FindsStatesThatAreNotTheSame) {
  const auto moved = [](Subsystem& s, StateId id) {
    const Clock clock = s.restore_state(id);
    std::vector<double> row(3 * 9), zero = {0.0, 0.0};
    const Segment none{1e9, 0.0, {}};
    const Signal u[] = {{&none, 1, 0}, {&none, 1, 0}};
    Samples y(row.data(), 3, 9);
    s.advance(clock.next_time, false, u, y);
    return clock;
  };
  EXPECT_EQ(found({.restore = moved}, "a restored state goes on with the same bits",
                  {"from a state that was saved"}),
            "");
  const auto any = [](Subsystem&, StateId) { return Clock{0.0, 0.01, Stop::limit}; };
  EXPECT_EQ(found({.restore = any}, "a state that is released or was never saved is refused",
                  {"restoring a state that was never saved was done"}),
            "");
}

TEST(Check, FindsBytesThatAreNotTheState) {
  const auto other = [](Subsystem& s, StateId id) {
    auto bytes = s.serialize_state(id);
    bytes[bytes.size() - 1] ^= std::byte{1};  // of the last number's sign and exponent
    return bytes;
  };
  EXPECT_EQ(
      found({.serialize = other}, "a state goes as bytes to another instance and goes on with the same bits",
            {"from the bytes of a state", "to the last bit"}),
      "");
}

TEST(Check, FindsJumpsThatAreNotTwoRows) {
  const std::string of = "a jump is two samples at one time, the second marked";
  const auto alone = [](auto& s, double t, bool, auto u, Samples& y) {
    const std::int64_t first = y.size();
    const Clock clock = s.advance(t, false, u, y);
    if (y.size() > first) y.c_view().rows[first * 3 + 1] = 1.0;
    return clock;
  };
  EXPECT_EQ(found({.advance = alone}, of, {"at t = 0.01 s", "stands alone"}), "");
}

TEST(Check, FindsEventsThatAreNone) {
  const std::string of = "one with events returns at each of them";
  const auto says_so = [](auto& s, double t, bool land, auto u, Samples& y) {
    const Clock clock = s.advance(t, land, u, y);
    return Clock{clock.time, clock.next_time, Stop::event};
  };
  const auto has_events = [](auto& i) { i.abilities.events = true; };
  EXPECT_EQ(found({.info = has_events, .advance = says_so}, of, {"stopped at an event", "is no jump"}), "");
}

/// What one gives depends on whether another is within a call.
TEST(Check, FindsInstancesThatCanNotBeAtWorkAtOnce) {
  const auto shared = std::make_shared<std::atomic<int>>(0);
  const auto busy = [shared](auto& s, double t, bool land, auto u, Samples& y) {
    const int inside = ++*shared;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::int64_t first = y.size();
    const Clock clock = s.advance(t, land, u, y);
    if (inside > 1 && y.size() > first) y.c_view().rows[first * 3 + 2] += 1.0;
    --*shared;
    return clock;
  };
  EXPECT_EQ(found({.advance = busy}, "two instances may be at work at once", {"another"}), "");
}

TEST(Check, LeavesOutWhatASubsystemSaysItCanNot) {
  const Faults less{.info = [](auto& i) { i.abilities = {}; }};
  const auto findings = check([&] { return std::make_unique<Faulty>(less); });
  int left_out = 0;
  for (const Finding& f : findings) left_out += f.kind == Finding::Kind::left_out ? 1 : 0;
  EXPECT_EQ(left_out, 5);
  ASSERT_EQ(findings.size(), 7U) << "it saves states though it says that it can't";
  EXPECT_NE(findings[3].sentence.find("save_state without the ability"), std::string::npos)
      << findings[3].sentence;
}

/// It takes no notice of them at all.
TEST(Check, FindsInputsThatDoNotReact) {
  const Faults says{.info = [](auto& i) { i.abilities.reactive_inputs = true; }};
  EXPECT_EQ(found(says, "states of a reaction are integrated along", {"z0' = 1", "t = 0.01 s", "0.51"}), "");
  EXPECT_EQ(found(says, "a reaction follows the outputs", {"z0' = its first output"}), "");
  EXPECT_EQ(found(says, "an answer is a part of its input", {"with an answer of 0.5"}), "");
  const Faults alone{.info = [](auto& i) { i.abilities.reactive_inputs = true, i.inputs.clear(); }};
  const auto findings =
      check("a reaction follows the outputs", [&] { return std::make_unique<Faulty>(alone); });
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_NE(findings[0].sentence.find("its inputs may react, and has none"), std::string::npos);
}

/// z' = 1, but from one call to the next it goes on from what it has itself.
TEST(Check, FindsAReactionThatIsKept) {
  auto z = std::make_shared<double>(0.0);
  const auto keeps = [z](Subsystem& s, double t, bool land, Signals u, Samples& y) {
    const std::int64_t first = y.size();
    const Clock clock = s.advance(t, land, u, y);
    for (std::int64_t row = first; reaction_of(u) && row < y.size(); ++row) {
      double* const end = y.rows() + y.stride() * (row + 1);
      end[-2] = end[-1] = *z += 0.01;
    }
    return clock;
  };
  const Faults faults{.info = [](auto& i) { i.abilities.reactive_inputs = true; }, .advance = keeps};
  EXPECT_EQ(found(faults, "nothing of a reaction is kept between calls", {"step by step", "to the last bit"}),
            "");
}

TEST(Check, TakesInputsAndOneCheckByItsName) {
  const auto open = [] { return std::make_unique<FixedStep<Sum>>(Sum()); };
  EXPECT_TRUE(check("times rise", open, {1e4, {3.0, std::numeric_limits<double>::quiet_NaN()}}).empty());
  ASSERT_EQ(check("times rise", open, {0.0, {3.0}}).size(), 1U);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'times ris'", "times rise"},
                            [&] { check("times ris", open); }));
}

}  // namespace
}  // namespace tandem
