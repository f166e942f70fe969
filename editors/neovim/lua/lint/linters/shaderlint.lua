-- shaderlint for nvim-lint. Copy this file to ~/.config/nvim/lua/lint/linters/, then
--
--   require('lint').linters_by_ft = { glsl = { 'shaderlint' } }
--   vim.api.nvim_create_autocmd({ 'BufEnter', 'InsertLeave', 'TextChanged' }, {
--     callback = function() require('lint').try_lint() end,
--   })
--
-- The contents of the buffer are checked, saved or not.

local severities = {
  error = vim.diagnostic.severity.ERROR,
  warning = vim.diagnostic.severity.WARN,
  info = vim.diagnostic.severity.INFO,
}

return {
  cmd = 'shaderlint',
  stdin = true,
  args = {
    '--format',
    'json',
    '--stdin-filename',
    function()
      return vim.api.nvim_buf_get_name(0)
    end,
    '-',
  },
  ignore_exitcode = true,
  parser = function(output, bufnr)
    if output == '' then
      return {}
    end
    -- Neovim counts columns in bytes from the start of the line.
    local function place(position)
      local line = vim.api.nvim_buf_get_lines(bufnr, position.line - 1, position.line, false)[1] or ''
      local ok, byte = pcall(vim.str_byteindex, line, position.column - 1)
      return position.line - 1, ok and byte or #line
    end
    local found = {}
    local name = vim.api.nvim_buf_get_name(bufnr)
    for _, finding in ipairs(vim.json.decode(output).diagnostics) do
      -- Findings in included files and in passes of exports have no position in this buffer.
      if finding.file == name and not finding.pass then
        local line, column = place(finding.start)
        local end_line, end_column = place(finding['end'])
        table.insert(found, {
          lnum = line,
          col = column,
          end_lnum = end_line,
          end_col = end_column,
          severity = severities[finding.severity],
          source = 'shaderlint',
          code = finding.rule,
          message = finding.message,
        })
      end
    end
    return found
  end,
}
