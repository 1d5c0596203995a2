"""Measures the command line on many files and on a long one, natively and under Node, compared with ruff. Part of `cargo xtask bench`.

In: the native program, the script of the npm package, ruff, a program of a million lines, a folder for files, the path of the report, rounds. Out: a table of
times, processor times and memory: medians of the rounds, each run in a separate process. The ten thousand programs repeat the shaft of sixty lines and the
complete programs of `tests/programs`; ruff gets the same number of Python files with the same sizes.
"""

import os
import shutil
import statistics
import sys
import time
from pathlib import Path

COUNT = 10_000
IN_A_FOLDER = 200
WHOLE = 200
ROOT = Path(__file__).resolve().parents[2]

# One statement of the Python files. ruff reports nothing for it, as most G-code programs here are correct too.
STATEMENT = "def area_{n}(diameter: float, length: float) -> float:\n    return 3.14159 * diameter * length\n\n\n"


def main() -> None:
    native, node, ruff, long_program, folder, report, rounds = sys.argv[1:]
    folder = Path(folder)
    programs, python = folder / "programs", folder / "python"
    size = write_files(programs, python)
    long_python = folder / "long.py"
    with long_python.open("w", encoding="utf-8") as file:
        # Written in pieces: a started process counts the memory of this one.
        for n in range(Path(long_program).stat().st_size // len(STATEMENT)):
            file.write(STATEMENT.format(n=n))
    under_node = ["node", node, "check", "--no-config", "--quiet"]
    natively = [native, "check", "--no-config", "--quiet"]
    lints = [ruff, "check", "--no-cache", "--isolated", "--quiet"]
    one = ["taskset", "-c", "0"] if shutil.which("taskset") else []
    rows = [
        ("10,000 files, native, all processors", [*natively, programs]),
        ("10,000 files, native, one processor", [*one, *natively, programs]),
        ("10,000 files, `npx`", [*under_node, programs]),
        ("10,000 files of Python, ruff, all processors", [*lints, python]),
        ("10,000 files of Python, ruff, one processor", [*one, *lints, python]),
        ("one file of a million lines, native", [*natively, long_program]),
        ("one file of a million lines, `npx`", [*under_node, long_program]),
        ("one file of Python of that size, ruff", [*lints, long_python]),
        ("one file of three lines, `npx`", [*under_node, short(folder)]),
    ]
    runs = {name: [] for name, _ in rows}
    for _ in range(int(rounds)):
        for name, command in rows:
            runs[name].append(measured([str(word) for word in command]))
    table = [
        f"### The command line: 10,000 files of {size / 1e6:.0f} MB in all, and one of 20 MB ({rounds} rounds)",
        "",
        "| what | s | s of processors | MB |",
        "|---|---:|---:|---:|",
    ]
    for name, own in runs.items():
        seconds, busy, memory = (statistics.median(one[at] for one in own) for at in range(3))
        table.append(f"| {name} | {seconds:.2f} | {busy:.2f} | {memory:.0f} |")
    text = "\n".join(table) + "\n"
    print(text)
    Path(report).write_text(text, encoding="utf-8")
    alone = statistics.median(one[0] for one in runs["10,000 files, native, one processor"])
    under = statistics.median(one[0] for one in runs["10,000 files, `npx`"])
    print(f"npx: {under:.2f} s of at most {0.3 + 4 * alone:.2f} (0.3 and four times the native time of one processor)")


def write_files(programs: Path, python: Path) -> int:
    """Writes the files. Returns the total size of the programs in bytes."""
    for folder in (programs, python):
        shutil.rmtree(folder, ignore_errors=True)
    sources = [source.read_bytes() for source in sorted(ROOT.glob("tests/programs/*/*.nc"))]
    # Fragments of a few blocks are not realistic programs.
    sources = [source for source in sources if len(source) >= WHOLE]
    sources.append((python.parent / "shaft.nc").read_bytes())
    size = 0
    for at in range(COUNT):
        source = sources[at % len(sources)]
        size += len(source)
        for folder, name, text in (
            (programs, f"p{at:05}.nc", source),
            (python, f"p{at:05}.py", python_of(len(source)).encode()),
        ):
            inner = folder / f"{at // IN_A_FOLDER:02}"
            inner.mkdir(parents=True, exist_ok=True)
            (inner / name).write_bytes(text)
    return size


def python_of(size: int) -> str:
    """Python code of about this size in bytes."""
    count = max(1, size // len(STATEMENT))
    return "".join(STATEMENT.format(n=n) for n in range(count)).rstrip() + "\n"


def short(folder: Path) -> Path:
    file = folder / "short.nc"
    file.write_text("O1\nG0 X50 Z2\nM30\n", encoding="utf-8")
    return file


def measured(command: list[str]) -> tuple[float, float, float]:
    """Elapsed seconds, processor seconds, and peak memory in MB."""
    begun = time.perf_counter()
    process = os.posix_spawnp(
        command[0],
        command,
        os.environ,
        file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)],
    )
    _, status, used = os.wait4(process, 0)
    seconds = time.perf_counter() - begun
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        sys.exit(f"{' '.join(command)} ended with {os.waitstatus_to_exitcode(status)}")
    return seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


main()
