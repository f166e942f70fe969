;;; shaderlint.el --- The shaderlint language server for Eglot  -*- lexical-binding: t -*-

;; Load this file from init.el; M-x eglot in a shader buffer starts the server.  It requires one of the
;; packages glsl-mode and glsl-ts-mode.

;;; Code:

(require 'eglot)

(add-to-list 'eglot-server-programs
             '((glsl-mode glsl-ts-mode) . ("shaderlint" "lsp")))

(provide 'shaderlint)
;;; shaderlint.el ends here
