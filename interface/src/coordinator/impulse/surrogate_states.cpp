// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "surrogate.hpp"
#include "tandem/error.hpp"

namespace tandem {

void Surrogate::write(ByteWriter& to) const {
  to.put(slow_.begin());
  to.put(std::uint8_t{passed_}), to.put(std::int32_t{steps_});
  for (const Forces* one : {&forces_[2], &net_, &accelerations_})
    for (const double number : *one) to.put(number);
  accelerance_.write(to);
  for (const SurrogateLink& link : links_) link.write(to);
  for (const ReactionCheck& check : checks_) check.write(to);
  for (const double one : begin_position_) to.put(one);
  for (const double one : {worst_, worst_at_, changed_, changed_at_}) to.put(one);
  rest_.write(to);
}

void Surrogate::read(ByteReader& from) {
  slow_.begin_at(from.take<double>());
  passed_ = from.take<std::uint8_t>() != 0, steps_ = from.take<std::int32_t>();
  for (Forces* one : {&forces_[2], &net_, &accelerations_})
    for (double& number : *one) number = from.take<double>();
  accelerance_.read(from);
  for (SurrogateLink& link : links_) link.read(from);
  for (ReactionCheck& check : checks_) check.read(from);
  for (double& one : begin_position_) one = from.take<double>();
  for (double* one : {&worst_, &worst_at_, &changed_, &changed_at_}) *one = from.take<double>();
  rest_.read(from);
}

std::vector<double*> Surrogate::numbers() {
  std::vector<double*> all;
  const auto add = [&](std::span<double> some) {
    for (double& one : some) all.push_back(&one);
  };
  for (Forces* one : {&forces_[2], &net_, &accelerations_, &begin_position_}) add(*one);
  if (varies()) add(accelerance_.values()), add(accelerance_.rates());
  for (SurrogateLink& link : links_)
    for (double* one : link.numbers()) all.push_back(one);
  return all;
}

std::optional<std::vector<StateName>> Surrogate::states() const {
  std::vector<StateName> names;
  Surrogate copy = *this;
  for (std::size_t k = 1; k <= copy.numbers().size(); ++k)
    names.push_back({"state " + std::to_string(k), ""});
  return names;
}

void Surrogate::get_states(std::span<double> x) const {
  Surrogate copy = *this;
  if (!passed_ && steps_ > 0)
    throw Error(ErrorCode::not_supported,
                "impulse coupling: the surrogate stands between two nodes of the slow side; allowed for its "
                "states is at one");
  for (std::size_t k = 0; k < size() && !passed_; ++k)
    copy.links_[k].begin_at_node(of_.links[k].free_acceleration, of_.slow_step);
  std::size_t at = 0;
  for (const double* one : copy.numbers()) x[at++] = *one;
}

void Surrogate::set_states(std::span<const double> x) {
  for (SurrogateLink& link : links_) link.go_on(of_.slow_step);
  std::size_t k = 0;
  for (double* one : numbers()) *one = x[k++];
  passed_ = true, steps_ = of_.degree + 1;
  slow_.make_end_of_begin();
}

}  // namespace tandem
