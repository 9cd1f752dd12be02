// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Impulse couplings by the slow side's own equations, and dampers in links.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_run.hpp"

namespace tandem::test {
namespace {

const std::string taylor_scene = std::string(TANDEM_SOURCE_DIR) + "/scenarios/pushed_pendulum/";

double error_beside(const std::vector<double>& right, const std::vector<double>& x) {
  double errors = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
    errors += std::pow(x[k] - right[k], 2), squares += right[k] * right[k];
  return std::sqrt(errors / squares);
}

/// Where a slow step is half a fast period, and a whole one.
TEST(ImpulseTaylorScenario, IsRightWhereAMassThatIsToldIsNot) {
  for (const char* ratio : {"49.5", "98"}) {
    const std::string of = std::string("constants.ratio=") + ratio;
    const SceneRun right(taylor_scene + "reference.toml",
                         {std::string("subsystems.whole.parameters.frequency_ratio=") + ratio});
    const SceneRun best(taylor_scene + "pushed_pendulum.toml", {of, "coordination.coupling=impulse_taylor"}),
        plain(taylor_scene + "pushed_pendulum.toml", {of, "coordination.coupling=impulse_plain"});
    ASSERT_EQ(best.said().status, 0) << best.said().err;
    EXPECT_TRUE(contains(best.said().err, "subsystem 'slow' is coupled by impulse_taylor"))
        << best.said().err;
    const double factor = std::stod(ratio) / 100.0;
    EXPECT_LT(factor * error_beside(right.column("whole.x1"), best.column("fast.x1")), 0.003) << ratio;
    EXPECT_GT(factor * error_beside(right.column("whole.x1"), plain.column("fast.x1")), 0.004) << ratio;
  }
}

/// A wagon on a spring that another force G moves, with a fast mass on it.
struct Moved {
  explicit Moved(double step) {
    folder.write(
        "piston.toml",
        "[inputs]\nxc = { unit = 'm' }\n[outputs]\nx1 = { unit = 'm' }\nF = { unit = 'N' }\n[blocks.F]\nkind "
        "= "
        "'sum'\ninputs = ['x1', 'xc']\ngains = [12000, -12000]\n[blocks.v1]\nkind = 'integrator'\ninput = "
        "'a'\n[blocks.a]\nkind = 'sum'\ninputs = ['F']\ngains = [-0.33]\n[blocks.x1]\nkind = "
        "'integrator'\ninput = 'v1'\ninitial = 0.01\n[run]\nstep = 0.001\n");
    folder.write(
        "moving.toml",
        "[parameters]\nG0 = { value = 0, unit = 'N' }\n[outputs]\nG = { unit = 'N' }\n[blocks.G]\nkind = "
        "'integrator'\ninput = 'w'\ninitial = '$G0'\n[blocks.w]\nkind = "
        "'integrator'\ninput = 'b'\ninitial = 800\n[blocks.b]\nkind = 'gain'\ninput = 'G'\ngain = "
        "-64\n[run]\nstep = 0.001\n");
    folder.write(
        "wagon.toml",
        "dimension = 2\n[points]\nO = { at = [-1, 0], fixed = true }\nP = { at = [0, 0] }\n[masses]\nload = "
        "{ "
        "point = 'P', mass = 300, free = true }\n[springs]\ns = { points = ['O', 'P'], free = 1, stiffness = "
        "3000, "
        "damping = 30 }\n[inputs]\nF = { unit = 'N' }\nG = { unit = 'N', value = 0 }\n[forces]\nf = { point "
        "= "
        "'P', direction = [1, 0], magnitude = 'F' }\ng = { point = 'P', direction = [1, 0], magnitude = 'G' "
        "}\n[outputs]\nx = { position = 'P.x' }\n[run]\nstep = " +
            std::to_string(step) + "\n");
    folder.write(
        "s.toml",
        "[subsystems.fast]\nsource = 'diagram:piston.toml'\n[subsystems.moving]\nsource = "
        "'diagram:moving.toml'\n[subsystems.slow]\nsource = 'mechanism:wagon.toml'\n[[connections]]\nfrom = "
        "'fast.F'\nto = 'slow.F'\n[[connections]]\nfrom = 'slow.x'\nto = 'fast.xc'\n[[connections]]\nfrom = "
        "'moving.G'\nto = 'slow.G'\nreconstruction = 'lagrange3'\n[[links]]\neffort = 'fast.F'\ndisplacement "
        "= "
        "'slow.x'\n[coordination]\ncoupling = 'impulse_taylor'\nfast_period = 0.1\n[span]\nstop = 3.0\n");
  }
  std::vector<double> x(const std::string& to, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"run", "s.toml", "--quiet", "--output", to};
    words.insert(words.end(), more.begin(), more.end());
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 0) << said.err;
    const auto table = text::TimeTable::read(folder.path() / to);
    const auto at = std::find(table.names.begin(), table.names.end(), "slow_surrogate.displacement") -
                    table.names.begin();
    return table.columns.at(static_cast<std::size_t>(at));
  }
  std::string rows(const std::string& of) const { return read_text(folder.path() / of / "results.csv"); }
  Scratch folder;
};

/// Other inputs change what the polynomials are of: second order, too.
TEST(ImpulseTaylorScenario, FollowsOtherInputsToSecondOrder) {
  const std::vector<double> right = Moved(0.00125).x("o");
  const double coarse = error_beside(right, Moved(0.02).x("o")),
               fine = error_beside(right, Moved(0.01).x("o"));
  EXPECT_LT(coarse, 0.005);
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

/// A start value of a connected input counts for nothing.
TEST(ImpulseTaylorScenario, BeginsWithWhatOtherInputsAreThen) {
  const auto from = [](const std::string& coupling, double step, const char* start) {
    return Moved(step).x(
        "o", {"--set", "coordination.coupling=" + coupling, "--set", "subsystems.moving.parameters.G0=900",
              "--set", std::string("subsystems.slow.inputs.G=") + start});
  };
  for (const char* coupling : {"impulse_plain", "impulse_stiffness", "impulse_taylor"})
    EXPECT_LT(error_beside(from(coupling, 0.02, "900"), from(coupling, 0.02, "0")), 1e-9) << coupling;
  EXPECT_LT(error_beside(from("impulse_taylor", 0.00125, "0"), from("impulse_taylor", 0.02, "0")), 0.005);
}

/// Also in the middle of a slow step, and between one and what the surrogate makes of it.
TEST(ImpulseTaylorScenario, GoesOnFromACheckpointWithTheSameBits) {
  Moved scene(0.09);
  scene.x("whole");
  for (const char* every : {"0.13", "0.31", "0.9", "1.07"}) {
    scene.x("cut", {"--checkpoint-every", every});
    EXPECT_EQ(scene.rows("cut"), scene.rows("whole")) << every;
    scene.x("cut", {"--resume", "cut/checkpoint"});
    EXPECT_EQ(scene.rows("cut"), scene.rows("whole")) << every;
  }
}

TEST(ImpulseTaylorScenario, RefusesASideThatKeepsItsEquations) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"run", two_mass_file("impulse.toml"), "--set", "coordination.coupling=impulse_taylor"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "does not give its equations")) << said.err;
}

/// A mass of 3 kg on a spring and a damper of 1 % beside a wagon of 300 kg, against the closed form.
struct Damped {
  explicit Damped(const std::string& link, double step) {
    folder.write(
        "piston.toml",
        "[parameters]\nm = { value = 3.0, unit = 'kg' }\nk = { value = 11844.0, unit = 'N/m' }\nc = { value "
        "= 3.77, unit = 'N s/m' }\n[inputs]\nxc = { unit = 'm' }\nvc = { unit = 'm/s' "
        "}\n[outputs]\nx1 = { unit = 'm' }\nF = { unit = 'N' }\n[blocks.F]\nkind = 'sum'\ninputs = ['x1', "
        "'xc', "
        "'v1', 'vc']\ngains = ['$k', '$(-k)', '$c', '$(-c)']\n[blocks.v1]\nkind = 'integrator'\ninput = "
        "'a'\n[blocks.a]\nkind = 'sum'\ninputs = ['F']\ngains = ['$(-1/m)']\n[blocks.x1]\nkind = "
        "'integrator'\ninput = 'v1'\ninitial = 0.01\n[run]\nstep = 0.001\n");
    folder.write(
        "wagon.toml",
        "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nload = { point = 'P', mass = 300, free = "
        "true "
        "}\n[inputs]\nF = { unit = 'N' }\n[forces.push]\npoint = 'P'\ndirection = [1, 0]\nmagnitude = "
        "'F'\n[outputs]\nx = { position = 'P.x' }\nv = { velocity = 'P.x' }\n[run]\nstep = " +
            std::to_string(step) + "\n");
    folder.write(
        "s.toml",
        "[subsystems.fast]\nsource = 'diagram:piston.toml'\n[subsystems.slow]\nsource = "
        "'mechanism:wagon.toml'\n[[connections]]\nfrom = 'fast.F'\nto = 'slow.F'\n[[connections]]\nfrom = "
        "'slow.x'\nto = 'fast.xc'\n[[connections]]\nfrom = 'slow.v'\nto = 'fast.vc'\nreconstruction = "
        "'lagrange3'\n[[links]]\neffort = "
        "'fast.F'\ndisplacement = 'slow.x'\n" +
            link + "[coordination]\ncoupling = 'impulse'\nfast_period = 0.1\n[span]\nstop = 5.0\n");
  }
  double error() {
    said = tandem(folder, {"run", "s.toml", "--output", "o"});
    EXPECT_EQ(said.status, 0) << said.err;
    const auto table = text::TimeTable::read(folder.path() / "o");
    const auto x = std::find(table.names.begin(), table.names.end(), "fast.x1") - table.names.begin();
    const double mass = 3.0 * 300.0 / 303.0, w = std::sqrt(11844.0 / mass), d = 0.5 * 3.77 / mass,
                 wd = std::sqrt(w * w - d * d);
    std::vector<double> right;
    for (const double t : table.times)
      right.push_back(
          0.01 * (3.0 + 300.0 * std::exp(-d * t) * (std::cos(wd * t) + d / wd * std::sin(wd * t))) / 303.0);
    return error_beside(right, table.columns[static_cast<std::size_t>(x)]);
  }
  Scratch folder;
  Said said;
};

/// A damper needs the rate with its ripple; without it, or with samples of the slow side's, its force is another one.
TEST(ImpulseScenario, OfADamperIsRightWithTheVelocityOfTheSurrogate) {
  for (const double step : {0.02, 0.05, 0.09, 0.3}) {
    Damped with("velocity = 'slow.v'\n", step), without("", step);
    EXPECT_LT(with.error(), 0.002) << step;
    EXPECT_GT(without.error(), 0.004) << step;
    EXPECT_FALSE(contains(with.said.err, "goes past the surrogate")) << with.said.err;
    EXPECT_TRUE(contains(without.said.err, "slow.v to fast.vc: it goes past the surrogate"))
        << without.said.err;
  }
}

/// A mass of 310 kg in front of nine times that, beside a mass of 2.5 kg that takes 30 of its cycles for one: no
/// surrogate but that by its equations has what the first does on the second.
struct Inner {
  explicit Inner(const std::string& stiffness) {
    folder.write(
        "fast.toml",
        "[inputs]\ny = { unit = 'm' }\n[outputs]\nx = { unit = 'm' }\nF = { unit = 'N' "
        "}\n[blocks]\nF = { kind = 'sum', inputs = ['x', 'y'], gains = [100, -100] }\na = { kind = "
        "'gain', input = 'F', gain = -0.39 }\nv = { kind = 'integrator', input = 'a' }\nx = { kind = "
        "'integrator', input = 'v', initial = 1.35 }\n[run]\nstep = 0.01\n");
    folder.write(
        "slow.toml",
        "dimension = 2\n[coordinates]\ny = { unit = 'm', at = 0.35, inertia = 310 }\nz = { unit = 'm', "
        "at = 0.35, inertia = 2790 }\ne = { unit = 'm', at = 0 }\n[relations.e]\nterms = { y = 1, z = "
        "-1, e = -1 }\nvalue = 0\n[springs.between]\ncoordinate = 'e'\nstiffness = " +
            stiffness +
            "\nfree = "
            "0\n[springs.ground]\ncoordinate = 'z'\nstiffness = 136\nfree = 0\n[inputs.F]\nunit = "
            "'N'\n[forces.push]\ncoordinate = 'y'\nmagnitude = 'F'\n[outputs.y]\nposition = 'y'\n[run]\nstep "
            "= 0.3\n");
    folder.write(
        "s.toml",
        "[subsystems.fast]\nsource = 'diagram:fast.toml'\n[subsystems.slow]\nsource = "
        "'mechanism:slow.toml'\n[[connections]]\nfrom = 'fast.F'\nto = 'slow.F'\n[[connections]]\nfrom "
        "= 'slow.y'\nto = 'fast.y'\n[[links]]\neffort = 'fast.F'\ndisplacement = "
        "'slow.y'\n[coordination]\ncoupling = 'impulse'\nfast_period = 1.0\n[span]\nstop = 60\n");
  }
  std::string err(const std::string& coupling, int status = 0, const std::string& more = "span.stop=60") {
    const Said all =
        tandem(folder, {"run", "s.toml", "--set", "coordination.coupling=" + coupling, "--set", more});
    EXPECT_EQ(all.status, status) << all.err;
    return all.err;
  }
  Scratch folder;
};

TEST(ImpulseScenario, TellsOfAnInnerModeOfTheSlowSide) {
  const char *const bends = "bends within a step", *const otherwise = "otherwise than a mass on this spring";
  Inner soft("110"), stiff("4900");
  EXPECT_FALSE(contains(soft.err("impulse_plain"), bends));
  EXPECT_TRUE(contains(stiff.err("impulse_plain"), bends));
  EXPECT_FALSE(contains(soft.err("impulse_stiffness"), otherwise));
  EXPECT_TRUE(contains(stiff.err("impulse_stiffness"), otherwise));
  for (Inner* one : {&soft, &stiff}) EXPECT_FALSE(contains(one->err("impulse_taylor"), "bend"));
}

/// A spring that is two hundred times as stiff where the slow side stands.
TEST(ImpulseScenario, TellsOfStepsThatATaylorPolynomialDoesNotFollow) {
  Inner scene("110");
  scene.folder.write("slow.toml",
                     "dimension = 2\n[coordinates]\ny = { unit = 'm', at = 1.0, inertia = 100 "
                     "}\n[springs.ground]\ncoordinate = 'y'\nstiffness = [10, 0, 2000]\nfree = "
                     "0\n[inputs.F]\nunit = 'N'\n[forces.push]\ncoordinate = 'y'\nmagnitude = "
                     "'F'\n[outputs.y]\nposition = 'y'\n[run]\nstep = 0.3\n");
  EXPECT_TRUE(contains(scene.err("impulse_taylor", 0, "span.stop=3"),
                       "bend within a step beyond their Taylor polynomial"));
}

TEST(ImpulseScenario, RefusesMatchedHoldByName) {
  EXPECT_TRUE(contains(Inner("110").err("impulse", 2, "connections.reconstruction=matched_hold"),
                       "matched_hold is no reconstruction for a link that is coupled by impulse"));
}

/// A stiffness that is stated is that which is found, to half a percent.
TEST(ImpulseScenario, ChecksAStiffnessThatIsStated) {
  const auto said = [](const char* stiffness) {
    return SceneRun(two_mass_file("impulse.toml"), {"parameters.frequency_ratio=20", "span.stop=40",
                                                    "coordination.coupling=impulse_stiffness",
                                                    std::string("links[0].effective_stiffness=") + stiffness})
        .said()
        .err;
  };
  const std::string note = "otherwise than a mass on this spring and damper";
  EXPECT_FALSE(contains(said("0.25313"), note));
  EXPECT_TRUE(contains(said("0.2560"), note));
}

/// Grams for kilograms: no reaction tells it then, but that of the start.
TEST(ImpulseScenario, NotesAStatedMassThatTheStartDoesNotFind) {
  const SceneRun run(two_mass_file("impulse.toml"), {"span.stop=20", "links[0].effective_mass=2564.7"});
  EXPECT_TRUE(contains(run.said().err, "effective mass is stated as 2564.7")) << run.said().err;
}

TEST(ImpulseScenario, RefusesAccelerancesOfNamesThatAreNotThere) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"info", "mechanism:" + taylor_scene + "pendulum.toml?accelerances=x.by.G"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "'accelerances'") && contains(said.err, "'G'")) << said.err;
}

}  // namespace
}  // namespace tandem::test
