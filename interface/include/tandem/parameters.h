/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The parameters of `create` read by their declaration, in C99 or C++. */
#ifndef TANDEM_PARAMETERS_H
#define TANDEM_PARAMETERS_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tandem/subsystem_info.h"

/* In the order of the declaration. */
typedef struct tandem_values {
  double* p;          /* numbers; NAN of a word */
  const char** words; /* the texts of all */
  char error[200];    /* a sentence, or "" */
} tandem_values;

static inline void tandem_take_parameter(tandem_values* values, const tandem_parameter* declared,
                                         int32_t count, const char* pair) {
  const size_t length = strcspn(pair, "=");
  int32_t i = 0;
  while (i < count && !(strlen(declared[i].name) == length && strncmp(declared[i].name, pair, length) == 0))
    ++i;
  if (i < count && pair[length] && !values->words[i])
    values->words[i] = pair + length + 1;
  else
    snprintf(values->error, sizeof values->error, "'%.100s' %s", pair,
             i < count ? "is there twice, or without value" : "is no parameter");
}

/* What is not given takes what is declared in its place. */
static inline void tandem_complete_parameter(tandem_values* values, const tandem_parameter* declared,
                                             int32_t i) {
  const char* const text = values->words[i] ? values->words[i] : declared[i].otherwise;
  char* end = NULL;
  values->words[i] = text;
  values->p[i] = text && declared[i].unit ? strtod(text, &end) : NAN;
  if (!text)
    snprintf(values->error, sizeof values->error, "parameter '%.60s' is needed: %.100s", declared[i].name,
             declared[i].sentence);
  else if (declared[i].unit && (end == text || *end || !isfinite(values->p[i])))
    snprintf(values->error, sizeof values->error, "parameter '%.100s' is no finite number", declared[i].name);
}

/* Reads "key=value&key=value". `error` tells what is wrong. To be freed, by free(); NULL without memory. */
static inline tandem_values* tandem_read_parameters(const tandem_parameter* declared, int32_t count,
                                                    const char* text) {
  const size_t n = (size_t)count, size = strlen(text) + 1;
  tandem_values* const values =
      (tandem_values*)calloc(1, sizeof *values + n * (sizeof(double) + sizeof(char*)) + size);
  char *pair, *next;
  int32_t i;
  if (!values) return NULL;
  values->p = (double*)(void*)(values + 1);
  values->words = (const char**)(void*)(values->p + n);
  next = (char*)memcpy(values->words + n, text, size);
  while (!values->error[0] && *(pair = next)) {
    next = pair + strcspn(pair, "&");
    if (*next) *next++ = 0;
    tandem_take_parameter(values, declared, count, pair);
  }
  for (i = 0; !values->error[0] && i < count; ++i) tandem_complete_parameter(values, declared, i);
  return values;
}

#endif
