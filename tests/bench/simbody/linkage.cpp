// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "simbody/linkage.hpp"

#include <Simbody.h>

#include <algorithm>
#include <cmath>

#include "tandem/error.hpp"

namespace tandem::simbody {
namespace {

using four_bar::Course;
using four_bar::Knot;
using SimTK::MobilizedBody;
using SimTK::Vec3;
using Integrator = std::shared_ptr<SimTK::Integrator>;  // which has no virtual destructor

struct IntegratorEntry {
  std::string name;
  Integrator (*make)(const SimTK::System&);
};

template <class Method>
Integrator make(const SimTK::System& system) {
  return std::make_shared<Method>(system);
}

/// Without CPodes: its vectors have the names of those of SUNDIALS, which this program links too.
const std::vector<IntegratorEntry>& integrators() {
  static const std::vector<IntegratorEntry> all = {
      {"RungeKuttaMerson", make<SimTK::RungeKuttaMersonIntegrator>},
      {"RungeKutta3", make<SimTK::RungeKutta3Integrator>},
      {"Verlet", make<SimTK::VerletIntegrator>},
      {"SemiExplicitEuler2", make<SimTK::SemiExplicitEuler2Integrator>}};
  return all;
}

[[noreturn]] void refuse(const std::string& integrator) {
  std::string sentence = "Simbody's integrator is '" + integrator + "'; allowed is one of";
  for (const std::string& name : integrator_names()) sentence += " " + name;
  throw Error(ErrorCode::invalid_argument, sentence);
}

Integrator make_integrator(const Settings& settings, const SimTK::System& system) {
  const auto found = std::find_if(integrators().begin(), integrators().end(),
                                  [&](const auto& entry) { return entry.name == settings.integrator; });
  if (found == integrators().end()) refuse(settings.integrator);
  const Integrator integrator = found->make(system);
  integrator->setAccuracy(settings.accuracy);
  if (settings.tolerance > 0.0) integrator->setConstraintTolerance(settings.tolerance);
  if (settings.step > 0.0) integrator->setFixedStepSize(settings.step);
  integrator->setProjectEveryStep(settings.step > 0.0);
  integrator->setReturnEveryInternalStep(true);
  integrator->setProjectInterpolatedStates(false);  // none is asked for but the last
  return integrator;
}

/// A uniform rod of 1 kg from the origin to `to`, 1 m away, that carries a mass there.
SimTK::Body::Rigid rod(const Vec3& to, double carried = 0.0) {
  const SimTK::Inertia about_origin = SimTK::Inertia::pointMassAt(to, 1.0 / 3.0 + carried);
  const Vec3 centre = (0.5 + carried) / (1.0 + carried) * to;
  return SimTK::Body::Rigid(SimTK::MassProperties(1.0 + carried, centre, about_origin));
}

}  // namespace

std::vector<std::string> integrator_names() {
  std::vector<std::string> names;
  for (const IntegratorEntry& entry : integrators()) names.push_back(entry.name);
  return names;
}

/// Cranks turn from upright and couplers from level, counter-clockwise, each from the body before.
struct Linkage::Model {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::Gravity gravity{forces, matter, SimTK::UnitVec3(0, -1, 0), 9.81};
  std::vector<MobilizedBody::Pin> cranks, couplers;
  SimTK::State start;

  Model(int loops, four_bar::Start from, Closing closing) {
    closing == Closing::rod ? chain(loops) : close_each(loops);
    system.realizeTopology();
    start = system.getDefaultState();
    system.realizeModel(start);
    const bool hanging = from == four_bar::Start::hanging;
    const double angle = hanging ? SimTK::Pi : 0.0, rate = hanging ? 1.0 : -1.0;
    for (auto& crank : cranks) crank.setAngle(start, angle), crank.setRate(start, rate);
    const std::size_t on_cranks = closing == Closing::rod ? 1 : couplers.size();
    for (std::size_t i = 0; i < on_cranks; ++i)
      couplers[i].setAngle(start, -angle), couplers[i].setRate(start, -rate);
  }

  void add_crank(int i) { cranks.emplace_back(matter.Ground(), Vec3(i, 0, 0), rod(Vec3(0, 1, 0)), Vec3(0)); }

  void close_each(int loops) {
    for (int i = 0; i <= loops; ++i) add_crank(i);
    for (int i = 0; i < loops; ++i) {
      couplers.emplace_back(cranks[i], Vec3(0, 1, 0), rod(Vec3(1, 0, 0)), Vec3(0));
      SimTK::Constraint::PointOnLine(cranks[i + 1], SimTK::UnitVec3(0, 0, 1), Vec3(0, 1, 0), couplers.back(),
                                     Vec3(1, 0, 0));
    }
  }

  void chain(int loops) {
    const Vec3 end(1, 0, 0);
    add_crank(0);
    for (int i = 0; i < loops; ++i) {
      MobilizedBody& before = i == 0 ? cranks[0] : couplers.back();
      const Vec3 pin = i == 0 ? Vec3(0, 1, 0) : end;
      couplers.emplace_back(before, pin, rod(end, 1.0 / 3.0), Vec3(0));
      SimTK::Constraint::Rod(matter.Ground(), Vec3(i + 1, 0, 0), couplers.back(), end, 1.0);
      SimTK::Force::ConstantForce(forces, couplers.back(), end, Vec3(0, -9.81 / 6.0, 0));
    }
  }

  Knot knot(const SimTK::State& s) const {
    const double angle = cranks[0].getOneQ(s, 0), rate = cranks[0].getOneU(s, 0);
    const double x = -std::sin(angle), y = std::cos(angle);
    return {s.getTime(), x, y, -y * rate, x * rate, cranks.size() > 1 ? skew(s, x, y) : chain_skew(s, angle)};
  }

  double skew(const SimTK::State& s, double x, double y) const {
    double most = 0.0;
    for (const auto& crank : cranks) {
      const double angle = crank.getOneQ(s, 0);
      most = std::max(most, std::hypot(-std::sin(angle) - x, std::cos(angle) - y));
    }
    return most;
  }

  double chain_skew(const SimTK::State& s, double angle) const {
    double most = 0.0, x = 0.0, y = 0.0;  // of a coupler's end, from where it should be
    for (const auto& coupler : couplers) {
      angle += coupler.getOneQ(s, 0);
      x += std::cos(angle) - 1.0, y += std::sin(angle);
      most = std::max(most, std::hypot(x, y));
    }
    return most;
  }
};

Linkage::Linkage(int loops, four_bar::Start start, Closing closing)
    : model_(std::make_unique<Model>(loops, start, closing)) {}
Linkage::~Linkage() = default;

Course Linkage::run(const Settings& settings, double end) const {
  const Integrator integrator = make_integrator(settings, model_->system);
  integrator->setFinalTime(end);
  Course course;
  const double began = four_bar::thread_seconds();
  try {
    integrator->initialize(model_->start);
    course.knots.push_back(model_->knot(integrator->getState()));
    while (course.knots.back().time < end && course.ended == Course::Ended::at_the_end) {
      integrator->stepTo(end, end);  // the first ends at the start
      if (integrator->getTime() > course.knots.back().time)
        course.knots.push_back(model_->knot(integrator->getState()));
      if (lost(course.knots.back())) course.ended = Course::Ended::lost;
      if (four_bar::thread_seconds() - began > settings.patience) course.ended = Course::Ended::given_up;
    }
  } catch (const std::exception& error) {
    course.ended = Course::Ended::failed;
    course.reason = error.what();
  }
  course.seconds = four_bar::thread_seconds() - began;
  return course;
}

}  // namespace tandem::simbody
