# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Builds wheels for pip by CMake, with nothing but Python's own modules (PEP 517).

Of `pip install -C`, "cmake" has arguments for CMake, and "build" a directory to build in, which is
kept: build/wheel by default.
"""

import base64
import hashlib
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# Parts that the package does not need. Without a network, it has no three.js for its pages.
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", "-DWITH_Python=ON",
           *(f"-DWITH_{name}=OFF" for name in ("Cairo", "Ceres", "TBB", "compiled_library"))]


def _project():
    with open(ROOT / "pyproject.toml", "rb") as file:
        return tomllib.load(file)["project"]


def _name(project):
    return f"{project['name'].replace('-', '_')}-{project['version']}"


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _metadata(project):
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}",
             *(f"Requires-Dist: {name}" for name in project["dependencies"])]
    for extra, names in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}",
                  *(f'Requires-Dist: {name}; extra == "{extra}"' for name in names)]
    readme = (ROOT / project["readme"]).read_text(encoding="utf-8")
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", readme])


def _write_metadata(folder, project):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "METADATA").write_text(_metadata(project), encoding="utf-8")
    (folder / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: build_backend\n"
                                  f"Root-Is-Purelib: false\nTag: {_tag()}\n")
    shutil.copy(ROOT / "LICENSE", folder / "LICENSE")


def _run(*command):
    subprocess.run([str(c) for c in command], check=True)


def _install(prefix, settings):
    """Builds the package and installs it into the directory `prefix`."""
    build = Path(settings.get("build", ROOT / "build" / "wheel"))
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    _run("cmake", "-S", ROOT, "-B", build, *generator, *OPTIONS,
         f"-DPython3_EXECUTABLE={sys.executable}", *shlex.split(settings.get("cmake", "")))
    _run("cmake", "--build", build, "--target", "intrinsic_python", "--parallel",
         os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", os.cpu_count() or 1))
    _run("cmake", "--install", build, "--component", "python", "--prefix", prefix, "--strip")
    if not list(Path(prefix, "intrinsic").glob("_core*")):
        raise RuntimeError("CMake has not built the package: pybind11, CGAL or Eigen is missing")


def _record(folder, files, metadata):
    lines = []
    for file in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=")
        lines.append(f"{file.relative_to(folder).as_posix()},sha256={digest.decode()},"
                     f"{file.stat().st_size}")
    return "\n".join([*lines, f"{metadata}/RECORD,,", ""])


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = _project()
    name = f"{_name(project)}-{_tag()}.whl"
    metadata = f"{_name(project)}.dist-info"
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        _install(folder, config_settings or {})
        _write_metadata(folder / metadata, project)
        files = sorted(f for f in folder.rglob("*") if f.is_file())
        with zipfile.ZipFile(Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
            for file in files:
                wheel.write(file, file.relative_to(folder))
            wheel.writestr(f"{metadata}/RECORD", _record(folder, files, metadata))
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    project = _project()
    name = f"{_name(project)}.dist-info"
    _write_metadata(Path(metadata_directory, name), project)
    return name


def build_sdist(sdist_directory, config_settings=None):
    project = _project()
    name = f"{_name(project)}.tar.gz"
    with tarfile.open(Path(sdist_directory, name), "w:gz") as archive:
        for path in sorted(ROOT.iterdir()):
            if path.name not in ("build", "results", ".git"):
                archive.add(path, Path(_name(project), path.name),
                            filter=lambda info: None if "__pycache__" in info.name else info)
        with tempfile.NamedTemporaryFile("w", encoding="utf-8") as information:
            information.write(_metadata(project))
            information.flush()
            archive.add(information.name, Path(_name(project), "PKG-INFO"))
    return name
