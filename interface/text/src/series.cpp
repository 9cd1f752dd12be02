// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/series.hpp"

#include <algorithm>
#include <cmath>

#include "tandem/nearest.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::text {
namespace {

/// Its place among those that there are; the language has checked that it is one of them.
template <std::size_t Count>
std::size_t place(const std::array<std::string_view, Count>& words, const std::string& word) {
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

template <std::size_t Count>
std::vector<std::string> texts_of(const std::array<std::string_view, Count>& words) {
  return {words.begin(), words.end()};
}

std::vector<double> numbers(Section& section, const std::string& key) {
  const toml::node* found = section.node(key);
  if (!found) section.missing(key);
  if (!found->is_array()) section.wrong(key, described(*found), "an array of numbers");
  std::vector<double> all;
  for (const toml::node& one : *found->as_array())
    all.push_back(section.number_of(one, section.name(key) + "[" + std::to_string(all.size()) + "]"));
  return all;
}

}  // namespace

void keys_of_joining(KeyList& to, const std::string& beyond) {
  to.may("interpolation", Key::Type::word,
         "How the values are joined: by straight lines, not at all (each holds until the next), or by the "
         "natural cubic spline. A time that is there twice is a jump; a spline has none.",
         {.otherwise = "linear", .words = texts_of(TimeSeries::between_words)})
      .may("beyond", Key::Type::word,
           "Before the first time and after the last: an error, or the first and the last value.",
           {.otherwise = beyond, .words = texts_of(TimeSeries::beyond_words)});
}

void keys_of_series(KeyList& to) {
  to.may("file", Key::Type::text,
         "A CSV file, from the folder of this one: a first row of names, `time` [s] first, then rows of "
         "numbers "
         "whose times never fall.")
      .may("column", Key::Type::text, "The column of the file, by its name.")
      .may("times", Key::Type::vector, "Times, in place of a file.", {.unit = "s"})
      .may("values", Key::Type::vector, "A value for each time.");
  keys_of_joining(to);
}

std::optional<TimeSeries> read_series(Section& section, const std::filesystem::path& folder) {
  const auto file = section.text("file");
  const bool given = section.node("times") != nullptr;
  if (file && given) section.wrong("times", "given beside file", "one of them");
  if (!file) section.leave_out("column", "there is no file");
  if (!given) section.leave_out("values", "there are no times");
  if (!file && !given)
    for (const char* key : {"interpolation", "beyond"})
      section.leave_out(key, "there is no file and there are no times");
  const TimeSeries::How how{
      static_cast<TimeSeries::Between>(place(TimeSeries::between_words, *section.text("interpolation"))),
      static_cast<TimeSeries::Beyond>(place(TimeSeries::beyond_words, *section.text("beyond")))};
  if (file) {
    const std::string column = section.required_text("column");
    return located(section.place("file"), [&] { return column_series(folder / *file, column, how); });
  }
  if (!given) return std::nullopt;
  const auto times = numbers(section, "times"), values = numbers(section, "values");
  return located(section.place("times"), [&] { return TimeSeries(section.path(), times, values, how); });
}

TimeSeries column_series(const std::filesystem::path& file, const std::string& column, TimeSeries::How how) {
  const TimeTable table = TimeTable::read(file);
  const auto found = std::find(table.names.begin(), table.names.end(), column);
  if (found == table.names.end()) refuse({table.file.string()}, unknown("column", column, table.names));
  const auto& values = table.columns[static_cast<std::size_t>(found - table.names.begin())];
  const auto empty = std::find_if(values.begin(), values.end(), [](double v) { return std::isnan(v); });
  if (empty != values.end())
    refuse({table.file.string(), static_cast<int>(empty - values.begin()) + 2},
           "column '" + column + "' is empty; allowed is a finite number in each row");
  return {"column '" + column + "' of " + table.file.string(), table.times, values, how};
}

}  // namespace tandem::text
