! Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
! tandem/subsystem.h in Fortran 2008, by ISO_C_BINDING: its structures, and the value of an input. What the functions of
! the table have to do stands in that header.
module tandem
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  implicit none
  private
  public :: text_of, declared, given, read_parameters, input_at

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
  type, bind(c), public :: declaration ! of a parameter
    type(c_ptr) :: name, unit, otherwise, sentence
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
      sampling = c_null_funptr, sample = c_null_funptr, parameters = c_null_funptr, nominal = c_null_funptr
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

  ! A parameter of these texts: its name, its unit (blank of a word), what stands where none is given (blank: one has to
  ! be), and what it is. They are ended as C's texts are, and have to live as long as it does.
  type(declaration) function declared(texts)
    character(kind=c_char, len=*), target, intent(inout) :: texts(4)
    type(c_ptr) :: c(4)
    integer :: i, at
    do i = 1, 4
      at = index(texts(i), c_null_char)
      if (at == 0) at = len_trim(texts(i)) + 1
      texts(i)(at:at) = c_null_char
      c(i) = c_loc(texts(i))
      if (at == 1) c(i) = c_null_ptr
    end do
    declared = declaration(c(1), c(2), c(3), c(4))
  end function

  ! The text of a parameter in 'key=value&key=value': as it is given, else as it is declared, else ''.
  function given(pairs, name, otherwise) result(text)
    character(len=*), intent(in) :: pairs, name
    type(c_ptr), intent(in) :: otherwise
    character(len=:), allocatable :: text
    integer :: at
    at = index('&'//pairs, '&'//name//'=')
    if (at > 0) then
      text = pairs(at + len(name) + 1:)
      text = text(:index(text//'&', '&') - 1)
    else if (c_associated(otherwise)) then
      text = text_of(otherwise)
    else
      text = ''
    end if
  end function

  ! The numbers of the parameters, in their order; 0 of a word, whose text `given` has. A sentence, or '' if all is well.
  function read_parameters(pairs, parameters, values) result(sentence)
    character(len=*), intent(in) :: pairs
    type(declaration), intent(in) :: parameters(:)
    real(c_double), intent(out) :: values(:)
    character(len=:), allocatable :: sentence, name, text
    integer :: i, failed
    sentence = unknown(pairs, parameters)
    do i = 1, size(parameters)
      if (sentence /= '') return
      values(i) = 0
      name = text_of(parameters(i)%name)
      text = given(pairs, name, parameters(i)%otherwise)
      failed = 0
      if (c_associated(parameters(i)%unit)) read (text, *, iostat=failed) values(i)
      if (failed /= 0 .or. (c_associated(parameters(i)%unit) .and. verify(text, '0123456789.eE+-') > 0) .or. &
        .not. ieee_is_finite(values(i))) sentence = "parameter '"//name//"' is no finite number"
      if (text == '') sentence = "parameter '"//name//"' is needed: "//text_of(parameters(i)%sentence)
    end do
  end function

  function unknown(pairs, parameters) result(sentence)
    character(len=*), intent(in) :: pairs
    type(declaration), intent(in) :: parameters(:)
    character(len=:), allocatable :: sentence, rest, key
    integer :: i
    logical :: known
    sentence = ''
    rest = pairs
    do while (rest /= '')
      key = rest(:scan(rest//'&', '=&') - 1)
      known = .false.
      do i = 1, size(parameters)
        known = known .or. text_of(parameters(i)%name) == key
      end do
      if (.not. known) sentence = "parameter '"//key//"' is not there"
      rest = rest(min(index(rest//'&', '&'), len(rest)) + 1:)
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
