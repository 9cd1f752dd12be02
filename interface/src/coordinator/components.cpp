// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/components.hpp"

#include <algorithm>
#include <cstddef>

namespace tandem {
namespace {

/// Depth-first, with a path of its own in place of calls: chains are thousands long.
class Components {
 public:
  Components(int nodes, const std::vector<std::pair<int, int>>& edges)
      : to_(static_cast<std::size_t>(nodes)), nodes_(static_cast<std::size_t>(nodes)) {
    for (const auto& [from, to] : edges) to_[static_cast<std::size_t>(from)].push_back(to);
  }

  std::vector<int> find() {
    for (std::size_t root = 0; root < nodes_.size(); ++root)
      if (nodes_[root].number == 0) visit(static_cast<int>(root));
    std::vector<int> of;
    for (const Node& node : nodes_) of.push_back(node.component);
    return of;
  }

 private:
  struct Node {
    int number = 0;  ///< in the order of visits, from 1
    int lowest = 0;  ///< that can be reached
    int component = -1;
    std::size_t edge = 0;  ///< the next to be followed
  };
  Node& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }

  void enter(int node) {
    at(node).number = at(node).lowest = ++visited_;
    path_.push_back(node);
    open_.push_back(node);
  }

  void visit(int root) {
    enter(root);
    while (!path_.empty()) {
      const int node = path_.back();
      const auto& edges = to_[static_cast<std::size_t>(node)];
      if (at(node).edge == edges.size()) {
        leave(node);
        continue;
      }
      const int next = edges[at(node).edge++];
      if (at(next).number == 0)
        enter(next);
      else if (at(next).component < 0)
        at(node).lowest = std::min(at(node).lowest, at(next).number);
    }
  }

  void leave(int node) {
    path_.pop_back();
    if (!path_.empty()) at(path_.back()).lowest = std::min(at(path_.back()).lowest, at(node).lowest);
    if (at(node).lowest != at(node).number) return;
    for (int last = -1; last != node; open_.pop_back()) at(last = open_.back()).component = components_;
    ++components_;
  }

  std::vector<std::vector<int>> to_;
  std::vector<Node> nodes_;
  std::vector<int> path_, open_;
  int visited_ = 0, components_ = 0;
};

}  // namespace

std::vector<int> strongly_connected(int nodes, const std::vector<std::pair<int, int>>& edges) {
  return Components(nodes, edges).find();
}

}  // namespace tandem
