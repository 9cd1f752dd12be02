// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tandem/scenario/comparison.hpp"
#include "tandem/text/expression.hpp"
#include "tandem/text/place.hpp"
#include "tandem/text/set_value.hpp"

namespace tandem::study {

using text::FileValue;
using text::FileValues;
using text::Place;

/// An expression of columns (and of metrics, where it says so).
struct Formula {
  std::string text;
  Place place;
};

/// What something is set to: a value, or a text of columns: "$NAME", "$(EXPRESSION)", or with "${NAME}" within.
struct Given {
  std::string name;  ///< a key of the scenario, or a column
  text::SetValue value;
  Place place;

  /// The columns that it stands for.
  std::vector<std::string> columns() const;
  /// With the values of columns. Throws Error with the place.
  text::SetValue with(const FileValues& columns) const;
};

/// A number that a row tells of its run.
struct Metric {
  enum class Kind {
    output,     ///< A norm of an output's difference from a reference, or of the output itself.
    signal,     ///< A norm of an expression over time.
    drift,      ///< The same of its departure from its start.
    order,      ///< The log2 of the ratio of a metric to what it is with all own steps halved.
    formula,    ///< Of other metrics and columns.
    exchanges,  ///< Calls of subsystems, all together.
    steps,      ///< Own steps of a subsystem.
    seconds,    ///< Wall time of the rounds, and processor time as NAME.processor.
    share,      ///< Part of the wall time inside a subsystem.
    real_time,  ///< Simulated time divided by wall time.
    stability,  ///< Of the map of a super-step (tandem::stability): `of` says what.
    coded,      ///< By a CodedMetric.
    defect,     ///< The largest defect of an input (tandem::Indicators).
    energy,     ///< That the coupling made on a link.
  };
  enum class Norm { max, rms, end, least, most };
  /// An output of a reference, and what an expression calls it: OUTPUT.REFERENCE.
  struct Referred {
    std::string name, output, reference;
  };
  enum class Relative { no, peak, rms, start };
  std::string name;
  Kind kind;
  std::string of =
      {};  ///< the output, the subsystem, the metric, the name of the coded one, or what of stability
  std::string against = {};  ///< a reference; empty: none
  std::string state =
      {};  ///< of stability: the mode in which it takes part most; empty: the one farthest off
  Norm norm = Norm::max;
  Relative relative = Relative::no;
  scenario::Measure window = {};
  std::string unit = {};                            ///< that the number is told in; empty: that of the output
  std::optional<Formula> formula = {}, scale = {};  ///< formula: of a signal and a drift too
  std::vector<std::string> outputs = {};            ///< of the run; of an expression its columns too
  std::vector<Referred> referred = {};
  std::vector<Given> with = {};          ///< parameters of a coded one
  std::optional<double> otherwise = {};  ///< what it is where it is not known
  int repetitions = 1;                   ///< of which a time is the least
  Place place = {};

  void of_reference(const std::string& reference, const std::string& output) {
    against = reference, referred = {{output, output, reference}};
  }
  bool is_over_time() const { return kind == Kind::signal || kind == Kind::drift; }
  bool is_indicator() const { return kind == Kind::defect || kind == Kind::energy; }
  /// Whether it is not the same each time.
  bool is_time() const { return kind == Kind::seconds || kind == Kind::share || kind == Kind::real_time; }
};

}  // namespace tandem::study
