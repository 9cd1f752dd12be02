% Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
% Two uniform rods of 1 m and 1 kg, the first hinged at the origin, the second to its end; let go level. The
% variables are the coordinates of the end of the first, the elbow, and of the second, the tip.
function model = double_pendulum ()
  model.variables = {"elbow_x", "elbow_y", "tip_x", "tip_y"};
  model.q = [1; 0; 2; 0];
  model.v = zeros (4, 1);
  model.mass = @mass;
  model.constraints = @constraints;
  model.jacobian = @jacobian;
  model.constraint_accelerations = @constraint_accelerations;
  model.forces = @forces;
  model.energy = @energy;
end

function m = mass ()
  m = [2/3, 1/6; 1/6, 1/3];  % of a uniform rod between two points: 1/6 [2 1; 1 2]
  m = kron (m, eye (2));
end

function phi = constraints (t, q)
  x = q(3) - q(1);
  y = q(4) - q(2);
  phi = [q(1) * q(1) + q(2) * q(2) - 1; x * x + y * y - 1];
end

function phi_q = jacobian (t, q)
  x = q(3) - q(1);
  y = q(4) - q(2);
  phi_q = [2 * q(1), 2 * q(2), 0, 0; -2 * x, -2 * y, 2 * x, 2 * y];
end

function gamma = constraint_accelerations (t, q, v)
  x = v(3) - v(1);
  y = v(4) - v(2);
  gamma = [2 * (v(1) * v(1) + v(2) * v(2)); 2 * (x * x + y * y)];
end

function force = forces (t, q, v)
  force = -9.81 * [0; 1; 0; 0.5];
end

function e = energy (t, q, v)
  e = 0.5 * v' * mass () * v + 9.81 * (q(2) + 0.5 * q(4));
end
