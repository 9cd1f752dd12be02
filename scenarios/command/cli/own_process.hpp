// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

namespace tandem::cli {

/// Is told what is about to be done.
using Tell = std::function<void(const std::string&)>;

/// Goes on in a child process, as what `work` calls may crash: that returns, or throws, what the work does.
/// This process ends with the child's status; if a signal has ended it, throws RunFailed with the signal and
/// with what was told last.
void in_own_process(const std::function<void(const Tell&)>& work);

}  // namespace tandem::cli
