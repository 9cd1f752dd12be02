// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sampled_map.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "remembered.hpp"
#include "tandem/error.hpp"

namespace tandem::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr double together = 1e-9;  ///< instants so near, as a part of the super-step, are one

double largest_of(const Eigen::VectorXcd& values) {
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

}  // namespace

SampledMap::SampledMap(const Trial& trial, bool is_linear)
    : trial_(trial),
      whole_(undivided(trial, is_linear, Sampled::held)),
      fastest_(largest_of(whole_.rates.eigenvalues())),
      waiting_(static_cast<std::size_t>(trial.topology().size())) {
  find_happenings();
}

SampledMap::Happening& SampledMap::at(double time) {
  for (Happening& one : happenings_)
    if (std::abs(one.time - time) <= together * trial_.period().length) return one;
  return happenings_.emplace_back(Happening{time, {}, {}});
}

/// Those after the begin, up to the end.
void SampledMap::find_happenings() {
  for (const Line& line : trial_.topology().lines())
    if (line.lag == Lag::delay && trial_.topology().info(line.reader).abilities.sampled)
      throw Error(ErrorCode::not_supported, fmt::format("subsystem '{}' is sampled and reads with a delay",
                                                        trial_.topology().name(line.reader)));
  const double length = trial_.period().length, rounding = together * length;
  for (int i = 0; i < trial_.topology().size(); ++i) {
    const SubsystemInfo& info = trial_.topology().info(i);
    if (!info.abilities.sampled) continue;
    const double period = trial_.own_step(i), late = info.sampling.latency, count = length / period;
    if (std::abs(count - std::round(count)) > 1e-6)
      throw Error(ErrorCode::not_supported,
                  fmt::format("the period {} s of subsystem '{}' does not meet others within the super-step",
                              period, trial_.topology().name(i)));
    const double offset = trial_.offset(i);
    const auto before = static_cast<int>(std::ceil((offset + late) / period)) + 1;
    for (int k = -before; offset + k * period <= length + rounding; ++k) {
      const double instant = offset + k * period;
      if (instant > rounding) at(instant).samples.push_back(i);
      const double effect = instant + late;
      if (late > 0.0 && effect > rounding && effect <= length + rounding) at(effect).take_effect.push_back(i);
      if (instant <= rounding && effect > rounding) ++waiting_[static_cast<std::size_t>(i)];
    }
  }
  std::ranges::sort(happenings_, {}, &Happening::time);
}

/// Of an instance, by the numbers before: what it reads of others now, or had before this time.
MatrixXd SampledMap::inputs(int instance, const MatrixXd& before, const MatrixXd& now) const {
  const Topology& topology = trial_.topology();
  MatrixXd u = MatrixXd::Zero(topology.info(instance).input_size(), before.cols());
  for (const Line& line : topology.lines()) {
    if (line.reader != instance) continue;
    const bool held = topology.info(line.source).abilities.sampled && !topology.just_before(line);
    u.row(line.input) += line.gain * (held ? now : before).row(whole_.output_of(line.source) + line.output);
  }
  return u;
}

/// First outputs that take effect, then those of all that act, in the order of feedthrough, then their states.
MatrixXd SampledMap::jump(const Happening& happening, std::vector<int>& waiting) const {
  const Index size = whole_.rates.rows();
  MatrixXd next = MatrixXd::Identity(size, size), now = whole_.outputs;
  for (const int i : happening.take_effect) {
    const Index width = trial_.topology().info(i).output_size(), first = whole_.held_of(i);
    const Index late = width * waiting[static_cast<std::size_t>(i)]--;
    next.middleRows(first, late) = MatrixXd(next.middleRows(first + width, late));
    now.middleRows(whole_.output_of(i), width) = next.middleRows(first, width);
  }
  const auto given = [&](int i) {
    const identification::LinearModel& model = trial_.model(i);
    const MatrixXd y = model.c * next.middleRows(whole_.state_of(i), model.order()) +
                       model.d * inputs(i, whole_.outputs, now);
    MatrixXd all = MatrixXd::Zero(trial_.topology().info(i).output_size(), size);
    for (Index k = 0; k < y.rows(); ++k)
      if (const int value = model.values[static_cast<std::size_t>(k)]; value < all.rows())
        all.row(value) = y.row(k);
    return all;
  };
  for (std::size_t pass = 0; pass < happening.samples.size(); ++pass)
    for (const int i : happening.samples)
      if (trial_.topology().info(i).sampling.latency == 0.0)
        now.middleRows(whole_.output_of(i), trial_.topology().info(i).output_size()) = given(i);
  for (const int i : happening.samples) {
    const Index width = trial_.topology().info(i).output_size();
    const bool late = trial_.topology().info(i).sampling.latency > 0.0;
    const int slot = late ? ++waiting[static_cast<std::size_t>(i)] : 0;
    next.middleRows(whole_.held_of(i) + slot * width, width) = given(i);
  }
  for (const int i : happening.samples) {
    const identification::LinearModel& model = trial_.model(i);
    const MatrixXd u = inputs(i, whole_.outputs, now);
    MatrixXd x = model.a * next.middleRows(whole_.state_of(i), model.order());
    for (Index k = 0; k < u.rows(); ++k)
      x += model.b.col(k * static_cast<Index>(identification::places.size())) * u.row(k);
    next.middleRows(whole_.state_of(i), model.order()) = x;
  }
  return next;
}

/// Flows go in parts in which nothing turns by more than a radian.
void SampledMap::pass(const Visit& by) const {
  std::map<std::int64_t, MatrixXd> flows;  // by their length
  double time = 0.0;
  const auto flow = [&](double to) {
    const double length = to - time, parts = std::max(1.0, std::ceil(length * fastest_));
    if (length <= together * trial_.period().length) return;
    const auto key = static_cast<std::int64_t>(std::llround(length / (trial_.period().length * together)));
    auto found = flows.find(key);
    if (found == flows.end()) found = flows.emplace(key, MatrixXd(length / parts * whole_.rates).exp()).first;
    for (double part = 0.0; part < parts; ++part) by(found->second, false);
    time = to;
  };
  std::vector<int> waiting = waiting_;
  for (const Happening& one : happenings_) flow(one.time), by(jump(one, waiting), !one.samples.empty());
  flow(trial_.period().length);
}

MatrixXd SampledMap::map() const {
  MatrixXd all = MatrixXd::Identity(whole_.rates.rows(), whole_.rates.cols());
  pass([&](const MatrixXd& part, bool) { all = part * all; });
  return all;
}

/// By columns, of the number that each is told by [rad]. One that does not swing has changed its sign or not from instant
/// to instant, which is counted from the last one of the super-step before.
Eigen::VectorXd SampledMap::turns(MatrixXcd vectors, const std::vector<Index>& told_by) const {
  Eigen::VectorXd turns(vectors.cols());
  MatrixXcd last = vectors;
  const auto follow = [&](const MatrixXd& part, bool is_instant) {
    vectors = MatrixXcd(part * vectors);
    for (Index k = 0; k < vectors.cols(); ++k) {
      const Index row = told_by[static_cast<std::size_t>(k)];
      const std::complex<double> turn = vectors(row, k) * std::conj(last(row, k));
      const bool swings = !vectors.col(k).imag().isZero(0.0);
      if (!swings && !is_instant) continue;
      turns[k] += swings ? std::arg(turn) : std::arg(turn.real());
      last.col(k) = vectors.col(k);
    }
  };
  pass(follow);
  turns.setZero();
  pass(follow);
  return turns;
}

TrueModes SampledMap::modes() const {
  const Remembered kept = remembered(map());
  const Eigen::EigenSolver<MatrixXd> right(kept.map), left(kept.map.transpose());
  std::vector<Index> named;
  TrueModes modes;
  for (Index k = 0; k < whole_.rates.rows(); ++k)
    if (const std::string& name = whole_.names[static_cast<std::size_t>(k)]; !name.empty())
      named.push_back(k), modes.states.push_back(name);
  const Eigen::VectorXcd values = right.eigenvalues(), mirrored = left.eigenvalues();
  const MatrixXcd vectors = kept.basis * right.eigenvectors(),
                  of_modes = kept.back.transpose() * left.eigenvectors();
  modes.vectors = vectors(named, Eigen::all);
  modes.parts.resize(modes.vectors.rows(), modes.vectors.cols());
  std::vector<Index> told_by(static_cast<std::size_t>(values.size()));
  for (Index k = 0; k < values.size(); ++k) {
    Index same = 0, most = 0;
    (mirrored.array() - values[k]).abs().minCoeff(&same);
    const Eigen::VectorXcd of_mode = of_modes(named, same);
    modes.parts.col(k) = of_mode.cwiseProduct(modes.vectors.col(k)).cwiseAbs();
    modes.parts.col(k).maxCoeff(&most);
    told_by[static_cast<std::size_t>(k)] = named[static_cast<std::size_t>(most)];
  }
  const Eigen::VectorXd turned = turns(vectors, told_by);
  const double length = trial_.period().length, round = 2.0 * std::numbers::pi;
  modes.rates.resize(values.size());
  for (Index k = 0; k < values.size(); ++k) {
    const double angle = std::arg(values[k]);
    modes.rates[k] = {std::log(std::abs(values[k])) / length,
                      (angle + round * std::round((turned[k] - angle) / round)) / length};
  }
  return modes;
}

}  // namespace tandem::stability
