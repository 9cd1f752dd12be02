// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tandem/engine/compiled_block.hpp"
#include "tandem/engine/exchanged_diagram.hpp"
#include "tandem/sources/source_file.hpp"
#include "tandem/transports/open.hpp"

namespace tandem {

/// Takes a sentence that a diagram tells once: a signal has left its limits.
using TellOfDiagram = std::function<void(const std::string&)>;

/// A diagram's file as a subsystem. Parameters: `step` [s], `integrator`, the settings of the one that is
/// chosen by the names of IntegratorSettings and AdaptiveSettings, and the diagram's own parameters. What is
/// not given is taken from the file's table [run], else by default; `step` must be given. A client of a
/// server may set the diagram's own parameters too, but names files only below the folder of the diagram's
/// file, besides those that stand in it.
/// - kinds: of blocks, besides those that are built in.
std::unique_ptr<Subsystem> make_diagram(const SourceFile& file, Parameters& parameters,
                                        std::vector<engine::CompiledBlock> kinds = {},
                                        const TellOfDiagram& tell = {});

/// What a file describes with these parameters and those of its table [run]; the others stay untaken. Throws
/// Error for what is wrong with it.
engine::Description describe_diagram(const SourceFile& file, Parameters& parameters);

/// The file as a subsystem for an integrator from elsewhere; the settings of integrators say nothing then. Throws as
/// engine::ExchangedDiagram does, too.
std::unique_ptr<engine::ExchangedDiagram> exchanged_diagram(const SourceFile& file, Parameters& parameters,
                                                            const TellOfDiagram& tell = {});

/// "diagram:FILE".
Source diagram_source(const std::vector<engine::CompiledBlock>& kinds = {}, const TellOfDiagram& tell = {});

}  // namespace tandem
