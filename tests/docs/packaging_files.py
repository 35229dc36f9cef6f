# SPDX-License-Identifier: BSD-3-Clause
"""Files that others' programs read: CITATION.cff, GitHub's templates and workflow, the container's recipe and Spack's.
Usage: packaging_files.py ENVIRONMENT SPHK WORK"""

import ast
import re
import subprocess
import sys
from pathlib import Path

import docs_environment

docs_environment.enter(sys.argv[1])

import yaml  # noqa: E402
from dockerfile_parse import DockerfileParser  # noqa: E402

ROOT = docs_environment.ROOT
VERSION = re.search(r"project\(sphk VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def check_citation():
    checker = Path(sys.executable).parent / "cffconvert"
    subprocess.run([checker, "--validate", "-i", ROOT / "CITATION.cff"], check=True)
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert str(citation["version"]) == VERSION, f"it is of version {citation['version']}, the project is {VERSION}"
    assert f"## {VERSION}" in (ROOT / "CHANGELOG.md").read_text(), f"CHANGELOG.md says nothing of {VERSION}"


def check_github():
    """Forms have what GitHub asks of them; the workflow calls what every change has to pass."""
    for path in (ROOT / ".github" / "ISSUE_TEMPLATE").glob("*.yml"):
        form = yaml.safe_load(path.read_text())
        if path.name != "config.yml":
            assert form["name"] and form["description"], path
            assert all(part["attributes"]["label"] for part in form["body"]), path
            assert len({part["id"] for part in form["body"]}) == len(form["body"]), path
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / "ci.yml").read_text())
    steps = [step for job in workflow["jobs"].values() for step in job["steps"]]
    assert any(".ci/run" in step.get("run", "") for step in steps), "the workflow does not call .ci/run"


def check_container():
    """Two stages; the packages of the first are among those of the set-up script, and what is copied exists."""
    recipe = DockerfileParser(path=str(ROOT / "cmake" / "packaging" / "Dockerfile"), cache_content=True)
    # The script's package list, as the shell has it.
    script = (ROOT / "cmake" / "sphk.sh").read_text()
    needed = set(re.search(r"packages=\((.*?)\)", script, re.DOTALL)[1].split())
    runs = [step["value"] for step in recipe.structure if step["instruction"] == "RUN"]
    installed = set(re.search(r"--no-install-recommends(.*?)&&", runs[0].replace("\\", ""), re.DOTALL)[1].split())
    tests_alone = {"libgtest-dev", "libbenchmark-dev", "python3-matplotlib", "python3-jinja2", "python3-h5py"}
    assert needed - tests_alone <= installed, f"it lacks {sorted(needed - tests_alone - installed)}"
    assert recipe.parent_images == ["debian:12", "debian:12"], recipe.parent_images
    preset = re.search(r"-C /source/(\S+)", " ".join(runs))[1]
    assert (ROOT / preset).exists(), f"there is no {preset}"


def check_spack():
    """It is Python, and gives CMake what the project's own files know."""
    tree = ast.parse((ROOT / "cmake" / "packaging" / "spack" / "package.py").read_text())
    package = next(node for node in tree.body if isinstance(node, ast.ClassDef))
    assert package.name == "Sphk"
    known = "".join(path.read_text() for path in [ROOT / "CMakeLists.txt", *ROOT.glob("cmake/*.cmake")])
    given = [call.args[0].value for call in ast.walk(package)
             if isinstance(call, ast.Call) and getattr(call.func, "attr", "").startswith("define")]
    assert given, "it gives CMake nothing"
    for name in given:
        assert name in known or name.replace("CUDA", "${backend}") in known, f"CMake knows no {name}"
    kokkos = re.search(r"find_package\(Kokkos ([\d.]+)", known)[1]
    calls = [ast.unparse(node) for node in ast.walk(package) if isinstance(node, ast.Call)]
    assert any(f"kokkos@{kokkos}" in call for call in calls), f"it does not ask for Kokkos {kokkos}"


def main():
    failed = []
    for check in (check_citation, check_github, check_container, check_spack):
        try:
            check()
            print(f"{check.__name__} passed", flush=True)
        except Exception as error:  # of the libraries, too: tell all of them
            failed.append(f"{check.__name__}: {type(error).__name__}: {error}")
            print(failed[-1], flush=True)
    sys.exit(len(failed) > 0)


main()
