"""Checks the output of `check --format sarif` with the schema of SARIF 2.1.0.

In: the command line; the schema of the npm package `@microsoft/jest-sarif`. Out: whether each report is valid: for the failing
examples of all rules, for the test programs, with fixes, for names with blanks and non-Latin letters, for pages of a manual,
and without any input.
"""

import json
import re
from pathlib import Path

from jsonschema import Draft4Validator

from shared import FAULTY, ROOT, Tools, run, say, scratch


def validator(tools: Tools) -> Draft4Validator:
    # The approved release candidate. The final text differs in titles, and in the format of GUIDs and languages, which
    # the reports do not contain.
    path = tools.node_modules / "@microsoft/jest-sarif/lib/schemas/sarif-2.1.0-rtm.5.json"
    return Draft4Validator(json.loads(path.read_text(encoding="utf-8")))


def examples(folder: Path) -> int:
    """The failing examples of all rules, one file each."""
    count = 0
    for page in sorted((ROOT / "src/rules").glob("*.md")):
        block = re.search(r"^```wrong\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
        if block is None or page.name == "README.md":
            continue
        lines = [line for line in block[1].splitlines() if not re.match(r"// *\^", line)]
        (folder / f"{page.stem}.nc").write_text("\n".join(lines) + "\n", encoding="utf-8")
        count += 1
    return count


def main(tools: Tools) -> None:
    schema = validator(tools)
    folder = scratch("sarif")
    count = examples(folder)
    names = folder / "ü ß 外圆"
    names.mkdir()
    (names / "Welle 1 (neu) #2%.nc").write_text(FAULTY, encoding="utf-8")
    (names / "repair.nc").write_text("O1\nM3 S500\n(\U0001f600) GO0 X5\nM30\n", encoding="utf-8")
    (names / "empty.nc").write_bytes(b"")
    (names / "gbk.nc").write_bytes(b"O1(\xcd\xe2\xd4\xb2\xb3\xb5\xcf\xf7)\r\nM3 S500\r\nG0 X\r\nM30\r\n")
    (names / "control.nc").write_text("O1\nG0 X (\x1b[31mRED\x07)\nM30\n", encoding="utf-8")

    def report(*words, piped: str = "", status: int | None = None) -> dict:
        done = run([tools.command, "check", *words, "--format", "sarif"], folder, status, input=piped)
        found = json.loads(done.stdout)
        faults = [f"{'/'.join(map(str, fault.absolute_path))}: {fault.message}" for fault in schema.iter_errors(found)]
        assert not faults, f"check {' '.join(map(str, words))}: {faults[:5]}"
        return found["runs"][0]

    everything = report(".", status=1)
    rules = {rule["id"] for rule in everything["tool"]["driver"]["rules"]}
    assert {result["ruleId"] for result in everything["results"]} == rules
    assert count > 150 and len(rules) > count * 3 // 4, f"{len(rules)} rules found in {count} examples"
    assert any("fixes" in result for result in everything["results"])
    places = [place["physicalLocation"]["artifactLocation"]["uri"] for result in report(ROOT / "tests/programs")["results"] for place in result["locations"]]
    assert places and all(place.startswith("file:///") for place in places), places[:3]
    for language in ("en", "zh", "ru"):
        report("ü ß 外圆", "--lang", language)
    report("ü ß 外圆/empty.nc")
    report("-", piped="")
    report("-", "--stdin-filename", "part 1 ü.nc", piped=FAULTY, status=1)
    report("ü ß 外圆/repair.nc", "--ignore", "letter-for-digit")
    report("ü ß 外圆/repair.nc", "gone.nc", status=2)
    (names / "page.md").write_text(f"# Page\n\n```gcode\n{FAULTY}```\n", encoding="utf-8")
    assert report("--markdown", "ü ß 外圆", status=1)["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] == 9
    assert not report("ü ß 外圆/repair.nc", "--fix", status=0)["results"]

    # Checks that the schema rejects an invalid report.
    broken = {"version": "2.1.0", "runs": [{"results": [{"level": "fatal", "message": {}}]}]}
    assert len(list(schema.iter_errors(broken))) >= 2, "the schema takes a report that is none"
    say(f"SARIF: the reports of {count} examples, with {len(everything['results'])} results of {len(rules)} rules, are valid")
