## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## Speed governor in Octave: proportional and integral, sampled each h, held; its integral stays within the plate's range.
## Inputs set and N [rad/s]; output throttle [deg] (README.md).
1;

function model = make (p)
  model.name = "governor";
  model.inputs = {"set", "rad/s"; "N", "rad/s"};
  model.outputs = {"throttle", "deg"};
  model.feedthrough = [1, 1; 1, 2];
  model.sampled = true;
  model.h = p.h;
  model.start = @(t, u0) p.theta0;
  model.values = @(integral, u) throttle (p, integral, u);
  model.step = @(integral, t, t_end, h, u) step (p, integral, h, tandem_value (u(1), t) - tandem_value (u(2), t));
endfunction

## Of the integral alone before the first sample.
function theta = throttle (p, integral, u)
  if (isempty (u))
    u = [0, 0];
  endif
  theta = within (p.kp * (u(1) - u(2)) + integral);
endfunction

function integral = step (p, integral, h, error)
  integral = within (integral + p.ki * h * error);
endfunction

function theta = within (theta)
  theta = min (max (theta, 0), 50);
endfunction

parameters = {"kp", "deg s/rad", 0.0614, "proportional gain"
              "ki", "deg/rad", 0.0723, "integral gain"
              "theta0", "deg", 8.97, "throttle at the start"
              "h", "s", 0.01, "period"};
exit (tandem_serve (@make, parameters));
