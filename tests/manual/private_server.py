# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A PostgreSQL of a test's own, and the commands of an administrator that lead to it."""

import ctypes
import os
import pwd
import shlex
import signal
import socket
import subprocess
import threading
import time
from pathlib import Path

PR_SET_PDEATHSIG = 1
UNITS = Path(__file__).resolve().parents[2] / "packaging"


def programs_of_postgresql():
    """Folder with initdb and postgres, None where there is none."""
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"))
    return found[-1].parent if found else None


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class PrivateServer:
    """Its socket lets the system's user in, as on Debian; from the network nobody comes in.

    data: its folder, with pg_hba.conf. commands: a folder for PATH with `sudo` and `systemctl`.
    """

    def __init__(self, folder):
        self.folder, self.data = folder, folder / "data"
        self.commands = folder / "commands"
        self.port = free_port()
        folder.mkdir()
        self.commands.mkdir()
        self._give_away(folder)
        self._run([programs_of_postgresql() / "initdb", "-D", self.data, "-U", "postgres", "-A", "trust",
                   "-E", "UTF8", "--no-locale", "--no-sync"])
        (self.data / "pg_hba.conf").write_text("local all all trust\n")
        with (self.data / "postgresql.conf").open("a") as settings:
            settings.write(f"port = {self.port}\nfsync = off\nunix_socket_directories = '{folder}'\n"
                           "listen_addresses = ''\n")
        self._write_commands()
        self._ends = threading.Event()
        # The server dies with the thread that started it, so one thread starts it each time.
        self._keeper = threading.Thread(target=self._keep, daemon=True)
        self._keeper.start()
        if not self.waits_for("SELECT true"):
            raise RuntimeError("the server did not start:\n" + (folder / "log").read_text())

    def stop(self):
        self._ends.set()
        self._keeper.join()

    def waits_for(self, query, limit_s=30):
        """Whether the query's value becomes true in this time."""
        end = time.monotonic() + limit_s
        while time.monotonic() < end:
            asked = subprocess.run(["psql", "-h", self.folder, "-p", str(self.port), "-U", "postgres", "-tAc",
                                    query, "postgres"], capture_output=True, text=True, check=False)
            if asked.stdout.strip() == "t":
                return True
            time.sleep(0.1)
        return False

    def _keep(self):
        """Starts the server, and again each time that `systemctl restart` asks for it."""
        asked, done = self.folder / "restart", self.folder / "restarted"
        process = self._start()
        while not self._ends.wait(0.05):
            if asked.exists():
                process.send_signal(signal.SIGINT)
                process.wait()
                process = self._start()
                asked.unlink()
                if self.waits_for("SELECT true"):
                    done.touch()
        process.send_signal(signal.SIGQUIT)  # At once: the data is thrown away.
        process.wait()

    def _start(self):
        with (self.folder / "log").open("a") as log:
            return subprocess.Popen([programs_of_postgresql() / "postgres", "-D", self.data], cwd="/",
                                    stdin=subprocess.DEVNULL, stdout=log, stderr=log, preexec_fn=self._become)

    def _write_commands(self):
        root = os.geteuid() == 0
        become = "setpriv --reuid=postgres --regid=postgres --init-groups " if root else ""
        postgres = (f"exec {become}env -u PGHOSTADDR PGHOST={shlex.quote(str(self.folder))} "
                    f"PGPORT={self.port} PGUSER=postgres ")
        texts = {
            # Who is not root runs the server as himself, and gives it no files.
            "sudo": f'if [ "$1 $2" = "-u postgres" ]; then shift 2; cd /; {postgres}"$@"; fi\n'
                    '[ "$1 $2" != "install --owner" ] || [ "$(id -u)" = 0 ] || exec install "${@:4}"\nexec "$@"\n',
            # A timer is not waited for; it has to be one that the package brings.
            "systemctl": f'[ "$1 $2" != "enable --now" ] || exec test -e {shlex.quote(str(UNITS))}/"$3"\n'
                         f'[ "$*" = "restart postgresql" ] || exit 1\ncd {shlex.quote(str(self.folder))}\n'
                         "rm -f restarted; touch restart\n"
                         "for _ in $(seq 300); do [ -e restarted ] && exit 0; sleep 0.1; done; exit 1\n",
        }
        for name, text in texts.items():
            (self.commands / name).write_text("#!/bin/bash\n" + text)
            (self.commands / name).chmod(0o755)

    # PostgreSQL refuses to run as root.

    def _give_away(self, path):
        if os.geteuid() == 0:
            user = pwd.getpwnam("postgres")
            os.chown(path, user.pw_uid, user.pw_gid)

    def _become(self):
        if os.geteuid() == 0:
            user = pwd.getpwnam("postgres")
            os.setgid(user.pw_gid)
            os.setuid(user.pw_uid)
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGQUIT)

    def _run(self, command):
        subprocess.run(command, cwd="/", check=True, stdout=subprocess.DEVNULL, preexec_fn=self._become)
