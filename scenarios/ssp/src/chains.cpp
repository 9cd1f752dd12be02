// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "chains.hpp"

#include <algorithm>

#include "tandem/coordinator/units.hpp"
#include "tandem/printable.hpp"
#include "tandem/text/place.hpp"

namespace tandem::ssp {
namespace {

struct Affine {
  double factor = 1.0, offset = 0.0;

  void then(double by, double and_add) { factor *= by, offset = by * offset + and_add; }
};

/// A value on its way: what has been made of it, and its unit.
class Carrier {
 public:
  Carrier(Structure& in, std::string unit) : in_(in), unit_(std::move(unit)) {}

  /// To a node, by what leads there.
  void go(const Node& to, const Transformation& how, int line) {
    const std::string unit = in_.unit(to);
    if (!how.keeps_number) convert(unit, to, line);
    if (how.keeps_number || !unit.empty()) unit_ = unit;
    all_.then(how.factor, how.offset);
  }

  const Affine& all() const { return all_; }

 private:
  void convert(const std::string& unit, const Node& to, int line) {
    if (unit.empty() || unit_.empty() || unit == unit_) return;
    if (const auto conversion = convert_unit(unit_, unit))
      return all_.then(conversion->factor, conversion->shift);
    const auto a = base_unit(unit_), b = base_unit(unit);
    if (!a || !b || a->exponents != b->exponents) return check_unknown(unit, to, line);
    all_.then(a->factor / b->factor, (a->offset - b->offset) / b->factor);  // a torque and an energy
  }

  void check_unknown(const std::string& unit, const Node& to, int line) {
    bool any = false;
    for (const std::string& one : {unit_, unit})
      if (!base_unit(one)) any = true, in_.unknown_units.insert(printable(one, 100));
    if (!any)
      text::refuse(
          {in_.file.string(), line},
          "'" + printable(to.second, 200) + "' takes values of unit '" + printable(unit_, 100) +
              "' in unit '" + printable(unit, 100) +
              "', which is of another kind; allowed are units of one kind, or suppressUnitConversion");
  }

  Structure& in_;
  std::string unit_;
  Affine all_;
};

/// The number itself, or each of an array. Others are left as they are, if nothing is to be made of them.
void transform(Given& given, const Affine& by, const Structure& in) {
  const auto change = [&](double& value) { value = by.factor * value + by.offset; };
  if (double* number = std::get_if<double>(&given.value)) return change(*number);
  if (auto* list = std::get_if<std::vector<double>>(&given.value)) {
    std::for_each(list->begin(), list->end(), change);
    return;
  }
  if (by.factor != 1.0 || by.offset != 0.0)
    text::refuse({in.file.string(), given.line},
                 "a linear transformation is to be made of a value that is no number; allowed is a number");
}

}  // namespace

Chain chain_to(const Structure& in, const Node& node) {
  constexpr std::size_t most = 256;  // systems lie in each other 32 deep
  Chain chain{node};
  for (auto it = in.into.find(node); it != in.into.end(); it = in.into.find(chain.source)) {
    const Edge& edge = in.edges[it->second];
    chain.edges.push_back(&edge);
    chain.source = edge.from;
    if (chain.edges.size() > in.edges.size())
      text::refuse({in.file.string(), edge.line},
                   "connectors lead back to themselves; allowed are connections from a component");
    if (chain.edges.size() > most)
      text::refuse({in.file.string(), edge.line},
                   "'" + printable(node.second, 200) + "' takes its values through more than " +
                       std::to_string(most) + " connections; allowed are fewer");
  }
  std::reverse(chain.edges.begin(), chain.edges.end());
  return chain;
}

Gain gain_of(Structure& in, const Chain& chain) {
  Carrier carrier(in, in.unit(chain.source));
  for (const Edge* edge : chain.edges) carrier.go(edge->to, edge->how, edge->line);
  const std::string from = in.unit(chain.source), to = in.unit(chain.edges.back()->to);
  const bool differ = from != to && !from.empty() && !to.empty();
  const auto unit = convert_unit(from, to);
  const bool kept = !unit || std::any_of(chain.edges.begin(), chain.edges.end(),
                                         [](const Edge* edge) { return edge->how.keeps_number; });
  const Edge& first = *chain.edges.front();
  const Affine& all = carrier.all();
  if (chain.edges.size() == 1 && (!differ || !kept))
    return {first.how.factor, first.how.offset, differ, false};
  if (!differ || kept) return {all.factor, all.offset, false, differ};
  const double gain = all.factor / unit->factor;
  return {gain, all.offset - gain * unit->shift, true, false};
}

std::optional<Given> given_through(Structure& in, const Chain& chain) {
  const Given* newest = nullptr;
  std::size_t after = 0;  // the edges that are behind it
  const bool is_read = !chain.edges.empty() && !in.at(chain.source.first).is_system();
  for (std::size_t k = is_read ? 1 : 0; k <= chain.edges.size(); ++k) {
    const Node& node = k == 0 ? chain.source : chain.edges[k - 1]->to;
    const auto it = in.given.find(node);
    if (it != in.given.end() && (!newest || it->second.order > newest->order))
      newest = &it->second, after = k;
  }
  if (!newest) return std::nullopt;
  Given given = *newest;
  Carrier carrier(in, given.unit);
  carrier.go(after == 0 ? chain.source : chain.edges[after - 1]->to, given.how, given.line);
  for (; after < chain.edges.size(); ++after)
    carrier.go(chain.edges[after]->to, chain.edges[after]->how, chain.edges[after]->line);
  transform(given, carrier.all(), in);
  return given;
}

}  // namespace tandem::ssp
