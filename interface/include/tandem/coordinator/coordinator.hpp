// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/coordinator/coordination.hpp"
#include "tandem/coordinator/exchange.hpp"
#include "tandem/coordinator/schedule.hpp"
#include "tandem/coordinator/seat.hpp"
#include "tandem/coordinator/thread_pool.hpp"
#include "tandem/coordinator/topology.hpp"

namespace tandem {

/// Runs subsystems that integrate themselves from t_start to t_stop. The stepping loop allocates nothing once
/// the memory of the histories has settled. Its header is long, as one object holds all that a turn touches;
/// its sources go by concern: samples, events, through, threads, checkpoint, end.
class Coordinator {
 public:
  /// subsystems: one for each of the topology, in its order; the topology has been checked; both must outlive
  /// the coordinator. Throws Error for a span that does not end after its start.
  Coordinator(const Topology& topology, const std::vector<Subsystem*>& subsystems, Coordination coordination,
              TimeSpan span);

  /// First samples, order, scheme checks and start, up to the point from which round() goes on; once. Throws
  /// Error for an order that names what is not there, a scheme that the schedule can't honour, and a start
  /// that the coordination asks for and that can't be made. It also throws what a subsystem throws.
  void initialize();

  /// Tells `observer` (may be null) of all samples from now on. Call before initialize(), or after restore().
  void observe(Observer* observer) { observer_ = observer; }

  /// One round of the schedule, after initialize(). False: there was none left, or the observer ended the
  /// run. Throws Error that names subsystem, call and span if one breaks the contract, and for what one
  /// throws.
  bool round();

  /// initialize(), then rounds to the end.
  void run();

  /// In place of round() and run(), with Coordination::pauses, after initialize(): rounds up to t [s], within the
  /// span, where all that can shorten a step end one; again and again, with rising t.
  void run_to(double t);
  /// An open input of the topology, which is to be known before run_to(). Valid from initialize() on.
  Driven& open_input(int subsystem, int input) { return exchange_->open_input(subsystem, input); }
  /// Outputs that follow inputs at once follow the open ones that have jumped where the run stands.
  void tell_jumps();

  /// Throws Error(not_supported) that names the subsystems whose state can't leave the process.
  void require_serializable() const;
  /// Between rounds: all that the run goes by from here on, states of the subsystems and histories included.
  void save(ByteWriter& to) const;
  /// After initialize() of a run that is put together alike: it stands where the other was saved, and goes on
  /// with the same bits. Refuses, Error(invalid_argument), what is of another run, as far as that shows.
  void restore(ByteReader& from);
  /// Has its subsystems release the states that they keep for it. It can't go on then.
  void forget_states();

  const Topology& topology() const { return topology_; }
  const Exchange& exchange() const { return *exchange_; }
  const Schedule& schedule() const { return *schedule_; }
  double t_stop() const { return t_stop_; }  ///< [s]
  /// Where a subsystem stands [s].
  double time(int subsystem) const { return seat(subsystem).time; }
  const Effort& effort(int subsystem) const { return seat(subsystem).effort; }
  /// Its first own step [s].
  double own_step(int subsystem) const { return own_steps_[static_cast<std::size_t>(subsystem)]; }
  /// How the histories were filled; cold too where no connection needs them filled. After initialize().
  StartKind start() const { return start_; }
  /// Of a repeated start, also of one that was not used: how often the first steps were run.
  int start_passes() const { return start_passes_; }
  /// What a user should know of this run: a start that costs order, settings without effect, an end not
  /// reached.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  friend class RunStart;
  static constexpr int most_idle_calls = 100;
  Seat& seat(int who) { return seats_[static_cast<std::size_t>(who)]; }
  const Seat& seat(int who) const { return seats_[static_cast<std::size_t>(who)]; }
  EventSeat& events(int who) { return event_seats_[static_cast<std::size_t>(who)]; }
  const EventSeat& events(int who) const { return event_seats_[static_cast<std::size_t>(who)]; }
  void make(std::span<const Turn> turns);
  void make_together(std::span<const Turn> turns);
  void work_at_once(std::span<const Turn> turns, FirstError& error);
  void make_in_parts(std::span<const Turn> turns);
  void make_part(std::span<const Turn> turns);
  void let_one_switch();
  void start(const Turn& turn);
  void go_on(const Turn& turn);
  void take(const Turn& turn, Exchange& inputs);
  void make_ready(int who);
  void read(const Turn& turn, Exchange& inputs);
  Clock advance(const Turn& turn, Samples& y);
  void begin_threads();
  bool is_timed(int who) const {
    constexpr std::int64_t one_of = 64;
    return coordination_.profile || (threads_ && effort(who).exchanges % one_of == 0);
  }
  void note_seconds(int who, double seconds);
  bool is_work_for_threads(std::span<const Turn> turns) const;
  void offer(const Turn& turn);
  void make_offered(int who);
  Clock finish_offered(int who);
  Turn next_call(const Turn& turn) const;
  void check_clock(const Turn& turn, double before, std::int64_t rows, const Clock& after);
  void hear_of_event(int who);
  void hear_of_jump(int who);
  Exchange::Jump jump_seen(int who, int reader, double until) const;
  void pass_by(int reader, int who);
  void remember(int who);
  double earliest_event(int who) const;
  double earliest_stand(int who, double t) const;
  void go_back(int who, double t);
  void forget_jumps(int who);
  void place_readers(int who);
  std::int64_t last_final(int who) const;
  void keep_rest();
  void check_end() const;
  void note_events();
  void await_jumps(std::span<const Turn> turns);
  void await_jumps(int reader, bool at_once);
  void tell_jump(int who);
  void act();
  Clock sample(int who, SamplePart part);
  void give(int who);
  void go_on(int who, const Clock& clock);
  [[noreturn]] void refuse_sample(int who, const std::string& what) const;
  void stand(int who, const Clock& clock) {
    seat(who).time = clock.time;
    const double next = clock.stop == Stop::finished ? Member::never : clock.next_time;
    own_next_[static_cast<std::size_t>(who)] = next;
    if (lands_elsewhere_) return place(who);
    schedule_->stand(who, clock.time, next);
  }
  double own_next(int who) const { return own_next_[static_cast<std::size_t>(who)]; }
  void place(int who);
  void place_all();
  void place_neighbours(int sampled);
  void commit(int who, double limit);
  void tell(int who);
  void finish_all(std::span<const Turn> turns);
  void keep(const Turn& turn);
  void write_state(int who, StateId id, ByteWriter& to) const;
  void write_events(int who, ByteWriter& to) const;
  void read_events(int who, ByteReader& from, std::vector<std::span<const std::byte>>& states);
  void check_events(int who, const ByteReader& from);
  void forget_states(int who);
  void restore_back(std::span<const std::span<const std::byte>> states);
  void check_seat(int who, const ByteReader& from);
  void restore_stop(ByteReader& from);
  void restore_state(int who, std::span<const std::byte> bytes, const ByteReader& from);
  void note_extra_steps(int who);
  bool make_round();
  bool end();
  void stop_at(double t);

  const Topology& topology_;
  Coordination coordination_;
  double t_start_, t_stop_;
  TimeTolerance tolerance_;
  StartKind start_ = StartKind::cold;
  int start_passes_ = 0;
  Observer* observer_ = nullptr;
  bool stopped_ = false;

  std::optional<Exchange> exchange_;
  std::optional<Schedule> schedule_;
  std::vector<Seat> seats_;
  std::vector<EventSeat> event_seats_;
  int not_known_here_ = 0;        ///< Subsystems that may work elsewhere (Seat::works_here).
  bool has_samples_ = false;      ///< There are sampled subsystems.
  bool has_events_ = false;       ///< There are some with events, in turns or parallel.
  bool lands_elsewhere_ = false;  ///< Some are sampled or have events: steps end elsewhere than at own nodes.
  bool frozen_ = false;           ///< Then in parallel: others read what was there at the begin of a round.
  bool ended_ = false;            ///< Nobody goes back any more.
  std::vector<std::vector<Through>> through_;  ///< By subsystem; empty if there is none.
  std::vector<int> followers_;  ///< Of a run that pauses: whose outputs may jump with inputs, sources first.
  std::vector<double> own_next_;  ///< By subsystem: its next node or instant; Member::never: it has finished.
  std::vector<int> output_calls_;  ///< Sampled ones that read each other: who gives outputs, in this order.
  std::vector<char> together_;     ///< By subsystem: is one of these.
  std::vector<double> outputs_;    ///< Of one that acts.
  std::vector<char> acts_;         ///< By subsystem: of `together_`, in the present round.
  std::vector<int> acting_;        ///< In the present round.
  std::vector<Turn> going_;        ///< Likewise.
  std::vector<int> awaiting_;      ///< Likewise: who waits for jumps of what it reads.
  std::vector<double> own_steps_;
  std::vector<std::string> notes_;
  std::vector<OfferedCall> offered_;     ///< By subsystem; empty without threads.
  std::unique_ptr<ThreadPool> threads_;  ///< The first to go.
};

}  // namespace tandem
