" shaderlint's language server for ALE: findings, hovers, definitions, references, renaming, fixes.
" This file goes to ~/.vim/ale_linters/glsl/.

call ale#linter#Define('glsl', {
\   'name': 'shaderlint',
\   'lsp': 'stdio',
\   'executable': 'shaderlint',
\   'command': '%e lsp',
\   'project_root': {buffer -> fnamemodify(bufname(buffer), ':p:h')},
\})
