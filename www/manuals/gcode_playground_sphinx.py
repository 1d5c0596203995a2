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
import subprocess

from docutils import nodes
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

logger = logging.getLogger(__name__)


class Example(nodes.General, nodes.Element):
    """A program; its child is what other formats than HTML show."""


class AnyAttribute(dict):
    """Every attribute is an option; one without a value is there or not."""

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
    if command is not None:
        call = [command, "embed", "-"]
        for name, value in example["attributes"].items():
            call.append(f"--attribute={name}={value}" if value else f"--attribute={name}")
        try:
            done = subprocess.run(call, input=example["program"].encode(), capture_output=True, check=False)
        except OSError as error:
            logger.warning("no pictures of programs: %s", error, once=True, type="gcode-playground")
        else:
            # 1: the program has errors, which are a matter of `check --markdown`.
            if done.returncode in (0, 1):
                return done.stdout.decode()
            logger.warning(done.stderr.decode().strip(), location=example, type="gcode-playground")
    attributes = "".join(
        f' {name}="{html.escape(value)}"' if value else f" {name}" for name, value in example["attributes"].items()
    )
    program = html.escape(example["program"], quote=False)
    return f"<gcode-playground{attributes}>\n<pre>\n{program}</pre>\n</gcode-playground>\n"


def visit_html(translator, example: Example) -> None:
    translator.body.append(element(translator.builder.app, example))
    raise nodes.SkipNode


def visit_other(translator, example: Example) -> None:
    pass


def depart(translator, example: Example) -> None:
    pass


def add_script(app) -> None:
    if app.config.gcode_playground_element:
        app.add_js_file(app.config.gcode_playground_element, type="module")


def setup(app) -> dict:
    app.add_config_value("gcode_playground_element", "embed/element.js", "html", str)
    app.add_config_value("gcode_playground_command", "gcode-playground", "html", (str, type(None)))
    app.add_node(
        Example,
        html=(visit_html, depart),
        **{name: (visit_other, depart) for name in ("latex", "text", "man", "texinfo")},
    )
    app.add_directive("gcode-playground", Directive)
    app.connect("builder-inited", add_script)
    return {"version": "0.1.0", "parallel_read_safe": True, "parallel_write_safe": True}
