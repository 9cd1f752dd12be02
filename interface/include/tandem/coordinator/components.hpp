// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

namespace tandem {

/// The strongly connected components of a directed graph: by node a number, the same for two nodes if and
/// only if each can be reached from the other along the edges (from, to). R. Tarjan, SIAM J. Comput. 1 (1972)
/// 146.
std::vector<int> strongly_connected(int nodes, const std::vector<std::pair<int, int>>& edges);

}  // namespace tandem
