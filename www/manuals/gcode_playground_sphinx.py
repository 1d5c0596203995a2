"""The directive ``gcode-playground`` for Sphinx: a turning program as a live example.

In: the program, and the attributes of the element ``<gcode-playground>`` as options. Out: in HTML the element, with
its picture where the command line ``gcode-playground`` is there; in other formats a block of code.
Must not know: what a program says.

Settings in ``conf.py``:
    gcode_playground_element  where ``element.js`` is: a path in ``html_static_path``, or an address
    gcode_playground_command  the command line, or ``None`` to do without pictures
"""

from __future__ import annotations

import html
import posixpath
import shutil
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

logger = logging.getLogger(__name__)


class Example(nodes.General, nodes.Element):
    """A program; its child is what other formats than HTML show."""


class AnyAttribute(dict):
    """Every attribute is an option; one without a value is there or not. The command line knows which there are."""

    def __contains__(self, name: object) -> bool:
        return True

    def __getitem__(self, name: str):
        return lambda value: (value or "").strip()

    def __bool__(self) -> bool:
        return True


class Directive(SphinxDirective):
    has_content = True
    option_spec = AnyAttribute()

    def run(self) -> list[nodes.Node]:
        self.assert_has_content()
        program = "\n".join(self.content) + "\n"
        example = Example("", program=program, attributes=dict(self.options))
        self.set_source_info(example)
        block = nodes.literal_block(program, program, language="text")
        self.set_source_info(block)
        example += block
        return [example]


def element(app, example: Example) -> str:
    """The element with its picture; without one where there is no command line."""
    command = app.config.gcode_playground_command
    own = {name: value for name, value in example["attributes"].items() if name != "no-check"}
    if command is not None:
        call = [command, "embed", "-"]
        for name, value in own.items():
            call.append(f"--attribute={name}={value}" if value else f"--attribute={name}")
        done = subprocess.run(call, input=example["program"].encode(), capture_output=True, check=False)
        if done.returncode == 1 and "no-check" not in example["attributes"]:
            logger.warning("the program has errors, which `%s check --markdown` names", command, location=example, type="gcode-playground")
        if done.returncode in (0, 1):
            return done.stdout.decode()
        logger.warning(done.stderr.decode().strip(), location=example, type="gcode-playground")
    attributes = "".join(f' {name}="{html.escape(value)}"' for name, value in own.items())
    program = html.escape(example["program"], quote=False)
    return f"<gcode-playground{attributes}>\n<pre>\n{program}</pre>\n</gcode-playground>\n"


def visit_html(translator, example: Example) -> None:
    if translator.builder.name == "epub":
        # No script runs in a book.
        return
    translator.body.append(element(translator.builder.app, example))
    raise nodes.SkipNode


def visit_other(translator, example: Example) -> None:
    pass


def depart(translator, example: Example) -> None:
    pass


def begin(app) -> None:
    """Names the script, and says once what is missing."""
    command = app.config.gcode_playground_command
    if command is not None and shutil.which(command) is None:
        logger.warning("no pictures of programs: there is no command `%s` (gcode_playground_command)", command, type="gcode-playground")
        app.config.gcode_playground_command = None
    script = app.config.gcode_playground_element
    if not script:
        return
    if app.builder.name == "epub":
        app.config.exclude_patterns.append(posixpath.dirname(script))
        return
    folders = [Path(app.confdir, folder) for folder in app.config.html_static_path]
    if "://" not in script and not any((folder / script).is_file() for folder in folders):
        logger.warning("no `%s` in html_static_path (gcode_playground_element)", script, type="gcode-playground")
    app.add_js_file(script, type="module")


def setup(app) -> dict:
    app.add_config_value("gcode_playground_element", "embed/element.js", "html", str)
    app.add_config_value("gcode_playground_command", "gcode-playground", "html", (str, type(None)))
    app.add_node(
        Example,
        html=(visit_html, depart),
        **{name: (visit_other, depart) for name in ("latex", "text", "man", "texinfo")},
    )
    app.add_directive("gcode-playground", Directive)
    app.connect("builder-inited", begin)
    return {"version": "0.1.0", "parallel_read_safe": True, "parallel_write_safe": True}
