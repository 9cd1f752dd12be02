! Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
! A PI controller that samples, in Fortran 2008, as a shared library, with the types of transports/fortran/tandem.f90.
!   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
! Input y [m]; output u [N], which holds.
module pi_subsystem
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
  use tandem
  implicit none
  private

  type :: instance
    real(c_double) :: p(6) ! in the order of `parameters`
    real(c_double) :: s ! the integral part
    real(c_double) :: first, time ! instant, and where it stands [s]
    integer(c_int64_t) :: instant ! number of the next one
    character(kind=c_char, len=200) :: error
  end type

  character(kind=c_char, len=3), target, save :: texts(5) = [character(kind=c_char, len=3) :: &
    'pi'//c_null_char, 'y'//c_null_char, 'u'//c_null_char, 'm'//c_null_char, 'N'//c_null_char]
  ! of each parameter name, unit, what stands otherwise, and what it is
  character(kind=c_char, len=48), target, save :: told(4, 6) = reshape([character(kind=c_char, len=48) :: &
    'kp', 'N/m', '', 'proportional gain', &
    'ki', 'N/(m s)', '', 'integral gain', &
    'r', 'm', '', 'what y is to be', &
    'T', 's', '', 'period', &
    'offset', 's', '', 'of the first instant', &
    'latency', 's', '', 'by which u changes later than the instant'], [4, 6])
  type(declaration), target, save :: parameters(6)
  type(port), target, save :: inputs(1), outputs(1)
  integer(c_int32_t), target, save :: feedthrough(2) = [0, 0] ! of output 0 and input 0
  type(info), target, save :: the_info
  type(table), target, save :: the_table

contains

  function tandem_subsystem() bind(c, name='tandem_subsystem') result(api)
    type(c_ptr) :: api
    real(c_double) :: none
    integer :: i
    none = ieee_value(none, ieee_quiet_nan)
    do i = 1, size(parameters)
      parameters(i) = declared(told(:, i))
    end do
    inputs(1) = port(c_loc(texts(2)), c_loc(texts(4)), 1, 0, none)
    outputs(1) = port(c_loc(texts(3)), c_loc(texts(5)), 1, 0, none)
    the_info = info(c_loc(texts(1)), ior(sampled, restarts), 1, 1, 1, c_loc(inputs), c_loc(outputs), c_loc(feedthrough))
    the_table = table(table_size=int(c_sizeof(the_table), c_int32_t), create=c_funloc(create), &
      destroy=c_funloc(destroy), info=c_funloc(get_info), last_error=c_funloc(last_error), &
      initialize=c_funloc(initialize), sampling=c_funloc(sampling), sample=c_funloc(sample), &
      parameters=c_funloc(get_parameters))
    api = c_loc(the_table)
  end function

  type(c_ptr) function get_parameters(number) bind(c, name='')
    integer(c_int32_t), intent(out) :: number
    number = size(parameters)
    get_parameters = c_loc(parameters)
  end function

  function of(self) result(it)
    type(c_ptr), value :: self
    type(instance), pointer :: it
    call c_f_pointer(self, it)
  end function

  integer(c_int) function refuse(it, sentence)
    type(instance), intent(inout) :: it
    character(len=*), intent(in) :: sentence
    it%error = sentence//c_null_char
    refuse = invalid_argument
  end function

  integer(c_int) function create(pairs, self) bind(c, name='')
    type(c_ptr), value :: pairs
    type(c_ptr), intent(out) :: self
    type(instance), pointer :: it
    character(len=:), allocatable :: sentence
    allocate (it)
    self = c_loc(it)
    sentence = read_parameters(text_of(pairs), parameters, it%p)
    create = ok
    if (sentence /= '') create = refuse(it, sentence)
  end function

  subroutine destroy(self) bind(c, name='')
    type(c_ptr), value :: self
    type(instance), pointer :: it
    it => of(self)
    deallocate (it)
  end subroutine

  type(c_ptr) function get_info(self) bind(c, name='')
    type(c_ptr), value :: self
    if (.not. c_associated(self)) then
      get_info = c_null_ptr
    else
      get_info = c_loc(the_info)
    end if
  end function

  type(c_ptr) function last_error(self) bind(c, name='')
    type(c_ptr), value :: self
    type(instance), pointer :: it
    it => of(self)
    last_error = c_loc(it%error)
  end function

  integer(c_int) function sampling(self, period, latency) bind(c, name='')
    type(c_ptr), value :: self
    real(c_double), intent(out) :: period, latency
    type(instance), pointer :: it
    it => of(self)
    period = it%p(4)
    latency = it%p(6)
    sampling = ok
  end function

  type(clock) function clock_of(it)
    type(instance), intent(in) :: it
    clock_of = clock(it%time, it%first + it%instant*it%p(4), stop_limit, 0) ! multiplied, never accumulated
  end function

  ! Before the first instant the integral part alone holds.
  integer(c_int) function initialize(self, t_start, t_stop, u0, y, now) bind(c, name='')
    type(c_ptr), value :: self
    real(c_double), value :: t_start, t_stop
    real(c_double), intent(in) :: u0(1)
    type(samples), intent(inout) :: y
    type(clock), intent(out) :: now
    type(instance), pointer :: it
    real(c_double), pointer :: rows(:, :)
    it => of(self)
    it%s = 0
    it%first = t_start + it%p(5)
    it%time = t_start
    it%instant = 0
    call c_f_pointer(y%rows, rows, [y%stride, y%capacity])
    y%size = y%size + 1
    rows(:, y%size) = [t_start, 0d0, it%s]
    now = clock_of(it)
    initialize = ok
    if (.not. t_stop > t_start .or. size(u0) /= 1) initialize = refuse(it, 't_stop has to be after t_start')
  end function

  integer(c_int) function sample(self, t, parts, y, u, now) bind(c, name='')
    type(c_ptr), value :: self
    real(c_double), value :: t
    integer(c_int32_t), value :: parts
    real(c_double), intent(in) :: y(1)
    real(c_double), intent(inout) :: u(1)
    type(clock), intent(out) :: now
    type(instance), pointer :: it
    real(c_double) :: e
    it => of(self)
    e = it%p(3) - y(1)
    if (iand(parts, sample_outputs) /= 0) u(1) = it%p(1)*e + it%s
    if (iand(parts, sample_states) /= 0) then
      it%s = it%s + it%p(2)*it%p(4)*e
      it%time = t
      it%instant = it%instant + 1
    end if
    now = clock_of(it)
    sample = ok
  end function

end module
