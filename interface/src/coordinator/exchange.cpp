// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "feedthrough.hpp"

namespace tandem {
namespace {

double lag_of(Lag lag, int reader, const LinkTimes& times) {
  if (lag == Lag::memory) return times.memory[static_cast<std::size_t>(reader)];
  return lag == Lag::delay ? times.delay : 0.0;
}

/// Of a term's pieces that which begins with a jump where this piece of the sum does: the last of them, if there is one.
const Segment* jump_at(std::span<const Segment> pieces, const Segment& of_sum,
                       const TimeTolerance& tolerance) {
  const auto jump = std::find_if(pieces.rbegin(), pieces.rend(), [&](const Segment& s) {
    return tandem_segment_jumps(&s) &&
           std::abs(s.origin - of_sum.origin) <= tolerance.width(s.origin, of_sum.origin);
  });
  return jump == pieces.rend() ? nullptr : &*jump;
}

/// The pieces that a call up to the limit reads.
Signal up_to(const Signal& signal, double limit, const TimeTolerance& tolerance) {
  const auto pieces = signal.segments();
  std::size_t last = 0;
  while (last + 1 < pieces.size() && !tolerance.before(limit, pieces[last].end)) ++last;
  return Signal(pieces.data(), static_cast<std::int32_t>(last + 1), signal.degree());
}

/// Whether what the source gives may jump with events of another.
bool carries_jumps(const SubsystemInfo& source, const Link& link, const LinkTimes& times) {
  return !times.carries.empty() && times.carries[static_cast<std::size_t>(link.source())] &&
         std::any_of(link.lanes().begin(), link.lanes().end(),
                     [&](const Lane& lane) { return follows(source, lane.output); });
}

/// Whether the reader ends a step where an output of the source is known to jump.
bool ends_steps_at(const SubsystemInfo& source, int reader, bool carries, const LinkTimes& times) {
  if (times.shortest_period.empty()) return false;
  const double shortest = times.shortest_period[static_cast<std::size_t>(reader)];
  return source.abilities.events || carries ? std::isfinite(shortest)
                                            : source.abilities.sampled && source.sampling.period >= shortest;
}

}  // namespace

Exchange::Exchange(const Topology& topology, double t_start, const LinkTimes& times,
                   std::span<const std::int64_t> capacities)
    : tolerance_(t_start) {
  ends_.reserve(static_cast<std::size_t>(topology.size()));
  links_.reserve(topology.lines().size() + times.watches.size());
  for (int i = 0; i < topology.size(); ++i) {
    const auto inputs = static_cast<std::size_t>(topology.info(i).input_size());
    History history(topology.name(i), topology.info(i), capacities[static_cast<std::size_t>(i)]);
    ends_.emplace_back(std::move(history), inputs);
  }
  std::map<std::pair<int, int>, std::vector<std::size_t>> of_pairs;
  for (const Line& line : topology.lines())
    add_line(topology, line, times, of_pairs[{line.source, line.reader}]);
  for (const Watch& watch : times.watches) add_watch(watch);
  for (int i = 0; i < topology.size(); ++i) hold_start_values(topology, i), drive(topology, i, t_start);
  for (std::size_t i = 0; i < times.breaks.size(); ++i) ends_[i].known_breaks = times.breaks[i];
  for (Link& link : links_) {
    End &source = ends_[static_cast<std::size_t>(link.source())],
        &reader = ends_[static_cast<std::size_t>(link.reader())];
    const bool at_instants = topology.info(link.reader()).abilities.sampled;
    const SubsystemInfo& info = topology.info(link.source());
    const bool carries = !at_instants && carries_jumps(info, link, times);
    if (carries) link.expect_jumps();
    link.attach(source.history, tolerance_);
    source.out.insert(at_instants ? source.out.begin() : source.out.end(), &link);
    source.at_instants += at_instants ? 1 : 0;
    reader.in.push_back(&link);
    if (ends_steps_at(info, link.reader(), carries, times)) reader.breaks.push_back(&link);
  }
}

/// The link that this line belongs to: same source, reader, reconstruction and delay. of_pair: numbers of the
/// links between the two.
Link& Exchange::link_for(const Topology& topology, const Line& line, const LinkTimes& times,
                         std::vector<std::size_t>& of_pair) {
  const bool just_before = topology.just_before(line);
  const double delay = just_before ? 0.0 : lag_of(line.lag, line.reader, times);
  for (const std::size_t k : of_pair)
    if (links_[k].how() == line.how && links_[k].delay() == delay && links_[k].just_before() == just_before)
      return links_[k];
  of_pair.push_back(links_.size());
  Link& link = links_.emplace_back(line.source, line.reader, line.how, delay);
  const auto source = static_cast<std::size_t>(line.source), reader = static_cast<std::size_t>(line.reader);
  if (!times.nearest.empty() && times.nearest[source] > 0.0) link.pass_over(times.nearest[source]);
  if (topology.info(line.source).abilities.events) link.expect_jumps();
  if (topology.info(line.reader).abilities.sampled)
    link.read_at_instants(times.loop.empty() || times.loop[source] == times.loop[reader], just_before);
  return link;
}

void Exchange::add_line(const Topology& topology, const Line& line, const LinkTimes& times,
                        std::vector<std::size_t>& of_pair) {
  End& reader = ends_[static_cast<std::size_t>(line.reader)];
  auto slot = static_cast<std::size_t>(line.input);
  if (const auto terms = topology.lines_to(line.reader, line.input); terms.size() > 1) {
    const auto known =
        std::find_if(reader.sums.begin(), reader.sums.end(), [&](const Sum& s) { return s.input == slot; });
    const bool first = known == reader.sums.end();
    Sum& sum =
        first ? reader.sums.emplace_back(Sum{slot, reader.slots.size(), terms.size(), {}, {}}) : *known;
    if (first) reader.slots.resize(reader.slots.size() + terms.size());
    reader.has_more = true;
    const auto number = static_cast<int>(&line - topology.lines().data());
    slot =
        sum.first + static_cast<std::size_t>(std::find(terms.begin(), terms.end(), number) - terms.begin());
  }
  const bool held = scalar_at(topology.info(line.source).outputs, line.output).port->held;
  link_for(topology, line, times, of_pair)
      .add({line.output, static_cast<int>(slots_of_lines_.emplace_back(slot)), line.gain, line.offset, held});
}

/// A link of its own, into a place that is no input's.
void Exchange::add_watch(const Watch& watch) {
  const Reconstruction held{Reconstruction::Kind::held};
  End& reader = ends_[static_cast<std::size_t>(watch.reader)];
  Link& link = links_.emplace_back(watch.source, watch.reader, held, watch.lag);
  link.add({watch.output, static_cast<int>(reader.slots.size()), 1.0, 0.0, true});
  reader.slots.resize(reader.slots.size() + 1);
}

std::int64_t Exchange::accept(int source, double t_limit) {
  End& end = ends_[static_cast<std::size_t>(source)];
  const NewRows rows = end.history.commit(t_limit, tolerance_);
  for (std::size_t k = 0; k < end.out.size(); ++k)
    if (k < end.at_instants)
      end.out[k]->extend(rows);
    else
      end.out[k]->wait(rows.count);
  return rows.count;
}

void Exchange::publish(int source) {
  for (Link* link : ends_[static_cast<std::size_t>(source)].out) link->extend_late();
}

double Exchange::next_break(int reader, double time) const {
  const End& end = ends_[static_cast<std::size_t>(reader)];
  double first = Member::never;
  for (const Link* link : end.breaks) first = std::min(first, link->next_break(time));
  const auto known =
      std::upper_bound(end.known_breaks.begin(), end.known_breaks.end(), time + tolerance_.width(time, time));
  return known == end.known_breaks.end() ? first : std::min(first, *known);
}

void Exchange::remake_newest(int source) {
  const End& end = ends_[static_cast<std::size_t>(source)];
  const double* row = end.history.row(end.history.newest());
  for (Link* link : end.out) link->remake(row);
}

void Exchange::withdraw(int source, std::int64_t rows) {
  End& end = ends_[static_cast<std::size_t>(source)];
  end.history.withdraw(rows);
  for (Link* link : end.out) link->withdraw(rows);
}

Exchange::Jump Exchange::jump(int source, int reader, double until) const {
  const End& end = ends_[static_cast<std::size_t>(source)];
  const double t = end.history.time(end.history.newest());
  Jump jump;
  for (const Link* link : end.out)
    if (const double size = link->newest_jump();
        link->reader() == reader && size != 0.0 && tolerance_.before(t + link->delay(), until))
      jump.add({size, t + link->delay()});
  return jump;
}

void Exchange::rebuild(int reader) {
  for (Link* link : ends_[static_cast<std::size_t>(reader)].in) link->rebuild();
}

std::span<const double> Exchange::sample(int reader, TimeSpan to) {
  End& end = ends_[static_cast<std::size_t>(reader)];
  for (Link* link : end.in) link->sample(to, end.values.data());
  for (const Sum& sum : end.sums) {
    const auto first = end.values.begin() + static_cast<std::ptrdiff_t>(sum.first);
    end.values[sum.input] = std::accumulate(first, first + static_cast<std::ptrdiff_t>(sum.count), 0.0);
  }
  for (Driven& input : end.driven) end.values[input.slot()] = input.at(to.stop);
  return {end.values.data(), static_cast<std::size_t>(end.inputs)};
}

/// The sum's breaks are those of all its terms, and it jumps where one does: by a marked piece of no length,
/// after which it goes on as elsewhere. Each piece has its origin at its end, where a term's node is,
/// so it too depends on the samples alone.
void Exchange::add_up(Sum& sum, std::span<Signal> slots, double limit) const {
  const auto terms = slots.subspan(sum.first, sum.count);
  for (Signal& term : terms) term = up_to(term, limit, tolerance_);
  sum.segments.clear();
  const double begin = first_jump_end(terms);
  for (const Signal& term : terms) add_pieces(sum, term, begin);
  add_rest(sum, terms);
  const auto jumps = [](const Segment& s) { return tandem_segment_jumps(&s); };
  std::sort(sum.segments.begin(), sum.segments.end(), [&](const Segment& a, const Segment& b) {
    return std::tuple(a.end, jumps(a), a.origin) < std::tuple(b.end, jumps(b), b.origin);
  });
  const auto last =
      std::unique(sum.segments.begin(), sum.segments.end(), [&](const Segment& a, const Segment& b) {
        return jumps(a) == jumps(b) && (a.end == b.end || b.end - a.end <= tolerance_.width(a.end, a.end));
      });
  sum.segments.erase(last, sum.segments.end());
  sum.jumps.clear();
  for (Segment& s : sum.segments) sum.jumps.push_back(jumps(s) != 0), mark_jump(s, false);
  int degree = 0;
  for (const Signal& term : terms)
    add_term(sum, term), degree = std::max(degree, static_cast<int>(term.degree()));
  for (std::size_t k = 0; k < sum.segments.size(); ++k) mark_jump(sum.segments[k], sum.jumps[k] != 0);
  slots[sum.input] = Signal(sum.segments.data(), static_cast<std::int32_t>(sum.segments.size()), degree);
}

/// To each piece of the sum that piece of the term which holds up to its end.
void Exchange::add_term(Sum& sum, const Signal& term) const {
  const auto pieces = term.segments();
  std::size_t at = 0;
  for (std::size_t k = 0; k < sum.segments.size(); ++k) {
    Segment& s = sum.segments[k];
    while (at + 1 < pieces.size() && pieces[at].end < s.end) ++at;
    const Segment* const jump = sum.jumps[k] ? jump_at(pieces, s, tolerance_) : nullptr;
    add_shifted(jump ? *jump : pieces[at], s.origin, s.c);
  }
}

/// Terms that begin with a jump have jumped by the begin of the call, and so has the sum: the last such end.
double Exchange::first_jump_end(std::span<const Signal> terms) const {
  double end = -Member::never;
  for (const Signal& term : terms)
    if (const Segment& s = term.segments().front(); tandem_segment_jumps(&s))
      end = std::max(end, s.origin + tolerance_.width(s.origin, s.origin));
  return end;
}

/// Those of a term that go on past `begin`, and those jumps that are not before it.
void Exchange::add_pieces(Sum& sum, const Signal& term, double begin) const {
  for (const Segment& s : term.segments()) {
    const double jump_end = s.origin + tolerance_.width(s.origin, s.origin);
    if (s.end > begin) sum.segments.push_back({s.end, s.origin, {}});
    if (!tandem_segment_jumps(&s) || jump_end < begin) continue;
    sum.segments.push_back({jump_end, s.origin, {}});
    mark_jump(sum.segments.back(), true);
  }
}

/// Where the last sample of a term is the second of its time, what goes on behind it is another polynomial
/// than that which ends there. Its origin is that of the last piece, as it is where only that is left.
void Exchange::add_rest(Sum& sum, std::span<const Signal> terms) const {
  bool any = false;
  double origin = -Member::never;
  for (const Signal& term : terms) {
    const auto segments = term.segments();
    origin = std::max(origin, segments.back().origin);
    any = any || (segments.size() > 1 && segments[segments.size() - 2].end >= segments.back().end);
  }
  if (any) sum.segments.push_back({std::numeric_limits<double>::infinity(), origin, {}});
}

void Exchange::make_room(int source, std::int64_t wanted) {
  End& end = ends_[static_cast<std::size_t>(source)];
  std::int64_t keep = end.history.newest();
  if (end.keep_from != Member::never)  // also for observers, which are not told yet
    while (keep > end.history.oldest() && !tolerance_.before(end.history.time(keep), end.keep_from)) --keep;
  for (Link* link : end.out) {
    const End& reader = ends_[static_cast<std::size_t>(link->reader())];
    keep = reader.history.empty()
               ? end.history.oldest()
               : std::min(keep, link->oldest_needed(reader.history.time(reader.history.newest())));
    const double back_to = std::min(reader.keep_from, end.keep_from);
    if (back_to != Member::never) keep = std::min(keep, link->oldest_to_rebuild(back_to));
  }
  end.history.make_room(keep, wanted);
  for (Link* link : end.out) link->follow_room();
}

void Exchange::reach_back() {
  for (Link& link : links_)
    if (link.how().follows_samples()) link.reach_back();
}

}  // namespace tandem
