// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Declared parameters and nominal values in the codec: whole, not right, and with a side that does not speak
// of them.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "refusal.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::wire {
namespace {

using test::refuses;
using Bytes = std::vector<std::byte>;
constexpr ErrorCode code = ErrorCode::invalid_argument;

/// What such a call puts into a payload.
Bytes payload_of(const std::function<void(Writer&)>& put) {
  Writer frame;
  put(frame);
  return {frame.bytes().begin(), frame.bytes().end()};
}

const DeclaredParameters two = {{"m", "kg", {}, "mass"}, {"file", {}, "a b", ""}};

Bytes hello_of(const DeclaredParameters& declared) {
  return payload_of([&](Writer& w) { put_hello(w, {.text = "tandem", .declared = declared}); });
}
DeclaredParameters read(const Bytes& hello) { return *read_hello(hello, all_capabilities).declared; }

TEST(WireDeclared, CrossesTheWireWhole) {
  const auto back = read(hello_of(two));
  ASSERT_EQ(back.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(back[k].name, two[k].name);
    EXPECT_EQ(back[k].unit, two[k].unit);
    EXPECT_EQ(back[k].otherwise, two[k].otherwise);
    EXPECT_EQ(back[k].sentence, two[k].sentence);
  }
}

TEST(WireDeclared, IsRefusedCutAnywhereAndWithMoreBehindIt) {
  Bytes hello = hello_of(two);
  for (std::size_t size = 0; size < hello.size(); ++size)
    EXPECT_TRUE(refuses(code, {"the message 'hello'"}, [&] {
      read_hello(std::span(hello).first(size), all_capabilities);
    })) << size;
  hello.push_back(std::byte{0});
  EXPECT_TRUE(refuses(code, {"1 bytes more"}, [&] { read(hello); }));
}

/// The hello with another number there, counted from the number of parameters on.
Bytes with(std::size_t place, std::uint32_t value) {
  Bytes hello = hello_of(two);
  const std::size_t begin = hello_of({}).size() - 4 + place;
  const auto number = to_wire(value);
  std::copy(number.begin(), number.end(), hello.begin() + static_cast<std::ptrdiff_t>(begin));
  return hello;
}

TEST(WireDeclared, CountsLengthsAndKindsAreCheckedBeforeAnythingIsAllocated) {
  EXPECT_TRUE(refuses(code, {"announces 4294967295 things"}, [] { read(with(0, 0xffffffffU)); }));
  EXPECT_TRUE(refuses(code, {"4 for the kind of a parameter; allowed are 0 to 3"}, [] { read(with(4, 4)); }));
  EXPECT_TRUE(refuses(code, {"a text of 4097 bytes"}, [] { read(with(8, 4097)); }));
  const DeclaredParameters many(most_parameters + 1, {"m", "kg", {}, ""});
  EXPECT_TRUE(
      refuses(code, {"declares 4097 parameters; allowed are up to 4096"}, [&] { read(hello_of(many)); }));
}

TEST(WireDeclared, WhatMakesNoSenseIsRefused) {
  const auto reading = [](const DeclaredParameters& declared) { return [=] { read(hello_of(declared)); }; };
  EXPECT_TRUE(refuses(code, {"'m' is declared twice"}, reading({{"m", "kg", {}, ""}, {"m", "1", {}, ""}})));
  EXPECT_TRUE(refuses(code, {"the name 'a=b'"}, reading({{"a=b", "kg", {}, ""}})));
  EXPECT_TRUE(refuses(code, {"the name ''"}, reading({{"", "kg", {}, ""}})));
  for (const char* none : {"heavy", "", "1 ", "nan", "inf"})
    EXPECT_TRUE(refuses(code, {"'m' is declared to be '", "allowed is a finite number in kg"},
                        reading({{"m", "kg", none, ""}})))
        << none;
}

/// Of a server that was written before them, and of a request.
TEST(WireDeclared, NothingIsReadWhereOneSideDoesNotSpeakOfThem) {
  const Bytes before =
      payload_of([](Writer& w) { put_hello(w, {.capabilities = carries_held, .text = "before"}); });
  EXPECT_FALSE(read_hello(before, all_capabilities).declared);
  const Bytes request = payload_of([](Writer& w) { put_hello(w, {.text = "m=2"}); });
  EXPECT_FALSE(read_hello(request).declared);
}

TEST(WireDeclared, ComesWithTheErrorOfAHello) {
  const Bytes whole = payload_of([](Writer& w) { put_error(w, NotMade(Error(code, "m is needed"), two)); });
  const Bytes alone = payload_of([](Writer& w) { put_error(w, code, "m is needed"); });
  for (const Bytes& error : {whole, alone}) {
    DeclaredParameters declared;
    EXPECT_EQ(read_error(error, declared).what(), std::string("m is needed"));
    EXPECT_EQ(declared.size(), error == whole ? 2U : 0U);
  }
  for (std::size_t size = alone.size() + 1; size < whole.size(); ++size) {
    DeclaredParameters declared;
    EXPECT_TRUE(refuses(code, {"the message 'error'"}, [&] {
      read_error(std::span(whole).first(size), declared);
    })) << size;
  }
}

SubsystemInfo mass2(double nominal) {
  SubsystemInfo info{"mass2", {}, {{"x2", "m"}}, {}, {}};
  info.outputs[0].nominal = nominal;
  return info;
}

TEST(WireNominal, CrossesTheWireWhereBothSpeakOfIt) {
  for (const std::uint32_t both : {all_capabilities, carries_held}) {
    const Bytes info = payload_of([&](Writer& w) { put_info(w, mass2(7.0), both); });
    EXPECT_EQ(read_info(info, both).outputs[0].nominal, both == carries_held ? 1.0 : 7.0);
  }
}

TEST(WireNominal, IsANumberAbove0) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double none : {0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(refuses(code, {"output 'x2' has the nominal value", "allowed is a number above 0"}, [&] {
      read_info(payload_of([&](Writer& w) { put_info(w, mass2(none)); }));
    })) << none;
}

}  // namespace
}  // namespace tandem::wire
