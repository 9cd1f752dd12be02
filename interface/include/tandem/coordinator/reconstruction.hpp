// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace tandem {

/// How the samples of an output become a function of time for its reader.
struct Reconstruction {
  enum class Kind {
    lagrange,  ///< Polynomial through the newest degree + 1 samples; interpolates where samples cover the
               ///< span.
    hermite,   ///< Cubic through the values and derivatives of two samples.
    mean,      ///< Mean of the source's samples within the reader's own step, constant over that step.
    least_squares,  ///< Polynomial fitted to the newest degree + 1 + extra samples.
    matched_hold,   ///< The newest sample, constant over the whole call.
    held,           ///< Of a held output: each sample from its time on, to the next.
    taylor,         ///< The newest sample's parabola, by its first two derivatives; no word of scenarios.
  };
  Kind kind = Kind::lagrange;
  int degree = 0;  ///< lagrange: 0 to 4; least_squares: 0 to 4; else 0
  int extra = 0;   ///< least_squares: samples beyond degree + 1, 1 to 16; else 0

  /// From "lagrange0" .. "lagrange4", "hermite", "mean", "least_squaresD_EXTRA", "matched_hold".
  /// Throws Error(invalid_argument) that lists these for any other text. (Of what is held, and taylor, there is none.)
  static Reconstruction parse(std::string_view text);
  /// The words that parse() takes, without the family `least_squares`, whose words match least_squares_words.
  static const std::vector<std::string>& words();
  static constexpr const char* least_squares_words = "least_squares[0-4]_([1-9]|1[0-6])";
  /// The text that parse() takes.
  std::string name() const;

  /// Makes segments from the samples alone, whoever reads them (all but mean and matched_hold).
  bool follows_samples() const { return kind != Kind::mean && kind != Kind::matched_hold; }
  /// Samples that one segment is made of.
  int samples() const;
  /// Degree of the polynomial in a segment.
  int polynomial_degree() const;
  /// Output derivatives that each sample must carry.
  int derivatives_read() const { return kind == Kind::taylor ? 2 : kind == Kind::hermite ? 1 : 0; }
  /// Output derivatives at the start from which past samples can be made by a Taylor expansion so that the
  /// order of the scheme is kept: degree - 1 (hermite: 2). 0 where a cold start costs no order.
  int derivatives_at_start() const;

  bool operator==(const Reconstruction&) const = default;
};

}  // namespace tandem
