// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string>
#include <vector>

namespace tandem {

class ByteReader;
class ByteWriter;

/// The equations of a slow side, for a surrogate of it in the same process (docs/impulse_coupling.md):
///
///     M(q) q'' = f(q, q') + B(q) F,
///
/// with n independent coordinates q and p links, each a force F and a displacement y(q). f is without the forces on the links
/// and on coordinates. Units are those of the side. Calls may throw Error(numerical) where q can't be.
class SlowModel {
 public:
  virtual ~SlowModel() = default;

  virtual int links() const = 0;  ///< p
  /// The side's outputs with q, each with two derivatives, and its inputs of a generalised force on each: scalars by name.
  virtual std::vector<std::string> coordinates() const = 0;
  virtual std::vector<std::string> reactions() const = 0;
  /// By so much of each coordinate the equations change notably; finite, above 0.
  virtual std::vector<double> units() const = 0;

  /// At a node of the side, time t [s]: from here on f is that of then, with all other inputs as the side has them.
  virtual void stand_at(double t) = 0;
  /// M^-1 f; u = q'.
  virtual void accelerations(std::span<const double> q, std::span<const double> u, std::span<double> a) = 0;
  /// M^-1 b of generalised forces b.
  virtual void answer(std::span<const double> q, std::span<const double> b, std::span<double> a) = 0;
  /// M a, the generalised forces that accelerate so.
  virtual void inertia(std::span<const double> q, std::span<const double> a, std::span<double> b) = 0;
  /// B, n numbers for each link: the generalised forces of a force of 1 there.
  virtual void pushes(std::span<const double> q, std::span<double> b) = 0;
  /// Of each link y and its rate. Called for each own step of the surrogate.
  virtual void motions(std::span<const double> q, std::span<const double> u, std::span<double> y,
                       std::span<double> rates) = 0;

  /// What its answers go by since stand_at(), to the last bit: nothing, unless told otherwise. Always so many bytes.
  virtual void write(ByteWriter&) const {}
  virtual void read(ByteReader&) {}
};

/// A link on a slow side: an input and an output of it, by scalars.
struct SlowLink {
  int force, displacement;
};

}  // namespace tandem
