"""Shared helpers of the repository tests: paths, scratch repositories, commands.

In: nothing. Out: functions. Does not depend on the tests.
"""

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "tests/example-repository"
TARGET = (ROOT / os.environ.get("CARGO_TARGET_DIR", "target")).resolve()

# A program with an error, and one with only a warning.
FAULTY = "O0007 (STOCK D=40 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X42 Z2\nG90 X36 Z-20 F0.2\nX\nG00 X100 Z100\nM30\n"
DOUBTFUL = "O0008 (STOCK D=40 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X42 Z2\nG90 X36 Z-20 F0.2\nX32\nG00 X100 Z100\n"


@dataclass(frozen=True)
class Tools:
    """The programs and packages that the tests use."""

    # The built command line.
    command: Path
    # The folder of the built npm package; it may be missing.
    package: Path
    # The folder with the npm packages of the tests.
    node_modules: Path


def run(words: list, folder: Path, status: int | None = 0, env: dict | None = None, **more) -> subprocess.CompletedProcess:
    """Runs a command and returns its output. Any other exit status is an error; `None` accepts all."""
    done = subprocess.run([str(word) for word in words], cwd=folder, env=env, capture_output=True, text=True, encoding="utf-8", **more)
    if status is not None and done.returncode != status:
        raise AssertionError(f"{' '.join(map(str, words))}: {done.returncode} instead of {status}\n{done.stdout}{done.stderr}")
    return done


def has(text: str, *parts: str) -> None:
    """Checks that a text contains each of these parts."""
    for part in parts:
        assert part in text, f"no `{part}` in\n{text}"


def lacks(text: str, *parts: str) -> None:
    """Checks that a text contains none of these parts."""
    for part in parts:
        assert part not in text, f"`{part}` in\n{text}"


def scratch(name: str) -> Path:
    """A new folder for a test, next to the builds of the repository."""
    base = TARGET / "tmp/teams"
    shutil.rmtree(base / name, ignore_errors=True)
    (base / name).mkdir(parents=True)
    return base / name


def git(folder: Path, *words, status: int | None = 0, env: dict | None = None) -> subprocess.CompletedProcess:
    """Runs git without the settings of the user."""
    who = {f"GIT_{role}_{part}": value for role in ("AUTHOR", "COMMITTER") for part, value in (("NAME", "Test"), ("EMAIL", "test@example.com"))}
    plain = {**(env or os.environ), **who, "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_NOSYSTEM": "1"}
    return run(["git", *words], folder, status, plain)


def repository(name: str) -> Path:
    """A scratch repository with the files of the example, in one commit."""
    folder = scratch(name)
    shutil.copytree(EXAMPLE, folder, dirs_exist_ok=True)
    git(folder, "init", "--quiet", "--initial-branch", "main")
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--message", "Programs")
    return folder


def own_repository(name: str) -> Path:
    """A scratch repository with the current files of this one, in one commit."""
    folder = scratch(name)
    listed = git(ROOT, "ls-files", "--cached", "--others", "--exclude-standard", "-z").stdout.split("\0")
    for file in filter(None, listed):
        if (ROOT / file).is_file():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / file, folder / file)
    git(folder, "init", "--quiet", "--initial-branch", "main")
    git(folder, "add", "--all", "--force")
    git(folder, "commit", "--quiet", "--message", "As it is")
    return folder


def say(line: str) -> None:
    print(line, flush=True)
