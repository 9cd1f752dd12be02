// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Replies that no sound subsystem gives: refused with the address, the call and the time, in C++ and in C.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "by_hand.hpp"
#include "masters.hpp"
#include "printable_table.hpp"
#include "refusal.hpp"
#include "tandem/error.hpp"

namespace tandem::test {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// u feeds through to x; y has two elements; both give a derivative.
SubsystemInfo odd_info() {
  return {"odd",
          {{"u", "m", 1, 0, 0.0}},
          {{"x", "m", 1, 1}, {"y", "m/s", 2, 1}},
          {{0, 0}},
          {.saves_state = true}};
}

struct OddRow {
  double t, x, y0 = 0.0, y1 = 0.0, x_dot = 0.0, y1_dot = 0.0;
  double jump = 0.0;
};

ByHand::Answer rows_answer(const std::vector<OddRow>& rows, const Clock& clock) {
  return {wire::Type::samples, [rows, clock](wire::Writer& w) {
            std::vector<double> memory(8 * (rows.size() + 1));
            Samples y(memory.data(), 8, static_cast<std::int64_t>(rows.size() + 1));
            for (const OddRow& row : rows) {
              const double values[] = {row.x, row.y0, row.y1, row.x_dot, 0.0, row.y1_dot};
              std::copy(std::begin(values), std::end(values), y.append(row.t));
              memory[8 * static_cast<std::size_t>(y.size()) - 7] = row.jump;
            }
            wire::put_samples(w, clock, y);
          }};
}

const Clock at_start = {0.0, 0.5, Stop::limit};

class ReplyChecks : public testing::TestWithParam<Master> {
 protected:
  /// What is said of a start and an advance from 0 s to 1 s; "" if all is believed.
  std::string said(const ByHand& server, double u0) {
    std::vector<double> memory(8 * 10);
    Samples y(memory.data(), 8, 10);
    const Segment piece = {1.0, 0.0, {u0}};
    const Signal u(&piece, 1, 0);
    try {
      const auto far = GetParam().open(server.address());
      try {
        far->initialize(0.0, 10.0, {&u0, 1}, y);
        far->advance(1.0, false, {&u, 1}, y);
        return {};
      } catch (const Error& error) {
        EXPECT_THROW(far->advance(1.0, false, {&u, 1}, y), Error) << "it goes on after: " << error.what();
        return error.what();
      }
    } catch (const Error& error) {
      return error.what();
    }
  }

  std::string said_of(const ByHand::Answer& first, const ByHand::Answer& next, double u0 = 0.0) {
    auto answers = opening_answers(odd_info());
    answers.insert(answers.end(), {first, next});
    const ByHand server(std::move(answers));
    return after_address(said(server, u0), server.address());
  }

  std::string said_of_rows(const std::vector<OddRow>& rows, const Clock& clock) {
    return said_of(rows_answer({{0.0, 1.0}}, at_start), rows_answer(rows, clock));
  }
  std::string said_of_start(const std::vector<OddRow>& rows, const Clock& clock, double u0 = 0.0) {
    return said_of(rows_answer(rows, clock), rows_answer({{0.5, 1.0}}, {0.5, 1.5, Stop::limit}), u0);
  }
};

TEST_P(ReplyChecks, WhatIsSoundIsBelieved) {
  EXPECT_EQ(said_of_rows({{0.5, 1.0}, {1.0, 2.0}}, {1.0, 1.5, Stop::limit}), "");
  EXPECT_EQ(said_of_rows({{0.5, 1.0}, {0.5, 2.0, 0, 0, 0, 0, 1.0}}, {0.5, 0.75, Stop::event}), "");
  EXPECT_EQ(said_of_rows({{0.0, 2.0, 0, 0, 0, 0, 1.0}}, {0.0, 0.75, Stop::event}), "") << "a jump at once";
  EXPECT_EQ(said_of_rows({}, {0.0, 0.5, Stop::limit}), "") << "no step fits";
  EXPECT_EQ(said_of_rows({{1.0, 1.0}}, {1.0, not_a_number, Stop::finished}), "");
  EXPECT_EQ(said_of_rows({{std::nextafter(1.0, 2.0), 1.0}}, {std::nextafter(1.0, 2.0), 1.5, Stop::limit}), "")
      << "past the limit by rounding";
}

TEST_P(ReplyChecks, RowsOfAnAdvanceThatAreNotFiniteOrOutOfOrder) {
  const struct {
    std::vector<OddRow> rows;
    Clock clock;
    std::string said;
  } cases[] = {
      {{{0.5, not_a_number}}, {0.5, 1.0, Stop::limit}, "gives x not finite at t = 0.5 s"},
      {{{0.5, 1.0}, {1.0, 1.0, 0.0, -unbounded}},
       {1.0, 1.5, Stop::limit},
       "gives y[1] not finite at t = 1 s"},
      {{{0.5, 1, 0, 0, unbounded}},
       {0.5, 1.0, Stop::limit},
       "gives x (a derivative) not finite at t = 0.5 s"},
      {{{0.5, 1, 0, 0, 0, not_a_number}},
       {0.5, 1.0, Stop::limit},
       "gives y[1] (a derivative) not finite at t = 0.5 s"},
      {{{not_a_number, 1.0}}, {not_a_number, 1.0, Stop::limit}, "has a sample whose time is not finite"},
      {{{unbounded, 1.0}}, {unbounded, unbounded, Stop::limit}, "has a sample whose time is not finite"},
      {{{0.0, 1.0}}, {0.0, 0.5, Stop::limit}, "has a sample at t = 0 s that does not come after t = 0 s"},
      {{{-0.5, 1.0}},
       {-0.5, 0.5, Stop::limit},
       "has a sample at t = -0.5 s that does not come after t = 0 s"},
      {{{0.5, 1.0}, {0.25, 1.0}},
       {0.25, 0.5, Stop::limit},
       "has a sample at t = 0.25 s that does not come after t = 0.5 s"},
      {{{0.5, 1.0}, {0.25, 1.0, 0, 0, 0, 0, 1.0}},
       {0.25, 0.5, Stop::limit},
       "has a sample at t = 0.25 s that does not come after t = 0.5 s"},
      {{{0.5, 1.0}, {1.25, 1.0}},
       {1.25, 1.5, Stop::limit},
       "has a sample at t = 1.25 s, past the limit 1 s"}};
  for (const auto& [rows, clock, sentence] : cases)
    EXPECT_EQ(said_of_rows(rows, clock), "advance at t = 0 s to 1 s: the reply " + sentence);
}

TEST_P(ReplyChecks, AJumpFlagThatIsNeither0Nor1) {
  for (const auto& [flag, text] : {std::pair{2.0, "2"}, {-1.0, "-1"}, {0.5, "0.5"}, {unbounded, "inf"}}) {
    const std::string sentence =
        std::string("the reply gives ") + text + " as the jump flag of its sample at t = ";
    EXPECT_EQ(said_of_rows({{0.25, 1.0}, {0.5, 1.0, 0, 0, 0, 0, flag}}, {0.5, 1.0, Stop::limit}),
              "advance at t = 0 s to 1 s: " + sentence + "0.5 s; allowed is 0 or 1");
    EXPECT_EQ(said_of_start({{0.0, 1.0, 0, 0, 0, 0, flag}}, at_start),
              "initialize at t = 0 s: " + sentence + "0 s; allowed is 0 or 1");
  }
}

/// Bytes behind the sentence, which only an advance may have, and there rows only.
TEST_P(ReplyChecks, AnErrorWithBytesLeftOver) {
  const auto failing = [](int bytes) {
    return ByHand::Answer{wire::Type::error, [bytes](wire::Writer& w) {
                            wire::put_error(w, ErrorCode::numerical, "no");
                            w.put_bytes(std::vector<std::byte>(static_cast<std::size_t>(bytes)));
                          }};
  };
  const auto first = rows_answer({{0.0, 1.0}}, at_start);
  EXPECT_EQ(said_of(first, failing(0)), "advance at t = 0 s to 1 s: no");
  for (const int bytes : {1, 13})
    EXPECT_NE(said_of(first, failing(bytes)).find("the message 'error'"), std::string::npos);
  for (const int bytes : {0, 3}) {
    auto answers = opening_answers(odd_info());
    answers.push_back(failing(bytes));
    const ByHand server(std::move(answers));
    const auto saving = [&] { GetParam().open(server.address())->save_state(); };
    EXPECT_TRUE(bytes ? refuses(ErrorCode::invalid_argument, {"save", "the message 'error'"}, saving)
                      : refuses(ErrorCode::numerical, {"save", "no"}, saving));
  }
}

TEST_P(ReplyChecks, TwoPortsOfOneName) {
  SubsystemInfo info = odd_info();
  info.outputs[1].name = "x";
  const ByHand server(opening_answers(info));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {server.address(), "info", "port 'x'", "twice"},
                      [&] { GetParam().open(server.address()); }));
}

TEST_P(ReplyChecks, AClockThatContradictsTheNewestRow) {
  const struct {
    std::vector<OddRow> rows;
    Clock clock;
    std::string said;
  } cases[] = {
      {{{0.5, 1.0}},
       {0.75, 1.0, Stop::limit},
       "says that it stands at t = 0.75 s, but its newest sample is of 0.5 s"},
      {{{0.5, 1.0}},
       {not_a_number, 1.0, Stop::limit},
       "says that it stands at t = nan s, but its newest sample is of 0.5 s"},
      {{}, {0.5, 1.0, Stop::limit}, "says that it stands at t = 0.5 s, but its newest sample is of 0 s"},
      {{{0.5, 1.0}},
       {0.5, 0.5, Stop::limit},
       "gives 0.5 s as the end of the next own step, which is not later than 0.5 s"},
      {{{0.5, 1.0}},
       {0.5, not_a_number, Stop::limit},
       "gives nan s as the end of the next own step, which is not later than 0.5 s"}};
  for (const auto& [rows, clock, sentence] : cases)
    EXPECT_EQ(said_of_rows(rows, clock), "advance at t = 0 s to 1 s: the reply " + sentence);
}

TEST_P(ReplyChecks, AFirstSampleThatIsNotFiniteThoughNoUnknownInputFeedsThrough) {
  EXPECT_EQ(said_of_start({{0.0, not_a_number}}, at_start, not_a_number), "")
      << "x follows u, which is not known";
  EXPECT_EQ(said_of_start({{0.0, 1, 0, 0, not_a_number, not_a_number}}, at_start, not_a_number), "")
      << "derivatives may not be known yet";
  const std::string where = "initialize at t = 0 s: the reply ";
  EXPECT_EQ(said_of_start({{0.0, not_a_number}}, at_start, 0.0), where + "gives x not finite at the start");
  EXPECT_EQ(said_of_start({{0.0, 1.0, 0.0, unbounded}}, at_start, not_a_number),
            where + "gives y[1] not finite at the start");
  EXPECT_EQ(said_of_start({{0.0, 1, 0, 0, not_a_number}}, at_start),
            where + "gives x (a derivative) not finite at the start");
  EXPECT_EQ(said_of_start({{0.0, 1, 0, 0, 0, unbounded}}, at_start),
            where + "gives y[1] (a derivative) not finite at the start");
  EXPECT_EQ(said_of_start({}, at_start), where + "has no first sample");
  EXPECT_EQ(said_of_start({{0.25, 1.0}}, {0.25, 0.5, Stop::limit}),
            where + "has a sample at t = 0.25 s; allowed is the start, 0 s");
  EXPECT_EQ(said_of_start({{not_a_number, 1.0}}, at_start),
            where + "has a sample at t = nan s; allowed is the start, 0 s");
  EXPECT_EQ(said_of_start({{0.0, 1.0}}, {0.25, 0.5, Stop::limit}),
            where + "says that it stands at t = 0.25 s, but its newest sample is of 0 s");
  EXPECT_EQ(said_of_start({{0.0, 1.0}}, {0.0, 0.0, Stop::limit}),
            where + "gives 0 s as the end of the next own step, which is not later than 0 s");
}

TEST_P(ReplyChecks, AStateIsRestoredToATimeThatIsFinite) {
  const auto restored = [](const Clock& clock) {
    return ByHand::Answer{wire::Type::restore, [clock](wire::Writer& w) { wire::put_clock(w, clock); }};
  };
  const auto restoring = [&](const Clock& clock) {
    auto answers = opening_answers(odd_info());
    answers.push_back(restored(clock));
    const ByHand server(std::move(answers));
    try {
      GetParam().open(server.address())->restore_state(1);
      return std::string();
    } catch (const Error& error) {
      return after_address(error.what(), server.address());
    }
  };
  EXPECT_EQ(restoring({0.5, 1.0, Stop::limit}), "");
  const std::string where = "restore at t = 0 s: the reply ";
  EXPECT_EQ(restoring({not_a_number, 1.0, Stop::limit}), where + "gives a time that is not finite");
  EXPECT_EQ(restoring({0.5, 0.25, Stop::limit}),
            where + "gives 0.25 s as the end of the next own step, which is not later than 0.5 s");
}

/// Those that a port may have: no blank, no bracket, no quote, no comma.
bool may_be_a_name(const std::string& text) { return text.find_first_of("[] \t\n\",") == std::string::npos; }

TEST_P(ReplyChecks, NamesAndUnitsOfAPeerAreShownPrintable) {
  for (const auto& [text, shown] : printable_table()) {
    SubsystemInfo info = odd_info();
    info.name = info.inputs[0].unit = info.outputs[1].unit = text;
    if (may_be_a_name(shown)) info.outputs[0].name = text;
    const ByHand server(opening_answers(info));
    const auto far = GetParam().open(server.address());
    EXPECT_EQ(far->info().name, shown);
    EXPECT_EQ(far->info().inputs[0].unit, shown);
    EXPECT_EQ(far->info().outputs[1].unit, shown);
    EXPECT_EQ(far->info().outputs[0].name, may_be_a_name(shown) ? shown : "x");
  }
}

TEST_P(ReplyChecks, ANameOfControlCharactersIsCutAtTheLengthOfAName) {
  SubsystemInfo info = odd_info();
  info.name = std::string(4096, '\x1b');
  const ByHand server(opening_answers(info));
  const std::string name = GetParam().open(server.address())->info().name;
  EXPECT_EQ(name.size(), 4096U + 3U);
  EXPECT_TRUE(name.starts_with("\\x1b\\x1b") && name.ends_with("\\x1b..."));
}

TEST_P(ReplyChecks, SentencesOfAPeerAreShownPrintableAndCut) {
  for (auto [text, shown] : printable_table()) {
    const bool shown_whole = text.size() > 4;
    if (shown_whole) text += std::string(5000, 'x');
    auto answers = opening_answers(odd_info());
    answers.push_back({wire::Type::error, [text = text](wire::Writer& w) {  // as no server of ours puts it
                         w.put(std::uint32_t{TANDEM_NUMERICAL});
                         w.put_text(text);
                       }});
    const ByHand server(std::move(answers));
    const std::string sentence = after_address(said(server, 0.0), server.address());
    const std::string beginning = "initialize at t = 0 s: " + shown;
    EXPECT_TRUE(sentence.starts_with(beginning)) << sentence;
    EXPECT_EQ(sentence.ends_with("..."), shown_whole) << sentence;
    EXPECT_LT(sentence.size(), 2200U);
  }
}

INSTANTIATE_TEST_SUITE_P(Masters, ReplyChecks, masters, master_name);

}  // namespace
}  // namespace tandem::test
