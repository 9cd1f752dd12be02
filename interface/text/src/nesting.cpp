// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/nesting.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace tandem::text {
namespace {

/// Counts what a TOML parser would go down, without going down. Strings and comments are passed over.
class Nesting {
 public:
  Nesting(std::string_view text, int most) : text_(text), most_(most) {}

  int first_too_deep() {
    for (; place_ < text_.size(); ++place_) {
      take(text_[place_]);
      if (header_ + inside_ + key_ + dots_ > most_) return line_;
    }
    return 0;
  }

 private:
  void take(char c) {
    if (c == '#') return pass_comment();
    if (c == '"' || c == '\'') return pass_string(c);
    if (c == '\n') return end_line();
    if (c == '.') ++dots_;
    if (c == '=') key_ = dots_ + 1, dots_ = 0, in_header_ = false, begun_ = true;
    if (c == ',') key_ = dots_ = 0;
    if (c == '[' || c == '{') open(c);
    if (c == ']' || c == '}') close();
    if (c != ' ' && c != '\t') begun_ = true;
  }

  /// A bracket that begins a line outside of values is that of a table's header.
  void open(char c) {
    if (c == '[' && open_.empty() && (!begun_ || in_header_)) {
      header_ = std::exchange(in_header_, true) ? header_ + 1 : 1;
      return;
    }
    open_.push_back(std::max(key_, 1) + dots_);
    inside_ += open_.back();
    key_ = dots_ = 0;
  }

  void close() {
    if (in_header_) header_ += std::exchange(dots_, 0);
    key_ = dots_ = 0;
    if (open_.empty()) return;
    inside_ -= open_.back();
    open_.pop_back();
  }

  void end_line() {
    ++line_;
    if (in_header_) header_ += dots_;
    in_header_ = false;
    dots_ = 0;
    if (open_.empty()) key_ = 0, begun_ = false;
  }

  void pass_comment() { place_ = std::min(text_.find('\n', place_), text_.size()) - 1; }

  /// To its closing quotation mark; one of a single line ends with the line at the latest.
  void pass_string(char quote) {
    begun_ = true;
    const bool lines = text_.substr(place_).starts_with(std::string_view(quote == '"' ? "\"\"\"" : "'''"));
    place_ += lines ? 3 : 1;
    for (int closing = 0; place_ < text_.size(); ++place_) {
      const char c = text_[place_];
      if (c == '\n' && !lines) return void(--place_);
      if (c == '\n') ++line_;
      closing = c == quote ? closing + 1 : 0;
      if (closing == (lines ? 3 : 1)) break;
      if (c == '\\' && quote == '"') pass_escaped();
    }
    for (int more = 0; lines && more < 2 && next_is(quote); ++more) ++place_;
  }

  bool next_is(char c) const { return place_ + 1 < text_.size() && text_[place_ + 1] == c; }

  void pass_escaped() {
    if (++place_ < text_.size() && text_[place_] == '\n') ++line_;
  }

  std::string_view text_;
  int most_;
  std::size_t place_ = 0;
  int line_ = 1;
  int header_ = 0;          ///< of the table that the lines are in
  int inside_ = 0;          ///< of the values that are open
  int key_ = 0, dots_ = 0;  ///< parts of the key before, dots since
  bool in_header_ = false, begun_ = false;
  std::vector<int> open_;  ///< what each bracket added to inside_
};

}  // namespace

int deeper_than(std::string_view toml, int most) { return Nesting(toml, most).first_too_deep(); }

}  // namespace tandem::text
