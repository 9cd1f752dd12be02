// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/identification/identify.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

#include "by_states.hpp"
#include "prober.hpp"
#include "realise.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The columns of a model that responses belong to.
struct Seats {
  Responses responses;
  std::vector<Index> of;  ///< the change of each; the baseline comes last and has none
};

/// Those that are not 0, without what outputs follow at once, which leaves its rounding. Of the baseline the differences from step to step: in these
/// e stands alone.
Seats seats(const Runs& runs, const MatrixXd& d, const Eigen::VectorXd& inputs) {
  Seats all;
  const Index length = runs.baseline.cols() - 1;
  const auto add = [&](MatrixXd response, Index change, double size) {
    constexpr double rounding = 1e-13;
    if (!(response.norm() > rounding * size)) return;
    all.responses.push_back(std::move(response)), all.of.push_back(change);
  };
  for (std::size_t k = 0; k < runs.changes.size(); ++k) {
    MatrixXd response = runs.changes[k].rightCols(length);
    const auto input = static_cast<Index>(k) / (all_places + 1),
               place = static_cast<Index>(k) % (all_places + 1);
    const double size = response.norm() + d.col(input).norm();
    if (!runs.sampled && place == all_places - 1) response.col(0) -= d.col(input);
    add(std::move(response), static_cast<Index>(k), size);
  }
  add(runs.baseline.rightCols(length) - runs.baseline.leftCols(length), -1,
      runs.baseline.norm() + (d.cwiseAbs() * inputs.cwiseAbs()).norm());
  return all;
}

LinearModel empty(const Runs& runs, const Wanted& wanted) {
  const Index inputs = static_cast<Index>(wanted.inputs.size()), values = runs.baseline.rows();
  LinearModel model;
  model.inputs = Eigen::Map<const Eigen::VectorXd>(wanted.inputs.data(), inputs);
  model.values = wanted.values;
  model.linear = runs.linear;
  model.d.resize(values, inputs);
  for (Index i = 0; i < inputs; ++i) model.d.col(i) = runs.at_once(i).col(0);
  model.y0 = runs.baseline.col(0);
  model.a.resize(0, 0), model.c.resize(values, 0), model.e.resize(0);
  model.b.resize(0, inputs * all_places), model.s.resize(0, inputs);
  return model;
}

/// States that come to given ones in a step; of several those that outputs tell least of, as what outputs have at the
/// start is taken for what they follow at once.
class Start {
 public:
  explicit Start(const Realisation& of) : c_(of.c), back_(of.a) {
    constexpr double rounding = 1e-9;
    Eigen::FullPivLU<MatrixXd> lu(of.a);
    lu.setThreshold(rounding);
    if (lu.dimensionOfKernel() > 0) lost_ = lu.kernel();
  }
  Eigen::VectorXd before(const Eigen::VectorXd& x1) const {
    const Eigen::VectorXd x = back_.solve(x1);
    if (lost_.cols() == 0) return x;
    return x - lost_ * (c_ * lost_).completeOrthogonalDecomposition().solve(c_ * x);
  }

 private:
  MatrixXd c_, lost_;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> back_;
};

LinearModel model_of(const Runs& runs, const Wanted& wanted) {
  LinearModel model = empty(runs, wanted);
  const Seats all = seats(runs, model.d, model.inputs);
  if (all.responses.empty()) return model;
  const Realisation r = realise(all.responses);
  const Index n = r.a.rows();
  model.a = r.a, model.c = r.c, model.residual = r.residual;
  model.e.setZero(n), model.b.setZero(n, model.b.cols()), model.s.setZero(n, model.s.cols());
  const Start start(r);
  for (std::size_t k = 0; k < all.of.size(); ++k) {
    const auto x1 = r.x1.col(static_cast<Index>(k));
    if (all.of[k] < 0)
      model.e = x1;
    else if (const Index input = all.of[k] / (all_places + 1), place = all.of[k] % (all_places + 1);
             place < all_places)
      model.b.col(input * all_places + place) = x1;
    else
      model.s.col(input) = start.before(x1);
  }
  if (!runs.sampled) model.d -= model.c * model.s;
  return model;
}

bool stays(const LinearModel& before, const LinearModel& now) {
  constexpr double exact = 1e-10, alike = 3.0;
  return now.order() == before.order() && now.residual <= std::max(exact, alike * before.residual);
}

LinearModel found(Prober& prober, const Wanted& wanted) {
  std::int64_t steps = wanted.steps;
  const bool is_longest = 2 * steps > most_steps;
  Runs runs = prober.runs(is_longest ? steps : 2 * steps);
  LinearModel now = model_of(is_longest ? runs : runs.up_to(steps), wanted);
  while (2 * steps <= most_steps) {
    const LinearModel before = std::move(now);
    now = model_of(runs, wanted);
    steps *= 2;
    if (stays(before, now) || 2 * steps > most_steps) break;
    runs = prober.runs(2 * steps);
  }
  now.step = prober.probe().step(), now.offset = prober.probe().offset(),
  now.before = prober.probe().before();
  return now;
}

}  // namespace

LinearModel identify(Subsystem& subsystem, const Wanted& wanted) {
  Prober prober(subsystem, wanted);
  return found(prober, wanted);
}

std::optional<LinearModel> identify_linear(Subsystem& subsystem, const Wanted& wanted) {
  Prober prober(subsystem, wanted);
  if (!prober.is_linear()) return {};
  constexpr double good = 1e-9;
  auto by_states = model_by_states(prober);
  if (by_states && by_states->residual > good) {
    prober.make_responses_large();
    by_states = model_by_states(prober);
  }
  // States that no output tells of may keep a step from being cut; responses have none of these.
  const bool is_whole = by_states && can_be_cut(by_states->a);
  if (is_whole && by_states->residual <= good) return by_states;
  LinearModel other = found(prober, wanted);
  const bool is_better = by_states && by_states->residual < other.residual;
  return is_better && (is_whole || other.residual > good) ? by_states : other;
}

}  // namespace tandem::identification
