// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tandem/engine/compiled_block.hpp"

namespace tandem::engine {

/// Where a block's port gets its value: a signal by its name ("block", "block.port" or a diagram's input), or
/// a number.
using Wire = std::variant<std::string, double>;

/// What stands at a key of a block: a number, a text (a signal's name or a word), true or false, an array.
using Value = std::variant<double, std::string, bool, std::vector<Wire>>;

struct Description;

/// A block by its kind (docs/diagrams.md has all), with its ports' sources and its parameters by key.
struct Block {
  std::string name, kind;
  std::map<std::string, Value> values = {};
  std::string where = {};                          ///< file and line, or nothing
  std::map<std::string, std::string> places = {};  ///< the same by key

  /// Of a key, or of the block.
  const std::string& place(const std::string& key) const {
    const auto it = places.find(key);
    return it == places.end() ? where : it->second;
  }
  /// Tables, and arrays of them, at a key: each like a block of its own.
  std::map<std::string, std::vector<Block>> tables = {};
  /// The one that stands in this block, of kind diagram or triggered.
  std::shared_ptr<const Description> diagram = {};
};

/// A number, or a text: a word of a block, the file of a diagram in one.
using ParameterValue = std::variant<double, std::string>;

struct Parameter {
  std::string name, unit;  ///< a text has no unit
  ParameterValue value;
};

struct Input {
  std::string name, unit;
  std::string where = {};
};

struct Output {
  std::string name, unit;
  Wire from;
  std::string where = {};
};

/// Values of a signal between which a diagram is believed, and what happens where the signal leaves them.
/// That instant is located as an event: the run ends with the sentence, or it is told once and the run goes
/// on.
struct Limit {
  enum class OnLeaving { ignore, warn, stop };
  std::string name;
  Wire signal;
  double low, high;      ///< low < high; one of them may be infinite
  std::string sentence;  ///< why: "the torque is no measured one there"
  OnLeaving on_leaving = OnLeaving::warn;
  std::string where = {};
};

/// What is done about algebraic loops, and how: KINSOL stops where each signal at which a loop is cut stays
/// as it is to this tolerance, relative, or absolute where it is below 1.
struct LoopSettings {
  bool solve = false;  ///< if not, they are refused
  double tolerance = 1e-12;
  int most_iterations = 50;
  std::map<std::string, double> guess = {};  ///< signals at which loops are cut, with where to begin
  std::string where = {};
};

/// A block diagram as written down: nothing is sorted or checked yet. From a file: read_diagram().
struct Description {
  std::string name;
  std::vector<Parameter> parameters;  ///< whose values stand in the blocks already
  std::vector<Input> inputs;
  std::vector<Block> blocks;
  std::vector<Output> outputs;
  std::vector<Limit> limits = {};
  std::vector<CompiledBlock> kinds = {};  ///< of blocks, beside those that there are; of the whole diagram
  LoopSettings loops = {};                ///< of the whole diagram, those in blocks with it
  std::filesystem::path folder = {};      ///< that files are named from; empty: the working folder
};

}  // namespace tandem::engine
