// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Three masses in a row, of which two are a scenario; and a plant with an actuator and a sampled damper.
#pragma once
#include <string>

#include "scratch.hpp"

namespace tandem::test {

/// m x'' = k (u - x) + s (w - x), of two neighbours at u and w.
inline const std::string mass_between =
    "[parameters]\nm = { value = 1, unit = 'kg' }\nk = { value = 4, unit = 'N/m' }\ns = { value = 3, unit = "
    "'N/m' }\n"
    "x0 = { value = 0, unit = 'm' }\n[inputs]\nu = { unit = 'm' }\nw = { unit = 'm' }\n[blocks]\n"
    "a = { kind = 'sum', inputs = ['u', 'w', 'x'], gains = ['$(k / m)', '$(s / m)', '$(-(k + s) / m)'] }\n"
    "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v', initial = '$x0' }\n"
    "[outputs]\nx = { unit = 'm' }\n[run]\nstop = 1\nstep = 0.01\n";

/// The second and the third mass, by Lagrange's polynomials of degree 3; the second's u is open, the third's w a wall.
inline const std::string two_of_three =
    "[constants]\nh = 0.01\nm3 = 1.5\n[subsystems.two]\nsource = 'diagram:mass.toml'\n"
    "parameters = { step = '$h', m = 2, k = 3, s = 5 }\n"
    "[subsystems.three]\nsource = 'diagram:mass.toml'\nparameters = { step = '$(h / 2)', m = '$m3', k = 5, s "
    "= 2 }\n"
    "[[connections]]\nfrom = 'three.x'\nto = 'two.w'\nreconstruction = 'lagrange3'\n"
    "[[connections]]\nfrom = 'two.x'\nto = 'three.u'\nreconstruction = 'lagrange3'\n"
    "[subsystems.two.inputs]\nu = 0\n[subsystems.three.inputs]\nw = { times = [0, 1], values = [0, 0], "
    "beyond = 'hold' }\n"
    "[span]\nstop = 4\n";

inline void write_three_masses(const Scratch& folder) {
  folder.write("mass.toml", mass_between);
  folder.write("pair.toml", two_of_three);
}

/// The actuator's set point r is open, and two of its outputs and one of the plant follow it at once.
inline void write_plant(const Scratch& folder) {
  folder.write(
      "plant.toml",
      "[inputs]\nF = { unit = 'N' }\nd = { unit = 'N' }\n[parameters]\nm = { value = 2, unit = 'kg' }\n"
      "[blocks]\na = { kind = 'sum', inputs = ['F', 'd', 'x', 'v'], gains = ['$(1/m)', '$(1/m)', '$(-30/m)', "
      "-0.3] }\nv = { kind = 'integrator', input = 'a', initial = 0.1 }\n"
      "x = { kind = 'integrator', input = 'v', initial = 0.05 }\n"
      "[outputs]\nx = { unit = 'm' }\nv = { unit = 'm/s' }\na = { unit = 'm/s^2' }\n");
  folder.write(
      "actuator.toml",
      "[inputs]\nx = { unit = 'm' }\nr = { unit = 'm' }\n[blocks]\n"
      "e = { kind = 'sum', inputs = ['r', 'x'], gains = [1, -1] }\n"
      "late = { kind = 'lag', input = 'e', time = 0.02, gain = 12 }\n"
      "T = { kind = 'sum', inputs = ['late', 'e'], gains = [1, 5] }\n[outputs]\nT = { unit = 'N' }\n");
  folder.write(
      "damper.toml",
      "[inputs]\nv = { unit = 'm/s' }\n[blocks]\ns = { kind = 'sample', input = 'v', period = 0.02 }\n"
      "u = { kind = 'gain', input = 's', gain = -0.4 }\n[outputs]\nu = { unit = 'N' }\n");
  std::string text =
      "name = 'drive'\n[subsystems.plant]\nsource = 'diagram:plant.toml'\nparameters = { step = 0.004 }\n"
      "[subsystems.actuator]\nsource = 'diagram:actuator.toml'\nparameters = { step = 0.001 }\n"
      "inputs = { r = 0.2 }\n[subsystems.damper]\nsource = 'diagram:damper.toml'\n";
  for (const char* pair : {"from = 'plant.x'\nto = 'actuator.x'", "from = 'actuator.T'\nto = 'plant.F'",
                           "from = 'plant.v'\nto = 'damper.v'"})
    text += std::string("[[connections]]\n") + pair + "\nreconstruction = 'lagrange2'\n";
  text +=
      "[[connections]]\nfrom = 'damper.u'\nto = 'plant.d'\n[record]\n"
      "ports = ['plant.x', 'plant.a', 'actuator.T', 'damper.u']\n[span]\nstop = 2\n";
  folder.write("drive.toml", text);
}

}  // namespace tandem::test
