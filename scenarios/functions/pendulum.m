% A mass of 2 kg on a rod of 0.5 m about the origin, in still air; let go level. Variables: its place.
function model = pendulum ()
  model.variables = {"x", "y"};
  model.q = [0.5; 0];                                  % where it starts [m]
  model.v = [0; 0];                                    % [m/s]
  model.mass = @() 2 * eye (2);                        % M [kg]
  model.constraints = @(t, q) q' * q - 0.5^2;          % Phi(t, q) = 0
  model.jacobian = @(t, q) 2 * q';                     % dPhi/dq: a row for each constraint
  model.constraint_accelerations = @(t, q, v) 2 * (v' * v);  % Phi'' without what holds q''
  model.forces = @air;                                 % Q(t, q, q') [N]
end

function force = air (t, q, v)
  force = [0; -2 * 9.81] - 0.4 * norm (v) * v;
end
