/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Saved states of a model in C: copies of its place and state. As bytes they are what stands in memory, for
 * machines of one kind. */
#ifndef TANDEM_SAVED_STATES_H
#define TANDEM_SAVED_STATES_H
#include <stdlib.h>
#include <string.h>

#include "tandem/model.h"

static inline tandem_status tandem_tell(const tandem_instance* self, tandem_stop stop, tandem_clock* clock) {
  const tandem_clock now = {self->now->time, self->now->next, stop, 0};
  *clock = now;
  return TANDEM_OK;
}

static inline tandem_place* tandem_slot(const tandem_instance* self, int64_t id) {
  return (tandem_place*)(void*)((char*)self->saved + (size_t)id * self->place_size);
}

/* NULL, with a sentence, if there is none. */
static inline tandem_place* tandem_saved(tandem_instance* self, int64_t id) {
  if (id >= 0 && id < self->saved_count && tandem_slot(self, id)->kept) return tandem_slot(self, id);
  tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "there is no saved state %lld", (long long)id);
  return NULL;
}

/* In the memory of one that is released, if there is one. */
static inline tandem_status tandem_keep(tandem_instance* self, const void* place, int64_t* id) {
  for (*id = 0; *id < self->saved_count && tandem_slot(self, *id)->kept;) ++*id;
  if (*id == self->saved_count) {
    void* const more = realloc(self->saved, (size_t)(*id + 1) * self->place_size);
    if (!more) return tandem_refuse(self, TANDEM_INTERNAL, "there is no memory for a saved state");
    self->saved = more;
    ++self->saved_count;
  }
  memcpy(tandem_slot(self, *id), place, self->place_size);
  tandem_slot(self, *id)->kept = 1;
  return TANDEM_OK;
}

static inline tandem_status tandem_save(void* made, int64_t* id) {
  tandem_instance* const self = (tandem_instance*)made;
  return tandem_keep(self, self->now, id);
}

static inline tandem_status tandem_restore(void* made, int64_t id, tandem_clock* clock) {
  tandem_instance* const self = (tandem_instance*)made;
  const tandem_place* const place = tandem_saved(self, id);
  if (!place) return TANDEM_INVALID_ARGUMENT;
  memcpy(self->now, place, self->place_size);
  return tandem_tell(self, TANDEM_STOP_LIMIT, clock);
}

static inline tandem_status tandem_release(void* made, int64_t id) {
  tandem_place* const place = tandem_saved((tandem_instance*)made, id);
  if (place) place->kept = 0;
  return place ? TANDEM_OK : TANDEM_INVALID_ARGUMENT;
}

static inline tandem_status tandem_serialize(void* made, int64_t id, const void** bytes, int64_t* size) {
  *bytes = tandem_saved((tandem_instance*)made, id);
  *size = (int64_t)((tandem_instance*)made)->place_size;
  return *bytes ? TANDEM_OK : TANDEM_INVALID_ARGUMENT;
}

/* It has to be of this grid, and to stand from the node before its next one on. */
static inline tandem_status tandem_deserialize(void* made, const void* bytes, int64_t size, int64_t* id) {
  tandem_instance* const self = (tandem_instance*)made;
  const double origin = self->now->origin, h = self->now->h;
  tandem_place its = {0.0, 0.0, 0.0, 0.0, -1, 0, 0};
  if (size == (int64_t)self->place_size) memcpy(&its, bytes, sizeof its);
  if (its.origin == origin && its.h == h && its.node >= 0 && its.next == origin + (double)its.node * h &&
      its.time <= its.next && (its.node == 0 || its.time >= origin + (double)(its.node - 1) * h))
    return tandem_keep(self, bytes, id);
  return tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "the state is none of this model with these own steps");
}

#endif
