## Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause

## [message, result] = __tandem_call__ (f, ...): what f gives, or the message of its error, which is not empty.
function [message, result] = __tandem_call__ (f, varargin)
  message = "";
  result = [];
  try
    result = feval (f, varargin{:});
  catch failed
    message = failed.message;
    if (isempty (message))
      message = "an error without a message";
    endif
  end_try_catch
endfunction
