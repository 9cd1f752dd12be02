// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "taylor_coordinate.hpp"

namespace tandem {

void TaylorCoordinate::step(double h, const double (&a)[4], const double (&pulse)[3]) {
  const double middle = (a[1] + a[2]) / 2.0;
  integrals_.step(h, {a[0], middle, a[3]});
  z_ += h * (v_ + h * (a[0] + 2.0 * middle + pulse[0] + 2.0 * pulse[1]) / 6.0);
  v_ += h * (a[0] + 4.0 * middle + a[3] + pulse[0] + 4.0 * pulse[1] + pulse[2]) / 6.0;
}

double TaylorCoordinate::pass(double h, double s, double before, double now, double length, double next) {
  const double a = window_.pass(integrals_.cut_at_node(h, s, before, now), length, next);
  foreseen_rate_ = rate_ + length * a;
  foreseen_ = at_ + length * (rate_ + length * a / 2.0);
  return a;
}

void TaylorCoordinate::take(double q, double u, double lacks, double s, double length, double next,
                            bool jumps) {
  const DefectPulse defect(q - foreseen_, u - foreseen_rate_, next);
  if (jumps)
    z_ += defect.free(s), v_ += defect.free_rate();
  else
    pulse_.turn_to(defect, s, z_, v_);
  const double sigma = lacks / (length * length * length);
  cubic_ = first_ ? sigma : 2.0 * sigma - sigma_;
  sigma_ = sigma, first_ = false, at_ = q, rate_ = u;
}

void TaylorCoordinate::write(ByteWriter& to) const {
  for (const double one : {z_, v_, at_, rate_, foreseen_, foreseen_rate_, cubic_, sigma_}) to.put(one);
  to.put(std::uint8_t{first_});
  pulse_.write(to), integrals_.write(to), window_.write(to);
}

void TaylorCoordinate::read(ByteReader& from) {
  for (double* one : {&z_, &v_, &at_, &rate_, &foreseen_, &foreseen_rate_, &cubic_, &sigma_})
    *one = from.take<double>();
  first_ = from.take<std::uint8_t>() != 0;
  pulse_.read(from), integrals_.read(from), window_.read(from);
}

}  // namespace tandem
