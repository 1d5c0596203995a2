"""Tests the ways to check programs in a repository with the real tools; `cargo xtask test --all` runs all of them.

    python3 tests/teams/run.py COMMAND PACKAGE NODE_MODULES WAY…

    COMMAND       the built command line
    PACKAGE       the built npm package (`www/dist/embed`); it may be missing
    NODE_MODULES  where the npm packages of the tests are
    WAY           sarif, schemas, hooks, action, gitlab

Needs the Python packages that `xtask/src/teams.rs` names. The programs are those of `tests/example-repository`.
"""

import importlib
import sys
import time
from pathlib import Path

# Write no bytecode into the tree.
sys.dont_write_bytecode = True
from shared import Tools, say


def main() -> None:
    command, package, node_modules, *ways = sys.argv[1:]
    tools = Tools(Path(command).resolve(), Path(package).resolve(), Path(node_modules).resolve())
    for way in ways:
        begun = time.monotonic()
        importlib.import_module(way).main(tools)
        say(f"{way}: {time.monotonic() - begun:.1f} s")


main()
