// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tandem/transports/open.hpp"

namespace tandem::identification {

/// What stands for the subsystems of one source.
struct Stand {
  std::string source;     ///< its URI
  bool modelled = false;  ///< a linear model; else it runs itself
  int order = 0;          ///< states of the model
  double residual = 0.0;  ///< what the model leaves of responses
  bool sampled = false;
  std::string why = {};  ///< it runs itself

  /// What is sampled is as good as its model.
  bool is_known() const { return modelled || sampled; }
};

class Known;
struct Kin;

/// Linear models in place of subsystems, each found once for the same source and parameters.
class Models {
 public:
  /// What becomes of what has no model, unless it is sampled: it runs itself, or is refused where it starts.
  enum class Without { runs_itself, refused };
  explicit Models(Without without = Without::runs_itself) : without_(without) {}

  /// The same sources. What they make becomes at its start a linear model (identification/identify.hpp), where three
  /// things hold. It is linear. The model leaves at most `most_residual` of its responses. Alone, with inputs that stay,
  /// both go alike to the end of the run, to `most_apart` of each value's peak. No model have what is sampled, has
  /// events, varies its steps or can't start again, and what no such model tells. This must outlive what they make.
  /// Each source takes one more parameter, step_word: an own step of the model, in place of the subsystem's [s].
  Builtins replacing(Builtins all);
  static constexpr double most_residual = 1e-7, most_apart = 1e-4;
  static constexpr const char* step_word = "model_step";

  /// Of each source with each set of parameters, in the order of their names.
  std::vector<Stand> stands() const;

 private:
  Source replacing(Source source);
  std::shared_ptr<Known> known(const Address& address, const Parameters& parameters);

  const Without without_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Known>> known_;  ///< by source and parameters
  std::map<std::string, std::shared_ptr<Kin>> kin_;      ///< by these, but for own steps
};

}  // namespace tandem::identification
