;;; shaderlint-dap.el --- The debugger of shaderlint in dap-mode  -*- lexical-binding: t; -*-

;; Copy this file to ~/.emacs.d/, install dap-mode, and add (load "~/.emacs.d/shaderlint-dap.el") to init.el.
;; `M-x dap-debug RET Shaderlint RET' debugs the centre of the current shader; `M-x dap-debug-edit-template'
;; changes the pixel, time and size.

;;; Code:

(require 'dap-mode)

(dap-register-debug-provider
 "shaderlint"
 (lambda (conf)
   (dap--put-if-absent conf :dap-server-path '("shaderlint" "dap"))
   (dap--put-if-absent conf :program (buffer-file-name))
   (dap--put-if-absent conf :name "Shader")
   conf))

(dap-register-debug-template
 "Shaderlint"
 (list :type "shaderlint" :request "launch" :name "Shader" :size [320 180] :pixel [160 90] :time 0))

(defun shaderlint-dap--request (command)
  "Send COMMAND for the thread that is shown."
  (let ((session (dap--cur-session-or-die)))
    (dap--send-message
     (dap--make-request command (list :threadId (dap--debug-session-thread-id session)))
     (dap--resp-handler)
     session)))

(defun shaderlint-dap-step-back ()
  "Step back over calls."
  (interactive)
  (shaderlint-dap--request "stepBack"))

(defun shaderlint-dap-reverse-continue ()
  "Run back to the last breakpoint."
  (interactive)
  (shaderlint-dap--request "reverseContinue"))

(defun shaderlint-dap-step-back-in ()
  "Step back, also into calls."
  (interactive)
  (shaderlint-dap--request "shaderlint/stepBackIn"))

(defun shaderlint-dap-next-iteration ()
  "Run to the next iteration of the loop."
  (interactive)
  (shaderlint-dap--request "shaderlint/nextIteration"))

;;; shaderlint-dap.el ends here
