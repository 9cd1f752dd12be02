## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
## Speed governor in Octave: proportional and integral, sampled each h; its integral stays within the plate's range.
## Inputs set and N [rad/s]; output throttle [deg]. Parameters kp [deg s/rad], ki [deg/rad], theta0 [deg], h [s]
## (README.md).
1;

function model = make (parameters)
  p = struct ("kp", 0.0614, "ki", 0.0723, "theta0", 8.97, "h", 0.01);
  for [text, key] = parameters
    if (! isfield (p, key) || isnan (str2double (text)))
      error ("governor: '%s=%s'; allowed are kp, ki, theta0 and h, numbers", key, text);
    endif
    p.(key) = str2double (text);
  endfor
  model.name = "governor";
  model.inputs = {"set", "rad/s"; "N", "rad/s"};
  model.outputs = {"throttle", "deg"};
  model.feedthrough = [1, 1; 1, 2];
  model.h = p.h;
  model.start = @(t, u0) struct ("integral", p.theta0, "error", u0(1) - u0(2));
  model.step = @(state, t, t_end, h, u) sample (p, state, h, tandem_value (u(1), t_end) - tandem_value (u(2), t_end));
  model.values = @(state) min (max (p.kp * state.error + state.integral, 0), 50);
endfunction

function state = sample (p, state, h, error)
  state.integral = min (max (state.integral + p.ki * h * error, 0), 50);
  state.error = error;
endfunction

exit (tandem_serve (@make));
