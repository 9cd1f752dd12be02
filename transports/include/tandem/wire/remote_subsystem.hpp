// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"
#include "tandem/wire/channel.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::wire {

/// A subsystem at the other end of a channel. Each call is one request and one reply. Errors name the
/// subsystem, the address, the call and the time in the run. After an error of the connection every further
/// call fails with it.
class RemoteSubsystem final : public Subsystem {
 public:
  /// Says hello with these parameters ("key=value&key=value") and asks for the info. deadline [s]: how long
  /// the reply to a request may take. Where the subsystem's kind declares parameters, those that it does not
  /// take are refused here, whatever the peer does, and the error is NotMade.
  RemoteSubsystem(std::unique_ptr<Channel> channel, const std::string& parameters, double deadline);
  ~RemoteSubsystem() override;
  RemoteSubsystem(const RemoteSubsystem&) = delete;
  RemoteSubsystem& operator=(const RemoteSubsystem&) = delete;

  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double t_stop, std::span<const double> u0, Samples& y) override;
  Clock advance(double t_limit, bool land, std::span<const Signal> u, Samples& y) override;
  bool start_advance(double t_limit, bool land, std::span<const Signal> u, const Samples& y) override;
  Clock finish_advance(Samples& y) override;
  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override;
  StateId save_state() override;
  Clock restore_state(StateId id) override;
  void release_state(StateId id) override;
  std::vector<std::byte> serialize_state(StateId id) override;
  StateId deserialize_state(std::span<const std::byte> bytes) override;

 private:
  void hello(const std::string& parameters);
  Hello greeting(const std::string& parameters);
  void begin(Type type);
  void send();
  void hear_farewell();
  Frame receive(Type expected, Samples* y);
  Frame exchange(Type expected, Samples* y = nullptr);
  std::uint64_t room(const Samples& y) const;
  void require_saving() const;
  void require_serializing() const;
  template <class Call>
  auto told(const Call& call);

  std::unique_ptr<Channel> channel_;
  SubsystemInfo info_;
  double deadline_;
  std::uint64_t longest_ = usual_longest;  ///< payload that the other side takes
  std::uint32_t capabilities_ = 0;         ///< of both sides
  std::uint32_t number_ = 0;               ///< of the last request
  Type request_ = Type::hello;             ///< the last one
  TimeTolerance tolerance_;
  double time_ = 0.0, goal_ = 0.0;  ///< where it stands, and the limit of the call under way [s]
  std::string broken_;              ///< why the connection is not used any more
  Writer frame_;
  Initialize initialize_;
};

}  // namespace tandem::wire
