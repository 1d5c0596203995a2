"""Tests the action of `action.yml`: runs its single step as a GitHub runner does, in the example repository.

In: `action.yml`, the workflow of the example, the npm package. Out: whether both are valid, and whether annotations, summary, SARIF and
exit status are right for programs with an error, with a warning and without findings. `evaluated` supports the expressions that `action.yml` may use.
"""

import json
import os
import re
import sys
from pathlib import Path

import yaml

import package
from sarif import validator
from shared import DOUBTFUL, FAULTY, ROOT, Tools, has, lacks, repository, run, say, scratch

WORKFLOW = ".github/workflows/programs.yml"


def is_valid(schema: str, file: Path, status: int = 0) -> None:
    run([sys.executable, "-m", "check_jsonschema", "--builtin-schema", schema, file], ROOT, status)


def evaluated(text: str, places: dict) -> str:
    """A text with the values of `${{ inputs.x }}` and `${{ steps.check.outputs.x }}`; the keys of `places` are the parts before the last dot."""

    def value(found: re.Match) -> str:
        place, _, name = found[1].rpartition(".")
        return places[place].get(name, "")

    return re.sub(r"\$\{\{ *([\w.-]+) *\}\}", value, text)


class Action:
    """The action in a repository."""

    def __init__(self, folder: Path, archive: Path) -> None:
        self.folder, self.archive = folder, archive
        self.text = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))

    def __call__(self, status: int, **given: str) -> tuple[str, str, str, str]:
        """Runs it with these inputs. Returns both output streams, the summary and the path of the SARIF file."""
        given = {name.replace("_", "-"): str(value) for name, value in given.items()} | {"package": str(self.archive)}
        known = self.text["inputs"]
        assert given.keys() <= known.keys(), given
        inputs = {name: given.get(name, str(known[name].get("default", ""))) for name in known}
        temporary = scratch("action-temporary")
        env = {**os.environ, "RUNNER_TEMP": str(temporary), "GITHUB_OUTPUT": str(temporary / "output"), "GITHUB_STEP_SUMMARY": str(temporary / "summary")}
        (step,) = self.text["runs"]["steps"]
        assert step.keys() <= {"id", "shell", "env", "run"} and step["shell"] == "bash", step
        lacks(step["run"], "${{")
        values = {name: evaluated(text, {"inputs": inputs}) for name, text in step["env"].items()}
        script = temporary / "step.sh"
        script.write_text(step["run"], encoding="utf-8")
        done = run(["bash", "--noprofile", "--norc", "-eo", "pipefail", script], self.folder, status, {**env, **values})
        output = temporary / "output"
        lines = output.read_text(encoding="utf-8").splitlines() if output.is_file() else []
        outputs = dict(line.split("=", 1) for line in lines)
        summary = temporary / "summary"
        return done.stdout, done.stderr, summary.read_text(encoding="utf-8"), evaluated(self.text["outputs"]["sarif"]["value"], {f"steps.{step['id']}.outputs": outputs})


def with_of(folder: Path) -> dict:
    """The inputs in the workflow of the example."""
    steps = yaml.safe_load((folder / WORKFLOW).read_text(encoding="utf-8"))["jobs"]["check"]["steps"]
    (step,) = [step for step in steps if "gcode-playground" in step.get("uses", "")]
    return {name.replace("-", "_"): value for name, value in step.get("with", {}).items()}


def main(tools: Tools) -> None:
    is_valid("vendor.github-actions", ROOT / "action.yml")
    is_valid("vendor.github-workflows", ROOT / "tests/example-repository" / WORKFLOW)
    broken = scratch("action-broken") / "action.yml"
    broken.write_text("name: x\ndescription: y\nruns: {using: composite, steps: [{run: ls}]}\n", encoding="utf-8")
    is_valid("vendor.github-actions", broken, 1)
    version = re.search(r'^version = "(.*)"$', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.MULTILINE)[1]

    folder = repository("action")
    action = Action(folder, package.pack(tools))
    assert action.text["inputs"]["version"]["default"] == version
    given = with_of(folder)
    schema = validator(tools)

    # With the configuration of the example, its findings are in the baseline.
    said, _, summary, sarif = action(0, **given)
    assert said == "" and json.loads(Path(sarif).read_text(encoding="utf-8"))["runs"][0]["results"] == []
    has(summary, "nothing found in 2 files")
    # There is no baseline with another configuration, or with an empty one.
    (folder / "strict.toml").write_text('setup = "setup.json"\n', encoding="utf-8")
    said, _, _, _ = action(1, config="strict.toml")
    has(said, "::error file=programs/bushing.nc,line=7,")
    (folder / "none.json").write_text("[]\n", encoding="utf-8")
    said, _, _, _ = action(1, baseline="none.json")
    has(said, "::error file=programs/bushing.nc,line=7,")
    # The example allows no warning; an input can allow one.
    (folder / "programs/doubtful.nc").write_text(DOUBTFUL, encoding="utf-8")
    said, errors, summary, sarif = action(1, **given)
    has(said, "::warning file=programs/doubtful.nc,")
    lacks(said, "::error", "bushing")
    has(errors, "`--max-warnings` allows 0")
    action(0, paths="programs/doubtful.nc", max_warnings=1)
    # Names with blanks, several paths, another language, further options, a separate output file.
    (folder / "ü neu").mkdir()
    (folder / "ü neu/Welle 1.nc").write_text(FAULTY, encoding="utf-8")
    said, _, summary, sarif = action(1, paths="ü neu\nprograms/shoulder.nc\n", language="zh", options="--ignore\nnot-checked-behind-fault", sarif="report.sarif")
    has(said, "::error file=ü neu/Welle 1.nc,line=6,")
    has(summary, "| ü neu/Welle 1.nc | 6 | ")
    assert any("\u4e00" <= letter <= "\u9fff" for letter in said), said
    assert sarif == "report.sarif" and len(said.splitlines()) == 1, said
    report = json.loads((folder / sarif).read_text(encoding="utf-8"))
    assert not list(schema.iter_errors(report)) and len(report["runs"][0]["results"]) == 1
    # The pages of a manual.
    action(0, paths="manual", options="--markdown")
    (folder / "manual/faulty.md").write_text(f"# Page\n\n```gcode\n{FAULTY}```\n", encoding="utf-8")
    said, _, summary, sarif = action(1, paths="manual", options="--markdown")
    has(said, "::error file=manual/faulty.md,line=9,")
    has(summary, "| manual/faulty.md | 9 | ")
    assert not list(schema.iter_errors(json.loads(Path(sarif).read_text(encoding="utf-8"))))
    # An unreadable path is an error and hides no findings, and no part of a name is executed as a command.
    said, errors, _, _ = action(2, paths="ü neu\n$(touch made) `touch made`\n--quiet")
    has(said, "Welle 1.nc,line=6,")
    has(errors, "touch made")
    assert not (folder / "made").exists()
    said, errors, _, sarif = action(2, options="--control=heidenhain")
    has(errors, "heidenhain")
    assert sarif == "", sarif
    say("GitHub: the action is valid, and its steps annotate, sum up, write SARIF and fail as they should")
