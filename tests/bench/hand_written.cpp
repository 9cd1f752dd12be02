// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/hand_written.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "bench/bench.hpp"
#include "four_bar/linkage.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {
namespace {

constexpr int most_repetitions = 300;
constexpr double hand_step = 1.25e-3;

/// The linkage in one form, where it starts.
struct Form {
  mbs::Model& model;
  mbs::State first;
};

/// So many that they take about a millisecond.
int steps_of(const Form& f) { return std::clamp(20'000 / f.model.structure().variables, 20, 400); }

template <class Work>
double seconds_of(int count, const Work& work) {
  const auto began = std::chrono::steady_clock::now();
  for (int k = 1; k <= count; ++k) work(k);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / count;
}

/// Takes steps with the settings of `tandem bench four_bar`.
class Steps {
 public:
  Steps(const Form& form, const std::string& solver)
      : form_(form), stepper_(form.model, {.penalty = 1e8, .tolerance = 1e-5, .solver = solver}) {}
  double seconds() {
    mbs::State s = form_.first;
    stepper_.start(s);
    return seconds_of(steps_of(form_), [&](int k) { stepper_.step(s, hand_step, hand_step * k); });
  }

 private:
  const Form& form_;
  mbs::Index3 stepper_;
};

/// What each of Newton's iterations asks of a model.
class Terms {
 public:
  explicit Terms(const Form& form)
      : form_(form),
        jacobian_(form.model.structure().jacobian_values()),
        phi_(form.model.structure().constraints),
        force_(form.model.structure().variables) {}
  double seconds() {
    const mbs::State& s = form_.first;
    return seconds_of(10 * steps_of(form_), [&](int) {
      form_.model.constraints(s.q.data(), phi_.data(), jacobian_.data());
      form_.model.forces(s.q.data(), s.v.data(), force_.data());
      benchmark::ClobberMemory();
    });
  }

 private:
  const Form& form_;
  Eigen::VectorXd jacobian_, phi_, force_;
};

/// The least times of both, taken in turn: what else runs on the machine slows both, and some pieces not at
/// all.
template <class Timed>
void add_forms(Table& table, const std::string& what, Timed general, Timed own, int variables) {
  double least = 1e300, least_own = 1e300;
  for (int r = 0; r < most_repetitions; ++r) {
    least = std::min(least, general.seconds());
    least_own = std::min(least_own, own.seconds());
  }
  table.add({what, std::to_string(variables / 2 - 1), std::to_string(variables),
             fmt::format("{:.2f}", 1e9 * least / variables),
             fmt::format("{:.2f}", 1e9 * least_own / variables), fmt::format("{:.3f}", least / least_own)});
}

}  // namespace

Table hand_written_linkage() {
  Table table({"what", "loops", "variables", "general_ns", "hand_written_ns", "ratio"});
  for (const int loops : {5, 40, 500}) {
    mbs::Mechanism mechanism(mbs::read_mechanism("four_bar", four_bar::text(loops)));
    four_bar::HandWritten hand_written(loops);
    const Form general{mechanism, mechanism.described_state()}, own{hand_written, hand_written.first_state()};
    const int variables = mechanism.structure().variables;
    for (const std::string solver : {"auto", "klu"})
      add_forms(table, "step with " + solver, Steps(general, solver), Steps(own, solver), variables);
    add_forms(table, "terms", Terms(general), Terms(own), variables);
  }
  return table;
}

}  // namespace tandem::bench
