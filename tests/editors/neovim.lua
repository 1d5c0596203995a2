-- The section "Neovim" of `www/docs/editors.md`: its code starts the server, which reports, repairs, renames and explains.
--
-- In: the documentation, and the server on PATH. Out: a line for each step; an error ends it with status 1.

local documentation = arg[1]

--- The code of the section.
local function snippet()
  local text = table.concat(vim.fn.readfile(documentation), '\n')
  local section = assert(text:match('\n## Neovim\n(.-)\n## '), 'no section "Neovim"')
  return assert(section:match('```lua\n(.-)```'), 'no code in the section "Neovim"')
end

local function text()
  return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')
end

local function codes()
  local found = {}
  for _, diagnostic in ipairs(vim.diagnostic.get(0)) do
    found[#found + 1] = tostring(diagnostic.code)
  end
  table.sort(found)
  return table.concat(found, ' ')
end

--- Waits for a condition, at most 20 s.
local function wait_for(what, condition)
  assert(vim.wait(20000, condition, 20), 'not in time: ' .. what .. '\n' .. codes() .. '\n' .. text())
  io.stdout:write(what .. '\n')
end

--- The answer of the server to a request at a line and a column, from 0.
local function ask(method, line, column, more)
  local params = vim.tbl_extend('force', {
    textDocument = vim.lsp.util.make_text_document_params(),
    position = { line = line, character = column },
  }, more or {})
  local answers = assert(vim.lsp.buf_request_sync(0, method, params, 20000), method)
  local _, answer = next(answers)
  return assert(answer and answer.result, method .. ': ' .. vim.inspect(answers))
end

local function main()
  local folder = vim.fn.tempname()
  vim.fn.mkdir(folder)
  local part = folder .. '/part.nc'
  -- O for 0 in `X3O`; P of M99 leads to N10.
  vim.fn.writefile({ 'O0001', 'N10 G00 X3O Z2', 'G01 U4 W-12 F0.2', '/M99 P10', 'm30' }, part)
  vim.fn.writefile({}, folder .. '/gcode-playground.toml')

  assert(load(snippet(), 'editors.md'))()
  vim.cmd.filetype('on')
  vim.cmd.edit(part)
  assert(vim.bo.filetype == 'gcode', 'file type ' .. vim.bo.filetype)
  wait_for('the server starts', function()
    return #vim.lsp.get_clients({ bufnr = 0 }) == 1
  end)
  wait_for('a message: the letter O in a number', function()
    return codes():find('E-OCR', 1, true) ~= nil
  end)

  vim.lsp.buf.code_action({
    context = { only = { 'source.fixAll' }, diagnostics = {} },
    apply = true,
  })
  wait_for('all safe fixes', function()
    return text():find('G00 X30 Z2', 1, true) ~= nil
  end)
  wait_for('the message is gone', function()
    return codes():find('E-OCR', 1, true) == nil
  end)

  vim.api.nvim_win_set_cursor(0, { 2, 1 })
  vim.lsp.buf.rename('20')
  wait_for('rename: N10 and P10', function()
    return text():find('N20 G00', 1, true) ~= nil and text():find('M99 P20', 1, true) ~= nil
  end)

  vim.lsp.buf.format({ async = false })
  wait_for('formatting: M30', function()
    return text():find('M30', 1, true) ~= nil
  end)

  local hover = ask('textDocument/hover', 2, 5)
  assert(vim.inspect(hover.contents):find('34', 1, true), 'hover of U4: ' .. vim.inspect(hover))
  io.stdout:write('hover of U4 names X34' .. '\n')

  local whole = {
    range = { start = { line = 0, character = 0 }, ['end'] = { line = 5, character = 0 } },
  }
  local hints = ask('textDocument/inlayHint', 0, 0, whole)
  local labels = {}
  for _, hint in ipairs(hints) do
    labels[#labels + 1] = hint.label
  end
  assert(table.concat(labels, ' ') == 'X34 Z-10', 'hints: ' .. vim.inspect(hints))
  io.stdout:write('hints: X34 Z-10' .. '\n')

  assert(#ask('textDocument/semanticTokens/full', 0, 0).data > 0, 'no tokens')
  io.stdout:write('tokens' .. '\n')
  for _, client in ipairs(vim.lsp.get_clients()) do
    client:stop()
  end
  wait_for('the server ends', function()
    return #vim.lsp.get_clients() == 0
  end)
end

local is_passed, message = xpcall(main, debug.traceback)
if not is_passed then
  io.stderr:write(message .. '\n')
  os.exit(1)
end
