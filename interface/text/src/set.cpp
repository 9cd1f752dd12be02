// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/text/document.hpp"
#include "tandem/text/nesting.hpp"

namespace tandem::text {
namespace {

[[noreturn]] void refuse_setting(const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, sentence);
}

/// A key, or what stands in brackets.
struct Step {
  std::string text;
  bool bracket;
};
using Steps = std::vector<Step>;

Steps split(const std::string& path) {
  Steps steps;
  std::size_t i = 0;
  while (i < path.size()) {
    if (path[i] == '[') {
      const auto end = end_of_bracket(path, i);
      if (end == std::string::npos) refuse_setting("'" + path + "' has a '[' without ']'");
      steps.push_back({path.substr(i + 1, end - i - 1), true});
      i = end + 1;
    } else if (path[i] == '"') {
      const auto end = path.find('"', i + 1);
      if (end == std::string::npos) refuse_setting("'" + path + "' has a '\"' without another");
      steps.push_back({path.substr(i + 1, end - i - 1), false});
      i = end + 1;
    } else {
      const auto end = std::min(path.find_first_of(".[", i), path.size());
      steps.push_back({path.substr(i, end - i), false});
      i = end;
    }
    if (steps.back().text.empty())
      refuse_setting("'" + path + "' has an empty part; allowed is a path like coordination.schedule");
    if (i < path.size() && path[i] == '.' && ++i == path.size())
      refuse_setting("'" + path + "' ends with a '.'");
  }
  if (steps.empty() || steps[0].bracket)
    refuse_setting("'" + path + "' names no key; allowed is a path like coordination.schedule");
  return steps;
}

}  // namespace

std::size_t end_of_bracket(std::string_view path, std::size_t at) {
  for (int depth = 0; at < path.size(); ++at) {
    depth += (path[at] == '[') - (path[at] == ']');
    if (depth == 0) return at;
  }
  return path.npos;
}

namespace {

/// Where the key ends: at the first '=' that no quotation marks are about.
std::size_t end_of_key(const std::string& text) {
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"') quoted = !quoted;
    if (text[k] == '=' && !quoted) return k;
  }
  return text.find('=');
}

/// One override: the path is walked from the root; what it ends at is replaced or added.
class Override {
 public:
  explicit Override(const std::string& text) : source_(set_prefix + text) {
    const auto equals = end_of_key(text);
    if (equals == std::string::npos || equals == 0)
      refuse_setting("'" + text + "' is not of the form KEY=VALUE");
    steps_ = split(text.substr(0, equals));
    value_ = text.substr(equals + 1);
    if (steps_.size() > deepest_nesting) refuse_setting("'" + printable(text, 60) + "': " + too_deep);
    value_ = toml_value(value_);
  }
  Override(const std::string& path, const SetValue& value)
      : source_(set_prefix + override_of(path, value)), steps_(split(path)) {
    if (const auto* number = std::get_if<double>(&value))
      value_ = "0.0", number_ = *number;
    else if (const auto* flag = std::get_if<bool>(&value))
      value_ = *flag ? "true" : "false";
    else
      value_ = toml_text(std::get<std::string>(value));
  }

  void apply(toml::table& root) { at_table(root, 0); }

 private:
  /// `steps_[first..] = value_` as a table of its own, which knows where it came from.
  toml::table parsed(std::size_t first) const {
    std::string key;
    for (std::size_t i = first; i < steps_.size(); ++i) {
      if (steps_[i].bracket)
        refuse_setting("'" + written(i) + "' is not there, so it has no [" + steps_[i].text + "]");
      key += (i > first ? "." : "") + toml_text(steps_[i].text);
    }
    try {
      toml::table made = toml::parse(std::string_view(key + " = " + value_), std::string_view(source_));
      toml::node* innermost = &made;
      for (std::size_t i = first; i < steps_.size(); ++i)
        innermost = innermost->as_table()->get(steps_[i].text);
      put_number(*innermost);
      return made;
    } catch (const toml::parse_error& error) {
      refuse_setting("not TOML: " + std::string(error.description()));
    }
  }

  /// The number itself, never its text.
  void put_number(toml::node& node) const {
    if (number_) node.as_floating_point()->get() = *number_;
  }

  /// The path up to a step, as it was given.
  std::string written(std::size_t end) const {
    std::string text;
    for (std::size_t i = 0; i < end; ++i)
      text += steps_[i].bracket ? "[" + steps_[i].text + "]" : (i > 0 ? "." : "") + steps_[i].text;
    return text;
  }

  void at_table(toml::table& table, std::size_t i) {
    const Step& step = steps_[i];
    if (step.bracket) refuse_setting("'" + written(i) + "' is a table; it has no [" + step.text + "]");
    toml::node* node = table.get(step.text);
    if (!node && i > 0 && i + 1 < steps_.size() && holds_tables_alone(table)) refuse_new(table, i);
    if (node && i + 1 < steps_.size()) return go_on(*node, i + 1);
    toml::table made = parsed(i);
    if (i == 2 && steps_[0].text == "subsystems") leave_one_origin(table, step.text);
    made.get(step.text)->visit([&](auto& value) { table.insert_or_assign(step.text, std::move(value)); });
  }

  /// As [subsystems] and [rods] do, by name.
  static bool holds_tables_alone(const toml::table& table) {
    return !table.empty() &&
           std::all_of(table.begin(), table.end(), [](const auto& entry) { return entry.second.is_table(); });
  }

  [[noreturn]] void refuse_new(const toml::table& table, std::size_t i) const {
    refuse_setting(unknown("table of [" + written(i) + "]", steps_[i].text, keys(table)) +
                   "; a new one is set as a whole, " + written(i + 1) + "={..}");
  }

  /// A source takes the place of a command, and the other way round.
  static void leave_one_origin(toml::table& subsystem, const std::string& key) {
    if (key == "source") subsystem.erase("command");
    if (key == "command") subsystem.erase("source");
  }

  void go_on(toml::node& node, std::size_t i) {
    if (auto* table = node.as_table()) return at_table(*table, i);
    if (auto* array = node.as_array())
      return array->is_array_of_tables() ? at_tables(*array, i) : at_values(*array, i);
    refuse_setting("'" + written(i) + "' is " + described(node) + "; it has no '" + steps_[i].text + "'");
  }

  void at_tables(toml::array& array, std::size_t i) {
    const bool all = !steps_[i].bracket;
    const std::size_t next = all ? i : i + 1;
    if (next == steps_.size())
      refuse_setting("'" + written(i + 1) + "' is a table; name one of its keys, as in " + written(i + 1) +
                     ".KEY");
    std::vector<std::string> names;
    bool found = false;
    const bool some_only = all && steps_[next].text == "reconstruction" && has(array, "reconstruction");
    for (std::size_t k = 0; k < array.size(); ++k) {
      const std::string name = (*array[k].as_table())["to"].value_or(std::string());
      names.push_back(name);
      if (!all && steps_[i].text != name && steps_[i].text != std::to_string(k)) continue;
      if (some_only && !array[k].as_table()->contains("reconstruction")) continue;  // of a held output
      at_table(*array[k].as_table(), next);
      found = true;
    }
    if (!found) fail_no_element(i, names);
  }

  static bool has(const toml::array& array, std::string_view key) {
    return std::any_of(array.begin(), array.end(),
                       [key](const toml::node& node) { return node.as_table()->contains(key); });
  }

  [[noreturn]] void fail_no_element(std::size_t i, const std::vector<std::string>& names) const {
    std::vector<std::string> numbered;
    for (std::size_t k = 0; k < names.size(); ++k)
      numbered.push_back(std::to_string(k) + " (" + names[k] + ")");
    const std::string near = nearest(steps_[i].text, names);
    refuse_setting("'" + written(i) + "' has no [" + steps_[i].text + "]" +
                   (near.empty() ? "." : "; did you mean [" + near + "]?") +
                   " There are: " + listed(numbered));
  }

  void at_values(toml::array& array, std::size_t i) {
    std::size_t index = array.size();
    const std::string& text = steps_[i].text;
    std::from_chars(text.data(), text.data() + text.size(), index);
    if (!steps_[i].bracket || std::to_string(index) != text || index >= array.size() || i + 1 < steps_.size())
      refuse_setting("'" + written(i) + "' is an array of " + std::to_string(array.size()) + "; '" + text +
                     "' is not one of its elements, which are named like " + written(i) + "[0]");
    toml::table made = toml::parse(std::string_view("v = " + value_), std::string_view(source_));
    put_number(*made.get("v"));
    made.get("v")->visit([&](auto& value) {
      array.replace(array.cbegin() + static_cast<std::ptrdiff_t>(index), std::move(value));
    });
  }

  std::string source_, value_;
  Steps steps_;
  std::optional<double> number_ = {};  ///< the value, where it is one and not a text
};

}  // namespace

std::string toml_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text)
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (const auto byte = static_cast<unsigned char>(c); byte < 0x20 || byte == 0x7f)
      out += fmt::format("\\u{:04x}", byte);
    else
      out += c;
  return out + "\"";
}

std::string toml_value(const std::string& text) {
  if (deeper_than("v = " + text, deepest_nesting) > 0)
    refuse_setting("'" + printable(text, 60) + "': " + too_deep);
  try {
    if (toml::parse(std::string_view("v = " + text)).size() == 1) return text;
  } catch (const toml::parse_error&) {  // a text, then
  }
  return toml_text(text);
}

std::string override_of(const std::string& path, const SetValue& value) {
  return path + "=" + std::visit([](const auto& one) { return fmt::format("{}", one); }, value);
}

void set(toml::table& file, const std::string& override_text) { Override(override_text).apply(file); }
void set(toml::table& file, const std::string& path, const SetValue& value) {
  Override(path, value).apply(file);
}

}  // namespace tandem::text
