// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/key_list.hpp"

namespace tandem::text {

KeyList& KeyList::table(std::string path, std::string sentence, bool required) {
  const auto type = path.ends_with("[]") ? Key::Type::tables : Key::Type::table;
  if (!path.starts_with(with_kinds_ + ".")) kinds_.clear();
  keys_.push_back(
      {.path = path, .type = type, .sentence = std::move(sentence), .required = required, .kinds = kinds_});
  table_ = std::move(path);
  return *this;
}

KeyList& KeyList::or_numbers() {
  keys_.back().type = Key::Type::numbers_or_table;
  return *this;
}

KeyList& KeyList::named(const std::string& path, std::string sentence, std::string of_each, bool required) {
  table(path, std::move(sentence), required).table(path + ".NAME", std::move(of_each));
  with_kinds_ = table_;
  return *this;
}

KeyList& KeyList::by_kind() {
  with_kinds_ = table_;
  return *this;
}

KeyList& KeyList::kind(std::string word, std::string sentence) {
  kinds_ = {std::move(word)};
  table_ = with_kinds_;
  const auto type = table_.ends_with("[]") ? Key::Type::tables : Key::Type::table;
  keys_.push_back({.path = table_, .type = type, .sentence = std::move(sentence), .kinds = kinds_});
  return *this;
}

KeyList& KeyList::may(const std::string& name, Key::Type type, std::string sentence, KeyDetails details) {
  keys_.push_back({.path = table_.empty() ? name : table_ + "." + name,
                   .type = type,
                   .sentence = std::move(sentence),
                   .unit = std::move(details.unit),
                   .otherwise = std::move(details.otherwise),
                   .allowed = std::move(details.allowed),
                   .words = std::move(details.words),
                   .pattern = std::move(details.pattern),
                   .also = details.also,
                   .kinds = table_ == with_kinds_ ? kinds_ : std::vector<std::string>{}});
  return *this;
}

KeyList& KeyList::need(const std::string& name, Key::Type type, std::string sentence, KeyDetails details) {
  may(name, type, std::move(sentence), std::move(details));
  keys_.back().required = true;
  return *this;
}

}  // namespace tandem::text
