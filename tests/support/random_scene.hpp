// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Three to six diagrams that read each other, or data, at random: oscillators, relays and sampled ones.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "connection.hpp"
#include "tandem/coordinator/coordination.hpp"
#include "tandem/time_series.hpp"

namespace tandem::test {

struct RandomScene {
  enum class Kind { oscillator, relay, sampled };
  struct Part {
    std::string name, text;  ///< text: of the diagram
    Kind kind;
    double step;  ///< [s]; 0 of a sampled one
    double period = 0.0;
    Landing landing = Landing::automatic;
  };
  struct Data {
    std::string port;
    std::shared_ptr<const TimeSeries> series;
  };
  std::vector<Part> parts;
  std::vector<Connection> connections;
  std::vector<Data> data;  ///< of inputs that are not connected
  Coordination coordination;
  double t_start = 0.0, t_stop = 0.0;
};

/// The scene of a seed, the same everywhere.
class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : random_(seed) {}

  RandomScene scene() {
    RandomScene scene;
    const int count = 3 + number(4);
    for (int i = 0; i < count; ++i) add_part(scene);
    how_ = "lagrange" + std::to_string(number(5));
    for (int to = 0; to < count; ++to)
      for (const char* port : {"u", "y"})
        for (int terms = 1 + (number(3) == 0); terms > 0; --terms) connect(scene, to, port);
    coordinate(scene);
    scene.t_start = std::vector{0.0, -1.3, 100.0}[static_cast<std::size_t>(number(3))];
    scene.t_stop = scene.t_start + 1.0 + part(0.0, 0.5);
    return scene;
  }
  /// The same with a quarter of its inputs data in place of connections.
  RandomScene driven_scene() {
    RandomScene scene = this->scene();
    for (const auto& part : scene.parts)
      for (const char* port : {".u", ".y"}) {
        if (number(4) != 0) continue;
        const std::string input = part.name + port;
        std::erase_if(scene.connections, [&](const Connection& c) { return c.to == input; });
        scene.data.push_back({input, std::make_shared<const TimeSeries>(series(scene))});
      }
    return scene;
  }
  int number(int below) { return static_cast<int>(random_() % static_cast<std::uint64_t>(below)); }
  std::mt19937_64& random() { return random_; }

 private:
  using Kind = RandomScene::Kind;
  double part(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  double rounded(double from, double to) { return std::round(1e4 * part(from, to)) / 1e4; }

  void add_part(RandomScene& scene) {
    constexpr Kind kinds[] = {Kind::oscillator, Kind::oscillator, Kind::relay, Kind::relay, Kind::sampled};
    const Kind kind = scene.parts.empty() ? Kind::oscillator : kinds[number(5)];
    RandomScene::Part part{"s" + std::to_string(scene.parts.size()), "", kind, 0.0};
    if (kind == Kind::sampled)
      part.period = rounded(0.01, 0.3);
    else
      part.step = rounded(0.004, 0.05);
    if (kind != Kind::sampled && number(5) == 0) part.landing = number(3) ? Landing::never : Landing::always;
    part.text = "[inputs]\nu = { unit = 'm' }\ny = { unit = 'm' }\n[blocks]\n" + blocks(part) +
                "[outputs]\nx = { unit = 'm' }\nv = { unit = 'm' }\na = { unit = 'm' }\n";
    scene.parts.push_back(std::move(part));
  }

  /// Output a follows the inputs at once, and so do all of a sampled one; x of a relay is held.
  std::string blocks(const RandomScene::Part& part) {
    if (part.kind == Kind::oscillator)
      return fmt::format(
          "a = {{ kind = 'sum', inputs = ['u', 'y', 'x', 'v'], gains = [1, 0.5, {}, -0.5] }}\n"
          "v = {{ kind = 'integrator', input = 'a', initial = 0.3 }}\n"
          "x = {{ kind = 'integrator', input = 'v', initial = {} }}\n",
          -this->part(5.0, 60.0), this->part(-0.1, 0.1));
    if (part.kind == Kind::relay)
      return fmt::format(
          "s = {{ kind = 'sum', inputs = ['u', 'v'], gains = [1, 0.1] }}\n"
          "v = {{ kind = 'lag', input = 'y', time = 0.2 }}\n"
          "x = {{ kind = 'relay', input = 's', low = {}, high = {}, on = -1, off = 1 }}\n"
          "a = {{ kind = 'sum', inputs = ['x', 'v'] }}\n",
          this->part(-0.05, -0.005), this->part(0.005, 0.05));
    return fmt::format(
        "mix = {{ kind = 'sum', inputs = ['u', 'y', 'x'], gains = [-0.7, 0.2, 0.2] }}\n"
        "x = {{ kind = 'sample', input = 'mix', period = {}, offset = {} }}\n"
        "v = {{ kind = 'gain', input = 'x', gain = -0.3 }}\na = {{ kind = 'gain', input = 'x', gain = 0.5 "
        "}}\n",
        part.period, number(2) ? 0.0 : rounded(0.0, 0.1));
  }

  void connect(RandomScene& scene, int to, const std::string& port) {
    const auto count = static_cast<int>(scene.parts.size());
    const auto &source = scene.parts[static_cast<std::size_t>((to + 1 + number(count - 1)) % count)],
               &reader = scene.parts[static_cast<std::size_t>(to)];
    const std::string output = std::vector{"x", "x", "v", "a"}[static_cast<std::size_t>(number(4))];
    const bool held = source.kind == Kind::sampled || (source.kind == Kind::relay && output == "x"),
               among_sampled = source.kind == Kind::sampled && reader.kind == Kind::sampled;
    Lag lag = output == "a" || among_sampled ? Lag::memory : Lag::none;
    if (number(8) == 0) lag = number(2) ? Lag::memory : Lag::delay;
    scene.connections.push_back(
        added(connection(source.name + "." + output, reader.name + "." + port, held ? "" : how_, lag)));
  }

  /// Points over the span, some of them nodes or instants; but for splines a quarter of them jumps.
  TimeSeries series(const RandomScene& scene) {
    using Between = TimeSeries::Between;
    const Between between =
        std::vector{Between::linear, Between::hold, Between::spline}[static_cast<std::size_t>(number(3))];
    std::vector<double> times{scene.t_start}, points, values;
    for (int k = 4 + number(20); k > 0; --k) times.push_back(time_in(scene));
    times.push_back(scene.t_stop + 0.01);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    for (const double t : times)
      for (int count = between != Between::spline && t > scene.t_start && number(4) == 0 ? 2 : 1; count > 0;
           --count)
        points.push_back(t), values.push_back(part(-0.3, 0.3));
    return {"data", points, values, {between, TimeSeries::Beyond::hold}};
  }
  double time_in(const RandomScene& scene) {
    const auto& part = scene.parts[static_cast<std::size_t>(number(static_cast<int>(scene.parts.size())))];
    const double h = part.step > 0.0 ? part.step : part.period;
    const int nodes = static_cast<int>((scene.t_stop - scene.t_start) / h);
    return number(2) && nodes > 0 ? scene.t_start + (1 + number(nodes)) * h
                                  : scene.t_start + rounded(0.0, 1.0);
  }

  void coordinate(RandomScene& scene) {
    Coordination& c = scene.coordination;
    c.schedule = Schedule::parse(
        std::vector{"slowest-first", "fastest-first", "parallel"}[static_cast<std::size_t>(number(3))]);
    for (const auto& part : scene.parts) {
      c.landing[part.name] = part.landing;
      if (part.kind != Kind::sampled) c.order.push_back(part.name);
    }
    if (c.schedule == Schedule::Kind::parallel && number(3) == 0) c.communication_step = rounded(0.005, 0.1);
    std::shuffle(c.order.begin(), c.order.end(), random_);
    if (c.schedule == Schedule::Kind::parallel || number(2)) c.order.clear();
  }

  std::mt19937_64 random_;
  std::string how_;
};

}  // namespace tandem::test
