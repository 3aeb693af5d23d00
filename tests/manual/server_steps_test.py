# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/manual/*/admin-server.md does what it says: every command of it is typed as it stands, at a
terminal, in the order of the page, and its questions are answered there.

Only what belongs to one computer is another: the port, three folders, and `sudo` and `systemctl`,
which lead to a PostgreSQL of this test; and SHARED and its way back, which need users of this computer,
are those of shared_station_test. That server has no way in but its own socket until the page
opens one. The station is this computer under the server's name (PGHOSTADDR)."""

import os
import re
import secrets
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

from private_server import PrivateServer, programs_of_postgresql
from terminal import type_at_terminal

SOURCE = Path(__file__).resolve().parents[2]
BIN = Path(os.environ["PLACODE_BIN_DIR"])
OWNER, STATION, ADA, NIGHT_JOB = (secrets.token_hex(8) for _ in range(4))
# What is asked, and what is typed then.
ANSWERS = [
    ("Password for postgresql://placode_owner", OWNER),
    ("Password of ada", ADA),
    ("New password of night", NIGHT_JOB),
]
SERVER, ENCRYPT, TABLES, STATIONS, SHARED, MOVE, BACK, COPY, NIGHT = range(9)


def commands_of(language):
    """The commands of each section of the page, in its order; sections are SERVER to NIGHT."""
    text = (SOURCE / "docs/manual" / language / "admin-server.md").read_text()
    return [re.findall(r"^ {4,}(\S.*)$", part, re.M) for part in re.split(r"^## ", text, flags=re.M)[1:]]


class ServerSteps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if programs_of_postgresql() is None:
            raise unittest.SkipTest("PostgreSQL's server is not installed")
        cls.folder = tempfile.TemporaryDirectory(prefix="placode-manual-")
        cls.addClassCleanup(cls.folder.cleanup)
        top = Path(cls.folder.name)
        top.chmod(0o755)  # PostgreSQL runs as another user where the test is root.
        cls.home = top / "home"
        cls.home.mkdir(mode=0o700)
        cls.server = PrivateServer(top / "server")
        cls.addClassCleanup(cls.server.stop)
        cls.pages = commands_of("en")

    def setUp(self):
        self.environment = {
            "HOME": str(self.home),
            "PATH": f"{self.server.commands}:{BIN}:/usr/bin:/bin",
            "LC_ALL": "C.UTF-8",
            "TERM": "dumb",
            "PAGER": "cat",
            "XDG_RUNTIME_DIR": str(self.home),
            "PLACODE_STATION_KEY": str(self.home / "station.key"),
            "PGHOSTADDR": "127.0.0.1",  # who db.example.org is
            "QT_QPA_PLATFORM": "offscreen",
        }

    def here(self, command):
        """The command with the port and the folders of this test."""
        for written, ours in [
            ("db.example.org:5432", f"db.example.org:{self.server.port}"),
            ("/etc/postgresql/15/main", str(self.server.data)),
            ("/var/lib/postgresql", str(self.server.folder)),
            ("/home/ada", str(self.home)),
            ("/etc/placode", str(self.home / "etc")),
        ]:
            command = command.replace(written, ours)
        return command

    def type(self, command, **environment):
        made = OWNER if "placode_owner" in command else STATION
        answers = [("new role", made), ("Enter it again", made)] + ANSWERS
        return type_at_terminal(self.here(command), answers, self.home, self.environment | environment)

    def do(self, commands):
        """Types them all; what they printed."""
        said = ""
        for command in commands:
            with self.subTest(command=command):
                status, text = self.type(command)
                self.assertEqual(status, 0, text)
                for password in (OWNER, STATION, ADA, NIGHT_JOB):
                    self.assertNotIn(password, text)
                said += text
        return said

    def station(self, *, user="theatre_1", words="check", tail="", **environment):
        """Placode's own program at the station."""
        address = f"postgresql://{user}@db.example.org:5432/placode{tail}"
        return self.type(f"placodectl --store '{address}' --as ada {words}", **environment)

    def test_the_page_from_its_first_step_to_its_last(self):
        self.prepare_the_file()
        self.do(self.pages[SERVER])
        self.nobody_comes_in_from_the_network()
        self.do(self.pages[ENCRYPT])
        self.trust_the_certificate()
        self.do(self.pages[TABLES])
        self.keep_the_stations_password()
        self.move()
        self.use_the_stations()
        self.only_the_right_ones_come_in()
        self.a_station_cannot_change_scores()
        self.copy_and_get_it_back()
        self.simulate_at_night()
        self.move_back()

    def test_both_languages_have_the_same_commands(self):
        self.assertEqual(commands_of("pl"), self.pages)
        self.assertEqual([len(section) > 0 for section in self.pages], [True] * 9)

    def prepare_the_file(self):
        """The store that will move: an administrator and an attempt."""
        for command in [
            "placodectl user add ada --role administrator --role trainee",
            "placode-sim --task diathermy_ring_small --headless --fast --duration 0.3 --device "
            "script:expert --record a.placode",
            "placodectl import --user ada a.placode",
        ]:
            status, text = self.type(command, PLACODE_NEW_PASSWORD=ADA)
            self.assertEqual(status, 0, text)

    def nobody_comes_in_from_the_network(self):
        status, text = self.type(f"psql -w -c 'SELECT 1' {self.address('placode_owner', 'disable')}",
                                 PGPASSWORD=OWNER)
        self.assertNotEqual(status, 0, text)

    def address(self, user, mode):
        return f"'host=db.example.org port={self.server.port} dbname=placode user={user} sslmode={mode}'"

    def trust_the_certificate(self):
        """Step 2 of a station; the copy from the server to it is the administrator's."""
        refused, said = self.type(self.pages[TABLES][0])
        self.assertEqual(refused, 1, said)
        self.assertIn("has to prove who it is", said)
        (self.home / "placode.crt").write_bytes((self.server.data / "placode.crt").read_bytes())
        self.do(self.pages[STATIONS][:2])

    def keep_the_stations_password(self):
        """Step 3 of a station: the line as the page's text has it."""
        text = (SOURCE / "docs/manual/en/admin-server.md").read_text()
        line = re.search(r"in a line\s+`([^`]*:)` and then the password", text).group(1)
        (self.home / ".pgpass").write_text(self.here(line) + STATION + "\n")
        self.do([self.pages[STATIONS][2]])

    def move(self):
        before = self.contents("")
        said = self.do(self.pages[MOVE])
        self.assertIn("which is free", said)
        self.assertTrue((self.home / "before-the-move.db").exists())
        status, text = self.type("placodectl user list")
        self.assertEqual(status, 1)
        self.assertIn("the store was moved to postgresql://placode_owner@db.example.org", text)
        self.assertEqual(self.contents("--store postgresql://theatre_1@db.example.org:5432/placode --as ada "),
                         before)

    def contents(self, store):
        said = ""
        for what in ("user list", "attempts"):
            status, text = self.type(f"placodectl {store}{what} --json")
            self.assertEqual(status, 0, text)
            said += re.sub(r"Password [^\n]*\n", "", text)
        self.assertIn("diathermy_ring_small", said)
        return said

    def use_the_stations(self):
        """Step 4 and the check. The window stays open: it is closed when it has reached the store."""
        window, check = self.pages[STATIONS][3:]
        program = subprocess.Popen(["bash", "-c", "exec " + self.here(window)], cwd=self.home,
                                   env=self.environment, stdin=subprocess.DEVNULL)
        try:
            self.assertTrue(self.server.waits_for(
                "SELECT count(*) > 0 FROM pg_stat_activity JOIN pg_stat_ssl USING (pid) "
                "WHERE usename = 'theatre_1' AND ssl"), "the window has no encrypted connection")
        finally:
            program.send_signal(signal.SIGTERM)
            program.wait(30)
        self.do([check])

    def only_the_right_ones_come_in(self):
        # The same server by another name than that of its certificate, or with another certificate.
        status, text = self.type(f"placodectl --store postgresql://theatre_1@127.0.0.2:{self.server.port}"
                                 "/placode?sslmode=verify-full --as ada check", PGPASSWORD=STATION)
        self.assertEqual(status, 1, text)
        self.assertIn("does not match host name", text)
        other = self.home / "other.crt"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256",
                        "-nodes", "-subj", "/CN=db.example.org", "-keyout", str(self.home / "other.key"),
                        "-out", str(other)], check=True, stderr=subprocess.DEVNULL)
        status, text = self.station(tail=f"?sslrootcert={other}")
        self.assertEqual(status, 1, text)
        self.assertIn("certificate verify failed", text)
        self.assertEqual(self.station(tail=f"?sslrootcert={self.home}/placode.crt")[0], 0)
        # Never in the clear, and nobody but stations and the owner.
        for user, mode, password in (("theatre_1", "disable", STATION), ("postgres", "require", OWNER)):
            status, text = self.type(f"psql -w -c 'SELECT 1' {self.address(user, mode)}", PGPASSWORD=password)
            self.assertNotEqual(status, 0, text)
            self.assertIn("no pg_hba.conf entry", text)

    def a_station_cannot_change_scores(self):
        status, text = self.type(f"psql -w -c 'UPDATE attempts SET points = 100' "
                                 f"{self.address('theatre_1', 'verify-full')}")
        self.assertNotEqual(status, 0, text)
        self.assertIn("permission denied", text)
        status, text = self.station(words="station role --check")
        self.assertEqual(status, 0, text)

    def copy_and_get_it_back(self):
        whole = self.contents("--store postgresql://theatre_1@db.example.org:5432/placode --as ada ")
        self.do(self.typed_here(self.pages[COPY]))
        self.assertEqual(self.contents("--store postgresql://theatre_1@db.example.org:5432/placode --as ada "),
                         whole)
        self.a_station_cannot_change_scores()

    def typed_here(self, copy):
        """Without the lines at the end for the computer of SHARED: shared_station_test restores there."""
        end = next(i for i, command in enumerate(copy) if "createdb --owner placode placode" in command)
        for command in copy[end:-1]:
            self.assertNotIn("placode_owner", command, "nobody has that role there")
        return copy[:end]

    def simulate_at_night(self):
        """The account, the file of its password, and what the timer starts, as its unit says."""
        self.do(self.pages[NIGHT])
        password = self.home / "etc" / "night.password"
        self.assertEqual(password.stat().st_mode & 0o777, 0o600)
        password.write_text(NIGHT_JOB + "\n")
        unit = (SOURCE / "packaging/placode-server-verify.service").read_text()
        self.assertIn("\nLoadCredential=password:/etc/placode/night.password\n", unit)
        self.assertIn("\nEnvironment=PLACODE_AS=night\n", unit)
        status, text = self.type(
            f"sh {SOURCE}/packaging/scheduled-verify", PLACODE_AS="night", PLACODE_PASSWORD_FILE=str(password),
            PLACODE_STORE=self.here("postgresql://theatre_1@db.example.org:5432/placode"))
        self.assertEqual(status, 0, text)
        self.assertIn("1 attempt gave the same", text)

    def move_back(self):
        self.do(self.pages[BACK])
        status, text = self.type(f"placodectl --store sqlite:{self.home}/placode.db check")
        self.assertEqual(status, 0, text)
        self.contents(f"--store sqlite:{self.home}/placode.db ")


if __name__ == "__main__":
    unittest.main(verbosity=2)
