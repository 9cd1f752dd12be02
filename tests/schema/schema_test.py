#!/usr/bin/env python3
# Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
"""schema_test.py TANDEM FOLDER: the schemas let every scenario, study, mechanism and diagram of the folder pass, and no file
with an unknown key, a wrong type, a word that is not allowed or a required key that is missing. What they refuse of
mechanisms and diagrams tandem itself refuses too."""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

tandem, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def schema_of(language):
    schema = json.loads(subprocess.run([tandem, "schema", language], check=True, capture_output=True).stdout)
    there = json.loads((folder / f"scenarios/{language}.schema.json").read_text())
    assert schema == there, f"the file of {language} in scenarios is stale"
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def language_of(document):
    kinds = {"subsystems": "scenario", "tables": "study", "search": "study", "blocks": "diagram"}
    return next((kind for key, kind in kinds.items() if key in document), "mechanism")


folders = ("scenarios", "tests/examples", "tests/consumer")
files = {f: tomllib.loads(f.read_text()) for name in folders for f in sorted((folder / name).glob("**/*.toml"))}
validators = {language: schema_of(language) for language in ("scenario", "study", "mechanism", "diagram")}
for file, document in files.items():
    language = language_of(document)
    error = next(validators[language].iter_errors(document), None)
    assert error is None, f"{file}: {error.message}"
    named = file.read_text().split("\n")[0].removeprefix("#:schema ")
    there = folder / f"scenarios/{language}.schema.json"
    assert (file.parent / named).resolve() == there.resolve(), f"{file} does not name the schema"
assert len(files) > 70


def refused(document):
    return next(validators[language_of(document)].iter_errors(document), None) is not None


def told(text):
    """What tandem says of a file with that text; nothing if it is well."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        done = subprocess.run([tandem, "info", file.name], capture_output=True, text=True)
    assert (done.returncode == 0) == (not done.stderr), done
    assert done.returncode in (0, 2), done
    return done.stderr


# A line in place of another one, or more lines.
mechanism = """
dimension = 2
gravity = [0, "$(-g)"]
[parameters]
g = { value = 9.81, unit = "m/s^2" }
[points]
O = { at = [0, 0], fixed = true }
P = { at = [1, 0] }
[rods.arm]
points = ["O", "P"]
mass = "$g"
[elements.air]
kind = "drag"
point = "P"
coefficient = 1.0
[outputs]
x = { position = "P.x" }
"""
diagram = """
[parameters]
k = { value = 2.0, unit = "1" }
how = { value = "hold", allowed = ["hold", "extend"] }
[inputs]
u = { unit = "m" }
[blocks]
twice = { kind = "gain", input = "u", gain = "$k" }
limit = { kind = "table", input = "twice", x = [0, 1], y = [0, "$k"], beyond = "$how" }
y = { kind = "integrator", input = "limit", initial = "$(1 + k)" }
[outputs]
y = { unit = "m s" }
"""
changes = [
    (mechanism, "dimension = 2", "dimension = 'two'"),
    (mechanism, "dimension = 2", "dimension = 2\ncolour = 1"),
    (mechanism, "mass = \"$g\"", ""),
    (mechanism, "mass = \"$g\"", "mass = -1"),
    (mechanism, "mass = \"$g\"", "mass = 'g'"),
    (mechanism, "mass = \"$g\"", "mass = 1\nlength = 2"),
    (mechanism, "fixed = true", "fixed = 1"),
    (mechanism, "at = [1, 0]", "at = 1"),
    (mechanism, "at = [1, 0]", "at = [1, 'a']"),
    (mechanism, "[\"O\", \"P\"]", "\"O\""),
    (mechanism, "\"drag\"", "\"drug\""),
    (mechanism, "coefficient = 1.0", ""),
    (mechanism, "coefficient = 1.0", "coefficient = 1.0\nspin = 'x'"),
    (mechanism, "value = 9.81, ", ""),
    (mechanism, "position =", "place ="),
    (mechanism, "[outputs]", "[initial]\npositions = 'P.x'\n[outputs]"),
    (mechanism, "[outputs]", "[relations.r]\nterms = ['P.x']\n[outputs]"),
    (mechanism, "[outputs]", "[initial.velocities]\n'P.x' = true\n[outputs]"),
    (diagram, "unit = \"m\" }", "units = \"m\" }"),
    (diagram, "\"gain\"", "\"gian\""),
    (diagram, "gain = \"$k\"", "gain = 'k'"),
    (diagram, "gain = \"$k\"", "again = 2"),
    (diagram, ", gain = \"$k\"", ""),
    (diagram, "x = [0, 1]", "x = true"),
    (diagram, "\"$how\"", "\"held\""),
    (diagram, "\"$how\"", "1"),
    (diagram, "initial = \"$(1 + k)\"", "initial = true"),
    (diagram, "[outputs]", "[loops]\nsolve = 1\n[outputs]"),
    (diagram, "[outputs]", "[loops]\ntolerance = 0\n[outputs]"),
    (diagram, "[outputs]", "[output]"),
]
for text in (mechanism, diagram):
    assert not refused(tomllib.loads(text)) and not told(text), told(text)
for text, old, new in changes:
    assert old in text, old
    changed = text.replace(old, new, 1)
    assert refused(tomllib.loads(changed)), f"passes: {changed}"
    assert told(changed), f"is read: {changed}"

good = files[folder / "scenarios/two_mass/two_mass.toml"]


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
    with_("parameters", "frequency_ratio", [[1.0]]),
    with_("subsystems", "fast", "parameters", {"set": []}),
]
for document in bad:
    assert refused(document), f"passes: {document}"
assert not refused(with_("connections", 0, "reconstruction", "least_squares2_16"))
assert not refused(with_("subsystems", "fast", "parameters", {"set": {"A": [1, 0.5], "k": 3}, "outputs": ["x"]}))
print(f"{len(files)} files pass, {len(bad) + len(changes)} bad ones do not")
