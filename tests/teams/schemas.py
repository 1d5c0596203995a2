"""Checks the schemas of `gcode-playground schema` with a complete validator.

In: the command line. Out: whether both are valid schemas (draft 2020-12) that accept the setups of the test programs, the files of
the example repository, and refuse files with a fault.
"""

import json
import tomllib
from pathlib import Path

from jsonschema import Draft202012Validator

from shared import EXAMPLE, ROOT, Tools, run, say

WRONG_SETUPS = [
    {"stok": {}},
    {"dialect": {"feedMode": "G97"}},
    {"tools": {"0101": {}}},
    {"tools": {"T0101": {"tip": 256}}},
    {"stock": {"diameter": 1}},
    {"stock": {"outline": [[36, 2], [56, -80]], "length": 80}},
    {"rules": {"no-program-ends": "off"}},
    {"limits": {"motions": 20_000_001}},
]

WRONG_CONFIGURATIONS = [
    {"controls": "gsk"},
    {"language": "de"},
    {"select": ["nothing-such"]},
    {"max-warnings": -1},
    {"rules-url": "rules"},
    {"override": [{"control": "gsk"}]},
]


def validator(tools: Tools, of: str) -> Draft202012Validator:
    schema = json.loads(run([tools.command, "schema", of], ROOT).stdout)
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


def accepts(schema: Draft202012Validator, name: Path | str, value: object) -> None:
    faults = [f"{'/'.join(map(str, fault.absolute_path))}: {fault.message}" for fault in schema.iter_errors(value)]
    assert not faults, f"{name}: {faults[:5]}"


def main(tools: Tools) -> None:
    setup, configuration = validator(tools, "setup"), validator(tools, "config")
    files = [*sorted((ROOT / "tests/programs").glob("*/setup.json")), EXAMPLE / "setup.json"]
    assert len(files) > 50, len(files)
    for file in files:
        accepts(setup, file, json.loads(file.read_text(encoding="utf-8")))
    file = EXAMPLE / "gcode-playground.toml"
    accepts(configuration, file, tomllib.loads(file.read_text(encoding="utf-8")))
    for schema, values in [(setup, WRONG_SETUPS), (configuration, WRONG_CONFIGURATIONS)]:
        for value in values:
            assert not schema.is_valid(value), f"accepted: {value}"
    say(f"schemas: {len(files)} setups and a configuration are valid")
