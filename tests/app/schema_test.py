"""The JSON schema of case files, held against the files and the reader, by the validator of
python3-jsonschema: every shipped case is valid; what is wrong is neither valid nor read. Skipped
(77) without the validator. Usage: schema_test.py PROGRAM SOURCE_DIRECTORY"""

import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not installed: skipped")
    sys.exit(77)

program, source = sys.argv[1], pathlib.Path(sys.argv[2])
small = source / "tests/app/cases/small-gas.toml"
pipe = source / "cases/catalog/pipe-gas-fig4.toml"
hopper = source / "cases/catalog/hopper-flow.toml"

# A text of a case, and what makes it wrong.
wrong = {
    "an unknown key": (small, "gravity = 0.0", "gravity = 0.0\nviscosity = 1.0"),
    "an unknown key of the file": (small, 'source = "test"', 'source = "test"\nauthor = "me"'),
    "a wrong type": (small, "time_limit = 60.0", 'time_limit = "60"'),
    "a number out of range": (small, "gravity = 0.0", "gravity = -1.0"),
    "a number at an open end": (small, "restitution = 0.8", "restitution = 0.0"),
    "a wrong word": (small, '"verlet-half-step"', '"verlet"'),
    "a wrong word in a list": (small, 'suites = ["quick"]', 'suites = ["fast"]'),
    "a missing key": (small, 'title = "Gas of 16 discs"\n', ""),
    "a missing key of a scene": (small, 'spins = "off"\n', ""),
    "a missing key of a check": (small, 'reason = "round-off"\n', ""),
    "none of two keys": (small, "dt = 1e-3\n", ""),
    "both of two keys": (small, "dt = 1e-3", "dt = 1e-3\nsteps_per_contact_time = 100"),
    "a key of another kind": (small, "count = 16,", "count = 16, columns = 4,"),
    "a missing key of a kind": (small, ", velocity_spread = 3.0", ""),
    "an unknown model": (small, 'source = "test"', 'source = "test"\nmodel = "foam"'),
    "an unknown observable": (small, 'name = "momentum"', 'name = "momenta"'),
    "an unknown option": (small, 'name = "momentum"', 'name = "momentum"\nskip = 1.0'),
    "an option of an observable out of range": (
        small, 'name = "momentum"', 'name = "flow-depth"\nshare = 1.0'),
    "several numbers for an option that is one": (
        small, 'name = "momentum"', 'name = "flow-depth"\nshare = [0.1, 0.2]'),
    "a text for an option that is a number": (
        small, 'name = "momentum"', 'name = "flow-depth"\nskip = "long"'),
    "a part of a whole number": (
        small, 'name = "momentum"', 'name = "energy-balance"\nsamples_per_frame = 1.5'),
    "a wrong word of an option": (
        small, 'name = "momentum"',
        'name = "displacement-spectrum"\nspacing = 3.0\ncrossing = "up"'),
    "a missing option": (small, 'name = "momentum"', 'name = "displacement-spectrum"'),
    "an unknown code": (small, 'suites = ["quick"]', 'suites = ["quick"]\nreplicas = { foo = 2 }'),
    "an empty list": (small, "dt = 1e-3", "dt = []"),
    "a whole number that is none": (small, "count = 16", "count = 16.5"),
    "a sweep over an unknown key": (
        small, "[scene.contact]", "[sweep]\nfoo = [1]\n[scene.contact]"),
    "a sweep over a wrong value": (
        small, "[scene.contact]", '[sweep]\n"contact.restitution" = [2.0]\n[scene.contact]'),
    "a key of another model": (pipe, "[scene]", "[scene]\ngamma = 1.0"),
    "a suite within a suite": (hopper, "[quick.scene]", "[quick.quick.scene]"),
    "a wrong word in a layer": (hopper, "[quick.scene]", '[quick.scene]\nengine = "slow"'),
}
accepted = {
    "a sweep over a key behind a dot": (
        small, "[scene.contact]", '[sweep]\n"contact.restitution" = [0.5, 0.8]\n[scene.contact]'),
    "a sweep over all words": (
        small, "[scene.contact]", '[sweep]\nprecision = ["*"]\n[scene.contact]'),
    "a scene that its variants complete": (
        small, 'spins = "off"\n', '[[variant]]\nname = "v"\nscene.contact.spins = "off"\n'),
    "options of an observable in their ranges": (
        small, 'name = "momentum"',
        'name = "displacement-spectrum"\nspacing = 3\ncrossing = "either"\nk_min = 2.0'),
    "one of several ways to say when": (
        small, "every_contact_times = 0.1", "first_and_last = true"),
}


def reader_accepts(text, directory):
    """Whether the reader has no complaint, each of which names the file."""
    file = pathlib.Path(directory, "case.toml")
    file.write_text(text)
    answer = subprocess.run(
        [program, "--results", directory, "write", file, "--code", "native-dem", "--out",
         pathlib.Path(directory, "out")], capture_output=True, text=True, check=False)
    return "case.toml" not in answer.stderr, answer.stderr


def check(name, given, expected, validator, directory):
    file, old, new = given
    text = file.read_text()
    assert old in text, f"{file} lacks {old}"
    text = text.replace(old, new, 1)
    problems = list(validator.iter_errors(tomllib.loads(text)))
    read, stderr = reader_accepts(text, directory)
    said = "; ".join(problem.message for problem in problems)
    if (not problems) == expected and read == expected:
        return 0
    print(f"{name}: the schema says: {said or 'valid'}; the reader: {stderr or 'valid'}")
    return 1


def main():
    schema = json.loads(subprocess.run([program, "schema"], capture_output=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    failures = 0
    cases = sorted((source / "cases/catalog").glob("*.toml"))
    assert len(cases) > 40, "the catalogue is missing"
    for case in cases:
        for problem in validator.iter_errors(tomllib.loads(case.read_text())):
            print(f"{case.name}: {problem.json_path}: {problem.message}")
            failures += 1
    with tempfile.TemporaryDirectory() as directory:
        for name, given in wrong.items():
            failures += check(name, given, False, validator, directory)
        for name, given in accepted.items():
            failures += check(name, given, True, validator, directory)
    print(f"{len(cases)} cases, {len(wrong)} wrong and {len(accepted)} more right ones, "
          f"{failures} failures")
    return 1 if failures else 0


sys.exit(main())
