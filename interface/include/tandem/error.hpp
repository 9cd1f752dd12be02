// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>
#include <string>

namespace tandem {

/// What kind of mistake an Error reports. The same numbers cross the C interface and the wire
/// (tandem_status).
enum class ErrorCode {
  invalid_argument = 1,  ///< A value that the caller gave: port, unit, step, parameter.
  not_supported = 2,     ///< Asked for something that the subsystem or scheme has not.
  wrong_state = 3,       ///< A call out of order.
  numerical = 4,         ///< The integration failed: not finite, no convergence, no progress.
  input_output = 5,      ///< A file or a stream.
  internal = 6,          ///< Anything else.
};

/// Thrown for a caller's mistake or a failed run. what() is one sentence that names subsystem, port and time
/// where they matter, the value found and the values allowed.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

/// A file that is written has no room: the disk is full, or the file is as large as files may be.
class NoRoom final : public Error {
 public:
  explicit NoRoom(const std::string& sentence) : Error(ErrorCode::input_output, sentence) {}
};

/// What an exception says, in words that a user of the library understands: "there is no memory for it".
std::string sentence_of(const std::exception& exception);

}  // namespace tandem
