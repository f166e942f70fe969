" The shaderlint language server for ALE: findings, hovers, definitions, references, renaming, fixes.
" Copy this file to ~/.vim/ale_linters/glsl/.

call ale#linter#Define('glsl', {
\   'name': 'shaderlint',
\   'lsp': 'stdio',
\   'executable': 'shaderlint',
\   'command': '%e lsp',
\   'project_root': {buffer -> fnamemodify(bufname(buffer), ':p:h')},
\})
