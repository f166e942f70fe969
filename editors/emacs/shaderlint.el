;;; shaderlint.el --- shaderlint's language server for Eglot  -*- lexical-binding: t -*-

;; Load this file from init.el; M-x eglot in a buffer with a shader starts the server.  It goes by the
;; name of the mode: glsl-mode is a package of its own, and glsl-ts-mode another.

;;; Code:

(require 'eglot)

(add-to-list 'eglot-server-programs
             '((glsl-mode glsl-ts-mode) . ("shaderlint" "lsp")))

(provide 'shaderlint)
;;; shaderlint.el ends here
