// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpi_ranks.hpp"

#include <cstdlib>

#include "tandem/error.hpp"

#if TANDEM_HAS_MPI
#include <mpi.h>

#include <climits>
#include <list>
#endif

namespace tandem::cli {
namespace {

/// Without a look at MPI, of which the start takes long: by what Open MPI, MPICH and PMIx tell their processes.
bool is_started_by_mpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name)) return true;
  return false;
}

#if TANDEM_HAS_MPI
/// A failed call ends all ranks, by MPI's own rule.
class MpiRanks final : public study::Ranks {
 public:
  MpiRanks() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiRanks() override {
    for (Sent& one : sent_) MPI_Wait(&one.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void send(int to, const std::vector<std::uint8_t>& bytes) override {
    if (bytes.size() > INT_MAX)
      throw Error(ErrorCode::not_supported, "a reference has " + std::to_string(bytes.size()) +
                                                " bytes; between ranks allowed are up to " +
                                                std::to_string(INT_MAX));
    forget_sent();
    Sent& one = sent_.emplace_back(Sent{bytes, {}});
    MPI_Isend(one.bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD,
              &one.request);
  }

  std::optional<Message> receive() override {
    forget_sent();
    int is_there = 0, size = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return {};
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{status.MPI_SOURCE, std::vector<std::uint8_t>(static_cast<std::size_t>(size))};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

 private:
  struct Sent {
    std::vector<std::uint8_t> bytes;
    MPI_Request request;
  };
  void forget_sent() {
    sent_.remove_if([](Sent& one) {
      int done = 0;
      MPI_Test(&one.request, &done, MPI_STATUS_IGNORE);
      return done != 0;
    });
  }

  int rank_ = 0, size_ = 1;
  std::list<Sent> sent_;
};

std::unique_ptr<study::Ranks> started() {
  auto ranks = std::make_unique<MpiRanks>();
  return ranks->size() > 1 ? std::move(ranks) : nullptr;
}
#else
std::unique_ptr<study::Ranks> started() {
  throw Error(ErrorCode::not_supported,
              "this build has no MPI, so that each rank would sweep all rows (packages libopenmpi-dev, "
              "openmpi-bin)");
}
#endif

}  // namespace

std::unique_ptr<study::Ranks> mpi_ranks() { return is_started_by_mpi() ? started() : nullptr; }

}  // namespace tandem::cli
