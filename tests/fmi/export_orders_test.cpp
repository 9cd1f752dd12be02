// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>
#include <unsupported/Eigen/MatrixFunctions>

#include "exports.hpp"
#include "run_bench.hpp"
#include "tandem/exported/stepped_unit.hpp"

namespace tandem::test {
namespace {

/// m x'' = k (u - x) - s x - d x', from x = 1 at rest.
const std::string coupled_mass =
    "[parameters]\nk = { value = 4, unit = '1' }\ns = { value = 1, unit = '1' }\nd = { value = 0.3, unit = "
    "'1' }\n"
    "m = { value = 1, unit = '1' }\n[inputs]\nu = { unit = '1' }\n[blocks]\n"
    "a = { kind = 'sum', inputs = ['u', 'x', 'v'], gains = ['$(k / m)', '$(-(k + s) / m)', '$(-d / m)'] }\n"
    "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v', initial = 1 }\n"
    "[outputs]\nx = { unit = '1' }\n";
constexpr double until = 5.0;

double right_x() {
  Eigen::Matrix4d a;
  a << 0.0, 1.0, 0.0, 0.0,   //
      -5.0, -0.3, 4.0, 0.0,  //
      0.0, 0.0, 0.0, 1.0,    //
      4.0 / 1.5, 0.0, -6.0 / 1.5, -0.1 / 1.5;
  return ((a * until).exp() * Eigen::Vector4d(1.0, 0.0, 1.0, 0.0))[0];
}

double coupled_error(Subsystem& one, Subsystem& other, const std::string& how) {
  RunBench bench;
  bench.add("one", one).add("other", other);
  bench.connect("one.x", "other.u", how).connect("other.x", "one.u", how);
  return std::abs(bench.run(until).rows(0).back()[2] - right_x());
}

class ExportOrders : public testing::Test {
 protected:
  /// prefix: of the parameters' names.
  std::unique_ptr<Subsystem> of(const std::string& uri, const Builtins& sources, const std::string& prefix,
                                bool second) const {
    std::string all = uri;
    for (const char* value : {"s=2", "d=0.1", "m=1.5"})
      if (second) all += "&" + prefix + value;
    return open(all, sources);
  }
  double error_of_sources(double h, const std::string& how) const {
    const std::string uri =
        "diagram:" + (exports.folder.path() / "mass.toml").string() + "?step=" + std::to_string(h);
    return coupled_error(*of(uri, file_sources(), "", false), *of(uri, file_sources(), "", true), how);
  }
  double error_of_exports(double h, const std::string& how, const std::string& inputs) const {
    const std::string uri = "fmu:" + fmu.string() + "?step=" + std::to_string(h) + "&inputs=" + inputs;
    return coupled_error(*of(uri, fmu_sources(), "set.", false), *of(uri, fmu_sources(), "set.", true), how);
  }
  /// As other importers couple: values at communication points alone.
  double error_of_held(double h, bool extrapolate) const {
    exported::SteppedUnit one(resources), other(resources);
    const auto reference = [&](const std::string& name) {
      std::size_t k = 0;
      while (one.variable(k).name != name) ++k;
      return k;
    };
    other.set(reference("s"), 2.0), other.set(reference("d"), 0.1), other.set(reference("m"), 1.5);
    for (exported::SteppedUnit* unit : {&one, &other}) unit->set(reference("extrapolate"), extrapolate);
    const auto x = reference("x"), u = reference("u");
    for (int k = 0; k < std::lround(until / h); ++k) {
      const double of_one = one.number(x), of_other = other.number(x);
      one.set(u, of_other), other.set(u, of_one);
      one.step(k * h, h), other.step(k * h, h);
    }
    return std::abs(one.number(x) - right_x());
  }
  template <class Error>
  static double order(const Error& error) {
    return std::log2(error(0.05) / error(0.0125)) / 2.0;
  }

  Exports exports;
  std::filesystem::path source = exports.folder.write("mass.toml", coupled_mass),
                        fmu = exports.of("diagram:" + source.string() + "?step=0.0015625", "mass"),
                        resources = exports.unpacked(fmu);
};

TEST_F(ExportOrders, HeldInputsAreOfOrder1AndALineThroughTwoValuesOfOrder2) {
  EXPECT_NEAR(order([&](double h) { return error_of_held(h, false); }), 1.0, 0.2);
  EXPECT_NEAR(order([&](double h) { return error_of_held(h, true); }), 2.0, 0.2);
}

TEST_F(ExportOrders, CoupledWithDerivativesOfInputsTheyErrAsTheirSourcesDo) {
  for (const double h : {0.05, 0.025, 0.0125})
    for (const char* degree : {"1", "2"}) {
      const std::string how = std::string("lagrange") + degree;
      const double sources = error_of_sources(h, how);
      const double found = error_of_exports(h, how, std::string("derivatives&order=") + degree);
      EXPECT_LT(found, 1.1 * sources) << how << " " << h;
      EXPECT_GT(found, 0.9 * sources) << how << " " << h;
    }
}

/// The output of the controller follows its input at once: that of the mean would be off in the first order.
TEST(ExportedDrive, TakesMeansInOrder2ThoughAnOutputFollowsItsInputAtOnce) {
  const Exports exports;
  const std::string folder = TANDEM_SOURCE_DIR "/scenarios/fmi/", ours = exports.folder.path().string() + "/";
  for (const char* name : {"controller", "drive_train"}) exports.of(folder + name + ".toml", name);
  const auto speed = [&](const std::string& sources, const std::string& ending, double h,
                         const std::string& how) {
    const std::string step = ending + "?step=" + std::to_string(h);
    const Builtins builtins = ending == ".fmu" ? fmu_sources() : file_sources();
    const auto one = open(sources + "controller" + step, builtins),
               other = open(sources + "drive_train" + step, builtins);
    RunBench bench;
    bench.add("one", *one).add("other", *other);
    bench.connect("one.torque", "other.torque", how).connect("other.w1", "one.w", how);
    return bench.run(1.0).rows(1).back()[3];
  };
  const double right = speed("diagram:" + folder, ".toml", 1e-4, "lagrange3");
  const auto error = [&](double h) { return std::abs(speed("fmu:" + ours, ".fmu", h, "lagrange1") - right); };
  EXPECT_NEAR(std::log2(error(1e-3) / error(2.5e-4)) / 2.0, 2.0, 0.2);
}

/// u = 1 + t + t^2 + .. to the degree of the derivatives that are given, from rest: x is a polynomial of two
/// degrees more.
TEST_F(ExportOrders, DerivativesOfInputsAreTakenToOrder5) {
  const auto file = exports.folder.write("twice.toml",
                                         "[inputs]\nu = { unit = '1' }\n[blocks]\nx = { kind = 'integrator', "
                                         "input = 'u' }\n[outputs]\nx = { unit = '1' }\n");
  exported::SteppedUnit unit(
      exports.unpacked(exports.of("diagram:" + file.string() + "?step=0.001", "twice")));
  unit.set(1, 1.0);
  double factorial = 1.0, expected = 0.5;
  for (int n = 1; n <= 5; ++n) {
    unit.set_derivative(1, n, factorial *= n);
    expected += std::pow(0.5, n + 1) / (n + 1);
  }
  unit.step(0.0, 0.5);
  EXPECT_NEAR(unit.number(2), expected, 1e-13);
  unit.step(0.5, 0.5);  // they hold for one step
  EXPECT_NEAR(unit.number(2), expected + 0.5, 1e-13);
}

}  // namespace
}  // namespace tandem::test
