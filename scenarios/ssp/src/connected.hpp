// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "document.hpp"
#include "structure.hpp"

namespace tandem::ssp {

/// Adds a connection between connectors of a system and of what is directly in it. line: that it is to have.
void add_connection(const Document& document, xml_node connection, int line, int system, Structure& to);

/// Gives an element, and what is in it, the values of the parameter bindings of `of`. Called for an inner
/// element before an outer one, whose values hold then (SSP 1.0, section 5.2.3). line: that they are to have;
/// 0: their own. Values that nothing takes are remarked.
void apply_bindings(const Document& document, xml_node of, int line, int element, Structure& to);

}  // namespace tandem::ssp
