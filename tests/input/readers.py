# SPDX-License-Identifier: GPL-3.0-or-later
"""What reads the file case.prm of a directory for fuzz.py: the program `lahar`, or a child of check_server.cc.

read() returns the status, the signal's negative number or None if it takes too long, and what was printed on stdout and
stderr.
"""
import os
import resource
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from program_test import ALONE  # noqa: E402


def command_line(program, arguments):
    largest = arguments.largest
    return [program, "--check", "case.prm", "--set", "Largest number of particles=%d" % largest,
            "--set", "Solids/Largest number of nodes=%d" % largest]


class Program:
    """Starts anew for each directory."""

    def __init__(self, arguments):
        self.command, self.environment = command_line(arguments.lahar, arguments), ALONE
        self.seconds, self.bytes = arguments.seconds, int(arguments.memory * 2**30)

    def limit_memory(self):
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if self.bytes > 0:
            resource.setrlimit(resource.RLIMIT_AS, (self.bytes, self.bytes))

    def read(self, directory):
        process = subprocess.Popen(self.command, cwd=directory, env=self.environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=self.limit_memory)
        try:
            out, err = process.communicate(timeout=self.seconds)
            return process.returncode, out, err
        except subprocess.TimeoutExpired:
            process.kill()
            return (None, *process.communicate())

    def close(self):
        pass


class Server:
    """Starts once; each process that it forks reads some directories."""

    def __init__(self, arguments):
        self.limits = "%g %d" % (arguments.seconds, int(arguments.memory * 2**30))
        program, *options = command_line(arguments.server, arguments)
        # Symbols are looked up before the fork, not by each child.
        self.process = subprocess.Popen([program, str(arguments.batch), *options], stdin=subprocess.PIPE, text=True,
                                        stdout=subprocess.PIPE, env=dict(ALONE, LD_BIND_NOW="1"))
        self.answer("ready")

    def answer(self, *allowed):
        words = self.process.stdout.readline().split()
        if not words or words[0] not in allowed:
            raise RuntimeError("the server says: %s" % " ".join(words))
        return words

    def read(self, directory):
        self.process.stdin.write("%s %s\n" % (self.limits, directory))
        self.process.stdin.flush()
        word, *number = self.answer("exited", "killed", "late")
        return ({"exited": 1, "killed": -1}[word] * int(number[0]) if number else None,
                self.take(directory + ".out"), self.take(directory + ".err"))

    def close(self):
        self.process.communicate()

    @staticmethod
    def take(name):
        with open(name, "rb") as file:
            data = file.read()
        os.remove(name)
        return data
