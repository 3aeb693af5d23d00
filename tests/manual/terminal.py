# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A command typed at a terminal of its own by somebody who answers its questions."""

import os
import pty
import select
import signal
import time


def type_at_terminal(command, answers, folder, environment, limit_s=120):
    """Runs `command` by bash and answers each question that ends with ": ".

    answers: [(part of the question, what is typed)], the first that fits.
    Returns (exit status, all that stood on the screen). TimeoutError where it does not end.
    """
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(folder)
        os.execve("/bin/bash", ["bash", "-c", command], environment)
    screen, answered, end = b"", 0, time.monotonic() + limit_s
    try:
        while True:
            if time.monotonic() > end:
                os.kill(child, signal.SIGKILL)
                raise TimeoutError(f"{command}\n{screen.decode(errors='replace')}")
            if not select.select([terminal], [], [], 0.5)[0]:
                continue
            try:
                part = os.read(terminal, 65536)
            except OSError:  # The last process has closed the terminal.
                part = b""
            if not part:
                break
            screen += part
            question = screen[answered:].decode(errors="replace").splitlines()[-1:]
            if question and question[0].endswith(": "):
                for asked, typed in answers:
                    if asked in question[0]:
                        time.sleep(0.05)  # Echo is switched off around the question.
                        os.write(terminal, typed.encode() + b"\n")
                        answered = len(screen)
                        break
    finally:
        # In this order: a program may close its files before it ends, and would be hung up on.
        status = os.waitpid(child, 0)[1]
        os.close(terminal)
    return os.waitstatus_to_exitcode(status), screen.decode(errors="replace").replace("\r\n", "\n")
