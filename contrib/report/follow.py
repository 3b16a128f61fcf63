# SPDX-License-Identifier: GPL-3.0-or-later
"""Follows runs that go on: a server that this machine alone reaches has their report, made anew as they write."""

import http.server
import json
import sys
import threading
import time

from html_tables import escape
from lahar_output import OutputError
from report_page import make_report, plotly_block, write_report
from run_record import lock_of, read_runs, split_argument

PATIENCE = 10.   # s that a run has to begin
PAUSE = 0.5      # s between two looks at the files
LEAST_AGE = 3.   # s between two pages; making them takes at most this share of a core:
LARGEST_SHARE = 0.1
FAREWELL = 60.   # s that an open page, busy as it may be, has to fetch the end
WAITING = """<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta http-equiv="refresh" content="2">
<title>Lahar</title><link rel="icon" href="data:,"><body data-state="waiting"><p>{reason}</p></body></html>"""
NOTHING = """<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>Lahar</title><link rel="icon" href="data:,">
<body data-state="failed"><p>{reason}</p><p>The run has ended.</p></body></html>"""
FILES = ("parameters.prm", "statistics", "solution.pvd", "log", "lock")


def follow(arguments):
    """Serves the report until no run goes on or somebody stops it; then writes it, if arguments.output is a file."""
    directories = [split_argument(argument)[0] for argument in arguments.outputs]
    wait_for_run(directories)
    server = Server(arguments.port)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(f"{server.address} shows {', '.join(map(str, directories))} until the run ends. Ctrl-C ends it, too.",
          flush=True)
    try:
        follow_runs(arguments, directories, server)
        end = time.monotonic() + FAREWELL
        while server.is_awaited() and time.monotonic() < end:
            time.sleep(0.1)
        end_of(directories, server.state)
    except KeyboardInterrupt:
        print(flush=True)
    if arguments.output:
        write_report(read_runs(arguments.outputs), arguments)


def end_of(directories, state):
    """Says that the runs have ended, and what is wrong with their files at the end; throws it if there never was a page."""
    if state["version"] == 0:
        raise OutputError(state["complaint"])
    if state["complaint"]:
        print(f"Not up to date: {state['complaint']}", flush=True)
    print("The run has ended." if len(directories) == 1 else "The runs have ended.", flush=True)


def wait_for_run(directories):
    end = time.monotonic() + PATIENCE
    while not any_goes_on(directories):
        if time.monotonic() > end:
            raise OutputError(f"{', '.join(map(str, directories))}: no run goes on here; allowed with --follow: the "
                              "output directory of a run that goes on; without --follow, with -o, of one that has ended")
        time.sleep(PAUSE)


def any_goes_on(directories):
    return any(lock_of(directory) in ("held", "elsewhere") for directory in directories)


def follow_runs(arguments, directories, server):
    """Makes the page again where files have changed, until no run goes on."""
    last, version, next_time = None, 0, 0.
    while True:
        goes_on = any_goes_on(directories)  # first, so that the page at the end has all
        files = [times(directory / name) for directory in directories for name in FILES]
        if (files != last and time.monotonic() >= next_time) or not goes_on:
            begin = time.process_time()
            try:
                page, _ = make_report(read_runs(arguments.outputs), arguments, version + 1)
                last, version = files, version + 1
                server.publish(page, version, not goes_on)
            except (OutputError, OSError) as reason:  # not yet, or not any more: the last page stays
                server.complain(str(reason), not goes_on)
            next_time = time.monotonic() + max(LEAST_AGE, (time.process_time() - begin) / LARGEST_SHARE)
        if not goes_on:
            return
        time.sleep(PAUSE)


def times(path):
    """Something that changes when a file does."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size


class Server(http.server.ThreadingHTTPServer):
    """Serves to programs on this machine: / the page, /news the page without plotly, and /version what there is; who asks
    for /version?N shows version N."""

    daemon_threads = True

    def __init__(self, port):
        try:
            super().__init__(("127.0.0.1", port), Handler)
        except (OSError, OverflowError) as error:
            raise OutputError(f"--port is {port}: {error}; allowed: a free port of this machine, 0 finds one") from None
        self.texts = {"/": WAITING.format(reason="The run has not written anything yet.")}
        self.state = {"version": 0, "ended": False, "complaint": ""}
        self.last_asked, self.knows_end = None, False

    @property
    def address(self):
        return f"http://127.0.0.1:{self.server_address[1]}/"

    def publish(self, page, version, ended):
        self.texts = {"/": page, "/news": page.replace(plotly_block(), "")}
        self.state = {"version": version, "ended": ended, "complaint": ""}

    def complain(self, reason, ended):
        if self.state["version"] == 0:
            self.texts = {"/": (NOTHING if ended else WAITING).format(reason=escape(reason))}
        self.state = {**self.state, "ended": ended, "complaint": reason}

    def answer(self, path):
        """The text and its kind; None where there is none."""
        state, texts = self.state, self.texts
        self.last_asked = time.monotonic()
        path, _, shown = path.partition("?")
        if path == "/version":
            self.knows_end = state["ended"] and shown == str(state["version"])
            return json.dumps(state), "application/json"
        if path == "/" and state["version"] == 0:
            self.knows_end = state["ended"]  # this page says it and asks no more
        return (texts[path], "text/html; charset=utf-8") if path in texts else None

    def handle_error(self, request, client_address):
        """A browser that has gone is no error."""
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, client_address)

    def is_awaited(self):
        """Whether somebody has asked of late, and not yet been told of the end."""
        return self.last_asked is not None and time.monotonic() < self.last_asked + FAREWELL and not self.knows_end


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        # Pages of other sites have other hosts.
        is_local = self.headers.get("Host") in (f"{name}:{self.server.server_address[1]}" for name
                                                in ("127.0.0.1", "localhost"))
        answer = self.server.answer(self.path) if is_local else None
        if answer is None:
            self.send_error(404)
            return
        content = answer[0].encode()
        self.send_response(200)
        self.send_header("Content-Type", answer[1])
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_):
        pass
