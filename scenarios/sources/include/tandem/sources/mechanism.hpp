// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/sources/source_file.hpp"
#include "tandem/transports/open.hpp"

namespace tandem {

/// Times [s] from a text with commas between them, in rising order. Throws Error for what is none, which
/// begins with `name`.
std::vector<double> matrix_times(const std::string& name, const std::string& text);

/// A mechanism's file as a subsystem. Parameters:
/// - `step` [s];
/// - `formulation` and `integrator` by name, and the settings of the two that are chosen, by the names of
///   StepperSettings;
/// - `animate`, which adds an output for each coordinate of each point and of vectors that move
///   (`tandem view` draws them);
/// - `accelerances`, "x.by.F,..": adds outputs that tell what an input of 1 accelerates at a displacement, where
///   only forces follow the input (impulse couplings ask for them);
/// - `matrices`, a folder for the matrices of steps;
/// - `matrices_at` (times [s] with commas between; by default the start) and `matrices_format` (mtx, ccs).
///
/// What is not given is taken from the file's table [run], else by default; `step` must be given.
/// - kinds: of elements, besides those that are built in.
/// - tell: takes what a limit of the file tells.
std::unique_ptr<Subsystem> make_mechanism(const SourceFile& file, Parameters& parameters,
                                          const mbs::ElementKinds& kinds = {},
                                          const mbs::TellOfLimit& tell = {});

/// What a file describes with these parameters and those of its table [run]; the others stay untaken. Throws
/// Error for what is wrong with it.
mbs::Description describe_mechanism(const SourceFile& file, Parameters& parameters,
                                    const mbs::ElementKinds& kinds = {});

/// "mechanism:FILE". The files that matrices are written to are the operator's alone.
Source mechanism_source(const mbs::ElementKinds& kinds = {}, const mbs::TellOfLimit& tell = {});

/// The same sources; their mechanisms write no matrices, whatever is said.
Builtins without_matrices(Builtins builtins);

}  // namespace tandem
