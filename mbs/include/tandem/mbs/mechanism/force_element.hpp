// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/elements.hpp"

namespace tandem::text {
class KeyList;
}

namespace tandem::mbs {

/// Where a force element stands: values and rates of its coordinates, and its inputs, in its own order. SI
/// units.
struct ElementState {
  const double *x, *v, *u;
  /// By coordinate, what counts as a length of one: the mechanism's (Structure::unit()) [m], of vectors,
  /// angles and states 1. None: all 1.
  const double* size = nullptr;
};

/// A force law of one's own between any coordinates of a mechanism: a tyre, an aerodynamic force, a rotor.
/// Nothing in it changes while a mechanism moves; what has a memory keeps it in a coordinate (ElementKeys::
/// state).
class ForceElement {
 public:
  struct Quantity {
    std::string name, unit;
    bool follows_inputs = false;  ///< depends on an input of the element at the same instant
  };

  virtual ~ForceElement() = default;

  /// What it acts on or depends on, each once.
  const std::vector<Coordinate>& coordinates() const { return coordinates_; }
  /// Inputs of the description.
  const std::vector<int>& inputs() const { return inputs_; }

  /// Adds the generalized force on each coordinate.
  virtual void add(const ElementState& at, double* force) const = 0;
  /// Adds K = -dQ/dx and C = -dQ/dv, matrices of as many rows and columns as there are coordinates; by
  /// central differences over a millionth of `at.size` unless it is overridden. Small terms may be left out.
  virtual void add_derivatives(const ElementState& at, Eigen::Ref<Eigen::MatrixXd> k,
                               Eigen::Ref<Eigen::MatrixXd> c) const;
  /// K and C are symmetric, but for rows and columns of states.
  virtual bool symmetric() const { return false; }
  virtual double potential(const double* /*x*/) const { return 0.0; }  ///< [J]

  /// What outputs may name, and their values.
  virtual std::vector<Quantity> quantities() const { return {}; }
  virtual void measure(const ElementState& /*at*/, double* /*values*/) const {}

 protected:
  ForceElement(std::vector<Coordinate> coordinates, std::vector<int> inputs)
      : coordinates_(std::move(coordinates)), inputs_(std::move(inputs)) {}

 private:
  std::vector<Coordinate> coordinates_;
  std::vector<int> inputs_;
};

struct NamedElement {
  std::string name;
  std::shared_ptr<const ForceElement> force;
  std::string where = {};
};

/// The table of an element in a mechanism's file, while it is read by the keys that its kind lists. One that
/// is not there is as the list says, or refused, as is what is wrong, with its place. Points and vectors are
/// numbers of the description's entities.
class ElementKeys {
 public:
  virtual ~ElementKeys() = default;
  virtual int dimension() const = 0;
  virtual bool has(const std::string& key) = 0;
  virtual double number(const std::string& key) = 0;
  virtual double positive(const std::string& key) = 0;
  virtual bool flag(const std::string& key) = 0;
  virtual std::string text(const std::string& key) = 0;
  /// Refuses a listed key that has no meaning beside the others: "why" ends the sentence.
  virtual void leave_out(const std::string& key, const std::string& why) = 0;
  /// What fails in `use` is refused with the key's place.
  virtual void at(const std::string& key, const std::function<void()>& use) = 0;

  virtual int point(const std::string& key) = 0;
  virtual int vector(const std::string& key) = 0;
  virtual std::vector<int> vectors(const std::string& key) = 0;
  virtual Coordinate coordinate(const std::string& key) = 0;
  virtual std::vector<Coordinate> coordinates(const std::string& key) = 0;
  /// An input's name; a unit other than this is refused. -1: the key is not there.
  virtual int input(const std::string& key, const std::string& unit) = 0;
  /// Of a point or vector.
  virtual Eigen::Vector3d drawn(int entity) const = 0;
  std::vector<Coordinate> axes(int entity) const;  ///< its coordinates

  /// A coordinate more, whose rate is a state of the element: the force on it is the rate's derivative.
  virtual Coordinate state(const std::string& name) = 0;
  virtual void add_inertia(const Coordinate& coordinate, double value) = 0;
  virtual void add_mass(int point, double mass) = 0;
};

/// A kind of elements: what it is, the keys of its table (each has to be asked for, or left out, when one is
/// made), and what makes one.
struct ElementKind {
  std::string sentence;
  void (*keys)(text::KeyList& to);
  std::function<std::unique_ptr<ForceElement>(ElementKeys&)> make;
};
/// By the word of the key `kind`.
using ElementKinds = std::map<std::string, ElementKind>;

}  // namespace tandem::mbs
