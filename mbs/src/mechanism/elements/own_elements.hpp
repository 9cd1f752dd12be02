// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem::mbs {

/// drag, rotor and shaft.
ElementKinds own_elements();

std::unique_ptr<ForceElement> make_drag(ElementKeys& keys);
std::unique_ptr<ForceElement> make_rotor(ElementKeys& keys);
std::unique_ptr<ForceElement> make_shaft(ElementKeys& keys);
void keys_of_drag(text::KeyList& to);
void keys_of_rotor(text::KeyList& to);
void keys_of_shaft(text::KeyList& to);

}  // namespace tandem::mbs
