;; Tests editors/emacs/shaderlint-dap.el: dap-mode starts the debugger, steps, and stops at a breakpoint.
;; The working folder gets the shader and the files of dap-mode.

(setq user-emacs-directory (expand-file-name "emacs/"))
(make-directory user-emacs-directory t)
(setq lsp-session-file (expand-file-name "session" user-emacs-directory)
      dap-breakpoints-file (expand-file-name "breakpoints" user-emacs-directory))
(load (getenv "SHADERLINT_DAP") nil t)
(setq dap-auto-configure-features nil)

(with-temp-file "ball.glsl"
  (insert "float field(vec3 p) {
    float ball = length(p) - 1.0;
    return ball;
}

void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    float total = 0.0;
    for (int i = 0; i < 3; i++) {
        total += field(vec3(0.0, 0.0, 3.0));
    }
    fragColor = vec4(vec3(total), 1.0);
}
"))

(defun wait-for (what)
  "Wait until the function WHAT returns something; return it."
  (let ((end (+ (float-time) 100)) found)
    (while (not (setq found (funcall what)))
      (when (> (float-time) end)
        (message "no answer of the debugger")
        (kill-emacs 1))
      (accept-process-output nil 0.02))
    found))

(defun stopped-at ()
  "The function and the line of the frame that is shown."
  (when-let* ((session (dap--cur-session))
              (frame (dap--debug-session-active-frame session)))
    (format "%s %s" (gethash "name" frame) (gethash "line" frame))))

(defun expect (place action &rest arguments)
  "Call ACTION with ARGUMENTS, and wait until the debugger is stopped at PLACE."
  (apply action arguments)
  (let ((end (+ (float-time) 100)))
    (while (not (equal (stopped-at) place))
      (when (> (float-time) end)
        (message "stopped at %s instead of %s" (stopped-at) place)
        (kill-emacs 1))
      (accept-process-output nil 0.02)))
  (message "%s: %s" action place))

(defun value (expression)
  "The value of EXPRESSION."
  (let (answer)
    (dap--send-message
     (dap--make-request "evaluate" (list :expression expression
                                         :frameId (gethash "id" (dap--debug-session-active-frame (dap--cur-session)))))
     (lambda (response) (setq answer (gethash "result" (gethash "body" response))))
     (dap--cur-session))
    (wait-for (lambda () answer))))

(find-file "ball.glsl")
(expect "mainImage 7" #'dap-debug (list :type "shaderlint" :request "launch" :size [32 18]))
(let ((session (dap--cur-session)))
  (expect "mainImage 8" #'dap-next session)
  (with-current-buffer "ball.glsl"
    (goto-char (point-min))
    (search-forward "return ball")
    (dap-breakpoint-toggle))
  (expect "field 3" #'dap-continue session (dap--debug-session-thread-id session))
  (unless (equal (value "ball * 2.0") "4.0")
    (message "ball is %s" (value "ball"))
    (kill-emacs 1))
  (expect "mainImage 9" #'dap-step-out session)
  (expect "field 3" #'shaderlint-dap-step-back-in)
  (expect "field 2" #'shaderlint-dap-step-back)
  (dap-disconnect session))
(message "dap-mode: ok")
