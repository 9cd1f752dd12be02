// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/file_parameters.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// What "$NAME" stands for in its table [run], with the parameters that are given.
text::Values file_values(const text::Document& document, Parameters& p);

/// Values in `p` of the parameters that a mechanism's or diagram's file declares, which are a client's to
/// give.
/// - settings: the words of its source, of which no parameter may have the name: one value would be both.
text::GivenValues take_file_parameters(const text::Document& document, const Words& settings, Parameters& p);

/// Refuses a client's word that the file does not have or allow, as it may name a file.
void refuse_words_of_clients(const text::Document& document, const text::GivenValues& given,
                             const Parameters& p);

}  // namespace tandem
