"""The npm package that `npx` starts in the tests.

In: the folder of the built package. Out: an archive written by `npm pack`.
"""

from pathlib import Path

from shared import Tools, run, say, scratch

COMMAND = "bin/gcode-playground.js"


def pack(tools: Tools) -> Path:
    if not (tools.package / COMMAND).is_file():
        raise SystemExit(f"{tools.package} has no {COMMAND}: `cargo xtask site` builds it")
    folder = scratch("package")
    say(f"the package: {tools.package}")
    name = run(["npm", "pack", "--silent", tools.package], folder).stdout.strip()
    return folder / name
