-- The shaderlint language server for Neovim.
--
-- With Neovim 0.11 or newer, copy this file to ~/.config/nvim/lsp/, and add
--
--   vim.lsp.enable('shaderlint')
--
-- to init.lua. With older versions, call vim.lsp.start (0.8) or vim.lsp.start_client (0.7) with the table.
-- `settings` may contain { shaderlint = { run = false, hints = { types = true } } }; editors/README.md
-- lists all settings.

return {
  cmd = { 'shaderlint', 'lsp' },
  filetypes = {
    'glsl',
    'html',
    'javascript',
    'javascriptreact',
    'typescript',
    'typescriptreact',
    'vue',
    'svelte',
    'astro',
    'markdown',
  },
  root_markers = { 'shaderlint.toml', '.git' },
}
