// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"
#include "tandem/coordinator/power_link.hpp"

namespace tandem {

/// How far the coupling of a run departs from that of the system as one: from what the run does anyway, and without
/// a change of any bit of it.
///
/// **Defect** of a connection: the input as its reader used it, less gain * output + offset as the source gave it in
/// the end. A lag is part of the defect. It is taken in the middle of each own step of the one of the two with the
/// shorter steps at the start; of a sampled reader, at its instants. Between its rows an output is the cubic through
/// values and derivatives; without derivatives it is the polynomial through its newest four rows. Held outputs have
/// no defect, and none is taken where either of the two jumps.
///
/// **Energy** that the coupling makes on a power link, negative where it loses. With e, f the outputs, g their gains,
/// d the defects of their readers' inputs, and s the scale of the link, the power is
/// - effort and flow: s (d_e f - g_e e d_f / g_f);
/// - effort and displacement: s (d_e f' + g_e e' d_f / g_f), the same after an integration by parts;
/// - two displacements, of a spring of stiffness k: k (d_e f' + d_f e').
///
/// In each the first term is what the effort does on its reader beyond what it should, the second what the other end
/// is relieved of. (After the power bonds of S. Sadjina et al., doi:10.1007/s00366-016-0492-8.)
class Indicators final : public Observer {
 public:
  /// A run has so many windows at most, and numbers of them. Each window is as long as the longest first own step, or
  /// longer.
  static constexpr double most_windows = 1000.0, most_cells = 1e6;

  /// `run` must outlive it. It is to be told of all that the run does from Coordinator::initialize on.
  /// - left_out: lines of the topology that have no defect by intent.
  Indicators(const Coordinator& run, std::vector<PowerLink> links, std::vector<int> left_out = {});
  ~Indicators() override;

  bool samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) override;
  void inputs(int subsystem, TimeSpan span, std::span<const Signal> lanes) override;
  void inputs_at(int subsystem, double t, std::span<const double> lanes) override;
  void went_back(int subsystem, double t) override;

  struct Connection {
    double largest = 0.0;              ///< magnitude of the defect
    double at = 0.0;                   ///< when [s]
    double peak = 0.0;                 ///< largest magnitude that the input should have had
    std::vector<double> windows = {};  ///< largest magnitude in each; negative: none was taken
    std::string name, unit;  ///< "defect(INPUT)", of a sum "defect(INPUT:OUTPUT)"; that of the input
    int line;                ///< of the topology
  };
  struct Link {
    double energy = 0.0;               ///< [J]
    double passed = 0.0;               ///< of the power's magnitude over time [J]
    std::vector<double> windows = {};  ///< energy that was made in each [J]
    PowerLink link;
    std::string name;  ///< "energy(EFFORT:BACK)"
  };
  const std::vector<Connection>& connections() const;
  const std::vector<Link>& links() const;
  /// Ends of the windows [s]; empty before the first samples.
  std::vector<double> times() const;

  /// All that it goes by from here on, and back, in place of the first samples.
  void save(ByteWriter& to) const;
  void resume(ByteReader& from);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tandem
