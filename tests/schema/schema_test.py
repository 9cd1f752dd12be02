#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""schema_test.py TANDEM FOLDER: the schema of scenarios lets every scenario of the folder pass, and no file with an
unknown key, a wrong type, a word that is not allowed or a required key that is missing. The same files are read, or
refused, by tandem itself."""
import copy
import json
import pathlib
import subprocess
import sys
import tomllib

import jsonschema

tandem, folder = sys.argv[1], pathlib.Path(sys.argv[2])
schema = json.loads(subprocess.run([tandem, "schema", "scenario"], check=True, capture_output=True).stdout)
assert schema == json.loads((folder / "scenarios/scenario.schema.json").read_text()), "the file in scenarios is stale"
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

files = {f: tomllib.loads(f.read_text()) for f in sorted(folder.glob("scenarios/**/*.toml"))}
scenarios = {f: d for f, d in files.items() if "subsystems" in d}
assert len(scenarios) > 20
for file, document in scenarios.items():
    error = next(validator.iter_errors(document), None)
    assert error is None, f"{file}: {error.message}"
    up = "../" * (len(file.relative_to(folder / "scenarios").parts) - 1)
    assert file.read_text().startswith(f"#:schema {up}scenario.schema.json\n"), f"{file} does not name the schema"

good = scenarios[folder / "scenarios/two_mass/two_mass.toml"]


def with_(*path_and_value):
    *path, last, value = path_and_value
    changed = copy.deepcopy(good)
    inner = changed
    for key in path:
        inner = inner[key]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return changed


bad = [
    with_("colour", "red"),
    with_("span", "colour", 1),
    with_("subsystems", "fast", "colour", 1),
    with_("connections", 0, "colour", 1),
    with_("span", "stop", "late"),
    with_("span", "stop", None),
    with_("span", None),
    with_("connections", 0, "from", None),
    with_("connections", 0, "gain", "two"),
    with_("connections", 0, "add", 1),
    with_("connections", 0, "reconstruction", "lagrange5"),
    with_("connections", 0, "reconstruction", "least_squares2_17"),
    with_("connections", {"from": "a.b"}),
    with_("coordination", "schedule", "fast"),
    with_("coordination", "order", "fast"),
    with_("coordination", "communication_step", -1.0),
    with_("record", {"animate": "yes"}),
    with_("judge", {"quantity": "slow.x2", "tolerance": 0}),
    with_("subsystems", "fast", "inputs", {"x2": "1"}),
    with_("subsystems", "fast", "land", "sometimes"),
    with_("parameters", "frequency_ratio", [1.0]),
]
for document in bad:
    assert next(validator.iter_errors(document), None), f"passes: {document}"
assert not next(validator.iter_errors(with_("connections", 0, "reconstruction", "least_squares2_16")), None)
print(f"{len(scenarios)} scenarios pass, {len(bad)} bad ones do not")
