// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/error.hpp"

#include <new>
#include <system_error>

namespace tandem {

std::string sentence_of(const std::exception& exception) {
  if (dynamic_cast<const std::bad_alloc*>(&exception)) return "there is no memory for it";
  if (const auto* error = dynamic_cast<const std::system_error*>(&exception)) return error->code().message();
  return exception.what();
}

}  // namespace tandem
