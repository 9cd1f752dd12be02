! Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
! tandem/subsystem.h in Fortran 2008, by ISO_C_BINDING: its structures, and the value of an input. What the functions of
! the table have to do stands in that header.
module tandem
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: text_of, input_at

  integer(c_int), parameter, public :: ok = 0, invalid_argument = 1
  integer(c_int32_t), parameter, public :: stop_limit = 0, stop_samples_full = 2
  integer(c_int32_t), parameter, public :: lands = 2, restarts = 8, sampled = 64
  integer(c_int32_t), parameter, public :: sample_outputs = 1, sample_states = 2

  type, bind(c), public :: segment
    real(c_double) :: end, origin, c(0:5)
  end type
  type, bind(c), public :: signal
    type(c_ptr) :: segments
    integer(c_int32_t) :: count, degree
    type(c_ptr) :: reactive
  end type
  type, bind(c), public :: samples
    type(c_ptr) :: rows
    integer(c_int64_t) :: stride, capacity, size
  end type
  type, bind(c), public :: clock
    real(c_double) :: time, next_time
    integer(c_int32_t) :: stop, reserved
  end type
  type, bind(c), public :: port
    type(c_ptr) :: name, unit
    integer(c_int32_t) :: size, derivatives
    real(c_double) :: start
  end type
  type, bind(c), public :: info
    type(c_ptr) :: name
    integer(c_int32_t) :: abilities, input_count, output_count, feedthrough_count
    type(c_ptr) :: inputs, outputs, feedthrough
  end type
  type, bind(c), public :: table
    integer(c_int32_t) :: abi_version = 1, table_size = 0
    type(c_funptr) :: create = c_null_funptr, destroy = c_null_funptr, info = c_null_funptr, &
      last_error = c_null_funptr, initialize = c_null_funptr, advance = c_null_funptr, &
      save_state = c_null_funptr, restore_state = c_null_funptr, release_state = c_null_funptr, &
      serialize_state = c_null_funptr, deserialize_state = c_null_funptr, held = c_null_funptr, &
      sampling = c_null_funptr, sample = c_null_funptr
  end type

contains

  ! A text of C, as the parameters of `create` are.
  function text_of(pointer) result(text)
    type(c_ptr), intent(in) :: pointer
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: c(:)
    integer :: i, n
    call c_f_pointer(pointer, c, [100000])
    n = 0
    do while (c(n + 1) /= c_null_char)
      n = n + 1
    end do
    allocate (character(len=n) :: text)
    do i = 1, n
      text(i:i) = c(i)
    end do
  end function

  ! In this order of operations, as tandem/signal.h has it.
  real(c_double) function input_at(u, t)
    type(signal), intent(in) :: u
    real(c_double), intent(in) :: t
    type(segment), pointer :: s(:)
    real(c_double) :: x, x2
    integer :: i
    call c_f_pointer(u%segments, s, [u%count])
    i = 1
    do while (i < u%count .and. t > s(i)%end)
      i = i + 1
    end do
    x = t - s(i)%origin
    x2 = x*x
    associate (c => s(i)%c)
      input_at = (c(0) + c(1)*x) + x2*((c(2) + c(3)*x) + x2*(c(4) + c(5)*x))
    end associate
  end function

end module
