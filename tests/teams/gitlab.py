"""Tests the job of `templates/check.yml`, included from a server and run by `gitlab-ci-local` in the example repository.

In: the template, `.gitlab-ci.yml` of the example, the npm package. Out: whether the job fails when it should, prints the findings,
and writes them as a JUnit report and a Code Quality report. Needs `rsync`, which `gitlab-ci-local` uses for copies.
"""

import functools
import http.server
import json
import re
import sys
import threading
import xml.etree.ElementTree
from pathlib import Path

import package
from shared import DOUBTFUL, FAULTY, ROOT, Tools, has, lacks, repository, run, say


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_) -> None:
        pass


def job(tools: Tools, folder: Path, status: int) -> tuple[str, xml.etree.ElementTree.Element]:
    """Runs the job; returns its log and its report."""
    report = folder / "gcode-playground.xml"
    report.unlink(missing_ok=True)
    program = tools.node_modules / "gitlab-ci-local/dist/index.js"
    done = run(["node", program, "--force-shell-executor", "gcode-playground"], folder, status)
    return done.stdout + done.stderr, xml.etree.ElementTree.parse(report).getroot()


def quality(folder: Path) -> list[tuple[str, int]]:
    """Path and line of each finding in the Code Quality report, whose fingerprints are all different."""
    issues = json.loads((folder / "gcode-playground.json").read_text(encoding="utf-8"))
    assert len({issue["fingerprint"] for issue in issues}) == len(issues), issues
    return [(issue["location"]["path"], issue["location"]["lines"]["begin"]) for issue in issues]


def main(tools: Tools) -> None:
    folder = repository("gitlab")
    file = folder / ".gitlab-ci.yml"
    run([sys.executable, "-m", "check_jsonschema", "--builtin-schema", "vendor.gitlab-ci", file], folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=ROOT / "templates")) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        given = file.read_text(encoding="utf-8")
        here = f"remote: http://127.0.0.1:{server.server_port}/check.yml"
        text, count = re.subn(r"remote: https://\S+/templates/check\.yml", here, given)
        assert count == 1, given
        text += f"    inputs:\n      package: {package.pack(tools)}\n"
        file.write_text(text, encoding="utf-8")

        log, report = job(tools, folder, 0)
        has(log, "nothing found in 2 files")
        assert [suite.get("failures") for suite in report] == ["0", "0"]
        assert quality(folder) == []
        # One warning is too many here.
        (folder / "programs/doubtful.nc").write_text(DOUBTFUL, encoding="utf-8")
        log, report = job(tools, folder, 1)
        has(log, "programs/doubtful.nc:", "`--max-warnings` allows 0")
        lacks(log, "programs/bushing.nc:7")
        assert [suite.get("failures") for suite in report] == ["0", "1", "0"]
        # Without the baseline.
        file.write_text(f"{text}      options: --no-config --lang ru\n      paths: programs/bushing.nc\n", encoding="utf-8")
        log, report = job(tools, folder, 1)
        has(log, "programs/bushing.nc:7:1", "PS0005")
        assert any("а" <= letter <= "я" for letter in log), log
        (case,) = report.findall("testsuite[@name='programs/bushing.nc']/testcase")
        has(case.get("name"), "number-missing 7:1")
        # The error, and the note that the rest is not checked.
        assert quality(folder) == [("programs/bushing.nc", 7), ("programs/bushing.nc", 8)], quality(folder)
        # The pages of a manual.
        (folder / "manual/faulty.md").write_text(f"# Page\n\n```gcode\n{FAULTY}```\n", encoding="utf-8")
        file.write_text(f"{text}      options: --markdown\n      paths: manual\n", encoding="utf-8")
        log, report = job(tools, folder, 1)
        has(log, "manual/faulty.md:9:1")
        assert len(report.findall("testsuite[@name='manual/faulty.md']/testcase/failure")) == 1
        server.shutdown()
    say("GitLab: the job that a repository includes fails where it should, with a log and a report")
