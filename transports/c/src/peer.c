/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* One file, so that a program takes it along easily. In this order: bytes, frames on a socket, addresses, a
 * session that is served, the server, a remote subsystem. */
#ifdef __linux__
#define _GNU_SOURCE /* accept4 */
#else
#define _POSIX_C_SOURCE 200809L
#endif
#include "tandem/peer.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <limits.h>
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
#ifdef __GLIBC__
#include <malloc.h>
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
  T_DESERIALIZE,
  T_SAMPLE
};
enum {
  VERSION = 1,
  HEADER = 16,
  SAMPLES_HEAD = 32,
  LONGEST_NAME = 4096,
  SHORTEST_LIMIT = 4096,
  MAX_SESSIONS = 1024,
  LONGEST_SHOWN = 1000, /* bytes of a stranger's sentence */
  LONGEST_TOLD = 4000,  /* bytes of a sentence of ours */
  MAX_STATES = 1000,    /* saved ones of a session */
  /* capabilities: held outputs and sampled subsystems, declared parameters (of servers), nominal values */
  CARRIES_HELD = 1,
  CARRIES_PARAMETERS = 2,
  CARRIES_NOMINAL = 4
};
#define LONGEST ((uint64_t)1 << 26)
#define LONGEST_TEXT ((uint32_t)1 << 20)
#define USUAL_MEMORY ((size_t)1 << 22)      /* more is given back when a request has been answered */
#define MAX_STATE_BYTES ((uint64_t)1 << 25) /* of all saved states of a session */
static const char magic[8] = {'T', 'A', 'N', 'D', 'E', 'M', '\r', '\n'};
static const char* const type_names[] = {"none",    "hello", "info",      "initialize",  "advance",
                                         "samples", "save",  "restore",   "release",     "ping",
                                         "error",   "bye",   "serialize", "deserialize", "sample"};

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

/* The code of the first character of a text, and its bytes: 0 if it is no UTF-8 (RFC 3629, section 4:
 * shortest form, no surrogates, up to U+10FFFF). */
static uint32_t first_character(const unsigned char* text, size_t length, size_t* bytes) {
  static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const size_t wanted = text[0] < 0x80 ? 1 : text[0] >= 0xf0 ? 4 : text[0] >= 0xe0 ? 3 : 2;
  uint32_t code = wanted == 1 ? text[0] : text[0] & (0x7fU >> wanted);
  size_t k;
  *bytes = 0;
  if ((text[0] >= 0x80 && text[0] < 0xc2) || text[0] > 0xf4 || length < wanted) return text[0];
  for (k = 1; k < wanted; ++k) {
    if ((text[k] & 0xc0) != 0x80) return text[0];
    code = code << 6 | (text[k] & 0x3fU);
  }
  if (code < least[wanted] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return text[0];
  *bytes = wanted;
  return code;
}

/* Those that a terminal obeys, also such as turn the direction of writing. */
static int is_control(uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e || code == 0x200f ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/* A stranger's text as a terminal, a log and a file can take it: UTF-8 as it is, control characters as \x1b
 * or \u202e, bytes that are no UTF-8 as \xff, what is beyond `longest` bytes as "...". `shown` has room for
 * longest + 4 bytes, or is NULL: then only the length is told. */
static size_t printable(char* shown, size_t longest, const char* text, size_t length) {
  const unsigned char* at = (const unsigned char*)text;
  size_t size = 0, bytes;
  while (length > 0) {
    const uint32_t code = first_character(at, length, &bytes);
    const int plain = bytes > 0 && !is_control(code), narrow = bytes == 0 || code < 0x80;
    const size_t needed = plain ? bytes : narrow ? 4 : 6;
    if (size + needed > longest) {
      if (shown) strcpy(shown + size, "...");
      return size + 3;
    }
    if (shown && plain)
      memcpy(shown + size, at, bytes);
    else if (shown)
      sprintf(shown + size, narrow ? "\\x%02x" : "\\u%04x", (unsigned)code);
    size += needed;
    at += bytes ? bytes : 1;
    length -= bytes ? bytes : 1;
  }
  if (shown) shown[size] = 0;
  return size;
}

/* Whether it is so already. */
static int is_printable(const char* text, size_t length) {
  const unsigned char* at = (const unsigned char*)text;
  size_t bytes;
  for (; length > 0; at += bytes, length -= bytes) {
    const uint32_t code = first_character(at, length, &bytes);
    if (bytes == 0 || is_control(code)) return 0;
  }
  return 1;
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
static void release(buffer* b) {
  free(b->bytes);
  memset(b, 0, sizeof *b);
}
/* The system has it back too: glibc would keep blocks of up to 32 MiB once it has seen one go. */
static void release_large(buffer* b) {
  if (b->capacity <= USUAL_MEMORY) return;
  release(b);
#ifdef __GLIBC__
  malloc_trim(0);
#endif
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
static char* take_text(reader* in, uint32_t longest, size_t* length) {
  unsigned char* const place = in->at;
  const unsigned char* text;
  *length = take_u32(in);
  if (*length > longest) wrong(in, "has a text of %zu bytes; allowed are up to %u", *length, longest);
  if (!(text = take(in, *length))) return NULL;
  memmove(place, text, *length);
  place[*length] = 0;
  return (char*)place;
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
  release(&c->in);
  release(&c->out);
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

/* Reads until there are so many bytes, and a little of what has come besides; memory grows with what has
 * come. Nothing at all is no error where the connection is closed between two frames. */
static tandem_status fill(channel* c, size_t least, double until) {
  while (c->in.size < least) {
    const size_t wanted = least - c->in.size, grown = c->in.size;
    const size_t part = (wanted < grown ? wanted : grown) + 65536;
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
  if (type < T_HELLO || type > T_SAMPLE)
    return refuse(&c->fault, TANDEM_INVALID_ARGUMENT, "the frame has the type %u; allowed are 1 to %d",
                  (unsigned)type, T_SAMPLE);
  if (length > LONGEST)
    return refuse(&c->fault, TANDEM_INVALID_ARGUMENT,
                  "the frame '%s' announces %llu bytes; allowed are up to %llu", type_names[type],
                  (unsigned long long)length, (unsigned long long)LONGEST);
  c->frame = HEADER + (size_t)length;
  return TANDEM_OK;
}

/* The frame that was received last is not needed any more. */
static void forget(channel* c) {
  const size_t left = c->in.size - c->frame;
  buffer rest = {NULL, 0, 0, 0};
  if (c->in.capacity > USUAL_MEMORY) put_bytes(&rest, c->in.bytes + c->frame, left);
  if (c->in.capacity > USUAL_MEMORY && !rest.lost) {
    release_large(&c->in);
    c->in = rest;
  } else {
    if (c->frame && left) memmove(c->in.bytes, c->in.bytes + c->frame, left);
    c->in.size = left;
  }
  c->frame = 0;
}

/* The next frame, whole by then; *type is 0 if the connection was closed before it. */
static tandem_status receive(channel* c, double until, int* type, uint32_t* number, reader* in) {
  tandem_status status;
  forget(c);
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

#ifndef SOCK_CLOEXEC /* then a program that another thread starts meanwhile inherits it */
#define SOCK_CLOEXEC 0
#endif

/* A socket that programs started from here do not inherit; or -1. */
static int open_socket(int family) {
  const int s = socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (s >= 0 && !SOCK_CLOEXEC) fcntl(s, F_SETFD, FD_CLOEXEC);
  return s;
}

static int accept_connection(int listening) {
#ifdef __linux__
  return accept4(listening, NULL, NULL, SOCK_CLOEXEC);
#else
  const int s = accept(listening, NULL, NULL);
  if (s >= 0) fcntl(s, F_SETFD, FD_CLOEXEC);
  return s;
#endif
}

static int close_with(int socket, int error) {
  close(socket);
  errno = error;
  return -1;
}

/* A connected socket, or -1 and errno. */
static int attempt(const struct sockaddr* place, socklen_t size, double until) {
  const int s = open_socket(place->sa_family);
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
  if (strcmp(host, "*") == 0)
    return refuse(f, TANDEM_INVALID_ARGUMENT,
                  "address '%s' has the host '*'; allowed is a name or a number, which is 0.0.0.0 or [::] to "
                  "listen at every interface",
                  address);
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

static int64_t scalars_of(const tandem_port* ports, int32_t count) {
  int64_t scalars = 0;
  int32_t i;
  for (i = 0; i < count; ++i) scalars += ports[i].size;
  return scalars;
}
static int64_t input_size(const tandem_info* info) { return scalars_of(info->inputs, info->input_count); }
static int64_t output_size(const tandem_info* info) { return scalars_of(info->outputs, info->output_count); }

int64_t tandem_row_size(const tandem_info* info) {
  int64_t blocks = 1;
  int32_t i;
  for (i = 0; i < info->output_count; ++i)
    if (info->outputs[i].derivatives >= blocks) blocks = info->outputs[i].derivatives + 1;
  return 2 + output_size(info) * blocks;
}

/* A saved state that is not released. */
typedef struct kept_state {
  int64_t id;
  uint64_t bytes; /* as far as it is known */
} kept_state;

typedef struct session {
  channel channel;
  const tandem_subsystem_api* api;
  double idle; /* seconds */
  void* self;
  const tandem_info* info;
  int greeted, initialized,
      not_made;                  /* not_made: an instance, so that what it takes is told with the error */
  uint32_t number, capabilities; /* the last of the peer */
  buffer u0, signals, segments;  /* memory of a call */
  kept_state states[MAX_STATES];
  int state_count;
  uint64_t states_bytes, state_bytes; /* of all of them, and of one */
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

/* What the subsystem says, if it does not do it. */
static tandem_status told(session* s, tandem_status status) {
  if (status == TANDEM_OK) return TANDEM_OK;
  return refuse(&s->channel.fault, status, "%s", s->api->last_error(s->self));
}

/* Whether the table reaches to a function, and that is there. */
#define HAS(api, function) \
  ((api)->table_size >= offsetof(tandem_subsystem_api, function) + sizeof(api)->function && (api)->function)

/* A list that is empty where none are declared. */
static void put_declared(const session* s, buffer* b) {
  int32_t count = 0, i;
  const tandem_parameter* const list = HAS(s->api, parameters) ? s->api->parameters(&count) : NULL;
  put_u32(b, (uint32_t)count);
  for (i = 0; i < count; ++i) {
    put_u32(b, (list[i].unit ? 0U : 1U) | (list[i].otherwise ? 2U : 0U));
    put_text(b, list[i].name, LONGEST_NAME);
    put_text(b, list[i].unit ? list[i].unit : "", LONGEST_NAME);
    put_text(b, list[i].otherwise ? list[i].otherwise : "", LONGEST_NAME);
    put_text(b, list[i].sentence, LONGEST_NAME);
  }
}

static void put_nominal(const session* s, buffer* b) {
  const double* const nominal = HAS(s->api, nominal) ? s->api->nominal(s->self) : NULL;
  int32_t i;
  for (i = 0; i < s->info->output_count; ++i) put_double(b, nominal ? nominal[i] : 1.0);
}

/* What stands behind the rest of an info only where there are held outputs. */
static tandem_status put_held(session* s, buffer* b) {
  const int32_t* const held = s->info->abilities & TANDEM_HOLDS ? s->api->held(s->self) : NULL;
  double period = 0.0, latency = 0.0;
  tandem_status status;
  int32_t i;
  for (i = 0; held && i < s->info->output_count; ++i) put_u32(b, (uint32_t)held[i]);
  if (!(s->info->abilities & TANDEM_SAMPLED)) return TANDEM_OK;
  if ((status = s->api->sampling(s->self, &period, &latency)) != TANDEM_OK) return told(s, status);
  put_double(b, period);
  put_double(b, latency);
  return TANDEM_OK;
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
  if (put_held(s, b) != TANDEM_OK) return s->channel.fault.status;
  if (s->capabilities & CARRIES_NOMINAL) put_nominal(s, b);
  return send_frame(&s->channel);
}

static void put_hello(channel* c, const char* text, uint32_t capabilities) {
  put_bytes(&c->out, magic, sizeof magic);
  put_u32(&c->out, VERSION);
  put_u32(&c->out, VERSION);
  put_u64(&c->out, LONGEST);
  put_u32(&c->out, capabilities);
  put_text(&c->out, text, LONGEST_TEXT);
}

typedef struct greeting {
  uint32_t lowest, highest, capabilities;
  uint64_t longest;
  const char* text;
  size_t text_length;
} greeting;

static tandem_status read_hello(reader* in, greeting* g) {
  const unsigned char* mark = take(in, sizeof magic);
  if (mark && memcmp(mark, magic, sizeof magic) != 0)
    wrong(in, "does not begin with TANDEM, so the peer speaks something else");
  g->lowest = take_u32(in);
  g->highest = take_u32(in);
  g->longest = take_u64(in);
  g->capabilities = take_u32(in);
  g->text = take_text(in, LONGEST_TEXT, &g->text_length);
  return done(in);
}

/* Whether both sides can do what held outputs and samples need. */
static tandem_status require_carried(session* s) {
  const tandem_subsystem_api* const api = s->api;
  const uint32_t abilities = s->info->abilities;
  if (!(abilities & (TANDEM_HOLDS | TANDEM_SAMPLED))) return TANDEM_OK;
  if (!(s->capabilities & CARRIES_HELD))
    return refuse(
        &s->channel.fault, TANDEM_NOT_SUPPORTED,
        "subsystem '%s' has held outputs or is sampled, of which the peer does not speak (capability "
        "1)",
        s->info->name);
  if (((abilities & TANDEM_HOLDS) && !HAS(api, held)) ||
      ((abilities & TANDEM_SAMPLED) && !(HAS(api, sampling) && HAS(api, sample))))
    return refuse(&s->channel.fault, TANDEM_INVALID_ARGUMENT,
                  "subsystem '%s' has held outputs or is sampled, but has no functions for it",
                  s->info->name);
  return TANDEM_OK;
}

static tandem_status answer_hello(session* s, reader* in) {
  fault* f = &s->channel.fault;
  greeting g;
  char shown[204];
  if (read_hello(in, &g) != TANDEM_OK) return f->status;
  s->greeted = 1;
  if (g.lowest > VERSION || g.highest < VERSION)
    return refuse(f, TANDEM_NOT_SUPPORTED, "the peer speaks version %u to %u of the protocol; allowed is %d",
                  g.lowest, g.highest, VERSION);
  if (g.longest < SHORTEST_LIMIT)
    return refuse(f, TANDEM_NOT_SUPPORTED,
                  "the peer takes payloads of up to %llu bytes; allowed are %d or more",
                  (unsigned long long)g.longest, SHORTEST_LIMIT);
  if (!is_printable(g.text, g.text_length)) {
    printable(shown, sizeof shown - 4, g.text, g.text_length);
    return refuse(f, TANDEM_INVALID_ARGUMENT, "the parameters hold what is no text: '%s'", shown);
  }
  s->channel.longest = g.longest;
  s->capabilities = g.capabilities;
  s->not_made = 1;
  if (s->api->create(g.text, &s->self) != TANDEM_OK)
    return refuse(f, TANDEM_INVALID_ARGUMENT, "%s",
                  s->self ? s->api->last_error(s->self) : "no instance can be made");
  s->not_made = 0;
  if (!(s->info = s->api->info(s->self))) return refuse(f, TANDEM_INTERNAL, "the subsystem gives no info");
  if (require_carried(s) != TANDEM_OK) return f->status;
  begin(&s->channel, T_HELLO, s->number);
  put_hello(&s->channel, "tandem for C", CARRIES_HELD | CARRIES_PARAMETERS | CARRIES_NOMINAL);
  if (s->capabilities & CARRIES_PARAMETERS) put_declared(s, &s->channel.out);
  return send_frame(&s->channel);
}

/* Rows for one reply: as many as are asked for and fit. They are made where the reply has them. */
static tandem_status make_rows(session* s, uint64_t room, tandem_samples* y) {
  const uint64_t stride = (uint64_t)tandem_row_size(s->info);
  const uint64_t longest = s->channel.longest < LONGEST ? s->channel.longest : LONGEST;
  const uint64_t fit = (longest - SAMPLES_HEAD) / (8 * stride), capacity = room < fit ? room : fit;
  const size_t before = HEADER + SAMPLES_HEAD, spare = LONGEST_TOLD; /* an error's head is longer */
  if (capacity == 0)
    return refuse(&s->channel.fault, TANDEM_INVALID_ARGUMENT,
                  "there is room for no row of %llu bytes in a reply", (unsigned long long)(8 * stride));
  if (!reserve(&s->channel.out, before + 8 * capacity * stride + spare))
    return refuse(&s->channel.fault, TANDEM_INTERNAL, "there is no memory for %llu rows",
                  (unsigned long long)capacity);
  y->rows = (double*)(void*)(s->channel.out.bytes + before);
  y->stride = (int64_t)stride;
  y->capacity = (int64_t)capacity;
  y->size = 0;
  return TANDEM_OK;
}

static void put_clock(buffer* b, const tandem_clock* clock) {
  put_double(b, clock->time);
  put_double(b, clock->next_time);
  put_u32(b, (uint32_t)clock->stop);
}

/* Rows that stand in the reply already, behind what has been put and these two numbers. */
static void put_rows(buffer* b, const tandem_samples* y) {
  put_u32(b, (uint32_t)y->stride);
  put_u64(b, (uint64_t)y->size);
  put_doubles(b, y->rows, (size_t)(y->size * y->stride));
}

static tandem_status reply_error(session* s, tandem_status code, const char* sentence, tandem_samples* y) {
  buffer* const out = &s->channel.out;
  char told[LONGEST_TOLD + 4];
  const size_t length = printable(told, LONGEST_TOLD, sentence, strlen(sentence));
  if (y) {
    double* const place = (double*)(void*)(out->bytes + HEADER + 20 + length);
    memmove(place, y->rows, 8 * (size_t)(y->size * y->stride));
    y->rows = place;
  }
  begin(&s->channel, T_ERROR, s->number);
  put_u32(out, (uint32_t)code);
  put_text(out, told, length);
  if (y) put_rows(out, y);
  if (s->not_made && (s->capabilities & CARRIES_PARAMETERS)) put_declared(s, out);
  return send_frame(&s->channel);
}

/* What the subsystem has done; its own errors leave the session as it is. */
static tandem_status reply_samples(session* s, tandem_status status, tandem_samples* y,
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
  forget(&s->channel);
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

typedef struct signal_head {
  uint32_t count, degree;
} signal_head;

static signal_head take_signal_head(reader* in) {
  signal_head head;
  head.count = take_u32(in);
  head.degree = take_u32(in);
  if (!in->bad && (head.count == 0 || head.degree >= TANDEM_MAX_COEFFICIENTS ||
                   head.count > in->left / (8 * (head.degree + 3))))
    wrong(in, "has an input of %u segments of degree %u; allowed are 1 or more that follow, of degree 0 to 5",
          head.count, head.degree);
  return head;
}

/* Reads one input into the segments from `next` on, and gives the next free one. */
static tandem_segment* read_signal(reader* in, tandem_signal* signal, tandem_segment* next) {
  const signal_head head = take_signal_head(in);
  uint32_t k;
  memset(signal, 0, sizeof *signal);
  signal->segments = next;
  signal->count = (int32_t)head.count;
  signal->degree = (int32_t)head.degree;
  for (k = 0; !in->bad && k < head.count; ++k) read_segment(in, head.degree, next++);
  return next;
}

/* Of all inputs, which may take no more memory than a request. */
static size_t count_segments(reader* in, size_t inputs) {
  reader ahead = *in;
  size_t i, all = 0;
  for (i = 0; !ahead.bad && i < inputs; ++i) {
    const signal_head head = take_signal_head(&ahead);
    take(&ahead, head.count * (size_t)(8 * (head.degree + 3)));
    all += head.count;
  }
  in->bad = ahead.bad;
  if (all * sizeof(tandem_segment) + inputs * sizeof(tandem_signal) > LONGEST)
    wrong(in, "has %zu inputs of %zu segments, which take more than %llu bytes", inputs, all,
          (unsigned long long)LONGEST);
  return in->bad ? 0 : all;
}

static void read_signals(session* s, reader* in, size_t inputs) {
  const size_t segments = count_segments(in, inputs);
  tandem_segment* next;
  size_t i;
  if (!in->bad && (!reserve(&s->signals, (inputs + 1) * sizeof(tandem_signal)) ||
                   !reserve(&s->segments, (segments + 1) * sizeof(tandem_segment))))
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
  forget(&s->channel);
  if (s->info->abilities & TANDEM_SAMPLED)
    return reply_error(s, TANDEM_NOT_SUPPORTED, "the subsystem is sampled and takes no own steps", NULL);
  memset(&clock, 0, sizeof clock);
  status = s->api->advance(s->self, t_limit, (int32_t)land, (const tandem_signal*)(void*)s->signals.bytes, &y,
                           &clock);
  return reply_samples(s, status, &y, &clock);
}

/* The inputs stand in u0, the outputs that are asked for behind them. */
static tandem_status reply_sample(session* s, double t, uint32_t parts, size_t inputs) {
  const double* const u = (const double*)(void*)s->u0.bytes;
  double* const y = (double*)(void*)s->u0.bytes + inputs;
  const size_t outputs = parts & TANDEM_SAMPLE_OUTPUTS ? (size_t)output_size(s->info) : 0;
  tandem_clock clock = {0.0, 0.0, 0, 0};
  tandem_status status;
  if (!(s->info->abilities & TANDEM_SAMPLED))
    return reply_error(s, TANDEM_NOT_SUPPORTED, "the subsystem is not sampled", NULL);
  status = s->api->sample(s->self, t, (int32_t)parts, u, y, &clock);
  if (status != TANDEM_OK) return reply_error(s, status, s->api->last_error(s->self), NULL);
  begin(&s->channel, T_SAMPLE, s->number);
  put_clock(&s->channel.out, &clock);
  put_u32(&s->channel.out, (uint32_t)outputs);
  put_doubles(&s->channel.out, y, outputs);
  return send_frame(&s->channel);
}

static tandem_status answer_sample(session* s, reader* in) {
  const double t = take_finite(in, "t");
  const uint32_t parts = take_u32(in);
  const size_t inputs = take_count(in, 8), outputs = (size_t)output_size(s->info);
  size_t k;
  if (parts < 1 || parts > 3) wrong(in, "asks for the parts %u; allowed are 1 to 3", parts);
  check_inputs(s, in, inputs);
  if (!in->bad && !reserve(&s->u0, 8 * (inputs + outputs) + 8))
    wrong(in, "has %zu inputs; there is no memory for them", inputs);
  for (k = 0; !in->bad && k < inputs; ++k) ((double*)(void*)s->u0.bytes)[k] = take_finite(in, "input");
  return done(in) == TANDEM_OK ? reply_sample(s, t, parts, inputs) : s->channel.fault.status;
}

/* Whether the subsystem can do what is asked of its states. */
static int can(const session* s, int type) {
  const int bytes = type == T_SERIALIZE || type == T_DESERIALIZE;
  return (s->info->abilities & TANDEM_SAVES_STATE) &&
         (!bytes || ((s->info->abilities & TANDEM_SERIALIZES_STATE) &&
                     s->api->table_size >= offsetof(tandem_subsystem_api, held)));
}

/* A peer may leave states for as long as it likes, but only so many; one is as large as the model makes it.
 */
static tandem_status require_room_for_state(session* s, uint64_t bytes) {
  if (s->state_count == 0 || (s->state_count < MAX_STATES && s->states_bytes + bytes <= MAX_STATE_BYTES))
    return TANDEM_OK;
  return refuse(
      &s->channel.fault, TANDEM_NOT_SUPPORTED,
      "the session keeps %d saved states of %llu bytes; allowed are up to %d, and %llu bytes in all: "
      "release some",
      s->state_count, (unsigned long long)s->states_bytes, MAX_STATES, (unsigned long long)MAX_STATE_BYTES);
}

static void forget_state(session* s, int64_t id) {
  int k = 0;
  while (k < s->state_count && s->states[k].id != id) ++k;
  if (k == s->state_count) return;
  s->states_bytes -= s->states[k].bytes;
  s->states[k] = s->states[--s->state_count];
}

static void keep_state(session* s, int64_t id, uint64_t bytes) {
  forget_state(s, id);
  s->states[s->state_count].id = id;
  s->states[s->state_count++].bytes = bytes;
  s->states_bytes += bytes;
}

/* How large its states are is asked once. One that the peer is not told of is not kept. */
static tandem_status save(session* s, int64_t* id) {
  const void* bytes;
  int64_t size = 0;
  tandem_status status = require_room_for_state(s, s->state_bytes);
  if (status != TANDEM_OK || (status = told(s, s->api->save_state(s->self, id))) != TANDEM_OK) return status;
  if (s->state_bytes == 0 && can(s, T_SERIALIZE)) {
    status = told(s, s->api->serialize_state(s->self, *id, &bytes, &size));
    if (status != TANDEM_OK) {
      s->api->release_state(s->self, *id);
      return status;
    }
    s->state_bytes = (uint64_t)size;
  }
  keep_state(s, *id, s->state_bytes);
  return status;
}

static tandem_status deserialize(session* s, const reader* in, int64_t* id) {
  const uint64_t size = in->left;
  tandem_status status = require_room_for_state(s, size);
  if (status != TANDEM_OK) return status;
  status = told(s, s->api->deserialize_state(s->self, in->at, (int64_t)size, id));
  if (status == TANDEM_OK) keep_state(s, *id, size);
  return status;
}

/* Puts the bytes into the reply, if the peer takes that many. */
static tandem_status serialize(session* s, int64_t id) {
  const uint64_t most = s->channel.longest < LONGEST ? s->channel.longest : LONGEST;
  const void* bytes = NULL;
  int64_t size = 0;
  const tandem_status status = told(s, s->api->serialize_state(s->self, id, &bytes, &size));
  if (status != TANDEM_OK) return status;
  if ((uint64_t)size > most)
    return refuse(&s->channel.fault, TANDEM_NOT_SUPPORTED,
                  "the state has %lld bytes; a reply may have up to %llu", (long long)size,
                  (unsigned long long)most);
  put_bytes(&s->channel.out, bytes, (size_t)size);
  return TANDEM_OK;
}

/* Does what is asked, and puts what it gives into the reply. */
static tandem_status do_state(session* s, int type, int64_t id, const reader* in) {
  buffer* const out = &s->channel.out;
  tandem_clock clock = {0.0, 0.0, 0, 0};
  tandem_status status;
  begin(&s->channel, type, s->number);
  if (type == T_SERIALIZE) return serialize(s, id);
  if (type == T_SAVE)
    status = save(s, &id);
  else if (type == T_RESTORE)
    status = told(s, s->api->restore_state(s->self, id, &clock));
  else if (type == T_RELEASE)
    status = told(s, s->api->release_state(s->self, id));
  else
    status = deserialize(s, in, &id);
  if (status != TANDEM_OK) return status;
  if (type == T_RELEASE) forget_state(s, id);
  if (type == T_SAVE || type == T_DESERIALIZE) put_u64(out, (uint64_t)id);
  if (type == T_RESTORE) put_clock(out, &clock);
  return TANDEM_OK;
}

static tandem_status answer_state(session* s, int type, reader* in) {
  const int bytes_too = type == T_SERIALIZE || type == T_DESERIALIZE;
  const int64_t id = type == T_SAVE || type == T_DESERIALIZE ? 0 : (int64_t)take_u64(in);
  tandem_status status;
  if (type != T_DESERIALIZE && (status = done(in)) != TANDEM_OK) return status;
  if (!can(s, type))
    return reply_error(s, TANDEM_NOT_SUPPORTED,
                       bytes_too ? "the subsystem has no ability to give its state as bytes"
                                 : "the subsystem has no ability to save its state",
                       NULL);
  if ((status = do_state(s, type, id, in)) != TANDEM_OK)
    return reply_error(s, status, s->channel.fault.sentence, NULL);
  return send_frame(&s->channel);
}

static tandem_status answer_ping(session* s, reader* in) {
  begin(&s->channel, T_PING, s->number);
  put_bytes(&s->channel.out, in->at, in->left);
  forget(&s->channel);
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
    case T_SAMPLE:
      return answer_sample(s, in);
    case T_PING:
      return answer_ping(s, in);
    default:
      return answer_state(s, type, in);
  }
}

/* Memory that a request or its reply has left. */
static void release_memory(session* s, void (*give_back)(buffer*)) {
  give_back(&s->channel.out);
  give_back(&s->u0);
  give_back(&s->signals);
  give_back(&s->segments);
}

/* One request; *more is 0 after the last one. The hello has one deadline for the wait and all of it. */
static tandem_status answer(session* s, int* more) {
  channel* c = &s->channel;
  const uint32_t allowed = s->number + 1;
  const double patience = s->info ? s->idle : c->deadline, until = now() + patience;
  uint32_t number;
  reader in;
  int type;
  *more = 0;
  s->number = 0; /* of what goes wrong before the request's own is known to be right */
  release_memory(s, release_large);
  forget(c);
  if (c->in.size == 0 && !wait_for(c->socket, POLLIN, until))
    return refuse(&c->fault, TANDEM_INPUT_OUTPUT, "no %s came within %g s, so the session ends",
                  s->info ? "request" : "hello", patience);
  if (receive(c, s->info ? now() + c->deadline : until, &type, &number, &in) != TANDEM_OK)
    return c->fault.status;
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

/* On standard error. A peer's text may be in it. */
static void say(const char* sentence) {
  char shown[LONGEST_SHOWN + 4];
  printable(shown, LONGEST_SHOWN, sentence, strlen(sentence));
  fprintf(stderr, "%s\n", shown);
}

enum { BROKE = 1, NO_HELLO = 2 }; /* of a session that has ended; both of one that began with nonsense */

/* Serves one session on a connected socket, which it closes. */
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
    char sentence[sizeof s.channel.fault.sentence + 16];
    snprintf(sentence, sizeof sentence, "session ends: %s", s.channel.fault.sentence);
    say(sentence);
    reply_error(&s, status, s.channel.fault.sentence, NULL);
  }
  if (s.self) api->destroy(s.self);
  release_memory(&s, release);
  tear_down(&s.channel);
  return (status != TANDEM_OK ? BROKE : 0) | (s.greeted ? 0 : NO_HELLO);
}

/* ---- The server ---- */

typedef struct server {
  const tandem_subsystem_api* api;
  const char* address;
  double deadline, idle;
  int once, most, allow_plaintext;
  int listener, count; /* of the sessions under way, each a process */
  pid_t sessions[MAX_SESSIONS];
  int begun, broken; /* a session has begun, and perhaps said hello; the last to end was broken */
  int shortage;      /* errno of the last connection, if it could not be taken */
  struct stat file;  /* of a Unix socket */
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
  s->listener = open_socket(AF_UNIX);
  if (s->listener < 0 ||
      fchmod(s->listener, S_IRUSR | S_IWUSR) != 0 || /* before there is a file to connect to */
      bind(s->listener, (const struct sockaddr*)&place, sizeof place) != 0 ||
      listen(s->listener, SOMAXCONN) != 0 || lstat(place.sun_path, &s->file) != 0)
    return refuse(&s->fault, TANDEM_INPUT_OUTPUT, "no listening at %s: %s", s->address, strerror(errno));
  printf("serving at %s\n", s->address);
  return TANDEM_OK;
}

/* The file of a Unix socket goes with it, unless another has come in its place. */
static void remove_file(const server* s) {
  struct stat there;
  if (strncmp(s->address, "unix:", 5) == 0 && lstat(s->address + 5, &there) == 0 &&
      there.st_ino == s->file.st_ino && there.st_dev == s->file.st_dev)
    unlink(s->address + 5);
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
  s->listener = open_socket(all->ai_family);
  setsockopt(s->listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  failed = s->listener < 0 || bind(s->listener, all->ai_addr, all->ai_addrlen) != 0 ||
           listen(s->listener, SOMAXCONN) != 0;
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
      if (WIFEXITED(status) && (WEXITSTATUS(status) & NO_HELLO))
        s->begun = 0;
      else
        s->broken = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
      s->sessions[i] = s->sessions[--s->count];
    }
}

/* Its request is not awaited: whoever connects and says nothing costs nothing. */
static void turn_away(int socket, const char* why) {
  session guest;
  char sentence[256];
  memset(&guest, 0, sizeof guest);
  set_up(&guest.channel, socket, 0.1);
  guest.number = 1;
  snprintf(sentence, sizeof sentence, "turned away, as the server %s", why);
  say(sentence);
  snprintf(sentence, sizeof sentence, "the server %s; try again later", why);
  reply_error(&guest, TANDEM_NOT_SUPPORTED, sentence, NULL);
  tear_down(&guest.channel);
}

static void take_guest(server* s, int socket) {
  char why[128];
  pid_t process = -1;
  if (s->count >= s->most) clear_away(s); /* one may have ended since */
  if (s->count >= s->most)
    snprintf(why, sizeof why, "has %d sessions open, the most that it allows", s->most);
  else if ((process = fork()) < 0)
    snprintf(why, sizeof why, "can make no process: %s", strerror(errno));
  if (process < 0) {
    turn_away(socket, why);
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

/* There is no descriptor or memory for another connection, which waits. Told once, and tried again at
 * leisure. */
static void wait_out(server* s, int shortage) {
  char sentence[256];
  snprintf(sentence, sizeof sentence, "further connections wait: %s", strerror(shortage));
  if (shortage != s->shortage) say(sentence);
  s->shortage = shortage;
  poll(NULL, 0, 100);
}

static void take_next(server* s) {
  const int guest = accept_connection(s->listener);
  if (guest >= 0) {
    s->shortage = 0;
    take_guest(s, guest);
  } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
    wait_out(s, errno);
  }
}

static void serve_all(server* s) {
  while (!ended && !(s->once && s->begun && s->count == 0)) {
    clear_away(s);
    if (s->once && s->begun)
      poll(NULL, 0, 5);
    else if (wait_for(s->listener, POLLIN, now() + 0.1))
      take_next(s);
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

/* That of TANDEM_FD. */
static tandem_status find_socket(server* s, int* socket) {
  const char* const number = getenv("TANDEM_FD");
  char* end;
  const long found = strtol(number, &end, 10);
  int type;
  socklen_t size = sizeof type;
  if (end == number || *end || found < 0 || found > INT_MAX ||
      getsockopt((int)found, SOL_SOCKET, SO_TYPE, &type, &size) != 0)
    return refuse(&s->fault, TANDEM_INVALID_ARGUMENT,
                  "the variable TANDEM_FD is '%s'; allowed is the number of a socket that is open", number);
  *socket = (int)found;
  return TANDEM_OK;
}

/* The session of TANDEM_FD, or all of --listen; the status of the program. */
static int serve_there(server* s) {
  signals before;
  int socket = -1;
  if (!s->address) {
    if (find_socket(s, &socket) == TANDEM_OK)
      return serve_session(s->api, socket, s->deadline, s->idle) & BROKE;
  } else if (strncmp(s->address, "unix:", 5) == 0) {
    listen_unix(s);
  } else {
    listen_tcp(s);
  }
  if (s->fault.status != TANDEM_OK) {
    say(s->fault.sentence);
    return 2;
  }
  fflush(stdout);
  fcntl(s->listener, F_SETFL, O_NONBLOCK);
  catch_signals(&before);
  serve_all(s);
  sigaction(SIGTERM, &before.terminate, NULL);
  sigaction(SIGINT, &before.interrupt, NULL);
  sigprocmask(SIG_SETMASK, &before.mask, NULL);
  close(s->listener);
  remove_file(s);
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

/* A text of a peer that could not stay as it was, in a list. */
typedef struct shown_text {
  struct shown_text* next;
  char text[];
} shown_text;

typedef struct remote {
  channel channel;
  char* address;
  pid_t program, group;          /* of spawn: */
  int held_open;                 /* the end of a pipe, by the group */
  int request;                   /* the type of the last one */
  uint32_t number, capabilities; /* the last of both sides */
  double t_start, time, goal;    /* of the run, where it stands, where it was told to go */
  tandem_info info;
  void* info_memory[6];   /* names, inputs, outputs, feedthrough, which outputs are held, nominal values */
  double period, latency; /* of a sampled one, in seconds */
  shown_text* shown;      /* and names that hold control characters */
  int broken;             /* the connection; `reason` says why */
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
  char hint[32] = "";
  if (r->program <= 0 || !has_ended(r->program, now() + 0.1, &end)) return;
  if (end.si_code == CLD_EXITED && end.si_status > 128)
    snprintf(hint, sizeof hint, " (signal %d?)", end.si_status - 128);
  snprintf(r->reason, sizeof r->reason, "program '%s' %s %d%s", r->address + 6,
           end.si_code == CLD_EXITED ? "ended with status" : "was ended by signal", end.si_status,
           end.si_code == CLD_EXITED && end.si_status == 127 ? " (not found?)" : hint);
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

/* Its sentence goes into `shown`. */
static void take_error(reader* in, tandem_status* status, char shown[LONGEST_SHOWN + 4]) {
  const uint32_t code = take_u32(in);
  const int known = code >= TANDEM_INVALID_ARGUMENT && code <= TANDEM_INTERNAL;
  size_t length;
  const char* const text = take_text(in, LONGEST_TEXT, &length);
  *status = known ? (tandem_status)code : TANDEM_INTERNAL;
  printable(shown, LONGEST_SHOWN, text, text ? length : 0);
}

/* What the subsystem says; the connection is as sound as before. Rows may have come before the error. */
static tandem_status read_error(remote* r, reader* in, tandem_samples* y) {
  tandem_status status;
  char sentence[LONGEST_SHOWN + 4];
  take_error(in, &status, sentence);
  if (y && !in->bad && in->left) read_rows(in, y);
  if (done(in) != TANDEM_OK) return break_off(r);
  return tell(r, status, sentence);
}

/* Why the server ended the session. */
static tandem_status hear(remote* r, reader* in) {
  tandem_status status;
  char sentence[LONGEST_SHOWN + 4];
  take_error(in, &status, sentence);
  if (done(in) == TANDEM_OK) refuse(&r->channel.fault, status, "%s", sentence);
  return break_off(r);
}

/* Nothing can be sent; the server may have said why before it closed. */
static tandem_status hear_farewell(remote* r, reader* in) {
  const fault why = r->channel.fault;
  uint32_t number;
  int type;
  if (receive(&r->channel, now() + 0.1, &type, &number, in) == TANDEM_OK && type == T_ERROR)
    return hear(r, in);
  r->channel.fault = why;
  return break_off(r);
}

/* Sends the request; the reply is of that type, or an error. */
static tandem_status exchange(remote* r, int expected, reader* in, tandem_samples* y) {
  fault* f = &r->channel.fault;
  uint32_t number = 0;
  int type = 0;
  if (send_frame(&r->channel) != TANDEM_OK) return hear_farewell(r, in);
  if (receive(&r->channel, now() + r->channel.deadline, &type, &number, in) != TANDEM_OK) return break_off(r);
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
  const uint32_t ours = CARRIES_HELD | CARRIES_NOMINAL;
  greeting g;
  reader in;
  tandem_status status = begin_request(r, T_HELLO);
  put_hello(&r->channel, parameters, ours);
  if ((status = exchange(r, T_HELLO, &in, NULL)) != TANDEM_OK) return status;
  if (read_hello(&in, &g) != TANDEM_OK) return break_off(r);
  if (g.lowest != VERSION || g.highest != VERSION) {
    refuse(&r->channel.fault, TANDEM_NOT_SUPPORTED,
           "the peer speaks version %u to %u of the protocol; allowed is %d", g.lowest, g.highest, VERSION);
    return break_off(r);
  }
  r->channel.longest = g.longest;
  r->capabilities = g.capabilities & ours;
  return TANDEM_OK;
}

/* A name or a unit, to be shown. It stays where it came if it can. */
static const char* take_name(remote* r, reader* in) {
  size_t length, size;
  const char* const text = take_text(in, LONGEST_NAME, &length);
  shown_text* other;
  if (!text || is_printable(text, length)) return text;
  size = printable(NULL, LONGEST_NAME, text, length);
  if (!(other = malloc(sizeof *other + size + 1))) {
    wrong(in, "has a name of %zu bytes; there is no memory for it", size);
    return NULL;
  }
  printable(other->text, LONGEST_NAME, text, length);
  other->next = r->shown;
  r->shown = other;
  return other->text;
}

static int by_name(const void* a, const void* b) {
  return strcmp(((const tandem_port*)a)->name, ((const tandem_port*)b)->name);
}

/* Looks at a copy in the order of the names: a peer may tell of millions. */
static void check_names(reader* in, const tandem_port* ports, int32_t count) {
  tandem_port* const sorted = in->bad ? NULL : malloc((1 + (size_t)count) * sizeof *sorted);
  int32_t i;
  if (!in->bad && !sorted) wrong(in, "has %d ports; there is no memory for them", count);
  if (!sorted) return;
  memcpy(sorted, ports, (size_t)count * sizeof *sorted);
  qsort(sorted, (size_t)count, sizeof *sorted, by_name);
  for (i = 1; i < count; ++i)
    if (strcmp(sorted[i - 1].name, sorted[i].name) == 0)
      wrong(in, "has port '%s' twice among its inputs or outputs", sorted[i].name);
  free(sorted);
}

static tandem_port* read_ports(remote* r, reader* in, int32_t* count, int64_t* scalars) {
  tandem_port* const ports = calloc(1 + (size_t)(*count = (int32_t)take_count(in, 24)), sizeof *ports);
  int32_t i;
  if (!ports) wrong(in, "has %d ports; there is no memory for them", *count);
  for (i = 0; !in->bad && i < *count; ++i) {
    tandem_port* const p = ports + i;
    p->name = take_name(r, in);
    p->unit = take_name(r, in);
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
  check_names(in, ports, *count);
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

/* A flag for each output. told: they stand there; those of a sampled subsystem are held in any case. */
static int32_t* read_held(const remote* r, reader* in, int told) {
  int32_t* const held = calloc(1 + (size_t)r->info.output_count, sizeof *held);
  int32_t i;
  if (!held) wrong(in, "has %d outputs; there is no memory for them", r->info.output_count);
  for (i = 0; !in->bad && i < r->info.output_count; ++i)
    if ((held[i] = told ? (int32_t)take_u32(in) : 1) != 0 && held[i] != 1)
      wrong(in, "gives %d for whether output '%s' is held; allowed are 0 and 1", held[i],
            r->info.outputs[i].name);
  return held;
}

static void read_sampling(remote* r, reader* in) {
  r->period = take_double(in);
  r->latency = take_double(in);
  if (!in->bad && !(r->period > 0.0 && isfinite(r->period) && r->latency >= 0.0 && isfinite(r->latency)))
    wrong(in,
          "has a period of %g s and a latency of %g s; allowed are a period above 0, a latency of 0 or more",
          r->period, r->latency);
}

static double* read_nominal(const remote* r, reader* in) {
  double* const nominal = calloc(1 + (size_t)r->info.output_count, sizeof *nominal);
  int32_t i;
  if (!nominal) wrong(in, "has %d outputs; there is no memory for them", r->info.output_count);
  for (i = 0; !in->bad && i < r->info.output_count; ++i)
    if (!((nominal[i] = take_finite(in, "nominal value")) > 0.0))
      wrong(in, "gives %g as the nominal value of output '%s'; allowed is a number above 0", nominal[i],
            r->info.outputs[i].name);
  return nominal;
}

/* The texts of the info stay where they are, in memory of its own. */
static tandem_status ask_info(remote* r) {
  int64_t scalars[2] = {0, 0};
  reader in;
  tandem_status status = begin_request(r, T_INFO);
  if ((status = exchange(r, T_INFO, &in, NULL)) != TANDEM_OK) return status;
  if (!(r->info_memory[0] = malloc(in.size + 1))) {
    wrong(&in, "has %zu bytes; there is no memory for it", in.size);
    return break_off(r);
  }
  in.at = memcpy(r->info_memory[0], in.at, in.size);
  r->info.name = take_name(r, &in);
  r->info.abilities = take_u32(&in);
  r->info.inputs = r->info_memory[1] = read_ports(r, &in, &r->info.input_count, &scalars[0]);
  r->info.outputs = r->info_memory[2] = read_ports(r, &in, &r->info.output_count, &scalars[1]);
  r->info.feedthrough = r->info_memory[3] = read_feedthrough(&in, &r->info.feedthrough_count, scalars);
  if (!in.bad && (r->info.abilities & (TANDEM_HOLDS | TANDEM_SAMPLED)))
    r->info_memory[4] = read_held(r, &in, (r->info.abilities & TANDEM_HOLDS) != 0);
  if (!in.bad && (r->info.abilities & TANDEM_SAMPLED)) read_sampling(r, &in);
  if (!in.bad && (r->capabilities & CARRIES_NOMINAL)) r->info_memory[5] = read_nominal(r, &in);
  return finish(r, &in);
}

/* A group of processes that ends with this one, however that ends: a shell in it waits for the end of its
 * standard input, which only this process holds open, and then kills the group. */
static int start_group(remote* r) {
  int ends[2];
  if (pipe(ends) != 0) return 0;
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  fcntl(ends[1], F_SETFD, FD_CLOEXEC);
  r->group = fork();
  if (r->group == 0) {
    setpgid(0, 0);
    dup2(ends[0], STDIN_FILENO);
    fcntl(STDIN_FILENO, F_SETFD, 0);
    execl("/bin/sh", "sh", "-c", "trap '' HUP INT TERM; read x; kill -KILL 0", (char*)NULL);
    _exit(127);
  }
  close(ends[0]);
  r->held_open = ends[1];
  if (r->group > 0) return setpgid(r->group, r->group), 1; /* here too: whoever joins may come first */
  close(ends[1]);
  return 0;
}

static void end_group(remote* r) {
  kill(-r->group, SIGKILL);
  close(r->held_open);
  waitpid(r->group, NULL, 0);
}

/* sh -c COMMAND with one end of a socket, in a group of its own. */
static tandem_status start_program(remote* r, const char* command, int* ours) {
  char variable[32];
  char* arguments[] = {(char*)"sh", (char*)"-c", (char*)command, NULL};
  char** variables;
  size_t count = 0, kept = 0, k;
  int ends[2];
  while (environ[count]) ++count;
  variables = malloc((count + 2) * sizeof *variables);
  if (!variables || !start_group(r)) {
    free(variables);
    return refuse(&r->channel.fault, TANDEM_INPUT_OUTPUT, "the program can't be started: %s",
                  strerror(errno));
  }
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    const int why = errno;
    end_group(r);
    free(variables);
    return refuse(&r->channel.fault, TANDEM_INPUT_OUTPUT, "the program can't be started: %s", strerror(why));
  }
  /* All that allocates is done before the fork. */
  snprintf(variable, sizeof variable, "TANDEM_FD=%d", ends[1]);
  for (k = 0; k < count; ++k)
    if (strncmp(environ[k], "TANDEM_FD=", 10) != 0) variables[kept++] = environ[k];
  variables[kept++] = variable;
  variables[kept] = NULL;
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  r->program = fork();
  if (r->program == 0) {
    fcntl(ends[1], F_SETFD, 0);
    if (setpgid(0, r->group) == 0) execve("/bin/sh", arguments, variables);
    _exit(127);
  }
  free(variables);
  close(ends[1]);
  *ours = ends[0];
  if (r->program > 0) return TANDEM_OK;
  close(ends[0]);
  end_group(r);
  return refuse(&r->channel.fault, TANDEM_INPUT_OUTPUT, "the program can't be started: no process");
}

/* By now its socket is closed: a program that reads it ends of its own accord, others are told to. What it
 * has started and left is in its group, and goes with it. */
static void end_program(remote* r) {
  siginfo_t end;
  if (!has_ended(r->program, now() + 1.0, &end)) kill(-r->group, SIGTERM);
  if (!has_ended(r->program, now() + 1.0, &end)) kill(r->program, SIGKILL);
  waitpid(r->program, NULL, 0);
  end_group(r);
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
  if (r->program > 0) end_program(r);
  for (k = 0; k < sizeof r->info_memory / sizeof *r->info_memory; ++k) free(r->info_memory[k]);
  while (r->shown) {
    shown_text* const text = r->shown;
    r->shown = text->next;
    free(text);
  }
  free(r->address);
  free(r);
}

static const tandem_info* info(void* self) { return &((remote*)self)->info; }

static const char* last_error(void* self) { return ((remote*)self)->error; }

/* What a reply does not hold. */
static void refuse_reply(reader* in, const char* format, ...) {
  char sentence[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(sentence, sizeof sentence, format, arguments);
  va_end(arguments);
  if (!in->bad) refuse(in->fault, TANDEM_NUMERICAL, "the reply %s", sentence);
  in->bad = 1;
  in->left = 0;
}

/* The name of output k, flattened. */
static void name_output(const tandem_info* info, int64_t k, char name[256]) {
  const tandem_port* p = info->outputs;
  for (; k >= p->size; ++p) k -= p->size;
  snprintf(name, 256, p->size == 1 ? "%s" : "%s[%lld]", p->name, (long long)k);
}

static void check_value(const remote* r, reader* in, const double* row, int64_t k, const char* when) {
  const int64_t outputs = output_size(&r->info);
  char name[256];
  if (isfinite(row[2 + k])) return;
  name_output(&r->info, k % outputs, name);
  refuse_reply(in, "gives %s%s not finite at %s", name, k >= outputs ? " (a derivative)" : "", when);
}

/* Whether no input that is not known feeds through to the output. */
static int knows(const remote* r, const double* u0, int64_t output) {
  int32_t k;
  for (k = 0; k < r->info.feedthrough_count; ++k)
    if (r->info.feedthrough[k].output == output && isnan(u0[r->info.feedthrough[k].input])) return 0;
  return 1;
}

/* A row's second number. */
static void check_jump(reader* in, const double* row) {
  char flag[32], time[32];
  if (row[1] == 0.0 || row[1] == 1.0) return;
  shortest(flag, row[1]);
  shortest(time, row[0]);
  refuse_reply(in, "gives %s as the jump flag of its sample at t = %s s; allowed is 0 or 1", flag, time);
}

/* Finite, but for what may follow inputs that are not known: outputs by feedthrough, derivatives by any. */
static void check_newest(const remote* r, reader* in, const double* row, const double* u0) {
  const int64_t outputs = output_size(&r->info), inputs = input_size(&r->info);
  int64_t k, known = 0;
  while (known < inputs && !isnan(u0[known])) ++known;
  for (k = 0; !in->bad && k < tandem_row_size(&r->info) - 2; ++k)
    if (known == inputs || (k < outputs && knows(r, u0, k))) check_value(r, in, row, k, "the start");
}

/* Samples of the start. */
static void check_first(const remote* r, reader* in, const double* u0, const tandem_samples* y,
                        int64_t first) {
  char found[32], start[32];
  int64_t k;
  if (y->size == first) refuse_reply(in, "has no first sample");
  for (k = first; k < y->size; ++k) {
    if (y->rows[k * y->stride] != r->t_start) {
      shortest(found, y->rows[k * y->stride]);
      shortest(start, r->t_start);
      refuse_reply(in, "has a sample at t = %s s; allowed is the start, %s s", found, start);
    }
    check_jump(in, y->rows + k * y->stride);
  }
  if (!in->bad) check_newest(r, in, y->rows + (y->size - 1) * y->stride, u0);
}

static int is_sound(const double* row, int64_t stride, double before, double limit) {
  const int jump = row[1] == 1.0; /* may repeat a time */
  int64_t k;
  if (!jump && row[1] != 0.0) return 0;
  for (k = 0; k < stride; ++k)
    if (k != 1 && !isfinite(row[k])) return 0;
  return (row[0] > before || (jump && row[0] == before)) && row[0] <= limit;
}

/* A row of an advance, after one at time `before`. */
static void check_row(const remote* r, reader* in, const double* row, int64_t stride, double before) {
  const double width = 6.0 * DBL_EPSILON * fmax(fmax(fabs(row[0]), fabs(r->goal)), fabs(r->t_start));
  char time[32], last[32], limit[32], when[40];
  int64_t k;
  if (is_sound(row, stride, before, r->goal + width)) return;
  shortest(time, row[0]);
  shortest(last, before);
  shortest(limit, r->goal);
  snprintf(when, sizeof when, "t = %s s", time);
  if (!isfinite(row[0])) refuse_reply(in, "has a sample whose time is not finite");
  for (k = 0; !in->bad && k < stride - 2; ++k) check_value(r, in, row, k, when);
  check_jump(in, row);
  if (row[0] > r->goal + width)
    refuse_reply(in, "has a sample at t = %s s, past the limit %s s", time, limit);
  refuse_reply(in, "has a sample at t = %s s that does not come after t = %s s", time, last);
}

/* Wherever it stands. at_once: its next instant may be there. */
static void check_next(reader* in, const tandem_clock* clock, int at_once) {
  char time[32], next[32];
  if (!isfinite(clock->time)) refuse_reply(in, "gives a time that is not finite");
  if (clock->stop == TANDEM_STOP_FINISHED || clock->next_time > clock->time) return;
  if (at_once && clock->next_time == clock->time) return;
  shortest(time, clock->time);
  shortest(next, clock->next_time);
  refuse_reply(in, "gives %s s as the end of the next own step, which is not later than %s s", next, time);
}

static int is_sampled(const remote* r) { return (r->info.abilities & TANDEM_SAMPLED) != 0; }

/* The clock has to be that of the newest sample. */
static void check_clock(const remote* r, reader* in, const tandem_clock* clock, double stands) {
  char time[32], newest[32];
  if (clock->time != stands) {
    shortest(time, clock->time);
    shortest(newest, stands);
    refuse_reply(in, "says that it stands at t = %s s, but its newest sample is of %s s", time, newest);
  }
  check_next(in, clock, is_sampled(r));
}

/* The rows from `first` on, and the clock. */
static void check_samples(const remote* r, reader* in, const double* u0, const tandem_samples* y,
                          int64_t first, const tandem_clock* clock) {
  double time = r->time;
  int64_t i;
  if (r->request == T_INITIALIZE) check_first(r, in, u0, y, first);
  for (i = first; r->request == T_ADVANCE && !in->bad && i < y->size; ++i) {
    const double* const row = y->rows + i * y->stride;
    check_row(r, in, row, y->stride, time);
    time = row[0];
  }
  if (!in->bad) check_clock(r, in, clock, time);
}

/* They are the caller's. */
static tandem_status require_rows(remote* r, const tandem_samples* y) {
  const int64_t wanted = tandem_row_size(&r->info);
  if (y->stride == wanted) return TANDEM_OK;
  snprintf(r->error, sizeof r->error, "%s: the samples have rows of %lld numbers; allowed are %lld",
           r->address, (long long)y->stride, (long long)wanted);
  return TANDEM_INVALID_ARGUMENT;
}

/* u0: of initialize. */
static tandem_status exchange_samples(remote* r, const double* u0, tandem_samples* y, tandem_clock* clock) {
  const int64_t first = y->size;
  reader in;
  const tandem_status status = exchange(r, T_SAMPLES, &in, y);
  if (status != TANDEM_OK) return status;
  read_clock(&in, clock);
  read_rows(&in, y);
  if (!in.bad) check_samples(r, &in, u0, y, first, clock);
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
  if ((status = require_rows(r, y)) != TANDEM_OK) return status;
  if ((status = begin_request(r, T_INITIALIZE)) != TANDEM_OK) return status;
  put_double(b, t_start);
  put_double(b, t_stop);
  put_u64(b, room_of(y));
  put_u32(b, (uint32_t)inputs);
  put_doubles(b, u0, inputs);
  return exchange_samples(r, u0, y, clock);
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
  if ((status = require_rows(r, y)) != TANDEM_OK) return status;
  if ((status = begin_request(r, T_ADVANCE)) != TANDEM_OK) return status;
  put_double(&r->channel.out, t_limit);
  put_u32(&r->channel.out, land != 0);
  put_u32(&r->channel.out, (uint32_t)inputs);
  put_u64(&r->channel.out, room_of(y));
  for (i = 0; i < inputs; ++i) put_signal(&r->channel.out, u + i);
  return exchange_samples(r, NULL, y, clock);
}

static const int32_t* held(void* self) { return ((remote*)self)->info_memory[4]; }
static const double* nominal_values(void* self) { return ((remote*)self)->info_memory[5]; }

static tandem_status sampling(void* self, double* period, double* latency) {
  *period = ((remote*)self)->period;
  *latency = ((remote*)self)->latency;
  return TANDEM_OK;
}

/* Of a sample at r->time: outputs that are finite and, with the states, a clock that goes on from there. */
static void check_sample(const remote* r, reader* in, const double* y, size_t outputs,
                         const tandem_clock* clock) {
  char name[256], time[32], found[32];
  size_t k;
  shortest(time, r->time);
  for (k = 0; k < outputs; ++k) {
    if (isfinite(y[k])) continue;
    name_output(&r->info, (int64_t)k, name);
    refuse_reply(in, "gives %s not finite at t = %s s", name, time);
  }
  if (!clock) return;
  shortest(found, clock->time);
  if (clock->time != r->time)
    refuse_reply(in, "says that it stands at t = %s s; allowed is that of the sample, %s s", found, time);
  check_next(in, clock, 0);
}

static tandem_status sample(void* self, double t, int32_t parts, const double* u, double* y,
                            tandem_clock* clock) {
  remote* const r = self;
  buffer* const b = &r->channel.out;
  const size_t inputs = (size_t)input_size(&r->info);
  const size_t outputs = parts & TANDEM_SAMPLE_OUTPUTS ? (size_t)output_size(&r->info) : 0;
  size_t found;
  reader in;
  tandem_status status;
  r->time = t;
  if ((status = begin_request(r, T_SAMPLE)) != TANDEM_OK) return status;
  put_double(b, t);
  put_u32(b, (uint32_t)parts);
  put_u32(b, (uint32_t)inputs);
  put_doubles(b, u, inputs);
  if ((status = exchange(r, T_SAMPLE, &in, NULL)) != TANDEM_OK) return status;
  read_clock(&in, clock);
  if ((found = take_count(&in, 8)) != outputs) wrong(&in, "has %zu outputs; allowed are %zu", found, outputs);
  if (!in.bad) take_doubles(&in, y, outputs);
  if (!in.bad) check_sample(r, &in, y, outputs, parts & TANDEM_SAMPLE_STATES ? clock : NULL);
  return finish(r, &in);
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
  if (!in.bad) check_next(&in, clock, is_sampled(r));
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
  static const tandem_subsystem_api api = {
      .abi_version = TANDEM_ABI_VERSION,
      .table_size = sizeof(tandem_subsystem_api),
      .create = create,
      .destroy = destroy,
      .info = info,
      .last_error = last_error,
      .initialize = initialize,
      .advance = advance,
      .save_state = save_state,
      .restore_state = restore_state,
      .release_state = release_state,
      .serialize_state = serialize_state,
      .deserialize_state = deserialize_state,
      .held = held,
      .sampling = sampling,
      .sample = sample,
      .nominal = nominal_values,
  };
  return &api;
}
