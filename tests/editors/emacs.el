;;; emacs.el --- The section "Emacs" of `www/docs/editors.md`  -*- lexical-binding: t -*-

;; Its code starts the server, which reports, repairs, renames and explains.
;;
;; In: the documentation as the argument, and the server on PATH.  Out: a line for each step; an error ends Emacs with
;; a status that is not 0.

(require 'package)
(package-initialize)
(require 'cl-lib)
(require 'eglot)
(require 'flymake)

(defun playground-snippet (documentation)
  "The code of the section in the file DOCUMENTATION."
  (with-temp-buffer
    (insert-file-contents documentation)
    (search-forward "\n## Emacs\n")
    (search-forward "```elisp\n")
    (let ((start (point)))
      (search-forward "```")
      (buffer-substring start (- (point) 3)))))

(defun playground-wait (what condition)
  "Wait at most 20 s until CONDITION holds; WHAT names it."
  (let ((end (+ (float-time) 20)))
    (while (not (funcall condition))
      (when (> (float-time) end)
        (error "Not in time: %s\n%s\n%s" what (flymake-diagnostics) (buffer-string)))
      (accept-process-output nil 0.05)))
  (message "%s" what))

(defun playground-has (text)
  "Whether the buffer contains TEXT."
  (save-excursion
    (goto-char (point-min))
    (search-forward text nil t)))

(defun playground-is-reported (text)
  "Whether a message contains TEXT."
  (cl-some (lambda (found) (string-match-p (regexp-quote text) (flymake-diagnostic-text found)))
           (flymake-diagnostics)))

(defun playground-ask (method)
  "The answer of the server to METHOD at point."
  (jsonrpc-request (eglot--current-server-or-lose) method (eglot--TextDocumentPositionParams)))

(defun playground-test (documentation)
  "Follow the section of DOCUMENTATION."
  (let* ((folder (make-temp-file "playground" t))
         (part (expand-file-name "part.nc" folder))
         ;; A project, so that Eglot has a root.
         (default-directory folder))
    (with-temp-file part
      (insert "O0001\nN10 G00 X3O Z2\nG01 U4 W-12 F0.2\n/M99 P10\nM30\n"))
    (eval (car (read-from-string (format "(progn %s)" (playground-snippet documentation)))) t)
    (find-file part)
    (cl-assert (eq major-mode 'gcode-mode))
    ;; `eglot-ensure' starts the server after the next command of the user.
    (run-hooks 'post-command-hook)
    (playground-wait "the server starts" #'eglot-current-server)
    (flymake-start)
    (playground-wait "a message: the letter O in a number"
                     (lambda () (playground-is-reported "X3O")))

    (goto-char (point-min))
    (search-forward "X3")
    (cl-letf (((symbol-function 'completing-read) (lambda (_ actions &rest _) (caar actions))))
      (eglot-code-actions (line-beginning-position) (line-end-position) "quickfix" t))
    (playground-wait "the fix of the message" (lambda () (playground-has "G00 X30 Z2")))
    (playground-wait "the message is gone" (lambda () (not (playground-is-reported "X30"))))

    ;; Eglot sends a change when the user is idle, which a batch never is.
    (eglot--signal-textDocument/didChange)
    (goto-char (point-min))
    (search-forward "N1")
    (eglot-rename "20")
    (playground-wait "rename: N10 and P10"
                     (lambda () (and (playground-has "N20 G00") (playground-has "M99 P20"))))

    (goto-char (point-min))
    (search-forward "U")
    (let ((hover (format "%s" (playground-ask :textDocument/hover))))
      (unless (string-match-p "34" hover) (error "Hover of U4: %s" hover))
      (message "hover of U4 names X34"))
    (eglot-shutdown (eglot-current-server))
    (message "the server ends")))

(playground-test (expand-file-name (pop command-line-args-left)))
(kill-emacs 0)
