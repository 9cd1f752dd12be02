// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "norm_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tandem::study {
namespace {

const char* norm(const Metric& metric) {
  switch (metric.norm) {
    case Metric::Norm::max:
      return "largest magnitude";
    case Metric::Norm::rms:
      return "rms";
    case Metric::Norm::least:
      return "least value";
    case Metric::Norm::most:
      return "largest value";
    case Metric::Norm::end:
      break;
  }
  return "last magnitude";
}

std::string divided(const Metric& metric) {
  switch (metric.relative) {
    case Metric::Relative::peak:
      return ", divided by its peak";
    case Metric::Relative::rms:
      return ", divided by its rms";
    case Metric::Relative::start:
      return ", divided by its start";
    case Metric::Relative::no:
      break;
  }
  return "";
}

std::string window(const Metric& metric) {
  const auto& [from, to] = std::tie(metric.window.from, metric.window.to);
  return (std::isfinite(from) ? fmt::format(", from {} s", from) : "") +
         (std::isfinite(to) ? fmt::format(", to {} s", to) : "");
}

}  // namespace

std::string norm_text(const Metric& metric) {
  std::string text;
  if (metric.kind == Metric::Kind::output && metric.against.empty())
    text = fmt::format("{} of {}", norm(metric), metric.of);
  else if (metric.kind == Metric::Kind::output)
    text = fmt::format("{} of {} - {}", norm(metric), metric.of, metric.against);
  else if (metric.kind == Metric::Kind::signal)
    text = fmt::format("{} of {}", norm(metric), metric.formula->text);
  else if (metric.kind == Metric::Kind::drift)
    text = fmt::format("{} of the departure from its start", norm(metric));
  else if (metric.kind == Metric::Kind::order)
    text = fmt::format("order of {}, with half the steps", metric.of);
  else if (metric.kind == Metric::Kind::formula)
    text = metric.formula->text;
  else if (metric.kind == Metric::Kind::stability)
    text = "of the map of a super-step";
  else if (metric.kind == Metric::Kind::coded)
    text = metric.of;
  else if (metric.kind == Metric::Kind::defect)
    text = "largest defect of " + metric.of;
  else if (metric.kind == Metric::Kind::energy)
    text = "energy that the coupling made on " + metric.of;
  else
    return "";
  text += divided(metric) + window(metric);
  return metric.scale ? text + ", times " + metric.scale->text : text;
}

}  // namespace tandem::study
