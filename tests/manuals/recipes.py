#!/usr/bin/env python3
"""Follows the recipes of www/docs/manuals.md exactly, with the real tools.

usage: recipes.py COMMAND_LINE ELEMENT FOLDER RECIPE…
    COMMAND_LINE  the program gcode-playground
    ELEMENT       the folder of the unpacked package; if it is missing, a substitute is created
    FOLDER        where the manuals are built; Docusaurus sites need their packages in FOLDER/site
    RECIPE        html, mdbook, sphinx, docusaurus

Then does the same with a program that contains all special characters of Markdown, HTML and JSX. A block after "…, `name`:" is the content of that
file; all other blocks of a recipe are commands. The element in the resulting page is parsed as in a browser: its program must equal the
original, byte for byte.
"""

import html.parser
import os
import re
import shutil
import subprocess
import sys
import textwrap
import xml.etree.ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCUMENT = ROOT / "www/docs/manuals.md"
RECIPES = {
    "html": ("Plain HTML", "index.html", ["shoulder.html"], "hard.html"),
    "mdbook": ("mdBook 0.5", "book/turning.html", [], "book/turning.html"),
    "sphinx": ("Sphinx 9", "_build/index.html", [], "_build/hard.html"),
    "docusaurus": ("Docusaurus 3", "build/index.html", [], "build/hard/index.html"),
}
# Commands to skip on a machine that has the tools.
INSTALLS = ("npm pack ", "tar ", "cargo install ", "pip install ")

# Each line has been misinterpreted by some tool.
HARD = (ROOT / "tests/manuals/hard.nc").read_text(encoding="utf-8")


def hard_page(recipe: str, folder: Path, path: str) -> None:
    """Writes a page with the hard program."""
    (folder / "hard.nc").write_text(HARD, encoding="utf-8")
    write = lambda name, text: (folder / name).write_text(text, encoding="utf-8")
    if recipe == "sphinx":
        lines = "".join(f"   {line}\n" if line else "\n" for line in HARD.splitlines())
        write("hard.rst", f":orphan:\n\nHard\n====\n\n.. gcode-playground::\n   :caption: a \"b\" <c>\n   :no-check:\n   :readonly:\n\n{lines}\nEnd.\n")
    elif recipe == "docusaurus":
        (folder / "docs").mkdir(exist_ok=True)
        run(["gcode-playground embed hard.nc --format mdx -o docs/hard.mdx || test $? = 1"], folder, path)
        block = (folder / "docs/hard.mdx").read_text(encoding="utf-8")
        write("docs/hard.mdx", f"# Hard\n\n{block}\nEnd.\n")
        run(["gcode-playground embed --check docs/hard.mdx"], folder, path)
    else:
        kind = "markdown" if recipe == "mdbook" else "html"
        # The faults in it do not matter here.
        run([f"gcode-playground embed hard.nc --format {kind} -o hard.{kind} || test $? = 1"], folder, path)
        block = (folder / f"hard.{kind}").read_text(encoding="utf-8")
        if recipe == "html":
            write("hard.html", f"<!doctype html>\n<p>Before</p>\n{block}<p>After</p>\n")
        else:
            write("src/turning.md", f"# Hard\n\n1. Before\n\n   {block.rstrip().replace(chr(10), chr(10) + '   ')}\n\n*After*\n")
            run(["mdbook build"], folder, path)


def warns(folder: Path, path: str) -> None:
    """Checks that Sphinx ends with an error where the recipe announces a warning."""
    page = folder / "index.rst"
    text = page.read_text(encoding="utf-8")
    for old, new, said in [
        ("   :view: picture\n", "   :veiw: picture\n", "veiw"),
        ("   :view: picture\n", "   :view: pictur\n", "view=pictur"),
        ("X32\n", "XO\n", "has errors"),
    ]:
        page.write_text(text.replace(old, new, 1), encoding="utf-8")
        fails(folder, path, "sphinx-build -q -W -E . _warned", said, "index.rst")
    page.write_text(text.replace("XO\n", "X32\n").replace("   :view: picture\n", "   :view: picture\n   :no-check:\n", 1).replace("X32\n", "XO\n", 1), encoding="utf-8")
    run(["sphinx-build -q -W -E . _warned"], folder, path)
    page.write_text(text, encoding="utf-8")
    fails(folder, path, "sphinx-build -q -W -E -D gcode_playground_element=embed/0.0.0/element.js . _warned", "no `embed/0.0.0/element.js`", "")
    fails(folder, path, "sphinx-build -q -W -E -D gcode_playground_command=no-such-command . _warned", "no command `no-such-command`", "")
    # A book cannot contain elements, and malformed markup ends its build.
    run(["sphinx-build -q -W -b epub -d _trees -D copyright=us -D version=1 . _epub"], folder, path)
    for chapter in (folder / "_epub").glob("*.xhtml"):
        xml.etree.ElementTree.parse(chapter)
        assert "<gcode-playground" not in chapter.read_text(encoding="utf-8"), chapter


def fails(folder: Path, path: str, command: str, said: str, where: str) -> None:
    print(f"$ {command}   # has to fail", flush=True)
    done = subprocess.run(command, shell=True, cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True)
    assert done.returncode != 0 and said in done.stderr and where in done.stderr, f"{command}: {done.stdout}{done.stderr}"


def holds(page: Path, program: str) -> "Elements":
    """Checks that the page has one element with this program."""
    elements = Elements()
    elements.feed(page.read_text(encoding="utf-8"))
    found = [without_blank_ends(text) for text in elements.programs]
    assert found == [without_blank_ends(program)], f"{page}: {elements.programs}"
    return elements


def sections() -> dict[str, list[tuple[str, str]]]:
    """The blocks of each section, each with the line before it."""
    found: dict[str, list[tuple[str, str]]] = {}
    title, before, block = "", "", []

    def end() -> None:
        nonlocal block
        if block:
            found.setdefault(title, []).append((before, "\n".join(block).rstrip("\n") + "\n"))
        block = []

    for line in DOCUMENT.read_text(encoding="utf-8").split("\n"):
        if line.startswith("    ") and (block or after_blank):
            block.append(line[4:])
        elif line == "":
            if block:
                block.append("")
        else:
            end()
            if line.startswith("## "):
                title = line[3:]
            before = line
        after_blank = line == ""
    end()
    return found


class Elements(html.parser.HTMLParser):
    """The programs of a page, and whether each has a picture."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.programs: list[str] = []
        self.pictures = 0
        self.scripts: list[dict[str, str | None]] = []
        self._in_element = self._in_pre = False
        self._depth = 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        own = dict(attributes)
        if tag == "script":
            self.scripts.append(own)
        elif tag == "gcode-playground":
            self._in_element = True
        elif tag == "pre" and (self._in_element or "data-gcode-playground" in own):
            self._in_pre = True
            self.programs.append("")
        elif tag == "svg" and self._depth > 0:
            self._depth += 1
        elif tag == "svg" and own.get("slot") == "fallback":
            self._depth = 1
            self.pictures += 1

    def handle_startendtag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        """Self-closing tags are empty."""

    def handle_endtag(self, tag: str) -> None:
        if tag == "svg":
            self._depth = max(self._depth - 1, 0)
        elif tag == "gcode-playground":
            self._in_element = False
        elif tag == "pre":
            self._in_pre = False

    def handle_data(self, data: str) -> None:
        if self._in_pre and self._depth == 0:
            self.programs[-1] += data


def without_blank_ends(text: str) -> str:
    """The program as the element reads it: without surrounding blank lines and common indentation."""
    lines = textwrap.dedent(text.replace("\r\n", "\n")).split("\n")
    while lines and not lines[0].strip():
        lines.pop(0)
    while lines and not lines[-1].strip():
        lines.pop()
    return "\n".join(lines)


def follow(blocks: list[tuple[str, str]], folder: Path, program: str, path: str) -> None:
    (folder / "shoulder.nc").write_text(program, encoding="utf-8")
    commands: list[str] = []
    for before, block in blocks:
        named = re.search(r"`([^`]+)`:$", before)
        if named is None:
            commands += [line for line in block.splitlines() if line and not line.startswith(INSTALLS)]
            continue
        # Commands run in the order of the document; files are written before the next command.
        run(commands, folder, path)
        commands = []
        file = folder / named[1]
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(block, encoding="utf-8")
    run(commands, folder, path)


def run(commands: list[str], folder: Path, path: str) -> None:
    for command in commands:
        print(f"$ {command}", flush=True)
        subprocess.run(command, shell=True, check=True, cwd=folder, env={**os.environ, "PATH": path})


def main() -> None:
    command_line, element, folder, *recipes = sys.argv[1:]
    all_sections = sections()
    assert set(RECIPES) >= set(recipes), recipes
    program = all_sections["Live examples in a manual"] if "Live examples in a manual" in all_sections else all_sections[""]
    program = program[0][1]
    version = re.search(r'^version = "(.+)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]
    document = DOCUMENT.read_text(encoding="utf-8")
    assert set(re.findall(r"embed/(\d[\w.]*)", document)) == {version}, f"the version is {version}"
    path = os.pathsep.join([str(Path(command_line).resolve().parent), os.environ["PATH"]])
    for recipe in recipes:
        title, result, more, hard = RECIPES[recipe]
        own = Path(folder).resolve() / ("site" if recipe == "docusaurus" else recipe)
        if recipe != "docusaurus":
            shutil.rmtree(own, ignore_errors=True)
        own.mkdir(parents=True, exist_ok=True)
        for old in ("package", "static/embed"):
            shutil.rmtree(own / old, ignore_errors=True)
        package = own / "package"
        if Path(element).is_dir():
            shutil.copytree(element, package)
        else:
            package.mkdir()
            (package / "element.js").write_text("export {};\n", encoding="utf-8")
        (package / "sphinx").mkdir(exist_ok=True)
        shutil.copy(ROOT / "www/manuals/gcode_playground_sphinx.py", package / "sphinx")
        comes_after = recipe in ("html", "mdbook")
        if not comes_after:
            hard_page(recipe, own, path)
        follow(all_sections[title], own, program, path)
        for name in [result, *more]:
            page = holds(own / name, program)
            if name.endswith("shoulder.html") or recipe == "sphinx":
                assert page.pictures == 1, f"{recipe}: no picture in {name}"
            if name == result:
                scripts = [script for script in page.scripts if "element.js" in (script.get("src") or "")]
                assert scripts and all(script.get("type") == "module" for script in scripts), f"{recipe}: {page.scripts}"
                place = (own / name).parent / scripts[0]["src"].split("?")[0].lstrip("/")
                assert place.is_file(), f"{recipe}: no {place}"
        if comes_after:
            hard_page(recipe, own, path)
        page = holds(own / hard, HARD)
        assert page.pictures == 1, f"{recipe}: no picture"
        if recipe == "sphinx":
            warns(own, path)
        print(f"{recipe}: the program of the page is the program that was written", flush=True)


if __name__ == "__main__":
    main()
