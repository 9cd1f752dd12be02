// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <nlohmann/json.hpp>

#include "tandem/study/ranks.hpp"

namespace tandem::study {

/// What ranks tell each other: an object, as CBOR.
using Told = nlohmann::json;

/// Rank 0's side of a sweep with ranks. At the end, however that comes, it tells the others to end.
class HandOut {
 public:
  explicit HandOut(Ranks& ranks) : ranks_(ranks) {}
  ~HandOut();
  HandOut(const HandOut&) = delete;
  HandOut& operator=(const HandOut&) = delete;

  /// Lets the others do `count` jobs; most: ranks that have one at a time. Where that is more than one, the next
  /// job of a rank waits there already. job: what a rank is told; done: what it has answered. tick: is told now and then how many are done; false ends it. Throws the Error
  /// that a rank has met.
  void each(std::size_t count, unsigned most, const std::function<Told(std::size_t)>& job,
            const std::function<void(std::size_t, const Told&)>& done,
            const std::function<bool(std::size_t)>& tick);
  void tell_all(const Told& what);

 private:
  Ranks& ranks_;
};

/// The side of another rank: does jobs until rank 0 says that it is the end. work: answers a job, with null where
/// there is none, and throws Error where its `going` says no. An Error goes to rank 0.
void work_for(Ranks& ranks, const std::function<Told(const Told&, const std::function<bool()>&)>& work,
              const std::function<bool()>& going);

}  // namespace tandem::study
