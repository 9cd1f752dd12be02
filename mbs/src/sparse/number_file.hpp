// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"

namespace tandem::mbs {

/// A text file read number by number; lines that begin with % are left out. Errors name file and line, but no
/// text of it: it may be none of ours.
class NumberFile {
 public:
  explicit NumberFile(const std::filesystem::path& file) : name_(file.string()), in_(file) {}

  /// The first line as it is.
  std::string first_line() {
    std::string text;
    ++line_;
    in_.line(text);
    return text;
  }

  double number(const std::string& what) { return parse<double>(what, "a finite number"); }
  /// least to most.
  int integer(const std::string& what, int least, int most) {
    const std::string allowed = "an integer from " + std::to_string(least) + " to " + std::to_string(most);
    const int value = parse<int>(what, allowed);
    if (value < least || value > most)
      refuse(what + " is " + std::to_string(value) + "; allowed is " + allowed);
    return value;
  }
  void end() {
    if (next()) refuse("there is more than the numbers of entries says");
  }

  [[noreturn]] void refuse(const std::string& sentence) const {
    const std::string place = line_ > 0 ? name_ + ":" + std::to_string(line_) : name_;
    throw Error(ErrorCode::input_output, place + ": " + sentence);
  }

 private:
  /// To the next word, over lines that have none.
  bool next() {
    while (!(words_ >> word_)) {
      std::string text;
      if (!in_.line(text)) return false;
      ++line_;
      words_ = std::istringstream(text.starts_with('%') ? "" : text);
    }
    return true;
  }

  template <class Value>
  Value parse(const std::string& what, const std::string& allowed) {
    if (!next()) refuse("the file ends where " + what + " should be");
    const char* const begin = word_.data() + (word_.starts_with('+') ? 1 : 0);
    const char* const end = word_.data() + word_.size();
    Value value{};
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(static_cast<double>(value)))
      refuse(what + " is something else; allowed is " + allowed);
    return value;
  }

  std::string name_;
  InputFile in_;
  std::istringstream words_;
  std::string word_;
  int line_ = 0;
};

}  // namespace tandem::mbs
