" shaderlint for :make. Copy this file to ~/.vim/compiler (Neovim: ~/.config/nvim/compiler), then
"
"   autocmd FileType glsl compiler shaderlint
"   :make       checks the file; :copen lists the findings
"   :make %:h   also checks its folder
if exists('current_compiler')
  finish
endif
let current_compiler = 'shaderlint'

if exists(':CompilerSet') != 2
  command -nargs=* CompilerSet setlocal <args>
endif

CompilerSet makeprg=shaderlint\ --info\ --format\ short\ %:S\ $*
CompilerSet errorformat=%f:%l:%c:\ %trror[%*[^]]]:\ %m
CompilerSet errorformat+=%f:%l:%c:\ %tarning[%*[^]]]:\ %m
CompilerSet errorformat+=%f:%l:%c:\ %tnfo[%*[^]]]:\ %m
CompilerSet errorformat+=%-Gshaderlint:\ %.%#

" shaderlint counts columns in characters, and Vim in bytes. Where 'encoding' is not UTF-8, a buffer has the
" bytes of its file, unless 'fileencoding' says that they were converted.
function! s:Byte(buffer, line, characters) abort
  let l:is_converted = index(['', &encoding], getbufvar(a:buffer, '&fileencoding')) < 0
  if &encoding ==# 'utf-8' || l:is_converted
    return byteidx(a:line, a:characters)
  endif
  return matchend(a:line, '\m^\%([^\x80-\xbf][\x80-\xbf]*\)\{' . a:characters . '}')
endfunction

function! s:CountBytes() abort
  if getbufvar('%', 'current_compiler', get(g:, 'current_compiler', '')) !=# 'shaderlint'
    return
  endif
  let l:list = getqflist()
  for l:item in l:list
    if l:item.valid && l:item.col > 1 && l:item.bufnr > 0
      call bufload(l:item.bufnr)
      let l:line = get(getbufline(l:item.bufnr, l:item.lnum), 0, '')
      let l:byte = s:Byte(l:item.bufnr, l:line, l:item.col - 1)
      let l:item.col = l:byte >= 0 ? l:byte + 1 : l:item.col
    endif
  endfor
  call setqflist(l:list, 'r')
endfunction

augroup shaderlint
  autocmd!
  autocmd QuickFixCmdPost make call s:CountBytes()
augroup END
