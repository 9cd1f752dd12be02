// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "line_defect.hpp"

namespace tandem {

/// One of two, and whether it goes on no more.
struct TrackEnd {
  OutputTrack& track;
  bool ended;
};

/// Both ways between two subsystems that integrate themselves: looked at in the middle of each own step of the fine
/// one, when the other has come past it.
class CouplingIndicator {
 public:
  CouplingIndicator(int fine, int coarse) : fine_(fine), coarse_(coarse) {}

  int fine() const { return fine_; }
  int coarse() const { return coarse_; }
  bool is_between(int a, int b) const { return std::minmax(a, b) == std::minmax(fine_, coarse_); }
  void add(LineDefect& line, int source) { (source == fine_ ? of_fine_ : of_coarse_).push_back(&line); }
  void add(Indicators::Link& told, LineDefect& effort, LineDefect& back, int source_of_effort);

  /// All that both are known to have done.
  void settle(const TrackEnd& fine, const TrackEnd& coarse, const Windows& windows);
  /// The rows that are needed from now on, of either.
  std::int64_t next_of(int subsystem) const { return subsystem == fine_ ? next_ : row_; }

  void write(ByteWriter& to) const;
  void read(ByteReader& from, const OutputTrack& fine, const OutputTrack& coarse);

 private:
  struct Link {
    Indicators::Link* told;
    LineDefect *effort, *back;
    bool effort_is_fine;
    double ratio;  ///< of the gains
  };
  void settle(OutputTrack& fine, OutputTrack& coarse, const Windows& windows);
  void look(const OutputTrack& fine, const OutputTrack& coarse, double t, double length, std::size_t window);

  int fine_, coarse_;
  std::vector<LineDefect*> of_fine_, of_coarse_;  ///< by source
  std::vector<Link> links_;
  std::int64_t next_ = 1, row_ = 1;  ///< of fine, and of coarse
};

/// From subsystems to a sampled one: looked at at its instants, when the source has come past them.
class SamplingIndicator {
 public:
  SamplingIndicator(int source, int reader) : source_(source), reader_(reader) {}

  int source() const { return source_; }
  int reader() const { return reader_; }
  void add(LineDefect& line) { lines_.push_back(&line); }
  void acted(double t) {
    if (instants_.empty() || instants_.back() != t) instants_.push_back(t);
  }
  void settle(OutputTrack& source, bool reader_ended, const Windows& windows);
  std::int64_t next() const { return row_; }

  void write(ByteWriter& to) const;
  void read(ByteReader& from, const OutputTrack& source);

 private:
  int source_, reader_;
  std::vector<LineDefect*> lines_;
  std::vector<double> instants_;  ///< that are not looked at yet, after `looked_at_`
  std::size_t looked_at_ = 0;
  std::int64_t row_ = 1;
};

}  // namespace tandem
