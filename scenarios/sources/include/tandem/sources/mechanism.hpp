// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/sources/source_file.hpp"
#include "tandem/text/document.hpp"

namespace tandem {

/// What is done with a mechanism that has been read, before it is made.
using LookAtMechanism = std::function<void(const text::Document&, mbs::Description&, Parameters&)>;

/// Times [s] from a text with commas between them, in rising order. Throws Error for what is none, which
/// begins with `name`.
std::vector<double> matrix_times(const std::string& name, const std::string& text);

/// The words of make_mechanism(). The files that matrices are written to are the operator's alone.
Words mechanism_words();

/// A mechanism's file as a subsystem. Parameters: `step` [s], those of a stepper (take_stepper), `matrices`,
/// `matrices_at`, `matrices_format`. What is not given is taken from the file's table [run], else by default;
/// `step` must be given. kinds: of elements, besides those that are built in. tell: takes what
/// a limit of the file tells.
std::unique_ptr<Subsystem> make_mechanism(const SourceFile& file, Parameters& parameters,
                                          const mbs::ElementKinds& kinds = {},
                                          const LookAtMechanism& look = {},
                                          const mbs::TellOfLimit& tell = {});

}  // namespace tandem
