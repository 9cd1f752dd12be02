// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/functions/octave_struct.hpp"

#include <fmt/format.h>

#include <algorithm>


#include "tandem/nearest.hpp"

namespace tandem::mbs {

const char* const octave_functions = R"octave(
function [message, values] = tandem_evaluate (f, varargin)
  message = "";
  values = [];
  try
    values = f (varargin{:});
    if (! (isnumeric (values) || islogical (values)))
      error ("its value is a %s; allowed is a real matrix", class (values));
    elseif (! isreal (values))
      error ("its value is complex; allowed is a real matrix");
    elseif (ndims (values) > 2)
      error ("its value has %d dimensions; allowed is a matrix", ndims (values));
    end
    values = full (double (values));
  catch failure
    message = strrep (failure.message, "\n", " ");
  end
end
)octave";

void OctaveStruct::refuse(const std::string& what, ErrorCode code) const {
  throw Error(code, fmt::format("model '{}' in Octave: {}", info_.name, what));
}

void OctaveStruct::check(const std::string& what, Shape allowed) const {
  if (values_.rows != allowed.rows || values_.columns != allowed.columns)
    refuse(fmt::format("{} is {} x {}; allowed is {} x {}", what, values_.rows, values_.columns, allowed.rows,
                       allowed.columns));
}

void OctaveStruct::evaluate(Term term, double t, const double* q, const double* v, std::span<double> values) {
  const std::string what =
      term == Term::mass ? std::string("mass") : fmt::format("{} at t = {} s", name(term), t);
  call(term, what, t, q, v, values_);
  check(what, shape(term, info_));
  std::copy(values_.numbers.begin(), values_.numbers.end(), values.begin());
}

void OctaveStruct::take_info() {
  take_fields();
  take_variables();
  take_start("q", info_.q);
  take_start("v", info_.v);
  call(Term::constraints, "constraints at t = 0 s", 0.0, info_.q.data(), nullptr, values_);
  info_.constraints = values_.rows;
}

void OctaveStruct::take_fields() {
  std::vector<std::string> allowed = {"variables", "q", "v", "units"};
  for (const Term term : terms) allowed.emplace_back(name(term));
  const std::vector<std::string> found = fields();
  const auto has = [&](std::string_view field) {
    return std::find(found.begin(), found.end(), field) != found.end();
  };
  for (const std::string& field : found)
    if (std::find(allowed.begin(), allowed.end(), field) == allowed.end())
      refuse(unknown("field", field, allowed));
  for (const Term term : terms) info_.present[static_cast<std::size_t>(term)] = has(name(term));
  has_units_ = has("units");
  for (const std::string& field : allowed) {
    const bool optional = field == "units" || std::any_of(terms.begin(), terms.end(), [&](Term term) {
                            return field == name(term) && may_be_absent(term);
                          });
    if (!optional && !has(field)) refuse("its struct lacks the field '" + field + "'");
  }
}

void OctaveStruct::take_variables() {
  info_.variables = texts("variables");
  if (info_.variables.empty()) refuse("variables names none; allowed is one or more");
  info_.units.assign(info_.variables.size(), "m");
  if (has_units_) info_.units = texts("units");
  if (info_.units.size() != info_.variables.size())
    refuse(fmt::format("units has {} texts; allowed is {}, one of each variable", info_.units.size(),
                       info_.variables.size()));
}

void OctaveStruct::take_start(const std::string& field, Eigen::VectorXd& vector) {
  constant(field, values_);
  check(field, {info_.size(), 1});
  vector = Eigen::Map<const Eigen::VectorXd>(values_.numbers.data(), info_.size());
}

}  // namespace tandem::mbs
