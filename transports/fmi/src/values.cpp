// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

/// Variables that may be given a value before the start, by name.
std::map<std::string, int> settable(const Description& d) {
  std::map<std::string, int> all;
  for (int k = 0; k < std::ssize(d.variables); ++k) {
    const Variable& v = d.variables[static_cast<std::size_t>(k)];
    const bool allowed = v.causality == Causality::parameter ||
                         v.causality == Causality::structural_parameter ||
                         (v.start && v.variability != Variability::constant);
    const bool text = v.type == Type::text && v.dimensions.empty();
    if (allowed && (is_number(v.type) || text)) all[v.name] = k;
  }
  return all;
}

void check(const Variable& v, const std::string& word, double value) {
  if (!is_real(v.type) && value != std::round(value))
    refuse(fmt::format("parameter '{}' is {}; allowed is a whole number", word, value));
  if (!(value >= v.min && value <= v.max))
    refuse(fmt::format("parameter '{}' is {}; allowed is a number from {} to {}", word, value, v.min, v.max));
}

/// Of an array: numbers with blanks between.
std::vector<double> elements_of(const Variable& v, const std::string& word, Parameters& p) {
  const std::string text = p.text(word, "");
  std::istringstream words(text);
  std::vector<double> all;
  for (std::string one; words >> one;) {
    double value = 0.0;
    const auto [end, code] = std::from_chars(one.data(), one.data() + one.size(), value);
    if (code != std::errc{} || end != one.data() + one.size()) break;
    all.push_back(value);
  }
  if (!words.eof() || std::ssize(all) != v.size)
    refuse(fmt::format("parameter '{}' is '{}'; allowed are {} numbers with blanks between", word,
                       printable(text, 200), v.size));
  return all;
}

/// Of a boolean true or false.
std::vector<double> numbers_of(const Variable& v, const std::string& word, Parameters& p) {
  const bool flag = v.type == Type::boolean;
  const std::vector<double> all = !v.dimensions.empty() && v.size > 1 ? elements_of(v, word, p)
                                  : flag ? std::vector<double>{p.flag(word, false) ? 1.0 : 0.0}
                                         : std::vector<double>{p.number(word, 0.0)};
  for (const double value : all) check(v, word, value);
  return all;
}

int variable_of(const std::string& name, const std::map<std::string, int>& all) {
  if (const auto it = all.find(name); it != all.end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [one, variable] : all) known.push_back(one);
  refuse_name("parameter set: variable", name, known);
}

}  // namespace

void refuse(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

void refuse_name(const std::string& what, const std::string& name, std::vector<std::string> known) {
  constexpr std::size_t most = 30;
  if (known.size() <= most) refuse(unknown(what, printable(name, 200), known));
  const std::string near = nearest(name, known);
  refuse(what + " '" + printable(name, 200) + "' is not there" +
         (near.empty() ? "" : "; did you mean '" + near + "'?"));
}

/// Sizes of arrays first, as the others go by them.
std::vector<Setting> take_values(Description& d, Parameters& p) {
  const auto all = settable(d);
  std::vector<Setting> values;
  for (const bool sizes : {true, false}) {
    for (const std::string& name : p.names("set.")) {
      const std::string word = "set." + name;
      const int variable = variable_of(name, all);
      Variable& v = d.variables[static_cast<std::size_t>(variable)];
      if ((v.causality == Causality::structural_parameter) != sizes) continue;
      const bool text = v.type == Type::text;
      if (text && p.from_client(word))
        refuse("parameter '" + word +
               "' is a text that comes from a client; only who serves the source may set it");
      values.push_back({variable, {}, text ? p.text(word, "") : ""});
      if (!text) values.back().numbers = numbers_of(v, word, p);
      if (sizes) v.start_values = values.back().numbers;
    }
    if (sizes) set_sizes(d);
  }
  return values;
}

}  // namespace tandem::fmi
