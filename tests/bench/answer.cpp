// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/answer.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tandem/c_subsystem.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::bench {
namespace {

std::int64_t row_size(const Shape& shape) { return Samples::header + shape.signals; }

void append_rows(const Shape& shape, double end, tandem_samples& y) {
  const double step = 1.0 / shape.samples;
  const auto stride = y.stride;
  double* row = y.rows + stride * y.size;
  for (int k = shape.samples - 1; k >= 0; --k, row += stride) {
    row[0] = end - k * step;
    row[1] = 0.0;
    std::fill_n(row + Samples::header, shape.signals, 1.0);
  }
  y.size += shape.samples;
}

void append_start(const Shape& shape, double start, tandem_samples& y) {
  append_rows({shape.signals, 1}, start, y);
}

Clock clock_at(double time) { return {time, time + 1.0, Stop::limit}; }

class Answer final : public Subsystem {
 public:
  explicit Answer(const Shape& shape) : shape_(shape) {
    info_ = {"answer", {{"u", "1", shape.signals}}, {{"y", "1", shape.signals}}, {}, {}};
  }
  const SubsystemInfo& info() const override { return info_; }
  Clock initialize(double t_start, double, std::span<const double>, Samples& y) override {
    tandem_samples rows = y.c_view();
    append_start(shape_, t_start, rows);
    y.set_size(rows.size);
    return clock_at(t_start);
  }
  Clock advance(double t_limit, bool, std::span<const Signal>, Samples& y) override {
    tandem_samples rows = y.c_view();
    append_rows(shape_, t_limit, rows);
    y.set_size(rows.size);
    return clock_at(t_limit);
  }

 private:
  Shape shape_;
  SubsystemInfo info_;
};

/// The same as a library would have it.
struct TableAnswer {
  Shape shape;
  tandem_port in, out;
  tandem_info info;
};

TableAnswer& self_of(void* self) { return *static_cast<TableAnswer*>(self); }

tandem_status create(const char* parameters, void** self) {
  char* rest = nullptr;
  const int signals = static_cast<int>(std::strtol(parameters, &rest, 10));
  const int samples = static_cast<int>(std::strtol(rest + 1, nullptr, 10));
  auto* made =
      new TableAnswer{{signals, samples}, {"u", "1", signals, 0, 0.0}, {"y", "1", signals, 0, 0.0}, {}};
  made->info = {"answer", 0, 1, 1, 0, &made->in, &made->out, nullptr};
  *self = made;
  return TANDEM_OK;
}

tandem_status initialize(void* self, double t_start, double, const double*, tandem_samples* y,
                         tandem_clock* clock) {
  append_start(self_of(self).shape, t_start, *y);
  *clock = {t_start, t_start + 1.0, TANDEM_STOP_LIMIT, 0};
  return TANDEM_OK;
}

tandem_status advance(void* self, double t_limit, std::int32_t, const tandem_signal*, tandem_samples* y,
                      tandem_clock* clock) {
  append_rows(self_of(self).shape, t_limit, *y);
  *clock = {t_limit, t_limit + 1.0, TANDEM_STOP_LIMIT, 0};
  return TANDEM_OK;
}

const tandem_subsystem_api table = [] {
  tandem_subsystem_api api{};
  api.abi_version = TANDEM_ABI_VERSION;
  api.table_size = sizeof(tandem_subsystem_api);
  api.create = create;
  api.destroy = [](void* self) { delete &self_of(self); };
  api.info = [](void* self) -> const tandem_info* { return &self_of(self).info; };
  api.last_error = [](void*) -> const char* { return ""; };
  api.initialize = initialize;
  api.advance = advance;
  return api;
}();

}  // namespace

Sizes sizes_of(const Shape& shape) {
  const Segment segment{1.0, 0.0, {1.0, 1.0, 1.0, 1.0, 0.0, 0.0}};
  const std::vector<Signal> signals(static_cast<std::size_t>(shape.signals), Signal(&segment, 1, 3));
  wire::Writer request, reply;
  wire::begin(request, wire::Type::advance, 1);
  wire::put_advance(request, {1.0, false, 1}, signals);
  const auto rows = static_cast<std::size_t>(shape.samples * row_size(shape));
  return {request.size(), wire::header_size + wire::samples_head + 8 * rows};
}

std::unique_ptr<Subsystem> answer(const Shape& shape) { return std::make_unique<Answer>(shape); }

std::unique_ptr<Subsystem> answer_by_table(const Shape& shape) {
  return std::make_unique<CSubsystem>(&table,
                                      std::to_string(shape.signals) + "x" + std::to_string(shape.samples));
}

Asking::Asking(Subsystem& subsystem, const Shape& shape)
    : subsystem_(subsystem),
      shape_(shape),
      rows_(static_cast<std::size_t>(row_size(shape) * shape.samples)),
      segments_(static_cast<std::size_t>(shape.signals),
                Segment{1e300, 0.0, {1.0, 0.5, 0.25, 0.125, 0.0, 0.0}}) {
  for (const Segment& segment : segments_) signals_.emplace_back(&segment, 1, 3);
  Samples y(rows_.data(), row_size(shape), shape.samples);
  const std::vector<double> u0(static_cast<std::size_t>(shape.signals), 1.0);
  subsystem_.initialize(0.0, 1e15, u0, y);
}

void Asking::once() {
  Samples y(rows_.data(), row_size(shape_), shape_.samples);
  time_ += 1.0;
  subsystem_.advance(time_, false, signals_, y);
}

}  // namespace tandem::bench
