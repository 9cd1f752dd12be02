// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/npy.hpp"

#include <gtest/gtest.h>

#include <random>

#include "refusal.hpp"

namespace tandem {
namespace {

using test::refuses;

NpyHead read(const std::string& bytes) { return read_npy_head(std::as_bytes(std::span(bytes))); }

TEST(Npy, AHeadIsReadBack) {
  const std::vector<std::string> names{"time", "fast.x[1]", "it's \\ that", "Drehmoment_ä"};
  for (const std::uint64_t rows : {0ULL, 7ULL, 18446744073709551615ULL}) {
    const std::string bytes = npy_head(names, rows);
    EXPECT_EQ(bytes.size() % 64, 0U);
    EXPECT_EQ(bytes.size(), npy_head(names, 0).size());
    const NpyHead head = read(bytes);
    EXPECT_EQ(head.names, names);
    EXPECT_EQ(head.rows, rows);
    EXPECT_EQ(head.size, bytes.size());
  }
}

/// As numpy 1.24 writes numpy.zeros(3, [('time', '<f8'), ('x', '<f8')]).
TEST(Npy, AHeadOfNumpysIsRead) {
  const std::string text =
      "{'descr': [('time', '<f8'), ('x', '<f8')], 'fortran_order': False, 'shape': (3,), }";
  std::string bytes = "\x93NUMPY";
  bytes += {'\x01', '\0', static_cast<char>(text.size() + 1), '\0'};
  const NpyHead head = read(bytes + text + "\n");
  EXPECT_EQ(head.names, (std::vector<std::string>{"time", "x"}));
  EXPECT_EQ(head.rows, 3U);
  EXPECT_EQ(head.size, 10 + text.size() + 1);
}

TEST(Npy, WhatIsNoTableOfNumbersIsRefused) {
  const std::string good = npy_head({"time", "x"}, 3);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    return read(bytes.replace(bytes.find(from), from.size(), to));
  };
  const ErrorCode code = ErrorCode::input_output;
  EXPECT_TRUE(refuses(code, {"does not begin"}, [] { read("time,x\n0,1\n"); }));
  EXPECT_TRUE(refuses(code, {"does not begin"}, [] { read(""); }));
  EXPECT_TRUE(refuses(code, {"version 9", "1 to 3"}, [&] { with("\x03", "\x09"); }));
  EXPECT_TRUE(refuses(code, {"cut off"}, [&] { read(good.substr(0, 50)); }));
  EXPECT_TRUE(refuses(code, {"column 2", "<f8"}, [&] { with("'x', '<f8'", "'x', '<f4'"); }));
  EXPECT_TRUE(refuses(code, {"False"}, [&] { with("False", "True "); }));
}

TEST(Npy, AnyBytesAreAHeadOrAnError) {
  std::mt19937 random(5);
  const std::string good = npy_head({"time", "x"}, 3);
  for (int k = 0; k < 20000; ++k) {
    std::string bytes = good;
    for (int change = 0; change < 3; ++change) bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      const NpyHead head = read(bytes);
      EXPECT_LE(head.size, bytes.size());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::input_output);
    }
  }
}

}  // namespace
}  // namespace tandem
