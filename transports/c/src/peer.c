/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* One file, so that a program takes it along easily. In this order: bytes, frames on a socket, addresses, a
 * session that is served, the server, a remote subsystem. */
#define _POSIX_C_SOURCE 200809L
#include "tandem/peer.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <math.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

extern char** environ;

/* ---- Bytes ---- */

enum {
  T_HELLO = 1,
  T_INFO,
  T_INITIALIZE,
  T_ADVANCE,
  T_SAMPLES,
  T_SAVE,
  T_RESTORE,
  T_RELEASE,
  T_PING,
  T_ERROR,
  T_BYE,
  T_SERIALIZE,
  T_DESERIALIZE
};
enum {
  VERSION = 1,
  HEADER = 16,
  SAMPLES_HEAD = 32,
  LONGEST_NAME = 4096,
  SHORTEST_LIMIT = 4096,
  MAX_SESSIONS = 1024
};
#define LONGEST ((uint64_t)1 << 26)
#define LONGEST_TEXT ((uint32_t)1 << 20)
static const char magic[8] = {'T', 'A', 'N', 'D', 'E', 'M', '\r', '\n'};
static const char* const type_names[] = {"none",    "hello", "info",      "initialize", "advance",
                                         "samples", "save",  "restore",   "release",    "ping",
                                         "error",   "bye",   "serialize", "deserialize"};

typedef struct fault {
  tandem_status status;
  char sentence[1024];
} fault;

static tandem_status refuse(fault* f, tandem_status status, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(f->sentence, sizeof f->sentence, format, arguments);
  va_end(arguments);
  return f->status = status;
}

typedef struct buffer {
  unsigned char* bytes;
  size_t size, capacity;
  int lost; /* there was no memory for something */
} buffer;

static int reserve(buffer* b, size_t capacity) {
  unsigned char* bytes;
  if (capacity <= b->capacity) return 1;
  if (capacity < 2 * b->capacity) capacity = 2 * b->capacity;
  if (!(bytes = realloc(b->bytes, capacity))) return 0;
  b->bytes = bytes;
  b->capacity = capacity;
  return 1;
}

/* Room for so many bytes at the end; NULL without memory. */
static unsigned char* more(buffer* b, size_t bytes) {
  if (!reserve(b, b->size + bytes)) b->lost = 1;
  if (b->lost) return NULL;
  b->size += bytes;
  return b->bytes + b->size - bytes;
}

static void store(unsigned char* at, uint64_t value, int bytes) {
  int k;
  for (k = 0; k < bytes; ++k) at[k] = (unsigned char)(value >> (8 * k));
}
static uint64_t load(const unsigned char* at, int bytes) {
  uint64_t value = 0;
  int k;
  for (k = 0; k < bytes; ++k) value |= (uint64_t)at[k] << (8 * k);
  return value;
}

static void put_u32(buffer* b, uint32_t value) {
  unsigned char* at = more(b, 4);
  if (at) store(at, value, 4);
}
static void put_u64(buffer* b, uint64_t value) {
  unsigned char* at = more(b, 8);
  if (at) store(at, value, 8);
}
static void put_doubles(buffer* b, const double* values, size_t count) {
  unsigned char* at = more(b, 8 * count);
  size_t k;
  for (k = 0; at && k < count; ++k) {
    uint64_t bits;
    memcpy(&bits, values + k, 8);
    store(at + 8 * k, bits, 8);
  }
}
static void put_double(buffer* b, double value) { put_doubles(b, &value, 1); }
static void put_bytes(buffer* b, const void* bytes, size_t count) {
  unsigned char* at = more(b, count);
  if (at && count) memcpy(at, bytes, count);
}
static void put_text(buffer* b, const char* text, size_t longest) {
  size_t length = strlen(text);
  if (length > longest) length = longest;
  put_u32(b, (uint32_t)length);
  put_bytes(b, text, length);
}

/* Takes a payload apart. After the first thing that is wrong it gives zeros; done() tells. */
typedef struct reader {
  unsigned char* at;
  size_t left, size;
  const char* what;
  fault* fault;
  int bad;
} reader;

static void wrong(reader* in, const char* format, ...) {
  char sentence[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(sentence, sizeof sentence, format, arguments);
  va_end(arguments);
  if (!in->bad) refuse(in->fault, TANDEM_INVALID_ARGUMENT, "the message '%s' %s", in->what, sentence);
  in->bad = 1;
  in->left = 0;
}

static unsigned char* take(reader* in, size_t bytes) {
  if (!in->bad && bytes > in->left)
    wrong(in, "ends after %zu bytes; at byte %zu %zu more were to follow", in->size, in->size - in->left,
          bytes);
  if (in->bad) return NULL;
  in->at += bytes;
  in->left -= bytes;
  return in->at - bytes;
}
static uint32_t take_u32(reader* in) {
  const unsigned char* at = take(in, 4);
  return at ? (uint32_t)load(at, 4) : 0;
}
static uint64_t take_u64(reader* in) {
  const unsigned char* at = take(in, 8);
  return at ? load(at, 8) : 0;
}
static void take_doubles(reader* in, double* values, size_t count) {
  const unsigned char* at = take(in, 8 * count);
  size_t k;
  for (k = 0; at && k < count; ++k) {
    const uint64_t bits = load(at + 8 * k, 8);
    memcpy(values + k, &bits, 8);
  }
}
static double take_double(reader* in) {
  double value = 0.0;
  take_doubles(in, &value, 1);
  return value;
}
static double take_finite(reader* in, const char* name) {
  const double value = take_double(in);
  if (!isfinite(value)) wrong(in, "has a %s that is not finite", name);
  return value;
}

/* A text of C: it is moved onto its length, so that there is a byte for its end. */
static char* take_text(reader* in, uint32_t longest) {
  const uint32_t length = take_u32(in);
  unsigned char* text;
  if (length > longest) wrong(in, "has a text of %u bytes; allowed are up to %u", length, longest);
  if (!(text = take(in, length))) return NULL;
  if (memchr(text, 0, length)) wrong(in, "has a text with a zero byte");
  memmove(text - 4, text, length);
  text[(ptrdiff_t)length - 4] = 0;
  return (char*)text - 4;
}

/* Of things that need so many bytes each. */
static size_t take_count(reader* in, size_t bytes_each) {
  const uint32_t count = take_u32(in);
  if (count > in->left / bytes_each)
    wrong(in, "announces %u things of %zu bytes or more, but only %zu bytes follow", count, bytes_each,
          in->left);
  return in->bad ? 0 : count;
}

static tandem_status done(reader* in) {
  if (!in->bad && in->left) wrong(in, "has %zu bytes more than it should", in->left);
  return in->bad ? in->fault->status : TANDEM_OK;
}

/* ---- Frames on a socket ---- */

typedef struct channel {
  int socket;
  double deadline;  /* seconds */
  uint64_t longest; /* payload that the peer takes */
  buffer in, out;
  size_t frame; /* bytes of the frame at the beginning of `in` */
  fault fault;
} channel;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* 1 if the socket is ready by then, else 0. A broken one is ready: whoever uses it is told. */
static int wait_for(int socket, short events, double until) {
  struct pollfd entry;
  double left;
  entry.fd = socket;
  entry.events = events;
  while ((left = until - now()) > 0.0) {
    const int ready = poll(&entry, 1, (int)ceil(fmin(left, 1e6) * 1e3));
    if (ready > 0 || (ready < 0 && errno != EINTR)) return 1;
  }
  return 0;
}

static void set_up(channel* c, int socket, double deadline) {
  const int on = 1;
  memset(c, 0, sizeof *c);
  c->socket = socket;
  c->deadline = deadline;
  c->longest = LONGEST;
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_NONBLOCK);
  fcntl(socket, F_SETFD, FD_CLOEXEC);
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on,
             sizeof on); /* refused by a Unix socket, which needs it not */
}

static void tear_down(channel* c) {
  if (c->socket >= 0) close(c->socket);
  c->socket = -1;
  free(c->in.bytes);
  free(c->out.bytes);
  memset(&c->in, 0, sizeof c->in);
  memset(&c->out, 0, sizeof c->out);
}

static void begin(channel* c, int type, uint32_t number) {
  c->out.size = 0;
  c->out.lost = 0;
  put_u64(&c->out, 0);
  put_u32(&c->out, (uint32_t)type);
  put_u32(&c->out, number);
}

static tandem_status send_frame(channel* c) {
  const double until = now() + c->deadline;
  size_t sent = 0;
  if (c->out.lost) return refuse(&c->fault, TANDEM_INTERNAL, "there is no memory for the message");
  if (c->out.size - HEADER > c->longest)
    return refuse(&c->fault, TANDEM_NOT_SUPPORTED, "the message has %zu bytes; the peer takes up to %llu",
                  c->out.size - HEADER, (unsigned long long)c->longest);
  store(c->out.bytes, c->out.size - HEADER, 8);
  while (sent < c->out.size) {
    const ssize_t count = send(c->socket, c->out.bytes + sent, c->out.size - sent, MSG_NOSIGNAL);
    if (count >= 0) {
      sent += (size_t)count;
    } else if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
      return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "the connection broke: %s", strerror(errno));
    } else if (!wait_for(c->socket, POLLOUT, until)) {
      return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "the peer took no data within the deadline of %g s",
                    c->deadline);
    }
  }
  return TANDEM_OK;
}

/* Reads until there are so many bytes, and what has come besides; memory grows with what has come. Nothing at
 * all is no error where the connection is closed between two frames. */
static tandem_status fill(channel* c, size_t least, double until) {
  while (c->in.size < least) {
    const size_t part = c->in.size + 65536;
    ssize_t count;
    if (!reserve(&c->in, c->in.size + part))
      return refuse(&c->fault, TANDEM_INTERNAL, "there is no memory for a frame");
    if (!wait_for(c->socket, POLLIN, until))
      return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "no frame came whole within the deadline of %g s",
                    c->deadline);
    count = recv(c->socket, c->in.bytes + c->in.size, part, 0);
    if (count == 0 && c->in.size == 0) return TANDEM_OK;
    if (count == 0)
      return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "the peer closed the connection within a frame");
    if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)
      return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "the connection broke: %s", strerror(errno));
    if (count > 0) c->in.size += (size_t)count;
  }
  return TANDEM_OK;
}

static tandem_status check_header(channel* c) {
  const uint64_t length = load(c->in.bytes, 8), type = load(c->in.bytes + 8, 4);
  if (type < T_HELLO || type > T_DESERIALIZE)
    return refuse(&c->fault, TANDEM_INVALID_ARGUMENT, "the frame has the type %u; allowed are 1 to %d",
                  (unsigned)type, T_DESERIALIZE);
  if (length > LONGEST)
    return refuse(&c->fault, TANDEM_INVALID_ARGUMENT,
                  "the frame '%s' announces %llu bytes; allowed are up to %llu", type_names[type],
                  (unsigned long long)length, (unsigned long long)LONGEST);
  c->frame = HEADER + (size_t)length;
  return TANDEM_OK;
}

/* The next frame, whole within the deadline; *type is 0 if the connection was closed before it. */
static tandem_status receive(channel* c, int* type, uint32_t* number, reader* in) {
  const double until = now() + c->deadline;
  tandem_status status;
  c->in.size -= c->frame;
  if (c->in.size) memmove(c->in.bytes, c->in.bytes + c->frame, c->in.size);
  c->frame = 0;
  *type = 0;
  status = fill(c, HEADER, until);
  if (status != TANDEM_OK || c->in.size == 0) return status;
  if ((status = check_header(c)) != TANDEM_OK) return status;
  if ((status = fill(c, c->frame, until)) != TANDEM_OK) return status;
  *type = (int)load(c->in.bytes + 8, 4);
  *number = (uint32_t)load(c->in.bytes + 12, 4);
  memset(in, 0, sizeof *in);
  in->at = c->in.bytes + HEADER;
  in->left = in->size = c->frame - HEADER;
  in->what = type_names[*type];
  in->fault = &c->fault;
  return TANDEM_OK;
}

/* ---- Addresses ---- */

static int close_with(int socket, int error) {
  close(socket);
  errno = error;
  return -1;
}

/* A connected socket, or -1 and errno. */
static int attempt(const struct sockaddr* place, socklen_t size, double until) {
  const int s = socket(place->sa_family, SOCK_STREAM, 0);
  socklen_t length = sizeof(int);
  int error = 0;
  if (s < 0) return -1;
  fcntl(s, F_SETFL, O_NONBLOCK);
  while (connect(s, place, size) != 0 && errno != EISCONN) {
    if (errno == EAGAIN && now() < until) { /* a Unix socket whose queue is full */
      poll(NULL, 0, 5);
      continue;
    }
    if (errno != EINPROGRESS && errno != EINTR) return close_with(s, errno);
    if (!wait_for(s, POLLOUT, until)) return close_with(s, ETIMEDOUT);
    getsockopt(s, SOL_SOCKET, SO_ERROR, &error, &length);
    return error ? close_with(s, error) : s;
  }
  return s;
}

static tandem_status unix_place(const char* address, struct sockaddr_un* place, fault* f) {
  memset(place, 0, sizeof *place);
  place->sun_family = AF_UNIX;
  if (strlen(address + 5) >= sizeof place->sun_path || !address[5])
    return refuse(f, TANDEM_INVALID_ARGUMENT, "path '%s' has %zu bytes; a Unix socket's may have 1 to %zu",
                  address + 5, strlen(address + 5), sizeof place->sun_path - 1);
  strcpy(place->sun_path, address + 5);
  return TANDEM_OK;
}

static int is_loopback(const struct sockaddr* place) {
  if (place->sa_family == AF_INET)
    return ntohl(((const struct sockaddr_in*)(const void*)place)->sin_addr.s_addr) >> 24 == 127;
  return place->sa_family == AF_INET6 &&
         IN6_IS_ADDR_LOOPBACK(&((const struct sockaddr_in6*)(const void*)place)->sin6_addr);
}

/* Of tcp://HOST:PORT; freeaddrinfo is the caller's. */
static tandem_status resolve(const char* address, int allow_plaintext, struct addrinfo** all, fault* f) {
  const char* colon = strrchr(address, ':');
  struct addrinfo hints;
  const struct addrinfo* a;
  char host[256];
  size_t length;
  int code;
  if (strncmp(address, "tcp://", 6) != 0 || colon <= address + 6 || colon - address > 255 || !colon[1] ||
      strspn(colon + 1, "0123456789") != strlen(colon + 1) || strlen(colon) > 6)
    return refuse(f, TANDEM_INVALID_ARGUMENT, "address '%s' is not of the form tcp://HOST:PORT or unix:PATH",
                  address);
  length = (size_t)(colon - address) - 6;
  memcpy(host, address + 6, length);
  host[length] = 0;
  if (host[0] == '[' && host[length - 1] == ']') memmove(host, host + 1, length), host[length - 2] = 0;
  memset(&hints, 0, sizeof hints);
  hints.ai_socktype = SOCK_STREAM;
  if ((code = getaddrinfo(host, colon + 1, &hints, all)) != 0)
    return refuse(f, TANDEM_INPUT_OUTPUT, "host '%s' is not known: %s", host, gai_strerror(code));
  for (a = *all; a && !allow_plaintext; a = a->ai_next)
    if (!is_loopback(a->ai_addr)) {
      freeaddrinfo(*all);
      return refuse(f, TANDEM_NOT_SUPPORTED, "address '%s' is beyond this machine, and tcp is plain text",
                    address);
    }
  return TANDEM_OK;
}

static tandem_status connect_to(const char* address, int allow_plaintext, double deadline, int* s, fault* f) {
  const double until = now() + deadline;
  tandem_status status;
  if (strncmp(address, "unix:", 5) == 0) {
    struct sockaddr_un place;
    if ((status = unix_place(address, &place, f)) != TANDEM_OK) return status;
    *s = attempt((const struct sockaddr*)&place, sizeof place, until);
  } else {
    struct addrinfo *all, *a;
    int error;
    if ((status = resolve(address, allow_plaintext, &all, f)) != TANDEM_OK) return status;
    for (a = all, *s = -1; a && *s < 0; a = a->ai_next) *s = attempt(a->ai_addr, a->ai_addrlen, until);
    error = errno;
    freeaddrinfo(all);
    errno = error;
  }
  return *s >= 0 ? TANDEM_OK
                 : refuse(f, TANDEM_INPUT_OUTPUT, "no connection to %s: %s", address, strerror(errno));
}

/* ---- A session that is served ---- */

int64_t tandem_row_size(const tandem_info* info) {
  int64_t outputs = 0, blocks = 1;
  int32_t i;
  for (i = 0; i < info->output_count; ++i) {
    outputs += info->outputs[i].size;
    if (info->outputs[i].derivatives >= blocks) blocks = info->outputs[i].derivatives + 1;
  }
  return 2 + outputs * blocks;
}

static int64_t input_size(const tandem_info* info) {
  int64_t inputs = 0;
  int32_t i;
  for (i = 0; i < info->input_count; ++i) inputs += info->inputs[i].size;
  return inputs;
}

typedef struct session {
  channel channel;
  const tandem_subsystem_api* api;
  double idle; /* seconds */
  void* self;
  const tandem_info* info;
  int initialized;
  uint32_t number;
  /* Memory of a call: buffers of doubles, signals and segments */
  buffer rows, u0, signals, segments;
} session;

static void put_ports(buffer* b, const tandem_port* ports, int32_t count) {
  int32_t i;
  put_u32(b, (uint32_t)count);
  for (i = 0; i < count; ++i) {
    put_text(b, ports[i].name, LONGEST_NAME);
    put_text(b, ports[i].unit, LONGEST_NAME);
    put_u32(b, (uint32_t)ports[i].size);
    put_u32(b, (uint32_t)ports[i].derivatives);
    put_double(b, ports[i].start);
  }
}

static tandem_status reply_info(session* s) {
  buffer* b = &s->channel.out;
  int32_t i;
  begin(&s->channel, T_INFO, s->number);
  put_text(b, s->info->name, LONGEST_NAME);
  put_u32(b, s->info->abilities);
  put_ports(b, s->info->inputs, s->info->input_count);
  put_ports(b, s->info->outputs, s->info->output_count);
  put_u32(b, (uint32_t)s->info->feedthrough_count);
  for (i = 0; i < s->info->feedthrough_count; ++i) {
    put_u32(b, (uint32_t)s->info->feedthrough[i].output);
    put_u32(b, (uint32_t)s->info->feedthrough[i].input);
  }
  return send_frame(&s->channel);
}

static void put_hello(channel* c, const char* text) {
  put_bytes(&c->out, magic, sizeof magic);
  put_u32(&c->out, VERSION);
  put_u32(&c->out, VERSION);
  put_u64(&c->out, LONGEST);
  put_u32(&c->out, 0);
  put_text(&c->out, text, LONGEST_TEXT);
}

typedef struct greeting {
  uint32_t lowest, highest;
  uint64_t longest;
  const char* text;
} greeting;

static tandem_status read_hello(reader* in, greeting* g) {
  const unsigned char* mark = take(in, sizeof magic);
  if (mark && memcmp(mark, magic, sizeof magic) != 0)
    wrong(in, "does not begin with TANDEM, so the peer speaks something else");
  g->lowest = take_u32(in);
  g->highest = take_u32(in);
  g->longest = take_u64(in);
  take_u32(in); /* capabilities, of which version 1 knows none */
  g->text = take_text(in, LONGEST_TEXT);
  return done(in);
}

static tandem_status answer_hello(session* s, reader* in) {
  fault* f = &s->channel.fault;
  greeting g;
  if (read_hello(in, &g) != TANDEM_OK) return f->status;
  if (g.lowest > VERSION || g.highest < VERSION)
    return refuse(f, TANDEM_NOT_SUPPORTED, "the peer speaks version %u to %u of the protocol; allowed is %d",
                  g.lowest, g.highest, VERSION);
  if (g.longest < SHORTEST_LIMIT)
    return refuse(f, TANDEM_NOT_SUPPORTED,
                  "the peer takes payloads of up to %llu bytes; allowed are %d or more",
                  (unsigned long long)g.longest, SHORTEST_LIMIT);
  s->channel.longest = g.longest;
  if (s->api->create(g.text, &s->self) != TANDEM_OK)
    return refuse(f, TANDEM_INVALID_ARGUMENT, "%s",
                  s->self ? s->api->last_error(s->self) : "no instance can be made");
  if (!(s->info = s->api->info(s->self))) return refuse(f, TANDEM_INTERNAL, "the subsystem gives no info");
  begin(&s->channel, T_HELLO, s->number);
  put_hello(&s->channel, "tandem for C");
  return send_frame(&s->channel);
}

/* Rows for one reply: as many as are asked for and fit. */
static tandem_status make_rows(session* s, uint64_t room, tandem_samples* y) {
  const uint64_t stride = (uint64_t)tandem_row_size(s->info);
  const uint64_t longest = s->channel.longest < LONGEST ? s->channel.longest : LONGEST;
  const uint64_t fit = (longest - SAMPLES_HEAD) / (8 * stride), capacity = room < fit ? room : fit;
  if (capacity == 0)
    return refuse(&s->channel.fault, TANDEM_INVALID_ARGUMENT,
                  "there is room for no row of %llu bytes in a reply", (unsigned long long)(8 * stride));
  if (!reserve(&s->rows, 8 * capacity * stride))
    return refuse(&s->channel.fault, TANDEM_INTERNAL, "there is no memory for %llu rows",
                  (unsigned long long)capacity);
  y->rows = (double*)(void*)s->rows.bytes;
  y->stride = (int64_t)stride;
  y->capacity = (int64_t)capacity;
  y->size = 0;
  return TANDEM_OK;
}

static void put_rows(buffer* b, const tandem_samples* y) {
  put_u32(b, (uint32_t)y->stride);
  put_u64(b, (uint64_t)y->size);
  put_doubles(b, y->rows, (size_t)(y->size * y->stride));
}

static void put_clock(buffer* b, const tandem_clock* clock) {
  put_double(b, clock->time);
  put_double(b, clock->next_time);
  put_u32(b, (uint32_t)clock->stop);
}

static tandem_status reply_error(session* s, tandem_status code, const char* sentence,
                                 const tandem_samples* y) {
  begin(&s->channel, T_ERROR, s->number);
  put_u32(&s->channel.out, (uint32_t)code);
  put_text(&s->channel.out, sentence, LONGEST_TEXT);
  if (y) put_rows(&s->channel.out, y);
  return send_frame(&s->channel);
}

/* What the subsystem has done; its own errors leave the session as it is. */
static tandem_status reply_samples(session* s, tandem_status status, const tandem_samples* y,
                                   const tandem_clock* clock) {
  if (status != TANDEM_OK) return reply_error(s, status, s->api->last_error(s->self), y);
  begin(&s->channel, T_SAMPLES, s->number);
  put_clock(&s->channel.out, clock);
  put_rows(&s->channel.out, y);
  return send_frame(&s->channel);
}

static void check_inputs(session* s, reader* in, size_t found) {
  if (!in->bad && found != (uint64_t)input_size(s->info))
    wrong(in, "has %zu inputs; allowed are %lld", found, (long long)input_size(s->info));
}

static tandem_status answer_initialize(session* s, reader* in) {
  const double t_start = take_finite(in, "t_start"), t_stop = take_finite(in, "t_stop");
  const uint64_t room = take_u64(in);
  const size_t inputs = take_count(in, 8);
  tandem_samples y;
  tandem_clock clock;
  tandem_status status;
  double* u0;
  check_inputs(s, in, inputs);
  if (!reserve(&s->u0, 8 * inputs + 8)) wrong(in, "has %zu inputs; there is no memory for them", inputs);
  u0 = (double*)(void*)s->u0.bytes;
  if (!in->bad) take_doubles(in, u0, inputs);
  if ((status = done(in)) != TANDEM_OK || (status = make_rows(s, room, &y)) != TANDEM_OK) return status;
  s->initialized = 1;
  memset(&clock, 0, sizeof clock);
  status = s->api->initialize(s->self, t_start, t_stop, u0, &y, &clock);
  return reply_samples(s, status, &y, &clock);
}

static void read_segment(reader* in, uint32_t degree, tandem_segment* segment) {
  uint32_t k;
  memset(segment, 0, sizeof *segment);
  segment->end = take_double(in);
  if (isnan(segment->end)) wrong(in, "has an input that is not finite");
  segment->origin = take_finite(in, "segment's origin");
  for (k = 0; k <= degree; ++k) segment->c[k] = take_finite(in, "coefficient of an input");
}

/* Reads one input into the segments from `next` on, and gives the next free one. */
static tandem_segment* read_signal(reader* in, tandem_signal* signal, tandem_segment* next) {
  const uint32_t count = take_u32(in), degree = take_u32(in);
  uint32_t k;
  if (!in->bad && (count == 0 || degree >= TANDEM_MAX_COEFFICIENTS || count > in->left / (8 * (degree + 3))))
    wrong(in, "has an input of %u segments of degree %u; allowed are 1 or more that follow, of degree 0 to 5",
          count, degree);
  memset(signal, 0, sizeof *signal);
  signal->segments = next;
  signal->count = (int32_t)count;
  signal->degree = (int32_t)degree;
  for (k = 0; !in->bad && k < count; ++k) read_segment(in, degree, next++);
  return next;
}

static void read_signals(session* s, reader* in, size_t inputs) {
  const size_t segments = in->left / 24 + 1; /* the shortest has 24 bytes */
  tandem_segment* next;
  size_t i;
  if (!reserve(&s->signals, (inputs + 1) * sizeof(tandem_signal)) ||
      !reserve(&s->segments, segments * sizeof(tandem_segment)))
    wrong(in, "has %zu inputs; there is no memory for them", inputs);
  next = (tandem_segment*)(void*)s->segments.bytes;
  for (i = 0; !in->bad && i < inputs; ++i)
    next = read_signal(in, (tandem_signal*)(void*)s->signals.bytes + i, next);
}

static tandem_status answer_advance(session* s, reader* in) {
  const double t_limit = take_finite(in, "t_limit");
  const uint32_t land = take_u32(in);
  const size_t inputs = take_count(in, 8);
  const uint64_t room = take_u64(in);
  tandem_samples y;
  tandem_clock clock;
  tandem_status status;
  if (land > 1) wrong(in, "has %u for land; allowed are 0 and 1", land);
  check_inputs(s, in, inputs);
  if (!in->bad) read_signals(s, in, inputs);
  if ((status = done(in)) != TANDEM_OK || (status = make_rows(s, room, &y)) != TANDEM_OK) return status;
  memset(&clock, 0, sizeof clock);
  status = s->api->advance(s->self, t_limit, (int32_t)land, (const tandem_signal*)(void*)s->signals.bytes, &y,
                           &clock);
  return reply_samples(s, status, &y, &clock);
}

/* Whether the subsystem can do what is asked of its states. */
static int can(const session* s, int type) {
  const int bytes = type == T_SERIALIZE || type == T_DESERIALIZE;
  return (s->info->abilities & TANDEM_SAVES_STATE) &&
         (!bytes || ((s->info->abilities & TANDEM_SERIALIZES_STATE) && s->api->table_size >= sizeof *s->api));
}

/* Does what is asked, and puts what it gives into the reply. */
static tandem_status do_state(session* s, int type, int64_t id, const reader* in) {
  buffer* const out = &s->channel.out;
  tandem_clock clock = {0.0, 0.0, 0, 0};
  const void* bytes = NULL;
  int64_t size = 0;
  tandem_status status;
  if (type == T_SAVE)
    status = s->api->save_state(s->self, &id);
  else if (type == T_RESTORE)
    status = s->api->restore_state(s->self, id, &clock);
  else if (type == T_RELEASE)
    status = s->api->release_state(s->self, id);
  else if (type == T_SERIALIZE)
    status = s->api->serialize_state(s->self, id, &bytes, &size);
  else
    status = s->api->deserialize_state(s->self, in->at, (int64_t)in->left, &id);
  begin(&s->channel, type, s->number);
  if (type == T_SAVE || type == T_DESERIALIZE) put_u64(out, (uint64_t)id);
  if (type == T_RESTORE) put_clock(out, &clock);
  if (status == TANDEM_OK && type == T_SERIALIZE) put_bytes(out, bytes, (size_t)size);
  return status;
}

static tandem_status answer_state(session* s, int type, reader* in) {
  const int64_t id = type == T_SAVE || type == T_DESERIALIZE ? 0 : (int64_t)take_u64(in);
  tandem_status status;
  if (type != T_DESERIALIZE && (status = done(in)) != TANDEM_OK) return status;
  if (!can(s, type))
    return reply_error(s, TANDEM_NOT_SUPPORTED,
                       type == T_SERIALIZE || type == T_DESERIALIZE
                           ? "the subsystem has no ability to give its state as bytes"
                           : "the subsystem has no ability to save its state",
                       NULL);
  if ((status = do_state(s, type, id, in)) != TANDEM_OK)
    return reply_error(s, status, s->api->last_error(s->self), NULL);
  return send_frame(&s->channel);
}

static tandem_status answer_ping(session* s, reader* in) {
  begin(&s->channel, T_PING, s->number);
  put_bytes(&s->channel.out, in->at, in->left);
  return send_frame(&s->channel);
}

static tandem_status check_order(session* s, int type) {
  const int early = type == T_INFO || type == T_INITIALIZE || type == T_PING;
  if (type == T_SAMPLES || type == T_ERROR)
    return refuse(&s->channel.fault, TANDEM_WRONG_STATE, "'%s' is no request", type_names[type]);
  if (type == T_HELLO ? s->info == NULL : s->info != NULL && (early || s->initialized)) return TANDEM_OK;
  return refuse(
      &s->channel.fault, TANDEM_WRONG_STATE,
      "the request '%s' is out of order; allowed is hello once, then info, then initialize before all others",
      type_names[type]);
}

static tandem_status handle(session* s, int type, reader* in) {
  const tandem_status status = check_order(s, type);
  if (status != TANDEM_OK) return status;
  switch (type) {
    case T_HELLO:
      return answer_hello(s, in);
    case T_INFO:
      return done(in) == TANDEM_OK ? reply_info(s) : s->channel.fault.status;
    case T_INITIALIZE:
      return answer_initialize(s, in);
    case T_ADVANCE:
      return answer_advance(s, in);
    case T_PING:
      return answer_ping(s, in);
    default:
      return answer_state(s, type, in);
  }
}

/* One request; *more is 0 after the last one. */
static tandem_status answer(session* s, int* more) {
  channel* c = &s->channel;
  const uint32_t allowed = s->number + 1;
  uint32_t number;
  reader in;
  int type;
  *more = 0;
  s->number = 0; /* of what goes wrong before the request's own is known to be right */
  if (c->in.size == c->frame && !wait_for(c->socket, POLLIN, now() + s->idle))
    return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "no request came within %g s, so the session ends",
                  s->idle);
  if (receive(c, &type, &number, &in) != TANDEM_OK) return c->fault.status;
  if (type == 0) return TANDEM_OK;
  if (number != allowed)
    return refuse(&c->fault, TANDEM_WRONG_STATE, "the request has the number %u; allowed is %u", number,
                  allowed);
  s->number = number;
  if (type == T_BYE) { /* the peer need not wait for it */
    begin(c, T_BYE, number);
    send_frame(c);
    return TANDEM_OK;
  }
  *more = 1;
  return handle(s, type, &in);
}

/* Serves one session on a connected socket, which it closes. 0, or 1 if it broke. */
static int serve_session(const tandem_subsystem_api* api, int socket, double deadline, double idle) {
  session s;
  tandem_status status;
  int more = 1;
  memset(&s, 0, sizeof s);
  set_up(&s.channel, socket, deadline);
  s.api = api;
  s.idle = idle;
  while ((status = answer(&s, &more)) == TANDEM_OK && more) continue;
  if (status != TANDEM_OK) {
    fprintf(stderr, "session ends: %s\n", s.channel.fault.sentence);
    reply_error(&s, status, s.channel.fault.sentence, NULL);
  }
  if (s.self) api->destroy(s.self);
  tear_down(&s.channel);
  free(s.rows.bytes);
  free(s.u0.bytes);
  free(s.signals.bytes);
  free(s.segments.bytes);
  return status != TANDEM_OK;
}

/* ---- The server ---- */

typedef struct server {
  const tandem_subsystem_api* api;
  const char* address;
  double deadline, idle;
  int once, most, allow_plaintext;
  int listener, count; /* of the sessions under way, each a process */
  pid_t sessions[MAX_SESSIONS];
  int begun, broken; /* a session has begun; the last to end was broken */
  fault fault;
} server;

static volatile sig_atomic_t ended; /* by a signal */
static void end(int number) { ended = number; }

/* A file that is left of a server which is gone. */
static int is_stale(const struct sockaddr_un* place) {
  struct stat status;
  int s;
  if (stat(place->sun_path, &status) != 0 || !S_ISSOCK(status.st_mode)) return 0;
  s = attempt((const struct sockaddr*)place, sizeof *place, now() + 0.1);
  if (s >= 0) close(s);
  return s < 0 && errno == ECONNREFUSED;
}

static tandem_status listen_unix(server* s) {
  struct sockaddr_un place;
  tandem_status status = unix_place(s->address, &place, &s->fault);
  if (status != TANDEM_OK) return status;
  if (is_stale(&place)) unlink(place.sun_path);
  s->listener = socket(AF_UNIX, SOCK_STREAM, 0);
  fchmod(s->listener, S_IRUSR | S_IWUSR); /* before there is a file to connect to */
  if (bind(s->listener, (const struct sockaddr*)&place, sizeof place) != 0 ||
      listen(s->listener, SOMAXCONN) != 0)
    return refuse(&s->fault, TANDEM_INPUT_OUTPUT, "no listening at %s: %s", s->address, strerror(errno));
  printf("serving at %s\n", s->address);
  return TANDEM_OK;
}

static tandem_status listen_tcp(server* s) {
  struct addrinfo* all;
  const int on = 1;
  int failed;
  char port[8];
  struct sockaddr_storage place;
  socklen_t size = sizeof place;
  const tandem_status status = resolve(s->address, s->allow_plaintext, &all, &s->fault);
  if (status != TANDEM_OK) return status;
  s->listener = socket(all->ai_family, SOCK_STREAM, 0);
  setsockopt(s->listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  failed = bind(s->listener, all->ai_addr, all->ai_addrlen) != 0 || listen(s->listener, SOMAXCONN) != 0;
  if (failed) refuse(&s->fault, TANDEM_INPUT_OUTPUT, "no listening at %s: %s", s->address, strerror(errno));
  freeaddrinfo(all);
  if (failed) return s->fault.status;
  getsockname(s->listener, (struct sockaddr*)&place, &size);
  getnameinfo((struct sockaddr*)&place, size, NULL, 0, port, sizeof port, NI_NUMERICSERV);
  printf("serving at %.*s%s\n", (int)(strrchr(s->address, ':') + 1 - s->address), s->address, port);
  return TANDEM_OK;
}

/* Sessions that have ended. */
static void clear_away(server* s) {
  int i, status;
  for (i = s->count - 1; i >= 0; --i)
    if (waitpid(s->sessions[i], &status, WNOHANG) != 0) {
      s->broken = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
      s->sessions[i] = s->sessions[--s->count];
    }
}

/* Its request is not awaited: whoever connects and says nothing costs nothing. */
static void turn_away(const server* s, int socket) {
  session guest;
  char sentence[128];
  memset(&guest, 0, sizeof guest);
  set_up(&guest.channel, socket, 0.1);
  guest.number = 1;
  snprintf(sentence, sizeof sentence,
           "the server has %d sessions open, the most that it allows; try again later", s->most);
  reply_error(&guest, TANDEM_NOT_SUPPORTED, sentence, NULL);
  tear_down(&guest.channel);
}

static void take_guest(server* s, int socket) {
  pid_t process;
  if (s->count >= s->most || (process = fork()) < 0) {
    turn_away(s, socket);
    return;
  }
  if (process == 0) {
    signal(SIGTERM, SIG_DFL);
    signal(SIGINT, SIG_DFL);
    close(s->listener);
    _exit(serve_session(s->api, socket, s->deadline, s->idle));
  }
  s->begun = 1;
  s->sessions[s->count++] = process;
  close(socket);
}

static void serve_all(server* s) {
  while (!ended && !(s->once && s->begun && s->count == 0)) {
    clear_away(s);
    if (s->once && s->begun) {
      poll(NULL, 0, 5);
    } else if (wait_for(s->listener, POLLIN, now() + 0.1)) {
      const int guest = accept(s->listener, NULL, NULL);
      if (guest >= 0) take_guest(s, guest);
    }
  }
  while (s->count > 0) {
    kill(s->sessions[--s->count], SIGKILL);
    waitpid(s->sessions[s->count], NULL, 0);
  }
}

typedef struct signals {
  struct sigaction terminate, interrupt;
  sigset_t mask;
} signals;

/* SIGTERM and SIGINT end the server, also where the program around it has them blocked (as Octave has). */
static void catch_signals(signals* before) {
  struct sigaction action;
  sigset_t both;
  memset(&action, 0, sizeof action);
  action.sa_handler = end;
  ended = 0;
  sigaction(SIGTERM, &action, &before->terminate);
  sigaction(SIGINT, &action, &before->interrupt);
  sigemptyset(&both);
  sigaddset(&both, SIGTERM);
  sigaddset(&both, SIGINT);
  sigprocmask(SIG_UNBLOCK, &both, &before->mask);
}

/* The session of TANDEM_FD, or all of --listen; the status of the program. */
static int serve_there(server* s) {
  const char* number = getenv("TANDEM_FD");
  signals before;
  if (!s->address) return serve_session(s->api, atoi(number), s->deadline, s->idle);
  if ((strncmp(s->address, "unix:", 5) == 0 ? listen_unix(s) : listen_tcp(s)) != TANDEM_OK) {
    fprintf(stderr, "%s\n", s->fault.sentence);
    return 2;
  }
  fflush(stdout);
  fcntl(s->listener, F_SETFL, O_NONBLOCK);
  fcntl(s->listener, F_SETFD, FD_CLOEXEC);
  catch_signals(&before);
  serve_all(s);
  sigaction(SIGTERM, &before.terminate, NULL);
  sigaction(SIGINT, &before.interrupt, NULL);
  sigprocmask(SIG_SETMASK, &before.mask, NULL);
  close(s->listener);
  if (strncmp(s->address, "unix:", 5) == 0) unlink(s->address + 5);
  return s->once && s->broken;
}

/* A number above 0 after the option. */
static int number_of(server* s, const char* option, const char* text, double* value) {
  char* rest;
  *value = text ? strtod(text, &rest) : 0.0;
  if (!text || rest == text || *rest || !(*value > 0.0) || !isfinite(*value))
    refuse(&s->fault, TANDEM_INVALID_ARGUMENT, "%s has '%s'; allowed is a number above 0", option,
           text ? text : "");
  return 1;
}

/* Reads one option; how many of the words after it belong to it. */
static int read_option(server* s, const char* option, const char* value) {
  double most;
  if (strcmp(option, "--once") == 0) return s->once = 1, 0;
  if (strcmp(option, "--allow-plaintext") == 0) return s->allow_plaintext = 1, 0;
  if (strcmp(option, "--deadline") == 0) return number_of(s, option, value, &s->deadline);
  if (strcmp(option, "--idle") == 0) return number_of(s, option, value, &s->idle);
  if (strcmp(option, "--sessions") == 0) {
    number_of(s, option, value, &most);
    if (most > MAX_SESSIONS || most != floor(most))
      refuse(&s->fault, TANDEM_INVALID_ARGUMENT, "--sessions has %g; allowed are 1 to %d", most,
             MAX_SESSIONS);
    return s->most = (int)most, 1;
  }
  if (strcmp(option, "--listen") == 0 && value) return s->address = value, 1;
  refuse(&s->fault, TANDEM_INVALID_ARGUMENT,
         "'%s' is no option; allowed are --listen URI, --once, --sessions N, --deadline S, --idle S, "
         "--allow-plaintext",
         option);
  return 0;
}

int tandem_serve(const tandem_subsystem_api* api, int argc, char* const argv[]) {
  server s;
  int i;
  memset(&s, 0, sizeof s);
  s.api = api;
  s.deadline = 5.0;
  s.idle = 3600.0;
  s.most = 16;
  if (api->abi_version != TANDEM_ABI_VERSION)
    refuse(&s.fault, TANDEM_NOT_SUPPORTED, "the subsystem has ABI version %u; allowed is %d",
           api->abi_version, TANDEM_ABI_VERSION);
  for (i = 1; i < argc; ++i) i += read_option(&s, argv[i], i + 1 < argc ? argv[i + 1] : NULL);
  if (s.fault.status == TANDEM_OK && !s.address && !getenv("TANDEM_FD"))
    refuse(&s.fault, TANDEM_INVALID_ARGUMENT, "an address is needed: --listen URI");
  if (s.fault.status == TANDEM_OK) return serve_there(&s);
  fprintf(stderr, "%s\n", s.fault.sentence);
  return 2;
}

/* ---- A remote subsystem ---- */

typedef struct remote {
  channel channel;
  char* address;
  pid_t program; /* of spawn: */
  int request;   /* the type of the last one */
  uint32_t number;
  double t_start, time, goal; /* of the run, where it stands, where it was told to go */
  tandem_info info;
  void* info_memory[4]; /* names, inputs, outputs, feedthrough */
  int broken;           /* the connection; `reason` says why */
  char reason[1024], error[2048];
} remote;

static void shortest(char text[32], double value) {
  int digits;
  for (digits = 15; digits < 18; ++digits) {
    snprintf(text, 32, "%.*g", digits, value);
    if (strtod(text, NULL) == value) return;
  }
}

/* The sentence with the address, the call and the time in the run. */
static tandem_status tell(remote* r, tandem_status status, const char* sentence) {
  char from[32], to[32], place[128] = "";
  shortest(from, r->time);
  shortest(to, r->goal);
  if (r->request == T_ADVANCE)
    snprintf(place, sizeof place, " at t = %s s to %s s", from, to);
  else if (r->request > T_INFO)
    snprintf(place, sizeof place, " at t = %s s", from);
  snprintf(r->error, sizeof r->error, "%s, %s%s: %s", r->address, type_names[r->request], place, sentence);
  return status;
}

/* `end` is how, if it has. It keeps its number until end_program, so that nobody else has it. */
static int has_ended(pid_t program, double until, siginfo_t* end) {
  do {
    memset(end, 0, sizeof *end);
    if (waitid(P_PID, (id_t)program, end, WEXITED | WNOHANG | WNOWAIT) != 0 || end->si_pid != 0) return 1;
    poll(NULL, 0, 2);
  } while (now() < until);
  return 0;
}

/* What became of the program, if that is the reason. */
static void tell_fate(remote* r) {
  siginfo_t end;
  if (r->program <= 0 || !has_ended(r->program, now() + 0.1, &end)) return;
  snprintf(r->reason, sizeof r->reason, "program '%s' %s %d%s", r->address + 6,
           end.si_code == CLD_EXITED ? "ended with status" : "was ended by signal", end.si_status,
           end.si_code == CLD_EXITED && end.si_status == 127 ? " (not found?)" : "");
}

/* An error of the connection, which ends with it. */
static tandem_status break_off(remote* r) {
  r->broken = 1;
  strcpy(r->reason, r->channel.fault.sentence);
  tell_fate(r);
  close(r->channel.socket);
  r->channel.socket = -1;
  return tell(r, r->channel.fault.status, r->reason);
}

static tandem_status begin_request(remote* r, int type) {
  if (r->broken) {
    snprintf(r->error, sizeof r->error, "%s: the connection ended before: %s", r->address, r->reason);
    return TANDEM_WRONG_STATE;
  }
  r->request = type;
  begin(&r->channel, type, ++r->number);
  return TANDEM_OK;
}

/* Rows that y has room for, and a reply too. */
static uint64_t room_of(const tandem_samples* y) {
  const uint64_t fit = (LONGEST - SAMPLES_HEAD) / (8 * (uint64_t)y->stride);
  const uint64_t room = (uint64_t)(y->capacity - y->size);
  return room < fit ? room : fit;
}

static void read_rows(reader* in, tandem_samples* y) {
  const uint32_t stride = take_u32(in);
  const uint64_t rows = take_u64(in);
  if (rows > room_of(y) || (rows && stride != (uint64_t)y->stride))
    wrong(in, "has %llu rows of %u numbers; allowed are up to %llu of %lld", (unsigned long long)rows, stride,
          (unsigned long long)room_of(y), (long long)y->stride);
  if (in->bad) return;
  take_doubles(in, y->rows + y->size * y->stride, (size_t)(rows * stride));
  if (done(in) == TANDEM_OK) y->size += (int64_t)rows;
}

static void read_clock(reader* in, tandem_clock* clock) {
  uint32_t stop;
  clock->time = take_double(in);
  clock->next_time = take_double(in);
  if ((stop = take_u32(in)) > TANDEM_STOP_FINISHED)
    wrong(in, "gives %u as the reason to stop; allowed are 0 to 3", stop);
  clock->stop = (int32_t)stop;
  clock->reserved = 0;
}

static const char* take_error(reader* in, tandem_status* status) {
  const uint32_t code = take_u32(in);
  const int known = code >= TANDEM_INVALID_ARGUMENT && code <= TANDEM_INTERNAL;
  *status = known ? (tandem_status)code : TANDEM_INTERNAL;
  return take_text(in, LONGEST_TEXT);
}

/* What the subsystem says; the connection is as sound as before. Rows may have come before the error. */
static tandem_status read_error(remote* r, reader* in, tandem_samples* y) {
  tandem_status status;
  const char* const sentence = take_error(in, &status);
  if (y && !in->bad && in->left) read_rows(in, y);
  if (in->bad) return break_off(r);
  return tell(r, status, sentence);
}

/* Why the server ended the session. */
static tandem_status hear(remote* r, reader* in) {
  tandem_status status;
  const char* const sentence = take_error(in, &status);
  if (!in->bad) refuse(&r->channel.fault, status, "%s", sentence);
  return break_off(r);
}

/* Nothing can be sent; the server may have said why before it closed. */
static tandem_status hear_farewell(remote* r, reader* in) {
  const fault why = r->channel.fault;
  uint32_t number;
  int type;
  r->channel.deadline = 0.1;
  if (receive(&r->channel, &type, &number, in) == TANDEM_OK && type == T_ERROR) return hear(r, in);
  r->channel.fault = why;
  return break_off(r);
}

/* Sends the request; the reply is of that type, or an error. */
static tandem_status exchange(remote* r, int expected, reader* in, tandem_samples* y) {
  fault* f = &r->channel.fault;
  uint32_t number = 0;
  int type = 0;
  if (send_frame(&r->channel) != TANDEM_OK) return hear_farewell(r, in);
  if (receive(&r->channel, &type, &number, in) != TANDEM_OK) return break_off(r);
  if (type == T_ERROR && number == 0) return hear(r, in);
  if (type == 0)
    refuse(f, TANDEM_INPUT_OUTPUT, "the peer closed the connection");
  else if (number != r->number)
    refuse(f, TANDEM_WRONG_STATE, "the reply has the number %u; allowed is that of the request, %u", number,
           r->number);
  else if (type == T_ERROR)
    return read_error(r, in, y);
  else if (type != expected)
    refuse(f, TANDEM_WRONG_STATE, "the reply is of the type '%s'; allowed are '%s' and 'error'",
           type_names[type], type_names[expected]);
  else
    return TANDEM_OK;
  return break_off(r);
}

static tandem_status finish(remote* r, reader* in) {
  return done(in) == TANDEM_OK ? TANDEM_OK : break_off(r);
}

static tandem_status greet(remote* r, const char* parameters) {
  greeting g;
  reader in;
  tandem_status status = begin_request(r, T_HELLO);
  put_hello(&r->channel, parameters);
  if ((status = exchange(r, T_HELLO, &in, NULL)) != TANDEM_OK) return status;
  if (read_hello(&in, &g) != TANDEM_OK) return break_off(r);
  if (g.lowest != VERSION || g.highest != VERSION) {
    refuse(&r->channel.fault, TANDEM_NOT_SUPPORTED,
           "the peer speaks version %u to %u of the protocol; allowed is %d", g.lowest, g.highest, VERSION);
    return break_off(r);
  }
  r->channel.longest = g.longest;
  return TANDEM_OK;
}

static tandem_port* read_ports(reader* in, int32_t* count, int64_t* scalars) {
  tandem_port* const ports = calloc(1 + (size_t)(*count = (int32_t)take_count(in, 24)), sizeof *ports);
  int32_t i;
  if (!ports) wrong(in, "has %d ports; there is no memory for them", *count);
  for (i = 0; !in->bad && i < *count; ++i) {
    tandem_port* const p = ports + i;
    p->name = take_text(in, LONGEST_NAME);
    p->unit = take_text(in, LONGEST_NAME);
    p->size = (int32_t)take_u32(in);
    p->derivatives = (int32_t)take_u32(in);
    p->start = take_double(in);
    if (!in->bad &&
        (p->size < 1 || p->derivatives < 0 || p->derivatives > 3 || (*scalars += p->size) > INT32_MAX / 4))
      wrong(
          in,
          "has a port '%s' of size %d with %d derivatives; allowed are a size from 1 and 0 to 3 derivatives",
          p->name, p->size, p->derivatives);
  }
  return ports;
}

static tandem_feedthrough* read_feedthrough(reader* in, int32_t* count, const int64_t scalars[2]) {
  tandem_feedthrough* const pairs = calloc(1 + (size_t)(*count = (int32_t)take_count(in, 8)), sizeof *pairs);
  int32_t i;
  if (!pairs) wrong(in, "has %d pairs; there is no memory for them", *count);
  for (i = 0; !in->bad && i < *count; ++i) {
    pairs[i].output = (int32_t)take_u32(in);
    pairs[i].input = (int32_t)take_u32(in);
    if (pairs[i].input < 0 || pairs[i].input >= scalars[0] || pairs[i].output < 0 ||
        pairs[i].output >= scalars[1])
      wrong(in, "has a feedthrough from input %d to output %d, which are not there", pairs[i].input,
            pairs[i].output);
  }
  return pairs;
}

/* The texts of the info stay where they came, in memory that the channel gives up. */
static tandem_status ask_info(remote* r) {
  int64_t scalars[2] = {0, 0};
  reader in;
  tandem_status status = begin_request(r, T_INFO);
  if ((status = exchange(r, T_INFO, &in, NULL)) != TANDEM_OK) return status;
  r->info_memory[0] = r->channel.in.bytes;
  memset(&r->channel.in, 0, sizeof r->channel.in);
  r->channel.frame = 0;
  r->info.name = take_text(&in, LONGEST_NAME);
  r->info.abilities = take_u32(&in);
  r->info.inputs = r->info_memory[1] = read_ports(&in, &r->info.input_count, &scalars[0]);
  r->info.outputs = r->info_memory[2] = read_ports(&in, &r->info.output_count, &scalars[1]);
  r->info.feedthrough = r->info_memory[3] = read_feedthrough(&in, &r->info.feedthrough_count, scalars);
  return finish(r, &in);
}

/* A program with one end of a socket, in a group of its own. */
static tandem_status start_program(remote* r, const char* command, int* ours) {
  char *line = malloc(strlen(command) + 6), variable[32];
  char* arguments[] = {(char*)"sh", (char*)"-c", line, NULL};
  char** variables;
  size_t count = 0, kept = 0, k;
  int ends[2];
  const pid_t parent = getpid();
  while (environ[count]) ++count;
  variables = malloc((count + 2) * sizeof *variables);
  if (!line || !variables || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) {
    free(line);
    free(variables);
    return refuse(&r->channel.fault, TANDEM_INPUT_OUTPUT, "the program can't be started: %s",
                  strerror(errno));
  }
  /* All that allocates is done before the fork. */
  strcpy(line, "exec ");
  strcat(line, command);
  snprintf(variable, sizeof variable, "TANDEM_FD=%d", ends[1]);
  for (k = 0; k < count; ++k)
    if (strncmp(environ[k], "TANDEM_FD=", 10) != 0) variables[kept++] = environ[k];
  variables[kept++] = variable;
  variables[kept] = NULL;
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  r->program = fork();
  if (r->program == 0) {
    setpgid(0, 0);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* ended with this process, also if it is killed */
#endif
    if (getppid() != parent) _exit(0);
    execve("/bin/sh", arguments, variables);
    _exit(127);
  }
  free(line);
  free(variables);
  close(ends[1]);
  *ours = ends[0];
  if (r->program > 0) return TANDEM_OK;
  close(ends[0]);
  return refuse(&r->channel.fault, TANDEM_INPUT_OUTPUT, "the program can't be started: no process");
}

/* By now its socket is closed: a program that reads it ends of its own accord, others are told to. What it
 * has started and left is in its group, and goes with it. */
static void end_program(pid_t program) {
  siginfo_t end;
  if (!has_ended(program, now() + 1.0, &end)) kill(-program, SIGTERM);
  has_ended(program, now() + 1.0, &end);
  kill(-program, SIGKILL);
  waitpid(program, NULL, 0);
}

static tandem_status open_channel(remote* r, int allow_plaintext, double deadline) {
  fault* f = &r->channel.fault;
  int s = -1;
  const int spawned = strncmp(r->address, "spawn:", 6) == 0;
  if (!(deadline > 0.0 && isfinite(deadline)))
    return refuse(f, TANDEM_INVALID_ARGUMENT, "%s: the deadline is %g s; allowed is a number above 0",
                  r->address, deadline);
  if ((spawned ? start_program(r, r->address + 6, &s)
               : connect_to(r->address, allow_plaintext, deadline, &s, f)) != TANDEM_OK)
    return f->status;
  set_up(&r->channel, s, deadline);
  return TANDEM_OK;
}

/* Takes each pair deadline=S out of "key=value&key=value". NaN if it is no number. */
static double take_deadline(char* parameters) {
  char *from = parameters, *to = parameters;
  double deadline = 5.0;
  while (*from) {
    char *rest, *const end = from + strcspn(from, "&");
    const size_t length = (size_t)(end - from);
    if (strncmp(from, "deadline=", 9) == 0) {
      deadline = strtod(from + 9, &rest);
      if (rest != end || length == 9) deadline = NAN;
    } else {
      if (to > parameters) *to++ = '&';
      memmove(to, from, length);
      to += length;
    }
    from = *end ? end + 1 : end;
  }
  *to = 0;
  return deadline;
}

tandem_status tandem_connect(const char* uri, int allow_plaintext, void** self) {
  remote* r = calloc(1, sizeof *r);
  const size_t length = strcspn(uri, "?");
  double deadline;
  char* parameters;
  tandem_status status;
  if (!(*self = r)) return TANDEM_INTERNAL;
  r->channel.socket = -1;
  r->request = T_HELLO;
  r->broken = 1; /* until it is open */
  if (!(r->address = malloc(strlen(uri) + 2))) return TANDEM_INTERNAL;
  strcpy(r->address, uri); /* and the parameters behind it */
  parameters = r->address + length + (uri[length] == '?');
  r->address[length] = 0;
  deadline = take_deadline(parameters);
  if ((status = open_channel(r, allow_plaintext, deadline)) != TANDEM_OK) {
    strcpy(r->error, r->channel.fault.sentence);
    return status;
  }
  r->broken = 0;
  if ((status = greet(r, parameters)) != TANDEM_OK) return status;
  return ask_info(r);
}

static tandem_status create(const char* uri, void** self) { return tandem_connect(uri, 0, self); }

static void destroy(void* self) {
  remote* const r = self;
  size_t k;
  if (!r->broken) {
    begin(&r->channel, T_BYE, ++r->number);
    send_frame(&r->channel);
  }
  tear_down(&r->channel);
  if (r->program > 0) end_program(r->program);
  for (k = 0; k < sizeof r->info_memory / sizeof *r->info_memory; ++k) free(r->info_memory[k]);
  free(r->address);
  free(r);
}

static const tandem_info* info(void* self) { return &((remote*)self)->info; }

static const char* last_error(void* self) { return ((remote*)self)->error; }

/* Time and values of a row of an advance, after one at time `before`. */
static void check_row(const remote* r, reader* in, const double* row, int64_t stride, double before) {
  const double width = 6.0 * DBL_EPSILON * fmax(fmax(fabs(row[0]), fabs(r->goal)), fabs(r->t_start));
  int64_t k;
  const int later = row[0] > before || (row[1] == 1.0 && row[0] == before); /* a jump may repeat a time */
  if (!(later && isfinite(row[0]) && row[0] <= r->goal + width))
    wrong(in, "has a row at t = %.17g s; allowed are times past %.17g s up to %.17g s", row[0], before,
          r->goal);
  for (k = 1; k < stride; ++k)
    if (!isfinite(row[k])) wrong(in, "has a value at t = %.17g s that is not finite", row[0]);
}

/* The rows from `first` on, and the clock, which has to be that of the newest. */
static void check_samples(const remote* r, reader* in, const tandem_samples* y, int64_t first,
                          const tandem_clock* clock) {
  double time = r->time;
  int64_t i;
  for (i = first; !in->bad && i < y->size; ++i) {
    const double* const row = y->rows + i * y->stride;
    if (r->request == T_ADVANCE) check_row(r, in, row, y->stride, time);
    time = row[0];
  }
  if (clock->time != time || !(clock->next_time > time || clock->stop == TANDEM_STOP_FINISHED))
    wrong(
        in,
        "stands at t = %.17g s and goes on to %.17g s; allowed is the time of the newest row, %.17g s, and a "
        "later one",
        clock->time, clock->next_time, time);
}

static tandem_status exchange_samples(remote* r, tandem_samples* y, tandem_clock* clock) {
  const int64_t first = y->size;
  reader in;
  const tandem_status status = exchange(r, T_SAMPLES, &in, y);
  if (status != TANDEM_OK) return status;
  read_clock(&in, clock);
  read_rows(&in, y);
  if (!in.bad) check_samples(r, &in, y, first, clock);
  if (in.bad) y->size = first;
  if (finish(r, &in) != TANDEM_OK) return r->channel.fault.status;
  r->time = clock->time;
  return TANDEM_OK;
}

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  remote* const r = self;
  buffer* const b = &r->channel.out;
  const size_t inputs = (size_t)input_size(&r->info);
  tandem_status status;
  r->t_start = r->time = t_start;
  if ((status = begin_request(r, T_INITIALIZE)) != TANDEM_OK) return status;
  put_double(b, t_start);
  put_double(b, t_stop);
  put_u64(b, room_of(y));
  put_u32(b, (uint32_t)inputs);
  put_doubles(b, u0, inputs);
  return exchange_samples(r, y, clock);
}

static void put_signal(buffer* b, const tandem_signal* u) {
  int32_t k;
  put_u32(b, (uint32_t)u->count);
  put_u32(b, (uint32_t)u->degree);
  for (k = 0; k < u->count; ++k) {
    put_double(b, u->segments[k].end);
    put_double(b, u->segments[k].origin);
    put_doubles(b, u->segments[k].c, (size_t)u->degree + 1);
  }
}

static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* u,
                             tandem_samples* y, tandem_clock* clock) {
  remote* const r = self;
  const size_t inputs = (size_t)input_size(&r->info);
  size_t i;
  tandem_status status;
  r->goal = t_limit;
  if ((status = begin_request(r, T_ADVANCE)) != TANDEM_OK) return status;
  put_double(&r->channel.out, t_limit);
  put_u32(&r->channel.out, land != 0);
  put_u32(&r->channel.out, (uint32_t)inputs);
  put_u64(&r->channel.out, room_of(y));
  for (i = 0; i < inputs; ++i) put_signal(&r->channel.out, u + i);
  return exchange_samples(r, y, clock);
}

/* Refused unless the subsystem has the abilities. */
static tandem_status begin_state(remote* r, int type, uint32_t needed) {
  if ((r->info.abilities & needed) == needed) return begin_request(r, type);
  snprintf(r->error, sizeof r->error, "subsystem '%s' has no ability to %s", r->info.name,
           needed == TANDEM_SAVES_STATE ? "save its state" : "give its state as bytes");
  return TANDEM_NOT_SUPPORTED;
}
enum { AS_BYTES = TANDEM_SAVES_STATE | TANDEM_SERIALIZES_STATE };

static tandem_status save_state(void* self, int64_t* id) {
  remote* const r = self;
  reader in;
  tandem_status status = begin_state(r, T_SAVE, TANDEM_SAVES_STATE);
  if (status != TANDEM_OK || (status = exchange(r, T_SAVE, &in, NULL)) != TANDEM_OK) return status;
  *id = (int64_t)take_u64(&in);
  return finish(r, &in);
}

static tandem_status restore_state(void* self, int64_t id, tandem_clock* clock) {
  remote* const r = self;
  reader in;
  tandem_status status = begin_state(r, T_RESTORE, TANDEM_SAVES_STATE);
  if (status != TANDEM_OK) return status;
  put_u64(&r->channel.out, (uint64_t)id);
  if ((status = exchange(r, T_RESTORE, &in, NULL)) != TANDEM_OK) return status;
  read_clock(&in, clock);
  if ((status = finish(r, &in)) == TANDEM_OK) r->time = clock->time;
  return status;
}

static tandem_status release_state(void* self, int64_t id) {
  remote* const r = self;
  reader in;
  tandem_status status = begin_state(r, T_RELEASE, TANDEM_SAVES_STATE);
  if (status != TANDEM_OK) return status;
  put_u64(&r->channel.out, (uint64_t)id);
  if ((status = exchange(r, T_RELEASE, &in, NULL)) != TANDEM_OK) return status;
  return finish(r, &in);
}

/* The bytes stay where they came, up to the next reply. */
static tandem_status serialize_state(void* self, int64_t id, const void** bytes, int64_t* size) {
  remote* const r = self;
  reader in;
  tandem_status status = begin_state(r, T_SERIALIZE, AS_BYTES);
  if (status != TANDEM_OK) return status;
  put_u64(&r->channel.out, (uint64_t)id);
  if ((status = exchange(r, T_SERIALIZE, &in, NULL)) != TANDEM_OK) return status;
  *bytes = in.at;
  *size = (int64_t)in.left;
  return TANDEM_OK;
}

static tandem_status deserialize_state(void* self, const void* bytes, int64_t size, int64_t* id) {
  remote* const r = self;
  reader in;
  tandem_status status = begin_state(r, T_DESERIALIZE, AS_BYTES);
  if (status != TANDEM_OK) return status;
  put_bytes(&r->channel.out, bytes, (size_t)size);
  if ((status = exchange(r, T_DESERIALIZE, &in, NULL)) != TANDEM_OK) return status;
  *id = (int64_t)take_u64(&in);
  return finish(r, &in);
}

const tandem_subsystem_api* tandem_remote(void) {
  static const tandem_subsystem_api api = {TANDEM_ABI_VERSION,
                                           sizeof(tandem_subsystem_api),
                                           create,
                                           destroy,
                                           info,
                                           last_error,
                                           initialize,
                                           advance,
                                           save_state,
                                           restore_state,
                                           release_state,
                                           serialize_state,
                                           deserialize_state};
  return &api;
}
