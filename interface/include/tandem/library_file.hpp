// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <setjmp.h>  // sigsetjmp

#include <atomic>
#include <cfenv>
#include <filesystem>
#include <string>
#include <type_traits>

namespace tandem {

/// What is known of a shared library before it is loaded and called. (On Linux; elsewhere the loader has the
/// word alone.)

/// Throws Error(input_output) for what is no regular file, and for an ELF file that ends before what its
/// headers announce: the system's loader would end the program by a signal. `name`: what errors call it,
/// "library 'x.so'".
void check_library_file(const std::filesystem::path& file, const std::string& name);

/// Throws Error(invalid_argument) that begins with `library` if what stands at the address of a symbol is no
/// function.
void check_function(const void* address, const std::string& library, const std::string& symbol);

/// While there is one, this thread is in a call of a library. A library that ends the program there, by exit
/// or quick_exit, ends it with a sentence that names the library and with status 1, whatever status it gives.
/// In a program that says when it ends (begin_program, end_program) the same holds for a library that:
/// - ends the program before in any other way: in a thread of its own, or as it is unloaded;
/// - makes a fault, a signal: memory that is not there, a division by zero, abort.
///
/// Both in a thread that is in no call end the next call, or the one that is under way, as a fault in it does
/// (return_from_faults). The program itself ends two seconds later where no call is made or ends.
///
/// (What takes the process' place, exec, can't be told.)
class LibraryCall {
 public:
  /// library: how the sentence calls it, "library 'FILE'"; outlives the call. Null: no library.
  explicit LibraryCall(const char* library) noexcept : library_(library), outer_(current_) {
    if (library) current_ = this;
  }
  ~LibraryCall() { current_ = outer_; }
  LibraryCall(const LibraryCall&) = delete;
  LibraryCall& operator=(const LibraryCall&) = delete;

  /// Makes the call, once. In a program that has called return_from_faults() a fault in it is an
  /// Error(internal) that says what it was, and so is its end of the program. The program is to end soon then,
  /// without a call of any library: nobody knows what the fault has left behind. Throws Error(numerical) if the
  /// call has changed how this thread rounds numbers, and changes it back.
  template <class Call>
  auto make(const Call& call) {
    if (outside_ != 0) refuse_fault(outside_);
    sigjmp_buf back;
    if (const int signal = sigsetjmp(back, 0); signal != 0) refuse_fault(signal);
    back_ = &back;
    const int rounding = std::fegetround();
    if constexpr (std::is_void_v<decltype(call())>) {
      call();
      back_ = nullptr;
      check_end(rounding);
    } else {
      auto result = call();
      back_ = nullptr;
      check_end(rounding);
      return result;
    }
  }
  static void return_from_faults() noexcept;
  /// Then no library is to be called or unloaded any more.
  static bool has_faulted() noexcept;

  /// One in a process of its own did not end it well, after all that was wanted of it.
  static void note_bad_end() noexcept;
  static bool was_bad_end() noexcept;

  /// Before the first call; a second time it does nothing. Throws Error(internal) if it can't be done.
  static void guard_exit();
  /// From here on only end_program() gives this program a status.
  static void begin_program() noexcept;
  static void end_program(int status) noexcept;
  /// Set while another program waits for what this one does: its end tells it then. A library's exit is not
  /// printed but gives it the status ended_by_library, a fault outside of a call its signal.
  static void set_told_by_parent(bool told) noexcept;
  static constexpr int ended_by_library = 113;
  /// If it is not for this thread to end the program: tells so, and ends it with status 1. Else the status to
  /// end with. For who takes the place of _exit().
  static int refuse_exit(int status) noexcept;
  /// If this thread is in a call that faults return from: does not return, but ends the call so. In a thread
  /// beside the calls it waits for one that ends. For who takes the place of exit().
  static void return_from_exit() noexcept;

 private:
  /// Whether one is loaded in this process, which is not one that a library has made.
  static bool is_any_loaded() noexcept;
  static bool tells_itself() noexcept;
  static void guard_faults() noexcept;
  static void fault(int signal) noexcept;
  /// Where this thread is in a call that faults return from: there, with this cause.
  static void return_to_call(int cause) noexcept;
  /// Where this thread is in no call and is not the program's first: does not return while another may end the
  /// program for this cause.
  static void leave_to_others(int cause) noexcept;
  static constexpr int by_exit = -1;  ///< the cause that is no signal
  static void check_end(int rounding) {
    if (outside_ != 0) refuse_fault(outside_);
    if (std::fegetround() != rounding) refuse_rounding(rounding);
  }
  [[noreturn]] static void refuse_fault(int signal);
  [[noreturn]] static void refuse_rounding(int before);

  static constinit thread_local const LibraryCall* current_;
  static constinit std::atomic<int> outside_;  ///< cause of the fault of a thread in no call; 0: none
  const char* library_;
  const LibraryCall* outer_;
  sigjmp_buf* back_ = nullptr;
};

}  // namespace tandem
