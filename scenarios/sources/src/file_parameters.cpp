// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/file_parameters.hpp"

#include <algorithm>

namespace tandem {
namespace {

text::FileValue value(Parameters& p, const text::FileParameter& parameter) {
  if (const auto* number = std::get_if<double>(&parameter.value)) return p.number(parameter.name, *number);
  return p.text(parameter.name, std::get<std::string>(parameter.value));
}

void refuse_setting(const text::FileParameter& parameter, const Words& settings) {
  const auto is_it = [&](const Word& word) { return stands_for(word.name, parameter.name); };
  if (text::is_of_run(parameter.name) || std::ranges::any_of(settings, is_it))
    text::refuse(parameter.place, "parameter '" + parameter.name +
                                      "' has the name of a setting; allowed is a name of its own");
}

}  // namespace

text::Values file_values(const text::Document& document, Parameters& p) {
  return text::values_in_run(
      document, [&](const text::FileParameter& parameter) -> std::optional<text::FileValue> {
        p.declare({{parameter.name, Setter::client}});
        return p.has(parameter.name) ? std::optional(value(p, parameter)) : std::nullopt;
      });
}

text::GivenValues take_file_parameters(const text::Document& document, const Words& settings, Parameters& p) {
  return text::given_values(document,
                            [&](const text::FileParameter& parameter) -> std::optional<text::FileValue> {
                              if (!settings.empty()) refuse_setting(parameter, settings);
                              p.declare({{parameter.name, Setter::client}});
                              const bool is_given = p.has(parameter.name);
                              const text::FileValue now = value(p, parameter);
                              return is_given ? std::optional(now) : std::nullopt;
                            });
}

void refuse_words_of_clients(const text::Document& document, const text::GivenValues& given,
                             const Parameters& p) {
  for (const text::FileParameter& parameter : text::parameters_of(document, given))
    if (const auto* word = std::get_if<std::string>(&parameter.value);
        word && p.from_client(parameter.name) && !parameter.allowed_word)
      text::refuse(parameter.place,
                   "parameter '" + parameter.name + "' is '" + *word +
                       "'; allowed from a client is the word that stands here, or one that is allowed "
                       "by a list");
}

}  // namespace tandem
