-- shaderlint's language server for Neovim.
--
-- From Neovim 0.11 on, this file goes to ~/.config/nvim/lsp/, and
--
--   vim.lsp.enable('shaderlint')
--
-- into init.lua. Before, call vim.lsp.start (0.8) or vim.lsp.start_client (0.7) with the table.
-- `settings` may say { shaderlint = { run = false, hints = { types = true } } }; editors/README.md
-- lists what can be set.

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
