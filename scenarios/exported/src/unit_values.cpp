// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/exported/unit.hpp"

// Variables by number.
namespace tandem::exported {

using Kind = Variable::Kind;

[[noreturn]] static void refuse_value(const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, sentence);
}

const Variable& Unit::variable(std::size_t reference) const {
  if (reference < variables_.size()) return variables_[reference];
  refuse_value(fmt::format("there is no variable of value reference {}; allowed are 0 to {}", reference,
                           variables_.size() - 1));
}

const Variable& Unit::of_kind(std::size_t reference, Kind kind, const char* wanted) const {
  const Variable& v = variable(reference);
  if (v.kind != kind) refuse_value(fmt::format("variable '{}' is no {}", v.name, wanted));
  return v;
}

std::vector<std::string> Unit::allowed_words(std::size_t reference) const {
  const Variable& v = variable(reference);
  if (v.kind != Kind::word) return {};
  return parameters_[static_cast<std::size_t>(v.index)].allowed;
}

void Unit::set_span(double start, double stop) {
  if (begun_) throw Error(ErrorCode::wrong_state, "start and stop are given after the start was made");
  if (!std::isfinite(start) || std::isnan(stop) || stop <= start)
    refuse_value(fmt::format("the start is at {} s, the stop at {} s; allowed is a stop after a finite start",
                             start, stop));
  start_ = time_ = start, stop_ = stop, fresh_ = false;
}

void Unit::set(std::size_t reference, double value) {
  const Variable& v = variable(reference);
  if (!std::isfinite(value))
    refuse_value(
        fmt::format("variable '{}' at t = {} s is {}; allowed is a finite number", v.name, time_, value));
  if (v.kind == Kind::number) return change(v, value);
  inputs_.set(of_kind(reference, Kind::input, "input or parameter that is a number").index, value);
  fresh_ = fresh_ && begun_;
  inputs_set_ = true;
  input_set(v);
}

void Unit::set(std::size_t reference, const std::string& word) {
  change(of_kind(reference, Kind::word, "parameter that is a text"), word);
}

void Unit::set(std::size_t reference, bool flag) {
  const Variable& v = of_kind(reference, Kind::extrapolate, "Boolean");
  check_not_begun(v);
  inputs_.extrapolate(flag);
}

void Unit::check_not_begun(const Variable& v) const {
  if (begun_)
    refuse_value(fmt::format("parameter '{}' is set at t = {} s; allowed is to set it before the start",
                             v.name, time_));
}

void Unit::change(const Variable& v, Parameters::Value value) {
  check_not_begun(v);
  changed_[v.parameter] = std::move(value);
  parameters_ = file_parameters();
  subsystem_.reset();
  fresh_ = false;
}

double Unit::number(std::size_t reference) {
  const Variable& v = variable(reference);
  switch (v.kind) {
    case Kind::time:
      return time_;
    case Kind::input:
      return inputs_.value(v.index);
    case Kind::number:
      return std::get<double>(parameters_[static_cast<std::size_t>(v.index)].value);
    case Kind::word:
    case Kind::extrapolate:
      refuse_value(fmt::format("variable '{}' is no number", v.name));
    default:
      start();
      return output(v);
  }
}

std::string Unit::word(std::size_t reference) const {
  const Variable& v = of_kind(reference, Kind::word, "parameter that is a text");
  return std::get<std::string>(parameters_[static_cast<std::size_t>(v.index)].value);
}

bool Unit::flag(std::size_t reference) const {
  of_kind(reference, Kind::extrapolate, "Boolean");
  return inputs_.extrapolates();
}

}  // namespace tandem::exported
