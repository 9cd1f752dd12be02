// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/time_series.hpp"

#include <algorithm>
#include <cmath>

#include "number_text.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

/// Second derivatives of the natural cubic spline at its points: continuous slopes within, none at the ends
/// (C. de Boor, A Practical Guide to Splines, 1978, ch. IV). A tridiagonal system, by elimination.
std::vector<double> bends(std::span<const double> t, std::span<const double> y) {
  const std::size_t last = t.size() - 1;
  std::vector<double> bend(t.size()), pivot(t.size()), right(t.size());
  for (std::size_t k = 1; k < last; ++k) {
    const double before = t[k] - t[k - 1], after = t[k + 1] - t[k];
    pivot[k] = 2.0 * (before + after);
    right[k] = 6.0 * ((y[k + 1] - y[k]) / after - (y[k] - y[k - 1]) / before);
    if (k == 1) continue;
    pivot[k] -= before * before / pivot[k - 1];
    right[k] -= before / pivot[k - 1] * right[k - 1];
  }
  for (std::size_t k = last - 1; k > 0; --k)
    bend[k] = (right[k] - (t[k + 1] - t[k]) * bend[k + 1]) / pivot[k];
  return bend;
}

double slope_at_end(const Segment& s) { return Signal(&s, 1, TANDEM_MAX_COEFFICIENTS - 1).derivative(s.end); }

}  // namespace

TimeSeries::TimeSeries(std::string name, Points times, Points values, How how)
    : name_(std::move(name)),
      degree_(how.between == Between::spline ? 3
              : how.between == Between::hold ? 0
                                             : 1) {
  check(times, values, how.between);
  const double first = times.front(), last = times.back();
  if (how.beyond == Beyond::hold)
    add({first, first, {values.front()}}, false, true);
  else
    begin_ = first, end_ = last;
  join(times, values, how.between);
  const double before = value_before(times, values, times.size() - 1);
  if (how.beyond == Beyond::hold || before != values.back())
    add({end_, last, {values.back()}}, before != values.back(), false);
}

void TimeSeries::check(Points t, Points y, Between between) const {
  const auto refuse = [this](const std::string& what) {
    throw Error(ErrorCode::invalid_argument, name_ + " " + what);
  };
  if (t.size() != y.size())
    refuse("has " + std::to_string(t.size()) + " times and " + std::to_string(y.size()) +
           " values; allowed are as many");
  if (t.size() < 2) refuse("has " + std::to_string(t.size()) + " points; allowed are 2 or more");
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (!std::isfinite(t[k]) || !std::isfinite(y[k]))
      refuse("holds " + number_text(std::isfinite(t[k]) ? y[k] : t[k]) + "; allowed are finite numbers");
    if (k == 0) continue;
    if (t[k] < t[k - 1])
      refuse("has the time " + number_text(t[k]) + " s after " + number_text(t[k - 1]) +
             " s; allowed are times that never fall");
    if (t[k] == t[k - 1] && between == Between::spline)
      refuse("has the time " + number_text(t[k]) +
             " s twice, which is a jump; allowed for a spline are times that rise");
    if (k > 1 && t[k] == t[k - 2])
      refuse("has the time " + number_text(t[k]) + " s three times; allowed is once, or twice for a jump");
  }
  if (t.front() == t.back()) refuse("has one time; allowed are two or more");
}

/// The pieces between the points.
void TimeSeries::join(Points t, Points y, Between between) {
  const std::vector<double> bend = between == Between::spline ? bends(t, y) : std::vector<double>(t.size());
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    if (t[k] == t[k + 1]) continue;
    const double h = t[k + 1] - t[k], slope = (y[k + 1] - y[k]) / h;
    Segment piece{t[k + 1], t[k], {y[k]}};
    if (between != Between::hold) piece.c[1] = slope - h * (2.0 * bend[k] + bend[k + 1]) / 6.0;
    piece.c[2] = bend[k] / 2.0;
    piece.c[3] = (bend[k + 1] - bend[k]) / (6.0 * h);
    add(piece, value_before(t, y, k) != y[k], between == Between::spline && k > 0);
  }
}

/// The value to which the pieces before point k lead.
double TimeSeries::value_before(Points t, Points y, std::size_t k) const {
  if (degree_ == 0 && !pieces_.empty()) return pieces_.back().c[0];
  return k > 0 && t[k] == t[k - 1] ? y[k - 1] : y[k];
}

/// smooth: the slope is that of the piece before but for rounding.
void TimeSeries::add(const Segment& piece, bool jumps, bool smooth) {
  if (pieces_.empty()) return pieces_.push_back(piece);
  if (jumps)
    jumps_.push_back(piece.origin), runs_.push_back(pieces_.size());
  else if (!smooth && slope_at_end(pieces_.back()) != piece.c[1])
    kinks_.push_back(piece.origin);
  pieces_.push_back(piece);
  mark_jump(pieces_.back(), jumps);
}

/// The last of some pieces that has begun at t, else the first.
static const Segment& begun(std::span<const Segment> pieces, double t) {
  const auto after = std::upper_bound(pieces.begin() + 1, pieces.end(), t,
                                      [](double time, const Segment& s) { return time < s.origin; });
  return *(after - 1);
}

const Segment& TimeSeries::piece(double t) const { return begun(pieces_, t); }

double TimeSeries::value(std::size_t run, double t) const {
  const std::size_t first = runs_[run], end = run + 1 < runs_.size() ? runs_[run + 1] : pieces_.size();
  return polynomial(begun(std::span(pieces_).subspan(first, end - first), t), t);
}

void TimeSeries::require(double t) const {
  const TimeTolerance tolerance;
  if (!tolerance.before(t, begin_) && !tolerance.before(end_, t)) return;
  throw Error(ErrorCode::numerical, name_ + " is asked for at t = " + number_text(t) +
                                        " s; it has data from " + number_text(begin_) + " to " +
                                        number_text(end_) +
                                        " s, and beyond = \"refuse\" says that nothing is known there");
}

}  // namespace tandem
