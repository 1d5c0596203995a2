"""Tests the hooks for `pre-commit`, installed into a scratch repository and called by `git commit`.

In: this repository in its current state, which `pre-commit` clones and builds. Out: whether a faulty program is rejected, and a correct
one and one with known findings are accepted; and the same with the npm package.
"""

import os
import re
import sys
from pathlib import Path

import package
from shared import DOUBTFUL, FAULTY, TARGET, Tools, git, has, own_repository, repository, run, say, scratch

# The hook builds a release; for the little work here an unoptimised build is faster.
CHEAP = {"OPT_LEVEL": "0", "LTO": "off", "CODEGEN_UNITS": "16", "DEBUG": "0"}


def environment(tools: Tools) -> dict:
    home = scratch("hooks-home")
    cheap = {f"CARGO_PROFILE_RELEASE_{name}": value for name, value in CHEAP.items()}
    build = {"CARGO_TARGET_DIR": str(TARGET / "teams"), "CARGO_INCREMENTAL": "0", **cheap}
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    return {**os.environ, **build, "PATH": path, "PRE_COMMIT_HOME": str(home)}


def configure(folder: Path, text: str, env: dict) -> None:
    """Writes the configuration, and installs the hook in the repository."""
    (folder / ".pre-commit-config.yaml").write_text(text, encoding="utf-8")
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--message", "Hooks")
    run([sys.executable, "-m", "pre_commit", "install", "--install-hooks"], folder, env=env)


def commit(folder: Path, env: dict, file: str, text: str, status: int) -> str:
    """Commits a file. Returns the output of the hooks."""
    (folder / file).parent.mkdir(parents=True, exist_ok=True)
    (folder / file).write_text(text, encoding="utf-8")
    git(folder, "add", file)
    done = git(folder, "commit", "--message", file, status=status, env=env)
    if status != 0:
        git(folder, "rm", "--quiet", "--cached", file)
        (folder / file).unlink()
    return done.stdout + done.stderr


def refuses(folder: Path, env: dict) -> None:
    """Checks the hook for programs with the configuration of the example."""
    said = commit(folder, env, "programs/new faulty.nc", FAULTY, 1)
    has(said, "check lathe G-code", "Failed", "programs/new faulty.nc:6", "PS0005")
    said = commit(folder, env, "programs/O0007", FAULTY, 1)
    has(said, "programs/O0007:6")
    # One warning is too many here.
    has(commit(folder, env, "programs/doubtful.NC", DOUBTFUL, 1), "programs/doubtful.NC:", "allows 0")
    has(commit(folder, env, "programs/right.NC", f"{DOUBTFUL}M30\n", 0), "check lathe G-code", "Passed")
    # The findings of this file are in the baseline, wherever its blocks move; an additional one is new.
    old = (folder / "programs/bushing.nc").read_text(encoding="utf-8")
    has(commit(folder, env, "programs/bushing.nc", old.replace("T0101\n", "T0101\n(FIRST TOOL)\n"), 0), "Passed")
    (folder / "notes.txt").write_text(FAULTY, encoding="utf-8")
    has(commit(folder, env, "notes.txt", FAULTY, 0), "no files to check")


def main(tools: Tools) -> None:
    env = environment(tools)
    example = (repository("hooks") / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    own = own_repository("hooks-own")
    text, count = re.subn(r"repo: https://\S+", f"repo: {own}", example)
    text = re.sub(r"rev: \S+", f"rev: {git(own, 'rev-parse', 'HEAD').stdout.strip()}", text)
    assert count == 1, example
    folder = repository("hooks")
    configure(folder, text, env)
    refuses(folder, env)
    said = commit(folder, env, "manual/new.md", f"# New\n\n```gcode\n{FAULTY}```\n", 1)
    has(said, "check the G-code in manuals", "Failed", "manual/new.md:9")
    has(commit(folder, env, "manual/right.md", f"# New\n\n```gcode no-check\n{FAULTY}```\n", 0), "Passed")

    # All files, as on a server.
    run([sys.executable, "-m", "pre_commit", "run", "--all-files"], folder, env=env)
    say("pre-commit: the hooks built by cargo refuse what is faulty, and take the rest")

    example = (repository("hooks-npm") / ".pre-commit-config-npm.yaml").read_text(encoding="utf-8")
    text, count = re.subn(r"'gcode-playground@[^']+'", f"'{package.pack(tools)}'", example)
    assert count == 1, example
    folder = repository("hooks-npm")
    configure(folder, text, env)
    refuses(folder, env)
    configure(folder, f"{text}        args: [--lang=zh]\n", env)
    said = commit(folder, env, "programs/faulty.nc", FAULTY, 1)
    assert any("\u4e00" <= letter <= "\u9fff" for letter in said), said
    say("pre-commit: so does the npm package")
