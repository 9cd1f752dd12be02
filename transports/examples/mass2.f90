! Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
! Mass 2 of the two-mass test in Fortran 2008, as a shared library, with the types of transports/fortran/tandem.f90.
!   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
! Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one. The functions of the table have no name for
! the linker (name=''): `advance` would be that of the C library.
module mass2_subsystem
  use, intrinsic :: iso_c_binding
  use tandem
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
  implicit none
  private

  type :: instance
    real(c_double) :: p(6) ! in the order of `parameters`
    real(c_double) :: x, v, a, t_start, time, next
    integer(c_int64_t) :: node ! number of the node `next`
    logical :: cut
    character(kind=c_char, len=200) :: error
  end type

  character(kind=c_char, len=8), target, save :: texts(5) = [character(kind=c_char, len=8) :: &
    'mass2'//c_null_char, 'x1'//c_null_char, 'x2'//c_null_char, 'v2'//c_null_char, 'm'//c_null_char]
  character(kind=c_char, len=4), target, save :: speed = 'm/s'//c_null_char
  ! of each parameter name, unit, what stands otherwise, and what it is
  character(kind=c_char, len=40), target, save :: told(4, 6) = reshape([character(kind=c_char, len=40) :: &
    'm', 'kg', '', 'mass', &
    'k', 'N/m', '', 'stiffness of the spring to mass 1', &
    's', 'N/m', '', 'stiffness of both springs together', &
    'x', 'm', '', 'position at the start', &
    'v', 'm/s', '', 'speed at the start', &
    'h', 's', '', 'own step'], [4, 6])
  type(declaration), target, save :: parameters(6)
  type(port), target, save :: inputs(1), outputs(2)
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
    inputs(1) = port(c_loc(texts(2)), c_loc(texts(5)), 1, 0, none)
    outputs(1) = port(c_loc(texts(3)), c_loc(texts(5)), 1, 2, none)
    outputs(2) = port(c_loc(texts(4)), c_loc(speed), 1, 1, none)
    the_info = info(c_loc(texts(1)), ior(lands, restarts), 1, 2, 0, c_loc(inputs), c_loc(outputs), c_null_ptr)
    the_table = table(table_size=int(c_sizeof(the_table), c_int32_t), create=c_funloc(create), &
      destroy=c_funloc(destroy), info=c_funloc(get_info), last_error=c_funloc(last_error), &
      initialize=c_funloc(initialize), advance=c_funloc(advance), parameters=c_funloc(get_parameters))
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
    if (create == ok .and. .not. (it%p(1) > 0 .and. it%p(6) > 0)) create = refuse(it, 'm and h have to be above 0')
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

  ! Width within which two times are the same, as subsystem.h says.
  real(c_double) function width(it, a, b)
    type(instance), intent(in) :: it
    real(c_double), intent(in) :: a, b
    width = 6*epsilon(a)*max(max(abs(a), abs(b)), abs(it%t_start))
  end function

  subroutine append(it, y)
    type(instance), intent(in) :: it
    type(samples), intent(inout) :: y
    real(c_double), pointer :: rows(:, :)
    call c_f_pointer(y%rows, rows, [y%stride, y%capacity])
    y%size = y%size + 1
    rows(:, y%size) = [it%time, 0d0, it%x, it%v, it%v, it%a, it%a, 0d0]
  end subroutine

  subroutine step(it, end, u)
    type(instance), intent(inout) :: it
    real(c_double), intent(in) :: end
    type(signal), intent(in) :: u
    real(c_double) :: h, before, push
    associate (m => it%p(1), k => it%p(2), stiffness => it%p(3))
      h = merge(it%p(6), end - it%time, end == it%next .and. .not. it%cut)
      before = (k*input_at(u, it%time) - stiffness*it%x)/m
      push = k*input_at(u, end)
      it%x = (it%x + h*it%v + 0.25d0*h*h*(before + push/m))/(1 + 0.25d0*h*h*stiffness/m)
      it%a = (push - stiffness*it%x)/m
      it%v = it%v + 0.5d0*h*(before + it%a)
      it%time = end
    end associate
  end subroutine

  integer(c_int) function initialize(self, t_start, t_stop, u0, y, now) bind(c, name='')
    type(c_ptr), value :: self
    real(c_double), value :: t_start, t_stop
    real(c_double), intent(in) :: u0(1)
    type(samples), intent(inout) :: y
    type(clock), intent(out) :: now
    type(instance), pointer :: it
    it => of(self)
    it%x = it%p(4)
    it%v = it%p(5)
    it%a = (it%p(2)*u0(1) - it%p(3)*it%x)/it%p(1)
    it%t_start = t_start
    it%time = t_start
    it%node = 1
    it%next = t_start + it%p(6)
    it%cut = .false.
    call append(it, y)
    now = clock(it%time, it%next, stop_limit, 0)
    initialize = ok
    if (.not. t_stop > t_start) initialize = refuse(it, 't_stop has to be after t_start')
  end function

  integer(c_int) function advance(self, t_limit, land, u, y, now) bind(c, name='')
    type(c_ptr), value :: self
    real(c_double), value :: t_limit
    integer(c_int32_t), value :: land
    type(signal), intent(in) :: u(1)
    type(samples), intent(inout) :: y
    type(clock), intent(out) :: now
    type(instance), pointer :: it
    it => of(self)
    advance = ok
    do while (y%size < y%capacity)
      if (it%next <= t_limit + width(it, it%next, t_limit)) then
        call step(it, it%next, u(1))
        it%node = it%node + 1
        it%next = it%t_start + it%node*it%p(6) ! multiplied, never accumulated
        it%cut = .false.
      else if (land /= 0 .and. it%time < t_limit - width(it, it%time, t_limit)) then
        call step(it, t_limit, u(1))
        it%cut = .true.
      else
        now = clock(it%time, it%next, stop_limit, 0)
        return
      end if
      call append(it, y)
    end do
    now = clock(it%time, it%next, stop_samples_full, 0)
  end function

end module
