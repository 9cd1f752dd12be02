// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tandem::charts {
namespace {

constexpr double row_height = 0.05;  // of a strip's row, of the height below
constexpr double margin = 0.04;      // beyond what is covered

/// Down to 1, 2 or 5 times a power of ten.
double round_down(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  return value >= 5.0 * decade ? 5.0 * decade : value >= 2.0 * decade ? 2.0 * decade : decade;
}

std::string tic(double at, const std::string& text) { return fmt::format("{} {:g}", quote(text), at); }

}  // namespace

Axis::Axis(char name, bool logarithmic, std::vector<std::string> words)
    : name_(name), logarithmic_(logarithmic && words.empty()), words_(std::move(words)) {
  if (!words_.empty()) low_ = -0.5, high_ = static_cast<double>(words_.size()) - 0.5;
}

void Axis::cover(double value) {
  if (!words_.empty() || !std::isfinite(value) || (logarithmic_ && value <= 0.0)) return;
  low_ = std::min(low_, value), high_ = std::max(high_, value);
}

void Axis::add_strip(int rows, std::optional<double> limit) { strip_rows_ = rows, wanted_limit_ = limit; }

void Axis::close() {
  if (low_ > high_) low_ = logarithmic_ ? 0.1 : 0.0, high_ = 1.0;
  if (wanted_limit_) high_ = *wanted_limit_, low_ = std::min(low_, 0.1 * high_);
  if (logarithmic_) {
    const double room = std::max(1.1, std::pow(high_ / low_, margin));
    low_ = name_ == 'y' ? round_down(low_ / 1.1) : low_ / room;
    if (!wanted_limit_) high_ *= room;
  } else if (words_.empty()) {
    const double room = high_ > low_ ? margin * (high_ - low_) : std::max(1e-9, std::abs(high_));
    low_ -= room;
    if (!wanted_limit_) high_ += room;
  }
  const double part = row_height * strip_rows_ + 0.05;
  limit_ = high_;
  top_ = strip_rows_ == 0 ? high_
         : logarithmic_   ? high_ * std::pow(high_ / low_, part)
                          : high_ + part * (high_ - low_);
}

std::optional<double> Axis::place(double value) const {
  if (!std::isfinite(value) || (logarithmic_ && value < 0.0) || value > high_) return {};
  return logarithmic_ && value < low_ ? low_ : value;
}

double Axis::strip(int row) const {
  const double part = (row + 0.5) / strip_rows_;
  return logarithmic_ ? limit_ * std::pow(top_ / limit_, part) : limit_ + part * (top_ - limit_);
}

std::string Axis::tics_of_words(bool numbers) const {
  std::string all;
  std::size_t longest = 0;
  for (std::size_t k = 0; k < words_.size(); ++k) {
    all += (k == 0 ? "" : ", ") + tic(static_cast<double>(k), numbers ? words_[k] : "");
    longest = std::max(longest, words_[k].size());
  }
  const bool narrow = name_ == 'x' && longest * words_.size() > 40;
  return fmt::format("set {}tics ({}) {} noenhanced", name_, all, narrow ? "rotate by 35 right" : "norotate");
}

/// Powers of ten, each `step`-th of them; all: with 2 and 5 times these.
std::vector<double> Axis::places(bool all, int step) const {
  std::vector<double> places;
  for (int power = static_cast<int>(std::floor(std::log10(low_))); std::pow(10.0, power) <= high();
       power += step)
    for (const double factor : {1.0, 2.0, 5.0})
      if (const double at = factor * std::pow(10.0, power);
          at > low_ * (1.0 - 1e-9) && at < high() * (1.0 + 1e-9) && (all || factor == 1.0))
        places.push_back(at);
  return places;
}

std::string Axis::tics(bool numbers, std::size_t most) const {
  if (!words_.empty()) return tics_of_words(numbers);
  if (!logarithmic_)
    return fmt::format("set {0}tics autofreq norotate; set format {0} '{1}'", name_, numbers ? "%g" : "");
  auto at = places(true, 1);
  for (int step = 1; at.size() > most; ++step) at = places(false, step);
  std::string all;
  for (const double place : at)
    all += (all.empty() ? "" : ", ") + tic(place, numbers ? fmt::format("{:g}", place) : "");
  return fmt::format("set {}tics ({}) norotate", name_, all);
}

double Axis::step() const { return round_down((high_ - low_) / 3.0); }

void Axis::apply(Picture& picture, const std::string& label, bool numbers, std::size_t most) const {
  picture.command(fmt::format("{}set logscale {}; set {}range [{:.12g}:{:.12g}]; set {}label {} noenhanced",
                              logarithmic_ ? "" : "un", name_, name_, low_, top_, name_, quote(label)));
  picture.command(tics(numbers, most));
  if (name_ != 'y') return;
  picture.command(fmt::format("unset object 1; set xtics {}mirror", strip_rows_ > 0 ? "no" : ""));
  if (strip_rows_ > 0)
    picture.command(
        fmt::format("set object 1 rectangle from graph 0, first {:.12g} to graph 1, graph 1 behind fc rgb "
                    "'#E4E4E4' fs solid "
                    "noborder",
                    limit_));
}

}  // namespace tandem::charts
